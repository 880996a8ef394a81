/*
 * One family of a network upon common knots, together with the cardinal functions of the other:
 * those that are 1 at one node's parameter and 0 at the others.
 *
 * Where the curves fit together as they are, and their knots together are not many more than
 * each has, they stay exact. Else they are drawn anew through the nodes and get few common
 * knots, among them those of the cardinal functions. What the fit then lacks in the nodes is
 * added as a combination of cardinal functions, so that the nodes are met to rounding.
 */
#include "base/sort.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include "shape/skin/common_knots.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    bat_network *net;
    int family, nodes;
    bool periodic;
    batten_curve **drawn, **common; /* [curves] */
    double *deviation;              /* [curves] */
    bat_spline cardinal;
    bat_network_side *out;
} family_search;

static const bat_network_family *family_of(const family_search *t)
{
    return &t->net->family[t->family];
}

static batten_status elevate_cardinal(family_search *t, int degree)
{
    bat_spline raised;
    if (degree <= t->cardinal.degree)
        return BATTEN_OK;
    const batten_status status =
        bat_spline_elevate(&t->cardinal, degree - t->cardinal.degree, &raised);
    if (status == BATTEN_OK) {
        bat_spline_free(&t->cardinal);
        t->cardinal = raised;
    }
    return status;
}

/* ---- the curves ---- */

/* Distinct inner knots of all curves as they were given, those within rounding taken as one. */
static batten_status count_exact(const family_search *t, int *count)
{
    const bat_network_family *f = family_of(t);
    size_t total = 0, used = 0;
    for (int k = 0; k < f->count; k++)
        total += (size_t)batten_curve_spans(f->curves[k].curve, NULL);
    double *knots = bat_array(total, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < f->count; k++)
        used += (size_t)batten_curve_spans(f->curves[k].curve, knots + used);
    bat_sort_doubles(used, knots);
    *count = -1;
    for (size_t i = 1; i < used; i++)
        *count += knots[i] - knots[i - 1] > 16 * DBL_EPSILON;
    bat_release(knots);
    return BATTEN_OK;
}

/* Points of a curve when its degree is raised. */
static int raised_count(const batten_curve *curve, int degree)
{
    return batten_curve_point_count(curve) +
           (degree - batten_curve_degree(curve)) * (batten_curve_spans(curve, NULL) - 1);
}

/* Can the curves stay as they are? Then they get all their knots: when these are not more than
 * twice as many as a curve has on the mean. */
static batten_status try_exact(family_search *t, bool *exact)
{
    const bat_network_family *f = family_of(t);
    int degree = 1, curves = 0;
    double sum = 0;
    *exact = true;
    for (int k = 0; k < f->count && *exact; k++) {
        *exact = f->curves[k].map == NULL;
        degree = bat_max_int(degree, batten_curve_degree(f->curves[k].curve));
    }
    for (int k = 0; k < f->count && *exact; k++) {
        sum += f->curves[k].point ? 0 : raised_count(f->curves[k].curve, degree);
        curves += !f->curves[k].point;
        t->drawn[k] = batten_curve_ref(f->curves[k].curve);
    }
    if (!*exact)
        return BATTEN_OK;
    const batten_status status =
        batten_curves_unify(f->count, (const batten_curve *const *)t->drawn, t->common);
    *exact = status == BATTEN_OK &&
             batten_curve_point_count(t->common[0]) <= 2 * sum / curves + t->nodes;
    for (int k = 0; k < f->count && !*exact; k++) {
        batten_curve_unref(t->drawn[k]);
        batten_curve_unref(t->common[k]);
        t->drawn[k] = t->common[k] = NULL;
    }
    return status == BATTEN_TOO_LARGE ? BATTEN_OK : status;
}

/* A node that stands on a knot but for rounding stands on it. */
static void snap_parameters(const family_search *t)
{
    double *u = t->net->family[t->family].parameters;
    const double *U = batten_curve_knots(t->common[0]);
    const int count = batten_curve_knot_count(t->common[0]);
    for (int i = 1; i + 1 < t->nodes; i++)
        for (int k = 0; k < count; k++)
            if (fabs(U[k] - u[i]) <= BAT_ROUNDING)
                u[i] = U[k];
}

