/* A surface as the plane that covers it: feet of points, found and followed. */
#include "body/trace/chart.h"
#include "body/border.h"
#include "inspect/nearest/foot.h"
#include "numeric/vector.h"

#include <batten/nearest.h>
#include <float.h>
#include <string.h>

static const batten_direction FIXED[4] = {BATTEN_V, BATTEN_U, BATTEN_V, BATTEN_U};

/* ---- making ---- */

/* The length of the longest of a few lines along a direction, as chords. */
static batten_status extent(const bat_chart *chart, int along, double *length)
{
    enum { LINES = 3, STEPS = 16 };
    *length = 0;
    for (int i = 0; i < LINES; i++) {
        double before[3], point[3], sum = 0;
        for (int k = 0; k <= STEPS; k++) {
            double uv[2];
            const batten_interval a = chart->domain[along], b = chart->domain[1 - along];
            uv[along] = a.a + (a.b - a.a) * k / STEPS;
            uv[1 - along] = b.a + (b.b - b.a) * i / (LINES - 1);
            const batten_status status = bat_chart_evaluate(chart, uv, 0, point);
            if (status != BATTEN_OK)
                return status;
            if (k)
                sum += bat_distance(3, before, point);
            memcpy(before, point, sizeof before);
        }
        *length = bat_max(*length, sum);
    }
    return BATTEN_OK;
}

static batten_status find_pole(bat_chart *chart, int k)
{
    batten_curve *side = NULL;
    const batten_interval domain = chart->domain[FIXED[k]];
    const batten_status status = batten_surface_isocurve(
        chart->surface, FIXED[k], k == 1 || k == 2 ? domain.b : domain.a, &side);
    chart->pole[k] = status == BATTEN_OK && bat_border_is_point(side, chart->tolerance);
    if (chart->pole[k])
        memcpy(chart->pole_at[k], batten_curve_points(side), sizeof chart->pole_at[k]);
    batten_curve_unref(side);
    return status;
}

static batten_status find_poles(bat_chart *chart)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 4; k++)
        status = find_pole(chart, k);
    return status;
}

batten_status bat_chart_begin(const batten_surface *surface, double tolerance, bat_chart *chart)
{
    *chart = (bat_chart){.tolerance = tolerance};
    batten_status status = bat_border_surface(surface, tolerance, &chart->surface);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        chart->domain[k] = batten_surface_domain(chart->surface, k ? BATTEN_V : BATTEN_U);
        chart->period[k] = chart->domain[k].b - chart->domain[k].a;
    }
    if (status == BATTEN_OK)
        status = find_poles(chart);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        double length = 0;
        /* Poles that fall together are no seam. */
        chart->closed[k] =
            !chart->pole[k ? 0 : 3] && !chart->pole[k ? 2 : 1] &&
            batten_surface_is_closed(chart->surface, k ? BATTEN_V : BATTEN_U, tolerance);
        status = extent(chart, k, &length);
        chart->near[k] =
            bat_min(1e-3, length > 0 ? tolerance / 2 / length : 1e-3) * chart->period[k];
        chart->size = bat_max(chart->size, length);
    }
    chart->complete = (chart->closed[0] || (chart->pole[3] && chart->pole[1])) &&
                      (chart->closed[1] || (chart->pole[0] && chart->pole[2]));
    return status;
}

void bat_chart_loosen(bat_chart *chart, double tolerance)
{
    for (int k = 0; k < 2; k++)
        chart->near[k] =
            bat_min(1e-3 * chart->period[k], chart->near[k] * (tolerance / chart->tolerance));
    chart->tolerance = tolerance;
}

void bat_chart_end(bat_chart *chart)
{
    batten_surface_unref(chart->surface);
    bat_release(chart->seed_at[0]);
    bat_release(chart->seed_at[1]);
    bat_release(chart->seeds);
}

/* ---- points ---- */

