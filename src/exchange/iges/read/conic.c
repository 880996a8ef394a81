/* 104: conics, given by their equation and two points. */
#include "body/elementary/elementary.h"
#include "exchange/iges/read/curves.h"

#include <string.h>

/* a x^2 + b x y + c y^2 + d x + e y + f = 0 at the height z, from s to e. */
typedef struct {
    double a, b, c, d, e, f, z;
    double s[2], t[2];
} equation;

/* A conic in its own axes: kind, origin, direction of its x-axis, half axes. */
typedef struct {
    bat_conic_kind kind;
    double origin[2], angle, a, b;
} canonical;

/* With the x-axis turned by the angle the mixed term is gone. */
static double principal_angle(const equation *q)
{
    return q->b == 0 ? 0 : bat_atan2(q->b, q->a - q->c) / 2;
}

/* Ellipse or hyperbola: l1 x^2 + l2 y^2 = r about its centre. */
static void central(const equation *q, canonical *out)
{
    const double determinant = 4 * q->a * q->c - q->b * q->b;
    const double x = (q->b * q->e - 2 * q->c * q->d) / determinant,
                 y = (q->b * q->d - 2 * q->a * q->e) / determinant;
    const double r = -(q->f + (q->d * x + q->e * y) / 2);
    double angle = principal_angle(q);
    const double cosine = bat_cos(angle), sine = bat_sin(angle);
    double l1 = q->a * cosine * cosine + q->b * cosine * sine + q->c * sine * sine;
    double l2 = q->a * sine * sine - q->b * cosine * sine + q->c * cosine * cosine;
    /* The first axis of a hyperbola is the one that meets it. */
    if (determinant < 0 && l1 / r < 0) {
        const double kept = l1;
        l1 = l2;
        l2 = kept;
        angle += BAT_PI / 2;
    }
    out->kind = determinant > 0 ? BAT_ELLIPSE : BAT_HYPERBOLA;
    memcpy(out->origin, (double[]){x, y}, sizeof out->origin);
    out->angle = angle;
    out->a = sqrt(r / l1);
    out->b = sqrt(determinant > 0 ? r / l2 : -r / l2);
    /* The branch on which the start is. */
    if (determinant < 0 && (q->s[0] - x) * bat_cos(angle) + (q->s[1] - y) * bat_sin(angle) < 0)
        out->angle += BAT_PI;
}

/* l (y')^2 + d' x' + e' y' + f = 0 with x' along the axis: a is the focal distance. */
static void parabola(const equation *q, canonical *out)
{
    double angle = principal_angle(q);
    double cosine = bat_cos(angle), sine = bat_sin(angle);
    double l1 = q->a * cosine * cosine + q->b * cosine * sine + q->c * sine * sine;
    double l2 = q->a * sine * sine - q->b * cosine * sine + q->c * cosine * cosine;
    if (fabs(l1) > fabs(l2)) {
        angle += BAT_PI / 2;
        cosine = bat_cos(angle);
        sine = bat_sin(angle);
        l2 = l1;
    }
    const double d = q->d * cosine + q->e * sine, e = q->e * cosine - q->d * sine;
    const double v = -e / (2 * l2), u = -(l2 * v * v + e * v + q->f) / d;
    out->kind = BAT_PARABOLA;
    out->origin[0] = u * cosine - v * sine;
    out->origin[1] = u * sine + v * cosine;
    /* y'^2 = -(d / l) x' = 4 a x': it opens along x' when that is positive. */
    out->a = fabs(d / l2) / 4;
    out->b = 0;
    out->angle = -d / l2 > 0 ? angle : angle + BAT_PI;
}

/* The same curve with its largest quadratic term near 1, to the bit; false when it has none. */
static bool normalise(equation *q)
{
    double *const terms[] = {&q->a, &q->b, &q->c, &q->d, &q->e, &q->f};
    const double largest = bat_max(fabs(q->a), bat_max(fabs(q->b), fabs(q->c)));
    int exponent = 0;
    frexp(largest, &exponent);
    for (int k = 0; k < 6; k++)
        *terms[k] = ldexp(*terms[k], -exponent);
    return largest > 0;
}

/* By the invariants; what is nearly 0 beside its parts is 0. */
static batten_status make_canonical(const equation *said, canonical *out)
{
    equation q = *said;
    if (!normalise(&q))
        return bat_fail(BATTEN_SINGULAR_HERE, "an equation without a quadratic term");
    const double determinant = 4 * q.a * q.c - q.b * q.b;
    const double scale = 4 * fabs(q.a * q.c) + q.b * q.b;
    /* The coefficients have 12 digits or so: nearer to a parabola they cannot tell. */
    if (fabs(determinant) <= 1e-12 * scale)
        parabola(&q, out);
    else
        central(&q, out);
    const bool is_parabola = out->kind == BAT_PARABOLA;
    if (out->a > 0 && (is_parabola || out->b > 0) &&
        isfinite(out->a + out->b + out->origin[0] + out->origin[1]))
        return BATTEN_OK;
    return bat_fail(BATTEN_SINGULAR_HERE, "the equation %g %g %g %g %g %g describes no curve",
                    said->a, said->b, said->c, said->d, said->e, said->f);
}

/* How far a point is from the conic. */
static double off(const bat_conic *conic, const double p[3])
{
    double foot[3];
    bat_conic_point(conic, bat_conic_parameter(conic, p), foot);
    return bat_hypot(p[0] - foot[0], p[1] - foot[1]);
}

batten_status bat_iges_read_conic(bat_iges_item *item)
{
    static const char *const names[] = {"", "an ellipse", "a hyperbola", "a parabola"};
    static const bat_conic_kind kinds[] = {BAT_ELLIPSE, BAT_ELLIPSE, BAT_HYPERBOLA,
                                           BAT_PARABOLA};
    double v[11];
    canonical form = {.kind = BAT_ELLIPSE};
    batten_status status = bat_iges_reals_or_0(item, 1, 11, v);
    if (status != BATTEN_OK)
        return status;
    const equation q = {v[0], v[1], v[2], v[3], v[4], v[5], v[6], {v[7], v[8]}, {v[9], v[10]}};
    item->own = 12;
    status = make_canonical(&q, &form);
    if (status != BATTEN_OK)
        return status;
    const int said = item->entry->form;
    if (said > 0 && kinds[said] != form.kind)
        bat_iges_note(item->reading, item->entry,
                      "it is declared %s, but its equation is not; the equation is used",
                      names[said]);
    const bat_conic conic = {form.kind,
                             {{form.origin[0], form.origin[1], q.z},
                              {bat_cos(form.angle), bat_sin(form.angle), 0},
                              {0, 0, 1}},
                             form.a,
                             form.b};
    const double start[3] = {q.s[0], q.s[1], q.z}, end[3] = {q.t[0], q.t[1], q.z};
    /* An ellipse runs counter-clockwise; of the others the two points say the direction. */
    const bool forward = form.kind == BAT_ELLIPSE ||
                         bat_conic_parameter(&conic, start) < bat_conic_parameter(&conic, end);
    const double size = bat_max(form.a, bat_hypot(q.s[0] - q.t[0], q.s[1] - q.t[1])),
                 tolerance = bat_iges_tolerance(item->reading, size);
    const double miss = bat_max(off(&conic, start), off(&conic, end));
    if (miss > tolerance)
        bat_iges_note(item->reading, item->entry,
                      "a conic whose ends are %g off its equation; the equation is used", miss);
    return bat_conic_part(&conic, start, end, forward, tolerance, &item->curve);
}
