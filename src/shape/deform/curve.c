/* Curves under a deformation: quintic pieces that share point and two derivatives with the image, halved until they are near
 * enough. */
#include "spline/curve/curve.h"
#include "base/list.h"
#include "base/plural.h"
#include "numeric/halving.h"
#include "numeric/vector.h"
#include "shape/deform/lattice.h"
#include "shape/near/within.h"
#include "spline/curve/hermite_run.h"

#include <batten/measure.h>
#include <float.h>

enum { DEPTH = 40, SAMPLES = 7, MOST_PIECES = 100000 };

/* Derivatives on both sides of a knot that differ by less are the same but for rounding. */
static const double same_derivative = 1e-9;

typedef struct {
    const batten_curve *curve;
    const batten_deformation *deformation;
    double tolerance, error;
    int pieces;
    bat_hermite_run run; /* the smooth run in the making */
    batten_curve **runs; /* those that are made */
    int run_count, run_room;
} deforming;

/* The image at a parameter with its first and second derivative. */
static batten_status evaluate_image(const deforming *t, double u, batten_side side,
                                    bat_hermite_place *out)
{
    double given[3 * 3];
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
            out->q[m][c] = y[c].d[entry[m]];
    return BATTEN_OK;
}

/* How far the quintic from a to b is from the image. */
static batten_status measure_piece(const deforming *t, const bat_hermite_place *a,
                                   const bat_hermite_place *b, double *error)
{
    const bat_hermite_place ends[2] = {*a, *b};
    batten_curve *quintic = NULL;
    batten_status status = bat_hermite_curve(3, 2, ends, &quintic);
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
    batten_curve *made = NULL;
    batten_status status = bat_hermite_run_finish(&t->run, &made);
    if (status == BATTEN_OK && made)
        status = BAT_LIST_ADD(t->runs, t->run_count, t->run_room, made);
    if (status != BATTEN_OK)
        batten_curve_unref(made);
    return status;
}

/* From `a`, the last place of the run, to `b`, the end of its span. */
static batten_status follow_span(deforming *t, bat_hermite_place a, const bat_hermite_place *b)
{
    bat_halving h = bat_halving_of(a.u, b->u, DEPTH);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && h.waiting > 0) {
        bat_hermite_place next = *b;
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
        status = bat_hermite_run_add(&t->run, next.u, next.q[0]);
        a = next;
        bat_halving_accept(&h);
    }
    return status;
}

static batten_status follow_curve(deforming *t, int knot_count, const double *knots)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i + 1 < knot_count && status == BATTEN_OK; i++) {
        bat_hermite_place start, end;
        status = evaluate_image(t, knots[i], BATTEN_FROM_RIGHT, &start);
        if (status == BATTEN_OK)
            status = evaluate_image(t, knots[i + 1], BATTEN_FROM_LEFT, &end);
        if (status != BATTEN_OK)
            return status;
        const bat_hermite_run *run = &t->run;
        if (run->count == 0 || !bat_hermite_agrees(3, 1, run->places[run->count - 1].q[0],
                                                   start.q[0], same_derivative)) {
            status = finish_run(t);
            if (status == BATTEN_OK)
                status = bat_hermite_run_add(&t->run, start.u, start.q[0]);
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
    deforming t = {
        .curve = curve, .deformation = deformation, .tolerance = tolerance, .run.dimension = 3};
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
    bat_hermite_run_release(&t.run);
    bat_release(knots);
    return status;
}
