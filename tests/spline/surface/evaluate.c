#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"

/* z = x^2 y on [0, 2] x [0, 3]: one patch of degrees 2 and 1. */
static batten_status parabola(batten_surface **out)
{
    static const double u[] = {0, 0, 0, 2, 2, 2}, v[] = {0, 0, 3, 3};
    static const double points[] = {0, 0, 0, 0, 3, 0, 1, 0, 0, 1, 3, 0, 2, 0, 0, 2, 3, 12};
    const batten_axis axes[2] = {{2, 3, u, false}, {1, 2, v, false}};
    return batten_surface_create(3, &axes[0], &axes[1], points, NULL, out);
}

TEST(a_polynomial_patch_is_its_polynomial)
{
    batten_surface *surface = NULL;
    CHECK_OK(parabola(&surface));
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++) {
            const double x = i / 4.0, y = 3 * j / 8.0;
            double out[BATTEN_SURFACE_DERIVATIVES(3)][3];
            CHECK_OK(batten_surface_evaluate(surface, x, y, 3, out[0]));
            const double expected[][3] = {{x, y, x * x * y}, {1, 0, 2 * x * y}, {0, 1, x * x},
                                          {0, 0, 2 * y},     {0, 0, 2 * x},     {0, 0, 0},
                                          {0, 0, 0},         {0, 0, 2},         {0, 0, 0},
                                          {0, 0, 0}};
            for (int k = 0; k < COUNT(expected); k++)
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(out[k][c], expected[k][c], 1e-14);
        }
    batten_surface_unref(surface);
}

TEST(K10_derivatives_above_the_degree_are_exactly_0)
{
    batten_surface *surface = NULL;
    CHECK_OK(parabola(&surface));
    double out[BATTEN_SURFACE_DERIVATIVES(6)][3];
    CHECK_OK(batten_surface_evaluate(surface, 0.3, 0.7, 6, out[0]));
    for (int n = 0; n <= 6; n++)
        for (int l = 0; l <= n; l++)
            for (int c = 0; c < 3 && (n - l > 2 || l > 1); c++)
                CHECK_BITS(out[BATTEN_SURFACE_DERIVATIVE(n - l, l)][c], 0);
    batten_surface_unref(surface);
}

/* reliability, section 5: 8 p r |P| for a point; D^k times 4 p r more for derivatives. */
static void check_definition(const batten_surface *surface, double u, double v)
{
    const int p = batten_surface_degree(surface, BATTEN_U),
              q = batten_surface_degree(surface, BATTEN_V);
    const int d = batten_surface_dimension(surface);
    const double r = DBL_EPSILON / 2, largest = largest_coordinate(surface);
    double rate[2] = {0, 0}, out[BATTEN_SURFACE_DERIVATIVES(2)][3];
    for (int k = 0; k < 2; k++) {
        double knots[128];
        const int count = batten_surface_spans(surface, (batten_direction)k, knots);
        for (int i = 1; i < count; i++)
            rate[k] = fmax(rate[k], 2 * (k ? q : p) / (knots[i] - knots[i - 1]));
    }
    const bool rational = batten_surface_is_rational(surface);
    CHECK_OK(batten_surface_evaluate(surface, u, v, 2, out[0]));
    double packed[BATTEN_SURFACE_DERIVATIVES(2) * 3];
    CHECK_OK(batten_surface_evaluate(surface, u, v, 2, packed));
    long double a[6][4];
    for (int n = 0; n <= 2; n++)
        for (int l = 0; l <= n; l++)
            define_surface(surface, u, v, n - l, l, a[BATTEN_SURFACE_DERIVATIVE(n - l, l)]);
    for (int n = 0; n <= (rational ? 1 : 2); n++)
        for (int l = 0; l <= n; l++)
            for (int c = 0; c < d; c++) {
                const int at = BATTEN_SURFACE_DERIVATIVE(n - l, l);
                const long double point = a[0][c] / a[0][3];
                const long double exact = n == 0     ? point
                                          : rational ? (a[at][c] - a[at][3] * point) / a[0][3]
                                                     : a[at][c];
                const double bound = (p + q) * r * largest * (rational ? 10 : 8);
                CHECK_NEAR(packed[at * d + c], (double)exact,
                           bound * pow(rational ? 8 : 1, n) * pow(rate[0], n - l) *
                               pow(rate[1], l));
            }
}

