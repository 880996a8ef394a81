/* Properties that the theory of B-splines promises, on random curves. */
#include <batten/curve.h>

#include "support/generate.h"

#include <complex.h>

/* ---- derivatives against the complex step ---- */

/* de Boor's algorithm for an argument that is not real: row by row in the order of [dB]. */
static double complex de_boor(int p, const double *knots, int span, double complex u,
                              double complex *rows)
{
    for (int r = 1; r <= p; r++)
        for (int j = p; j >= r; j--) {
            const double left = knots[span - p + j], right = knots[span + 1 + j - r];
            const double complex alpha = (u - left) / (right - left);
            rows[j] = (1 - alpha) * rows[j - 1] + alpha * rows[j];
        }
    return rows[p];
}

static double complex_step(const batten_curve *curve, double u)
{
    enum { MOST = BATTEN_MAX_DEGREE + 1 };
    const int p = batten_curve_degree(curve);
    const double *knots = batten_curve_knots(curve), *w = batten_curve_weights(curve),
                 h = 1e-30;
    const double *points = batten_curve_points(curve);
    double complex above[MOST], below[MOST];
    int span = p;
    while (span < batten_curve_point_count(curve) - 1 && knots[span + 1] <= u)
        span++;
    for (int j = 0; j <= p; j++) {
        below[j] = w ? w[span - p + j] : 1;
        above[j] = below[j] * points[span - p + j];
    }
    const double complex at = u + h * I;
    return cimag(de_boor(p, knots, span, at, above) / de_boor(p, knots, span, at, below)) / h;
}

TEST(derivatives_are_those_of_the_complex_step)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(300); i++) {
        const test_wish wish = {.dimension = 1, .degree = 1 + i % 8, .tame = true};
        batten_curve *curve = test_curve(&random, &wish);
        const batten_interval domain = batten_curve_domain(curve);
        for (int k = 0; k < 20; k++) {
            const double u = domain.a + (domain.b - domain.a) * test_random_unit(&random);
            double out[2];
            CHECK_OK(batten_curve_evaluate(curve, u, 1, out));
            const double expected = complex_step(curve, u),
                         scale = fmax(fabs(expected), test_curve_size(curve));
            CHECK_NEAR(out[1] / scale, expected / scale, 1e-11);
        }
        batten_curve_unref(curve);
    }
}

/* ---- the operator of Schoenberg ---- */

static double square(double x)
{
    return x * x;
}

static double hinge(double x)
{
    return fabs(x - 0.3);
}

/* The spline with f at the Greville abscissae for control points. */
static batten_curve *schoenberg(test_random *random, double (*f)(double))
{
    const test_wish wish = {.dimension = 1,
                            .degree = test_random_int(random, 1, 6),
                            .tame = true,
                            .rational = TEST_NEVER,
                            .clamped = TEST_ALWAYS};
    batten_curve *curve = test_curve(random, &wish), *made = NULL;
    const int n = batten_curve_point_count(curve);
    double points[TEST_MOST_POINTS];
    for (int i = 0; i < n; i++)
        points[i] = f(batten_curve_greville(curve, i));
    CHECK_OK(batten_curve_create((batten_points){1, n, points}, wish.degree, NULL,
                                 batten_curve_knots(curve), &made));
    batten_curve_unref(curve);
    return made;
}

TEST(the_schoenberg_operator_of_a_convex_function_is_convex_and_above_it)
{
    double (*const functions[])(double) = {exp, square, hinge, fabs};
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(100); i++) {
        double (*const f)(double) = functions[i % COUNT(functions)];
        batten_curve *curve = schoenberg(&random, f);
        const batten_interval domain = batten_curve_domain(curve);
        const double size = test_curve_size(curve), length = domain.b - domain.a;
        double slope = -HUGE_VAL;
        for (int k = 0; k <= 200; k++) {
            const double u = fmin(domain.a + length * k / 200, domain.b);
            double out[2];
            CHECK_OK(batten_curve_evaluate(curve, u, 1, out));
            CHECK(out[0] >= f(u) - 1e-13 * size);
            CHECK(out[1] >= slope - 1e-9 * size / length);
            slope = out[1];
        }
        batten_curve_unref(curve);
    }
}

