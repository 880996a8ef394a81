/* Curves within a tolerance of points: corners, the pieces between them, the report. */
#include "numeric/vector.h"
#include "shape/near/corners.h"
#include "shape/near/within_many.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <string.h>

batten_curve_within_options batten_curve_within_defaults(void)
{
    return (batten_curve_within_options){
        .size = sizeof(batten_curve_within_options), .degree = 3, .parameters = BATTEN_CHORD};
}

/* ---- the row ---- */

/* Turned so that a closed row with corners begins at its first one, and ends there again. */
static batten_status take_row(bat_within_fit *t)
{
    const batten_curve_within_options *o = t->options;
    const int n = t->count;
    const size_t d = (size_t)t->dimension;
    const bool turned = o->closed && t->corner_count > 0;
    double *at = bat_array((size_t)n + 1, sizeof *at);
    t->row = bat_array3((size_t)n + 1, d, sizeof *t->row);
    t->parameters = bat_array((size_t)n + 1, sizeof *t->parameters);
    t->pieces = bat_array((size_t)n + 1, sizeof(batten_curve *));
    t->bows = bat_array((size_t)n + 1, sizeof *t->bows);
    batten_status status = at && t->row && t->parameters && t->pieces && t->bows
                               ? BATTEN_OK
                               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_fit_parameters(t->dimension, n, t->points, o->parameters, o->given,
                                    o->closed, at);
    while (turned && !t->corner[t->first])
        t->first++;
    t->row_count = n + turned;
    for (int i = 0; status == BATTEN_OK && i <= n; i++) {
        const int from = t->first + i, whole = from >= n && o->closed;
        memcpy(t->row + d * (size_t)i, t->points + d * (size_t)(from % n), d * sizeof *t->row);
        if (i < n || o->closed)
            t->parameters[i] = at[from - n * whole] + (whole ? at[n] - at[0] : 0);
    }
    bat_release(at);
    return status;
}

/* ---- pieces ---- */

/* How far from their chord places between datum i and the next are. */
enum { PLACES = 4 };

static double between(int d, const double *p, const double *places)
{
    double largest = 0;
    for (int k = 0; k < PLACES; k++) {
        const double *at = places + k * d, s = (k + 1.0) / (PLACES + 1);
        largest = bat_max(largest, d == 1 ? fabs(*at - p[0] - s * (p[1] - p[0]))
                                          : bat_segment_distance(d, p, p + d, at));
    }
    return largest;
}

/* By how much the polygon turns at a datum of the row: radians, of a function in slopes. */
static double turn_of_row(const bat_within_fit *t, int i)
{
    const int d = t->dimension;
    const double *p = t->row + (size_t)i * (size_t)d, *u = t->parameters + i;
    if (d == 1)
        return fabs((p[1] - p[0]) / (u[1] - u[0]) - (p[0] - p[-1]) / (u[0] - u[-1]));
    double before[3], after[3];
    for (int k = 0; k < d; k++) {
        before[k] = p[k] - p[k - d];
        after[k] = p[k + d] - p[k];
    }
    const double cosine =
        bat_dot(d, before, after) / (bat_norm(d, before) * bat_norm(d, after));
    return bat_acos(bat_max(-1, bat_min(1, cosine)));
}

/* An arc that turns by an angle bows by an eighth of it and its chord; four times as much, and
 * the tolerance, is left to a curve. Where data coincide anything may be. */
static void find_bows(bat_within_fit *t)
{
    const int d = t->dimension,
              last =
                  t->row_count - 1 + (t->options->closed && !t->first && t->corner_count == 0);
    double before = 0;
    for (int i = 0; i < last; i++) {
        const double *p = t->row + (size_t)i * (size_t)d;
        const double after = i + 1 < last ? turn_of_row(t, i + 1) : before;
        const double chord =
            d == 1 ? t->parameters[i + 1] - t->parameters[i] : bat_distance(d, p, p + d);
        const double bow = chord * bat_max(i > 0 ? before : after, after) / 2;
        t->bows[i] = isfinite(bow) ? t->options->tolerance + bow : HUGE_VAL;
        before = after;
    }
}

