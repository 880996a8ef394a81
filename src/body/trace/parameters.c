/* Parameter curves of edges: how far they miss, and those in planes and straight ones. */
#include "body/trace/parameters.h"
#include "body/border.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <string.h>

/* ---- how good ---- */

/* The distinct knots of both curves in order, and three places between each two.
 * @return how many; `t` has room */
static int sample_places(const batten_curve *curve, const batten_curve *parameters,
                         double *breaks, double *t)
{
    enum { EACH = 4, LEAST = 16 };
    const int n = batten_curve_spans(curve, breaks);
    const int m = batten_curve_spans(parameters, breaks + n);
    const double *a = breaks, *b = breaks + n;
    const int each = bat_max_int(EACH, LEAST / bat_max_int(1, bat_max_int(n, m) - 1));
    int count = 0;
    double last = a[0];
    for (int i = 1, j = 1; i < n;) {
        double next = a[i];
        if (j < m && b[j] < next)
            next = b[j++];
        else
            i++;
        if (!(next > last))
            continue;
        for (int k = 0; k < each; k++)
            t[count++] = last + (next - last) * k / each;
        last = next;
    }
    t[count++] = a[n - 1];
    return count;
}

static batten_status distance_at(const bat_chart *chart, const batten_curve *curve,
                                 const batten_curve *parameters, double t, double *distance)
{
    double c[3], uv[2], s[3];
    batten_status status = batten_curve_evaluate(curve, t, 0, c);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(parameters, t, 0, uv);
    if (status == BATTEN_OK)
        status = bat_chart_evaluate(chart, uv, 0, s);
    if (status == BATTEN_OK)
        *distance = bat_distance(3, c, s);
    return status;
}

/* At many places at once; room [count][8]. */
static batten_status distances(const bat_chart *chart, const batten_curve *curve,
                               const batten_curve *parameters, int count, const double *t,
                               double *room, double *miss)
{
    const size_t n = (size_t)count;
    double *c = room, *s = room + 3 * n, *uv = room + 6 * n;
    batten_status status = batten_curve_evaluate_many(curve, n, t, 0, NULL, c);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_many(parameters, n, t, 0, NULL, uv);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++)
        bat_chart_wrap(chart, (const double[]){uv[2 * i], uv[2 * i + 1]}, uv + 2 * i);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_many(chart->surface, n, uv, 0, NULL, s);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++)
        *miss = bat_max(*miss, bat_distance(3, c + 3 * i, s + 3 * i));
    return status;
}

batten_status bat_parameters_miss(const bat_chart *chart, const batten_curve *curve,
                                  const batten_curve *parameters, double enough, double *miss)
{
    static const double first[] = {0, 1, 0.5, 0.28, 0.77};
    const batten_interval on = batten_curve_domain(curve);
    double largest = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < 5 && !(largest > enough); i++) {
        double here = 0;
        const double t = first[i] == 1 ? on.b : on.a + (on.b - on.a) * first[i];
        status = distance_at(chart, curve, parameters, t, &here);
        largest = bat_max(largest, here);
    }
    *miss = largest;
    if (status != BATTEN_OK || largest > enough)
        return status;
    const int spans =
        batten_curve_spans(curve, NULL) + batten_curve_spans(parameters, NULL) + 2;
    double *breaks = bat_array((size_t)spans, sizeof *breaks);
    double *t = bat_array3((size_t)spans, 16, sizeof *t);
    double *room = bat_array3((size_t)spans, 16 * 8, sizeof *room);
    if (!breaks || !t || !room)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = distances(chart, curve, parameters,
                           sample_places(curve, parameters, breaks, t), t, room, miss);
    bat_release(breaks);
    bat_release(t);
    bat_release(room);
    return status;
}

bool bat_parameters_inside(const bat_chart *chart, const batten_curve *parameters)
{
    const batten_box box = batten_curve_box(parameters);
    const double low[] = {box.low.x, box.low.y}, high[] = {box.high.x, box.high.y};
    for (int k = 0; k < 2; k++)
        if (!chart->closed[k] &&
            !(low[k] >= chart->domain[k].a && high[k] <= chart->domain[k].b))
            return false;
    return true;
}

