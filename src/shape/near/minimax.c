/* Polynomials of least largest error, by exchanging one point of the reference at a time. */
#include "numeric/dense.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"
#include "spline/spline.h"
#include <batten/polygon.h>

#include <float.h>
#include <string.h>

enum {
    MOST_REFERENCE = BATTEN_MAX_DEGREE + 2,
    MOST_EXCHANGES = 2000,
    PLACES_OF_EXTREMUM = 64,
    REFINEMENTS = 24
};

/* What a function known everywhere may still be bettered by, as a share. */
#define LAST_SHARE 1e-6
/* Between two places the error exceeds that at both by less than the rest of this. */
#define NEARLY 0.95

typedef struct {
    int degree, count;   /* n; of the data, or of the places where a function is looked at */
    const double *t, *f; /* [count] */
    double *errors;
    double a, b;
    batten_evaluator function; /* NULL: the data are all there is */
    void *user;
    double size;                                 /* the largest |f| */
    double x[MOST_REFERENCE], y[MOST_REFERENCE]; /* the reference [n + 2] */
    double coefficients[MOST_REFERENCE];         /* of Chebyshev's polynomials */
    double level;                                /* with the sign that the first has */
    double worst, worst_value, worst_error;      /* where the error is largest */
    int exchanges;
} minimax;

/* ---- the polynomial ---- */

static double scaled_parameter(const minimax *t, double u)
{
    return bat_max(-1, bat_min(1, ((u - t->a) - (t->b - u)) / (t->b - t->a)));
}