/* Distances of the data; and where the curve leaves the polygon by more than it may, what is
 * too much on top of the tolerance. */
static batten_status measure_point_error(bat_within *w, const batten_curve *curve,
                                         const double *parameters, double *distances,
                                         double *max)
{
    const double *bows = w->bows;
    const size_t n = (size_t)w->count, d = (size_t)w->dimension, each = bows ? PLACES + 1 : 1;
    double *u = bat_array3(n, each, sizeof *u), *at = bat_array3(n * each, d, sizeof *at);
    batten_status status = u && at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < n; i++) {
        const bool ends = i == n - 1 && !w->periodic;
        const double step = ends ? 0 : (parameters[i + 1] - parameters[i]) / (double)each;
        for (size_t k = 0; k < each; k++)
            u[i * each + k] = parameters[i] + (double)k * step;
    }
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_many(curve, n * each, u, 0, NULL, at);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++)
        distances[i] = bat_distance(w->dimension, at + i * each * d, w->points + i * d);
    *max = 0;
    for (size_t i = 0; status == BATTEN_OK && bows && i < n; i++) {
        const bool ends = i == n - 1 && !w->periodic;
        const double off =
            ends ? 0 : between(w->dimension, w->points + i * d, at + (i * each + 1) * d);
        if (!ends && off > bows[i] + w->swing) {
            const size_t next = (i + 1) % n;
            const double over = w->tolerance + (off - bows[i] - w->swing);
            distances[i] = bat_max(distances[i], over);
            distances[next] = bat_max(distances[next], over);
        }
    }
    for (size_t i = 0; status == BATTEN_OK && i < n; i++)
        *max = bat_max(*max, distances[i]);
    bat_release(u);
    bat_release(at);
    return status;
}

/* The seam of a ring of even degree stands, like its other knots, between two data. */
static batten_interval domain_of(const bat_within_fit *t, int from, int to, bool periodic)
{
    const double *u = t->parameters;
    const double gap = periodic && t->options->degree % 2 == 0 ? (u[to + 1] - u[to]) / 2 : 0;
    return (batten_interval){u[from] - gap, u[periodic ? to + 1 : to] - gap};
}

/* Parameters move a few times in each of many fits, and once where each fit is dear; the last
 * ones have moved often. */
enum { CORRECTIONS = 4 };

static int corrections_of(int dimension, int count)
{
    return dimension == 1 ? 0 : count > BAT_WITHIN_MANY ? 1 : CORRECTIONS;
}

static batten_status search(bat_within *w, batten_within_method method)
{
    batten_status status = method == BATTEN_WITHIN_REMOVE ? BATTEN_OK : bat_within_insert(w);
    const bool done = method == BATTEN_WITHIN_INSERT ||
                      (method == BATTEN_WITHIN_FEWEST && w->count > BAT_WITHIN_MANY &&
                       w->error <= w->tolerance);
    return status == BATTEN_OK && !done ? bat_within_remove(w) : status;
}

static batten_status fit_piece(bat_within_fit *t, int from, int to, bool periodic,
                               batten_curve **out)
{
    const batten_curve_within_options *o = t->options;
    const size_t n = (size_t)(to - from) + 2;
    double *start = bat_array(n, sizeof *start), *parameters = bat_array(n, sizeof *parameters);
    bat_within w = {.dimension = t->dimension,
                    .degree = o->degree,
                    .periodic = periodic,
                    .corrections = corrections_of(t->dimension, to - from + 1),
                    .tolerance = o->tolerance,
                    .domain = domain_of(t, from, to, periodic),
                    .count = to - from + 1,
                    .points = t->row + (size_t)from * (size_t)t->dimension,
                    .start = start,
                    .parameters = parameters,
                    .best = t->parameters + from,
                    .measure = measure_point_error,
                    .context = t,
                    .bows = t->bows + from,
                    .error = HUGE_VAL,
                    .work = &t->work,
                    .done = {(double)from / t->row_count, (double)to / t->row_count}};
    batten_status status = start && parameters ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(start, w.best, (size_t)(w.count + periodic) * sizeof *start);
        status = search(&w, o->method);
    }
    t->fits += w.fits;
    if (status == BATTEN_OK && w.curve)
        *out = batten_curve_ref(w.curve);
    bat_within_end(&w);
    bat_release(start);
    bat_release(parameters);
    return status;
}

