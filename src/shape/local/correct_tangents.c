/*
 * Cubic spans with a loop, a cusp or needless inflections, cured by shortening their end
 * tangents. Source: [SL] III.6.
 */
#include "shape/local/correct_tangents.h"
#include "numeric/vector.h"

#include <string.h>

/* ---- limits ---- */

batten_status batten_tangent_limits(double chord, double alpha, double beta, double *start,
                                    double *end)
{
    const double turn = fabs(alpha + beta);
    if (!isfinite(chord) || !isfinite(alpha) || !isfinite(beta))
        return bat_fail(BATTEN_NOT_FINITE, "chord %g, angles %g and %g: all must be finite",
                        chord, alpha, beta);
    if (!(chord > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a chord of length %g", chord);
    if (!(alpha * beta > 0) || turn >= BAT_PI)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "turning by %g and %g there is no simple arc: both must turn to one "
                        "side, by less than BAT_PI together",
                        alpha, beta);
    *start = 3 * chord * fabs(bat_sin(beta)) / bat_sin(turn);
    *end = 3 * chord * fabs(bat_sin(alpha)) / bat_sin(turn);
    return BATTEN_OK;
}

batten_curve_correct_tangents_options batten_curve_correct_tangents_defaults(void)
{
    return (batten_curve_correct_tangents_options){
        .size = sizeof(batten_curve_correct_tangents_options),
        .within = 0.95,
        .tolerance = 1e-9};
}

/* ---- at work ---- */

/* Scale the leg from point `foot` to point `tip`. */
static void scale_leg(const bat_correction *w, int foot, int tip, double factor)
{
    for (int k = 0; k < w->dimension; k++)
        bat_correction_point(w, tip)[k] =
            bat_correction_point(w, foot)[k] +
            factor * (bat_correction_point(w, tip)[k] - bat_correction_point(w, foot)[k]);
}

/* Bring one span into its good region; false when that cannot be. */
static bool correct_span(bat_correction *w, int i)
{
    const batten_cubic *c = &w->spans[i];
    const double most = 1 + w->options.tolerance;
    if (c->segment == BATTEN_CUBIC_RETRACED_LINE)
        return false;
    if (!c->has_tangents)
        return true;
    if (c->lambda < 0 && c->mu < 0)
        return false;
    if (c->lambda > most || (c->lambda > w->options.within && c->mu > most)) {
        scale_leg(w, 3 * i, 3 * i + 1, w->options.within / c->lambda);
        w->changed[i] = 1;
    }
    if (c->mu > most || (c->mu > w->options.within && c->lambda > most)) {
        scale_leg(w, 3 * i + 3, 3 * i + 2, w->options.within / c->mu);
        w->changed[i] = 1;
    }
    return true;
}

static void correct_spans(bat_correction *w)
{
    for (int i = 0; i < w->count; i++)
        if (correct_span(w, i)) {
            w->report.corrected += w->changed[i];
        } else {
            if (w->report.incurable++ == 0)
                w->report.first_incurable = i;
        }
}

/* ---- curvatures at the joins, in the plane ---- */

/* How much two curvatures differ, of the larger one. */
static double relative_difference(double left, double right)
{
    const double larger = bat_max(fabs(left), fabs(right));
    return larger > 0 ? fabs(left - right) / larger : isnan(left + right) ? (double)NAN : 0;
}

/* How much curvature jumps at join j; the seam is join 0. */
static double jump(const bat_correction *w, int j)
{
    if (j == 0 && !w->closed)
        return 0;
    return relative_difference(bat_correction_bend(w, bat_correction_before(w, j), 1),
                               bat_correction_bend(w, j, 0));
}

/* The same as it was given. */
static double given_jump(const bat_correction *w, int j)
{
    if (j == 0 && !w->closed)
        return 0;
    return relative_difference(w->bends[2 * bat_correction_before(w, j) + 1], w->bends[2 * j]);
}

/* ---- the whole ---- */

static void note_shape(bat_correction *w)
{
    for (int i = 0; i < w->count; i++) {
        w->legs[2 * i] = bat_distance(w->dimension, bat_correction_point(w, 3 * i),
                                      bat_correction_point(w, 3 * i + 1));
        w->legs[2 * i + 1] = bat_distance(w->dimension, bat_correction_point(w, 3 * i + 3),
                                          bat_correction_point(w, 3 * i + 2));
        for (int end = 0; end < 2; end++)
            w->bends[2 * i + end] = w->dimension == 2 ? bat_correction_bend(w, i, end) : 0;
    }
}

static void count_joins(bat_correction *w, const double *corrected)
{
    for (int j = w->closed ? 0 : 1; j < w->count && w->dimension == 2; j++) {
        const double now = jump(w, j);
        w->report.broken +=
            !(now <= bat_correction_agree) && given_jump(w, j) <= bat_correction_agree;
        w->report.rejoined +=
            now <= bat_correction_agree && !(corrected[j] <= bat_correction_agree);
    }
}

static batten_status correct(bat_correction *w)
{
    double *corrected = bat_array((size_t)w->count, sizeof *corrected);
    batten_status status = corrected ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        note_shape(w);
        correct_spans(w);
        for (int j = 0; j < w->count && w->dimension == 2; j++)
            corrected[j] = jump(w, j);
        if (w->options.joins == BATTEN_CORRECT_CURVATURE && w->report.corrected > 0)
            status = bat_correction_join(w);
    }
    if (status == BATTEN_OK)
        count_joins(w, corrected);
    bat_release(corrected);
    return status;
}

