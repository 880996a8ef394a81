/*
 * The rounds of a lofting. A first patch is drawn to the points; then convex programs move it,
 * each about the patch of the one before it: feet, normals and the signs that cuts are to have.
 * Rounds that do not gain are taken back.
 */
#include "loft/rounds.h"
#include "base/work.h"
#include "loft/outline.h"
#include <batten/fair.h>

enum { ROUNDS = 10, ROUNDS_WITHOUT_GAIN = 4, FITS = 6, FITS_OF_GRAPH = 1, MOST_FITS = 10 };

/* Samples of cuts: in a span where they follow the parameters; else, and where they are short,
 * over the whole; and where they are judged. */
enum { SAMPLES_OF_SPAN = 4, SAMPLES_ALONG = 401, SHORT = 20, SAMPLES_JUDGED = 241 };

/* What a wrong sign costs, of a normed row and an objective of unit size: so much that a row
 * yields only where the bounds leave no other way. */
static const double price_of_sign = 30;

/* ---- the program of a round ---- */

static bool follows_parameters(const bat_loft_cut *cut)
{
    return cut->kind == BAT_CUT_STATION || cut->kind == BAT_CUT_WATERLINE ||
           bat_cut_is_edge(cut);
}

/* Rows for the cuts that follow the parameters, sampled in their spans, and for the others; short
 * ones of the former count with these. */
static batten_status add_cuts(const bat_loft *loft, bat_loft_program *p)
{
    bat_cut_tracer spans, even = {0};
    batten_status status = bat_cut_tracer_make(&loft->patch, SAMPLES_OF_SPAN, 0, &spans);
    if (status != BATTEN_OK)
        return status;
    status = bat_cut_tracer_make(&loft->patch, 0, SAMPLES_ALONG, &even);
    for (int k = 0; k < loft->cut_count && status == BATTEN_OK; k++) {
        const bat_loft_cut *cut = loft->cuts + k;
        if (!cut->shaped)
            continue;
        bat_cut_tracer *tracer = follows_parameters(cut) ? &spans : &even;
        bat_cut_find(tracer, cut);
        if (tracer->trace.count < SHORT) {
            tracer = &even;
            bat_cut_find(tracer, cut);
        }
        status = bat_loft_add_signs(p, cut, &tracer->trace, price_of_sign);
    }
    bat_cut_tracer_free(&spans);
    bat_cut_tracer_free(&even);
    return status;
}

/* At the places of a grid at which y is below a height the patch does not cross the centre plane. */
static batten_status add_side_of(const bat_loft *loft, const bat_loft_grid *grid, double below,
                                 bat_loft_program *p)
{
    const bat_loft_measure measure = {.weight[0][0] = 1, .vector = {0, -1, 0}};
    batten_status status = BATTEN_OK;
    for (int i = 0; i < grid->along_count; i++)
        for (int j = 0; j < grid->across_count && status == BATTEN_OK; j++) {
            bat_loft_place place;
            if (grid->points[3 * (i * grid->across_count + j) + 1] >= below)
                continue;
            bat_loft_place_at(&loft->patch, grid->along[i], grid->across[j], &place);
            status = bat_loft_add_row(p, &place, &measure, place.s[0][0][1], HUGE_VAL);
        }
    return status;
}

/* Where the patch is nearer to the centre plane than a bound, at the samples of the spans; and
 * wherever it is beyond, at those by which it is judged. */
static batten_status add_side(const bat_loft *loft, bat_loft_program *p)
{
    bat_cut_tracer spans, judged = {0};
    batten_status status = bat_cut_tracer_make(&loft->patch, SAMPLES_OF_SPAN, 0, &spans);
    if (status != BATTEN_OK)
        return status;
    status = bat_cut_tracer_make(&loft->patch, 0, SAMPLES_JUDGED, &judged);
    if (status == BATTEN_OK)
        status = add_side_of(loft, &spans.along_u, loft->within, p);
    if (status == BATTEN_OK)
        status = add_side_of(loft, &judged.along_u, 0, p);
    bat_cut_tracer_free(&spans);
    bat_cut_tracer_free(&judged);
    return status;
}

