/* Points of a contour between two that are known. */
#include "inspect/contours/lines.h"

#include "numeric/vector.h"

#include <string.h>

enum { DEPTH = 14, EASY_DEPTH = 10, MOST_STEPS = 8 };

typedef struct {
    double uv[2], point[3];
    double tangent[3]; /* unit; of smooth lines; 0 where there is none */
    int halvings;      /* after which it was found */
} spot;

/* Across the gradient, on the surface. */
static void find_tangent(const double derivatives[9], const double gradient[2], spot *s)
{
    double length;
    for (int k = 0; k < 3; k++)
        s->tangent[k] = gradient[0] * derivatives[6 + k] - gradient[1] * derivatives[3 + k];
    length = bat_norm(3, s->tangent);
    for (int k = 0; k < 3; k++)
        s->tangent[k] = length > 0 && isfinite(length) ? s->tangent[k] / length : 0;
}

static batten_status spot_at(const bat_net *net, int piece, const double uv[2], bool smooth,
                             spot *out)
{
    double derivatives[9], value, gradient[2];
    const batten_status status =
        bat_net_field(net, piece, uv, &value, smooth ? gradient : NULL, derivatives);
    *out = (spot){.uv = {uv[0], uv[1]}};
    memcpy(out->point, derivatives, sizeof out->point);
    if (status == BATTEN_OK && smooth)
        find_tangent(derivatives, gradient, out);
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
        find_tangent(derivatives, gradient, s);
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

/* Between two spots of a part. */
typedef struct {
    const bat_line_part *on;
    const spot *a, *b;
} part_chord;

/* On the contour, at a share of the way. */
static batten_status find_between(const part_chord *c, double share, spot *out, bool *found)
{
    const bat_net *net = c->on->net;
    const bat_triangle *t = c->on->triangle;
    *out = (spot){.uv = {(1 - share) * c->a->uv[0] + share * c->b->uv[0],
                         (1 - share) * c->a->uv[1] + share * c->b->uv[1]}};
    const batten_status status = project(net, t, net->levels[c->on->level], out, found);
    *found = *found && is_in_piece(net, t->piece, out->uv);
    return status;
}

/* ---- cubics ---- */

/* The end of a cubic near the arc from `at` that leaves along `tangent` towards `to`: of a
 * circular arc that which meets its middle. */
static void find_arm(const spot *at, const spot *to, double *arm)
{
    const double chord = bat_distance(3, at->point, to->point);
    double cosine = 0, side = 1;
    for (int k = 0; k < 3; k++)
        cosine += at->tangent[k] * (to->point[k] - at->point[k]) / (chord > 0 ? chord : 1);
    if (cosine < 0)
        side = -1;
    const bool none = bat_norm(3, at->tangent) == 0;
    for (int k = 0; k < 3; k++)
        arm[k] = at->point[k] +
                 (none ? (to->point[k] - at->point[k]) / 3
                       : side * at->tangent[k] * chord * 2 / (3 * (1 + fabs(cosine))));
}

/* Of a point from a cubic, near a share of its way. */
static double distance_from(double b[4][3], const double *point, double s)
{
    double gap[3], slope[3];
    for (int i = 0; i < 5; i++) {
        const double r = 1 - s;
        for (int k = 0; k < 3; k++) {
            gap[k] = r * r * r * b[0][k] + 3 * r * r * s * b[1][k] + 3 * r * s * s * b[2][k] +
                     s * s * s * b[3][k] - point[k];
            slope[k] = 3 * (r * r * (b[1][k] - b[0][k]) + 2 * r * s * (b[2][k] - b[1][k]) +
                            s * s * (b[3][k] - b[2][k]));
        }
        const double square = bat_dot(3, slope, slope);
        if (!(square > 0))
            break;
        s = bat_max(0, bat_min(1, s - bat_dot(3, gap, slope) / square));
    }
    return bat_norm(3, gap);
}

/* ---- between two spots ---- */

/* How far a chord, or the cubic in its place, is from the contour. */
typedef struct {
    spot middle; /* of the contour */
    bool found;
    double off;
    double arms[2][3]; /* the inner control points of the cubic */
} measured;

/* The cubic of a circular arc is exact in its middle, and farthest off near the quarters. */
static batten_status measure_cubic(const part_chord *c, measured *m)
{
    double bezier[4][3];
    find_arm(c->a, c->b, m->arms[0]);
    find_arm(c->b, c->a, m->arms[1]);
    memcpy(bezier[0], c->a->point, sizeof bezier[0]);
    memcpy(bezier[1], m->arms, sizeof m->arms);
    memcpy(bezier[3], c->b->point, sizeof bezier[3]);
    m->off = distance_from(bezier, m->middle.point, 0.5);
    batten_status status = BATTEN_OK;
    for (int i = 1; i < 4 && status == BATTEN_OK; i += 2) {
        spot quarter;
        bool near;
        status = find_between(c, 0.25 * i, &quarter, &near);
        if (status == BATTEN_OK && near)
            m->off = bat_max(m->off, distance_from(bezier, quarter.point, 0.25 * i));
    }
    return status;
}

static batten_status measure_chord(const part_chord *c, bool smooth, measured *m)
{
    const batten_status status = find_between(c, 0.5, &m->middle, &m->found);
    if (status != BATTEN_OK || !m->found)
        return status;
    if (smooth)
        return measure_cubic(c, m);
    m->off = bat_segment_distance(3, c->a->point, c->b->point, m->middle.point);
    return BATTEN_OK;
}

batten_status bat_line_predict(const bat_line_part *part, const bat_lines *lines,
                               double *chords)
{
    spot a, b;
    measured m = {.found = false};
    batten_status status = spot_at(part->net, part->triangle->piece, part->from, false, &a);
    if (status == BATTEN_OK)
        status = spot_at(part->net, part->triangle->piece, part->to, false, &b);
    if (status == BATTEN_OK)
        status = measure_chord(&(part_chord){part, &a, &b}, false, &m);
    *chords = 1 + (m.found ? sqrt(m.off / (0.7 * lines->tolerance)) : 0);
    return status;
}

/* A point more; the caller of the whole is asked now and then. */
static batten_status count_point(bat_lines *lines)
{
    if (++lines->done % 256)
        return BATTEN_OK;
    if (lines->done > BAT_MOST_CHORDS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "contours within %g have more than %d points: the tolerance is too "
                        "small",
                        lines->tolerance, (int)BAT_MOST_CHORDS);
    return bat_work_step(lines->work, 256, 0.5, "contours");
}

/* The cubic from the last point of the line. */
static void put_arms(bat_lines *lines, bat_line *line, double arms[2][3])
{
    if (line->count > 0)
        bat_line_set_arm(line, 1, arms[0]);
    memcpy(lines->arm, arms[1], sizeof lines->arm);
    lines->has_arm = true;
}

/* Along a jump of the field, or where it has no value, Newton's method goes anywhere, and more
 * points help nothing: on a contour a middle is about as far from both ends. */
static bool is_between(const spot *a, const spot *middle, const spot *b)
{
    const double first = bat_distance(3, a->point, middle->point),
                 second = bat_distance(3, middle->point, b->point);
    return first < 8 * second && second < 8 * first &&
           bat_max(first, second) < bat_distance(3, a->point, b->point);
}

/* Shall the chord be halved? */
static bool is_to_be_halved(const bat_lines *lines, const part_chord *c, const measured *m)
{
    return m->found && m->off > 0.7 * lines->tolerance && m->middle.halvings <= DEPTH &&
           (m->middle.halvings <= EASY_DEPTH || is_between(c->a, &m->middle, c->b));
}

/* The chord stays. */
static void keep_chord(bat_lines *lines, bat_line *line, measured *m)
{
    if (m->found)
        lines->error = bat_max(lines->error, m->off);
    lines->has_arm = false;
    if (lines->smooth && m->found)
        put_arms(lines, line, m->arms);
}

batten_status bat_line_refine(const bat_line_part *part, bat_lines *lines, bat_line *line)
{
    const int piece = part->triangle->piece;
    spot stack[DEPTH + 1], here;
    int depth = 0;
    batten_status status = spot_at(part->net, piece, part->from, lines->smooth, &here);
    if (status == BATTEN_OK)
        status = spot_at(part->net, piece, part->to, lines->smooth, &stack[0]);
    while (status == BATTEN_OK && depth >= 0) {
        const part_chord next = {part, &here, &stack[depth]};
        measured m = {.found = false};
        status = measure_chord(&next, lines->smooth, &m);
        if (status == BATTEN_OK)
            status = count_point(lines);
        if (status != BATTEN_OK)
            break;
        m.middle.halvings = 1 + bat_max_int(here.halvings, next.b->halvings);
        if (is_to_be_halved(lines, &next, &m)) {
            stack[++depth] = m.middle;
            continue;
        }
        keep_chord(lines, line, &m);
        here = *next.b;
        if (depth-- == 0)
            break;
        status = bat_line_add(line, here.point, here.uv);
        if (status == BATTEN_OK && lines->has_arm)
            bat_line_set_arm(line, 0, lines->arm);
    }
    return status;
}
