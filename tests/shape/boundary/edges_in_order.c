#include <batten/coons.h>
#include <batten/standard.h>

#include "support/faults.h"
#include "support/test.h"

static const double corners[5][2] = {{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 2}};

/* A side of a pentagon, bulged, from corner i to corner i + 1, or back. */
static batten_curve *side(int i, bool back, double shift)
{
    const double *a = corners[i % 5], *b = corners[(i + 1) % 5];
    const double knots[] = {0, 0, 0, 1, 1, 1};
    double points[6] = {a[0], a[1],        (a[0] + b[0]) / 2 + 0.1, (a[1] + b[1]) / 2 + 0.2,
                        b[0], b[1] + shift};
    for (int x = 0; back && x < 2; x++) {
        const double first = points[x];
        points[x] = points[4 + x];
        points[4 + x] = first;
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 2, NULL, knots, &curve));
    return curve;
}

static void release(int count, batten_curve **curves)
{
    for (int i = 0; i < count; i++)
        batten_curve_unref(curves[i]);
}

TEST(shuffled_and_reversed_sides_come_out_as_a_loop)
{
    test_random random = test_random_begin("loop");
    for (int c = 0; c < test_cases(50); c++) {
        int order[5] = {0, 1, 2, 3, 4};
        bool back[5];
        batten_curve *curves[5];
        batten_loop_place places[5];
        for (int i = 4; i > 0; i--) {
            const int j = test_random_int(&random, 0, i), kept = order[i];
            order[i] = order[j];
            order[j] = kept;
        }
        for (int i = 0; i < 5; i++) {
            back[i] = test_random_int(&random, 0, 1);
            curves[i] = side(order[i], back[i], 0);
        }
        CHECK_EACH_ALLOCATION(
            batten_curves_loop(5, (const batten_curve *const *)curves, 1e-9, places));
        CHECK(places[0].curve == 0 && !places[0].reversed);
        const int step = back[0] ? 4 : 1;
        for (int k = 0; k < 5; k++) {
            CHECK_INT(order[places[k].curve], (order[0] + k * step) % 5);
            CHECK_INT(places[k].reversed, back[places[k].curve] != back[0]);
            CHECK(places[k].gap == 0);
        }
        release(5, curves);
    }
}

TEST(two_curves_may_be_a_loop)
{
    const double knots[] = {0, 0, 0, 1, 1, 1};
    const double low[] = {0, 0, 1, -1, 2, 0}, high[] = {0, 0, 1, 1, 2, 1e-4};
    batten_curve *curves[2] = {NULL, NULL};
    batten_loop_place places[2];
    CHECK_OK(batten_curve_create((batten_points){2, 3, low}, 2, NULL, knots, &curves[0]));
    CHECK_OK(batten_curve_create((batten_points){2, 3, high}, 2, NULL, knots, &curves[1]));
    CHECK_EACH_ALLOCATION(
        batten_curves_loop(2, (const batten_curve *const *)curves, 1e-3, places));
    CHECK(places[1].curve == 1 && places[1].reversed);
    CHECK_NEAR(places[0].gap, 1e-4, 1e-15);
    CHECK(places[1].gap == 0);
    CHECK_STATUS(batten_curves_loop(2, (const batten_curve *const *)curves, 1e-5, places),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("corner 2, between curves 1 and 2, is open by 0.0001");
    release(2, curves);
}

TEST(a_gap_is_named_with_its_corner_and_curves)
{
    batten_curve *curves[5];
    batten_loop_place places[5];
    for (int i = 0; i < 5; i++)
        curves[i] = side(i, i == 3, i == 1 ? 0.12 : 0);
    CHECK_STATUS(batten_curves_loop(5, (const batten_curve *const *)curves, 0.1, places),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("corner 3, between curves 2 and 3, is open by 0.12");
    CHECK_OK(batten_curves_loop(5, (const batten_curve *const *)curves, 0.2, places));
    CHECK_NEAR(places[1].gap, 0.12, 1e-15);
    CHECK(places[3].reversed);
    release(5, curves);
}

TEST(sides_that_cannot_be_are_refused)
{
    batten_curve *curves[4];
    batten_loop_place places[4];
    for (int i = 0; i < 4; i++)
        curves[i] = side(i == 3 ? 1 : i, i == 3, 0);
    const batten_curve *const *given = (const batten_curve *const *)curves;
    CHECK_STATUS(batten_curves_loop(4, given, 1e-9, places), BATTEN_COINCIDENT);
    CHECK_MESSAGE("curves 2 and 4 are the same");
    CHECK_STATUS(batten_curves_loop(1, given, 1e-9, places), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curves_loop(3, given, -1, places), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curves_loop(3, given, NAN, places), BATTEN_BAD_ARGUMENT);
    batten_curve_unref(curves[2]);
    const double knots[] = {0, 0, 0, 1, 1, 1}, dot[] = {3, 3, 3, 3, 3, 3};
    const double ring[] = {0, 0, 1, 1, 0, 0}, line[] = {0, 1, 2};
    curves[2] = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, dot}, 2, NULL, knots, &curves[2]));
    CHECK_STATUS(batten_curves_loop(3, given, 1e-9, places), BATTEN_COINCIDENT);
    CHECK_MESSAGE("curve 3 has no length");
    batten_curve_unref(curves[2]);
    curves[2] = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, ring}, 2, NULL, knots, &curves[2]));
    CHECK_STATUS(batten_curves_loop(3, given, 1e-9, places), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("curve 3 is closed");
    batten_curve_unref(curves[2]);
    curves[2] = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 3, line}, 2, NULL, knots, &curves[2]));
    CHECK_STATUS(batten_curves_loop(3, given, 1e-9, places), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("dimensions");
    release(4, curves);
}

TEST(G7_boundaries_in_any_order_and_direction_make_a_loop_or_their_gap_is_named)
{
    batten_curve *curves[5];
    batten_loop_place places[5];
    static const int order[5] = {3, 1, 4, 0, 2};
    for (int i = 0; i < 5; i++)
        curves[i] = side(order[i], i % 2, order[i] == 4 ? 0.5 : 0);
    const batten_curve *const *given = (const batten_curve *const *)curves;
    CHECK_OK(batten_curves_loop(5, given, 0.6, places));
    CHECK_STATUS(batten_curves_loop(5, given, 0.4, places), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("corner 3, between curves 3 and 4, is open by 0.5");
    release(5, curves);
}

TEST(loops_of_one_curve_negative_tolerances_and_mixed_dimensions_are_refused)
{
    const double ends[6] = {0, 0, 0, 1, 0, 0};
    batten_curve *space = NULL, *plane = NULL;
    batten_loop_place places[2];
    CHECK_OK(batten_curve_line(3, ends, ends + 3, &space));
    CHECK_OK(batten_curve_line(2, ends, ends + 3, &plane));
    const batten_curve *mixed[2] = {space, plane};
    CHECK_STATUS(batten_curves_loop(1, mixed, 1e-6, places), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a loop has 2 curves or more, not 1");
    CHECK_STATUS(batten_curves_loop(2, mixed, -1, places), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is -1, below 0");
    CHECK_STATUS(batten_curves_loop(2, mixed, 1e-6, places), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("curves 1 and 2 have 3 and 2 dimensions");
    batten_curve_unref(space);
    batten_curve_unref(plane);
}