static batten_status add_limits(const bat_loft *loft, bat_loft_program *p)
{
    const bat_loft_measure measure = {.weight[0][0] = 1, .vector = {0, 1, 0}};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < loft->limit_count && status == BATTEN_OK; k++) {
        const bat_loft_limit *limit = loft->limits + k;
        bat_loft_place place;
        bat_loft_place_at(&loft->patch, limit->u, limit->v, &place);
        status =
            bat_loft_add_row(p, &place, &measure, limit->most - place.s[0][0][1], HUGE_VAL);
    }
    return status;
}

static batten_status add_rows(const bat_loft *loft, bool signs, double trust,
                              bat_loft_program *p)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < loft->datum_count && status == BATTEN_OK; k++)
        status = bat_loft_add_datum(p, loft->data + k);
    if (status == BATTEN_OK && signs)
        status = add_cuts(loft, p);
    if (status == BATTEN_OK)
        status = add_limits(loft, p);
    if (status == BATTEN_OK)
        status = bat_loft_add_stems(loft, p);
    if (status == BATTEN_OK && loft->one_side)
        status = add_side(loft, p);
    if (status == BATTEN_OK && trust < HUGE_VAL)
        status = bat_loft_limit_moves(p, trust);
    return status;
}

typedef enum { DRAW, FIT, SHAPE } step_kind;

static batten_status move_patch(bat_loft *loft, step_kind kind, double trust,
                                bat_loft_reached *r)
{
    bat_loft_program p;
    bat_convex_report report;
    bat_work work = {.job = loft->job};
    batten_status status = bat_work_step(&work, 1, 0, "lofting");
    if (status == BATTEN_OK)
        status = bat_loft_program_make(&loft->patch, loft->held, loft->within, &p);
    if (status != BATTEN_OK)
        return status;
    status = bat_loft_add_energy(&p, loft->smooth / (loft->breadth * loft->breadth));
    for (int k = 0; k < loft->datum_count && kind == DRAW; k++)
        bat_loft_attract_datum(&p, loft->data + k);
    if (status == BATTEN_OK && kind != DRAW)
        status = add_rows(loft, kind == SHAPE, trust, &p);
    if (status == BATTEN_OK)
        status = bat_loft_program_move(&p, loft->patch.points, &r->slack, &report);
    bat_loft_program_free(&p);
    if (status == BATTEN_OK)
        bat_loft_find_feet(&loft->patch, loft->datum_count, loft->data, &r->moves);
    return status;
}

/* ---- judging ---- */

/* The inflections of each cut; where the points do not say how many are needed, those that the
 * patch has before its signs are shaped, of bulges above a quarter of the bound. */
batten_status bat_loft_judge(bat_loft *loft, bat_loft_reached *r)
{
    bat_cut_tracer tracer;
    batten_status status = bat_cut_tracer_make(&loft->patch, 0, SAMPLES_JUDGED, &tracer);
    if (status != BATTEN_OK)
        return status;
    r->excess = r->cuts_in_excess = 0;
    r->lowest = HUGE_VAL;
    for (int k = 0; k < tracer.along_u.along_count * tracer.along_u.across_count; k++)
        r->lowest = bat_min(r->lowest, tracer.along_u.points[3 * k + 1]);
    for (int k = 0; k < loft->cut_count; k++) {
        bat_loft_cut *cut = loft->cuts + k;
        bat_cut_find(&tracer, cut);
        const int count = tracer.trace.count;
        const double *plane = tracer.trace.plane;
        if (cut->needed < 0) {
            cut->is_asked = true;
            cut->needed = batten_polyline_inflections(count, plane, loft->within / 4);
        }
        cut->found = batten_polyline_inflections(count, plane, loft->height);
        r->excess += bat_max_int(0, cut->found - cut->needed);
        r->cuts_in_excess += cut->found > cut->needed;
    }
    bat_cut_tracer_free(&tracer);
    return bat_loft_energy(&loft->patch, &r->energy);
}