void bat_chart_wrap(const bat_chart *chart, const double uv[2], double in[2])
{
    for (int k = 0; k < 2; k++) {
        const batten_interval domain = chart->domain[k];
        in[k] = uv[k];
        if (chart->closed[k] && (in[k] < domain.a || in[k] > domain.b))
            in[k] -= chart->period[k] * floor((in[k] - domain.a) / chart->period[k]);
        in[k] = bat_min(domain.b, bat_max(domain.a, in[k]));
    }
}

batten_status bat_chart_evaluate(const bat_chart *chart, const double uv[2], int order,
                                 double *out)
{
    double in[2];
    bat_chart_wrap(chart, uv, in);
    return batten_surface_evaluate(chart->surface, in[0], in[1], order, out);
}

int bat_chart_pole(const bat_chart *chart, const double q[3])
{
    for (int k = 0; k < 4; k++)
        if (chart->pole[k] && bat_distance(3, chart->pole_at[k], q) <= chart->tolerance)
            return k;
    return -1;
}

/* ---- feet ---- */

/* The step of Gauss and Newton: the surface is asked for first derivatives only. */
static void step_to_foot(const bat_foot_place *here, const bool free[2], double step[2])
{
    bat_foot_step(here, free, 0, step);
}

void bat_chart_velocity(const double *derivatives, const double d[3], double uv[2])
{
    /* The foot of S + d, from S. */
    double to[3];
    bat_foot_place here;
    memcpy(to, d, sizeof to);
    bat_foot_slopes(3, derivatives, 1, to, &here);
    for (int k = 0; k < 2; k++)
        here.gradient[k] = -bat_dot(3, derivatives + 3 * (k + 1), d);
    step_to_foot(&here, (const bool[2]){true, true}, uv);
}

typedef struct {
    const bat_chart *chart;
    const double *q;
} chart_search;

static batten_status look_on_chart(const void *context, const double at[2], bat_foot_place *out)
{
    const chart_search *search = context;
    double s[9];
    const batten_status status = bat_chart_evaluate(search->chart, at, 1, s);
    if (status != BATTEN_OK)
        return status;
    bat_foot_slopes(3, s, 1, search->q, out);
    out->value = bat_distance(3, s, search->q);
    memcpy(out->at, at, sizeof out->at);
    return BATTEN_OK;
}

static batten_status descend(const bat_chart *chart, const double q[3], double uv[2],
                             double *distance)
{
    const chart_search search = {chart, q};
    bat_foot_descent descent = {.look = look_on_chart,
                                .step = step_to_foot,
                                .context = &search,
                                .steps = 40,
                                .halvings = 10};
    bat_foot_place foot = {.at = {uv[0], uv[1]}};
    for (int k = 0; k < 2; k++) {
        descent.low[k] = chart->closed[k] ? -HUGE_VAL : chart->domain[k].a;
        descent.high[k] = chart->closed[k] ? HUGE_VAL : chart->domain[k].b;
        /* Where a direction has hardly any extent, at a pole, steps would be wild. */
        descent.longest[k] = chart->period[k] / 8;
        /* A step far below what matters: the foot stands. */
        descent.least[k] = 1e-7 * chart->near[k];
    }
    const batten_status status = bat_foot_descend(&descent, &foot);
    if (status != BATTEN_OK)
        return status;
    memcpy(uv, foot.at, sizeof foot.at);
    *distance = foot.value;
    return BATTEN_OK;
}

/* Parameters a hair off an end of the domain, or of a period, are put on it. */
static void settle(const bat_chart *chart, double uv[2])
{
    for (int k = 0; k < 2; k++) {
        const double a = chart->domain[k].a, period = chart->period[k];
        const double turns = (uv[k] - a) / period, whole = nearbyint(turns);
        if (fabs(turns - whole) * period <= 1e-3 * chart->near[k])
            uv[k] = whole == 1 ? chart->domain[k].b : a + whole * period;
    }
}

batten_status bat_chart_foot(const bat_chart *chart, const double q[3], double uv[2],
                             double *distance)
{
    const batten_status status = descend(chart, q, uv, distance);
    if (status == BATTEN_OK)
        settle(chart, uv);
    return status;
}

