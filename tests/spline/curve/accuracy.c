/* The bounds of evaluation and of the exact changes, measured in r = 2^-53 against sums in
 * higher precision. */
#include <batten/curve.h>

#include "support/generate.h"

#if defined(__SIZEOF_FLOAT128__) && !defined(__clang__)
__extension__ typedef __float128 wide;
#else
typedef long double wide;
#endif

static const double r = 0x1p-53;

typedef enum { UNIFORM, RANDOM, MULTIPLE, NEAR_EQUAL, GEOMETRIC, FAMILIES } family;

static double step_of(test_random *random, family kind, int i)
{
    switch (kind) {
    case UNIFORM:
        return 1;
    case RANDOM:
        return test_random_in(random, 0.05, 1);
    case MULTIPLE:
        return test_random_int(random, 0, 1);
    case NEAR_EQUAL:
        return test_random_int(random, 0, 1) ? 1e-12 : test_random_in(random, 0.5, 1);
    default:
        return ldexp(1e-9, i * 3 / 2);
    }
}

static batten_curve *curve_of(test_random *random, family kind, int p, bool rational)
{
    const int n = p + 1 + test_random_int(random, 0, 20);
    double knots[TEST_MOST_POINTS], points[TEST_MOST_POINTS], weights[TEST_MOST_POINTS];
    const bool clamped = test_random_int(random, 0, 2) > 0;
    for (int i = 0, times = 1; i <= n + p; i++) {
        const bool end = clamped && (i <= p || i > n);
        double step = i == 0 || end ? 0 : step_of(random, kind, i);
        if (step == 0 && !end && i > 0 && (times >= p || i == p + 1 || i == n))
            step = 1;
        knots[i] = (i ? knots[i - 1] : 0) + step;
        times = i > 0 && knots[i] > knots[i - 1] ? 1 : times + 1;
    }
    for (int i = 0; i < n; i++) {
        points[2 * i] = test_random_in(random, -1, 1);
        points[2 * i + 1] = test_random_in(random, -1, 1) + 1;
        weights[i] = test_random_in(random, 0.1, 10);
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, n, points}, p, rational ? weights : NULL,
                                 knots, &curve));
    return curve;
}

/* de Boor on (w x, w y, w) and its derivative, in wide. */
static void reference(const batten_curve *curve, double u, wide *point, wide *derivative)
{
    const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve);
    const double *U = batten_curve_knots(curve), *P = batten_curve_points(curve),
                 *W = batten_curve_weights(curve);
    int k = p;
    while (k + 1 < n && (U[k + 1] <= u || U[k] == U[k + 1]))
        k++;
    while (U[k] == U[k + 1])
        k--;
    wide rows[2][26][3];
    for (int j = 0; j <= p; j++) {
        const wide w = W ? W[k - p + j] : 1;
        for (int c = 0; c < 3; c++)
            rows[0][j][c] = c < 2 ? w * P[2 * (k - p + j) + c] : w;
    }
    for (int j = 0; j < p; j++)
        for (int c = 0; c < 3; c++)
            rows[1][j][c] = p * (rows[0][j + 1][c] - rows[0][j][c]) /
                            ((wide)U[k + 1 + j] - U[k + 1 + j - p]);
    for (int m = 0; m < 2; m++)
        for (int level = 1; level <= p - m; level++)
            for (int j = 0; j <= p - m - level; j++) {
                const wide left = U[k - p + m + level + j], right = U[k + 1 + j];
                const wide a = (u - left) / (right - left);
                for (int c = 0; c < 3; c++)
                    rows[m][j][c] += a * (rows[m][j + 1][c] - rows[m][j][c]);
            }
    for (int c = 0; c < 2; c++) {
        point[c] = rows[0][0][c] / rows[0][0][2];
        derivative[c] = (rows[1][0][c] - rows[1][0][2] * point[c]) / rows[0][0][2];
    }
}

/* The smallest span that bears on u. */
static double least_span(const batten_curve *curve, double u)
{
    const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve);
    const double *U = batten_curve_knots(curve);
    double least = 1e300;
    for (int i = 0; i < n + p; i++)
        if (U[i + 1] > U[i] && U[i] <= u && u <= U[i + 1])
            least = fmin(least, U[i + 1] - U[i]);
    return least;
}

static double error_of(const double *value, const wide *truth)
{
    const double x = (double)(value[0] - truth[0]), y = (double)(value[1] - truth[1]);
    return fmax(fabs(x), fabs(y));
}

static void measure(bool rational, double point_bound, double derivative_bound)
{
    test_random random = test_random_begin("accuracy");
    double worst = 0, worst_derivative = 0;
    for (int i = 0; i < test_cases(3000); i++) {
        const int p = test_random_int(&random, 0, 4) ? test_random_int(&random, 1, 5)
                                                     : test_random_int(&random, 1, 25);
        batten_curve *curve = curve_of(&random, (family)(i % FAMILIES), p, rational);
        const double size = test_curve_size(curve);
        for (int k = 0; k < 10; k++) {
            const double u = test_parameter(&random, curve),
                         D = 2 * p * size / least_span(curve, u);
            wide point[2], derivative[2];
            double out[4];
            CHECK_OK(batten_curve_evaluate(curve, u, 1, out));
            reference(curve, u, point, derivative);
            worst = fmax(worst, error_of(out, point) / (p * r * size));
            worst_derivative =
                fmax(worst_derivative, error_of(out + 2, derivative) / (p * r * D));
        }
        batten_curve_unref(curve);
    }
    CHECK_NEAR(worst, 0, point_bound);
    CHECK_NEAR(worst_derivative, 0, derivative_bound);
}

TEST(polynomial_points_keep_their_bound)
{
    measure(false, 8, 4);
}

TEST(rational_points_keep_their_bound)
{
    /* The quotient brings the ratio of the weights, 100, into the derivative: seen 39. */
    measure(true, 10, 100);
}

TEST(inserting_and_elevating_keep_their_bounds)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(1000); i++) {
        const int p = test_random_int(&random, 1, 5);
        batten_curve *curve = curve_of(&random, (family)(i % FAMILIES), p, false), *made = NULL;
        const batten_interval domain = batten_curve_domain(curve);
        const double u = domain.a + test_random_unit(&random) * (domain.b - domain.a),
                     size = test_curve_size(curve);
        CHECK_OK(batten_curve_insert_knot(curve, u, 1, &made));
        double sum = 0;
        for (int k = 0; k < 10; k++) {
            const double v = test_parameter(&random, curve);
            wide before[2], after[2], slope[2];
            reference(curve, v, before, slope);
            reference(made, v, after, slope);
            sum = fmax(sum, fmax(fabs((double)(before[0] - after[0])),
                                 fabs((double)(before[1] - after[1]))));
        }
        CHECK_NEAR(sum / (r * size), 0, 8);
        batten_curve_unref(made);
        CHECK_OK(batten_curve_elevate(curve, 1, &made));
        for (int k = 0; k < 10; k++) {
            const double v = test_parameter(&random, curve);
            wide before[2], after[2], slope[2];
            reference(curve, v, before, slope);
            reference(made, v, after, slope);
            sum = fmax(sum, fmax(fabs((double)(before[0] - after[0])),
                                 fabs((double)(before[1] - after[1]))));
        }
        CHECK_NEAR(sum / (r * size), 0, 8);
        batten_curve_unref(made);
        batten_curve_unref(curve);
    }
}
