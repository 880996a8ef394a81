/* Curves within a tolerance of very many points. */
#include "support/test.h"
#include <batten/approximate.h>

enum { MANY = 6000, DIMENSION = 2 };

/* A wave with some noise, sampled a hundred times a unit; closed: on a ring. */
static double *wave(int count, bool closed, double noise)
{
    test_random random = test_random_begin("wave");
    double *q = test_array((size_t)(DIMENSION * count), sizeof *q);
    for (int i = 0; i < count; i++) {
        const double x = i * 0.01, y = sin(2.3 * x) + test_random_in(&random, -noise, noise);
        const double r = count * 0.01 / 6.283185307179586 + y,
                     turn = 6.283185307179586 * i / count;
        q[2 * i] = closed ? r * cos(turn) : x;
        q[2 * i + 1] = closed ? r * sin(turn) : y;
    }
    return q;
}

static batten_curve_within_report fit_wave(int count, bool closed, double noise,
                                           double tolerance, double *farthest)
{
    batten_curve_within_options options = batten_curve_within_defaults();
    batten_curve_within_report report = {.points = 0};
    batten_curve *curve = NULL;
    double *q = wave(count, closed, noise), *u = test_array((size_t)count, sizeof *u);
    options.tolerance = tolerance;
    options.closed = closed;
    CHECK_OK(batten_curve_within((batten_points){DIMENSION, count, q}, &options, u, &report,
                                 &curve));
    *farthest = 0;
    for (int i = 0; i < count; i++) {
        double at[DIMENSION];
        CHECK_OK(batten_curve_evaluate(curve, u[i], 0, at));
        *farthest = fmax(*farthest, hypot(at[0] - q[2 * i], at[1] - q[2 * i + 1]));
    }
    batten_curve_unref(curve);
    return report;
}

/* The fits do not grow with the points; a short row is searched knot by knot, by hundreds of fits, and a long one takes
 * no more than twice the control points of its parts. */
TEST(very_many_points_are_met_within_the_tolerance_by_few_fits_and_control_points)
{
    enum { PARTS = 16 };
    batten_curve_within_report reports[4];
    double farthest;
    for (int c = 0; c < 4; c++) {
        reports[c] = fit_wave(MANY, c % 2, c / 2 ? 2e-4 : 0, c / 2 ? 4e-4 : 1e-5, &farthest);
        CHECK(farthest <= (c / 2 ? 4e-4 : 1e-5));
    }
    CHECK(reports[0].fits <= 64);
    CHECK(fit_wave(4 * MANY, false, 0, 1e-5, &farthest).fits <= reports[0].fits + 16);
    CHECK(reports[2].points <=
          2 * PARTS * fit_wave(MANY / PARTS, false, 2e-4, 4e-4, &farthest).points);
}
