#include "numeric/quadrature.h"

#include "support/test.h"

TEST(gauss_is_exact_for_polynomials_of_twice_its_degree)
{
    double nodes[BAT_MAX_GAUSS], weights[BAT_MAX_GAUSS];
    for (int n = 1; n <= BAT_MAX_GAUSS; n++) {
        bat_gauss(n, nodes, weights);
        for (int degree = 0; degree < 2 * n; degree++) {
            double sum = 0;
            for (int i = 0; i < n; i++)
                sum += weights[i] * pow(nodes[i], degree);
            CHECK_NEAR(sum, degree % 2 ? 0 : 2.0 / (degree + 1), 16 * DBL_EPSILON);
        }
        for (int i = 1; i < n; i++)
            CHECK(nodes[i - 1] < nodes[i]);
    }
}

TEST(known_nodes_of_gauss)
{
    double nodes[5], weights[5];
    bat_gauss(5, nodes, weights);
    CHECK_NEAR(nodes[4], sqrt(5 + 2 * sqrt(10.0 / 7)) / 3, DBL_EPSILON);
    CHECK_NEAR(weights[2], 128.0 / 225, DBL_EPSILON);
    CHECK_BITS(nodes[2], -0.0 + nodes[2]);
    CHECK_NEAR(nodes[2], 0, 0);
}

typedef struct {
    int kind, calls;
} problem;

static batten_status integrand(void *context, double t, double *value)
{
    problem *p = context;
    p->calls++;
    switch (p->kind) {
    case 0:
        *value = pow(t, 22);
        break;
    case 1:
        *value = sqrt(t);
        break;
    case 2:
        *value = 1 / (1e-4 + t * t);
        break;
    case 3:
        *value = fabs(t - 1.0 / 3);
        break;
    case 4:
        *value = cos(100 * t);
        break;
    case 5:
        *value = t > 0.3 ? 1 : 0;
        break;
    case 6:
        *value = 1 / t;
        break;
    case 7:
        return bat_fail(BATTEN_SINGULAR_HERE, "no tangent at %g", t);
    default:
        *value = 0;
    }
    return BATTEN_OK;
}

TEST(integrals_meet_their_tolerance)
{
    static const struct {
        int kind;
        double a, b, exact;
    } cases[] = {{0, -1, 1, 2.0 / 23},
                 {1, 0, 4, 16.0 / 3},
                 {2, -1, 1, 312.15933202164628},
                 {3, 0, 1, 5.0 / 18},
                 {4, 0, 2, -0.0087329729721399463}, /* sin 200 / 100 */
                 {5, 0, 1, 0.7},
                 {8, 0, 1, 0},
                 {1, 4, 0, -16.0 / 3},
                 {1, 2, 2, 0}};
    for (int i = 0; i < COUNT(cases); i++)
        for (double tolerance = 1e-3; tolerance > 1e-11; tolerance /= 100) {
            problem p = {cases[i].kind, 0};
            double value = 7, error = 7;
            CHECK_OK(bat_integrate(integrand, &p, cases[i].a, cases[i].b, tolerance, 100000,
                                   &value, &error));
            CHECK_NEAR(value, cases[i].exact, tolerance);
            CHECK(error <= tolerance);
            CHECK(p.calls <= 6000);
        }
}

TEST(the_first_rule_is_kronrods)
{
    problem p = {0, 0};
    double value = 7, error = 7;
    CHECK_OK(bat_integrate(integrand, &p, -1, 1, 1, 1, &value, &error));
    CHECK_NEAR(value, 2.0 / 23, 4 * DBL_EPSILON);
    CHECK_INT(p.calls % 16, 0);
}

/* Of a step from 0 to 1 the first rule gives the weight K of its nodes behind it, of 2 in all, and
 * cannot be off by more than K (2 - K), the weighted distances from the mean. */