/* ---- control polygons ---- */

static batten_curve *halved(const batten_curve *curve)
{
    double knots[2000];
    batten_curve *fine = NULL;
    const int spans = batten_curve_spans(curve, NULL) - 1;
    CHECK(spans < COUNT(knots));
    batten_curve_spans(curve, knots);
    for (int i = 0; i < spans; i++)
        knots[i] = 0.5 * (knots[i] + knots[i + 1]);
    CHECK_OK(batten_curve_refine(curve, spans, knots, &fine));
    return fine;
}

/* How far the control points are from the curve at their Greville abscissae. */
static double polygon_distance(const batten_curve *curve)
{
    double largest = 0;
    for (int i = 0; i < batten_curve_point_count(curve); i++) {
        double p[2];
        const double *q = batten_curve_points(curve) + 2 * (size_t)i;
        CHECK_OK(batten_curve_evaluate(curve, batten_curve_greville(curve, i), 0, p));
        largest = fmax(largest, hypot(p[0] - q[0], p[1] - q[1]));
    }
    return largest;
}

TEST(each_halving_of_the_spans_brings_the_polygon_four_times_nearer)
{
    test_random random = test_random_begin(__func__);
    for (int degree = 2; degree <= 5; degree++) {
        double points[2 * 9], knots[10], before = 0, ratio = 0;
        batten_curve *curve = NULL;
        for (int i = 0; i < COUNT(points); i++)
            points[i] = test_random_in(&random, -1, 1);
        for (int i = 0; i < COUNT(knots); i++)
            knots[i] = i;
        /* Periodic, for at a clamped end the ratio is 1/4 only in the limit. */
        CHECK_OK(batten_curve_create_periodic((batten_points){2, 9, points}, degree, NULL,
                                              knots, &curve));
        for (int halving = 0; halving <= 6; halving++) {
            const double distance = polygon_distance(curve);
            ratio = halving ? distance / before : 1;
            before = distance;
            if (halving < 6) {
                batten_curve *fine = halved(curve);
                batten_curve_unref(curve);
                curve = fine;
            }
        }
        CHECK_NEAR(ratio, 0.25, 0.01);
        batten_curve_unref(curve);
    }
}

typedef struct {
    double last;
    int count;
} changes;

static void see(changes *seen, double value, double nothing)
{
    if (fabs(value) <= nothing)
        return;
    seen->count += seen->last * value < 0;
    seen->last = value > 0 ? 1 : -1;
}

TEST(no_line_crosses_a_curve_more_often_than_its_polygon)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(300); i++) {
        const test_wish wish = {.dimension = 2, .tame = true};
        batten_curve *curve = test_curve(&random, &wish);
        const batten_interval domain = batten_curve_domain(curve);
        const double size = test_curve_size(curve), angle = test_random_in(&random, 0, 6.3);
        const double x = cos(angle), y = sin(angle),
                     offset = test_random_in(&random, -0.7, 0.7) * size;
        const double *P = batten_curve_points(curve);
        changes polygon = {0, 0}, line = {0, 0};
        for (int k = 0; k < batten_curve_point_count(curve); k++)
            see(&polygon, x * P[2 * k] + y * P[2 * k + 1] - offset, 0);
        for (int k = 0; k <= 500; k++) {
            double p[2];
            CHECK_OK(batten_curve_evaluate(
                curve, fmin(domain.a + (domain.b - domain.a) * k / 500, domain.b), 0, p));
            see(&line, x * p[0] + y * p[1] - offset, 1e-12 * size);
        }
        CHECK(line.count <= polygon.count);
        batten_curve_unref(curve);
    }
}