/* Clenshaw's recurrence. */
static double value(const minimax *t, double u)
{
    const double x = scaled_parameter(t, u);
    double b1 = 0, b2 = 0;
    for (int k = t->degree; k > 0; k--) {
        const double b0 = t->coefficients[k] + 2 * x * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    return t->coefficients[0] + x * b1 - b2;
}

/* p(x[i]) + level (-1)^i = y[i] at the n + 2 points of the reference. */
static batten_status level_reference(minimax *t)
{
    double a[MOST_REFERENCE * MOST_REFERENCE / 2], *matrix = NULL;
    int pivots[MOST_REFERENCE];
    const int n = t->degree, m = n + 2;
    if ((size_t)(m * m) > sizeof a / sizeof *a) {
        matrix = bat_array((size_t)(m * m), sizeof *matrix);
        if (!matrix)
            return BATTEN_OUT_OF_MEMORY;
    }
    double *rows = matrix ? matrix : a;
    for (int i = 0; i < m; i++) {
        double *row = rows + i * m;
        const double x = scaled_parameter(t, t->x[i]);
        row[0] = 1;
        row[1] = n > 0 ? x : 0;
        for (int k = 2; k <= n; k++)
            row[k] = 2 * x * row[k - 1] - row[k - 2];
        row[n + 1] = i % 2 ? -1 : 1;
        t->coefficients[i] = t->y[i];
    }
    const batten_status status = bat_dense_factor(m, rows, pivots);
    if (status == BATTEN_OK) {
        bat_dense_solve(m, rows, pivots, 1, t->coefficients);
        t->level = t->coefficients[n + 1];
    }
    bat_release(matrix);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return bat_fail(
            status,
            "%d of the parameters lie too close together for a polynomial of degree "
            "%d: near %g",
            m, n, t->x[0]);
    return status;
}

/* ---- the largest error ---- */

static void take_worst(minimax *t, double u, double f)
{
    const double error = f - value(t, u);
    if (fabs(error) > fabs(t->worst_error)) {
        t->worst = u;
        t->worst_value = f;
        t->worst_error = error;
    }
}

static batten_status ask(const minimax *t, double u, double *f)
{
    const batten_status status = t->function(t->user, u, 0, f);
    if (status != BATTEN_OK || isfinite(*f))
        return status;
    return bat_fail(BATTEN_NOT_FINITE, "the function is %g at %g", *f, u);
}

/* Golden sections on both sides of place `i`, beyond which the error is less. */
static batten_status refine(minimax *t, int i)
{
    const double ratio = (sqrt(5) - 1) / 2;
    double low = t->t[bat_max_int(0, i - 1)], high = t->t[bat_min_int(t->count - 1, i + 1)],
           best = t->t[i], error = t->errors[i];
    for (int k = 0; k < REFINEMENTS; k++) {
        const double u = best - low > high - best ? low + ratio * (best - low)
                                                  : high - ratio * (high - best);
        double f, edge = u;
        const batten_status status = ask(t, u, &f);
        if (status != BATTEN_OK)
            return status;
        take_worst(t, u, f);
        if (fabs(f - value(t, u)) > fabs(error)) {
            edge = best;
            best = u;
            error = f - value(t, u);
        }
        if (edge < best)
            low = edge;
        else
            high = edge;
    }
    return BATTEN_OK;
}

/* Of data all; of a function the places and, beside those that are extrema and might be the
 * worst, what lies between. */
static batten_status find_worst(minimax *t)
{
    const int last = t->count - 1;
    batten_status status = BATTEN_OK;
    t->worst_error = 0;
    for (int i = 0; i <= last; i++) {
        t->errors[i] = t->f[i] - value(t, t->t[i]);
        take_worst(t, t->t[i], t->f[i]);
    }
    const double high = NEARLY * fabs(t->worst_error);
    for (int i = 0; t->function && status == BATTEN_OK && i <= last; i++) {
        const double size = fabs(t->errors[i]);
        if (size > high && (i == 0 || size >= fabs(t->errors[i - 1])) &&
            (i == last || size > fabs(t->errors[i + 1])))
            status = refine(t, i);
    }
    return status;
}

/* ---- exchanging ---- */

/* Let the worst place in and its neighbour of the same sign out, so that signs go on to
 * alternate; the level can but grow. */
static void exchange(minimax *t)
{
    const int m = t->degree + 2;
    const bool plus = t->worst_error > 0, first_plus = t->level >= 0;
    int i = 0; /* how many of the reference lie before it */
    while (i < m && t->x[i] < t->worst)
        i++;
    const bool next_is_same = (i % 2 == 0 ? first_plus : !first_plus) == plus;
    int out = next_is_same ? i : i - 1;
    if (out < 0) {
        memmove(t->x + 1, t->x, (size_t)(m - 1) * sizeof *t->x);
        memmove(t->y + 1, t->y, (size_t)(m - 1) * sizeof *t->y);
        out = 0;
    } else if (out == m) {
        memmove(t->x, t->x + 1, (size_t)(m - 1) * sizeof *t->x);
        memmove(t->y, t->y + 1, (size_t)(m - 1) * sizeof *t->y);
        out = m - 1;
    }
    t->x[out] = t->worst;
    t->y[out] = t->worst_value;
}

static bool is_least(const minimax *t)
{
    /* What evaluation and the equations round. */
    const double rounding = 32 * (t->degree + 2) * DBL_EPSILON * t->size;
    const double share = t->function ? LAST_SHARE : 1e-12;
    return fabs(t->worst_error) <= fabs(t->level) * (1 + share) + rounding;
}

static batten_status exchange_all(minimax *t)
{
    batten_status status = level_reference(t);
    if (status == BATTEN_OK)
        status = find_worst(t);
    for (; status == BATTEN_OK && !is_least(t); t->exchanges++) {
        if (t->exchanges == MOST_EXCHANGES)
            return bat_fail(BATTEN_INCOMPLETE,
                            "after %d exchanges the error is %g, and none below %g is possible",
                            t->exchanges, fabs(t->worst_error), fabs(t->level));
        exchange(t);
        status = level_reference(t);
        if (status == BATTEN_OK)
            status = find_worst(t);
    }
    return status;
}

/* ---- beginning and end ---- */

/* The places nearest to the extrema of Chebyshev's polynomial of degree n + 1. */
static void begin_reference(minimax *t)
{
    const int m = t->degree + 2, last = t->count - 1;
    const double pi = 4 * bat_atan(1);
    for (int i = 0, at = -1; i < m; i++) {
        const int wanted = (int)(last * (1 - bat_cos(pi * i / (m - 1))) / 2 + 0.5);
        at = bat_max_int(at + 1, bat_min_int(wanted, t->count - m + i));
        t->x[i] = t->t[at];
        t->y[i] = t->f[at];
    }
}

/* Chebyshev's polynomials in Bernstein form: T_k has (-1)^(k - i) C(2 k, 2 i) / C(k, i), raised
 * to degree n. */
static batten_status make_curve(const minimax *t, batten_curve **out)
{
    const int n = bat_max_int(t->degree, 1);
    double control[BATTEN_MAX_DEGREE + 1] = {0}, b[BATTEN_MAX_DEGREE + 1];
    for (int k = 0; k <= t->degree; k++) {
        double term = k % 2 ? -1 : 1;
        for (int i = 0; i <= k; i++) {
            b[i] = term;
            term *= -(2.0 * (k - i) - 1) / (2.0 * i + 1);
        }
        for (int q = k; q < n; q++)
            for (int i = q + 1; i >= 0; i--)
                b[i] = (i <= q ? b[i] * (q + 1 - i) / (q + 1) : 0) +
                       (i > 0 ? b[i - 1] * i / (q + 1) : 0);
        for (int i = 0; i <= n; i++)
            control[i] += t->coefficients[k] * b[i];
    }
    double knots[2 * (BATTEN_MAX_DEGREE + 1)];
    for (int i = 0; i <= n; i++) {
        knots[i] = t->a;
        knots[n + 1 + i] = t->b;
    }
    return batten_curve_create((batten_points){1, n + 1, control}, n, NULL, knots, out);
}

/* The errors of the curve itself: Bernstein's form of high degrees rounds more than
 * Chebyshev's. */
static batten_status measure_bernstein_error(const minimax *t, const batten_curve *curve,
                                             batten_curve_minimax_report *report)
{
    double squares = 0;
    const batten_status status =
        batten_curve_evaluate_many(curve, (size_t)t->count, t->t, 0, NULL, t->errors);
    *report =
        (batten_curve_minimax_report){.error = fabs(t->worst_error), .exchanges = t->exchanges};
    for (int i = 0; status == BATTEN_OK && i < t->count; i++) {
        const double error = fabs(t->f[i] - t->errors[i]);
        report->error = bat_max(report->error, error);
        squares += error * (error / t->count);
    }
    report->rms = sqrt(squares);
    report->bound = bat_min(fabs(t->level), report->error);
    memcpy(report->places, t->x, (size_t)(t->degree + 2) * sizeof *t->x);
    return status;
}

static batten_status find_minimax(minimax *t, batten_curve_minimax_report *report,
                                  batten_curve **out)
{
    batten_curve_minimax_report reached;
    batten_curve *curve = NULL;
    t->a = t->t[0];
    t->b = t->t[t->count - 1];
    t->size = bat_largest(t->count, t->f);
    t->errors = bat_array((size_t)t->count, sizeof *t->errors);
    if (!t->errors)
        return BATTEN_OUT_OF_MEMORY;
    begin_reference(t);
    batten_status status = exchange_all(t);
    if (status == BATTEN_OK)
        status = make_curve(t, &curve);
    if (status == BATTEN_OK)
        status = measure_bernstein_error(t, curve, &reached);
    bat_release(t->errors);
    if (status != BATTEN_OK) {
        batten_curve_unref(curve);
        return status;
    }
    if (report)
        *report = reached;
    *out = curve;
    return BATTEN_OK;
}

static batten_status check_degree(int degree)
{
    return degree >= 0 && degree <= BATTEN_MAX_DEGREE
               ? BATTEN_OK
               : bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 0..%d", degree,
                          BATTEN_MAX_DEGREE);
}