batten_status bat_parameters_adjust(const batten_curve *parameters, const double low[2],
                                    const double high[2], const double *start,
                                    const double *end, batten_curve **out)
{
    batten_curve *made = NULL;
    batten_status status = bat_curve_copy(parameters, &made);
    if (status != BATTEN_OK)
        return status;
    const int last = made->count - 1;
    for (int i = 0; i <= last; i++)
        for (int k = 0; k < 2; k++)
            made->points[2 * i + k] =
                bat_min(high[k], bat_max(low[k], made->points[2 * i + k]));
    if (start)
        memcpy(made->points, start, 2 * sizeof *start);
    if (end)
        memcpy(made->points + 2 * last, end, 2 * sizeof *end);
    return bat_curve_finish(made, out);
}

/* ---- ways ---- */

/* Where the surface is P + u a + v b. */
static bool plane_of(const bat_chart *chart, double p[3], double a[3], double b[3])
{
    const batten_surface *s = chart->surface;
    const double *x = batten_surface_points(s), *w = batten_surface_weights(s);
    if (batten_surface_degree(s, BATTEN_U) != 1 || batten_surface_degree(s, BATTEN_V) != 1 ||
        batten_surface_point_count(s, BATTEN_U) != 2 ||
        batten_surface_point_count(s, BATTEN_V) != 2 ||
        (w && !(w[0] == w[1] && w[0] == w[2] && w[0] == w[3])))
        return false;
    for (int k = 0; k < 3; k++) {
        if (fabs(x[k] - x[3 + k] - x[6 + k] + x[9 + k]) > 1e-3 * chart->tolerance)
            return false;
        b[k] = (x[3 + k] - x[k]) / chart->period[1];
        a[k] = (x[6 + k] - x[k]) / chart->period[0];
        p[k] = x[k];
    }
    return true;
}

bool bat_parameters_plane(const bat_chart *chart)
{
    double p[3], a[3], b[3];
    return plane_of(chart, p, a, b);
}

/* With a clamped curve in a plane P + u a + v b. */
static batten_status put_in_plane(const bat_chart *chart, const batten_curve *curve,
                                  const double p[3], const double *derivatives,
                                  batten_curve **out, double *miss)
{
    const double *a = derivatives + 3, *b = derivatives + 6;
    batten_curve *made = NULL;
    const int n = batten_curve_point_count(curve);
    const double *points = batten_curve_points(curve);
    batten_status status = bat_curve_make(2, batten_curve_degree(curve), n,
                                          batten_curve_weights(curve) != NULL, &made);
    if (status != BATTEN_OK)
        return status;
    *miss = 0;
    for (int i = 0; i < n; i++) {
        double off[3], uv[2];
        for (int k = 0; k < 3; k++)
            off[k] = points[3 * i + k] - p[k];
        bat_chart_velocity(derivatives, off, uv);
        for (int k = 0; k < 3; k++)
            off[k] -= uv[0] * a[k] + uv[1] * b[k];
        *miss = bat_max(*miss, bat_norm(3, off));
        for (int k = 0; k < 2; k++)
            made->points[2 * i + k] = chart->domain[k].a + uv[k];
    }
    if (made->weights)
        memcpy(made->weights, batten_curve_weights(curve), (size_t)n * sizeof *made->weights);
    memcpy(made->knots, batten_curve_knots(curve),
           (size_t)batten_curve_knot_count(curve) * sizeof *made->knots);
    batten_curve *finished = NULL;
    status = bat_curve_finish(made, &finished);
    if (status == BATTEN_OK && *miss > chart->tolerance) {
        batten_curve_unref(finished);
        return BATTEN_NOT_FOUND;
    }
    if (status == BATTEN_OK)
        *out = finished;
    return status;
}

batten_status bat_parameters_in_plane(const bat_chart *chart, const batten_curve *curve,
                                      batten_curve **out, double *miss)
{
    double p[3], derivatives[9];
    batten_curve *clamped = NULL;
    if (!plane_of(chart, p, derivatives + 3, derivatives + 6))
        return BATTEN_NOT_FOUND;
    batten_status status = BATTEN_OK;
    if (batten_curve_is_clamped(curve))
        clamped = batten_curve_ref(curve);
    else
        status = batten_curve_clamp(curve, &clamped);
    if (status == BATTEN_OK)
        status = put_in_plane(chart, clamped, p, derivatives, out, miss);
    batten_curve_unref(clamped);
    return status == BATTEN_BAD_KNOTS ? BATTEN_NOT_FOUND : status;
}

