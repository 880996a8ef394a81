/* The true sweep as a surface: its formula, knot lines and size, and the NURBS near it on
 * demand. */
#include "numeric/vector.h"
#include "shape/formula/formula.h"
#include "shape/sweep/true_sweep.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

static batten_status formula_evaluate(const void *data, const bat_surface_place *at, int order,
                                      double *out)
{
    return bat_sweep_evaluate(data, at, order, out);
}

static batten_status formula_to_nurbs(const void *data, double tolerance, batten_surface **out,
                                      double *error)
{
    batten_surface_sweep_report report = {.error = 0};
    bat_work work = {NULL, 0};
    const batten_status status = bat_sweep_fit(data, 3, tolerance, &work, &report, out);
    if (status == BATTEN_OK && error)
        *error = report.error;
    return status;
}

static void formula_free(void *data)
{
    bat_sweep_release(data);
    bat_release(data);
}

static const bat_formula sweep_formula = {"sweep", formula_evaluate, formula_to_nurbs,
                                          formula_free};

/* Spans of the section, and how smooth it is across them. */
static batten_status section_axis(const bat_sweep *s, double **spans, bat_formula_axis *out)
{
    batten_curve *section = NULL;
    batten_status status = bat_sweep_section_at(s, 0, &section);
    if (status != BATTEN_OK)
        return status;
    out->count = batten_curve_spans(section, NULL);
    *spans = bat_array((size_t)out->count, sizeof **spans);
    status = *spans ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(section, *spans);
    out->smoothness =
        bat_knots_smoothness(batten_curve_degree(section), batten_curve_point_count(section),
                             batten_curve_knots(section), 2);
    out->spans = *spans;
    batten_curve_unref(section);
    return status;
}

/* The breaks of the motion inside the part. */
static batten_status motion_axis(const bat_sweep *s, double **spans, bat_formula_axis *out)
{
    const bat_motion *m = s->motion;
    *spans = bat_array((size_t)m->break_count, sizeof **spans);
    if (!*spans)
        return BATTEN_OUT_OF_MEMORY;
    *out = (bat_formula_axis){0, *spans, 2};
    for (int i = 0; i < m->break_count; i++) {
        const double at = m->breaks[i];
        if (at < s->part.a || at > s->part.b)
            continue;
        (*spans)[out->count++] = at;
        if (at > s->part.a && at < s->part.b)
            out->smoothness = bat_max_int(0, bat_min_int(out->smoothness, m->smoothness[i]));
    }
    return BATTEN_OK;
}

/* A coordinate as large as any. */
static batten_status size_of(const bat_sweep *s, const bat_formula_axis *v, double *size)
{
    const size_t width = bat_sweep_width(s), count = (size_t)bat_sweep_count(s);
    double *rows = bat_array3(count, width, sizeof *rows);
    batten_status status = rows ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < v->count; i++) {
        status = bat_sweep_rows(s, v->spans[i], i ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, rows);
        for (size_t k = 0; status == BATTEN_OK && k < count; k++)
            *size = bat_max(*size, bat_largest(3, rows + k * width) /
                                       (width == 4 ? rows[k * width + 3] : 1));
    }
    bat_release(rows);
    return status;
}

batten_status bat_sweep_surface(bat_sweep *sweep, batten_surface **out)
{
    double *spans[2] = {NULL, NULL}, size = 0;
    bat_formula_axis u, v;
    bat_sweep *data = bat_array(1, sizeof *data);
    batten_status status = data ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = section_axis(sweep, &spans[0], &u);
    if (status == BATTEN_OK)
        status = motion_axis(sweep, &spans[1], &v);
    if (status == BATTEN_OK)
        status = size_of(sweep, &v, &size);
    if (status == BATTEN_OK) {
        *data = *sweep;
        status = bat_formula_create(&sweep_formula, data, 3, &u, &v, size, out);
    }
    if (status == BATTEN_OK)
        *sweep = (bat_sweep){0};
    else
        bat_release(data);
    bat_release(spans[1]);
    bat_release(spans[0]);
    return status;
}
