/* From sections with common knots to the surface through them. */
#include "numeric/rounding.h"
#include "shape/linear/linear_solve.h"
#include "shape/points/grid_parameters.h"
#include "shape/skin/steps.h"

#include <string.h>

/* ---- across the sections ---- */

batten_status bat_skin_rows(bat_skin *t)
{
    t->rows = bat_array3((size_t)t->count, (size_t)t->points * t->width, sizeof *t->rows);
    if (!t->rows)
        return BATTEN_OUT_OF_MEMORY;
    const size_t d = (size_t)t->dimension;
    double *row = t->rows;
    for (int k = 0; k < t->count; k++) {
        const double *P = batten_curve_points(t->unified[k]);
        const double *w = batten_curve_weights(t->unified[k]);
        for (int i = 0; i < t->points; i++, row += t->width) {
            for (size_t c = 0; c < d; c++)
                row[c] = (w ? w[i] : 1) * P[(size_t)i * d + c];
            if (w)
                row[d] = w[i];
        }
    }
    return BATTEN_OK;
}

batten_status bat_skin_parameters(bat_skin *t)
{
    const size_t d = (size_t)t->dimension, row = (size_t)t->points * d;
    double *points = NULL;
    t->v = bat_array((size_t)t->count + 1, sizeof *t->v);
    if (!t->v)
        return BATTEN_OUT_OF_MEMORY;
    if (t->rational) { /* else the rows are the points */
        points = bat_array3((size_t)t->count, row, sizeof *points);
        if (!points)
            return BATTEN_OUT_OF_MEMORY;
        for (int k = 0; k < t->count; k++)
            memcpy(points + (size_t)k * row, batten_curve_points(t->unified[k]),
                   row * sizeof *points);
    }
    const bat_family family = {.name = "sections",
                               .dimension = t->dimension,
                               .count = t->count,
                               .lines = t->points,
                               .point_step = row,
                               .line_step = d,
                               .periodic = t->options->closed,
                               .points = points ? points : t->rows,
                               .given = t->options->given};
    double spread = 0;
    const batten_status status =
        bat_family_parametrize(&family, t->options->parameters, t->v, &spread);
    bat_release(points);
    return status;
}

static batten_end_kind linear_kind(batten_end_kind kind)
{
    return kind == BATTEN_END_DIRECTION ? BATTEN_END_CLAMPED : kind;
}

bat_request bat_skin_request(const batten_surface_skin_options *o, int count, const double *v)
{
    return (bat_request){.degree = o->degree,
                         .count = count,
                         .parameters = v,
                         .knots_at_data = o->degree % 2 == 1,
                         .periodic = o->closed,
                         .start = linear_kind(o->start.kind),
                         .end = linear_kind(o->end.kind)};
}

/* What the end asks of each control point: the same derivative of the surface along the whole
 * section, or the same direction with the length of the chord. Weights do not change there. */
static void fill_end(const bat_skin *t, const batten_end *end, int here, int next,
                     double *values)
{
    const size_t d = (size_t)t->dimension;
    const double step = fabs(t->v[next] - t->v[here]), length = bat_norm((int)d, end->vector);
    const double *P = batten_curve_points(t->unified[here]),
                 *Q = batten_curve_points(t->unified[next]);
    const double *w = batten_curve_weights(t->unified[here]);
    for (size_t i = 0; i < (size_t)t->points; i++) {
        double factor = w ? w[i] : 1;
        if (end->kind == BATTEN_END_DIRECTION)
            factor *= bat_distance((int)d, P + i * d, Q + i * d) / step / length;
        for (size_t c = 0; c < d; c++)
            values[i * t->width + c] = factor * end->vector[c];
    }
}

/* Is this end a point that becomes a smooth pole? */
static bool is_smooth_pole(const bat_skin *t, int tip, int next)
{
    return t->options->smooth_poles && !t->options->closed && t->point[tip] && !t->point[next];
}

/* A pole and the plane in which the surface leaves it: that of the section next to it. */
typedef struct {
    int dimension;
    batten_vec3 pole, normal;
} pole_plane;

