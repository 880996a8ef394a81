/* Parameter curves lifted onto their surface: curves in space within a tolerance. */
#include "body/trace/lift.h"

#include <string.h>

enum { MOST_SPANS = 20000, CHECKS = 3 };

/* One place of S(B): the parameter, the point and its derivative. */
typedef struct {
    double t, value[6];
} lifted_place;

typedef struct {
    const batten_surface *surface;
    const batten_curve *parameters;
    batten_interval u, v; /* of the surface */
    double tolerance, error;
    int spans, room;
    double *points; /* [3 spans + 1][3], of Bezier pieces */
    double *breaks; /* [spans + 1] */
} lifting;

/* Rounding may have put a parameter just outside. */
static double within(double x, batten_interval range)
{
    const double slack = 1e-9 * (range.b - range.a);
    if (x < range.a && x >= range.a - slack)
        return range.a;
    return x > range.b && x <= range.b + slack ? range.b : x;
}

/* @param side from which the derivative of B is taken, at its knots */
static batten_status evaluate(const lifting *l, double t, batten_side side, double value[6])
{
    double uv[2][2], s[3][3];
    batten_status status = batten_curve_evaluate_side(l->parameters, t, side, 1, &uv[0][0]);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate(l->surface, within(uv[0][0], l->u),
                                         within(uv[0][1], l->v), 1, &s[0][0]);
    for (int k = 0; status == BATTEN_OK && k < 3; k++) {
        value[k] = s[0][k];
        value[3 + k] = s[1][k] * uv[1][0] + s[2][k] * uv[1][1];
    }
    return status;
}

