/* NURBS surfaces near true sweeps: the control points of the section are followed along v by
 * splines through sections at Greville's abscissae; sections are added where it is too far. */
#include "base/plural.h"
#include "numeric/banded.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/sweep/near_error.h"
#include "shape/sweep/true_sweep.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST_SECTIONS = 2000,
    MOST_PARTS = 8 /* that a span is cut into at once */
};

/* ---- knots ---- */

static int count_rows(const bat_sweep_fitting *f)
{
    int count = f->degree + 1;
    for (int i = 1; i + 1 < f->mesh_count; i++)
        count += f->times[i];
    return count;
}

static void lay_knots(bat_sweep_fitting *f)
{
    double *knot = f->knots;
    for (int i = 0; i < f->mesh_count; i++) {
        const bool end = i == 0 || i + 1 == f->mesh_count;
        for (int k = 0; k < (end ? f->degree + 1 : f->times[i]); k++)
            *knot++ = f->mesh[i];
    }
}

static batten_status make_room(bat_sweep_fitting *f)
{
    const size_t count = (size_t)f->count, band = 2 * (size_t)f->degree + 1;
    bat_release(f->knots);
    bat_release(f->rows);
    bat_release(f->band);
    f->knots = bat_array(count + (size_t)f->degree + 1, sizeof *f->knots);
    f->rows = bat_array3(count, f->row, sizeof *f->rows);
    f->band = bat_array3(count, band, sizeof *f->band);
    return f->knots && f->rows && f->band ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- one interpolation ---- */

static batten_status interpolate(bat_sweep_fitting *f)
{
    const int q = f->degree, n = f->count;
    const size_t band = 2 * (size_t)q + 1;
    for (int i = 0; i < n; i++) {
        double basis[BATTEN_MAX_DEGREE + 1];
        const double v = bat_greville(f->degree, f->knots, i);
        const int span = bat_knots_span(q, n, f->knots, v, BATTEN_FROM_RIGHT);
        bat_basis(q, f->knots, span, v, 0, basis);
        for (int k = 0; k <= q; k++) {
            const int column = span - q + k - i + q;
            if (column >= 0 && column < (int)band)
                f->band[(size_t)i * band + (size_t)column] = basis[k];
        }
        const batten_status status =
            bat_sweep_rows(f->sweep, v, i + 1 < n ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT,
                           f->rows + (size_t)i * f->row);
        if (status != BATTEN_OK)
            return status;
    }
    f->size = bat_largest((int)(f->row * (size_t)n), f->rows);
    if (!isfinite(f->size))
        return bat_fail(BATTEN_OVERFLOW, "the coordinates of the sweep overflow");
    const batten_status status = bat_banded_factor(n, q, q, f->band);
    if (status == BATTEN_OK)
        bat_banded_solve(n, q, q, f->band, f->row, f->rows);
    return status;
}

/* ---- more sections ---- */

/* Into how many parts a span should be cut: its error falls with the power degree + 1. */
static int parts_of(const bat_sweep_fitting *f, int span)
{
    /* The error falls with the power degree + 1 of the length, a tenth more to be safe; what is not finite asks for the most. */
    const double ratio = f->error[span] / f->tolerance;
    if (!(ratio > 1))
        return 1;
    const double parts = ceil(1.1 * bat_pow(bat_min(ratio, 1e30), 1.0 / (f->degree + 1)));
    return bat_max_int(2, (int)bat_min(parts, MOST_PARTS));
}

/* False when there would be too many, `needed`, or when breaks could not be told apart. */
static bool cut_spans(bat_sweep_fitting *f, int *needed)
{
    int added = 0;
    for (int s = 0; s + 1 < f->mesh_count; s++)
        added += parts_of(f, s) - 1;
    *needed = count_rows(f) + added;
    if (added == 0 || *needed > MOST_SECTIONS)
        return false;
    int to = f->mesh_count + added - 1;
    for (int s = f->mesh_count - 2; s >= 0; s--) {
        const double a = f->mesh[s], b = f->mesh[s + 1];
        const int parts = parts_of(f, s), times = f->times[s + 1];
        f->mesh[to] = b;
        f->times[to--] = times;
        for (int k = parts - 1; k > 0; k--) {
            f->mesh[to] = a + (b - a) * k / parts;
            f->times[to--] = 1;
            if (!(f->mesh[to + 1] < f->mesh[to + 2]))
                return false;
        }
        if (!(a < f->mesh[to + 1]))
            return false;
    }
    f->mesh_count += added;
    return true;
}

static batten_status not_met(const bat_sweep_fitting *f, int needed)
{
    int s = 0;
    char why[80] = "whose spans cannot be cut any more";
    if (needed > MOST_SECTIONS)
        snprintf(why, sizeof why, "and would need about %d; the limit is %d", needed,
                 (int)MOST_SECTIONS);
    for (int i = 1; i + 1 < f->mesh_count; i++)
        if (f->error[i] > f->error[s])
            s = i;
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "the sweep is still %g from its true shape, more than %g, between %.17g and "
        "%.17g of the path, with %d section%s, %s",
        f->worst, f->tolerance, f->mesh[s], f->mesh[s + 1], f->count, bat_plural(f->count),
        why);
}

