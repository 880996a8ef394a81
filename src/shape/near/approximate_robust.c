/* Robust fits by weighing data anew, and the data that are outliers. */
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/near/approximate.h"
#include "spline/data_check.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* Distances below this share of their mean count as one: weights stay finite. The share by
 * which a fit may miss the least sum is as much. */
#define SMALL_SHARE 1e-6
enum { MOST_ROUNDS = 50 };

/* Distances of so many roundings of the largest coordinate count as 0. */
#define ROUNDINGS (1000 * DBL_EPSILON)

/* Chosen thresholds, in medians of the distance: of normal errors in a function the median is
 * 0.6745 standard deviations, so these are 1.35 and 4.72; the usual ones are 1.345 and 4.685.
 */
enum { HUBER_MEDIANS = 2, TUKEY_MEDIANS = 7 };

typedef struct {
    bat_fit *fit;
    const double *weights; /* of the data, or NULL */
    batten_status (*solve)(void *user, bat_fit *fit);
    void *user;
    const double *residuals;
    double *distances, *factors, *product; /* [data_count] */
    batten_robust how;
    double threshold; /* of BATTEN_ABSOLUTE: the mean distance, as a unit */
    double cost, gap;
    int rounds;
} robust_fit;

static double weight_of(const robust_fit *t, int i)
{
    return t->weights ? t->weights[i] : 1;
}

static void find_distances(robust_fit *t)
{
    const int d = t->fit->dimension;
    for (int i = 0; i < t->fit->data_count; i++)
        t->distances[i] = bat_norm(d, t->residuals + (size_t)i * (size_t)d);
}

/* ---- the sum that becomes least ---- */

static double loss(const robust_fit *t, double r)
{
    const double k = t->threshold, x = r / k, rest = 1 - x * x;
    switch (t->how) {
    case BATTEN_HUBER:
        return r <= k ? r * r / 2 : k * (r - k / 2);
    case BATTEN_TUKEY:
        return x < 1 ? k * k / 6 * (1 - rest * rest * rest) : k * k / 6;
    default:
        return k * r;
    }
}

/* The derivative of the loss by the distance, divided by the distance. */
static double factor_of(const robust_fit *t, double r)
{
    const double k = t->threshold, x = r / k, rest = 1 - x * x;
    switch (t->how) {
    case BATTEN_HUBER:
        return r <= k ? 1 : k / r;
    case BATTEN_TUKEY:
        /* Never quite nothing: what data determine they go on to determine. */
        return bat_max(x < 1 ? rest * rest : 0, 1e-8);
    default:
        return k / bat_max(r, SMALL_SHARE * k);
    }
}

static double sum_of_losses(const robust_fit *t)
{
    double sum = 0;
    for (int i = 0; i < t->fit->data_count; i++)
        sum += weight_of(t, i) * loss(t, t->distances[i]);
    return sum;
}

/*
 * No fit has a smaller sum than this. The forces y = w factor r of the fit by squares are in
 * balance, so y.r is the same, or larger, for every curve that is allowed; and where no |y| / w
 * exceeds the threshold, loss(r) >= y.r / w - conjugate(y / w) after Fenchel. Forces that are
 * too large are scaled down all together.
 */
static double lower_bound(const robust_fit *t)
{
    double most = 0, sum = 0;
    const int n = t->fit->data_count;
    for (int i = 0; i < n; i++)
        most = bat_max(most, weight_of(t, i) > 0 ? t->factors[i] * t->distances[i] : 0);
    const double scale = most > t->threshold ? t->threshold / most : 1;
    for (int i = 0; i < n; i++) {
        const double force = scale * t->factors[i] * t->distances[i];
        sum += weight_of(t, i) *
               (force * t->distances[i] - (t->how == BATTEN_HUBER ? force * force / 2 : 0));
    }
    return sum;
}

/* ---- rounds ---- */

static batten_status reweigh(robust_fit *t)
{
    batten_status status = BATTEN_OK;
    const int n = t->fit->data_count;
    t->cost = sum_of_losses(t);
    t->gap = HUGE_VAL;
    for (int i = 0; status == BATTEN_OK && i < MOST_ROUNDS; i++) {
        const double before = t->cost;
        for (int k = 0; k < n; k++) {
            t->factors[k] = factor_of(t, t->distances[k]);
            t->product[k] = weight_of(t, k) * t->factors[k];
        }
        bat_fit_weigh(t->fit, t->product);
        status = t->solve(t->user, t->fit);
        t->rounds++;
        find_distances(t);
        t->cost = sum_of_losses(t);
        if (t->how != BATTEN_TUKEY)
            t->gap = t->cost > 0 ? bat_max(0, 1 - lower_bound(t) / t->cost) : 0;
        if (t->how == BATTEN_TUKEY ? before - t->cost <= SMALL_SHARE * before
                                   : t->gap <= SMALL_SHARE)
            break;
    }
    return status;
}

/* ---- sizes ---- */

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The median of the distances of data that count, which `copy` [count] gathers; 0 for none. A
 * curve of so many unknowns may pass through as many data whatever they are: the nearest are
 * left out, at most half. */