static batten_status make_room(lifting *l)
{
    if (l->spans >= MOST_SPANS)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "a curve on a surface keeps within %g after %d spans", l->error,
                        MOST_SPANS);
    if (l->spans < l->room)
        return BATTEN_OK;
    const int room = bat_max_int(64, 2 * l->room);
    double *points = bat_resize(l->points, 3 * (size_t)room + 1, 3 * sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    l->points = points;
    double *breaks = bat_resize(l->breaks, (size_t)room + 1, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    l->breaks = breaks;
    l->room = room;
    return BATTEN_OK;
}

/* The Bezier points of the cubic between two places. */
static void put_cubic(const lifted_place *a, const lifted_place *b, double *p)
{
    const double third = (b->t - a->t) / 3;
    for (int k = 0; k < 3; k++) {
        p[k] = a->value[k];
        p[3 + k] = a->value[k] + third * a->value[3 + k];
        p[6 + k] = b->value[k] - third * b->value[3 + k];
        p[9 + k] = b->value[k];
    }
}

/* The cubic between two places as the next Bezier piece. */
static batten_status add_span(lifting *l, const lifted_place *a, const lifted_place *b)
{
    batten_status status = make_room(l);
    if (status != BATTEN_OK)
        return status;
    put_cubic(a, b, &l->points[9 * (size_t)l->spans]);
    l->breaks[l->spans] = a->t;
    l->breaks[++l->spans] = b->t;
    return BATTEN_OK;
}

/* The cubic between two places, at the share x of the way. */
static void cubic(const lifted_place *a, const lifted_place *b, double x, double point[3])
{
    const double h = b->t - a->t, y = 1 - x;
    for (int k = 0; k < 3; k++)
        point[k] = y * y * (1 + 2 * x) * a->value[k] + x * x * (1 + 2 * y) * b->value[k] +
                   h * x * y * (y * a->value[3 + k] - x * b->value[3 + k]);
}

/* How far the cubic between two places is off. */
static batten_status miss_between(const lifting *l, const lifted_place *a,
                                  const lifted_place *b, double *miss)
{
    *miss = 0;
    for (int i = 1; i <= CHECKS; i++) {
        const double x = (double)i / (CHECKS + 1);
        double value[6], point[3];
        batten_status status = evaluate(l, a->t + x * (b->t - a->t), BATTEN_FROM_RIGHT, value);
        if (status != BATTEN_OK)
            return status;
        cubic(a, b, x, point);
        *miss = bat_max(*miss, bat_hypot(bat_hypot(point[0] - value[0], point[1] - value[1]),
                                         point[2] - value[2]));
    }
    return BATTEN_OK;
}

/* Between two knots of B, halving: what is still to come lies on a stack, for an interval has
 * no more halves than a double has bits. */
static batten_status lift_piece(lifting *l, double from, double to)
{
    enum { DEEPEST = 60 };
    lifted_place stack[DEEPEST], a = {.t = from};
    int depth = 1;
    stack[0].t = to;
    batten_status status = evaluate(l, from, BATTEN_FROM_RIGHT, a.value);
    if (status == BATTEN_OK)
        status = evaluate(l, to, BATTEN_FROM_LEFT, stack[0].value);
    while (status == BATTEN_OK && depth > 0) {
        const lifted_place *b = &stack[depth - 1];
        const double middle = a.t + (b->t - a.t) / 2;
        double miss = 0;
        status = miss_between(l, &a, b, &miss);
        if (status != BATTEN_OK)
            break;
        if (miss > l->tolerance && depth < DEEPEST && middle > a.t && middle < b->t) {
            stack[depth].t = middle;
            status = evaluate(l, middle, BATTEN_FROM_RIGHT, stack[depth].value);
            depth++;
        } else {
            l->error = bat_max(l->error, miss);
            status = add_span(l, &a, b);
            a = *b;
            depth--;
        }
    }
    return status;
}

static batten_status lift_all(lifting *l, batten_curve **out)
{
    const int count = batten_curve_spans(l->parameters, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (knots)
        batten_curve_spans(l->parameters, knots);
    for (int i = 0; status == BATTEN_OK && i + 1 < count; i++)
        status = lift_piece(l, knots[i], knots[i + 1]);
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier(3, (batten_pieces){3, l->spans, l->breaks}, l->points,
                                          NULL, out);
    bat_release(knots);
    bat_release(l->points);
    bat_release(l->breaks);
    return status;
}

/* Is B a line along u or v, at even speed? Its ends are its control points. */
static bool is_isoline(const batten_curve *parameters, batten_direction *fixed)
{
    const double *p = batten_curve_points(parameters);
    if (batten_curve_degree(parameters) != 1 || batten_curve_point_count(parameters) != 2 ||
        batten_curve_is_rational(parameters) || !batten_curve_is_clamped(parameters))
        return false;
    *fixed = p[0] == p[2] ? BATTEN_U : BATTEN_V;
    return (p[0] == p[2]) != (p[1] == p[3]);
}

static batten_status lift_isoline(const lifting *l, batten_direction fixed, batten_curve **out)
{
    const double *p = batten_curve_points(l->parameters);
    const batten_interval domain = batten_curve_domain(l->parameters);
    const int along = fixed == BATTEN_U ? 1 : 0;
    const batten_interval range = along ? l->v : l->u;
    const double a = within(p[along], range), b = within(p[2 + along], range);
    batten_curve *line = NULL, *part = NULL, *turned = NULL;
    batten_status status = batten_surface_isocurve(
        l->surface, fixed, within(p[1 - along], along ? l->u : l->v), &line);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(line, bat_min(a, b), bat_max(a, b), &part);
    if (status == BATTEN_OK && a > b)
        status = batten_curve_reverse(part, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(turned ? turned : part, domain.a, domain.b, out);
    batten_curve_unref(line);
    batten_curve_unref(part);
    batten_curve_unref(turned);
    return status;
}

batten_status bat_lift(const batten_surface *surface, const batten_curve *parameters,
                       double tolerance, batten_curve **out, double *error)
{
    lifting l = {.surface = surface,
                 .parameters = parameters,
                 .u = batten_surface_domain(surface, BATTEN_U),
                 .v = batten_surface_domain(surface, BATTEN_V),
                 .tolerance = tolerance};
    batten_direction fixed = BATTEN_U;
    batten_status status = BATTEN_OK;
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    if (strcmp(batten_surface_kind(surface), "nurbs") == 0 && is_isoline(parameters, &fixed))
        status = lift_isoline(&l, fixed, out);
    else
        status = lift_all(&l, out);
    if (status == BATTEN_OK && error)
        *error = l.error;
    return status;
}