/* A piece of cubics ends when its pace brings it there: later ones begin and end as much later. */
static void shift_rest(bat_within_fit *t, int end, double by)
{
    for (int i = end + 1; i < t->row_count; i++)
        t->parameters[i] += by;
}

static batten_status make_piece(bat_within_fit *t, int from, int to, bool smooth_ring)
{
    const batten_curve_within_options *o = t->options;
    batten_curve **out = &t->pieces[t->piece_count];
    const double *a = t->parameters + from, end = a[to - from];
    if (!(end > a[0]))
        return bat_fail(BATTEN_COINCIDENT,
                        "between two corners all points from number %d on are one",
                        (t->first + from) % t->count + 1);
    const batten_status status =
        o->method == BATTEN_WITHIN_BEZIER
            ? bat_within_bezier(
                  &(bat_within_row){
                      .dimension = t->dimension,
                      .count = to - from + 1,
                      .closed = smooth_ring,
                      .points = t->row + (size_t)from * (size_t)t->dimension,
                      .tolerance = o->tolerance,
                      .work = &t->work,
                      .done = {(double)from / t->row_count, (double)to / t->row_count}},
                  t->parameters + from, out)
            : fit_piece(t, from, to, smooth_ring, out);
    t->piece_count += *out != NULL;
    shift_rest(t, to, t->parameters[to] - end);
    return status;
}

static batten_status make_pieces(bat_within_fit *t)
{
    const batten_curve_within_options *o = t->options;
    if (o->closed && t->corner_count == 0) {
        /* A ring of Bezier curves is a row that ends where it begins. */
        const bool bezier = o->method == BATTEN_WITHIN_BEZIER;
        t->row_count += bezier;
        return make_piece(t, 0, t->row_count - 1, true);
    }
    batten_status status = BATTEN_OK;
    for (int i = 1, from = 0; status == BATTEN_OK && i < t->row_count; i++) {
        const bool ends = i == t->row_count - 1 || t->corner[(t->first + i) % t->count];
        if (!ends)
            continue;
        status = make_piece(t, from, i, false);
        from = i;
    }
    return status;
}

/* ---- what came out ---- */

/* The largest distance of the curve from the polygon of the data. */
static batten_status measure_between(const bat_within_fit *t, double *apart)
{
    const int d = t->dimension;
    double at[PLACES * 3], u[PLACES];
    *apart = 0;
    for (int i = 0; i + 1 < t->row_count; i++) {
        const double a = t->parameters[i], b = t->parameters[i + 1];
        for (int k = 0; k < PLACES; k++)
            u[k] = a + (k + 1.0) / (PLACES + 1) * (b - a);
        const batten_status status =
            batten_curve_evaluate_many(t->curve, PLACES, u, 0, NULL, at);
        if (status != BATTEN_OK)
            return status;
        *apart = bat_max(*apart, between(d, t->row + (size_t)i * (size_t)d, at));
    }
    return BATTEN_OK;
}

