/*
 * The procedural skin S(u, v) = sum over k of L_k(v) C_k(u): sections stay as they are, and L_k
 * are the cardinal splines of interpolation across, 1 at section k and 0 at the others. No
 * knots are merged and no weights are blended, so no slivers and no creases arise. [FB89]
 */
#include "shape/formula/formula.h"
#include "shape/linear/linear_solve.h"
#include "shape/points/grid_parameters.h"
#include "shape/skin/steps.h"
#include <batten/approximate.h>

#include <stdlib.h>
#include <string.h>

typedef struct {
    int count, dimension;
    batten_curve **sections; /* [count] over [0, 1] */
    batten_surface_skin_options options;
    double *v;        /* [count + 1] */
    int degree, rows; /* of the splines across; those of a period and the wrapped ones */
    double *knots;    /* [rows + degree + 1] */
    double *cardinal; /* [rows][count + dimension]: the control values of all L_k, and what the
                         vectors at the ends add */
    double bound;     /* on the sum of |L_k| */
} procedural;

static void free_procedural(void *data)
{
    procedural *s = data;
    for (int k = 0; s->sections && k < s->count; k++)
        batten_curve_unref(s->sections[k]);
    bat_release(s->sections);
    bat_release(s->v);
    bat_release(s->knots);
    bat_release(s->cardinal);
    bat_release(s);
}

/* ---- evaluation ---- */

/* What section k adds: its derivatives times those of its cardinal spline. */
static void add_section(const procedural *s, int order, const double *along,
                        const double *across, double *out)
{
    const size_t d = (size_t)s->dimension;
    for (int total = 0; total <= order; total++)
        for (int l = 0; l <= total; l++) {
            double *to = out + (size_t)BATTEN_SURFACE_DERIVATIVE(total - l, l) * d;
            for (size_t c = 0; c < d; c++)
                to[c] += across[l] * along[(size_t)(total - l) * d + c];
        }
}

/* Derivatives of a column of the control values at v. */
static bool column_at(const procedural *s, int order, int span, const double *basis,
                      size_t column, double *out)
{
    const size_t width = (size_t)(s->count + s->dimension);
    bool any = false;
    for (int l = 0; l <= order; l++) {
        out[l] = 0;
        for (int j = 0; j <= s->degree; j++)
            out[l] += basis[l * (s->degree + 1) + j] *
                      s->cardinal[(size_t)(span - s->degree + j) * width + column];
        any = any || out[l] != 0;
    }
    return any;
}

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const procedural *s = data;
    const size_t d = (size_t)s->dimension;
    double basis[4 * (BATTEN_MAX_DEGREE + 1)], across[4], along[12];
    memset(out, 0, (size_t)BATTEN_SURFACE_DERIVATIVES(order) * d * sizeof *out);
    const int span = bat_knots_span(s->degree, s->rows, s->knots, at->v, at->sides.v);
    bat_basis(s->degree, s->knots, span, at->v, order, basis);
    for (int k = 0; k < s->count; k++) {
        if (!column_at(s, order, span, basis, (size_t)k, across))
            continue;
        const batten_status status =
            batten_curve_evaluate_side(s->sections[k], at->u, at->sides.u, order, along);
        if (status != BATTEN_OK)
            return status;
        add_section(s, order, along, across, out);
    }
    for (size_t c = 0; c < d; c++)
        if (column_at(s, order, span, basis, (size_t)s->count + c, across))
            for (int l = 0; l <= order; l++)
                out[(size_t)BATTEN_SURFACE_DERIVATIVE(0, l) * d + c] += across[l];
    return BATTEN_OK;
}

/* ---- as NURBS ---- */

/* Polynomial sections: the blend of rational ones at their points is no NURBS that a skin
 * makes. */
static batten_status polynomial_sections(const procedural *s, double tolerance, double *error,
                                         batten_curve **out)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < s->count; k++) {
        double moved = 0;
        if (!batten_curve_is_rational(s->sections[k])) {
            out[k] = batten_curve_ref(s->sections[k]);
            continue;
        }
        if (!(tolerance > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "section %d is rational: as NURBS the surface needs a tolerance",
                            k + 1);
        status = batten_curve_approximate(s->sections[k],
                                          bat_max_int(3, batten_curve_degree(s->sections[k])),
                                          tolerance / 4, &moved, &out[k]);
        *error = bat_max(*error, moved);
    }
    return status;
}

/* The skin of the same sections, at the same parameters. What one section moves, the surface
 * moves by as much times the bound on the sum of all |L_k|. */
