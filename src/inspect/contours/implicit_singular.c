/* Singular points of an implicit curve: where the field and its gradient vanish. */
#include "inspect/contours/implicit_singular.h"
#include "numeric/vector.h"

#include <batten/contours.h>

enum { NEWTON = 20 };

/* ---- singular points ---- */

/* The second derivatives by differences of the gradient: xx, xy, yy. */
static void hessian(const bat_tracer *t, const double *p, double *h)
{
    const double d[2] = {1e-4 * t->step[0], 1e-4 * t->step[1]};
    double g[4][2];
    for (int k = 0; k < 4; k++) {
        const double side = k % 2 ? -1 : 1;
        t->field(t->context, p[0] + (k < 2 ? side * d[0] : 0), p[1] + (k < 2 ? 0 : side * d[1]),
                 g[k]);
    }
    h[0] = (g[0][0] - g[1][0]) / (2 * d[0]);
    h[1] = ((g[0][1] - g[1][1]) / (2 * d[0]) + (g[2][0] - g[3][0]) / (2 * d[1])) / 2;
    h[2] = (g[2][1] - g[3][1]) / (2 * d[1]);
}

/* May the field and its gradient vanish in a cell? By what they can change across it, seen from
 * the corners and, once it is near the curve, from the middle. */
static bool may_be_singular(const bat_tracer *t, int i, int j)
{
    const int corners[4] = {bat_tracer_node(t, i, j), bat_tracer_node(t, i + 1, j),
                            bat_tracer_node(t, i, j + 1), bat_tracer_node(t, i + 1, j + 1)};
    double least = HUGE_VAL, change = 0, g[2], h[3];
    for (int k = 0; k < 4; k++) {
        const double *gradient = t->gradients + 2 * (size_t)corners[k];
        least = bat_min(least, fabs(t->values[corners[k]]));
        change =
            bat_max(change, fabs(gradient[0]) * t->step[0] + fabs(gradient[1]) * t->step[1]);
    }
    if (least > 2 * change)
        return false;
    const double p[2] = {bat_tracer_at(t, 0, i + 0.5), bat_tracer_at(t, 1, j + 0.5)};
    t->field(t->context, p[0], p[1], g);
    hessian(t, p, h);
    return fabs(g[0]) <= fabs(h[0]) * t->step[0] + fabs(h[1]) * t->step[1] &&
           fabs(g[1]) <= fabs(h[1]) * t->step[0] + fabs(h[2]) * t->step[1];
}

/* Newton for gradient = 0 from the middle of a cell; it must end near the cell, with f = 0 as
 * far as second derivatives over the rounding of the place allow. */
static bool find_singular(const bat_tracer *t, double x, double y, batten_singular_point *out)
{
    double p[2] = {x, y}, g[2], h[3], value = 0;
    for (int k = 0; k < NEWTON; k++) {
        value = t->field(t->context, p[0], p[1], g);
        hessian(t, p, h);
        /* damped a little, so that it settles where the Hessian is singular too: at cusps */
        const double most = bat_largest(3, h), shift = 1e-9 * most;
        const double a = h[0] * h[0] + h[1] * h[1] + shift * shift;
        const double b = h[0] * h[1] + h[1] * h[2];
        const double c = h[1] * h[1] + h[2] * h[2] + shift * shift;
        const double r[2] = {h[0] * g[0] + h[1] * g[1], h[1] * g[0] + h[2] * g[1]};
        const double det = a * c - b * b;
        if (!(det > 0))
            return false;
        p[0] -= (c * r[0] - b * r[1]) / det;
        p[1] -= (a * r[1] - b * r[0]) / det;
        if (!(fabs(p[0] - x) <= t->step[0] && fabs(p[1] - y) <= t->step[1]))
            return false;
    }
    value = t->field(t->context, p[0], p[1], g);
    const double reach = bat_norm(2, t->step), most = bat_largest(3, h);
    /* In units of the Hessian over a cell: Newton leaves its square in the value and itself in
     * the gradient, and differences keep about five digits of the latter. */
    if (!(fabs(value) <= 1e-9 * most * reach * reach && bat_norm(2, g) <= 1e-5 * most * reach))
        return false;
    const double det = h[0] * h[2] - h[1] * h[1], lost = 1e-4 * most * most;
    *out = (batten_singular_point){p[0], p[1],
                                   det < -lost  ? BATTEN_SINGULAR_CROSSING
                                   : det > lost ? BATTEN_SINGULAR_ISOLATED
                                                : BATTEN_SINGULAR_CUSP};
    return true;
}

static batten_status add_singular(const bat_tracer *t, batten_trace *out, int *room,
                                  const batten_singular_point *found)
{
    for (int i = 0; i < out->singular_count; i++)
        if (fabs(out->singular[i].x - found->x) <= 1e-3 * t->step[0] &&
            fabs(out->singular[i].y - found->y) <= 1e-3 * t->step[1])
            return BATTEN_OK;
    if (out->singular_count == *room) {
        *room = bat_max_int(4, 2 * *room);
        batten_singular_point *grown = bat_resize(out->singular, (size_t)*room, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        out->singular = grown;
    }
    out->singular[out->singular_count++] = *found;
    return BATTEN_OK;
}

batten_status bat_tracer_find_singular(const bat_tracer *t, batten_trace *out)
{
    int room = 0;
    batten_status status = BATTEN_OK;
    for (int j = 0; j < t->cells; j++)
        for (int i = 0; i < t->cells && status == BATTEN_OK; i++) {
            batten_singular_point found;
            if (may_be_singular(t, i, j) && find_singular(t, bat_tracer_at(t, 0, i + 0.5),
                                                          bat_tracer_at(t, 1, j + 0.5), &found))
                status = add_singular(t, out, &room, &found);
        }
    return status;
}
