#include <batten/polygon.h>

#include "support/test.h"

static double at(const batten_curve *curve, double u)
{
    double value;
    CHECK_OK(batten_curve_evaluate(curve, u, 0, &value));
    return value;
}

typedef struct {
    int kind;
    double constant;
} function;

enum { POWER, POLE, EXPONENTIAL, ABSOLUTE, UNDEFINED };

static batten_status evaluate(void *user, double u, int order, double *out)
{
    const function *f = user;
    CHECK_INT(order, 0);
    out[0] = f->kind == POWER         ? pow(u, f->constant)
             : f->kind == POLE        ? 1 / (u - f->constant)
             : f->kind == EXPONENTIAL ? exp(f->constant * u)
             : f->kind == ABSOLUTE    ? fabs(u)
                                      : sqrt(u - f->constant);
    return BATTEN_OK;
}

/* The errors at the places alternate and none is below the bound. */
static void check_alternates(const batten_curve_minimax_report *report, int degree,
                             const double *errors)
{
    for (int i = 0; i < degree + 2; i++) {
        CHECK(fabs(errors[i]) >= report->bound * (1 - 1e-7) - 1e-14);
        CHECK(fabs(errors[i]) <= report->error * (1 + 1e-7) + 1e-14);
        CHECK(i == 0 || errors[i] * errors[i - 1] < 0);
        CHECK(i == 0 || report->places[i] > report->places[i - 1]);
    }
}

static batten_curve_minimax_report best(function f, double a, double b, int degree)
{
    batten_curve_minimax_report report;
    batten_curve *curve = NULL;
    double errors[27], most = 0;
    CHECK_OK(batten_function_minimax((batten_interval){a, b}, degree, evaluate, &f, &report,
                                     &curve));
    for (int i = 0; i < degree + 2; i++) {
        double value;
        CHECK_OK(evaluate(&f, report.places[i], 0, &value));
        errors[i] = value - at(curve, report.places[i]);
    }
    check_alternates(&report, degree, errors);
    for (int i = 0; i <= 3000; i++) {
        const double u = i == 3000 ? b : a + (b - a) * i / 3000;
        double value;
        CHECK_OK(evaluate(&f, u, 0, &value));
        most = fmax(most, fabs(value - at(curve, u)));
    }
    CHECK(most <= report.error * (1 + 1e-5) + 1e-13);
    CHECK(report.rms <= report.error);
    batten_curve_unref(curve);
    return report;
}

TEST(chebyshevs_polynomials_are_the_errors_of_powers)
{
    for (int n = 0; n <= 24; n++) {
        const batten_curve_minimax_report report = best((function){POWER, n + 1}, -1, 1, n);
        CHECK_NEAR(report.error * ldexp(1, n), 1, 2e-6 + ldexp(1e-13, n));
    }
}

TEST(the_errors_of_a_pole_are_those_of_chebyshev)
{
    /* 1 / (x - c) on [-1, 1]: (c - sqrt(c^2 - 1))^n / (c^2 - 1). */
    for (int n = 0; n <= 20; n++) {
        const double c = 1.5, root = sqrt(c * c - 1), known = pow(c - root, n) / (root * root);
        const batten_curve_minimax_report report = best((function){POLE, c}, -1, 1, n);
        CHECK_NEAR(report.error, known, 2e-6 * known + 3e-13);
        CHECK(report.bound <= known * (1 + 1e-9) + 1e-14);
    }
}

TEST(the_best_line_of_the_exponential_is_known)
{
    const double slope = sinh(1), known = (exp(-1) + slope * log(slope)) / 2;
    const batten_curve_minimax_report report = best((function){EXPONENTIAL, 1}, -1, 1, 1);
    CHECK_NEAR(report.error, known, 1e-6 * known);
    CHECK_NEAR(report.places[1], log(slope), 1e-3);
}

TEST(the_corner_of_the_absolute_value_tends_to_bernsteins_constant)
{
    /* E_2, and 4 E_4 after Varga and Carpenter. */
    CHECK_NEAR(best((function){ABSOLUTE, 0}, -1, 1, 2).error, 0.125, 1e-7);
    CHECK_NEAR(4 * best((function){ABSOLUTE, 0}, -1, 1, 4).error, 0.270483597, 3e-7);
    double before = 0.25 * (1 - 1e-6);
    for (int n = 2; n <= 24; n += 2) {
        /* Of an even function the odd power gives nothing: there the first level is 0. */
        const double even = best((function){ABSOLUTE, 0}, -1, 1, n).error,
                     odd = best((function){ABSOLUTE, 0}, -1, 1, n + 1).error;
        CHECK_NEAR(odd, even, 3e-6 * even);
        CHECK(n * even >= before && n * even < 0.28017);
        before = n * even;
    }
    CHECK(before > 0.2795);
}

/* The least largest error of a line is the level of the worst of all triples. */
static double worst_triple(int count, const double *t, const double *y)
{
    double most = 0;
    for (int a = 0; a < count; a++)
        for (int b = a + 1; b < count; b++)
            for (int c = b + 1; c < count; c++) {
                const double chord = y[a] + (y[c] - y[a]) * (t[b] - t[a]) / (t[c] - t[a]);
                most = fmax(most, fabs(y[b] - chord) / 2);
            }
    return most;
}