static batten_status to_nurbs(const void *data, double tolerance, batten_surface **out,
                              double *error)
{
    const procedural *s = data;
    const double each = tolerance / s->bound;
    double moved = 0;
    batten_curve **sections = bat_array((size_t)s->count, sizeof *sections);
    if (!sections)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_skin_options options = s->options;
    batten_surface_skin_report report;
    batten_status status = polynomial_sections(s, each, &moved, sections);
    options.parameters = BATTEN_GIVEN;
    options.given = s->v;
    options.tolerance = each > 0 ? each - moved : 0;
    options.creases = BATTEN_CREASES_KEEP;
    if (status == BATTEN_OK)
        status = batten_surface_skin(
            (batten_curve_row){s->count, (const batten_curve *const *)sections}, &options, NULL,
            NULL, &report, out);
    if (status == BATTEN_OK && error)
        *error = (moved + report.error) * s->bound;
    for (int k = 0; k < s->count; k++)
        batten_curve_unref(sections[k]);
    bat_release(sections);
    return status;
}

static const bat_formula formula = {"skin", evaluate, to_nurbs, free_procedural};

/* ---- making it ---- */

/* Parameters from the distances of the sections, seen at 33 places of each. */
static batten_status find_parameters(procedural *s)
{
    enum { SAMPLES = 33 };
    const size_t d = (size_t)s->dimension;
    double *points = bat_array3((size_t)s->count, SAMPLES * d, sizeof *points);
    s->v = bat_array((size_t)s->count + 1, sizeof *s->v);
    batten_status status = points && s->v ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < s->count; k++)
        for (int i = 0; status == BATTEN_OK && i < SAMPLES; i++)
            status = batten_curve_evaluate(s->sections[k], (double)i / (SAMPLES - 1), 0,
                                           points + ((size_t)k * SAMPLES + (size_t)i) * d);
    if (status == BATTEN_OK) {
        const bat_family family = {.name = "sections",
                                   .dimension = s->dimension,
                                   .count = s->count,
                                   .lines = SAMPLES,
                                   .point_step = SAMPLES * d,
                                   .line_step = d,
                                   .periodic = s->options.closed,
                                   .points = points,
                                   .given = s->options.given};
        double spread = 0;
        status = bat_family_parametrize(&family, s->options.parameters, s->v, &spread);
    }
    bat_release(points);
    return status;
}

/* The control values of all cardinal splines are those of the unit data; the vectors at the
 * ends stand in columns of their own. */
static batten_status make_rows(const procedural *s, const bat_operator *op, double *rows)
{
    const size_t n = (size_t)s->count, d = (size_t)s->dimension, width = n + d;
    double *unit = bat_array3(n + 2, width, sizeof *unit);
    if (!unit)
        return BATTEN_OUT_OF_MEMORY;
    double *start = unit + n * width, *end = start + width;
    for (size_t k = 0; k < n; k++)
        unit[k * width + k] = 1;
    memcpy(start + n, s->options.start.vector, d * sizeof *start);
    memcpy(end + n, s->options.end.vector, d * sizeof *end);
    const bat_spline_data given = {width, unit, start, end, NULL};
    const batten_status status = bat_operator_apply(op, &given, rows);
    bat_release(unit);
    return status;
}

static batten_status take_rows(procedural *s, const bat_operator *op)
{
    const size_t width = (size_t)(s->count + s->dimension);
    const int q = op->degree, period = op->count;
    s->degree = q;
    s->rows = period + (op->periodic ? q : 0);
    s->knots = bat_array((size_t)(s->rows + q + 1), sizeof *s->knots);
    s->cardinal = bat_array3((size_t)s->rows, width, sizeof *s->cardinal);
    if (!s->knots || !s->cardinal)
        return BATTEN_OUT_OF_MEMORY;
    if (op->periodic)
        bat_knots_wrap(q, period, op->knots, s->knots);
    else
        memcpy(s->knots, op->knots, (size_t)(s->rows + q + 1) * sizeof *s->knots);
    const batten_status status = make_rows(s, op, s->cardinal);
    for (int j = period; status == BATTEN_OK && j < s->rows; j++)
        memcpy(s->cardinal + (size_t)j * width, s->cardinal + (size_t)(j % period) * width,
               width * sizeof *s->cardinal);
    for (int j = 0; j < s->rows; j++) {
        double sum = 0;
        for (int k = 0; k < s->count; k++)
            sum += fabs(s->cardinal[(size_t)j * width + (size_t)k]);
        s->bound = bat_max(s->bound, sum);
    }
    return status;
}

