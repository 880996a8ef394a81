#include "support/generate.h"

#include <batten/curve.h>

static const test_wish any = {0};

/* The same shape, where p r |P| is what one evaluation may err. */
static void check_same(test_random *random, const batten_curve *a, const batten_curve *b, double factor)
{
    const double size = test_curve_size(a);
    const int p = batten_curve_degree(a) + batten_curve_degree(b);
    for (int i = 0; i < 20; i++) {
        const double u = test_parameter(random, a);
        CHECK_NEAR(test_curve_distance(a, u, b, u, size), 0, factor * p * DBL_EPSILON);
    }
}

TEST(a_knot_inserted_moves_nothing)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(1000); i++) {
        batten_curve *curve = test_curve(&random, &any), *refined = NULL;
        const double u = test_parameter(&random, curve);
        const batten_status status = batten_curve_insert_knot(curve, u, 1, &refined);
        CHECK(status == BATTEN_OK || status == BATTEN_BAD_KNOTS || status == BATTEN_OUT_OF_MEMORY);
        if (status == BATTEN_OK) {
            CHECK_INT(batten_curve_point_count(refined), batten_curve_point_count(curve) + 1);
            check_same(&random, curve, refined, 8);
        }
        batten_curve_unref(refined);
        batten_curve_unref(curve);
    }
}

TEST(a_periodic_curve_stays_periodic_when_refined_and_elevated)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(500); i++) {
        batten_curve *curve = test_periodic_curve(&random, &any), *refined = NULL;
        const double u = test_parameter(&random, curve);
        const batten_status status = batten_curve_insert_knot(curve, u, 1, &refined);
        CHECK(status == BATTEN_OK || status == BATTEN_BAD_KNOTS || status == BATTEN_OUT_OF_MEMORY);
        if (status == BATTEN_OK) {
            CHECK(batten_curve_is_periodic(refined));
            CHECK_INT(batten_curve_point_count(refined), batten_curve_point_count(curve) + 1);
            check_same(&random, curve, refined, 16);
            batten_curve_unref(refined);
        }
        if (batten_curve_degree(curve) < 25) {
            CHECK_OK(batten_curve_elevate(curve, 1, &refined));
            CHECK(batten_curve_is_periodic(refined));
            check_same(&random, curve, refined, 16);
            batten_curve_unref(refined);
        }
        batten_curve_unref(curve);
    }
}

TEST(K5_the_clamped_form_is_the_same_curve)
{
    test_random random = test_random_begin(__func__);
    const test_wish unclamped = {.clamped = TEST_NEVER};
    for (int i = 0; i < test_cases(500); i++) {
        batten_curve *curve = i % 2 ? test_curve(&random, &unclamped) : test_periodic_curve(&random, &any);
        batten_curve *clamped = NULL;
        CHECK_OK(batten_curve_clamp(curve, &clamped));
        CHECK(batten_curve_is_clamped(clamped) && !batten_curve_is_periodic(clamped));
        CHECK_BITS(batten_curve_domain(clamped).a, batten_curve_domain(curve).a);
        CHECK_BITS(batten_curve_domain(clamped).b, batten_curve_domain(curve).b);
        check_same(&random, curve, clamped, 8);
        batten_curve_unref(clamped);
        batten_curve_unref(curve);
    }
}

TEST(an_elevated_curve_is_the_same_curve)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(500); i++) {
        batten_curve *curve = test_curve(&random, &any), *elevated = NULL;
        const int room = 25 - batten_curve_degree(curve), by = test_random_int(&random, 0, room < 3 ? room : 3);
        CHECK_OK(batten_curve_elevate(curve, by, &elevated));
        CHECK_INT(batten_curve_degree(elevated), batten_curve_degree(curve) + by);
        check_same(&random, curve, elevated, 8 + 8 * by);
        batten_curve_unref(elevated);
        batten_curve_unref(curve);
    }
}

TEST(both_parts_of_a_cut_are_the_curve)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(500); i++) {
        batten_curve *curve = i % 4 ? test_curve(&random, &any) : test_periodic_curve(&random, &any);
        const batten_interval domain = batten_curve_domain(curve);
        const double u = test_parameter(&random, curve);
        batten_curve *left = NULL, *right = NULL;
        if (u > domain.a && u < domain.b) {
            CHECK_OK(batten_curve_split(curve, u, &left, &right));
            CHECK_BITS(batten_curve_domain(left).b, u);
            CHECK_BITS(batten_curve_domain(right).a, u);
            const double size = test_curve_size(curve);
            const double most = 16 * batten_curve_degree(curve) * DBL_EPSILON;
            CHECK_NEAR(test_curve_distance(left, u, right, u, size), 0, 0);
            for (int k = 0; k < 20; k++) {
                const double v = test_parameter(&random, curve);
                CHECK_NEAR(test_curve_distance(v <= u ? left : right, v, curve, v, size), 0, most);
            }
        } else
            CHECK_STATUS(batten_curve_split(curve, u, &left, &right), BATTEN_OUT_OF_DOMAIN);
        batten_curve_unref(left);
        batten_curve_unref(right);
        batten_curve_unref(curve);
    }
}

TEST(bezier_pieces_are_the_curve)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(300); i++) {
        batten_curve *curve = i % 4 ? test_curve(&random, &any) : test_periodic_curve(&random, &any);
        batten_curve *bezier = NULL;
        CHECK_OK(batten_curve_to_bezier(curve, &bezier));
        const int p = batten_curve_degree(bezier), pieces = batten_curve_spans(curve, NULL) - 1;
        CHECK_INT(batten_curve_point_count(bezier), pieces * p + 1);
        check_same(&random, curve, bezier, 8);
        batten_curve_unref(bezier);
        batten_curve_unref(curve);
    }
}
