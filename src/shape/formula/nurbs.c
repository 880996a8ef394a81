/*
 * The B-spline near a surface of another kind: quintic, interpolating at Greville's abscissae, one
 * direction after the other. Errors are measured along each direction alone, at parameters of
 * the other where the spline is exact, so that only spans that need it are halved.
 */
#include "shape/formula/nurbs.h"
#include "base/plural.h"
#include "shape/formula/evaluate.h"
#include "shape/formula/nurbs_error.h"

#include "numeric/banded.h"
#include "numeric/dense.h"
#include "numeric/vector.h"
#include "spline/spline.h"

#include <float.h>

enum {
    ROUNDS = 64,
    JUDGED = 16384, /* points from which on it is asked whether more of them will do */
    GROWTH = 16,    /* points so many times as many show how errors fall with them: */
    SLOW = 4,    /* no more than this is what spans of a quarter of the length do of a kink */
    PATIENCE = 6 /* rounds without a smaller angle */
};

static void release_line(bat_formula_line *l)
{
    bat_release(l->breaks);
    bat_release(l->times);
    bat_release(l->knots);
    bat_release(l->greville);
    bat_release(l->lu);
    bat_release(l->errors);
}

static void release(bat_formula_fit *t)
{
    release_line(&t->lines[0]);
    release_line(&t->lines[1]);
    bat_release(t->points);
}

/* ---- one direction ---- */

static batten_status begin_line(const batten_surface *surface, batten_direction direction,
                                int smoothness, bat_formula_line *l)
{
    const int count = batten_surface_spans(surface, direction, NULL);
    l->breaks = bat_array((size_t)count, sizeof *l->breaks);
    l->times = bat_array((size_t)count, sizeof *l->times);
    if (!l->breaks || !l->times)
        return BATTEN_OUT_OF_MEMORY;
    l->span_count = batten_surface_spans(surface, direction, l->breaks) - 1;
    for (int i = 0; i <= l->span_count; i++)
        l->times[i] = i == 0 || i == l->span_count ? BAT_FORMULA_DEGREE + 1
                                                   : BAT_FORMULA_DEGREE - smoothness;
    return BATTEN_OK;
}

static batten_status fixed_line(double at, bat_formula_line *l)
{
    l->greville = bat_array(1, sizeof *l->greville);
    if (!l->greville)
        return BATTEN_OUT_OF_MEMORY;
    l->greville[0] = at;
    l->count = 1;
    return BATTEN_OK;
}

/* Knots and abscissae of the spans as they are. */
static batten_status lay_knots(bat_formula_line *l)
{
    int total = 0;
    for (int i = 0; i <= l->span_count; i++)
        total += l->times[i];
    bat_release(l->knots);
    bat_release(l->greville);
    l->count = total - BAT_FORMULA_DEGREE - 1;
    l->knots = bat_array((size_t)total, sizeof *l->knots);
    l->greville = bat_array((size_t)l->count, sizeof *l->greville);
    if (!l->knots || !l->greville)
        return BATTEN_OUT_OF_MEMORY;
    int k = 0;
    for (int i = 0; i <= l->span_count; i++)
        for (int j = 0; j < l->times[i]; j++)
            l->knots[k++] = l->breaks[i];
    for (int i = 0; i < l->count; i++)
        l->greville[i] = bat_greville(BAT_FORMULA_DEGREE, l->knots, i);
    return BATTEN_OK;
}

static batten_status factor(bat_formula_line *l)
{
    const size_t width = 2 * BAT_FORMULA_DEGREE + 1;
    bat_release(l->lu);
    l->lu = bat_array3((size_t)l->count, width, sizeof *l->lu);
    if (!l->lu)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < l->count; i++) {
        double basis[BAT_FORMULA_DEGREE + 1];
        const int span = bat_knots_span(BAT_FORMULA_DEGREE, l->count, l->knots, l->greville[i],
                                        BATTEN_FROM_RIGHT);
        bat_basis(BAT_FORMULA_DEGREE, l->knots, span, l->greville[i], 0, basis);
        for (int j = 0; j <= BAT_FORMULA_DEGREE; j++) {
            const int column = span - BAT_FORMULA_DEGREE + j - i + BAT_FORMULA_DEGREE;
            if (column >= 0 && column < (int)width)
                l->lu[(size_t)i * width + (size_t)column] = basis[j];
        }
    }
    return bat_banded_factor(l->count, BAT_FORMULA_DEGREE, BAT_FORMULA_DEGREE, l->lu);
}

static batten_status prepare(bat_formula_line *l)
{
    if (l->span_count == 0)
        return BATTEN_OK;
    const batten_status status = lay_knots(l);
    return status == BATTEN_OK ? factor(l) : status;
}

/* Halve the spans where the error is too large; false when one has become too short for that.
 */