static void shape_cuts(bat_loft *loft)
{
    for (int k = 0; k < loft->cut_count; k++)
        if (follows_parameters(loft->cuts + k) || loft->cuts[k].found > loft->cuts[k].needed)
            loft->cuts[k].shaped = true;
}

/* ---- rounds ---- */

/* Beyond the centre plane by no more than what is seen of a bulge. */
static bool keeps_bounds(const bat_loft *loft, const bat_loft_reached *r)
{
    return r->moves.largest_part <= 1 && r->lowest > -HUGE_VAL &&
           (!loft->one_side || r->lowest >= -loft->height);
}

/* Better: nearer to what must hold, then fewer inflections. */
static bool is_better(const bat_loft *loft, const bat_loft_reached *a,
                      const bat_loft_reached *b)
{
    const bool keeps_a = keeps_bounds(loft, a), keeps_b = keeps_bounds(loft, b);
    if (keeps_a != keeps_b)
        return keeps_a;
    if (!keeps_a)
        return a->moves.largest_part < b->moves.largest_part;
    return a->excess < b->excess;
}

static bool is_done(const bat_loft *loft, const bat_loft_reached *r)
{
    return r->excess == 0 && keeps_bounds(loft, r);
}

/* The patch and the feet of its data, to return to. */
typedef struct {
    double *points;
    bat_loft_datum *data;
} kept_patch;

static size_t number_count(const bat_loft *loft)
{
    return 3 * (size_t)loft->patch.nu * (size_t)loft->patch.nv;
}

static void keep_patch(const bat_loft *loft, kept_patch *kept)
{
    memcpy(kept->points, loft->patch.points, number_count(loft) * sizeof *kept->points);
    memcpy(kept->data, loft->data, (size_t)loft->datum_count * sizeof *kept->data);
}

static void return_to(const kept_patch *kept, bat_loft *loft)
{
    memcpy(loft->patch.points, kept->points, number_count(loft) * sizeof *kept->points);
    memcpy(loft->data, kept->data, (size_t)loft->datum_count * sizeof *kept->data);
}

/* As smooth as lets the moves be a quarter of the bound in the mean: less would repeat the
 * rounding of the table, more would rest on the bounds and take volume away. Each trial begins at
 * the best that kept the bounds. */
static batten_status choose_smoothness(bat_loft *loft, kept_patch *kept, bat_loft_reached *r)
{
    enum { TRIALS = 6 };
    double low = 1e-3, high = 1e3, best = loft->smooth;
    const double wanted = 0.25 * loft->within;
    for (int k = 0; k < TRIALS; k++) {
        loft->smooth = sqrt(low * high);
        batten_status status = move_patch(loft, FIT, 3 * loft->within, r);
        if (status == BATTEN_OK && r->moves.largest_part <= 1)
            status = bat_loft_judge(loft, r);
        if (status != BATTEN_OK && status != BATTEN_NOT_COMPATIBLE)
            return status;
        const bool keeps = status == BATTEN_OK && keeps_bounds(loft, r);
        if (keeps && r->moves.rms < wanted)
            low = loft->smooth;
        else
            high = loft->smooth;
        if (keeps) {
            keep_patch(loft, kept);
            best = loft->smooth;
        } else {
            return_to(kept, loft);
        }
    }
    loft->smooth = best;
    return BATTEN_OK;
}

/* Drawn to the points and fitted; when a few steps have not kept the bounds, with moves that
 * normals and feet can follow. */
static batten_status fit_as_smooth(bat_loft *loft, double smooth, bat_loft_reached *r)
{
    /* Of a graph the rows are linear but for its feet. */
    const int fits = loft->is_graph ? FITS_OF_GRAPH : FITS;
    loft->smooth = smooth;
    batten_status status = move_patch(loft, DRAW, HUGE_VAL, r);
    for (int k = 0; k < MOST_FITS && status == BATTEN_OK; k++) {
        const double far = bat_max(3 * loft->within, r->moves.largest);
        status = move_patch(loft, FIT, k < fits ? HUGE_VAL : far, r);
        r->lowest = -HUGE_VAL; /* not known */
        if (status == BATTEN_OK && k >= fits && r->moves.largest_part <= 1)
            status = bat_loft_judge(loft, r);
        if (status == BATTEN_OK && keeps_bounds(loft, r))
            break;
    }
    return status;
}