static batten_status find_pole_plane(const bat_skin *t, int here, int next, pole_plane *plane)
{
    const int d = t->dimension, n = t->points;
    const double *Q = batten_curve_points(t->unified[next]);
    const batten_vec3 pole = bat_vec3_of(d, batten_curve_points(t->unified[here]));
    batten_vec3 area = {0, 0, 0};
    double size = 0;
    for (int i = 0; i < n; i++) {
        const batten_vec3 a = bat_vec3_subtract(bat_vec3_of(d, Q + i * d), pole);
        const batten_vec3 b = bat_vec3_subtract(bat_vec3_of(d, Q + (i + 1) % n * d), pole);
        area = bat_vec3_add(area, bat_vec3_cross(a, b));
        size = bat_max(size, bat_vec3_norm(a));
    }
    const double length = bat_vec3_norm(area);
    if (!(length > BAT_ROUNDING * size * size))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "section %d, next to the smooth pole, is straight and has no plane",
                        next + 1);
    *plane = (pole_plane){d, pole, bat_vec3_scale(area, 1 / length)};
    return BATTEN_OK;
}

/* From the pole to a point, without its height above the plane. */
static batten_vec3 flat_from_pole(const pole_plane *plane, const double *point, double *height)
{
    const batten_vec3 r = bat_vec3_subtract(bat_vec3_of(plane->dimension, point), plane->pole);
    *height = bat_vec3_dot(r, plane->normal);
    return bat_vec3_subtract(r, bat_vec3_scale(plane->normal, *height));
}

/*
 * How much longer the arcs are that leave the pole in the plane for the points of the section than those points are
 * wide of it, by least squares. One factor serves the whole section: the surface about the pole is then the section
 * itself, drawn smaller, and has no crease that the section has not. A factor for each control point gives creases
 * where knots are double, as on circles.
 */
static batten_status measure_arcs(const pole_plane *plane, const batten_curve *section,
                                  double *factor)
{
    const int spans = batten_curve_spans(section, NULL) - 1,
              each = batten_curve_degree(section);
    double arcs = 0, squares = 0, *knots = bat_array((size_t)spans + 1, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(section, knots);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < spans * each && status == BATTEN_OK; i++) {
        const double s = (i % each + 0.5) / each;
        double point[3], height;
        status = batten_curve_evaluate(
            section, (1 - s) * knots[i / each] + s * knots[i / each + 1], 0, point);
        if (status != BATTEN_OK)
            break;
        const double wide = bat_vec3_norm(flat_from_pole(plane, point, &height));
        const double angle = bat_atan2(fabs(height), wide);
        arcs += wide * bat_hypot(wide, height) * (angle > 0 ? angle / bat_sin(angle) : 1);
        squares += wide * wide;
    }
    bat_release(knots);
    if (status == BATTEN_OK)
        *factor = arcs / squares;
    return status;
}

/* Derivatives at a pole, of homogeneous rows. */
static batten_status fill_pole(const bat_skin *t, int here, int next, double *values)
{
    const size_t d = (size_t)t->dimension;
    const double *Q = batten_curve_points(t->unified[next]);
    const double *w = batten_curve_weights(t->unified[here]);
    const double step = t->v[next] - t->v[here]; /* negative at the end */
    pole_plane plane;
    double factor = 1;
    batten_status status = find_pole_plane(t, here, next, &plane);
    if (status == BATTEN_OK)
        status = measure_arcs(&plane, t->unified[next], &factor);
    for (size_t i = 0; i < (size_t)t->points && status == BATTEN_OK; i++) {
        double height;
        const batten_vec3 flat = flat_from_pole(&plane, Q + i * d, &height);
        const double parts[3] = {flat.x, flat.y, flat.z};
        for (size_t c = 0; c < d; c++)
            values[i * t->width + c] = (w ? w[i] : 1) * factor / step * parts[c];
    }
    return status;
}

