/* Splines whose control points are sums over few data: Schoenberg's, quasi-interpolants. */
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/points/parametrize.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"
#include "spline/spline.h"
#include <batten/polygon.h>

#include <string.h>

/* Polynomials of higher degree through equally spaced data swing by more than their data. */
enum { MOST_LOCAL_DEGREE = 9, PLACES_OF_SPAN = 8 };

batten_curve_schoenberg_options batten_curve_schoenberg_defaults(void)
{
    return (batten_curve_schoenberg_options){.size = sizeof(batten_curve_schoenberg_options),
                                             .degree = 3,
                                             .parameters = BATTEN_CHORD};
}

typedef struct refinement refinement;

struct refinement {
    int dimension, count; /* of the data */
    const double *points;
    int most_degree; /* of what `make` can do */
    void (*make)(refinement *t);
    bool periodic;
    double *t;       /* [count], periodic [count + 1] */
    int degree;      /* p */
    int values;      /* control points; periodic: of one period */
    double *U;       /* all knots, those of a period wrapped */
    double *control; /* [values][dimension] */
};

/* ---- blossoms ---- */

/* Elementary symmetric polynomials e[0 .. count] of (x[i] - centre) / size. */
static void symmetric(int count, const double *x, double centre, double size, double *e)
{
    memset(e, 0, (size_t)(count + 1) * sizeof *e);
    e[0] = 1;
    for (int i = 0; i < count; i++)
        for (int r = i + 1; r > 0; r--)
            e[r] += (x[i] - centre) / size * e[r - 1];
}

/* The blossom at knots s [p] of the polynomial of degree p that is 1 at x[j] and 0 at the other
 * x [p + 1]: of the product of (x - x[k]) / (x[j] - x[k]), by powers of x - centre. */
static double blossom(int p, const double *x, int j, const double *s)
{
    double others[MOST_LOCAL_DEGREE], e[MOST_LOCAL_DEGREE + 1], f[MOST_LOCAL_DEGREE + 1];
    const double centre = x[j], size = x[p] - x[0];
    double sum = 0, divisor = 1;
    for (int k = 0, i = 0; k <= p; k++)
        if (k != j) {
            divisor *= (x[j] - x[k]) / size;
            others[i++] = x[k];
        }
    symmetric(p, others, centre, size, e);
    symmetric(p, s, centre, size, f);
    for (int r = 0; r <= p; r++)
        sum += ((p - r) % 2 ? -e[p - r] : e[p - r]) * f[r] / bat_binomials[p][r];
    return sum / divisor;
}

/* ---- data ---- */

/* Datum j of a ring, which continues in both directions. */
static double place_at(const refinement *t, int j, const double **point)
{
    const int n = t->count, turn = j >= 0 ? j / n : -((n - 1 - j) / n), i = j - turn * n;
    *point = t->points + (size_t)i * (size_t)t->dimension;
    return t->t[i] + (turn != 0 ? turn * (t->t[n] - t->t[0]) : 0);
}