TEST(points_and_derivatives_are_those_of_the_definition)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(300); c++) {
        surface_data data;
        surface_data_random(&random, c % 10 ? 5 : 25, &data);
        batten_surface *surface = NULL;
        CHECK_OK(surface_data_create(&data, &surface));
        for (int i = 0; i < 4; i++)
            check_definition(surface, random_parameter(&random, surface, BATTEN_U),
                             random_parameter(&random, surface, BATTEN_V));
        batten_surface_unref(surface);
    }
}

/* w S = A: the rule of Leibniz in all orders, with S from the surface and A, w by definition.
 */
TEST(rational_derivatives_obey_leibniz)
{
    static const double choose[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(50); c++) {
        surface_data data;
        surface_data_random(&random, 4, &data);
        data.rational = true;
        batten_surface *surface = NULL;
        CHECK_OK(surface_data_create(&data, &surface));
        const double u = random_parameter(&random, surface, BATTEN_U),
                     v = random_parameter(&random, surface, BATTEN_V);
        const int d = data.dimension;
        double S[BATTEN_SURFACE_DERIVATIVES(5) * 3];
        CHECK_OK(batten_surface_evaluate(surface, u, v, 5, S));
        for (int k = 0; k <= 3; k++)
            for (int l = 0; k + l <= 3; l++) {
                long double a[4], sum[3] = {0}, size = 1e-300L;
                define_surface(surface, u, v, k, l, a);
                for (int i = 0; i <= k; i++)
                    for (int j = 0; j <= l; j++) {
                        long double w[4];
                        define_surface(surface, u, v, i, j, w);
                        for (int x = 0; x < d; x++) {
                            const long double term =
                                choose[k][i] * choose[l][j] * w[3] *
                                S[BATTEN_SURFACE_DERIVATIVE(k - i, l - j) * d + x];
                            sum[x] += term;
                            size = fmaxl(size, fabsl(term));
                        }
                    }
                for (int x = 0; x < d; x++)
                    CHECK_NEAR((double)(sum[x] / size), (double)(a[x] / size), 1e-9);
            }
        batten_surface_unref(surface);
    }
}

TEST(many_points_have_the_bits_of_single_ones)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(40); c++) {
        surface_data data;
        surface_data_random(&random, c % 2 ? 3 : 7, &data);
        batten_surface *surface = NULL;
        CHECK_OK(surface_data_create(&data, &surface));
        enum { POINTS = 50 };
        const int order = c % 5, size = BATTEN_SURFACE_DERIVATIVES(order) * data.dimension;
        double uv[2 * POINTS], one[BATTEN_SURFACE_DERIVATIVES(4) * 3];
        double *many = test_array((size_t)POINTS * size, sizeof *many);
        for (int i = 0; i < 2 * POINTS; i++)
            uv[i] = random_parameter(&random, surface, i % 2 ? BATTEN_V : BATTEN_U);
        CHECK_OK(batten_surface_evaluate_many(surface, POINTS, uv, order, NULL, many));
        for (int i = 0; i < POINTS; i++) {
            CHECK_OK(batten_surface_evaluate(surface, uv[2 * i], uv[2 * i + 1], order, one));
            for (int k = 0; k < size; k++)
                CHECK_BITS(many[i * size + k], one[k]);
        }
        batten_surface_unref(surface);
    }
}

