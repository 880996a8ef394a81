/* The sides of a hole in order, each smooth, polynomial, over [0, 2], in a box of size 1. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include "spline/curve/curve.h"
#include <batten/approximate.h>

/* Polynomial and clamped; *error grows by how far it moved. */
static batten_status make_polynomial(double tolerance, double *error, batten_curve **curve)
{
    batten_curve *made = NULL;
    if (!batten_curve_is_rational(*curve))
        return bat_curve_replace(batten_curve_clamp(*curve, &made), curve, &made);
    double moved = 0;
    const int degree = bat_max_int(5, batten_curve_degree(*curve));
    const batten_status status =
        batten_curve_approximate(*curve, degree, tolerance, &moved, &made);
    if (status == BATTEN_OK && moved > *error)
        *error = moved;
    return bat_curve_replace(status, curve, &made);
}

/* The same curve with knots that are 1 but for rounding at 1: there the side is halved, and a
 * sliver of a span would be left. */
static batten_status settle_middle(const batten_curve *curve, batten_curve **out)
{
    const int count = batten_curve_knot_count(curve);
    const double *knots = batten_curve_knots(curve);
    double *settled = bat_array((size_t)count, sizeof *settled);
    if (!settled)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        settled[i] = fabs(knots[i] - 1) < BAT_ROUNDING ? 1 : knots[i];
    const batten_status status = batten_curve_create(
        (batten_points){batten_curve_dimension(curve), batten_curve_point_count(curve),
                        batten_curve_points(curve)},
        batten_curve_degree(curve), NULL, settled, out);
    bat_release(settled);
    return status;
}

/* A curve of one side, in the direction of the loop and its coordinates. */
static batten_status take_side(const batten_curve *given, bool reversed,
                               const batten_affine *map, double tolerance, double *error,
                               batten_curve **out)
{
    batten_curve *curve = NULL, *made = NULL;
    batten_status status = batten_curve_transform(given, map, &curve);
    if (status == BATTEN_OK)
        status = make_polynomial(tolerance, error, &curve);
    if (status == BATTEN_OK && reversed)
        status = bat_curve_replace(batten_curve_reverse(curve, &made), &curve, &made);
    if (status == BATTEN_OK)
        status = bat_curve_replace(batten_curve_set_domain(curve, 0, 2, &made), &curve, &made);
    if (status == BATTEN_OK)
        status = bat_curve_replace(settle_middle(curve, &made), &curve, &made);
    if (status == BATTEN_OK)
        *out = curve;
    else
        batten_curve_unref(curve);
    return status;
}

static void free_side(bat_fill_side *side)
{
    batten_curve_unref(side->curve);
    batten_curve_unref(side->slope);
    batten_curve_unref(side->bend);
}

void bat_fill_loop_free(bat_fill_loop *loop)
{
    for (int i = 0; i < loop->count; i++)
        free_side(&loop->sides[i]);
    loop->count = 0;
}

static batten_status add_side(bat_fill_loop *loop, bat_fill_side *side)
{
    if (loop->count == BATTEN_FILL_SIDES) {
        free_side(side);
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the hole has more than %d sides once those with corners are divided",
                        BATTEN_FILL_SIDES);
    }
    loop->sides[loop->count++] = *side;
    return BATTEN_OK;
}

/* Cut one curve at t; both parts over [0, 2]. */
static batten_status cut_sides(const batten_curve *curve, double t, batten_curve **low,
                               batten_curve **high)
{
    batten_curve *a = NULL, *b = NULL, *left = NULL, *right = NULL, *made = NULL;
    if (!curve)
        return BATTEN_OK;
    batten_status status = batten_curve_split(curve, t, &a, &b);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(a, 0, 2, &left);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(b, 0, 2, &right);
    if (status == BATTEN_OK)
        status = bat_curve_replace(settle_middle(left, &made), &left, &made);
    if (status == BATTEN_OK)
        status = bat_curve_replace(settle_middle(right, &made), &right, &made);
    batten_curve_unref(a);
    batten_curve_unref(b);
    if (status != BATTEN_OK) {
        batten_curve_unref(left);
        batten_curve_unref(right);
        return status;
    }
    *low = left;
    *high = right;
    return BATTEN_OK;
}

static batten_status cut_side(const bat_fill_side *side, double t, bat_fill_side *low,
                              bat_fill_side *high)
{
    low->given = high->given = side->given;
    batten_status status = cut_sides(side->curve, t, &low->curve, &high->curve);
    if (status == BATTEN_OK)
        status = cut_sides(side->slope, t, &low->slope, &high->slope);
    if (status == BATTEN_OK)
        status = cut_sides(side->bend, t, &low->bend, &high->bend);
    if (status != BATTEN_OK) {
        free_side(low);
        free_side(high);
        *low = *high = (bat_fill_side){0};
    }
    return status;
}

