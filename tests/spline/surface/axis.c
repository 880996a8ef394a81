#include "spline/surface/axis.h"

#include "support/surfaces.h"
#include "support/test.h"

static batten_status make(int degree, int count, const double *knots, bat_axis *axis)
{
    bat_axis made;
    batten_status status = bat_axis_make(degree, count, false, &made);
    if (status == BATTEN_OK) {
        memcpy(made.knots, knots, ((size_t)count + degree + 1) * sizeof *knots);
        status = bat_axis_finish(&made);
    }
    if (status == BATTEN_OK)
        *axis = made;
    else
        bat_axis_free(&made);
    return status;
}

/* The span by looking at all of them. */
static int look(const bat_axis *axis, double u, batten_side side)
{
    for (int s = 0; s < axis->span_count; s++)
        if (side == BATTEN_FROM_LEFT ? u <= axis->breaks[s + 1] : u < axis->breaks[s + 1])
            return s;
    return axis->span_count - 1;
}

TEST(a_span_is_found_however_the_knots_lie)
{
    test_random random = test_random_begin(__func__);
    enum { COUNT_ = 200 };
    double knots[COUNT_ + 4];
    for (int kind = 0; kind < 4; kind++) {
        double at = -1;
        for (int i = 0; i < COUNT_ + 4; i++) {
            at += kind == 0   ? 1
                  : kind == 1 ? test_random_int(&random, 0, 3) == 0
                  : kind == 2 ? exp(-0.2 * i)
                              : pow(10, test_random_in(&random, -15, 3));
            knots[i] = at;
        }
        bat_axis axis;
        CHECK_OK(make(3, COUNT_, knots, &axis));
        for (int s = 0; s <= axis.span_count; s++)
            for (int n = -1; n <= 1; n++)
                for (int side = 0; side < 2; side++) {
                    const double u =
                        n ? nextafter(axis.breaks[s], n * INFINITY) : axis.breaks[s];
                    if (u >= axis.breaks[0] && u <= axis.breaks[axis.span_count])
                        CHECK_INT(bat_axis_span(&axis, u, (batten_side)side),
                                  look(&axis, u, (batten_side)side));
                }
        bat_axis_free(&axis);
    }
}

TEST(K6_basis_on_knots_an_ulp_or_a_denormal_apart_sums_to_one)
{
    const double tables[][8] = {{0, 0, 0, 5e-324, 1, 1, 1, 0},
                                {0, 0, 0, 5e-324, 5e-324, 5e-324, 0, 0},
                                {1, 1, 1, 1 + DBL_EPSILON, 2, 2, 2, 0},
                                {0, 0, 0, 1e-9, 1, 1, 1, 0}};
    const int counts[] = {4, 3, 4, 4};
    for (int i = 0; i < COUNT(tables); i++) {
        bat_axis axis;
        CHECK_OK(make(2, counts[i], tables[i], &axis));
        for (int s = 0; s < axis.span_count; s++)
            for (int k = 0; k <= 4; k++) {
                const double a = axis.breaks[s], b = axis.breaks[s + 1];
                const double u = fmin(a + (b - a) * k / 4, b);
                double N[3];
                bat_axis_basis(&axis, bat_axis_span(&axis, u, BATTEN_FROM_RIGHT), u, 0, N);
                CHECK_NEAR(N[0] + N[1] + N[2], 1, 4 * DBL_EPSILON);
                CHECK(N[0] >= 0 && N[1] >= 0 && N[2] >= 0);
            }
        bat_axis_free(&axis);
    }
}

TEST(basis_and_derivatives_are_those_of_the_definition)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(200); c++) {
        const int p = test_random_int(&random, 1, c % 10 ? 5 : 25);
        const int n = p + test_random_int(&random, 1, 9),
                  order = test_random_int(&random, 0, p + 1);
        double knots[64];
        random_knots(&random, p, n, knots);
        bat_axis axis;
        CHECK_OK(make(p, n, knots, &axis));
        const double u = test_random_int(&random, 0, 3) ? test_random_unit(&random)
                                                        : knots[test_random_int(&random, 0, n)];
        const int span = bat_axis_span(&axis, u, BATTEN_FROM_RIGHT),
                  first = bat_axis_first_point(&axis, span);
        double N[27 * 26];
        bat_axis_basis(&axis, span, u, order, N);
        for (int k = 0; k <= order; k++) {
            long double expected[64];
            define_basis(p, n, knots, u, k, expected);
            for (int j = 0; j <= p; j++)
                CHECK_NEAR(N[k * (p + 1) + j], (double)expected[first + j],
                           4 * p * DBL_EPSILON * pow(4. * p * n, k));
        }
        bat_axis_free(&axis);
    }
}

TEST(N7_a_parameter_4_ulps_outside_is_the_end)
{
    const double knots[] = {1, 1, 3, 3};
    bat_axis axis;
    CHECK_OK(make(1, 2, knots, &axis));
    double u = 3 + 4 * (nextafter(3, 4) - 3);
    CHECK_OK(bat_axis_place(&axis, BATTEN_FROM_RIGHT, &u));
    CHECK_BITS(u, 3);
    u = 3 + 6 * (nextafter(3, 4) - 3);
    CHECK_STATUS(bat_axis_place(&axis, BATTEN_FROM_RIGHT, &u), BATTEN_OUT_OF_DOMAIN);
    u = NAN;
    CHECK_STATUS(bat_axis_place(&axis, BATTEN_FROM_RIGHT, &u), BATTEN_NOT_FINITE);
    axis.periodic = true;
    CHECK_STATUS(bat_axis_place(&axis, BATTEN_FROM_RIGHT, &u), BATTEN_NOT_FINITE);
    u = -1e308;
    axis.knots[0] = axis.knots[1] = axis.breaks[0] = 1e308;
    CHECK_STATUS(bat_axis_place(&axis, BATTEN_FROM_RIGHT, &u), BATTEN_OUT_OF_DOMAIN);
    bat_axis_free(&axis);
}

TEST(a_periodic_parameter_goes_around)
{
    const double knots[] = {1, 1, 3, 3};
    bat_axis axis;
    CHECK_OK(make(1, 2, knots, &axis));
    axis.periodic = true;
    const double given[] = {4, 0, -4, 3, 1, 3, 1, 1e9};
    const batten_side sides[] = {0, 0, 0, 0, 0, 1, 1, 1};
    const double expected[] = {2, 2, 2, 1, 1, 3, 3, 2};
    for (int i = 0; i < COUNT(given); i++) {
        double u = given[i];
        CHECK_OK(bat_axis_place(&axis, sides[i], &u));
        CHECK_BITS(u, expected[i]);
    }
    bat_axis_free(&axis);
}