static batten_status too_many_spans(const bat_motion *m)
{
    return bat_fail(BATTEN_TOO_LARGE,
                    "the path has %d spans, too many for a sweep of at most %d sections",
                    m->break_count - 1, (int)MOST_SECTIONS);
}

/* The breaks of the motion inside the part, as often as it is not smooth there. */
static batten_status begin_mesh(bat_sweep_fitting *f)
{
    const bat_motion *m = f->sweep->motion;
    const batten_interval part = f->sweep->part;
    f->mesh_count = 0;
    for (int i = 0; i < m->break_count; i++) {
        const double at = m->breaks[i];
        if (at < part.a || at > part.b)
            continue;
        const bool inner = at > part.a && at < part.b;
        if (inner && m->smoothness[i] < 0)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "the sections do not meet at the corner of the spine at %.17g", at);
        if (f->mesh_count == MOST_SECTIONS)
            return too_many_spans(m);
        f->mesh[f->mesh_count] = at;
        f->times[f->mesh_count++] =
            f->degree - (inner ? bat_min_int(m->smoothness[i], f->degree - 1) : 0);
    }
    return count_rows(f) <= MOST_SECTIONS ? BATTEN_OK : too_many_spans(m);
}

static batten_status refine_once(bat_sweep_fitting *f, bat_work *work, int places)
{
    f->count = count_rows(f);
    const double total = (double)f->count * f->points;
    if (total > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d sections of %d control points make a surface of %.3g; the limit "
                        "is %d",
                        f->count, f->points, total, (int)BAT_MAX_MADE_POINTS);
    batten_status status = make_room(f);
    if (status == BATTEN_OK)
        status = bat_work_step(work, (uint64_t)f->count * (uint64_t)f->points * 8,
                               bat_min(0.9, f->count / 200.0), "sweep");
    if (status != BATTEN_OK)
        return status;
    lay_knots(f);
    status = interpolate(f);
    if (status == BATTEN_OK)
        status = bat_sweep_measure_spans(f, places);
    return status;
}

/* A path of straight lines makes a surface of degree 1. */
static batten_status try_straight(bat_sweep_fitting *f, bat_work *work, bool *met)
{
    const int degree = f->degree;
    f->degree = 1;
    batten_status status = begin_mesh(f);
    if (status == BATTEN_OK)
        status = refine_once(f, work, BAT_SWEEP_LAST_PLACES);
    if (status == BATTEN_OK && f->tolerance < bat_sweep_rounding(f))
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the sweep cannot be within %g: its coordinates, as large as %g, are "
                          "known to %.3g",
                          f->tolerance, f->size, bat_sweep_rounding(f));
    *met = status == BATTEN_OK && f->worst <= 32 * DBL_EPSILON * f->size &&
           f->worst + bat_sweep_rounding(f) <= f->tolerance;
    if (*met)
        f->worst += bat_sweep_rounding(f);
    else
        f->degree = degree;
    return status;
}

static batten_status refine_until_near(bat_sweep_fitting *f, bat_work *work)
{
    bool met = false;
    int needed = 0;
    batten_status status = try_straight(f, work, &met);
    if (status != BATTEN_OK || met)
        return status;
    status = begin_mesh(f);
    while (status == BATTEN_OK && !met) {
        status = refine_once(f, work, BAT_SWEEP_PLACES);
        if (status == BATTEN_OK && f->worst <= f->tolerance)
            status = bat_sweep_measure_last(f);
        met = status == BATTEN_OK && f->worst <= f->tolerance;
        if (status == BATTEN_OK && !met && !cut_spans(f, &needed))
            status = not_met(f, needed);
    }
    return status;
}

