/*
 * Contours of a field on a shape that consists of smooth pieces; a surface consists of the
 * rectangles between its knot lines.
 */
#include "inspect/contours/contours.h"
#include "base/plural.h"

#include "inspect/contours/lines.h"
#include "numeric/vector.h"

#include <string.h>

/* ---- handing over ---- */

static batten_status hand_over_lines(bat_lines *lines, batten_contours *out)
{
    out->lines = bat_array(lines->count, sizeof *out->lines);
    if (!out->lines)
        return BATTEN_OUT_OF_MEMORY;
    int level_count = 0;
    for (size_t i = 0; i < lines->count; i++)
        level_count = bat_max_int(level_count, lines->lines[i].level + 1);
    /* By level; inside one as they were found. */
    int *first = bat_array((size_t)level_count + 1, sizeof *first);
    if (!first)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < lines->count; i++)
        first[lines->lines[i].level + 1]++;
    for (int i = 0; i < level_count; i++)
        first[i + 1] += first[i];
    for (size_t i = 0; i < lines->count; i++) {
        bat_line *from = &lines->lines[i];
        out->lines[first[from->level]++] =
            (batten_contour){from->level,
                             {(int)from->count, from->closed, from->points, from->parameters},
                             from->arms};
        *from = (bat_line){0};
    }
    out->count = (int)lines->count;
    bat_release(first);
    return BATTEN_OK;
}

static batten_status check_levels(int level_count, const double *levels, double tolerance,
                                  double size)
{
    /* Below some ten thousand roundings of a coordinate, chords are noise. */
    const double least = 1e-11 * size;
    if (!(tolerance > 0) || !isfinite(tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of contours is %g, not above 0",
                        tolerance);
    if (tolerance < least)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "contours cannot be within %g: points of a shape that is %g wide are "
                        "known to %.3g",
                        tolerance, size, least);
    for (int i = 0; i < level_count; i++) {
        if (!isfinite(levels[i]))
            return bat_fail(BATTEN_NOT_FINITE, "level %d is %g", i + 1, levels[i]);
        if (i > 0 && levels[i] <= levels[i - 1])
            return bat_fail(BATTEN_NOT_INCREASING,
                            "level %d is %g, not above the one before, %g", i + 1, levels[i],
                            levels[i - 1]);
    }
    return BATTEN_OK;
}

batten_status bat_contours(const bat_pieces *pieces, const batten_surface_field *field,
                           int level_count, const double *levels, double tolerance, bool smooth,
                           const batten_job *job, batten_contours *out)
{
    batten_surface_field prepared;
    batten_status status = check_levels(level_count, levels, tolerance, pieces->size);
    if (status == BATTEN_OK)
        status = bat_field_prepare(field, &prepared);
    if (status != BATTEN_OK)
        return status;
    bat_net net = {.pieces = pieces,
                   .field = &prepared,
                   .order = bat_field_order(&prepared),
                   .level_count = level_count,
                   .levels = levels,
                   .work = {job, 0}};
    /* Ends of lines that differ by some million roundings are the same: they are computed in two
     * pieces, with parameters of their own. */
    bat_lines lines = {.work = &net.work,
                       .smooth = smooth,
                       .tolerance = tolerance,
                       .near = 1e-9 * pieces->size};
    batten_contours made = {0};
    status = bat_net_build(&net);
    if (status == BATTEN_OK)
        status = bat_lines_trace(&net, &lines);
    if (status == BATTEN_OK)
        status = bat_lines_join(&lines);
    if (status == BATTEN_OK)
        status = hand_over_lines(&lines, &made);
    if (status == BATTEN_OK) {
        made.critical_count = net.critical_count;
        made.critical = net.criticals;
        net.criticals = NULL;
        made.least = net.least;
        made.greatest = net.greatest;
        made.error = lines.error;
        *out = made;
    } else {
        batten_contours_release(&made);
    }
    bat_lines_free(&lines);
    bat_net_free(&net);
    return status;
}

void batten_contours_release(batten_contours *contours)
{
    for (int i = 0; contours->lines && i < contours->count; i++) {
        bat_release(contours->lines[i].line.points);
        bat_release(contours->lines[i].line.parameters);
        bat_release(contours->lines[i].arms);
    }
    bat_release(contours->lines);
    bat_release(contours->critical);
    *contours = (batten_contours){0};
}

/* ---- surfaces ---- */

typedef struct {
    const batten_surface *surface;
    int count[2]; /* of knots */
    double *knots[2];
    int *nodes;
    double *uv;
} spans;

static void spans_free(spans *s)
{
    bat_release(s->knots[0]);
    bat_release(s->knots[1]);
    bat_release(s->nodes);
    bat_release(s->uv);
}

