/* Least squares with splines. */
#include "shape/near/approximate.h"
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

batten_curve_least_squares_options batten_curve_least_squares_defaults(void)
{
    return (batten_curve_least_squares_options){.size =
                                                    sizeof(batten_curve_least_squares_options),
                                                .degree = 3,
                                                .parameters = BATTEN_CHORD};
}

typedef struct {
    const batten_curve_least_squares_options *options;
    bat_fit_request request;
    double *parameters; /* [count], periodic [count + 1] */
    double *knots;
    double *control, *residuals;
    bat_condition_rows conditions;
    bat_robust robust;
    double cost; /* what the fit makes least */
    batten_fit_report report;
    bool is_reported; /* else its freedom, which takes as long as the solution, is left out */
    batten_curve *curve;
} approximation;

/* Second differences of the control points decide where no datum does: so much of the trace. */
#define SLIGHTLY 1e-10

static batten_status solve_with(approximation *t, bat_fit *fit, double lambda, int *unknown)
{
    t->report.lambda = lambda;
    if (t->conditions.count > 0)
        return bat_fit_solve_under(fit, lambda, t->options, &t->conditions, t->control,
                                   &t->report.pressing, &t->report.freedom);
    const batten_status status = bat_fit_solve(fit, lambda, t->control, unknown);
    return status == BATTEN_OK && t->is_reported ? bat_fit_freedom(fit, &t->report.freedom)
                                                 : status;
}

/* With the factors as they are. Conditions may determine what the data do not. */
static batten_status solve(approximation *t, bat_fit *fit)
{
    const bool plain = t->conditions.count == 0;
    int unknown = fit->periodic || !plain ? -1 : bat_fit_undetermined(fit);
    batten_status status = BATTEN_SINGULAR_SYSTEM;
    t->report.regularised = false;
    if (unknown < 0)
        status = solve_with(t, fit, 0, &unknown);
    if (status != BATTEN_SINGULAR_SYSTEM)
        return status;
    if (!t->options->regularise)
        return plain ? bat_fail(BATTEN_SINGULAR_SYSTEM,
                                "control point %d of %d has no datum of its own near its part "
                                "of the curve",
                                unknown + 1, fit->count)
                     : status;
    status = bat_fit_penalise_differences(fit, bat_min_int(2, fit->count - 1));
    t->report.regularised = true;
    return status == BATTEN_OK ? solve_with(t, fit, SLIGHTLY * fit->penalty_scale, &unknown)
                               : status;
}

static batten_status solve_and_measure(void *user, bat_fit *fit)
{
    approximation *t = user;
    const batten_status status = solve(t, fit);
    if (status == BATTEN_OK)
        bat_fit_residuals(fit, t->control, t->residuals);
    return status;
}

static batten_status solve_robustly(approximation *t, bat_fit *fit)
{
    const batten_status status = bat_fit_robustly(fit, t->request.weights, solve_and_measure, t,
                                                  t->residuals, &t->robust);
    t->report.reweightings = t->robust.rounds;
    t->report.threshold = t->robust.threshold;
    t->report.gap = t->robust.gap;
    /* The report counts all data by their own weights. */
    bat_fit_weigh(fit, t->request.weights);
    return status;
}

static batten_status fit_once(approximation *t)
{
    const batten_curve_least_squares_options *o = t->options;
    const bat_fit_request *r = &t->request;
    bat_fit fit = {0};
    batten_status status = bat_fit_begin(r, &fit);
    if (status != BATTEN_OK)
        return status;
    fit.fixed[0] = o->hold_start && !o->closed;
    fit.fixed[1] = o->hold_end && !o->closed;
    fit.ends[0] = r->points;
    fit.ends[1] = r->points + (size_t)(r->data_count - 1) * (size_t)r->dimension;
    if (bat_fit_has_conditions(o))
        status = bat_fit_conditions(&fit, o, &t->conditions);
    if (status == BATTEN_OK)
        status = solve_and_measure(t, &fit);
    if (status == BATTEN_OK && o->robust != BATTEN_SQUARES)
        status = solve_robustly(t, &fit);
    if (status == BATTEN_OK) {
        bat_fit_measure(&fit, t->residuals, &t->report);
        t->cost = o->robust == BATTEN_SQUARES ? t->report.sum : t->robust.cost;
        status = bat_fit_curve(&fit, t->control, &t->curve);
    }
    bat_condition_rows_free(&t->conditions);
    bat_fit_end(&fit);
    return status;
}