static batten_status refine(bat_formula_line *l, double tolerance, bool *changed)
{
    const int old = l->span_count;
    int added = 0;
    for (int i = 0; i < old; i++)
        added += l->errors[i] > tolerance;
    if (added == 0)
        return BATTEN_OK;
    double *breaks = bat_array((size_t)(old + added + 1), sizeof *breaks);
    int *times = bat_array((size_t)(old + added + 1), sizeof *times);
    int k = 0;
    bool too_short = false;
    for (int i = 0; breaks && times && i <= old; i++) {
        breaks[k] = l->breaks[i];
        times[k++] = l->times[i];
        if (i == old || !(l->errors[i] > tolerance))
            continue;
        breaks[k] = 0.5 * l->breaks[i] + 0.5 * l->breaks[i + 1];
        /* Of spans shorter than 1e-10 of the whole, abscissae run together in rounding. */
        too_short |= !(breaks[k] - l->breaks[i] > 1e-10 * (l->breaks[old] - l->breaks[0]));
        times[k++] = 1;
    }
    if (!breaks || !times || too_short) {
        bat_release(breaks);
        bat_release(times);
        return too_short ? BATTEN_TOLERANCE_NOT_MET : BATTEN_OUT_OF_MEMORY;
    }
    bat_release(l->breaks);
    bat_release(l->times);
    l->breaks = breaks;
    l->times = times;
    l->span_count = old + added;
    *changed = true;
    return BATTEN_OK;
}

/* ---- interpolation ---- */

static batten_status interpolate(bat_formula_fit *t)
{
    const bat_formula_line *u = &t->lines[0], *v = &t->lines[1];
    const int d = t->dimension;
    const size_t total = (size_t)u->count * (size_t)v->count;
    if (total > (size_t)t->most)
        return BATTEN_TOLERANCE_NOT_MET;
    bat_release(t->points);
    t->points = bat_array3(total, (size_t)d, sizeof *t->points);
    double *turned = bat_array3(total, (size_t)d, sizeof *turned);
    batten_status status = t->points && turned ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(
            t->surface,
            (batten_uv_grid){(size_t)u->count, (size_t)v->count, u->greville, v->greville}, 0,
            NULL, t->points);
    if (status == BATTEN_OK && u->lu)
        bat_banded_solve(u->count, BAT_FORMULA_DEGREE, BAT_FORMULA_DEGREE, u->lu,
                         (size_t)v->count * (size_t)d, t->points);
    if (status == BATTEN_OK && v->lu) {
        bat_transpose(u->count, v->count, (size_t)d, t->points, turned);
        bat_banded_solve(v->count, BAT_FORMULA_DEGREE, BAT_FORMULA_DEGREE, v->lu,
                         (size_t)u->count * (size_t)d, turned);
        bat_transpose(v->count, u->count, (size_t)d, turned, t->points);
    }
    bat_release(turned);
    return status;
}

/* ---- the search ---- */

static batten_status refine_both(bat_formula_fit *t, bool *changed)
{
    *changed = false;
    batten_status status = refine(&t->lines[0], t->tolerance, changed);
    if (status == BATTEN_OK)
        status = refine(&t->lines[1], t->tolerance, changed);
    return status;
}

/* One spline, and whether it must be refined. */
static batten_status try_once(bat_formula_fit *t, bool *changed)
{
    batten_status status = prepare(&t->lines[0]);
    if (status == BATTEN_OK)
        status = prepare(&t->lines[1]);
    if (status == BATTEN_OK)
        status = interpolate(t);
    if (status == BATTEN_OK)
        status = bat_formula_fit_errors(t, false);
    if (status == BATTEN_OK)
        status = refine_both(t, changed);
    const bool both = t->lines[0].span_count > 0 && t->lines[1].span_count > 0;
    if (status != BATTEN_OK || *changed || !both)
        return status;
    const double along = t->error;
    status = bat_formula_fit_errors(t, true);
    t->error = bat_max(t->error, along);
    return status == BATTEN_OK ? refine_both(t, changed) : status;
}

/* How many points a spline had, and its error. */
typedef struct {
    double points, error;
} attempt;

/* Would the points that are needed be far too many, when errors keep falling as slowly as they
 * did since there were a sixteenth of them? Where the surface jumps they do not fall at all;
 * where it is smooth and its features are found, to a four-thousandth. */
static bool is_hopeless(const bat_formula_fit *t, const attempt *attempts, int round)
{
    const attempt *now = &attempts[round];
    int before = round;
    while (before > 0 && attempts[before].points > now->points / GROWTH)
        before--;
    if (now->points < JUDGED || attempts[before].points > now->points / GROWTH)
        return false;
    const double fall = attempts[before].error / now->error, wanted = now->error / t->tolerance;
    if (!(wanted > 1) || fall > SLOW)
        return false;
    const double times = fall > 1 ? bat_pow(GROWTH, bat_log(wanted) / bat_log(fall)) : HUGE_VAL;
    return now->points * times > GROWTH * (double)t->most;
}