static batten_status check_correction(const batten_curve *curve,
                                      const batten_curve_correct_tangents_options *o)
{
    const int d = batten_curve_dimension(curve);
    if (d < 2)
        return bat_fail(BATTEN_UNSUPPORTED, "a function has no tangent lengths to correct");
    if (!(o->within > 0 && o->within < 1) || !(o->tolerance >= 0 && o->tolerance < 1))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "tangents are corrected to a part of %g, tolerance %g: the first must "
                        "be in (0, 1), the second in [0, 1)",
                        o->within, o->tolerance);
    if (o->joins == BATTEN_CORRECT_CURVATURE && d != 2)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "curvatures are brought together in the plane only");
    return BATTEN_OK;
}

static batten_status copy_pieces(bat_correction *w, const batten_curve *curve)
{
    batten_curve *cubic = NULL, *bezier = NULL;
    batten_cubics spans = {0, NULL};
    batten_status status = batten_curve_classify(curve, w->options.tolerance, &spans);
    w->count = spans.count;
    w->spans = spans.at;
    if (status == BATTEN_OK)
        status = batten_curve_elevate(curve, 3 - batten_curve_degree(curve), &cubic);
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(cubic, &bezier);
    const size_t n = (size_t)w->count, d = (size_t)w->dimension;
    if (status == BATTEN_OK) {
        w->points = bat_array3(3 * n + 1, d, sizeof *w->points);
        w->breaks = bat_array(n + 1, sizeof *w->breaks);
        w->changed = bat_array(n, sizeof *w->changed);
        w->legs = bat_array(2 * n, sizeof *w->legs);
        w->bends = bat_array(2 * n, sizeof *w->bends);
        if (!w->points || !w->breaks || !w->changed || !w->legs || !w->bends)
            status = BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        memcpy(w->points, batten_curve_points(bezier), (3 * n + 1) * d * sizeof *w->points);
        for (int i = 0; i <= w->count; i++)
            w->breaks[i] = i < w->count ? w->spans[i].from : w->spans[i - 1].to;
    }
    batten_curve_unref(bezier);
    batten_curve_unref(cubic);
    return status;
}

static batten_status make_corrected_curve(const bat_correction *w, const batten_curve *curve,
                                          int *changed,
                                          batten_curve_correct_tangents_report *report,
                                          batten_curve **out)
{
    batten_status status = BATTEN_OK;
    if (w->report.corrected == 0)
        *out = batten_curve_ref(curve);
    else
        status = batten_curve_from_bezier(w->dimension, (batten_pieces){3, w->count, w->breaks},
                                          w->points, NULL, out);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; changed && i < w->count; i++)
        changed[i] = w->changed[i] != 0;
    if (report)
        *report = w->report;
    return BATTEN_OK;
}

batten_status batten_curve_correct_tangents(
    const batten_curve *curve, const batten_curve_correct_tangents_options *options,
    int *changed, batten_curve_correct_tangents_report *report, batten_curve **out)
{
    batten_curve_correct_tangents_options chosen = batten_curve_correct_tangents_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_curve_correct_tangents_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_correction w = {.options = chosen,
                        .dimension = batten_curve_dimension(curve),
                        .closed = batten_curve_is_periodic(curve),
                        .report = {.first_incurable = -1}};
    status = check_correction(curve, &w.options);
    if (status == BATTEN_OK)
        status = copy_pieces(&w, curve);
    w.report.span_count = w.count;
    if (status == BATTEN_OK)
        status = correct(&w);
    if (status == BATTEN_OK)
        status = make_corrected_curve(&w, curve, changed, report, out);
    bat_release(w.points);
    bat_release(w.breaks);
    bat_release(w.changed);
    bat_release(w.legs);
    bat_release(w.bends);
    bat_release(w.spans);
    return status;
}
