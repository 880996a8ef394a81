/*
 * Few common knots for many curves.
 *
 * Sections that were faired one by one have knots of their own, and their union is a dense comb
 * of slivers. Here all are refitted, by least squares with their ends held, upon one vector: it
 * begins with the average of their own knots, or with none, gains the middles of the spans in
 * which some section is too far off, and loses every knot that is not needed. The better of the
 * two beginnings is kept. How far a section moved is bounded by the control points of the
 * difference on the common refinement, and that bound is what is compared with the tolerance.
 */
#include "shape/skin/common_knots_parts.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* ---- all sections upon a comb ---- */

static void forget_fits(bat_fitting *f)
{
    for (int k = 0; k < f->count; k++)
        bat_spline_free(&f->fitted[k]);
}

/* One step for each control point of each section. */
static uint64_t fit_steps(const bat_fitting *f, const bat_comb *c)
{
    return (uint64_t)f->count * (uint64_t)(c->inner + f->degree + 1);
}

static batten_status fit_all(bat_fitting *f, const bat_comb *c, double *worst)
{
    batten_status status = bat_work_step(f->work, fit_steps(f, c), 0.1, "common knots");
    *worst = 0;
    memset(f->error, 0, (size_t)(f->limit + 2) * sizeof *f->error);
    forget_fits(f);
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        status = bat_common_fit(f, k, c, &f->fitted[k]);
        if (status == BATTEN_OK)
            status = bat_common_deviation(f, &f->given[k], &f->fitted[k], f->error,
                                          &f->deviation[k]);
        *worst = bat_max(*worst, f->deviation[k]);
    }
    return status;
}

/* Do all sections keep the tolerance? The one that failed last is asked first. */
static batten_status all_keep(const bat_fitting *f, const bat_comb *c, int *suspect, bool *keep)
{
    batten_status status = BATTEN_OK;
    *keep = true;
    for (int i = 0; status == BATTEN_OK && *keep && i < f->count; i++) {
        const int k = (i + *suspect) % f->count;
        bat_spline fit = {0};
        double deviation = 0;
        status = bat_common_fit(f, k, c, &fit);
        if (status == BATTEN_OK)
            status = bat_common_deviation(f, &f->given[k], &fit, NULL, &deviation);
        bat_spline_free(&fit);
        if (!(deviation <= f->tolerance)) {
            *keep = false;
            *suspect = k;
        }
    }
    return status;
}

/* Halve the spans that are too far off, but for those that are sixteen times better than the
 * worst: a cubic gains that much by one halving. False when the comb is full. */
static bool add_knots(const bat_fitting *f, double worst, bat_comb *c)
{
    const double enough = bat_max(f->tolerance, worst / 16);
    const int inner = c->inner;
    for (int s = 0; f->symmetric && s < inner - s; s++)
        f->error[s] = f->error[inner - s] = bat_max(f->error[s], f->error[inner - s]);
    double *added = c->knots + c->capacity; /* scratch behind the knots */
    int count = 0;
    for (int s = 0; s <= inner; s++) {
        const double a = s > 0 ? c->knots[s - 1] : 0, b = s < inner ? c->knots[s] : 1;
        const double middle = a + (b - a) / 2;
        if (f->error[s] > enough && middle > a && middle < b)
            added[count++] = middle;
    }
    if (count == 0 || inner + count > f->limit)
        return false;
    for (int i = 0; i < count; i++)
        bat_comb_insert(c, added[i], false);
    if (f->symmetric)
        bat_comb_mirror(c);
    return true;
}

/* *met: the tolerance is kept with fewer knots than the exact union has. */
static batten_status grow_comb(bat_fitting *f, bat_comb *c, bool *met)
{
    for (;;) {
        double worst;
        const batten_status status = fit_all(f, c, &worst);
        *met = worst <= f->tolerance;
        if (status != BATTEN_OK || *met || !isfinite(worst) || !add_knots(f, worst, c))
            return status;
    }
}

/* Take out each knot that is not needed, twice over: what one leaves may free another. Of
 * symmetric curves two at once. */
