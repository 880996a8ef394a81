/* Four sides from boundary curves in any order and direction. */
#include "base/plural.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/coons.h>
#include <batten/measure.h>

/* The part of the loop that is one side: curves first .. first + count - 1. */
typedef struct {
    int first, count;
    bool against; /* the side runs against the loop */
} side_place;

/* The curve in the direction of its side, over [0, length]. */
static batten_status orient(const batten_curve *curve, bool reversed, bool by_length,
                            batten_curve **out)
{
    const batten_box box = batten_curve_box(curve);
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    batten_curve *open = NULL, *turned = NULL;
    double length = 1;
    batten_status status = batten_curve_clamp(curve, &open);
    if (status == BATTEN_OK && reversed)
        status = batten_curve_reverse(open, &turned);
    else if (status == BATTEN_OK)
        turned = batten_curve_ref(open);
    if (status == BATTEN_OK && by_length)
        status = batten_curve_length(turned, BAT_MEANT_SAME * size, NULL, &length);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(turned, 0, length, out);
    batten_curve_unref(turned);
    batten_curve_unref(open);
    return status;
}

/* A side that is a point, as a line without length. */
static batten_status make_pole(const batten_curve *const *curves,
                               const batten_loop_place *before, batten_curve **out)
{
    static const double knots[] = {0, 0, 1, 1};
    const batten_curve *curve = curves[before->curve];
    const batten_interval domain = batten_curve_domain(curve);
    const int d = curve->dimension;
    double points[6];
    const batten_status status =
        batten_curve_evaluate(curve, before->reversed ? domain.a : domain.b, 0, points);
    if (status != BATTEN_OK)
        return status;
    for (int x = 0; x < d; x++)
        points[d + x] = points[x];
    return batten_curve_create((batten_points){d, 2, points}, 1, NULL, knots, out);
}

static batten_status make_side(const batten_curve *const *curves,
                               const batten_loop_place *places, const side_place *side,
                               double tolerance, batten_curve **out)
{
    batten_curve *whole = NULL;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < side->count; k++) {
        const batten_loop_place *place =
            &places[side->first + (side->against ? side->count - 1 - k : k)];
        batten_curve *next = NULL, *joined = NULL;
        status = orient(curves[place->curve], place->reversed != side->against, side->count > 1,
                        &next);
        if (status == BATTEN_OK && whole)
            status = batten_curve_join(whole, next, tolerance, &joined);
        else if (status == BATTEN_OK)
            joined = batten_curve_ref(next);
        batten_curve_unref(next);
        batten_curve_unref(whole);
        whole = joined;
    }
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(whole, 0, 1, out);
    batten_curve_unref(whole);
    return status;
}

static batten_status check_counts(int count, const int *counts)
{
    int sum = 0;
    for (int s = 0; s < 4; s++) {
        if (counts[s] < 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "a side has %d curve%s", counts[s],
                            bat_plural(counts[s]));
        sum += counts[s];
    }
    if (counts[0] < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the first side has no curve");
    if (sum != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the sides have %d + %d + %d + %d curves of %d",
                        counts[0], counts[1], counts[2], counts[3], count);
    return BATTEN_OK;
}

/* How many curves each side has when nobody says so. */
static const int *usual_counts(int count)
{
    static const int counts[3][4] = {{1, 0, 1, 0}, {1, 1, 1, 0}, {1, 1, 1, 1}};
    return count >= 2 && count <= 4 ? counts[count - 2] : NULL;
}

static batten_status make_sides(int count, const batten_curve *const *curves, const int *counts,
                                double tolerance, const batten_loop_place *places,
                                batten_curve **sides)
{
    batten_status status = BATTEN_OK;
    for (int s = 0, first = 0; status == BATTEN_OK && s < 4; first += counts[s], s++) {
        const side_place side = {first, counts[s], s >= 2};
        status = counts[s] > 0
                     ? make_side(curves, places, &side, tolerance, &sides[s])
                     : make_pole(curves, &places[(first + count - 1) % count], &sides[s]);
    }
    return status;
}

batten_status batten_boundary_sides(int count, const batten_curve *const *curves,
                                    const int *counts, double tolerance,
                                    batten_loop_place *places, batten_curve **sides)
{
    assert(curves && sides);
    const int *parts = counts ? counts : usual_counts(count);
    if (!parts)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d curve%s %s four sides only when the number on each side is given",
                        count, bat_plural(count), bat_one_or_many(count, "makes", "make"));
    batten_curve *made[4] = {NULL, NULL, NULL, NULL};
    batten_loop_place *found = bat_array((size_t)bat_max_int(count, 1), sizeof *found);
    batten_status status = found ? check_counts(count, parts) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curves_loop(count, curves, tolerance, found);
    if (status == BATTEN_OK)
        status = make_sides(count, curves, parts, tolerance, found, made);
    for (int s = 0; s < 4; s++) {
        if (status == BATTEN_OK)
            sides[s] = made[s];
        else
            batten_curve_unref(made[s]);
    }
    for (int i = 0; status == BATTEN_OK && places && i < count; i++)
        places[i] = found[i];
    bat_release(found);
    return status;
}