static batten_status redraw(family_search *t, int degree)
{
    const bat_network_family *f = family_of(t);
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        batten_curve *cubic = NULL;
        if (f->curves[k].point)
            cubic = batten_curve_ref(f->curves[k].curve);
        else
            status = bat_network_redraw(&f->curves[k], t->nodes, f->parameters,
                                        t->net->tolerance / 16, &cubic);
        if (status == BATTEN_OK)
            status = bat_work_step(&t->net->work, 1000, 0.3, "reparametrisation");
        if (status == BATTEN_OK)
            status =
                batten_curve_elevate(cubic, degree - batten_curve_degree(cubic), &t->drawn[k]);
        batten_curve_unref(cubic);
    }
    return status;
}

static batten_status fit_common_curves(family_search *t)
{
    const bat_network_family *f = family_of(t);
    const int p = t->cardinal.degree;
    const bat_common_request wanted = {.tolerance = t->net->tolerance / 4,
                                       .held_count = t->cardinal.count - p - 1,
                                       .held = t->cardinal.knots + p + 1,
                                       .seam = t->periodic};
    batten_status status = redraw(t, p);
    if (status == BATTEN_OK)
        status = bat_common_knots_held(f->count, (const batten_curve *const *)t->drawn, &wanted,
                                       &t->net->work, t->common, t->deviation);
    return status;
}

/* ---- common knots of curves and cardinal functions ---- */

/* What the rising numbers `own` lack of `other`, counted or written. */
static int lacking(int count, const double *own, int other_count, const double *other,
                   double *out)
{
    int lacks = 0, i = 0;
    for (int j = 0; j < other_count; j++) {
        while (i < count && own[i] < other[j])
            i++;
        if (i < count && own[i] == other[j])
            i++;
        else
            out[lacks++] = other[j];
    }
    return lacks;
}

static batten_status refine_cardinal(family_search *t, int count, const double *knots)
{
    bat_spline fine;
    const batten_status status = bat_spline_insert(&t->cardinal, count, knots, &fine);
    if (status == BATTEN_OK) {
        bat_spline_free(&t->cardinal);
        t->cardinal = fine;
    }
    return status;
}

static batten_status bring_knots_together(family_search *t)
{
    const int p = t->cardinal.degree, n = batten_curve_point_count(t->common[0]);
    const double *U = batten_curve_knots(t->common[0]) + p + 1, *V = t->cardinal.knots + p + 1;
    const int inner = n - p - 1, other = t->cardinal.count - p - 1;
    double *lacks = bat_array((size_t)(inner + other) + 1, sizeof *lacks);
    if (!lacks)
        return BATTEN_OUT_OF_MEMORY;
    const int count = lacking(inner, U, other, V, lacks);
    batten_status status = BATTEN_OK;
    if (count > 0) {
        double *for_cardinal = bat_array((size_t)(inner + other) + 1, sizeof *lacks);
        status = for_cardinal ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
        if (status == BATTEN_OK)
            status =
                refine_cardinal(t, lacking(other, V, inner, U, for_cardinal), for_cardinal);
        bat_release(for_cardinal);
        for (int k = 0; status == BATTEN_OK && k < family_of(t)->count; k++) {
            batten_curve *fine = NULL;
            status = batten_curve_refine(t->common[k], count, lacks, &fine);
            if (status == BATTEN_OK) {
                batten_curve_unref(t->common[k]);
                t->common[k] = fine;
            }
        }
    } else
        status = refine_cardinal(t, lacking(other, V, inner, U, lacks), lacks);
    bat_release(lacks);
    return status;
}

/* ---- rows ---- */

static void row_at(const bat_network_side *side, const double *rows, double u, double *point)
{
    double basis[BATTEN_MAX_DEGREE + 1];
    const int p = side->degree;
    const int span = bat_knots_span(p, side->count, side->knots, u, BATTEN_FROM_RIGHT);
    bat_basis(p, side->knots, span, u, 0, basis);
    bat_combine(p, basis, 3, rows + (size_t)(span - p) * 3, point);
}

/* Add what the curve lacks in its nodes. */
static batten_status correct(const family_search *t, int k, double *rows)
{
    const bat_network_side *side = t->out;
    const int guides = t->net->family[1].count;
    double *lack = bat_array3((size_t)t->nodes, 3, sizeof *lack);
    if (!lack)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < t->nodes; i++) {
        const double *node =
            t->net->nodes + 3 * (t->family == 0 ? k * guides + i : i * guides + k);
        row_at(side, rows, family_of(t)->parameters[i], lack + 3 * i);
        for (int c = 0; c < 3; c++)
            lack[3 * i + c] = node[c] - lack[3 * i + c];
    }
    for (int a = 0; a < side->count; a++)
        for (int i = 0; i < side->cardinals; i++)
            for (int c = 0; c < 3; c++)
                rows[3 * a + c] += side->blend[a * side->cardinals + i] * lack[3 * i + c];
    for (int end = 0; end < 2; end++) {
        const int i = end ? t->nodes - 1 : 0;
        memcpy(rows + (end ? 3 * (side->count - 1) : 0),
               t->net->nodes + 3 * (t->family == 0 ? k * guides + i : i * guides + k),
               3 * sizeof *rows);
    }
    bat_release(lack);
    return BATTEN_OK;
}

