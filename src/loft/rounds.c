/*
 * The rounds of a lofting. A first patch is drawn to the points; then convex programs move it,
 * each about the patch of the one before it: feet, normals and the signs that cuts are to have.
 * Rounds that do not gain are taken back.
 */
#include "loft/rounds.h"
#include "base/work.h"
#include <batten/fair.h>

enum { ROUNDS = 10, ROUNDS_WITHOUT_GAIN = 4, FITS = 6 };

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

/* Where the patch is nearer to the centre plane than a bound it does not cross it. */
static batten_status add_side(const bat_loft *loft, bat_loft_program *p)
{
    bat_cut_tracer tracer;
    bat_loft_place place;
    const bat_loft_measure measure = {.weight[0][0] = 1, .vector = {0, -1, 0}};
    batten_status status = bat_cut_tracer_make(&loft->patch, SAMPLES_OF_SPAN, 0, &tracer);
    if (status != BATTEN_OK)
        return status;
    const bat_loft_grid *u = &tracer.along_u, *v = &tracer.along_v;
    for (int i = 0; i < u->along_count && status == BATTEN_OK; i++)
        for (int j = 0; j < v->along_count && status == BATTEN_OK; j++) {
            bat_loft_place_at(&loft->patch, u->along[i], v->along[j], &place);
            if (place.s[0][0][1] < loft->within)
                status = bat_loft_add_row(p, &place, &measure, place.s[0][0][1], HUGE_VAL);
        }
    bat_cut_tracer_free(&tracer);
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
    batten_status status = bat_loft_program_make(&loft->patch, loft->held, loft->within, &p);
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
static batten_status judge(bat_loft *loft, bat_loft_reached *r)
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
        if (cut->needed < 0)
            cut->needed = batten_polyline_inflections(count, plane, loft->within / 4);
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

static bool keeps_bounds(const bat_loft *loft, const bat_loft_reached *r)
{
    return r->moves.largest_part <= 1 && (!loft->one_side || r->lowest >= 0);
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

/* As smooth as lets the moves be a quarter of the bound in the mean: less would repeat the
 * rounding of the table, more would rest on the bounds and take volume away. */
static batten_status choose_smoothness(bat_loft *loft, bat_loft_reached *r)
{
    enum { TRIALS = 8 };
    double low = 1e-4, high = 1e4;
    const double wanted = 0.25 * loft->within;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < TRIALS && status == BATTEN_OK; k++) {
        loft->smooth = sqrt(low * high);
        status = move_patch(loft, FIT, HUGE_VAL, r);
        if (r->moves.rms < wanted)
            low = loft->smooth;
        else
            high = loft->smooth;
    }
    return status;
}

static batten_status fit(bat_loft *loft, bat_loft_reached *r)
{
    loft->smooth = 1;
    batten_status status = move_patch(loft, DRAW, HUGE_VAL, r);
    for (int k = 0; k < FITS && status == BATTEN_OK; k++)
        status = move_patch(loft, FIT, HUGE_VAL, r);
    return status;
}

batten_status bat_loft_fits(bat_loft *loft)
{
    bat_loft_reached reached = {0};
    const batten_status status = fit(loft, &reached);
    if (status != BATTEN_OK || reached.moves.largest_part <= 1)
        return status;
    return bat_fail(BATTEN_NOT_COMPATIBLE, "the bounds are exceeded to %g of them",
                    reached.moves.largest_part);
}

static batten_status find_start(bat_loft *loft, bat_loft_reached *r)
{
    batten_status status = fit(loft, r);
    if (status == BATTEN_OK)
        status = choose_smoothness(loft, r);
    return status == BATTEN_OK ? judge(loft, r) : status;
}

static batten_status improve(bat_loft *loft, double *best, bat_loft_reached *best_reached)
{
    const size_t bytes =
        3 * (size_t)loft->patch.nu * (size_t)loft->patch.nv * sizeof *loft->patch.points;
    bat_loft_reached r = *best_reached;
    bat_work work = {.job = loft->job};
    double trust = 3 * loft->within; /* the first variation of curvature holds so far */
    batten_status status = BATTEN_OK;
    for (int k = 1, gain = 0;
         k <= ROUNDS && k <= gain + ROUNDS_WITHOUT_GAIN && !is_done(loft, best_reached); k++) {
        status = bat_work_step(&work, 1, (double)k / ROUNDS, "lofting");
        shape_cuts(loft);
        if (status == BATTEN_OK)
            status = move_patch(loft, SHAPE, trust, &r);
        if (status == BATTEN_OK)
            status = judge(loft, &r);
        if (status != BATTEN_OK)
            return status;
        r.rounds = k;
        if (is_better(loft, &r, best_reached)) {
            memcpy(best, loft->patch.points, bytes);
            *best_reached = r;
            gain = k;
        } else if (k > 2) {
            trust *= 0.7;
        }
    }
    return status;
}

batten_status bat_loft_run(bat_loft *loft, bat_loft_reached *reached)
{
    const size_t numbers = 3 * (size_t)loft->patch.nu * (size_t)loft->patch.nv;
    bat_loft_reached r = {0};
    double *best = bat_array(numbers, sizeof *best);
    batten_status status = best ? find_start(loft, &r) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(best, loft->patch.points, numbers * sizeof *best);
        status = improve(loft, best, &r);
    }
    if (status == BATTEN_OK) {
        memcpy(loft->patch.points, best, numbers * sizeof *best);
        bat_loft_find_feet(&loft->patch, loft->datum_count, loft->data, &r.moves);
        status = judge(loft, &r);
    }
    if (status == BATTEN_OK && !keeps_bounds(loft, &r))
        status = bat_fail(BATTEN_NOT_COMPATIBLE,
                          "the bounds are exceeded to %g of them; the least y is %g",
                          r.moves.largest_part, r.lowest);
    if (status == BATTEN_OK)
        *reached = r;
    bat_release(best);
    return status;
}