/* ---- knots ---- */

static batten_status take_knots(approximation *t)
{
    const batten_curve_least_squares_options *o = t->options;
    const bat_fit_request *r = &t->request;
    const size_t count = (size_t)r->count + (r->periodic ? 1 : (size_t)r->degree + 1);
    t->knots = bat_array(count, sizeof *t->knots);
    if (!t->knots)
        return BATTEN_OUT_OF_MEMORY;
    t->request.knots = t->knots;
    if (o->knots != BATTEN_KNOTS_GIVEN)
        return bat_fit_knots(r, t->knots);
    if (!o->given_knots)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the knots must be given, and are missing");
    memcpy(t->knots, o->given_knots, count * sizeof *t->knots);
    const size_t bad = bat_first_not_finite(t->knots, count);
    if (bad < count)
        return bat_fail(BATTEN_NOT_FINITE, "knot %zu is %g", bad + 1, t->knots[bad]);
    return BATTEN_OK;
}

/* From the curve with the knots so far to better ones; the first that are no better end it, and
 * those before stay. */
static batten_status move_knots(approximation *t)
{
    batten_status status = BATTEN_OK;
    for (int round = 0; status == BATTEN_OK && round < 10; round++) {
        const batten_fit_report before = t->report;
        const double cost = t->cost;
        batten_curve *curve = t->curve;
        t->curve = NULL;
        status = bat_fit_knots_by_curvature(&t->request, curve, t->knots);
        if (status == BATTEN_OK)
            status = fit_once(t);
        if (status == BATTEN_OK && t->cost < cost) {
            batten_curve_unref(curve);
            continue;
        }
        batten_curve_unref(t->curve);
        t->curve = curve;
        t->report = before;
        t->cost = cost;
        const int p = t->request.degree, n = t->request.count;
        const bool ring = t->request.periodic;
        memcpy(t->knots, batten_curve_knots(curve) + (ring ? p : 0),
               (size_t)(n + (ring ? 1 : p + 1)) * sizeof *t->knots);
        break;
    }
    return status;
}

/* ---- the whole ---- */

/* One round; *better tells whether it was worth another. What it found is kept when it is
 * nearer to the data. */
static batten_status correct_once(approximation *t, double *kept, bool *better)
{
    const batten_fit_report before = t->report;
    const double cost = t->cost;
    batten_curve *curve = t->curve;
    const size_t bytes = (size_t)t->request.data_count * sizeof *kept;
    memcpy(kept, t->parameters, bytes);
    batten_status status = bat_fit_correct(t->request.dimension, t->request.data_count,
                                           t->request.points, curve, t->parameters);
    t->curve = NULL;
    if (status == BATTEN_OK)
        status = fit_once(t);
    if (status == BATTEN_OK && t->cost < cost) {
        t->report.rounds = before.rounds + 1;
        /* A thousandth of a distance; of a sum of squares that is twice as much. */
        *better = cost - t->cost >= 2e-3 * cost;
        batten_curve_unref(curve);
        return BATTEN_OK;
    }
    batten_curve_unref(t->curve);
    t->curve = curve;
    t->report = before;
    t->cost = cost;
    memcpy(t->parameters, kept, bytes);
    *better = false;
    /* Parameters that leave a control point without data are no better. */
    return status == BATTEN_SINGULAR_SYSTEM ? BATTEN_OK : status;
}

static batten_status correct(approximation *t)
{
    double *kept = bat_array((size_t)t->request.data_count, sizeof *kept);
    if (!kept)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    bool better = true;
    for (int i = 0; status == BATTEN_OK && better && i < t->options->corrections; i++)
        status = correct_once(t, kept, &better);
    bat_release(kept);
    return status;
}