static batten_status shrink(const bat_fitting *f, bat_comb *c, bat_comb *scratch)
{
    int suspect = 0;
    const int least = f->periodic ? f->degree : 0;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < (f->symmetric ? (c->inner + 1) / 2 : c->inner);) {
            bool keep = false;
            if (!c->held[i]) {
                bat_comb_copy(c, scratch);
                if (f->symmetric && c->inner - 1 - i > i)
                    bat_comb_remove(scratch, c->inner - 1 - i);
                bat_comb_remove(scratch, i);
                batten_status status =
                    bat_work_step(f->work, fit_steps(f, c),
                                  0.1 + 0.2 * (pass + (double)i / c->inner), "common knots");
                if (status == BATTEN_OK && scratch->inner >= least)
                    status = all_keep(f, scratch, &suspect, &keep);
                if (status != BATTEN_OK)
                    return status;
            }
            if (keep)
                bat_comb_copy(scratch, c);
            else
                i++;
        }
    return BATTEN_OK;
}

/* ---- the search ---- */

static int by_count(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Distinct inner knots. */
static int knot_places(const bat_spline *s)
{
    int places = 0;
    for (int i = s->degree + 1; i < s->count; i++)
        places += s->knots[i] != s->knots[i - 1];
    return places;
}

static batten_status median_knots(const bat_fitting *f, int *median)
{
    int *counts = bat_array((size_t)f->count, sizeof *counts);
    if (!counts)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < f->count; k++)
        counts[k] = knot_places(&f->given[k]);
    qsort(counts, (size_t)f->count, sizeof *counts, by_count);
    *median = counts[f->count / 2];
    bat_release(counts);
    return BATTEN_OK;
}

/* Try one beginning; *best is replaced when it needs fewer knots. */
static batten_status attempt(bat_fitting *f, int averaged, bat_comb *c, bat_comb *scratch,
                             bat_comb *best, bool *met)
{
    bool reached = false;
    c->inner = 0;
    if (!bat_comb_hold(f, c) || !bat_comb_corners(f, c))
        return BATTEN_OK;
    bat_comb_average(f, f->periodic ? bat_max_int(averaged, f->degree) : averaged, c);
    if (f->symmetric)
        bat_comb_mirror(c);
    batten_status status = grow_comb(f, c, &reached);
    if (status == BATTEN_OK && reached)
        status = shrink(f, c, scratch);
    if (status == BATTEN_OK && reached && (!*met || c->inner < best->inner)) {
        bat_comb_copy(c, best);
        *met = true;
    }
    return status;
}

/* Nothing but what must stand: no beginning leads to less. */
static bool is_least(const bat_comb *c)
{
    for (int i = 0; i < c->inner; i++)
        if (!c->held[i])
            return false;
    return true;
}

static batten_status search_comb(bat_fitting *f, bat_comb *best, bool *met)
{
    bat_comb c = {0}, scratch = {0};
    int median = 0;
    batten_status status = bat_comb_make(f->limit, &c);
    if (status == BATTEN_OK)
        status = bat_comb_make(f->limit, &scratch);
    if (status == BATTEN_OK)
        status = median_knots(f, &median);
    if (status == BATTEN_OK)
        status = attempt(f, 0, &c, &scratch, best, met);
    if (status == BATTEN_OK && !(*met && is_least(best)))
        status = attempt(f, median, &c, &scratch, best, met);
    bat_comb_free(&scratch);
    bat_comb_free(&c);
    return status;
}

/* ---- handing over ---- */

static batten_status to_curve(const bat_fitting *f, const bat_spline *s, batten_curve **out)
{
    const size_t n = (size_t)s->count, d = (size_t)f->dimension;
    double *points = bat_array3(n, d, sizeof *points);
    double *weights = bat_array(n, sizeof *weights);
    batten_status status = points && weights ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (size_t i = 0; i < n; i++) {
            const double *row = s->values + i * f->width;
            weights[i] = f->rational ? row[d] : 1;
            for (size_t c = 0; c < d; c++)
                points[i * d + c] = row[c] / weights[i];
        }
        status = batten_curve_create((batten_points){f->dimension, s->count, points}, s->degree,
                                     f->rational ? weights : NULL, s->knots, out);
    }
    bat_release(weights);
    bat_release(points);
    return status;
}

