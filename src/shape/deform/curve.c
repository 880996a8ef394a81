/* Curves under a deformation: quintic pieces that share point and two derivatives with the image, halved until they are near
 * enough. */
#include "spline/curve/curve.h"
#include "base/list.h"
#include "base/plural.h"
#include "numeric/halving.h"
#include "numeric/vector.h"
#include "shape/deform/lattice.h"
#include "shape/near/within.h"

#include <batten/measure.h>
#include <float.h>
#include <string.h>

enum { DEPTH = 40, SAMPLES = 7, VALUES = 9, MOST_PIECES = 100000 };

/* Derivatives on both sides of a knot that differ by less are the same but for rounding. */
static const double same_derivative = 1e-9;

/* The image at a parameter: point, first and second derivative. */
typedef struct {
    double u, values[VALUES];
} image_place;

typedef struct {
    const batten_curve *curve;
    const batten_deformation *deformation;
    double tolerance, error;
    int pieces;
    /* the smooth run in the making */
    image_place *places;
    int count, room;
    /* those that are made */
    batten_curve **runs;
    int run_count, run_room;
} deforming;

static batten_status evaluate_image(const deforming *t, double u, batten_side side,
                                    image_place *out)
{
    double given[VALUES];
    bat_jet x[3], y[3];
    const batten_status status = batten_curve_evaluate_side(t->curve, u, side, 2, given);
    if (status != BATTEN_OK)
        return status;
    /* A function of u alone: f, fu, fuu are entries 0, 1 and 3 of a jet. */
    static const int entry[3] = {0, 1, 3};
    for (int c = 0; c < 3; c++) {
        x[c] = bat_jet_constant(0);
        for (int m = 0; m < 3; m++)
            x[c].d[entry[m]] = given[3 * m + c];
    }
    bat_deformation_jets(t->deformation, x, y);
    out->u = u;
    for (int m = 0; m < 3; m++)
        for (int c = 0; c < 3; c++)
            out->values[3 * m + c] = y[c].d[entry[m]];
    return BATTEN_OK;
}

/* How far the quintic from a to b is from the image. */
static batten_status measure_piece(const deforming *t, const image_place *a,
                                   const image_place *b, double *error)
{
    const double ends[2] = {a->u, b->u};
    double values[2 * VALUES];
    batten_curve *quintic = NULL;
    memcpy(values, a->values, sizeof a->values);
    memcpy(values + VALUES, b->values, sizeof b->values);
    batten_status status = batten_curve_from_hermite(3, 2, 3, ends, values, &quintic);
    double most = 0;
    for (int i = 1; status == BATTEN_OK && i <= SAMPLES; i++) {
        const double u = a->u + (b->u - a->u) * (i / (SAMPLES + 1.0));
        double near[3], given[3], truth[3];
        status = batten_curve_evaluate(quintic, u, 0, near);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(t->curve, u, 0, given);
        if (status != BATTEN_OK)
            break;
        bat_deformation_point(t->deformation, given, truth);
        most = bat_max(most, bat_distance(3, near, truth));
    }
    batten_curve_unref(quintic);
    *error = BAT_QUINTIC_BETWEEN_7 * most;
    return status;
}

/* ---- runs ---- */

static batten_status finish_run(deforming *t)
{
    if (t->count < 2)
        return BATTEN_OK;
    batten_curve *run = NULL;
    double *parameters = bat_array((size_t)t->count, sizeof *parameters);
    double *values = bat_array((size_t)t->count, VALUES * sizeof *values);
    batten_status status = parameters && values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        parameters[i] = t->places[i].u;
        memcpy(values + (size_t)i * VALUES, t->places[i].values, VALUES * sizeof *values);
    }
    if (status == BATTEN_OK)
        status = batten_curve_from_hermite(3, t->count, 3, parameters, values, &run);
    if (status == BATTEN_OK)
        status = BAT_LIST_ADD(t->runs, t->run_count, t->run_room, run);
    if (status != BATTEN_OK)
        batten_curve_unref(run);
    bat_release(parameters);
    bat_release(values);
    t->count = 0;
    return status;
}