/* All distinct knots of the sections, and how smooth the least smooth of them is. */
static batten_status find_spans(const procedural *s, bat_formula_axis *axis, double **spans)
{
    size_t total = 0;
    for (int k = 0; k < s->count; k++)
        total += (size_t)batten_curve_spans(s->sections[k], NULL);
    if (total > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "the sections have %zu knots; the limit is %d", total,
                        (int)BAT_MAX_MADE_POINTS);
    double *all = *spans = bat_array(total, sizeof *all);
    if (!all)
        return BATTEN_OUT_OF_MEMORY;
    int count = 0;
    axis->smoothness = 2;
    for (int k = 0; k < s->count; k++) {
        const batten_curve *curve = s->sections[k];
        const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve);
        const int own = batten_curve_spans(curve, all + count);
        for (int i = 1; i + 1 < own; i++) {
            const int times =
                bat_knots_multiplicity(p, n, batten_curve_knots(curve), all[count + i]);
            axis->smoothness = bat_min_int(axis->smoothness, bat_max_int(0, p - times));
        }
        count += own;
    }
    axis->count = bat_skin_sort_knots(count, all);
    axis->spans = all;
    return BATTEN_OK;
}

static double size_of(const procedural *s)
{
    double size = 0;
    for (int k = 0; k < s->count; k++) {
        const int n = batten_curve_point_count(s->sections[k]) * s->dimension;
        for (int i = 0; i < n; i++)
            size = bat_max(size, fabs(batten_curve_points(s->sections[k])[i]));
    }
    return size * s->bound;
}

static batten_status make_surface(procedural *s, batten_surface **out)
{
    bat_formula_axis u = {0}, v = {.smoothness = bat_min_int(2, s->degree - 1)};
    double *spans_u = NULL;
    double *spans_v = bat_array((size_t)s->rows, sizeof *spans_v);
    batten_status status = spans_v ? find_spans(s, &u, &spans_u) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (int j = s->degree; j <= s->rows; j++)
            if (j == s->degree || s->knots[j] > s->knots[j - 1])
                spans_v[v.count++] = s->knots[j];
        v.spans = spans_v;
        status = bat_formula_create(&formula, s, s->dimension, &u, &v, size_of(s), out);
    }
    bat_release(spans_v);
    bat_release(spans_u);
    return status;
}

static batten_status take_sections(procedural *s, const bat_skin *t)
{
    batten_status status = BATTEN_OK;
    s->sections = bat_array((size_t)t->count, sizeof *s->sections);
    if (!s->sections)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < t->count; k++) {
        batten_curve *clamped = NULL;
        status = batten_curve_clamp(t->placed[k], &clamped);
        if (status == BATTEN_OK)
            status = batten_curve_set_domain(clamped, 0, 1, &s->sections[k]);
        batten_curve_unref(clamped);
    }
    return status;
}

static batten_status fill_in(procedural *s, const bat_skin *t)
{
    batten_status status = take_sections(s, t);
    if (status == BATTEN_OK)
        status = find_parameters(s);
    bat_operator across = {0};
    if (status == BATTEN_OK) {
        const bat_request request = bat_skin_request(&s->options, s->count, s->v);
        status = bat_operator_make(&request, &across);
    }
    if (status == BATTEN_OK)
        status = take_rows(s, &across);
    bat_operator_free(&across);
    return status;
}

static batten_status check_ends(const batten_surface_skin_options *o)
{
    if (o->start.kind == BATTEN_END_DIRECTION || o->end.kind == BATTEN_END_DIRECTION)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the ends of a procedural skin have no directions; clamp them");
    if (o->smooth_poles)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a procedural skin has no smooth poles");
    return BATTEN_OK;
}

batten_status batten_surface_skin_procedural(batten_curve_row sections,
                                             const batten_surface_skin_options *options,
                                             double *v, batten_surface **out)
{
    batten_surface_skin_options chosen = batten_surface_skin_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_skin_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    bat_skin t;
    status = bat_skin_begin(sections.count, sections.at, options, false, &t);
    const batten_surface_skin_options *o = t.options;
    if (status == BATTEN_OK)
        status = check_ends(o);
    const double size = (double)sections.count * (sections.count + 3.0);
    if (status == BATTEN_OK && size > BAT_MAX_MADE_POINTS)
        status = bat_fail(BATTEN_TOO_LARGE,
                          "%d sections have cardinal splines of %.3g numbers; the limit is %d",
                          sections.count, size, (int)BAT_MAX_MADE_POINTS);
    procedural *s = status == BATTEN_OK ? bat_array(1, sizeof *s) : NULL;
    if (status == BATTEN_OK && !s)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        s->count = sections.count;
        s->dimension = t.dimension;
        s->options = (batten_surface_skin_options){.size = sizeof s->options,
                                                   .degree = o->degree,
                                                   .parameters = o->parameters,
                                                   .given = o->given,
                                                   .start = o->start,
                                                   .end = o->end,
                                                   .closed = o->closed};
        status = fill_in(s, &t);
    }
    if (status == BATTEN_OK)
        s->options.given = NULL; /* they are in v */
    if (status == BATTEN_OK && v)
        memcpy(v, s->v, (size_t)sections.count * sizeof *v);
    if (status == BATTEN_OK)
        status = make_surface(s, out);
    if (status != BATTEN_OK && s)
        free_procedural(s);
    bat_skin_end(&t);
    return status;
}