/* At the high knots of a span the derivatives are those from inside it. */
static batten_status evaluate_span(const void *shape, int piece, const double uv[2], int order,
                                   double *out)
{
    const spans *s = shape;
    const int across = s->count[1] - 1;
    const int i = piece / across, j = piece % across;
    const double u = bat_max(s->knots[0][i], bat_min(uv[0], s->knots[0][i + 1]));
    const double v = bat_max(s->knots[1][j], bat_min(uv[1], s->knots[1][j + 1]));
    return batten_surface_evaluate_side(
        s->surface, u, v,
        (batten_sides){u < s->knots[0][i + 1] ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT,
                       v < s->knots[1][j + 1] ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT},
        order, out);
}

static batten_status list_spans(spans *s)
{
    for (int k = 0; k < 2; k++) {
        s->count[k] = batten_surface_spans(s->surface, (batten_direction)k, NULL);
        s->knots[k] = bat_array((size_t)s->count[k], sizeof *s->knots[k]);
        if (!s->knots[k])
            return BATTEN_OUT_OF_MEMORY;
        batten_surface_spans(s->surface, (batten_direction)k, s->knots[k]);
    }
    const size_t m = (size_t)s->count[0] - 1, n = (size_t)s->count[1] - 1;
    /* Each span becomes four triangles at least. */
    if ((double)m * (double)n > 262144)
        return bat_fail(BATTEN_TOO_LARGE,
                        "contours of a surface of %zu x %zu spans: more than a "
                        "million triangles",
                        m, n);
    s->nodes = bat_array3(m, n, 4 * sizeof *s->nodes);
    s->uv = bat_array3(m, n, 8 * sizeof *s->uv);
    if (!s->nodes || !s->uv)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < m; i++)
        for (size_t j = 0; j < n; j++) {
            static const size_t corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
            for (size_t k = 0; k < 4; k++) {
                const size_t a = i + corners[k][0], b = j + corners[k][1];
                const size_t at = 4 * (i * n + j) + k;
                s->nodes[at] = (int)(a * (n + 1) + b);
                s->uv[2 * at] = s->knots[0][a];
                s->uv[2 * at + 1] = s->knots[1][b];
            }
        }
    return BATTEN_OK;
}

static batten_status check_space(const batten_surface *surface)
{
    const int d = batten_surface_dimension(surface);
    return d == 3 ? BATTEN_OK
                  : bat_fail(BATTEN_NOT_COMPATIBLE,
                             "a surface in %d dimension%s has no fields: it must be in space",
                             d, bat_plural(d));
}

static double size_of(const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    return bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
}

static batten_status surface_contours(const batten_surface *surface,
                                      const batten_surface_field *field, int level_count,
                                      const double *levels, double tolerance, bool smooth,
                                      const batten_job *job, batten_contours *out)
{
    spans s = {.surface = surface};
    batten_status status = check_space(surface);
    if (status == BATTEN_OK)
        status = list_spans(&s);
    if (status == BATTEN_OK) {
        const bat_pieces pieces = {.shape = &s,
                                   .evaluate = evaluate_span,
                                   .piece_count = (s.count[0] - 1) * (s.count[1] - 1),
                                   .corner_count = 4,
                                   .nodes = s.nodes,
                                   .uv = s.uv,
                                   .node_count = s.count[0] * s.count[1],
                                   .size = size_of(surface)};
        status = bat_contours(&pieces, field, level_count, levels, tolerance, smooth, job, out);
    }
    spans_free(&s);
    return status;
}

batten_status batten_surface_contours(const batten_surface *surface,
                                      const batten_surface_field *field, batten_levels levels,
                                      double tolerance, const batten_job *job,
                                      batten_contours *out)
{
    return surface_contours(surface, field, levels.count, levels.at, tolerance, false, job,
                            out);
}

batten_status batten_surface_smooth_contours(const batten_surface *surface,
                                             const batten_surface_field *field,
                                             batten_levels levels, double tolerance,
                                             const batten_job *job, batten_contours *out)
{
    return surface_contours(surface, field, levels.count, levels.at, tolerance, true, job, out);
}

batten_status batten_surface_field_values(const batten_surface *surface,
                                          const batten_surface_field *field, size_t count,
                                          const double *uv, double *values)
{
    batten_surface_field prepared;
    batten_status status = check_space(surface);
    if (status == BATTEN_OK)
        status = bat_field_prepare(field, &prepared);
    if (status != BATTEN_OK)
        return status;
    const int order = bat_field_order(&prepared);
    for (size_t i = 0; i < count; i++) {
        double derivatives[3 * BATTEN_SURFACE_DERIVATIVES(3)], gradient[2];
        status = batten_surface_evaluate(surface, uv[2 * i], uv[2 * i + 1], order, derivatives);
        if (status != BATTEN_OK)
            return status;
        values[i] = bat_field_value(&prepared, derivatives, gradient);
    }
    return BATTEN_OK;
}