static batten_status search(bat_formula_fit *t)
{
    attempt attempts[ROUNDS];
    bool changed = true;
    batten_status status = BATTEN_OK;
    for (int round = 0; round < ROUNDS && changed && status == BATTEN_OK; round++) {
        status = try_once(t, &changed);
        attempts[round] = (attempt){(double)t->lines[0].count * t->lines[1].count, t->error};
        if (status == BATTEN_OK && is_hopeless(t, attempts, round))
            break;
    }
    if (status == BATTEN_TOLERANCE_NOT_MET || (status == BATTEN_OK && changed))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "%d x %d control points come to %g of the %s surface; %g was wanted",
                        t->lines[0].count, t->lines[1].count, t->error,
                        batten_surface_kind(t->surface), t->tolerance);
    return status;
}

/* ---- normals along the edges ---- */

static batten_status fail_angle(const bat_formula_fit *t)
{
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "%d x %d control points leave the normals of the %s surface by %.3g degree%s "
        "along its edges; %.3g were wanted",
        t->lines[0].count, t->lines[1].count, batten_surface_kind(t->surface),
        t->turned * 180 / BAT_PI, bat_plural_real(t->turned * 180 / BAT_PI, 3),
        t->angle * 180 / BAT_PI);
}

/* A spline on the spans as they are; where its normals are too far off these are halved, so that
 * knots crowd where slopes change quickly. Points are not measured. */
static batten_status try_edges(bat_formula_fit *t, bool *changed)
{
    batten_status status = prepare(&t->lines[0]);
    if (status == BATTEN_OK)
        status = prepare(&t->lines[1]);
    if (status == BATTEN_OK)
        status = interpolate(t);
    if (status == BATTEN_OK)
        status = bat_formula_fit_angles(t);
    return status == BATTEN_OK ? refine_both(t, changed) : status;
}

/* Until normals are near enough; not when they come no nearer. */
static batten_status search_edges(bat_formula_fit *t, bool *changed)
{
    double least = HUGE_VAL;
    bool more = true;
    *changed = false;
    for (int idle = 0; more && idle < PATIENCE; idle++) {
        const batten_status status = try_edges(t, &more);
        if (status != BATTEN_OK)
            return status == BATTEN_TOLERANCE_NOT_MET ? fail_angle(t) : status;
        *changed = *changed || more;
        if (t->turned < 0.9 * least) {
            least = t->turned;
            idle = -1;
        }
    }
    return more ? fail_angle(t) : BATTEN_OK;
}

/* Points, then normals; knots for the one seldom spoil the other. */
static batten_status search_both(bat_formula_fit *t)
{
    for (int round = 0; round < PATIENCE; round++) {
        bool changed = false;
        batten_status status = search(t);
        if (status == BATTEN_OK && t->angle > 0)
            status = search_edges(t, &changed);
        if (status != BATTEN_OK || !changed)
            return status;
    }
    return fail_angle(t);
}

static double box_size(const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    const double corners[6] = {box.low.x,  box.low.y,  box.low.z,
                               box.high.x, box.high.y, box.high.z};
    return bat_largest(6, corners);
}

static batten_status begin_fit(bat_formula_fit *t, double tolerance)
{
    batten_status status = bat_tolerance_check(tolerance);
    const double least = 64 * DBL_EPSILON * box_size(t->surface);
    if (status == BATTEN_OK && tolerance < least)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "a tolerance of %g is below %g, what rounding leaves of the surface",
                          tolerance, least);
    t->tolerance = bat_max(tolerance, DBL_MIN);
    return status;
}

batten_status bat_surface_approximate_smooth(const batten_surface *surface, double tolerance,
                                             double angle, int most, batten_surface **out,
                                             double *error)
{
    bat_formula_fit t = {
        .surface = surface, .dimension = surface->dimension, .angle = angle, .most = most};
    batten_status status = begin_fit(&t, tolerance);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = begin_line(surface, (batten_direction)k,
                            bat_formula_smoothness(surface, (batten_direction)k), &t.lines[k]);
    if (status == BATTEN_OK)
        status = search_both(&t);
    if (status == BATTEN_OK)
        status = bat_formula_fit_surface(&t, out);
    if (status == BATTEN_OK && error)
        *error = t.error;
    release(&t);
    return status;
}

batten_status bat_surface_approximate(const batten_surface *surface, double tolerance, int most,
                                      batten_surface **out, double *error)
{
    return bat_surface_approximate_smooth(surface, tolerance, 0, most, out, error);
}

batten_status bat_formula_isocurve(const batten_surface *surface, batten_direction direction,
                                   double at, batten_curve **out)
{
    const batten_direction along = bat_other(direction);
    bat_formula_fit t = {
        .surface = surface, .dimension = surface->dimension, .most = BAT_APPROXIMATE_MOST};
    batten_status status = begin_fit(&t, 1e-9 * box_size(surface));
    if (status == BATTEN_OK)
        status =
            begin_line(surface, along, bat_formula_smoothness(surface, along), &t.lines[along]);
    if (status == BATTEN_OK)
        status = fixed_line(at, &t.lines[direction]);
    if (status == BATTEN_OK)
        status = search(&t);
    if (status == BATTEN_OK)
        status = bat_formula_fit_curve(&t, &t.lines[along], out);
    release(&t);
    return status;
}