/* What the ends ask: `start` and `end`, and the kinds of both in the request. */
static batten_status fill_ends(const bat_skin *t, bat_request *request, double *start,
                               double *end)
{
    const int last = t->count - 1;
    const bool poles[2] = {is_smooth_pole(t, 0, 1), is_smooth_pole(t, last, last - 1)};
    batten_status status = BATTEN_OK;
    if ((poles[0] || poles[1]) && t->options->degree % 2 == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a smooth pole needs an odd degree, and it is %d",
                        t->options->degree);
    fill_end(t, &t->options->start, 0, 1, start);
    fill_end(t, &t->options->end, last, last - 1, end);
    if (poles[0]) {
        request->start = BATTEN_END_CLAMPED;
        status = fill_pole(t, 0, 1, start);
    }
    if (poles[1] && status == BATTEN_OK) {
        request->end = BATTEN_END_CLAMPED;
        status = fill_pole(t, last, last - 1, end);
    }
    return status;
}

batten_status bat_skin_across(bat_skin *t)
{
    const batten_surface_skin_options *o = t->options;
    bat_request request = bat_skin_request(o, t->count, t->v);
    const size_t row = (size_t)t->points * t->width;
    double *ends = bat_array3(2, row, sizeof *ends);
    batten_status status =
        ends ? fill_ends(t, &request, ends, ends + row) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_operator_make(&request, &t->across);
    if (status == BATTEN_OK) {
        t->control = bat_array3((size_t)t->across.count, row, sizeof *t->control);
        const bat_spline_data given = {row, t->rows, ends, ends + row, NULL};
        status = t->control ? bat_operator_apply(&t->across, &given, t->control)
                            : BATTEN_OUT_OF_MEMORY;
    }
    bat_release(ends);
    return status;
}

/* ---- the surface ---- */

/* From homogeneous rows across to Cartesian points and weights along. */
static batten_status divide(const bat_skin *t, double *points, double *weights)
{
    const size_t d = (size_t)t->dimension, across = (size_t)t->across.count;
    for (size_t j = 0; j < across; j++)
        for (size_t i = 0; i < (size_t)t->points; i++) {
            const double *row = t->control + (j * (size_t)t->points + i) * t->width;
            const double weight = t->rational ? row[d] : 1;
            if (!(weight > 0))
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "between the sections the weight of control point (%zu, %zu) "
                                "becomes %g: their "
                                "weights differ too much",
                                i + 1, j + 1, weight);
            for (size_t c = 0; c < d; c++)
                points[(i * across + j) * d + c] = row[c] / weight;
            if (t->rational)
                weights[i * across + j] = weight;
        }
    return BATTEN_OK;
}

/* The first and the last section are the rims to the last bit, so a point stays a pole. */
static void keep_rims(const bat_skin *t, double *points, double *weights)
{
    const size_t d = (size_t)t->dimension, across = (size_t)t->across.count;
    for (size_t end = 0; end < 2 && !t->options->closed; end++) {
        const batten_curve *section = t->unified[end == 0 ? 0 : t->count - 1];
        const size_t j = end == 0 ? 0 : across - 1;
        for (size_t i = 0; i < (size_t)t->points; i++) {
            memcpy(points + (i * across + j) * d, batten_curve_points(section) + i * d,
                   d * sizeof *points);
            if (t->rational)
                weights[i * across + j] = batten_curve_weights(section)[i];
        }
    }
}

batten_status bat_skin_surface(const bat_skin *t, batten_surface **surface)
{
    const size_t total = (size_t)t->points * (size_t)t->across.count;
    double *points = bat_array3(total, (size_t)t->dimension, sizeof *points);
    double *weights = bat_array(total, sizeof *weights);
    batten_status status =
        points && weights ? divide(t, points, weights) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const int p = batten_curve_degree(t->unified[0]);
        const double *U = batten_curve_knots(t->unified[0]) + (t->periodic_u ? p : 0);
        const batten_axis u = {p, t->points, U, t->periodic_u};
        const batten_axis v = {t->across.degree, t->across.count, t->across.knots,
                               t->across.periodic};
        keep_rims(t, points, weights);
        status = batten_surface_create(t->dimension, &u, &v, points,
                                       t->rational ? weights : NULL, surface);
    }
    bat_release(weights);
    bat_release(points);
    return status;
}