/* ---- handing over ---- */

/* A path that comes back to its start closes to the bit. */
static void close_seam(bat_sweep_fitting *f)
{
    double *last = f->rows + (size_t)(f->count - 1) * f->row;
    double gap = 0;
    for (size_t c = 0; c < f->row; c++)
        gap = bat_max(gap, fabs(f->rows[c] - last[c]));
    if (gap > bat_min(BAT_MEANT_SAME * f->size, f->tolerance / 16))
        return;
    memcpy(last, f->rows, f->row * sizeof *last);
    f->worst += gap;
}

static void fill_knots_u(const bat_sweep *s, bat_nurbs *made)
{
    const double *knots =
        s->row ? batten_surface_knots(s->row, BATTEN_U) : batten_curve_knots(s->section);
    const int count = s->row ? batten_surface_knot_count(s->row, BATTEN_U)
                             : batten_curve_knot_count(s->section);
    memcpy(made->axes[BATTEN_U].knots, knots, (size_t)count * sizeof *knots);
}

static batten_status make_surface(const bat_sweep_fitting *f, batten_surface **out)
{
    const bat_sweep *s = f->sweep;
    const double *w = s->row ? NULL : batten_curve_weights(s->section);
    const bat_nurbs_shape shape = {
        3,
        {s->row ? batten_surface_degree(s->row, BATTEN_U) : batten_curve_degree(s->section),
         f->degree},
        {f->points, f->count},
        {s->row ? batten_surface_is_periodic(s->row, BATTEN_U)
                : batten_curve_is_periodic(s->section),
         false},
        w || f->width == 4};
    bat_nurbs *made;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < f->points; i++)
        for (int j = 0; j < f->count; j++) {
            const double *from = f->rows + (size_t)j * f->row + (size_t)i * f->width;
            const size_t at = (size_t)i * (size_t)f->count + (size_t)j;
            const double weight = f->width == 4 ? from[3] : 1;
            for (size_t c = 0; c < 3; c++)
                made->points[3 * at + c] = from[c] / weight;
            if (made->weights)
                made->weights[at] = w ? w[i] : weight;
        }
    fill_knots_u(s, made);
    memcpy(made->axes[BATTEN_V].knots, f->knots,
           (size_t)(f->count + f->degree + 1) * sizeof *f->knots);
    return bat_nurbs_finish(made, out);
}

static void release_fitting(bat_sweep_fitting *f)
{
    bat_release(f->mesh);
    bat_release(f->times);
    bat_release(f->error);
    bat_release(f->knots);
    bat_release(f->rows);
    bat_release(f->band);
    bat_release(f->true_row);
    bat_release(f->made_row);
}

static batten_status check_request(int degree, double tolerance)
{
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree along the path is %d, not 1 to %d",
                        degree, BATTEN_MAX_DEGREE);
    if (!isfinite(tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "the tolerance is %g", tolerance);
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    return BATTEN_OK;
}

batten_status bat_sweep_fit(const bat_sweep *sweep, int degree, double tolerance,
                            bat_work *work, batten_surface_sweep_report *report,
                            batten_surface **out)
{
    batten_status status = check_request(degree, tolerance);
    if (status != BATTEN_OK)
        return status;
    bat_sweep_fitting f = {.sweep = sweep, .degree = degree, .tolerance = tolerance};
    f.points = bat_sweep_count(sweep);
    f.width = bat_sweep_width(sweep);
    f.row = (size_t)f.points * f.width;
    f.mesh = bat_array(MOST_SECTIONS + 2, sizeof *f.mesh);
    f.times = bat_array(MOST_SECTIONS + 2, sizeof *f.times);
    f.error = bat_array(MOST_SECTIONS + 2, sizeof *f.error);
    f.true_row = bat_array(f.row, sizeof *f.true_row);
    f.made_row = bat_array(f.row, sizeof *f.made_row);
    status = f.mesh && f.times && f.error && f.true_row && f.made_row ? BATTEN_OK
                                                                      : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = refine_until_near(&f, work);
    if (status == BATTEN_OK) {
        close_seam(&f);
        status = make_surface(&f, out);
    }
    if (status == BATTEN_OK) {
        report->error = bat_max(report->error, f.worst);
        report->section_count += f.count;
    }
    release_fitting(&f);
    return status;
}
