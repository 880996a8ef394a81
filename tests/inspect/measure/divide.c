#include "inspect/shapes.h"
#include <batten/measure.h>

#include "support/generate.h"

TEST(parts_of_equal_length_of_a_circle_are_equal_angles)
{
    batten_curve *circle = NULL;
    double u[13];
    CHECK_OK(shape_ellipse(3, 3, 0, 0, &circle));
    CHECK_OK(batten_curve_divide(circle, 12, 1e-11, u));
    for (int k = 0; k <= 12; k++) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(circle, u[k], 0, p));
        CHECK_NEAR(p[0], 3 * cos(PI * k / 6), 1e-10);
        CHECK_NEAR(p[1], 3 * sin(PI * k / 6), 1e-10);
    }
    CHECK_BITS(u[0], 0);
    CHECK_BITS(u[12], 1);
    batten_curve_unref(circle);
}

TEST(chords_stay_as_near_as_asked_and_are_not_many_more_than_needed)
{
    batten_curve *circle = NULL;
    batten_parameters cuts = {0, NULL};
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    CHECK_OK(batten_curve_divide_chord(circle, 1e-4, &cuts));
    /* a chord over the angle t is 1 - cos(t / 2) high */
    const double least = PI / acos(1 - 1e-4);
    CHECK(cuts.count - 1 >= least);
    CHECK(cuts.count - 1 <= 4 * least);
    for (int k = 1; k < cuts.count; k++) {
        double p[2], q[2];
        CHECK(cuts.at[k] > cuts.at[k - 1]);
        CHECK_OK(batten_curve_evaluate(circle, cuts.at[k - 1], 0, p));
        CHECK_OK(batten_curve_evaluate(circle, cuts.at[k], 0, q));
        CHECK(1 - hypot(p[0] + q[0], p[1] + q[1]) / 2 <= 1e-4);
    }
    batten_release(cuts.at);
    batten_curve_unref(circle);
}

TEST(chords_of_random_curves_are_near_all_along)
{
    test_random random = test_random_begin("chords");
    for (int n = test_cases(20); n > 0; n--) {
        double points[18];
        batten_curve *curve = NULL;
        batten_parameters cuts = {0, NULL};
        for (int i = 0; i < 18; i++)
            points[i] = test_random_in(&random, -1, 1);
        CHECK_OK(shape_bezier(3, 5, points, &curve));
        CHECK_OK(batten_curve_divide_chord(curve, 1e-3, &cuts));
        for (int k = 1; k < cuts.count; k++)
            for (int i = 1; i < 8; i++) {
                double p[3], a[3], b[3], along = 0, square = 0, far = 0;
                const double u = cuts.at[k - 1] + (cuts.at[k] - cuts.at[k - 1]) * i / 8;
                CHECK_OK(batten_curve_evaluate(curve, u, 0, p));
                CHECK_OK(batten_curve_evaluate(curve, cuts.at[k - 1], 0, a));
                CHECK_OK(batten_curve_evaluate(curve, cuts.at[k], 0, b));
                for (int j = 0; j < 3; j++) {
                    along += (p[j] - a[j]) * (b[j] - a[j]);
                    square += (b[j] - a[j]) * (b[j] - a[j]);
                }
                for (int j = 0; j < 3; j++)
                    far += pow(p[j] - a[j] - along / square * (b[j] - a[j]), 2);
                CHECK(sqrt(far) <= 1e-3);
            }
        batten_release(cuts.at);
        batten_curve_unref(curve);
    }
}

TEST(N6_counts_and_heights_that_mean_nothing_are_refused)
{
    batten_curve *circle = NULL;
    batten_parameters cuts = {7, NULL};
    double u[2];
    CHECK_OK(shape_ellipse(1, 1, 0, 0, &circle));
    CHECK_STATUS(batten_curve_divide(circle, 0, 1e-9, u), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide(circle, 1, NAN, u), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide_chord(circle, 0, &cuts), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide_chord(circle, NAN, &cuts), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide_chord(circle, 1e-14, &cuts), BATTEN_TOO_LARGE);
    CHECK_INT(cuts.count, 7);
    batten_curve_unref(circle);
}

TEST(between_parts_the_tangent_turns_by_no_more_than_the_angle)
{
    test_random random = test_random_begin("turns of parts");
    for (int n = test_cases(20); n > 0; n--) {
        const test_wish wish = {.dimension = 2 + n % 2, .degree = 1 + n % 5, .tame = true};
        batten_curve *curve = test_curve(&random, &wish);
        const double angle = test_random_in(&random, 0.05, 0.5);
        batten_parameters at = {0, NULL};
        CHECK_OK(batten_curve_divide_turn(curve, HUGE_VAL, angle, &at));
        for (int i = 0; i + 1 < at.count; i++) {
            batten_curve_local first, here;
            if (at.at[i + 1] - at.at[i] < 1e-12)
                continue; /* at a cusp */
            for (int k = 0; k <= 8; k++) {
                const double u = at.at[i] + (at.at[i + 1] - at.at[i]) * (k / 8.0);
                const batten_status status = batten_curve_local_at(
                    curve, u, k == 8 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &here);
                CHECK(status == BATTEN_OK || status == BATTEN_SINGULAR_HERE);
                if (k == 0)
                    first = here;
                const double cosine = first.tangent.x * here.tangent.x +
                                      first.tangent.y * here.tangent.y +
                                      first.tangent.z * here.tangent.z;
                CHECK(cosine >= cos(angle) - 1e-6);
            }
        }
        batten_release(at.at);
        batten_curve_unref(curve);
    }
}

TEST(a_circle_is_cut_by_its_angle_and_by_the_height_of_chords)
{
    batten_curve *circle = NULL;
    batten_parameters at = {0, NULL};
    CHECK_OK(shape_ellipse(2, 2, 0, 0, &circle));
    CHECK_OK(batten_curve_divide_turn(circle, HUGE_VAL, PI / 8 + 1e-9, &at));
    CHECK(at.count - 1 >= 16 && at.count - 1 <= 32);
    batten_release(at.at);
    CHECK_OK(batten_curve_divide_turn(circle, 1e-3, PI, &at));
    const int by_height = at.count;
    batten_release(at.at);
    CHECK_OK(batten_curve_divide_chord(circle, 1e-3, &at));
    CHECK_INT(at.count, by_height);
    batten_release(at.at);
    at = (batten_parameters){7, NULL};
    const double bad[] = {0, -1, 4, NAN};
    for (int i = 0; i < 4; i++)
        CHECK_STATUS(batten_curve_divide_turn(circle, 1, bad[i], &at), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_divide_turn(circle, NAN, 1, &at), BATTEN_BAD_ARGUMENT);
    CHECK_INT(at.count, 7);
    batten_curve_unref(circle);
}
