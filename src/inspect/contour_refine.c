/* Points of a contour between two that are known. */
#include "inspect/contour_lines.h"

#include "numeric/vector.h"

#include <string.h>

enum { DEPTH = 14, MOST_STEPS = 8 };

typedef struct {
    double uv[2], point[3];
} spot;

static batten_status spot_at(const bat_net *net, int piece, const double uv[2], spot *out)
{
    double derivatives[9], value;
    const batten_status status = bat_net_field(net, piece, uv, &value, NULL, derivatives);
    memcpy(out->uv, uv, sizeof out->uv);
    memcpy(out->point, derivatives, sizeof out->point);
    return status;
}

/* The shortest step on the surface that changes the field by `change`, to first order: along
 * the gradient in the metric of the surface. */
static bool step_for(const double derivatives[9], const double gradient[2], double change,
                     double step[2])
{
    const double *su = derivatives + 3, *sv = derivatives + 6;
    const double E = bat_dot(3, su, su), F = bat_dot(3, su, sv), G = bat_dot(3, sv, sv);
    const double det = E * G - F * F;
    const double a = (G * gradient[0] - F * gradient[1]) / det;
    const double b = (E * gradient[1] - F * gradient[0]) / det;
    const double slope2 = a * gradient[0] + b * gradient[1];
    step[0] = change * a / slope2;
    step[1] = change * b / slope2;
    return isfinite(step[0]) && isfinite(step[1]);
}

/* Into the box of the triangle: a chord is short, and the contour near it. */
static void clamp(const bat_triangle *t, double uv[2])
{
    for (int k = 0; k < 2; k++) {
        const double a = t->uv[0][k], b = t->uv[1][k], c = t->uv[2][k];
        uv[k] = bat_max(bat_min(a, bat_min(b, c)), bat_min(uv[k], bat_max(a, bat_max(b, c))));
    }
}

/* From uv onto the contour. Not found: no gradient, or no convergence. */
static batten_status project(const bat_net *net, const bat_triangle *t, double level, spot *s,
                             bool *found)
{
    *found = false;
    for (int i = 0; i <= MOST_STEPS; i++) {
        double value, gradient[2], derivatives[9], step[2];
        const batten_status status =
            bat_net_field(net, t->piece, s->uv, &value, gradient, derivatives);
        if (status != BATTEN_OK || isnan(value))
            return status;
        memcpy(s->point, derivatives, sizeof s->point);
        *found = fabs(value - level) <= net->roundoff;
        if (*found || !step_for(derivatives, gradient, level - value, step))
            return BATTEN_OK;
        for (int k = 0; k < 2; k++)
            s->uv[k] += step[k];
        clamp(t, s->uv);
    }
    return BATTEN_OK;
}

/* A piece of a triangle may be a part of the box of its corners only; for pieces over triangles
 * the projection is left out where it would leave the piece. */
static bool is_in_piece(const bat_net *net, int piece, const double uv[2])
{
    const bat_pieces *p = net->pieces;
    if (p->corner_count == 4)
        return true;
    const double *c = p->uv + 6 * (size_t)piece;
    for (int k = 0; k < 3; k++) {
        const double *a = c + 2 * k, *b = c + 2 * ((k + 1) % 3);
        if ((b[0] - a[0]) * (uv[1] - a[1]) - (b[1] - a[1]) * (uv[0] - a[0]) < 0)
            return false;
    }
    return true;
}

batten_status bat_line_refine(const bat_net *net, const bat_triangle *t, int level,
                              const double from[2], const double to[2], bat_lines *lines,
                              bat_line *line)
{
    spot stack[DEPTH + 1], here;
    int depth = 0;
    batten_status status = spot_at(net, t->piece, from, &here);
    if (status == BATTEN_OK)
        status = spot_at(net, t->piece, to, &stack[0]);
    while (status == BATTEN_OK && depth >= 0) {
        const spot *next = &stack[depth];
        spot middle = {
            .uv = {0.5 * (here.uv[0] + next->uv[0]), 0.5 * (here.uv[1] + next->uv[1])}};
        bool found;
        status = project(net, t, net->levels[level], &middle, &found);
        if (status != BATTEN_OK)
            break;
        const double off = bat_segment_distance(3, here.point, next->point, middle.point);
        found = found && is_in_piece(net, t->piece, middle.uv);
        if (found && off > 0.7 * lines->tolerance && depth < DEPTH) {
            stack[++depth] = middle;
            continue;
        }
        if (found)
            lines->error = bat_max(lines->error, off);
        here = *next;
        if (depth-- > 0)
            status = bat_line_add(line, here.point, here.uv);
    }
    return status;
}