static batten_status fill_side(family_search *t)
{
    bat_network_side *side = t->out;
    const bat_network_family *f = family_of(t);
    side->degree = t->cardinal.degree;
    side->count = t->cardinal.count;
    side->curves = f->count;
    side->cardinals = (int)t->cardinal.width;
    side->seam = t->periodic && !side->exact && side->degree == 3;
    side->knots = t->cardinal.knots;
    side->blend = t->cardinal.values;
    t->cardinal = (bat_spline){0}; /* handed over */
    const size_t row = 3 * (size_t)side->count;
    side->rows = bat_array3((size_t)f->count, row, sizeof *side->rows);
    batten_status status = side->rows ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        double *rows = side->rows + (size_t)k * row;
        const double *points = batten_curve_points(t->common[k]);
        memcpy(rows, points, row * sizeof *rows);
        if (!f->curves[k].point)
            status = correct(t, k, rows);
        for (int a = 1; a < side->count && f->curves[k].point; a++) /* to the bit */
            memcpy(rows + 3 * (size_t)a, points, 3 * sizeof *rows);
    }
    return status;
}

static batten_status check_size(const family_search *t)
{
    const double most = (double)(t->cardinal.count + batten_curve_point_count(t->common[0])) *
                        (family_of(t)->count + t->nodes);
    if (most > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d %ss with %d common control points are too much for a network; the "
                        "limit is %d points of all curves",
                        family_of(t)->count, family_of(t)->what,
                        batten_curve_point_count(t->common[0]), (int)BAT_MAX_MADE_POINTS);
    return BATTEN_OK;
}

static batten_status make_side(family_search *t)
{
    batten_status status = count_exact(t, &t->out->exact_knots);
    if (status == BATTEN_OK)
        status = try_exact(t, &t->out->exact);
    if (status == BATTEN_OK && t->out->exact)
        snap_parameters(t);
    if (status == BATTEN_OK)
        status = bat_network_make_cardinal(t->net, t->family, t->periodic, &t->cardinal);
    if (status == BATTEN_OK && t->out->exact) {
        const int p = bat_max_int(t->cardinal.degree, batten_curve_degree(t->common[0]));
        for (int k = 0; status == BATTEN_OK && k < family_of(t)->count; k++) {
            batten_curve *raised = NULL;
            status = batten_curve_elevate(t->common[k], p - batten_curve_degree(t->common[k]),
                                          &raised);
            if (status == BATTEN_OK) {
                batten_curve_unref(t->common[k]);
                t->common[k] = raised;
            }
        }
        if (status == BATTEN_OK)
            status = elevate_cardinal(t, p);
    } else if (status == BATTEN_OK) {
        status = elevate_cardinal(t, 3);
        if (status == BATTEN_OK)
            status = fit_common_curves(t);
    }
    if (status == BATTEN_OK)
        status = check_size(t);
    if (status == BATTEN_OK)
        status = bring_knots_together(t);
    return status == BATTEN_OK ? fill_side(t) : status;
}

batten_status bat_network_make_side(bat_network *net, int family, bat_network_side *out)
{
    const bat_network_family *f = &net->family[family];
    family_search t = {.net = net,
                       .family = family,
                       .nodes = net->family[1 - family].count,
                       .periodic = f->closed && f->smooth &&
                                   net->options->blend == BATTEN_GORDON_SPLINE,
                       .out = out};
    t.drawn = bat_array((size_t)f->count, sizeof *t.drawn);
    t.common = bat_array((size_t)f->count, sizeof *t.common);
    t.deviation = bat_array((size_t)f->count, sizeof *t.deviation);
    const batten_status status =
        t.drawn && t.common && t.deviation ? make_side(&t) : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < f->count; k++) {
        if (t.drawn)
            batten_curve_unref(t.drawn[k]);
        if (t.common)
            batten_curve_unref(t.common[k]);
    }
    bat_release(t.drawn);
    bat_release(t.common);
    bat_release(t.deviation);
    bat_spline_free(&t.cardinal);
    return status;
}

void bat_network_side_free(bat_network_side *side)
{
    bat_release(side->knots);
    bat_release(side->rows);
    bat_release(side->blend);
}