static batten_status check_result(bat_within_fit *t, double *parameters,
                                  batten_curve_within_report *report)
{
    const int d = t->dimension;
    double squares = 0;
    const int n = batten_curve_point_count(t->curve);
    *report = (batten_curve_within_report){
        .points = batten_curve_is_periodic(t->curve) ? n - batten_curve_degree(t->curve) : n,
        .corners = t->corner_count,
        .fits = t->fits};
    for (int i = 0; i < t->count; i++) {
        const int k = (i - t->first + t->count) % t->count;
        double at[3];
        const batten_status status = batten_curve_evaluate(t->curve, t->parameters[k], 0, at);
        if (status != BATTEN_OK)
            return status;
        const double distance = bat_distance(d, at, t->points + (size_t)i * (size_t)d);
        parameters[i] = t->parameters[k];
        squares += distance * distance;
        if (distance > report->error) {
            report->error = distance;
            report->worst = i;
        }
    }
    report->rms = sqrt(squares / t->count);
    if (!(report->error <= t->options->tolerance))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "the nearest curve that was found is %g away from point %d; the "
                        "tolerance is %g",
                        report->error, report->worst + 1, t->options->tolerance);
    return measure_between(t, &report->apart);
}

static batten_status search_within(bat_within_fit *t)
{
    batten_status status = bat_find_corners(t);
    if (status == BATTEN_OK)
        status = take_row(t);
    if (status == BATTEN_OK) {
        find_bows(t);
        status = make_pieces(t);
    }
    if (status == BATTEN_OK && t->piece_count == 0)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET, "no curve was found near the points");
    if (status == BATTEN_OK && t->piece_count == 1)
        t->curve = batten_curve_ref(t->pieces[0]);
    else if (status == BATTEN_OK)
        status = bat_curve_chained(t->piece_count, t->pieces, &t->curve);
    return status;
}

static batten_status check_within_data(int dimension, int count, const double *points,
                                       const batten_curve_within_options *o)
{
    const batten_status status = bat_points_check(dimension, count, points, 2);
    if (status != BATTEN_OK)
        return status;
    if (!(o->tolerance > 0 && isfinite(o->tolerance)))
        return bat_fail(isnan(o->tolerance) ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT,
                        "the tolerance is %g; it must be above 0", o->tolerance);
    if (o->degree < 1 || o->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", o->degree,
                        BATTEN_MAX_DEGREE);
    if ((int)o->method < 0 || o->method > BATTEN_WITHIN_BEZIER || (int)o->parameters < 0 ||
        o->parameters > BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown method %d or parametrization %d",
                        (int)o->method, (int)o->parameters);
    if (o->method == BATTEN_WITHIN_BEZIER && (dimension == 1 || o->degree != 3))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "Bezier pieces are cubics of the plane or space, not of degree %d in "
                        "dimension %d",
                        o->degree, dimension);
    if (dimension == 1 && (o->closed || o->corner != 0 || o->parameters != BATTEN_GIVEN))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a function needs its parameters, is not closed, and has no angles");
    if (!(o->corner >= 0) || o->corner_count < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "corners of %g radians, and %d corners", o->corner,
                        o->corner_count);
    return BATTEN_OK;
}

batten_status batten_curve_within(batten_points points,
                                  const batten_curve_within_options *options,
                                  double *parameters, batten_curve_within_report *report,
                                  batten_curve **out)
{
    assert(points.at && options && out);
    batten_curve_within_options chosen = batten_curve_within_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_within_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    bat_within_fit t = {.options = options,
                        .dimension = points.dimension,
                        .count = points.count,
                        .points = points.at,
                        .work = {.job = options->job}};
    batten_curve_within_report found = {0};
    status = check_within_data(points.dimension, points.count, points.at, options);
    if (status != BATTEN_OK)
        return status;
    double *at = bat_array((size_t)points.count, sizeof *at);
    status = at ? search_within(&t) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = check_result(&t, at, &found);
    if (status == BATTEN_OK) {
        *out = batten_curve_ref(t.curve);
        if (parameters)
            memcpy(parameters, at, (size_t)points.count * sizeof *at);
        if (report)
            *report = found;
    }
    batten_curve_unref(t.curve);
    for (int i = 0; i < t.piece_count; i++)
        batten_curve_unref(t.pieces[i]);
    bat_release(t.pieces);
    bat_release(t.corner);
    bat_release(t.row);
    bat_release(t.bows);
    bat_release(t.parameters);
    bat_release(at);
    return status;
}