/* The first knot at which the derivative jumps; 2 for none. */
static batten_status first_corner(const batten_curve *curve, double *at)
{
    double *knots = bat_array((size_t)batten_curve_point_count(curve) + 1, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    const int count = knots ? batten_curve_spans(curve, knots) : 0;
    *at = 2;
    for (int i = 1; status == BATTEN_OK && i < count - 1 && *at == 2; i++) {
        double left[2][3], right[2][3];
        status = batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_LEFT, 1, left[0]);
        if (status == BATTEN_OK)
            status =
                batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_RIGHT, 1, right[0]);
        /* A millionth: what is less is the rounding of a file. */
        if (status == BATTEN_OK &&
            bat_distance(3, left[1], right[1]) >
                1e-6 * bat_max(bat_norm(3, left[1]), bat_norm(3, right[1])))
            *at = knots[i];
    }
    bat_release(knots);
    return status;
}

/* Add a side, divided at its corners; takes it over. */
static batten_status add_divided(bat_fill_loop *loop, bat_fill_side *side)
{
    for (;;) {
        bat_fill_side low = {0}, high = {0};
        double at;
        batten_status status = first_corner(side->curve, &at);
        if (status == BATTEN_OK && at == 2)
            return add_side(loop, side);
        if (status == BATTEN_OK)
            status = cut_side(side, at, &low, &high);
        free_side(side);
        if (status != BATTEN_OK)
            return status;
        *side = high;
        status = add_side(loop, &low);
        if (status != BATTEN_OK) {
            free_side(side);
            return status;
        }
    }
}

/* The mean length of a derivative, by which slopes get the size of the sides. */
static batten_status mean_length(const batten_curve *curve, int order, double *out)
{
    double sum = 0;
    for (int k = 0; k < 16; k++) {
        double value[2][3];
        const batten_status status =
            batten_curve_evaluate(curve, (k + 0.5) / 8, order, value[0]);
        if (status != BATTEN_OK)
            return status;
        sum += bat_norm(3, value[order]);
    }
    *out = sum / 16;
    return BATTEN_OK;
}

/* Any multiple of a slope says the same; of a second derivative the square of it. */
static batten_status even_scale(bat_fill_side *side)
{
    double speed = 0, across = 0;
    batten_curve *made = NULL;
    if (!side->slope)
        return BATTEN_OK;
    batten_status status = mean_length(side->curve, 1, &speed);
    if (status == BATTEN_OK)
        status = mean_length(side->slope, 0, &across);
    if (status == BATTEN_OK && !(across > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the slope of the ribbon of curve %d is zero",
                        side->given + 1);
    const double factor = speed / across;
    const batten_affine scale = batten_affine_scaling(factor, factor, factor);
    const batten_affine square =
        batten_affine_scaling(factor * factor, factor * factor, factor * factor);
    if (status == BATTEN_OK)
        status = bat_curve_replace(batten_curve_transform(side->slope, &scale, &made),
                                   &side->slope, &made);
    if (status == BATTEN_OK && side->bend)
        status = bat_curve_replace(batten_curve_transform(side->bend, &square, &made),
                                   &side->bend, &made);
    return status;
}

/* Ends meet halfway. */
static batten_status close_corner(batten_curve **before, batten_curve **after)
{
    batten_curve *made = NULL;
    const int last = batten_curve_point_count(*before) - 1;
    const double *end = batten_curve_points(*before) + (size_t)3 * (size_t)last;
    const double *start = batten_curve_points(*after);
    double mean[3];
    for (int c = 0; c < 3; c++)
        mean[c] = end[c] / 2 + start[c] / 2;
    batten_status status =
        bat_curve_replace(batten_curve_with_point(*before, last, mean, &made), before, &made);
    if (status == BATTEN_OK)
        status =
            bat_curve_replace(batten_curve_with_point(*after, 0, mean, &made), after, &made);
    return status;
}

static batten_status add_given(bat_fill_loop *loop, const batten_ribbon *ribbon,
                               const batten_loop_place *place, double tolerance, double *error)
{
    const double f = 1 / loop->size, *o = loop->centre;
    const batten_affine linear = batten_affine_scaling(f, f, f);
    const batten_affine map =
        batten_affine_compose(batten_affine_translation(-o[0], -o[1], -o[2]), linear);
    bat_fill_side side = {.given = place->curve};
    /* A thousandth: planes at the ends are to be met as well as points. */
    const double within = bat_max(BAT_MEANT_SAME, 1e-3 * tolerance / loop->size);
    double ignored = 0;
    batten_status status =
        take_side(ribbon->curve, place->reversed, &map, within, error, &side.curve);
    if (status == BATTEN_OK && ribbon->slope)
        status =
            take_side(ribbon->slope, place->reversed, &linear, within, &ignored, &side.slope);
    if (status == BATTEN_OK && ribbon->slope && ribbon->curvature)
        status = take_side(ribbon->curvature, place->reversed, &linear, within, &ignored,
                           &side.bend);
    if (status == BATTEN_OK)
        status = even_scale(&side);
    if (status == BATTEN_OK)
        return add_divided(loop, &side);
    free_side(&side);
    return status;
}

batten_status bat_fill_check_sides(int count, int most, const batten_ribbon *sides)
{
    if (count < 2 || count > most)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a hole of %d sides cannot be filled: 2 to %d",
                        count, most);
    for (int i = 0; i < count; i++) {
        const batten_curve *all[3] = {sides[i].curve, sides[i].slope, sides[i].curvature};
        for (int k = 0; k < 3; k++)
            if (all[k] && batten_curve_dimension(all[k]) != 3)
                return bat_fail(BATTEN_BAD_ARGUMENT,
                                "curve %d has dimension %d: sides of a hole lie in space",
                                i + 1, batten_curve_dimension(all[k]));
    }
    return BATTEN_OK;
}

