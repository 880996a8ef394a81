/* Knots of several curves that differ by less than anybody means. */
#include "shape/points/near_knots.h"
#include "support/test.h"

#include <batten/curve.h>

static batten_curve *cubic(int inner, const double *knots)
{
    double points[20][2], all[24] = {0};
    for (int i = 0; i < inner + 4; i++) {
        points[i][0] = i;
        points[i][1] = i % 3;
    }
    memcpy(all + 4, knots, (size_t)inner * sizeof *all);
    for (int i = 0; i < 4; i++)
        all[4 + inner + i] = 1;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, inner + 4, &points[0][0]}, 3, NULL, all,
                                 &curve));
    return curve;
}

static void check_inner(const batten_curve *curve, int inner, const double *knots)
{
    CHECK_INT(batten_curve_point_count(curve), inner + 4);
    for (int i = 0; i < inner; i++)
        CHECK_BITS(batten_curve_knots(curve)[4 + i], knots[i]);
}

TEST(knots_move_onto_near_ones_of_curves_before_and_a_bound_of_the_move_is_added_up)
{
    const double first[] = {0.25, 0.5}, second[] = {0.25 + 5e-10, 0.5 - 8e-10, 0.75};
    const double third[] = {0.25 + 2e-9, 0.75 - 9e-10}, moved[] = {0.25, 0.5, 0.75};
    const double partly[] = {0.25 + 2e-9, 0.75};
    batten_curve *curves[3] = {cubic(2, first), cubic(3, second), cubic(2, third)};
    batten_curve *given[3];
    for (int i = 0; i < 3; i++)
        given[i] = batten_curve_ref(curves[i]);
    double error = 1;
    CHECK_OK(bat_near_knots_join(1, 3, curves, 1e-6, &error));
    check_inner(curves[0], 2, first);
    check_inner(curves[1], 3, moved);
    check_inner(curves[2], 2, partly); /* 2e-9 is too far */
    double far[3] = {0};
    for (int c = 0; c < 3; c++)
        for (int i = 0; i <= 400; i++) {
            double p[2], q[2];
            CHECK_OK(batten_curve_evaluate(given[c], i / 400.0, 0, p));
            CHECK_OK(batten_curve_evaluate(curves[c], i / 400.0, 0, q));
            far[c] = fmax(far[c], hypot(p[0] - q[0], p[1] - q[1]));
        }
    CHECK(far[1] > 1e-10 && far[2] > 1e-10);
    CHECK(error - 1 >= 0.999 * (far[1] + far[2]));
    CHECK(error - 1 <= 1e-7); /* moves of 1e-9 at slopes below 20 */
    for (int i = 0; i < 3; i++) {
        batten_curve_unref(given[i]);
        batten_curve_unref(curves[i]);
    }
}

TEST(fixed_curves_keep_their_knots_however_near)
{
    const double first[] = {0.5}, second[] = {0.5 + 1e-10};
    batten_curve *curves[2] = {cubic(1, first), cubic(1, second)};
    double error = 0;
    CHECK_OK(bat_near_knots_join(2, 2, curves, 1, &error));
    check_inner(curves[1], 1, second);
    CHECK(error == 0);
    CHECK_OK(bat_near_knots_join(0, 2, curves, 1, &error));
    check_inner(curves[0], 1, first);
    check_inner(curves[1], 1, first);
    CHECK(error > 0);
    batten_curve_unref(curves[0]);
    batten_curve_unref(curves[1]);
}

TEST(a_knot_moves_with_its_multiplicity_to_the_nearer_of_two)
{
    const double first[] = {0.3, 0.3 + 1e-9, 0.7}, second[] = {0.3 + 4e-10, 0.3 + 4e-10, 0.7};
    const double third[] = {0.3 + 6e-10, 0.3 + 6e-10, 0.3 + 6e-10, 0.8};
    const double low[] = {0.3, 0.3, 0.7}, high[] = {0.3 + 1e-9, 0.3 + 1e-9, 0.3 + 1e-9, 0.8};
    batten_curve *curves[3] = {cubic(3, first), cubic(3, second), cubic(4, third)};
    double error = 0;
    CHECK_OK(bat_near_knots_join(1, 3, curves, 1e-3, &error));
    check_inner(curves[0], 3, first);
    check_inner(curves[1], 3, low);
    check_inner(curves[2], 4, high);
    for (int i = 0; i < 3; i++)
        batten_curve_unref(curves[i]);
}

TEST(no_two_knots_of_one_curve_come_together)
{
    const double first[] = {0.4}, second[] = {0.4 - 3e-10, 0.4 + 5e-10};
    const double moved[] = {0.4 - 3e-10, 0.4};
    const double third[] = {0.4, 0.4 + 2e-10}; /* the second is kept off by the first */
    batten_curve *curves[2] = {cubic(1, first), cubic(2, second)};
    double error = 0;
    CHECK_OK(bat_near_knots_join(1, 2, curves, 1e-3, &error));
    const double *made = batten_curve_knots(curves[1]) + 4;
    CHECK(made[0] < made[1] && made[1] < 1);
    CHECK(made[0] == 0.4 || made[1] == 0.4 || made[0] == moved[0]);
    batten_curve_unref(curves[1]);
    curves[1] = cubic(2, third);
    CHECK_OK(bat_near_knots_join(1, 2, curves, 1e-3, &error));
    check_inner(curves[1], 2, third);
    batten_curve_unref(curves[0]);
    batten_curve_unref(curves[1]);
}

TEST(a_curve_that_would_move_by_more_than_the_tolerance_keeps_its_knots)
{
    const double first[] = {0.5}, second[] = {0.5 + 5e-10}, third[] = {0.5 + 5e-10 + 2e-10};
    batten_curve *curves[3] = {cubic(1, first), cubic(1, second), cubic(1, third)};
    double error = 0;
    CHECK_OK(bat_near_knots_join(1, 2, curves, 1e-12, &error));
    check_inner(curves[1], 1, second);
    CHECK(error == 0);
    for (int i = 0; i < 3; i++)
        batten_curve_unref(curves[i]);
}