static batten_status check_fit_data(int dimension, int count, const double *points,
                                    const batten_curve_least_squares_options *o)
{
    batten_status status = bat_points_check(dimension, count, points, 2);
    if (status == BATTEN_OK)
        status = bat_weights_check(count, o->weights);
    if (status != BATTEN_OK)
        return status;
    if (o->degree < 1 || o->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", o->degree,
                        BATTEN_MAX_DEGREE);
    if (o->corrections < 0 || (o->corrections > 0 && dimension == 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d corrections of the parameters of a %s",
                        o->corrections, dimension == 1 ? "function" : "curve");
    if (o->point_count < 0 || o->point_count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d control points; the limit is %d", o->point_count,
                        BAT_MAX_POINTS);
    if ((int)o->parameters < 0 || o->parameters > BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown parametrization %d", (int)o->parameters);
    if ((int)o->robust < 0 || o->robust > BATTEN_TUKEY)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown robust fit %d", (int)o->robust);
    if (!(o->band >= 0 && o->band < HUGE_VAL))
        return bat_fail(isfinite(o->band) ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_FINITE,
                        "the band is %g; it must be 0 or more", o->band);
    if (!(o->threshold >= 0 && o->threshold < HUGE_VAL))
        return bat_fail(isfinite(o->threshold) ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_FINITE,
                        "the threshold of a robust fit is %g; it must be 0 or more",
                        o->threshold);
    return BATTEN_OK;
}

static batten_status fit_approximation(approximation *t)
{
    const batten_curve_least_squares_options *o = t->options;
    bat_fit_request *r = &t->request;
    const size_t n = (size_t)r->data_count;
    t->parameters = bat_array(n + 1, sizeof *t->parameters);
    t->control = bat_array3((size_t)r->count, (size_t)r->dimension, sizeof *t->control);
    t->residuals = bat_array3(n, (size_t)r->dimension, sizeof *t->residuals);
    if (!t->parameters || !t->control || !t->residuals)
        return BATTEN_OUT_OF_MEMORY;
    r->parameters = t->parameters;
    batten_status status =
        bat_fit_parameters(r->dimension, r->data_count, r->points, o->parameters, o->given,
                           o->closed, t->parameters);
    if (status == BATTEN_OK)
        status = take_knots(t);
    if (status == BATTEN_OK)
        status = fit_once(t);
    if (status == BATTEN_OK && o->knots == BATTEN_KNOTS_BY_CURVATURE)
        status = move_knots(t);
    if (status == BATTEN_OK && o->corrections > 0)
        status = correct(t);
    return status;
}

/* Of few data a lower degree; one control point for every four data, else. */
static void choose_sizes(const batten_curve_least_squares_options *o, int count,
                         bat_fit_request *r)
{
    r->degree = o->degree;
    if (o->point_count == 0 && !o->closed)
        r->degree = bat_min_int(o->degree, count - 1);
    r->count = o->point_count > 0 ? o->point_count
               : o->closed        ? bat_max_int(bat_min_int(count, 4), count / 4)
                                  : bat_max_int(r->degree + 1, count / 4);
}

batten_status batten_curve_least_squares(batten_points points,
                                         const batten_curve_least_squares_options *options,
                                         double *parameters, batten_fit_report *report,
                                         batten_curve **out)
{
    batten_curve_least_squares_options chosen = batten_curve_least_squares_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_curve_least_squares_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    approximation t = {.options = &chosen,
                       .is_reported = report != NULL,
                       .request = {.dimension = points.dimension,
                                   .data_count = points.count,
                                   .points = points.at}};
    status = check_fit_data(points.dimension, points.count, points.at, t.options);
    if (status != BATTEN_OK)
        return status;
    t.request.periodic = t.options->closed;
    t.request.weights = t.options->weights;
    t.robust = (bat_robust){.how = t.options->robust, .threshold = t.options->threshold};
    choose_sizes(t.options, points.count, &t.request);
    if (!t.options->closed && t.request.count <= t.request.degree)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "%d control point%s for degree %d; %d are needed", t.request.count,
                        bat_plural(t.request.count), t.request.degree, t.request.degree + 1);
    status = fit_approximation(&t);
    if (status == BATTEN_OK) {
        if (parameters)
            memcpy(parameters, t.parameters, (size_t)points.count * sizeof *parameters);
        if (report)
            *report = t.report;
        *out = t.curve;
    } else {
        batten_curve_unref(t.curve);
    }
    bat_release(t.knots);
    bat_release(t.parameters);
    bat_release(t.control);
    bat_release(t.residuals);
    return status;
}
