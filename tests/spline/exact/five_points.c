/* Conics through five points: any size, any kind, in the order in which the points lie. */
#include <batten/standard.h>

#include "support/test.h"

/* Five points of an ellipse, a parabola or a branch of a hyperbola in their order. */
static void points_of_a_kind(test_random *random, int kind, double points[10])
{
    double at[5];
    at[0] = kind == 0 ? test_random_in(random, 0, 6) : test_random_in(random, -2, -1);
    for (int i = 1; i < 5; i++)
        at[i] = at[i - 1] + test_random_in(random, 0.3, kind == 0 ? 1.3 : 0.8);
    for (int i = 0; i < 5; i++) {
        const double x = kind == 0   ? 3 * cos(at[i])
                         : kind == 1 ? at[i]
                                     : sinh(at[i]),
                     y = kind == 0   ? sin(at[i])
                         : kind == 1 ? at[i] * at[i]
                                     : cosh(at[i]);
        points[2 * i] = x - 0.5 * y + 1;
        points[2 * i + 1] = 0.25 * x + y - 2;
    }
}

/* The largest distance of the given points from the curve, found by looking. */
static double miss_of(const batten_curve *curve, const double *points, bool *in_order)
{
    enum { LOOKS = 4000 };
    double worst = 0, before = -1;
    *in_order = true;
    for (int i = 0; i < 5; i++) {
        double least = HUGE_VAL, where = 0;
        for (int k = 0; k <= LOOKS; k++) {
            double at[2];
            CHECK_OK(batten_curve_evaluate(curve, (double)k / LOOKS, 0, at));
            const double off = hypot(at[0] - points[2 * i], at[1] - points[2 * i + 1]);
            where = off < least ? (double)k / LOOKS : where;
            least = fmin(least, off);
        }
        *in_order = *in_order && where > before;
        before = where;
        worst = fmax(worst, least);
    }
    return worst;
}

TEST(a_conic_of_any_kind_meets_its_five_points_in_their_order)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(12); c++) {
        double points[10], end[2];
        bool in_order = false;
        batten_curve *conic = NULL;
        points_of_a_kind(&random, c % 3, points);
        CHECK_OK(batten_curve_conic_five((batten_points){2, 5, points}, &conic));
        CHECK(miss_of(conic, points, &in_order) < 1e-2);
        CHECK(in_order);
        CHECK_OK(batten_curve_evaluate(conic, 0, 0, end));
        CHECK_NEAR(hypot(end[0] - points[0], end[1] - points[1]), 0, 1e-13);
        CHECK_OK(batten_curve_evaluate(conic, 1, 0, end));
        CHECK_NEAR(hypot(end[0] - points[8], end[1] - points[9]), 0, 1e-13);
        batten_curve_unref(conic);
    }
}

TEST(an_end_that_lies_between_other_points_is_refused)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(30); c++)
        for (int i = 0; i < 4; i += 3) {
            double points[10];
            batten_curve *none = NULL;
            points_of_a_kind(&random, c % 3, points);
            for (int k = 0; k < 2; k++) {
                const double swapped = points[2 * i + k];
                points[2 * i + k] = points[2 * i + 2 + k];
                points[2 * i + 2 + k] = swapped;
            }
            CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, points}, &none),
                         BATTEN_SINGULAR_SYSTEM);
            CHECK_MESSAGE("do not follow each other on one arc of a conic");
            CHECK(!none);
        }
}

TEST(N2_conics_through_five_points_are_alike_in_every_size)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(12); c++) {
        double points[10], scaled[10];
        batten_curve *conic = NULL, *other = NULL;
        points_of_a_kind(&random, c % 3, points);
        CHECK_OK(batten_curve_conic_five((batten_points){2, 5, points}, &conic));
        for (int k = -60; k <= 60; k += 60) {
            for (int i = 0; i < 10; i++)
                scaled[i] = ldexp(points[i], k);
            CHECK_OK(batten_curve_conic_five((batten_points){2, 5, scaled}, &other));
            CHECK_INT(batten_curve_point_count(other), batten_curve_point_count(conic));
            for (int i = 0; i < 2 * batten_curve_point_count(conic); i++)
                CHECK_NEAR(ldexp(batten_curve_points(other)[i], -k),
                           batten_curve_points(conic)[i], 1e-12 * (1 + fabs(points[0])));
            for (int i = 0; i < batten_curve_point_count(conic); i++)
                CHECK_NEAR(batten_curve_weights(other)[i], batten_curve_weights(conic)[i],
                           1e-12);
            batten_curve_unref(other);
        }
        batten_curve_unref(conic);
    }
}

TEST(a_conic_lies_in_space_as_well_and_in_no_more_dimensions)
{
    const double a[4] = {1, 0, 5, 9}, b[4] = {1, 1, 6, 9}, c[4] = {0, 1, 7, 9};
    for (int d = 1; d <= 3; d++) {
        batten_curve *conic = NULL;
        double at[3];
        CHECK_OK(batten_curve_conic(d, a, b, c, 0.5, &conic));
        /* the shoulder: (a + c + 2 w b) / (2 + 2 w) */
        CHECK_OK(batten_curve_evaluate(conic, 0.5, 0, at));
        for (int k = 0; k < d; k++)
            CHECK_NEAR(at[k], (a[k] + c[k] + b[k]) / 3, 1e-14);
        batten_curve_unref(conic);
    }
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_conic(4, a, b, c, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_conic(0, a, b, c, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK(!none);
}
