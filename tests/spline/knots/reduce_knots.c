#include <batten/interpolate.h>
#include <batten/standard.h>

#include "support/faults.h"
#include "support/generate.h"

static const test_wish tame = {.tame = true};

/* A function as a cubic with its values and slopes at equal steps. */
static batten_curve *cubic_of(double (*f)(double), double (*slope)(double), int count,
                              double length)
{
    double *u = test_array((size_t)count, sizeof *u),
           *values = test_array((size_t)count, 2 * sizeof *values);
    for (int i = 0; i < count; i++) {
        u[i] = length * i / (count - 1);
        values[2 * i] = f(u[i]);
        values[2 * i + 1] = slope(u[i]);
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_hermite(1, count, 2, u, values, &curve));
    return curve;
}

TEST(what_refining_added_goes_again)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(60); i++) {
        batten_curve *curve = test_curve(&random, &tame), *refined = NULL, *thin = NULL;
        const batten_interval domain = batten_curve_domain(curve);
        double knots[20];
        for (int k = 0; k < 20; k++)
            knots[k] = domain.a + (k + 0.37) / 20 * (domain.b - domain.a);
        int removed = -1;
        CHECK_OK(batten_curve_refine(curve, 20, knots, &refined));
        CHECK_OK(batten_curve_remove_knots(refined, 1e-7, &removed, NULL, &thin));
        CHECK(removed >= 20);
        CHECK(batten_curve_point_count(thin) <= batten_curve_point_count(curve));
        batten_curve_unref(thin);
        batten_curve_unref(refined);
        batten_curve_unref(curve);
    }
}

TEST(the_bound_of_a_reduction_holds_at_ten_thousand_places_and_both_ends_stay)
{
    batten_curve *curve = cubic_of(sin, cos, 200, 12);
    static const double tolerances[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};
    int before = 0;
    for (int i = 0; i < COUNT(tolerances); i++) {
        batten_curve *thin = NULL;
        double error = -1, largest = 0;
        CHECK_OK(batten_curve_remove_knots(curve, tolerances[i], NULL, &error, &thin));
        for (int k = 0; k <= 10000; k++) {
            double a, b;
            CHECK_OK(batten_curve_evaluate(curve, 12 * (k / 10000.0), 0, &a));
            CHECK_OK(batten_curve_evaluate(thin, 12 * (k / 10000.0), 0, &b));
            largest = fmax(largest, fabs(a - b));
        }
        CHECK(error <= tolerances[i]);
        CHECK(largest <= error + 1e-15);
        const int n = batten_curve_point_count(thin);
        CHECK(n >= before);
        before = n;
        CHECK_BITS(batten_curve_points(thin)[0], batten_curve_points(curve)[0]);
        CHECK_BITS(batten_curve_points(thin)[n - 1],
                   batten_curve_points(curve)[batten_curve_point_count(curve) - 1]);
        batten_curve_unref(thin);
    }
    batten_curve_unref(curve);
}

/* Cubics err by the fourth power of the step: a sixteenth of the tolerance takes twice the
 * spans, give or take what bisection misses. */
TEST(as_the_tolerance_shrinks_spans_grow_by_its_fourth_root)
{
    batten_curve *curve = cubic_of(sin, cos, 500, 40);
    double spans[3];
    for (int i = 0; i < 3; i++) {
        batten_curve *thin = NULL;
        CHECK_OK(batten_curve_remove_knots(curve, 1e-2 / pow(16, i), NULL, NULL, &thin));
        spans[i] = batten_curve_point_count(thin) - 3;
        batten_curve_unref(thin);
    }
    for (int i = 1; i < 3; i++)
        CHECK_NEAR(spans[i] / spans[i - 1], 2, 0.4);
    batten_curve_unref(curve);
}

TEST(with_tolerance_0_only_knots_go_that_move_nothing)
{
    /* All numbers are small integers, so the redundant knot 1 is met to the bit. */
    const double knots[] = {0, 0, 1, 2, 3, 3}, points[] = {0, 0, 1, 1, 2, 2, 4, 0};
    batten_curve *curve = NULL, *same = NULL;
    int removed = -1;
    double error = -1;
    CHECK_OK(batten_curve_create((batten_points){2, 4, points}, 1, NULL, knots, &curve));
    CHECK_OK(batten_curve_remove_knots(curve, 0, &removed, &error, &same));
    CHECK_INT(removed, 1);
    CHECK_BITS(error, 0);
    CHECK_NEAR(batten_curve_knots(same)[2], 2, 0);
    batten_curve_unref(same);
    batten_curve_unref(curve);
}

TEST(a_rational_circle_refined_and_reduced_stays_within_the_bound_and_rational)
{
    batten_curve *circle = NULL, *refined = NULL, *thin = NULL;
    double knots[100], error = -1;
    for (int i = 0; i < 100; i++)
        knots[i] = (i + 0.5) / 100;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(batten_curve_refine(circle, 100, knots, &refined));
    CHECK_OK(batten_curve_remove_knots(refined, 1e-9, NULL, &error, &thin));
    CHECK(batten_curve_point_count(thin) <= 9);
    CHECK(batten_curve_is_rational(thin));
    for (int k = 0; k <= 1000; k++) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(thin, k / 1000.0, 0, at));
        CHECK_NEAR(hypot(at[0], at[1]), 1, error + 1e-14);
    }
    CHECK(batten_curve_is_closed(thin, 1e-15));
    batten_curve_unref(thin);
    batten_curve_unref(refined);
    batten_curve_unref(circle);
}

/* Cubic splines through all points of aerofoils, of chord 1, within a ten-thousandth. Taken one
 * by one, knots would leave 121, 43 and more of them. */
TEST(published_aerofoils_shrink)
{
    static const struct {
        const char *file;
        int most; /* control points, of `of` */
        int of;
    } rows[] = {{"airfoils/s1223.dat", 45, 300},
                {"airfoils/naca0012_sharp.dat", 30, 153},
                {"airfoils/tp29-5.dat", 40, 260}};
    for (int r = 0; r < COUNT(rows); r++) {
        FILE *file = fopen(test_data(rows[r].file), "r");
        CHECK(file != NULL);
        char line[200];
        double *q = test_array(600, sizeof *q), error = -1;
        int n = 0;
        while (n < 300 && fgets(line, sizeof line, file))
            n += sscanf(line, "%lf %lf", &q[2 * n], &q[2 * n + 1]) == 2;
        fclose(file);
        CHECK_INT(n, rows[r].of);
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.parameters = BATTEN_CENTRIPETAL;
        batten_curve *curve = NULL, *thin = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){2, n, q}, &options, NULL, &curve));
        CHECK_OK(batten_curve_remove_knots(curve, 1e-4, NULL, &error, &thin));
        CHECK(error <= 1e-4);
        CHECK(batten_curve_point_count(thin) <= rows[r].most);
        batten_curve_unref(thin);
        batten_curve_unref(curve);
    }
}

TEST(a_reduction_reports_every_lack_of_memory)
{
    batten_curve *curve = cubic_of(sin, cos, 30, 6), *thin = NULL;
    int removed;
    double error;
    CHECK_EACH_ALLOCATION(batten_curve_remove_knots(curve, 1e-3, &removed, &error, &thin));
    CHECK(removed > 0 && error <= 1e-3);
    batten_curve_unref(thin);
    CHECK_EACH_ALLOCATION(batten_curve_remove_knots(curve, 0, &removed, &error, &thin));
    CHECK(error == 0);
    batten_curve_unref(thin);
    batten_curve_unref(curve);
}