static double median_of(int count, const double *distances, const double *weights, int unknowns,
                        double *copy)
{
    int n = 0;
    for (int i = 0; i < count; i++)
        if (!weights || weights[i] > 0)
            copy[n++] = distances[i];
    if (n == 0)
        return 0;
    qsort(copy, (size_t)n, sizeof *copy, by_value);
    const int from = bat_min_int(unknowns, n / 2);
    return (copy[from + (n - from - 1) / 2] + copy[from + (n - from) / 2]) / 2;
}

static double mean_of(const robust_fit *t)
{
    double sum = 0, weight = 0;
    for (int i = 0; i < t->fit->data_count; i++) {
        sum += weight_of(t, i) * t->distances[i];
        weight += weight_of(t, i);
    }
    return weight > 0 ? sum / weight : 0;
}

static double largest_coordinate(const bat_fit *fit)
{
    return bat_largest(fit->data_count * fit->dimension, fit->points);
}

/* By absolute distances first: the median of what they leave is not spoilt by outliers. */
static batten_status fit_robustly(robust_fit *t, bat_robust *robust)
{
    find_distances(t);
    const double mean = mean_of(t);
    if (!(mean > ROUNDINGS * largest_coordinate(t->fit)))
        return BATTEN_OK;
    batten_status status = BATTEN_OK;
    if (robust->how != BATTEN_HUBER || robust->threshold == 0) {
        t->how = BATTEN_ABSOLUTE;
        t->threshold = mean;
        status = reweigh(t);
        t->cost /= mean;
    }
    if (status != BATTEN_OK || robust->how == BATTEN_ABSOLUTE)
        return status;
    if (robust->threshold == 0) {
        const double median =
            median_of(t->fit->data_count, t->distances, t->weights, t->fit->count, t->product);
        robust->threshold =
            bat_max(SMALL_SHARE * mean,
                    median * (robust->how == BATTEN_HUBER ? HUBER_MEDIANS : TUKEY_MEDIANS));
    }
    t->how = robust->how;
    t->threshold = robust->threshold;
    return reweigh(t);
}

batten_status bat_fit_robustly(bat_fit *fit, const double *weights,
                               batten_status (*solve)(void *user, bat_fit *fit), void *user,
                               double *residuals, bat_robust *robust)
{
    robust_fit t = {.fit = fit, .weights = weights, .solve = solve, .user = user};
    const size_t n = (size_t)fit->data_count;
    t.residuals = residuals;
    t.distances = bat_array(n, sizeof *t.distances);
    t.factors = bat_array(n, sizeof *t.factors);
    t.product = bat_array(n, sizeof *t.product);
    const bool all = t.distances && t.factors && t.product;
    const batten_status status = all ? fit_robustly(&t, robust) : BATTEN_OUT_OF_MEMORY;
    robust->cost = t.cost;
    robust->gap = t.gap;
    robust->rounds = t.rounds;
    bat_release(t.distances);
    bat_release(t.factors);
    bat_release(t.product);
    return status;
}

/* ---- outliers ---- */

batten_status batten_curve_outliers(const batten_curve *curve, const batten_fit_data *data,
                                    double times, double *distance, int *outliers,
                                    int *outlier_count)
{
    if (data->points.dimension != batten_curve_dimension(curve))
        return bat_wrong_dimension(data->points, batten_curve_dimension(curve));
    const int d = batten_curve_dimension(curve);
    const size_t n = (size_t)bat_max_int(data->points.count, 0);
    if (data->points.count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d point%s; outliers need 1",
                        data->points.count, bat_plural(data->points.count));
    if (!(times > 0 && times < HUGE_VAL))
        return bat_fail(isfinite(times) ? BATTEN_BAD_ARGUMENT : BATTEN_NOT_FINITE,
                        "outliers from %g times the median distance; it must be above 0",
                        times);
    batten_status status = bat_weights_check(data->points.count, data->weights);
    if (status != BATTEN_OK)
        return status;
    double *at = bat_array3(n, (size_t)d, sizeof *at), *distances = bat_array(n, sizeof *at),
           *copy = bat_array(n, sizeof *at);
    status = at && distances && copy
                 ? batten_curve_evaluate_many(curve, n, data->parameters, 0, NULL, at)
                 : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (int i = 0; i < data->points.count; i++)
            distances[i] = bat_distance(d, at + (size_t)i * (size_t)d,
                                        data->points.at + (size_t)i * (size_t)d);
        const double from =
            bat_max(times * median_of(data->points.count, distances, data->weights,
                                      batten_curve_point_count(curve), copy),
                    ROUNDINGS * bat_largest(data->points.count * d, data->points.at));
        *outlier_count = 0;
        for (int i = 0; i < data->points.count; i++)
            if ((!data->weights || data->weights[i] > 0) && distances[i] > from)
                outliers[(*outlier_count)++] = i;
        if (distance)
            *distance = from;
    }
    bat_release(copy);
    bat_release(distances);
    bat_release(at);
    return status;
}