static bool is_smooth_joint(const image_place *left, const image_place *right)
{
    for (int m = 1; m < 3; m++) {
        const double *a = left->values + 3 * m, *b = right->values + 3 * m;
        if (bat_distance(3, a, b) > same_derivative * bat_max(bat_norm(3, a), bat_norm(3, b)))
            return false;
    }
    return true;
}

/* From `a`, the last place of the run, to `b`, the end of its span. */
static batten_status follow_span(deforming *t, image_place a, const image_place *b)
{
    bat_halving h = bat_halving_of(a.u, b->u, DEPTH);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && h.waiting > 0) {
        image_place next = *b;
        double error = 0;
        if (h.waiting > 1)
            status = evaluate_image(t, h.b, BATTEN_FROM_LEFT, &next);
        if (status == BATTEN_OK)
            status = measure_piece(t, &a, &next, &error);
        if (status != BATTEN_OK)
            return status;
        if (!(error <= t->tolerance)) {
            if (t->pieces >= MOST_PIECES || !bat_halving_split(&h))
                return bat_fail(
                    BATTEN_TOLERANCE_NOT_MET,
                    "the image of the curve is missed by %g near u = %.9g; %g was wanted",
                    error, a.u, t->tolerance);
            continue;
        }
        t->error = bat_max(t->error, error);
        t->pieces++;
        status = BAT_LIST_ADD(t->places, t->count, t->room, next);
        a = next;
        bat_halving_accept(&h);
    }
    return status;
}

static batten_status follow_curve(deforming *t, int knot_count, const double *knots)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i + 1 < knot_count && status == BATTEN_OK; i++) {
        image_place start, end;
        status = evaluate_image(t, knots[i], BATTEN_FROM_RIGHT, &start);
        if (status == BATTEN_OK)
            status = evaluate_image(t, knots[i + 1], BATTEN_FROM_LEFT, &end);
        if (status != BATTEN_OK)
            return status;
        if (t->count == 0 || !is_smooth_joint(&t->places[t->count - 1], &start)) {
            status = finish_run(t);
            if (status == BATTEN_OK)
                status = BAT_LIST_ADD(t->places, t->count, t->room, start);
        }
        if (status == BATTEN_OK)
            status = follow_span(t, start, &end);
    }
    return status == BATTEN_OK ? finish_run(t) : status;
}

static batten_status check_curve(const batten_curve *curve,
                                 const batten_deformation *deformation, double tolerance)
{
    batten_box box;
    if (batten_curve_dimension(curve) != 3)
        return bat_fail(BATTEN_UNSUPPORTED, "a curve in %d dimension%s; 3 are needed",
                        batten_curve_dimension(curve),
                        bat_plural(batten_curve_dimension(curve)));
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    const double least = 64 * DBL_EPSILON * (deformation->size + deformation->report.moved);
    if (tolerance < least)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "a tolerance of %g is below %g, what rounding leaves of the curve",
                        tolerance, least);
    const batten_status status = batten_curve_bounds(curve, &box);
    return status == BATTEN_OK ? bat_deformation_check(deformation, box, "the curve") : status;
}

batten_status batten_curve_deform(const batten_curve *curve,
                                  const batten_deformation *deformation, double tolerance,
                                  double *error, batten_curve **out)
{
    assert(curve && deformation && out);
    deforming t = {.curve = curve, .deformation = deformation, .tolerance = tolerance};
    batten_curve *made = NULL;
    batten_status status = check_curve(curve, deformation, tolerance);
    if (status != BATTEN_OK)
        return status;
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(curve, knots);
        status = follow_curve(&t, count, knots);
    }
    if (status == BATTEN_OK)
        status = bat_curve_chained(t.run_count, t.runs, &made);
    if (status == BATTEN_OK) {
        *out = made;
        if (error)
            *error = t.error;
    }
    for (int i = 0; i < t.run_count; i++)
        batten_curve_unref(t.runs[i]);
    bat_release(t.runs);
    bat_release(t.places);
    bat_release(knots);
    return status;
}