static batten_status hand_over_curves(bat_fitting *f, const bat_comb *best, batten_curve **out)
{
    double worst;
    batten_status status = fit_all(f, best, &worst);
    int made = 0;
    for (; status == BATTEN_OK && made < f->count; made++)
        status = f->periodic ? bat_common_ring_curve(f, made, best, &out[made])
                             : to_curve(f, &f->fitted[made], &out[made]);
    for (int k = 0; status != BATTEN_OK && k < made; k++) {
        batten_curve_unref(out[k]);
        out[k] = NULL;
    }
    return status;
}

/* The inner knots that the exact union can have at most. */
static int union_limit(const bat_fitting *f)
{
    double total = 0;
    for (int k = 0; k < f->count; k++)
        total += f->given[k].count - f->degree - 1;
    if (f->request->held_count > 0 || f->request->seam)
        total += f->request->held_count + 8;
    return (int)bat_min(total, 20000);
}

/* Has the exact union no more knots than these? Only asked when one section alone has as many.
 */
static batten_status prefer_exact(const bat_fitting *f, const batten_curve *const *sections,
                                  const bat_comb *best, bool *prefer)
{
    int most = 0;
    for (int k = 0; k < f->count; k++)
        most = bat_max_int(most, f->given[k].count - f->degree - 1);
    *prefer = false;
    if (best->inner < most || f->request->held_count > 0 || f->request->seam)
        return BATTEN_OK;
    batten_curve **unified = bat_array((size_t)f->count, sizeof *unified);
    if (!unified)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_curves_unify(f->count, sections, unified);
    if (status == BATTEN_OK)
        *prefer = batten_curve_point_count(unified[0]) - f->degree - 1 <= best->inner;
    for (int k = 0; k < f->count; k++)
        batten_curve_unref(unified[k]);
    bat_release(unified);
    return status == BATTEN_TOO_LARGE ? BATTEN_OK : status;
}

static batten_status find_common_knots(bat_fitting *f, const batten_curve *const *sections,
                                       bool *met, batten_curve **out)
{
    batten_status status = bat_common_take(f, sections);
    if (status == BATTEN_OK)
        status = bat_common_check_tolerance(f);
    if (status != BATTEN_OK)
        return status;
    bat_comb best = {0};
    /* Held knots stay to the bit, and need not be symmetric. */
    f->symmetric = f->request->held_count == 0 && !f->request->seam && bat_common_symmetry(f);
    f->limit = union_limit(f);
    f->error = bat_array((size_t)f->limit + 2, sizeof *f->error);
    status = f->error ? bat_comb_make(f->limit, &best) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = search_comb(f, &best, met);
    bool exact = false;
    if (status == BATTEN_OK && *met)
        status = prefer_exact(f, sections, &best, &exact);
    *met = *met && !exact;
    if (status == BATTEN_OK && *met)
        status = hand_over_curves(f, &best, out);
    bat_comb_free(&best);
    return status;
}

batten_status bat_common_knots(int count, const batten_curve *const *sections, double tolerance,
                               bat_work *work, batten_curve **out, double *deviation)
{
    const bat_common_request request = {.tolerance = tolerance};
    return bat_common_knots_held(count, sections, &request, work, out, deviation);
}

batten_status bat_common_knots_held(int count, const batten_curve *const *sections,
                                    const bat_common_request *request, bat_work *work,
                                    batten_curve **out, double *deviation)
{
    bat_fitting f = {.count = count,
                     .tolerance = request->tolerance,
                     .request = request,
                     .deviation = deviation,
                     .work = work};
    f.given = bat_array((size_t)count, sizeof *f.given);
    f.fitted = bat_array((size_t)count, sizeof *f.fitted);
    bool met = false;
    batten_status status =
        f.given && f.fitted ? find_common_knots(&f, sections, &met, out) : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < count; k++) {
        if (f.given)
            bat_spline_free(&f.given[k]);
        if (f.fitted)
            bat_spline_free(&f.fitted[k]);
    }
    bat_release(f.error);
    bat_release(f.fitted);
    bat_release(f.given);
    if (status != BATTEN_OK || met)
        return status;
    memset(deviation, 0, (size_t)count * sizeof *deviation);
    return batten_curves_unify(count, sections, out);
}