TEST(the_best_line_near_data_is_that_of_the_worst_triple)
{
    test_random random = test_random_begin("triples");
    double t[30], y[30];
    for (int c = 0; c < test_cases(60); c++) {
        const int n = 3 + c % 28;
        for (int i = 0; i < n; i++) {
            t[i] = i + test_random_in(&random, 0, 0.9);
            y[i] = c % 3 ? test_random_in(&random, -1, 1) : test_random_int(&random, -1, 1);
        }
        batten_curve_minimax_report report;
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_minimax(n, t, y, 1, &report, &curve));
        const double known = worst_triple(n, t, y);
        CHECK_NEAR(report.error, known, 1e-12);
        CHECK_NEAR(report.bound, known, 1e-12);
        for (int i = 0; i < n; i++)
            CHECK(fabs(at(curve, t[i]) - y[i]) <= known + 1e-12);
        batten_curve_unref(curve);
    }
}

TEST(data_of_any_degree_have_errors_that_alternate)
{
    test_random random = test_random_begin("alternate");
    double t[60], y[60], errors[27];
    for (int c = 0; c < test_cases(60); c++) {
        const int degree = c % 16, n = degree + 2 + c % 40;
        for (int i = 0; i < n; i++) {
            t[i] = i + test_random_in(&random, 0, 0.5);
            y[i] = sin(t[i]) + test_random_in(&random, -1, 1);
        }
        batten_curve_minimax_report report;
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_minimax(n, t, y, degree, &report, &curve));
        CHECK_NEAR(report.error, report.bound, 1e-11);
        for (int i = 0; i < degree + 2; i++)
            for (int k = 0; k < n; k++)
                if (t[k] == report.places[i])
                    errors[i] = y[k] - at(curve, t[k]);
        /* Bernstein's form of the last terms loses about a digit for each three degrees. */
        for (int i = 1; i < degree + 2; i++)
            CHECK(errors[i] * errors[i - 1] < 0);
        for (int i = 0; i < n; i++)
            CHECK(fabs(at(curve, t[i]) - y[i]) <= report.error + 1e-8);
        batten_curve_unref(curve);
    }
}

TEST(data_of_a_polynomial_leave_no_error)
{
    double t[40], y[40];
    for (int degree = 0; degree <= 25; degree += 5) {
        for (int i = 0; i < 40; i++) {
            t[i] = -1 + i / 19.5;
            y[i] = cos(degree * acos(fmax(-1, fmin(1, t[i]))));
        }
        batten_curve_minimax_report report;
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_minimax(40, t, y, degree, &report, &curve));
        CHECK(report.error < 1e-9 && report.bound <= report.error);
        CHECK_INT(batten_curve_degree(curve), degree > 0 ? degree : 1);
        batten_curve_unref(curve);
    }
}

TEST(N2_least_errors_scale_with_the_data)
{
    double t[12], y[12], scaled[12];
    for (int i = 0; i < 12; i++) {
        t[i] = i;
        y[i] = cos(3.0 * i);
    }
    batten_curve_minimax_report plain, report;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_minimax(12, t, y, 4, &plain, &curve));
    batten_curve_unref(curve);
    static const double sizes[] = {1e-300, 1e-9, 1e9, 1e300};
    for (int k = 0; k < COUNT(sizes); k++) {
        for (int i = 0; i < 12; i++)
            scaled[i] = y[i] * sizes[k];
        curve = NULL;
        CHECK_OK(batten_curve_minimax(12, t, scaled, 4, &report, &curve));
        CHECK_NEAR(report.error / sizes[k], plain.error, 1e-12);
        batten_curve_unref(curve);
    }
}

TEST(N1_what_minimax_cannot_do_is_named)
{
    const double t[4] = {0, 1, 1, 2}, y[4] = {0, NAN, 1, 2}, z[4] = {0, 1, 2, 3};
    function undefined = {UNDEFINED, 0.3}, power = {POWER, 2};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_minimax(4, z, y, 1, NULL, &curve), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_minimax(4, t, z, 1, NULL, &curve), BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_curve_minimax(4, z, z, 3, NULL, &curve), BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_curve_minimax(4, z, z, -1, NULL, &curve), BATTEN_BAD_DEGREE);
    CHECK_STATUS(
        batten_function_minimax((batten_interval){0, 1}, 26, evaluate, &power, NULL, &curve),
        BATTEN_BAD_DEGREE);
    CHECK_STATUS(
        batten_function_minimax((batten_interval){1, 1}, 3, evaluate, &power, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(
        batten_function_minimax((batten_interval){1, NAN}, 3, evaluate, &power, NULL, &curve),
        BATTEN_NOT_FINITE);
    CHECK_STATUS(
        batten_function_minimax((batten_interval){0, 1}, 3, evaluate, &undefined, NULL, &curve),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("the function is");
    CHECK(curve == NULL);
}