/* ---- search ---- */

enum { MOST_SEEDS = 64 };

static batten_status make_seeds(bat_chart *chart)
{
    if (chart->seeds)
        return BATTEN_OK;
    for (int k = 0; k < 2; k++) {
        const batten_direction along = k ? BATTEN_V : BATTEN_U;
        const int spans = batten_surface_spans(chart->surface, along, NULL) - 1;
        const int n = 1 + bat_min_int(MOST_SEEDS, bat_max_int(8, 3 * spans));
        bat_release(chart->seed_at[k]);
        chart->seed_count[k] = n;
        chart->seed_at[k] = bat_array((size_t)n, sizeof(double));
        if (!chart->seed_at[k])
            return BATTEN_OUT_OF_MEMORY;
        for (int i = 0; i < n; i++)
            chart->seed_at[k][i] = i < n - 1
                                       ? chart->domain[k].a + chart->period[k] * i / (n - 1)
                                       : chart->domain[k].b;
    }
    const size_t nu = (size_t)chart->seed_count[0], nv = (size_t)chart->seed_count[1];
    double *points = bat_array3(nu, nv, 3 * sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_surface_evaluate_grid(
        chart->surface, (batten_uv_grid){nu, nv, chart->seed_at[0], chart->seed_at[1]}, 0, NULL,
        points);
    if (status == BATTEN_OK)
        chart->seeds = points;
    else
        bat_release(points);
    return status;
}

static void nearest_seed(const bat_chart *chart, const double q[3], double uv[2])
{
    const size_t nu = (size_t)chart->seed_count[0], nv = (size_t)chart->seed_count[1];
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < nu; i++)
        for (size_t j = 0; j < nv; j++) {
            const double away = bat_distance(3, chart->seeds + 3 * (i * nv + j), q);
            if (!(away < nearest))
                continue;
            nearest = away;
            uv[0] = chart->seed_at[0][i];
            uv[1] = chart->seed_at[1][j];
        }
}

static batten_status from_seeds(bat_chart *chart, const double q[3], double uv[2],
                                double *distance)
{
    const batten_status status = make_seeds(chart);
    if (status != BATTEN_OK)
        return status;
    nearest_seed(chart, q, uv);
    return bat_chart_foot(chart, q, uv, distance);
}

batten_status bat_chart_find(bat_chart *chart, const double q[3], const double *guess,
                             double uv[2], double *distance)
{
    *distance = HUGE_VAL;
    batten_status status = BATTEN_OK;
    if (guess) {
        memcpy(uv, guess, 2 * sizeof *uv);
        status = bat_chart_foot(chart, q, uv, distance);
    }
    if (status == BATTEN_OK && *distance > chart->tolerance)
        status = from_seeds(chart, q, uv, distance);
    if (status != BATTEN_OK || *distance <= chart->tolerance)
        return status;
    batten_deviation worst;
    status = batten_surface_project(chart->surface, (batten_points){3, 1, q}, NULL, NULL,
                                    (batten_feet){uv, NULL}, &worst);
    if (status == BATTEN_OK)
        status = bat_chart_foot(chart, q, uv, distance);
    return status;
}

batten_status bat_chart_miss(bat_chart *chart, const batten_curve *curve, int places,
                             double *miss)
{
    const batten_interval on = batten_curve_domain(curve);
    double uv[2] = {0, 0}, worst = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < places; i++) {
        const double share = (i + 0.5) / places, guess[2] = {uv[0], uv[1]};
        double point[3], distance = 0;
        status = batten_curve_evaluate(curve, on.a + share * (on.b - on.a), 0, point);
        if (status == BATTEN_OK)
            status = bat_chart_find(chart, point, i ? guess : NULL, uv, &distance);
        worst = bat_max(worst, distance);
    }
    if (status == BATTEN_OK)
        *miss = worst;
    return status;
}
