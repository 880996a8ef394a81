/* How far a NURBS surface or isocurve is from the formula it stands for. */
#include "shape/formula/nurbs_error.h"
#include "numeric/vector.h"
#include "shape/formula/edge_angles.h"

enum { PROBES = 7 }; /* measurements of a span, between the abscissae */

static const double probes[PROBES] = {0.03, 0.08, 0.3, 0.5, 0.7, 0.92, 0.97};

/* A measured error grows by this much, for what lies between the measurements. */
#define SAFETY 1.3

batten_status bat_formula_fit_surface(const bat_formula_fit *t, batten_surface **out)
{
    const bat_formula_line *u = &t->lines[0], *v = &t->lines[1];
    const batten_axis axes[2] = {{BAT_FORMULA_DEGREE, u->count, u->knots, false},
                                 {BAT_FORMULA_DEGREE, v->count, v->knots, false}};
    return batten_surface_create(t->dimension, &axes[0], &axes[1], t->points, NULL, out);
}

batten_status bat_formula_fit_curve(const bat_formula_fit *t, const bat_formula_line *l,
                                    batten_curve **out)
{
    return batten_curve_create((batten_points){t->dimension, l->count, t->points},
                               BAT_FORMULA_DEGREE, NULL, l->knots, out);
}

/* ---- errors ---- */

/* The places of a span between the abscissae; [span_count * PROBES]. */
static double *places_of(const bat_formula_line *l)
{
    double *places = bat_array((size_t)l->span_count * PROBES, sizeof *places);
    for (int i = 0; places && i < l->span_count; i++)
        for (int j = 0; j < PROBES; j++)
            places[i * PROBES + j] =
                l->breaks[i] + probes[j] * (l->breaks[i + 1] - l->breaks[i]);
    return places;
}

/* The values of the spline that is made on a grid. */
static batten_status evaluate_made(const bat_formula_fit *t, batten_uv_grid at, double *out)
{
    batten_surface *surface = NULL;
    batten_curve *curve = NULL;
    batten_status status;
    if (t->lines[0].span_count > 0 && t->lines[1].span_count > 0) {
        status = bat_formula_fit_surface(t, &surface);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate_grid(surface, at, 0, NULL, out);
    } else {
        const bool along_u = t->lines[0].span_count > 0;
        status = bat_formula_fit_curve(t, &t->lines[along_u ? 0 : 1], &curve);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate_many(curve, along_u ? at.count_u : at.count_v,
                                                along_u ? at.u : at.v, 0, NULL, out);
    }
    batten_surface_unref(surface);
    batten_curve_unref(curve);
    return status;
}

/* Compare on the grid of places; errors go to the spans of those directions that are probed. */
static batten_status compare(bat_formula_fit *t, batten_uv_grid places, bool probe_u,
                             bool probe_v)
{
    const size_t d = (size_t)t->dimension, count_u = places.count_u, count_v = places.count_v;
    double *truth = bat_array3(count_u * count_v, d, sizeof *truth);
    double *made = bat_array3(count_u * count_v, d, sizeof *made);
    batten_status status = truth && made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(t->surface, places, 0, NULL, truth);
    if (status == BATTEN_OK)
        status = evaluate_made(t, places, made);
    for (size_t i = 0; status == BATTEN_OK && i < count_u; i++)
        for (size_t j = 0; j < count_v; j++) {
            const size_t at = (i * count_v + j) * d;
            const double error = SAFETY * bat_distance((int)d, truth + at, made + at);
            double *of_u = probe_u ? &t->lines[0].errors[i / PROBES] : NULL;
            double *of_v = probe_v ? &t->lines[1].errors[j / PROBES] : NULL;
            if (of_u)
                *of_u = bat_max(*of_u, error);
            if (of_v)
                *of_v = bat_max(*of_v, error);
            t->error = bat_max(t->error, error);
        }
    bat_release(truth);
    bat_release(made);
    return status;
}

static batten_status clear_errors(bat_formula_line *l)
{
    bat_release(l->errors);
    l->errors = bat_array((size_t)l->span_count + 1, sizeof *l->errors);
    return l->errors ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_formula_fit_errors(bat_formula_fit *t, bool between)
{
    bat_formula_line *u = &t->lines[0], *v = &t->lines[1];
    batten_status status = clear_errors(u);
    if (status == BATTEN_OK)
        status = clear_errors(v);
    double *at_u = u->span_count > 0 ? places_of(u) : NULL;
    double *at_v = v->span_count > 0 ? places_of(v) : NULL;
    if (status == BATTEN_OK && ((u->span_count > 0 && !at_u) || (v->span_count > 0 && !at_v)))
        status = BATTEN_OUT_OF_MEMORY;
    const size_t probes_u = (size_t)u->span_count * PROBES,
                 probes_v = (size_t)v->span_count * PROBES;
    t->error = 0;
    if (status == BATTEN_OK && between && at_u && at_v)
        status = compare(t, (batten_uv_grid){probes_u, probes_v, at_u, at_v}, true, true);
    if (status == BATTEN_OK && !between && at_u)
        status = compare(t, (batten_uv_grid){probes_u, (size_t)v->count, at_u, v->greville},
                         true, false);
    if (status == BATTEN_OK && !between && at_v)
        status = compare(t, (batten_uv_grid){(size_t)u->count, probes_v, u->greville, at_v},
                         false, true);
    bat_release(at_u);
    bat_release(at_v);
    return status;
}

/* Refining goes on until so much of the angle is used, for what lies between the places. */
#define ANGLE_SHARE 0.9

batten_status bat_formula_fit_angles(bat_formula_fit *t)
{
    batten_surface *made = NULL;
    batten_status status = bat_formula_fit_surface(t, &made);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = clear_errors(&t->lines[k]);
    t->turned = 0;
    for (int edge = 0; edge < 4 && status == BATTEN_OK; edge++) {
        const bool along_u = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1;
        const bool high = edge == BATTEN_EDGE_V1 || edge == BATTEN_EDGE_U1;
        bat_formula_line *along = &t->lines[along_u ? 0 : 1],
                         *across = &t->lines[along_u ? 1 : 0];
        double *first = &across->errors[high ? across->span_count - 1 : 0];
        for (int i = 0; i < along->span_count && status == BATTEN_OK; i++) {
            double turned = 0;
            status = bat_edge_angle(t->surface, made, (batten_edge)edge,
                                    (batten_interval){along->breaks[i], along->breaks[i + 1]},
                                    &turned);
            t->turned = bat_max(t->turned, turned);
            if (turned > ANGLE_SHARE * t->angle)
                along->errors[i] = *first = HUGE_VAL;
        }
    }
    batten_surface_unref(made);
    return status;
}