static double border_of(const bat_chart *chart, int side)
{
    const batten_interval domain = chart->domain[side % 2 ? 0 : 1];
    return side == 1 || side == 2 ? domain.b : domain.a;
}

/* The side of the pole q that the curve leaves by: both poles of a torus whose tube touches the
 * axis are one point, and the place at t, near the end of the curve, tells. */
static batten_status choose_pole(bat_chart *chart, const batten_curve *curve, double t,
                                 const double q[3], int *pole)
{
    const int other = (*pole + 2) % 4, fixed = *pole % 2 ? 0 : 1;
    double near[2], c[3], distance;
    if (!chart->pole[other] || bat_distance(3, chart->pole_at[other], q) > chart->tolerance)
        return BATTEN_OK;
    batten_status status = batten_curve_evaluate(curve, t, 0, c);
    if (status == BATTEN_OK)
        status = bat_chart_find(chart, c, NULL, near, &distance);
    if (status == BATTEN_OK && fabs(near[fixed] - border_of(chart, other)) <
                                   fabs(near[fixed] - border_of(chart, *pole)))
        *pole = other;
    return status;
}

/* The feet of both ends; at a pole the other coordinate is that of the middle of the curve. */
static batten_status find_ends(bat_chart *chart, const batten_curve *curve, const double *guess,
                               double ends[2][2])
{
    const batten_interval on = batten_curve_domain(curve);
    batten_status status = BATTEN_OK;
    double distance;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        double q[3];
        status = batten_curve_evaluate(curve, k ? on.b : on.a, 0, q);
        if (status == BATTEN_OK)
            status = bat_chart_find(chart, q, k ? ends[0] : guess, ends[k], &distance);
        if (status == BATTEN_OK && distance > chart->tolerance)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "the edge is %g off the surface at its %s, more than %g", distance,
                            k ? "end" : "start", chart->tolerance);
        int pole = status == BATTEN_OK ? bat_chart_pole(chart, q) : -1;
        if (pole < 0)
            continue;
        double middle[2], c[3];
        const double eighth = (on.b - on.a) / 8;
        status = choose_pole(chart, curve, k ? on.b - eighth : on.a + eighth, q, &pole);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(curve, on.a + (on.b - on.a) / 2, 0, c);
        if (status == BATTEN_OK)
            status = bat_chart_find(chart, c, NULL, middle, &distance);
        const int fixed = pole % 2 ? 0 : 1;
        ends[k][fixed] = border_of(chart, pole);
        ends[k][1 - fixed] = middle[1 - fixed];
    }
    return status;
}

batten_status bat_parameters_straight(bat_chart *chart, const batten_curve *curve,
                                      const double *guess, batten_curve **out, double *miss)
{
    double ends[2][2];
    batten_status status = find_ends(chart, curve, guess, ends);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < 2; k++)
        if (fabs(ends[0][k] - ends[1][k]) <= 1e-3 * chart->near[k])
            ends[1][k] = ends[0][k];
    /* The end may be reached one period around. */
    for (int i = 0; i < 9; i++) {
        const int turns[2] = {(i % 3) == 2 ? -1 : i % 3, (i / 3) == 2 ? -1 : i / 3};
        batten_curve *line = NULL;
        double to[2];
        if ((turns[0] && !chart->closed[0]) || (turns[1] && !chart->closed[1]))
            continue;
        for (int k = 0; k < 2; k++)
            to[k] = ends[1][k] + turns[k] * chart->period[k];
        status = bat_border_line(ends[0], to, batten_curve_domain(curve), &line);
        if (status == BATTEN_OK)
            status = bat_parameters_miss(chart, curve, line, chart->tolerance, miss);
        if (status == BATTEN_OK && *miss <= chart->tolerance) {
            *out = line;
            return BATTEN_OK;
        }
        batten_curve_unref(line);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_NOT_FOUND;
}