/* The last datum at or before u. */
static int datum_before(const refinement *t, double u)
{
    int low = 0, high = t->count - !t->periodic;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (t->t[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Add half of what the data from `first` on say of the control point at knots s. */
static void add_window(const refinement *t, int first, const double *s, double *out)
{
    const int p = t->degree, last = t->count - 1 - p;
    double x[MOST_LOCAL_DEGREE + 1];
    const double *q[MOST_LOCAL_DEGREE + 1];
    if (!t->periodic)
        first = bat_max_int(0, bat_min_int(first, last));
    for (int k = 0; k <= p; k++)
        x[k] = place_at(t, first + k, &q[k]);
    for (int k = 0; k <= p; k++) {
        const double weight = blossom(p, x, k, s) / 2;
        for (int c = 0; c < t->dimension; c++)
            out[c] += weight * q[k][c];
    }
}

/* Knots i + 1 .. i + p are data from the j-th on, some of them repeated at an end. */
static void make_quasi(refinement *t)
{
    const int p = t->degree;
    for (int i = 0; i < t->values; i++) {
        const int from = i - p + 1, to = i;
        double *out = t->control + (size_t)i * (size_t)t->dimension;
        const int j = t->periodic ? from : bat_max_int(from, 0),
                  l = t->periodic ? to : bat_min_int(to, t->count - 1);
        add_window(t, l - p, t->U + i + 1, out);
        add_window(t, j, t->U + i + 1, out);
    }
}

/* Greville's, of a ring in its first period. */
static double abscissa_of(const refinement *t, int i)
{
    double u = bat_greville(t->degree, t->U, i);
    if (t->periodic && u < t->t[0])
        u += t->t[t->count] - t->t[0];
    if (t->periodic && u >= t->t[t->count])
        u -= t->t[t->count] - t->t[0];
    return u;
}

static void make_schoenberg(refinement *t)
{
    for (int i = 0; i < t->values; i++) {
        const double u = abscissa_of(t, i), *q, *next;
        const int j = datum_before(t, u);
        const double a = place_at(t, j, &q), b = place_at(t, j + 1, &next);
        const double x = bat_max(0, bat_min(1, (u - a) / (b - a)));
        for (int c = 0; c < t->dimension; c++)
            t->control[(size_t)i * (size_t)t->dimension + (size_t)c] =
                x == 1 ? next[c] : q[c] + x * (next[c] - q[c]);
    }
}

/* ---- what they share ---- */

static batten_status make_knots(refinement *t, bool bernstein)
{
    const int p = t->degree, spans = t->periodic ? t->count : bernstein ? 1 : t->count - 1;
    t->values = t->periodic ? spans : spans + p;
    t->U = bat_array((size_t)spans + 2 * (size_t)p + 2, sizeof *t->U);
    t->control = bat_array3((size_t)t->values, (size_t)t->dimension, sizeof *t->control);
    if (!t->U || !t->control)
        return BATTEN_OUT_OF_MEMORY;
    if (t->periodic) {
        bat_knots_wrap(p, spans, t->t, t->U);
        return BATTEN_OK;
    }
    for (int i = 0; i <= spans + 2 * p; i++) {
        const int j = bat_max_int(0, bat_min_int(spans, i - p));
        t->U[i] = t->t[j == spans ? t->count - 1 : j];
    }
    return BATTEN_OK;
}

static batten_status measure_error(const refinement *t, const batten_curve *curve,
                                   batten_curve_schoenberg_report *report)
{
    const size_t n = (size_t)t->count, d = (size_t)t->dimension;
    double *at = bat_array3(n, d, sizeof *at), squares = 0;
    if (!at)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_curve_evaluate_many(curve, n, t->t, 0, NULL, at);
    *report = (batten_curve_schoenberg_report){0};
    for (int i = 0; status == BATTEN_OK && i < t->count; i++) {
        const double distance =
            bat_distance(t->dimension, at + (size_t)i * d, t->points + (size_t)i * d);
        if (distance > report->error) {
            report->error = distance;
            report->worst = i;
        }
        squares += distance * distance;
    }
    report->rms = sqrt(squares / (double)n);
    bat_release(at);
    return status;
}

static batten_status make_curve(const refinement *t, batten_curve **out)
{
    return t->periodic
               ? batten_curve_create_periodic(
                     (batten_points){t->dimension, t->values, t->control}, t->degree, NULL,
                     t->t, out)
               : batten_curve_create((batten_points){t->dimension, t->values, t->control},
                                     t->degree, NULL, t->U, out);
}

static batten_status begin_refining(refinement *t, const batten_curve_schoenberg_options *o)
{
    batten_status status = bat_points_check(t->dimension, t->count, t->points, 2);
    if (status != BATTEN_OK)
        return status;
    if (o->degree < 1 || o->degree > t->most_degree)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", o->degree,
                        t->most_degree);
    if ((int)o->parameters < 0 || o->parameters > BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown parametrization %d", (int)o->parameters);
    if (o->closed && o->bernstein)
        return bat_fail(BATTEN_BAD_ARGUMENT, "Bernstein's operator makes no closed curves");
    if (o->closed && t->count < 3)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d point%s; a closed curve needs 3", t->count,
                        bat_plural(t->count));
    t->periodic = o->closed;
    t->degree = o->closed || o->bernstein ? o->degree : bat_min_int(o->degree, t->count - 1);
    return bat_parameters_of((batten_points){t->dimension, t->count, t->points}, o->parameters,
                             o->given, o->closed, &t->t);
}

static batten_status refine_until_near(refinement *t, const batten_curve_schoenberg_options *o,
                                       double *parameters,
                                       batten_curve_schoenberg_report *report,
                                       batten_curve **out)
{
    batten_curve_schoenberg_report reached;
    batten_curve *curve = NULL;
    batten_status status = begin_refining(t, o);
    if (status == BATTEN_OK)
        status = make_knots(t, o->bernstein);
    if (status == BATTEN_OK) {
        t->make(t);
        status = make_curve(t, &curve);
    }
    if (status == BATTEN_OK)
        status = measure_error(t, curve, &reached);
    if (status == BATTEN_OK) {
        if (parameters)
            memcpy(parameters, t->t, (size_t)t->count * sizeof *parameters);
        if (report)
            *report = reached;
        *out = curve;
    } else {
        batten_curve_unref(curve);
    }
    bat_release(t->t);
    bat_release(t->U);
    bat_release(t->control);
    return status;
}

batten_status batten_curve_schoenberg(batten_points points,
                                      const batten_curve_schoenberg_options *options,
                                      double *parameters,
                                      batten_curve_schoenberg_report *report,
                                      batten_curve **out)
{
    batten_curve_schoenberg_options chosen = batten_curve_schoenberg_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_schoenberg_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    refinement t = {.dimension = points.dimension,
                    .count = points.count,
                    .points = points.at,
                    .most_degree = BATTEN_MAX_DEGREE,
                    .make = make_schoenberg};
    return refine_until_near(&t, &chosen, parameters, report, out);
}

batten_status batten_curve_quasi_interpolate(batten_points points,
                                             const batten_curve_schoenberg_options *options,
                                             double *parameters,
                                             batten_curve_schoenberg_report *report,
                                             batten_curve **out)
{
    batten_curve_schoenberg_options chosen = batten_curve_schoenberg_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_schoenberg_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    refinement t = {.dimension = points.dimension,
                    .count = points.count,
                    .points = points.at,
                    .most_degree = MOST_LOCAL_DEGREE,
                    .make = make_quasi};
    if (chosen.bernstein)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a quasi-interpolant has its knots at the data");
    return refine_until_near(&t, &chosen, parameters, report, out);
}

/* ---- functions that are known everywhere ---- */

typedef struct {
    int dimension, degree, count;
    const double *knots;
    batten_evaluator function;
    void *user;
} known;

static batten_status ask(const known *k, double u, int order, double *out)
{
    const size_t numbers = (size_t)(order + 1) * (size_t)k->dimension;
    const batten_status status = k->function(k->user, u, order, out);
    if (status != BATTEN_OK)
        return status;
    const size_t bad = bat_first_not_finite(out, numbers);
    return bad == numbers
               ? BATTEN_OK
               : bat_fail(BATTEN_NOT_FINITE, "the function is %g at %g", out[bad], u);
}

/* The blossom at the knots of Taylor's polynomial at Greville's abscissa; where the knots go on beyond the domain, at its
 * end, for the function need not be known outside. */
static batten_status control_of(const known *k, int i, int order, double *out)
{
    double at[3 * (BATTEN_MAX_DEGREE + 1)], e[BATTEN_MAX_DEGREE + 1], factorial = 1;
    const int d = k->dimension;
    const double u = bat_min(
        k->knots[k->count], bat_max(k->knots[k->degree], bat_greville(k->degree, k->knots, i)));
    const batten_status status = ask(k, u, order, at);
    symmetric(k->degree, k->knots + i + 1, u, 1, e);
    memset(out, 0, (size_t)d * sizeof *out);
    for (int r = 0; status == BATTEN_OK && r <= order; r++) {
        factorial *= r > 0 ? r : 1;
        for (int c = 0; c < d; c++)
            out[c] += at[r * d + c] / factorial * (e[r] / bat_binomials[k->degree][r]);
    }
    return status;
}

static batten_status compare(const known *k, const batten_curve *curve,
                             batten_curve_schoenberg_report *report)
{
    double squares = 0, places = 0;
    *report = (batten_curve_schoenberg_report){.worst = -1};
    for (int i = k->degree; i < k->count; i++)
        for (int j = 0; k->knots[i] < k->knots[i + 1] && j <= PLACES_OF_SPAN; j++) {
            const double a = k->knots[i], b = k->knots[i + 1];
            const double u = j == PLACES_OF_SPAN ? b : a + (b - a) * j / PLACES_OF_SPAN;
            double wanted[3], at[3];
            batten_status status = ask(k, u, 0, wanted);
            if (status == BATTEN_OK)
                status = batten_curve_evaluate(curve, u, 0, at);
            if (status != BATTEN_OK)
                return status;
            const double distance = bat_distance(k->dimension, wanted, at);
            report->error = bat_max(report->error, distance);
            squares += distance * distance;
            places++;
        }
    report->rms = sqrt(squares / places);
    return BATTEN_OK;
}

static batten_status check_known(const known *k)
{
    if (k->dimension < 1 || k->dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be in 1..3",
                        k->dimension);
    if (k->degree < 1 || k->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", k->degree,
                        BATTEN_MAX_DEGREE);
    if (k->count <= k->degree || k->count > BAT_MAX_POINTS)
        return bat_fail(k->count > k->degree ? BATTEN_TOO_LARGE : BATTEN_TOO_FEW_POINTS,
                        "%d control point%s for degree %d", k->count, bat_plural(k->count),
                        k->degree);
    return bat_knots_check(k->degree, k->count, k->knots, "knot");
}

static batten_status run_known(const known *k, int order,
                               batten_curve_schoenberg_report *report, batten_curve **out)
{
    batten_status status = check_known(k);
    if (status != BATTEN_OK)
        return status;
    const size_t d = (size_t)k->dimension;
    batten_curve_schoenberg_report reached;
    batten_curve *curve = NULL;
    double *control = bat_array3((size_t)k->count, d, sizeof *control);
    if (!control)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < k->count; i++)
        status = control_of(k, i, order, control + (size_t)i * d);
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){k->dimension, k->count, control},
                                     k->degree, NULL, k->knots, &curve);
    if (status == BATTEN_OK)
        status = compare(k, curve, &reached);
    bat_release(control);
    if (status != BATTEN_OK) {
        batten_curve_unref(curve);
        return status;
    }
    if (report)
        *report = reached;
    *out = curve;
    return BATTEN_OK;
}

batten_status batten_function_schoenberg(int dimension, const batten_axis *axis,
                                         batten_evaluator function, void *user,
                                         batten_curve_schoenberg_report *report,
                                         batten_curve **out)
{
    const known k = {dimension, axis->degree, axis->point_count, axis->knots, function, user};
    return run_known(&k, 0, report, out);
}

batten_status batten_function_de_boor_fix(int dimension, const batten_axis *axis,
                                          batten_evaluator function, void *user,
                                          batten_curve_schoenberg_report *report,
                                          batten_curve **out)
{
    const known k = {dimension, axis->degree, axis->point_count, axis->knots, function, user};
    return run_known(&k, axis->degree, report, out);
}