/* The feet settle from one smoothness where they wander from another. */
static batten_status fit(bat_loft *loft, bat_loft_reached *r)
{
    static const double smooth[] = {1, 100, 0.01};
    batten_status status = BATTEN_NOT_COMPATIBLE;
    for (int k = 0; k < 3; k++) {
        status = fit_as_smooth(loft, smooth[k], r);
        if (status == BATTEN_OK ? keeps_bounds(loft, r) : status != BATTEN_NOT_COMPATIBLE)
            break;
    }
    return status;
}

static batten_status refuse_bounds(const bat_loft_reached *r)
{
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "the bounds are exceeded to %g of them; the least y is %g",
                    r->moves.largest_part, r->lowest);
}

batten_status bat_loft_fits(bat_loft *loft)
{
    bat_loft_reached reached = {0};
    const batten_status status = fit_as_smooth(loft, 1, &reached);
    return status != BATTEN_OK || keeps_bounds(loft, &reached) ? status
                                                               : refuse_bounds(&reached);
}

/* A patch that keeps the bounds, or none is sought any further. */
static batten_status find_start(bat_loft *loft, kept_patch *kept, bat_loft_reached *r)
{
    batten_status status = fit(loft, r);
    if (status == BATTEN_OK && !keeps_bounds(loft, r))
        return refuse_bounds(r);
    keep_patch(loft, kept);
    if (status == BATTEN_OK)
        status = choose_smoothness(loft, kept, r);
    if (status != BATTEN_OK)
        return status;
    return_to(kept, loft);
    bat_loft_find_feet(&loft->patch, loft->datum_count, loft->data, &r->moves);
    for (int k = 0; k < loft->cut_count; k++)
        if (loft->cuts[k].is_asked)
            loft->cuts[k].needed = -1;
    return bat_loft_judge(loft, r);
}

static batten_status improve(bat_loft *loft, kept_patch *best, bat_loft_reached *best_reached)
{
    bat_loft_reached r = *best_reached;
    double trust = 3 * loft->within; /* the first variation of curvature holds so far */
    batten_status status = BATTEN_OK;
    for (int k = 1, gain = 0; status == BATTEN_OK && k <= ROUNDS &&
                              k <= gain + ROUNDS_WITHOUT_GAIN && !is_done(loft, best_reached);
         k++) {
        shape_cuts(loft);
        status = move_patch(loft, SHAPE, trust, &r);
        if (status == BATTEN_NOT_COMPATIBLE) /* what was reached before stays */
            return BATTEN_OK;
        if (status == BATTEN_OK)
            status = bat_loft_judge(loft, &r);
        r.rounds = k;
        if (status == BATTEN_OK && is_better(loft, &r, best_reached)) {
            keep_patch(loft, best);
            *best_reached = r;
            gain = k;
        } else if (k > 2) {
            trust *= 0.7;
        }
    }
    return status;
}

static batten_status loft_patch(bat_loft *loft, kept_patch *best, bat_loft_reached *r)
{
    batten_status status = find_start(loft, best, r);
    if (status == BATTEN_OK)
        status = improve(loft, best, r);
    if (status != BATTEN_OK)
        return status;
    return_to(best, loft);
    bat_loft_find_feet(&loft->patch, loft->datum_count, loft->data, &r->moves);
    status = bat_loft_judge(loft, r);
    return status == BATTEN_OK && !keeps_bounds(loft, r) ? refuse_bounds(r) : status;
}

batten_status bat_loft_run(bat_loft *loft, bat_loft_reached *reached)
{
    bat_loft_reached r = {0};
    kept_patch best = {bat_array(number_count(loft), sizeof *best.points),
                       bat_array((size_t)loft->datum_count, sizeof *best.data)};
    const batten_status status =
        best.points && best.data ? loft_patch(loft, &best, &r) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        *reached = r;
    bat_release(best.points);
    bat_release(best.data);
    return status;
}
