/* Steps to the foot of the perpendicular, and the descent that takes and halves them. */
#include "inspect/nearest/foot.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

/* ---- one step ---- */

double bat_foot_curve_step(int d, const double *at, const double *q)
{
    double off[3];
    for (int k = 0; k < d; k++)
        off[k] = at[k] - q[k];
    const double slope = bat_dot(d, at + d, at + d);
    const double bend = slope + bat_dot(d, off, at + 2 * d);
    const double by = bend > slope / 2 ? bend : slope;
    return by > 0 ? -bat_dot(d, off, at + d) / by : 0;
}

void bat_foot_slopes(int d, const double *s, int order, const double *q, bat_foot_place *out)
{
    const double *su = s + d, *sv = s + 2 * d;
    double r[3];
    for (int k = 0; k < d; k++)
        r[k] = s[k] - q[k];
    out->value = bat_dot(d, r, r) / 2;
    out->gradient[0] = bat_dot(d, r, su);
    out->gradient[1] = bat_dot(d, r, sv);
    out->normal[0] = bat_dot(d, su, su);
    out->normal[1] = bat_dot(d, su, sv);
    out->normal[2] = bat_dot(d, sv, sv);
    for (int k = 0; k < 3; k++)
        out->second[k] =
            out->normal[k] + (order > 1 ? bat_dot(d, r, s + (size_t)((3 + k) * d)) : 0);
}

bool bat_foot_solve(const double h[3], const double g[2], const bool free[2], double step[2])
{
    step[0] = step[1] = 0;
    if (free[0] && free[1]) {
        if (!(h[0] > 0 && h[2] > 0))
            return false;
        /* In units in which the diagonal is 1: squares of squares stay within the numbers. The
         * determinant must be above its rounding. */
        const double su = sqrt(h[0]), sv = sqrt(h[2]), c = h[1] / su / sv, det = 1 - c * c;
        if (!(det > 64 * DBL_EPSILON))
            return false;
        step[0] = (c * g[1] / sv - g[0] / su) / det / su;
        step[1] = (c * g[0] / su - g[1] / sv) / det / sv;
        return true;
    }
    const int k = free[0] ? 0 : 1;
    if (!(free[0] || free[1]) || !(h[2 * k] > 0))
        return false;
    step[k] = -g[k] / h[2 * k];
    return true;
}

static bool is_trusted(const double second[3], const double normal[3], double trust)
{
    return second[0] > trust * normal[0] && second[2] > trust * normal[2] &&
           second[0] * second[2] - second[1] * second[1] >
               trust * trust * (normal[0] * normal[2] - normal[1] * normal[1]);
}

void bat_foot_step(const bat_foot_place *here, const bool free[2], double trust, double step[2])
{
    const double *g = here->gradient, *normal = here->normal;
    if (trust == 0 || is_trusted(here->second, normal, trust))
        if (bat_foot_solve(here->second, g, free, step))
            return;
    if (bat_foot_solve(normal, g, free, step))
        return;
    for (int k = 0; k < 2; k++) /* the tangents span no plane: each direction by itself */
        step[k] = free[k] && normal[2 * k] > 0 ? -g[k] / normal[2 * k] : 0;
}

/* ---- downhill ---- */

/* Where 2^-half of the step leads, inside the limits. */
static void move_inside(const bat_foot_descent *d, const double from[2], const double step[2],
                        int half, double to[2])
{
    for (int k = 0; k < 2; k++) {
        const double by =
            bat_max(-d->longest[k], bat_min(d->longest[k], ldexp(step[k], -half)));
        to[k] = bat_min(d->high[k], bat_max(d->low[k], from[k] + by));
    }
}

/* Take the step, or the first of its halves that comes nearer; *better: one does. */
static batten_status take_step(const bat_foot_descent *d, const double step[2],
                               bat_foot_place *foot, bool *better)
{
    *better = false;
    for (int half = 0; half < d->halvings; half++) {
        bat_foot_place there;
        move_inside(d, foot->at, step, half, there.at);
        if (there.at[0] == foot->at[0] && there.at[1] == foot->at[1])
            return BATTEN_OK;
        const double to[2] = {there.at[0], there.at[1]};
        const batten_status status = d->look(d->context, to, &there);
        if (status != BATTEN_OK)
            return status;
        if (there.value < foot->value) {
            *foot = there;
            *better = true;
            return BATTEN_OK;
        }
    }
    return BATTEN_OK;
}

batten_status bat_foot_descend(const bat_foot_descent *d, bat_foot_place *foot)
{
    bool better = true;
    const double start[2] = {foot->at[0], foot->at[1]};
    batten_status status = d->look(d->context, start, foot);
    for (int i = 0; status == BATTEN_OK && better && i < d->steps; i++) {
        double step[2];
        bool free[2];
        for (int k = 0; k < 2; k++) {
            const double g = foot->gradient[k];
            free[k] =
                !((foot->at[k] <= d->low[k] && g > 0) || (foot->at[k] >= d->high[k] && g < 0));
        }
        d->step(foot, free, step);
        if (fabs(step[0]) < d->least[0] && fabs(step[1]) < d->least[1])
            break;
        status = take_step(d, step, foot, &better);
    }
    return status;
}

/* ---- on a surface ---- */

typedef struct {
    const bat_foot_area *area;
    const double *q;
    int order;
} surface_search;

static batten_status look_on_surface(const void *context, const double at[2],
                                     bat_foot_place *out)
{
    const surface_search *search = context;
    const bat_foot_area *in = search->area;
    double s[BATTEN_SURFACE_DERIVATIVES(2) * 3];
    batten_side side[2];
    for (int k = 0; k < 2; k++)
        side[k] = at[k] >= in->high[k] ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
    const batten_status status = batten_surface_evaluate_side(
        in->surface, at[0], at[1], (batten_sides){side[0], side[1]}, search->order, s);
    if (status != BATTEN_OK)
        return status;
    bat_foot_slopes(batten_surface_dimension(in->surface), s, search->order, search->q, out);
    memcpy(out->at, at, sizeof out->at);
    return BATTEN_OK;
}

static void newton_step(const bat_foot_place *here, const bool free[2], double step[2])
{
    bat_foot_step(here, free, 0, step);
}

batten_status bat_foot_on_surface(const bat_foot_area *area, int order, int steps,
                                  const double *q, bat_foot_place *foot)
{
    enum { HALVINGS = 12 };
    const surface_search search = {area, q, order};
    const bat_foot_descent descent = {.look = look_on_surface,
                                      .step = newton_step,
                                      .context = &search,
                                      .low = {area->low[0], area->low[1]},
                                      .high = {area->high[0], area->high[1]},
                                      .longest = {HUGE_VAL, HUGE_VAL},
                                      .steps = steps,
                                      .halvings = HALVINGS};
    return bat_foot_descend(&descent, foot);
}
