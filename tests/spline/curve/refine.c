#include "support/generate.h"

#include <batten/curve.h>
#include <time.h>

static const test_wish any = {0};

/* The same shape, where p r |P| is what one evaluation may err. */
static void check_same(test_random *random, const batten_curve *a, const batten_curve *b,
                       double factor)
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
        CHECK(status == BATTEN_OK || status == BATTEN_BAD_KNOTS ||
              status == BATTEN_OUT_OF_MEMORY);
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
        CHECK(status == BATTEN_OK || status == BATTEN_BAD_KNOTS ||
              status == BATTEN_OUT_OF_MEMORY);
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
        batten_curve *curve =
            i % 2 ? test_curve(&random, &unclamped) : test_periodic_curve(&random, &any);
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
        const int room = 25 - batten_curve_degree(curve),
                  by = test_random_int(&random, 0, room < 3 ? room : 3);
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
        batten_curve *curve =
            i % 4 ? test_curve(&random, &any) : test_periodic_curve(&random, &any);
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
                CHECK_NEAR(test_curve_distance(v <= u ? left : right, v, curve, v, size), 0,
                           most);
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
        batten_curve *curve =
            i % 4 ? test_curve(&random, &any) : test_periodic_curve(&random, &any);
        batten_curve *bezier = NULL;
        CHECK_OK(batten_curve_to_bezier(curve, &bezier));
        const int p = batten_curve_degree(bezier), pieces = batten_curve_spans(curve, NULL) - 1;
        CHECK_INT(batten_curve_point_count(bezier), pieces * p + 1);
        check_same(&random, curve, bezier, 8);
        batten_curve_unref(bezier);
        batten_curve_unref(curve);
    }
}

static int count_knots(const batten_curve *curve, double u)
{
    int times = 0;
    for (int i = 0; i < batten_curve_knot_count(curve); i++)
        times += batten_curve_knots(curve)[i] == u;
    return times;
}

static batten_curve *quadratic(bool periodic)
{
    const double points[] = {0, 1, 3, 2, 5}, knots[] = {0, 0, 0, 1, 2, 3, 3, 3},
                 period[] = {0, 1, 2, 3, 4, 5};
    batten_curve *curve = NULL;
    if (periodic)
        CHECK_OK(batten_curve_create_periodic((batten_points){1, 5, points}, 2, NULL, period,
                                              &curve));
    else
        CHECK_OK(batten_curve_create((batten_points){1, 5, points}, 2, NULL, knots, &curve));
    return curve;
}