batten_status batten_curve_minimax(int count, const double *parameters, const double *values,
                                   int degree, batten_curve_minimax_report *report,
                                   batten_curve **out)
{
    batten_status status = check_degree(degree);
    if (status == BATTEN_OK)
        status = bat_points_check(1, count, values, degree + 2);
    if (status == BATTEN_OK)
        status = bat_parameters_check(count, parameters);
    if (status != BATTEN_OK)
        return status;
    minimax t = {.degree = degree, .count = count, .t = parameters, .f = values};
    return find_minimax(&t, report, out);
}

batten_status batten_function_minimax(batten_interval domain, int degree,
                                      batten_evaluator function, void *user,
                                      batten_curve_minimax_report *report, batten_curve **out)
{
    batten_status status = check_degree(degree);
    if (status != BATTEN_OK)
        return status;
    if (!(isfinite(domain.a) && isfinite(domain.b) && domain.a < domain.b))
        return bat_fail(isfinite(domain.a) && isfinite(domain.b) ? BATTEN_BAD_ARGUMENT
                                                                 : BATTEN_NOT_FINITE,
                        "the interval is %g .. %g", domain.a, domain.b);
    const int count = PLACES_OF_EXTREMUM * (degree + 2) + 1;
    double *places = bat_array((size_t)count, sizeof *places),
           *values = bat_array((size_t)count, sizeof *values);
    status = places && values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    minimax t = {.degree = degree,
                 .count = count,
                 .t = places,
                 .f = values,
                 .function = function,
                 .user = user};
    /* Denser towards the ends, as the extrema are. */
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const double s = bat_sin(2 * bat_atan(1) * i / (count - 1));
        places[i] = i == count - 1 ? domain.b : domain.a + (domain.b - domain.a) * s * s;
        status = ask(&t, places[i], &values[i]);
    }
    if (status == BATTEN_OK)
        status = find_minimax(&t, report, out);
    bat_release(places);
    bat_release(values);
    return status;
}