TEST(N7_many_points_with_one_outside_write_nothing)
{
    batten_surface *surface = NULL;
    CHECK_OK(parabola(&surface));
    double uv[] = {0, 0, nextafter(2, 3), 3, 1, 3.5}, out[9] = {7};
    CHECK_STATUS(batten_surface_evaluate_many(surface, 3, uv, 0, NULL, out),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("point 3: v");
    CHECK(out[0] == 7);
    CHECK_OK(batten_surface_evaluate_many(surface, 2, uv, 0, NULL, out));
    CHECK_BITS(out[3], 2);
    uv[0] = NAN;
    CHECK_STATUS(batten_surface_evaluate_many(surface, 2, uv, 0, NULL, out), BATTEN_NOT_FINITE);
    CHECK_OK(batten_surface_evaluate_many(surface, 0, NULL, 0, NULL, NULL));
    batten_surface_unref(surface);
}

TEST(N1_a_parameter_that_is_not_finite_is_refused)
{
    batten_surface *surface = NULL;
    CHECK_OK(parabola(&surface));
    double out[3] = {7};
    CHECK_STATUS(batten_surface_evaluate(surface, NAN, 1, 0, out), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_evaluate(surface, 1, INFINITY, 0, out), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_evaluate(surface, 1, 3.1, 0, out), BATTEN_OUT_OF_DOMAIN);
    CHECK(out[0] == 7);
    batten_surface_unref(surface);
}

static batten_status crease(double height, batten_surface **out)
{
    static const double u[] = {0, 0, 1, 2, 2}, v[] = {0, 0, 1, 1};
    const double points[] = {0, 0, height, height, -height, -height};
    const batten_axis axes[2] = {{1, 3, u, false}, {1, 2, v, false}};
    return batten_surface_create(1, &axes[0], &axes[1], points, NULL, out);
}

TEST(at_a_crease_the_side_is_the_one_asked_for)
{
    batten_surface *surface = NULL;
    CHECK_OK(crease(1, &surface));
    double out[3];
    CHECK_OK(batten_surface_evaluate(surface, 1, 0.5, 1, out));
    CHECK_BITS(out[1], -2);
    CHECK_OK(batten_surface_evaluate_side(
        surface, 1, 0.5, (batten_sides){BATTEN_FROM_LEFT, BATTEN_FROM_LEFT}, 1, out));
    CHECK_BITS(out[1], 1);
    CHECK_OK(batten_surface_evaluate_side(
        surface, 0, 0.5, (batten_sides){BATTEN_FROM_LEFT, BATTEN_FROM_LEFT}, 1, out));
    CHECK_BITS(out[1], 1);
    batten_surface_unref(surface);
}

TEST(N2_an_overflow_is_a_status)
{
    batten_surface *surface = NULL;
    CHECK_OK(crease(1.5e308, &surface));
    double out[30] = {7};
    const double uv[] = {1.5, 0.5};
    CHECK_OK(batten_surface_evaluate(surface, 1.5, 0.5, 0, out));
    CHECK_BITS(out[0], 0);
    CHECK_STATUS(batten_surface_evaluate(surface, 1.5, 0.5, 1, out), BATTEN_OVERFLOW);
    CHECK_BITS(out[0], 0);
    CHECK_STATUS(batten_surface_evaluate(surface, 1.5, 0.5, 5, out), BATTEN_OVERFLOW);
    CHECK_BITS(out[0], 0);
    CHECK_STATUS(batten_surface_evaluate_many(surface, 1, uv, 1, NULL, out), BATTEN_OVERFLOW);
    batten_surface_unref(surface);
}

TEST(K8_weights_of_any_size_give_the_same_surface)
{
    test_random random = test_random_begin(__func__);
    surface_data data;
    do
        surface_data_random(&random, 3, &data);
    while (!data.rational);
    batten_surface *surface = NULL, *scaled = NULL;
    CHECK_OK(surface_data_create(&data, &surface));
    const int total = data.axes[0].point_count * data.axes[1].point_count;
    const double scales[] = {0x1p-1000, 0x1p1000, 0x1p-1060};
    for (int s = 0; s < COUNT(scales); s++) {
        double *weights = test_array((size_t)total, sizeof *weights);
        for (int i = 0; i < total; i++)
            weights[i] = data.weights[i] * scales[s];
        CHECK_OK(batten_surface_create(data.dimension, &data.axes[0], &data.axes[1],
                                       data.points, weights, &scaled));
        for (int i = 0; i < 10; i++) {
            const double u = random_parameter(&random, surface, BATTEN_U),
                         v = random_parameter(&random, surface, BATTEN_V);
            double a[9], b[9];
            CHECK_OK(batten_surface_evaluate(surface, u, v, 1, a));
            CHECK_OK(batten_surface_evaluate(scaled, u, v, 1, b));
            for (int c = 0; c < 3 * data.dimension; c++)
                CHECK_NEAR(b[c], a[c], (s < 2 ? 0 : 1e-3) * (1 + fabs(a[c])));
        }
        batten_surface_unref(scaled);
    }
    batten_surface_unref(surface);
}