TEST(K4_K6_insertion_never_exceeds_the_degree)
{
    batten_curve *curve = quadratic(false), *none = NULL, *made = NULL;
    const double falling[] = {2, 1}, outside[] = {1, 4}, bad[] = {NAN},
                 twice[] = {0.5, 0.5, 2.5};
    CHECK_STATUS(batten_curve_insert_knot(curve, 1, 2, &none), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("would stand 3 times; 2 are allowed");
    CHECK_STATUS(batten_curve_insert_knot(curve, 0, 1, &none), BATTEN_BAD_KNOTS);
    CHECK_STATUS(batten_curve_insert_knot(curve, 1, 0, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_insert_knot(curve, 1, 4, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_insert_knot(curve, 7, 1, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_refine(curve, 2, falling, &none), BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_curve_refine(curve, 2, outside, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_refine(curve, 1, bad, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_refine(curve, 2147483647, twice, &none), BATTEN_TOO_LARGE);
    CHECK_OK(batten_curve_refine(curve, 3, twice, &made));
    CHECK_INT(batten_curve_point_count(made), 8);
    batten_curve_unref(made);
    batten_curve_unref(curve);
}

TEST(the_seam_of_a_periodic_curve_is_a_knot_like_others)
{
    batten_curve *curve = quadratic(true), *made = NULL, *none = NULL;
    const double seam[] = {0.5, 5};
    CHECK_OK(batten_curve_refine(curve, 2, seam, &made));
    CHECK_INT(batten_curve_point_count(made), 9);
    for (double u = 0; u <= 5; u += 0.125)
        CHECK_NEAR(test_curve_distance(curve, u, made, u, 1), 0, 1e-14);
    batten_curve_unref(made);
    CHECK_OK(batten_curve_insert_knot(curve, 5.5, 1, &made)); /* any u is reduced */
    CHECK_INT(count_knots(made, 0.5), 1);
    batten_curve_unref(made);
    const double thrice[] = {0, 5};
    CHECK_STATUS(batten_curve_refine(curve, 2, thrice, &none), BATTEN_BAD_KNOTS);
    batten_curve_unref(curve);
}

TEST(a_part_of_a_periodic_curve_may_cross_the_seam)
{
    batten_curve *curve = quadratic(true), *part = NULL, *none = NULL;
    CHECK_OK(batten_curve_subrange(curve, 4.5, 6.25, &part));
    CHECK(batten_curve_is_clamped(part));
    for (double u = 4.5; u <= 6.25; u += 0.125)
        CHECK_NEAR(test_curve_distance(curve, u, part, u, 1), 0, 1e-14);
    batten_curve_unref(part);
    CHECK_OK(batten_curve_subrange(curve, 1, 6, &part)); /* one whole period */
    CHECK_NEAR(test_curve_distance(part, 1, part, 6, 1), 0, 1e-14);
    batten_curve_unref(part);
    CHECK_STATUS(batten_curve_subrange(curve, 1, 7, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_subrange(curve, 2, 2, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_subrange(curve, 2, 1, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_subrange(curve, NAN, 1, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_split(curve, NAN, &part, &none), BATTEN_NOT_FINITE);
    batten_curve_unref(curve);
}

TEST(K9_elevation_stops_at_degree_25)
{
    batten_curve *curve = quadratic(false), *made = NULL, *none = NULL;
    CHECK_OK(batten_curve_elevate(curve, 23, &made));
    CHECK_INT(batten_curve_degree(made), 25);
    for (double u = 0; u <= 3; u += 0.125)
        CHECK_NEAR(test_curve_distance(curve, u, made, u, 1), 0, 1e-13);
    CHECK_STATUS(batten_curve_elevate(curve, 24, &none), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_elevate(curve, -1, &none), BATTEN_BAD_DEGREE);
    batten_curve_unref(made);
    batten_curve_unref(curve);
}

TEST(N2_rows_that_overflow_are_refused)
{
    const double points[] = {1e308, -1e308, 1e308}, knots[] = {0, 0, 0, 1, 1, 1},
                 weights[] = {1, 1.9, 1};
    batten_curve *curve = NULL, *none = NULL, *other = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 2, weights, knots, &curve));
    CHECK_STATUS(batten_curve_insert_knot(curve, 0.5, 1, &none), BATTEN_OVERFLOW);
    CHECK_STATUS(batten_curve_elevate(curve, 1, &none), BATTEN_OVERFLOW);
    CHECK_STATUS(batten_curve_split(curve, 0.5, &none, &other), BATTEN_OVERFLOW);
    CHECK_STATUS(batten_curve_to_bezier(curve, &none), BATTEN_OVERFLOW);
    CHECK(none == NULL && other == NULL);
    batten_curve_unref(curve);
}

TEST(cuts_and_parts_outside_the_domain_are_refused)
{
    const double points[] = {0, 1, 3}, knots[] = {0, 0, 0, 1, 1, 1};
    const struct {
        double u;
        batten_status status;
    } cuts[] = {{0, BATTEN_OUT_OF_DOMAIN},  {1, BATTEN_OUT_OF_DOMAIN},
                {-1, BATTEN_OUT_OF_DOMAIN}, {2, BATTEN_OUT_OF_DOMAIN},
                {NAN, BATTEN_NOT_FINITE},   {INFINITY, BATTEN_NOT_FINITE}};
    batten_curve *curve = NULL, *left = NULL, *right = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 2, NULL, knots, &curve));
    for (int i = 0; i < COUNT(cuts); i++)
        CHECK_STATUS(batten_curve_split(curve, cuts[i].u, &left, &right), cuts[i].status);
    CHECK_STATUS(batten_curve_subrange(curve, -1, 0.5, &left), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_subrange(curve, 0.5, 2, &left), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_subrange(curve, 0.5, NAN, &left), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_subrange(curve, NAN, 0.5, &left), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_subrange(curve, 0.5, 0.5, &left), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("is empty");
    CHECK(left == NULL && right == NULL);
    batten_curve_unref(curve);
}

/* ---- parts of long curves ---- */

enum { LONG = 100000, PARTS = 10000 };

/* A polygon of many corners, (i, i mod 2). */
static batten_curve *make_zigzag(void)
{
    batten_curve *zigzag = NULL;
    double *points = test_array(2 * LONG, sizeof *points);
    double *knots = test_array(LONG + 2, sizeof *knots);
    for (int i = 0; i < LONG; i++) {
        points[2 * i] = knots[i + 1] = i;
        points[2 * i + 1] = i % 2;
    }
    knots[0] = 0;
    knots[LONG + 1] = LONG - 1;
    CHECK_OK(batten_curve_create((batten_points){2, LONG, points}, 1, NULL, knots, &zigzag));
    return zigzag;
}

/* Copying the whole curve for each part takes 20 s. */
TEST(a_part_of_a_long_curve_costs_what_it_holds)
{
    batten_curve *zigzag = make_zigzag();
    const clock_t start = clock();
    for (int i = 0; i < PARTS; i++) {
        const int from = i * (LONG / PARTS) + 1;
        batten_curve *part = NULL;
        CHECK_OK(batten_curve_subrange(zigzag, from, from + 2.5, &part));
        CHECK_INT(batten_curve_point_count(part), 4);
        const double *points = batten_curve_points(part);
        for (int k = 0; k < 3; k++) {
            CHECK(points[2 * k] == from + k);
            CHECK(points[2 * k + 1] == (from + k) % 2);
        }
        CHECK(points[6] == from + 2.5 && points[7] == 0.5);
        batten_curve_unref(part);
    }
    CHECK((double)(clock() - start) / CLOCKS_PER_SEC < 4);
    batten_curve_unref(zigzag);
}