TEST(the_error_of_a_step_is_how_much_it_varies)
{
    problem p = {5, 0};
    double value = 7, error = 7;
    CHECK_STATUS(bat_integrate(integrand, &p, -1, 1, 1e-9, 1, &value, &error),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_NEAR(value, 0.7, 0.1);
    CHECK_NEAR(error, value * (2 - value), 1e-15);
    CHECK_INT(p.calls % 16, 0);
    problem half = {5, 0};
    CHECK_STATUS(bat_integrate(integrand, &half, 0, 1, 1e-9, 1, &value, &error),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_NEAR(error, 2 * value * (1 - value), 1e-15);
}

TEST(an_integral_that_does_not_exist_ends_at_its_limit)
{
    problem p = {6, 0};
    double value = 7, error = 7;
    CHECK_STATUS(bat_integrate(integrand, &p, 0, 1, 1e-6, 500, &value, &error),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("after 500 evaluations");
    CHECK(p.calls <= 1000 && error > 1e-6);
    /* At the resolution of the numbers halving stops by itself. */
    p.kind = 1;
    CHECK_STATUS(
        bat_integrate(integrand, &p, 1, 1 + 4 * DBL_EPSILON, 1e-40, 10000000, &value, &error),
        BATTEN_TOLERANCE_NOT_MET);
}

TEST(a_failing_integrand_is_passed_on)
{
    problem p = {7, 0};
    double value = 7, error = 9;
    CHECK_STATUS(bat_integrate(integrand, &p, 0, 1, 1e-6, 500, &value, &error),
                 BATTEN_SINGULAR_HERE);
    p.kind = 6;
    CHECK_STATUS(bat_integrate(integrand, &p, -1, 1, 1e-6, 500, &value, &error),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(bat_integrate(integrand, &p, 1, 2, 0, 500, &value, &error),
                 BATTEN_BAD_ARGUMENT);
    CHECK_BITS(value, 7);
    CHECK_BITS(error, 9);
}

/* Two bumps 1 / (1 + (t / w)^2) at the breaks, of integral w atan(1 / w) each over a side of length 1. */
static batten_status narrow_bump(void *context, double t, double *value)
{
    const double w = *(const double *)context, x = (t - floor(t + 0.5)) / w;
    *value = 1 / (w * (1 + x * x));
    return BATTEN_OK;
}

TEST(peaks_at_breaks_are_seen_however_narrow)
{
    const double breaks[] = {0, 1, 2, 3};
    for (double w = 1e-1; w > 1e-7; w /= 7) {
        const bat_peaked_integral integral = {narrow_bump, &w, 4, breaks, 1e-10, 4000};
        const double exact = 6 * atan(0.5 / w);
        double value, error;
        CHECK_OK(bat_integrate_peaked(&integral, &value, &error, NULL));
        CHECK_NEAR(value, exact, 1e-10 * exact);
        CHECK(error <= 1e-10 * value);
    }
}

static batten_status count_calls(const bat_peaked_integral *integral, problem *p, double *value,
                                 double *error)
{
    p->calls = 0;
    return bat_integrate_peaked(integral, value, error, NULL);
}

TEST(an_integral_without_peaks_costs_one_rule_for_each_interval)
{
    problem p = {.kind = 0};
    const double breaks[] = {-1, -0.5, 0, 0.5, 1};
    const bat_peaked_integral integral = {integrand, &p, 5, breaks, 1e-4, 1000};
    double value, error;
    CHECK_OK(count_calls(&integral, &p, &value, &error));
    CHECK_NEAR(value, 2.0 / 23, 1e-9);
    CHECK(p.calls == 4 * 18);
}

TEST(an_integral_that_is_infinite_ends_with_its_error)
{
    problem p = {.kind = 6};
    const double breaks[] = {0, 1};
    const bat_peaked_integral integral = {integrand, &p, 2, breaks, 1e-9, 500};
    double value = 0, error = 0;
    CHECK_STATUS(bat_integrate_peaked(&integral, &value, &error, NULL),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK(error > 1e-9 * value);
    CHECK(p.calls <= 4 * 500);
}