/* Centre and half the size of the box of all curves. */
static void find_frame(int count, const batten_ribbon *sides, bat_fill_loop *loop)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < count; i++) {
        const batten_box box = batten_curve_box(sides[i].curve);
        const double a[3] = {box.low.x, box.low.y, box.low.z};
        const double b[3] = {box.high.x, box.high.y, box.high.z};
        for (int c = 0; c < 3; c++) {
            low[c] = bat_min(low[c], a[c]);
            high[c] = bat_max(high[c], b[c]);
        }
    }
    for (int c = 0; c < 3; c++) {
        loop->centre[c] = low[c] / 2 + high[c] / 2;
        loop->size = bat_max(loop->size, high[c] / 2 - low[c] / 2);
    }
}

/* Of two sides the first is halved: three surfaces meet in the centre at least. */
static batten_status halve_first(bat_fill_loop *loop)
{
    bat_fill_side low = {0}, high = {0};
    const batten_status status = cut_side(&loop->sides[0], 1, &low, &high);
    if (status != BATTEN_OK)
        return status;
    free_side(&loop->sides[0]);
    for (int i = loop->count++; i > 1; i--)
        loop->sides[i] = loop->sides[i - 1];
    loop->sides[0] = low;
    loop->sides[1] = high;
    return BATTEN_OK;
}

/* More control points than this in one surface are refused before they are made. */
static const double most_points = 4e6;

/* The least that the surface between two sides can have. */
static batten_status check_size(const bat_fill_loop *loop)
{
    for (int i = 0; i < loop->count; i++) {
        const bat_fill_side *a = &loop->sides[i], *b = &loop->sides[(i + 1) % loop->count];
        const double u = batten_curve_point_count(a->curve) / 2.0;
        const double v = batten_curve_point_count(b->curve) / 2.0;
        if (u * v > most_points)
            return bat_fail(BATTEN_TOO_LARGE,
                            "the surface between curves %d and %d would have more than %.0f x "
                            "%.0f control points; %.0f are the most",
                            a->given + 1, b->given + 1, u, v, most_points);
    }
    return BATTEN_OK;
}

batten_status bat_fill_loop_make(int count, const batten_ribbon *sides, double tolerance,
                                 batten_surface_fill_report *report, bat_fill_loop *out)
{
    bat_fill_loop loop = {0};
    const batten_curve *curves[BATTEN_FILL_SIDES];
    batten_loop_place places[BATTEN_FILL_SIDES];
    batten_status status = bat_fill_check_sides(count, BATTEN_FILL_SIDES, sides);
    if (status != BATTEN_OK)
        return status;
    find_frame(count, sides, &loop);
    if (!(loop.size > 0))
        return bat_fail(BATTEN_COINCIDENT, "all sides of the hole are one point");
    /* A millionth of the hole, when no tolerance is given. */
    if (!(tolerance > 0))
        tolerance = 1e-6 * loop.size;
    for (int i = 0; i < count; i++)
        curves[i] = sides[i].curve;
    status = batten_curves_loop(count, curves, tolerance, places);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        report->loop_gap = bat_max(report->loop_gap, places[i].gap);
        status = add_given(&loop, &sides[places[i].curve], &places[i], tolerance,
                           &report->approximation);
    }
    if (status == BATTEN_OK)
        status = check_size(&loop);
    if (status == BATTEN_OK && loop.count == 2)
        status = halve_first(&loop);
    for (int i = 0; status == BATTEN_OK && i < loop.count; i++)
        status = close_corner(&loop.sides[i].curve, &loop.sides[(i + 1) % loop.count].curve);
    report->approximation *= loop.size;
    if (status != BATTEN_OK)
        bat_fill_loop_free(&loop);
    else
        *out = loop;
    return status;
}
