#include "numeric/vector.h"
#include "shape/dbhs.h"
#include <batten/cubic.h>
#include <batten/cubic_spline.h>

#include <string.h>

/* ---- limits ---- */

batten_status batten_tangent_limits(double chord, double alpha, double beta, double *start,
                                    double *end)
{
    const double turn = fabs(alpha + beta), pi = 3.14159265358979323846;
    if (!isfinite(chord) || !isfinite(alpha) || !isfinite(beta))
        return bat_fail(BATTEN_NOT_FINITE, "chord %g, angles %g and %g: all must be finite",
                        chord, alpha, beta);
    if (!(chord > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a chord of length %g", chord);
    if (!(alpha * beta > 0) || turn >= pi)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "turning by %g and %g there is no simple arc: both must turn to one "
                        "side, by less than pi together",
                        alpha, beta);
    *start = 3 * chord * fabs(sin(beta)) / sin(turn);
    *end = 3 * chord * fabs(sin(alpha)) / sin(turn);
    return BATTEN_OK;
}

batten_correct_options batten_correct_defaults(void)
{
    return (batten_correct_options){
        .size = sizeof(batten_correct_options), .within = 0.95, .tolerance = 1e-9};
}

/* ---- at work ---- */

typedef struct {
    batten_correct_options options;
    int dimension, count;
    bool closed;    /* the last span joins the first */
    double *points; /* [3 count + 1][d] */
    double *breaks; /* [count + 1] */
    int *changed;   /* [count] */
    double *legs;   /* [count][2] lengths of the tangents as they were given */
    double *jumps;  /* [count] of curvature at the start of each span, as they were given */
    batten_cubic *spans;
    batten_correct_report report;
} work;

static double *point(const work *w, int index)
{
    return w->points + (size_t)index * (size_t)w->dimension;
}

/* Scale the leg from point `foot` to point `tip`. */
static void scale_leg(const work *w, int foot, int tip, double factor)
{
    for (int k = 0; k < w->dimension; k++)
        point(w, tip)[k] = point(w, foot)[k] + factor * (point(w, tip)[k] - point(w, foot)[k]);
}

static bool is_bad(batten_cubic_region region)
{
    return region != BATTEN_REGION_REGULAR && region != BATTEN_REGION_S_SHAPED;
}

/* Bring one span into its good region; false when that cannot be. */
static bool correct_span(work *w, int i)
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

static void correct_spans(work *w)
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

/* Signed curvature of span i at its start (0) or end (1); NaN where a leg is 0. */
static double curvature(const work *w, int i, int end)
{
    const double *a = point(w, end ? 3 * i + 3 : 3 * i);
    const double *b = point(w, end ? 3 * i + 2 : 3 * i + 1);
    const double *c = point(w, end ? 3 * i + 1 : 3 * i + 2);
    const double leg[2] = {b[0] - a[0], b[1] - a[1]}, next[2] = {c[0] - b[0], c[1] - b[1]};
    const double length = bat_norm(2, leg);
    const double cross = leg[0] * next[1] - leg[1] * next[0];
    return (end ? -1 : 1) * 2 * cross / (3 * length * length * length);
}

/* How much curvature jumps at join j, of the larger one; the seam is join 0. */
static double jump(const work *w, int j)
{
    if (j == 0 && !w->closed)
        return 0;
    const double left = curvature(w, j == 0 ? w->count - 1 : j - 1, 1),
                 right = curvature(w, j, 0);
    const double larger = bat_max(fabs(left), fabs(right));
    return larger > 0 ? fabs(left - right) / larger : isnan(left + right) ? (double)NAN : 0;
}

/* Legs below this part of the way to T bend as sharply as what they are to cure. */
static const double shortest = 0.1;

/* Set the legs of span i such that its end curvatures are these, if it stays without excess. */
static bool set_curvatures(work *w, int i, double start, double end)
{
    const double *p0 = point(w, 3 * i), *p3 = point(w, 3 * i + 3);
    double *p1 = point(w, 3 * i + 1), *p2 = point(w, 3 * i + 2);
    const double chord[2] = {p3[0] - p0[0], p3[1] - p0[1]};
    double t0[2] = {p1[0] - p0[0], p1[1] - p0[1]}, t1[2] = {p3[0] - p2[0], p3[1] - p2[1]};
    const double a = bat_norm(2, t0), b = bat_norm(2, t1);
    bat_legs legs[BAT_DBHS_SOLUTIONS];
    if (!(a > 0) || !(b > 0))
        return false;
    for (int k = 0; k < 2; k++) {
        t0[k] /= a;
        t1[k] /= b;
    }
    const int count = bat_dbhs(t0, t1, chord, start, end, legs);
    for (int s = 0; s < count; s++) {
        batten_cubic_place place;
        const batten_cubic *c = &w->spans[i];
        /* lambda and mu are proportional to the legs; as given they were these */
        const double lambda = c->lambda * legs[s].start / w->legs[2 * i];
        const double mu = c->mu * legs[s].end / w->legs[2 * i + 1];
        if (!c->has_tangents || batten_cubic_look_up(lambda, mu, &place) != BATTEN_OK ||
            is_bad(place.region) || fmin(fabs(lambda), fabs(mu)) < shortest)
            continue;
        for (int k = 0; k < 2; k++) {
            p1[k] = p0[k] + legs[s].start * t0[k];
            p2[k] = p3[k] - legs[s].end * t1[k];
        }
        return true;
    }
    return false;
}

static int before_join(const work *w, int j)
{
    return j == 0 ? w->count - 1 : j - 1;
}

/* The curvature that a corrected span should have at one end: that of its neighbour, or the
 * mean when that was corrected too; its own at a free end. */
static double wanted(const work *w, int i, int end)
{
    const double own = curvature(w, i, end);
    const int join = end ? (i + 1) % w->count : i;
    if (join == 0 && !w->closed)
        return own;
    const int other = end ? join : before_join(w, join);
    const double theirs = curvature(w, other, !end);
    return w->changed[other] ? (own + theirs) / 2 : theirs;
}

/* Let a span that was not corrected follow its neighbour at one end. */
static void follow(work *w, int i, int end, double curvature_there)
{
    const double kept = curvature(w, i, !end);
    if (w->changed[i])
        return;
    if (set_curvatures(w, i, end ? kept : curvature_there, end ? curvature_there : kept))
        w->changed[i] = 2;
}

static const double agree = 1e-6; /* of the larger curvature: what the header promises */

static batten_status restore_curvatures(work *w)
{
    double *targets = bat_array((size_t)w->count * 2, sizeof *targets);
    if (!targets)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < w->count; i++)
        for (int end = 0; end < 2; end++)
            targets[2 * i + end] = wanted(w, i, end);
    for (int i = 0; i < w->count; i++)
        if (w->changed[i] == 1)
            set_curvatures(w, i, targets[2 * i], targets[2 * i + 1]);
    bat_release(targets);
    for (int j = w->closed ? 0 : 1; j < w->count; j++) {
        const int left = before_join(w, j);
        if (jump(w, j) <= agree || left == j)
            continue;
        if (w->changed[left] == 1)
            follow(w, j, 0, curvature(w, left, 1));
        else if (w->changed[j] == 1)
            follow(w, left, 1, curvature(w, j, 0));
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

static void note_shape(work *w)
{
    for (int i = 0; i < w->count; i++) {
        w->legs[2 * i] = bat_distance(w->dimension, point(w, 3 * i), point(w, 3 * i + 1));
        w->legs[2 * i + 1] =
            bat_distance(w->dimension, point(w, 3 * i + 3), point(w, 3 * i + 2));
        w->jumps[i] = w->dimension == 2 ? jump(w, i) : 0;
    }
}

static void count_joins(work *w, const double *corrected)
{
    for (int j = w->closed ? 0 : 1; j < w->count && w->dimension == 2; j++) {
        const double now = jump(w, j);
        w->report.broken += !(now <= agree) && w->jumps[j] <= agree;
        w->report.rejoined += now <= agree && !(corrected[j] <= agree);
    }
}

static batten_status correct(work *w)
{
    double *corrected = bat_array((size_t)w->count, sizeof *corrected);
    batten_status status = corrected ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        note_shape(w);
        correct_spans(w);
        for (int j = 0; j < w->count && w->dimension == 2; j++)
            corrected[j] = jump(w, j);
        if (w->options.joins == BATTEN_CORRECT_CURVATURE && w->report.corrected > 0)
            status = restore_curvatures(w);
    }
    if (status == BATTEN_OK)
        count_joins(w, corrected);
    bat_release(corrected);
    return status;
}

static batten_status check(const batten_curve *curve, const batten_correct_options *o)
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

static batten_status begin(work *w, const batten_curve *curve)
{
    batten_curve *cubic = NULL, *bezier = NULL;
    batten_status status =
        batten_curve_classify(curve, w->options.tolerance, &w->count, &w->spans);
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
        w->jumps = bat_array(n, sizeof *w->jumps);
        if (!w->points || !w->breaks || !w->changed || !w->legs || !w->jumps)
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

static batten_status hand_over(const work *w, const batten_curve *curve, int *changed,
                               batten_correct_report *report, batten_curve **out)
{
    batten_status status = BATTEN_OK;
    if (w->report.corrected == 0)
        *out = batten_curve_ref(curve);
    else
        status = batten_curve_from_bezier(w->dimension, 3, w->count, w->points, NULL, w->breaks,
                                          out);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; changed && i < w->count; i++)
        changed[i] = w->changed[i] != 0;
    if (report)
        *report = w->report;
    return BATTEN_OK;
}

batten_status batten_curve_correct_tangents(const batten_curve *curve,
                                            const batten_correct_options *options, int *changed,
                                            batten_correct_report *report, batten_curve **out)
{
    work w = {.options = options ? *options : batten_correct_defaults(),
              .dimension = batten_curve_dimension(curve),
              .closed = batten_curve_is_periodic(curve),
              .report = {.first_incurable = -1}};
    batten_status status = check(curve, &w.options);
    if (status == BATTEN_OK)
        status = begin(&w, curve);
    w.report.span_count = w.count;
    if (status == BATTEN_OK)
        status = correct(&w);
    if (status == BATTEN_OK)
        status = hand_over(&w, curve, changed, report, out);
    bat_release(w.points);
    bat_release(w.breaks);
    bat_release(w.changed);
    bat_release(w.legs);
    bat_release(w.jumps);
    bat_release(w.spans);
    return status;
}
