/* Strokes: polylines in space, with room for their parameters; and curves as strokes. */
#include "picture/lines/stroke.h"

/* Steps into which each span of a curve is divided. */
static int stroke_steps(const batten_curve *curve)
{
    if (batten_curve_degree(curve) == 1 && !batten_curve_is_rational(curve))
        return 1;
    /* 48 steps on a quarter circle leave the polyline within 1/7,000 of the radius, and a span
     * may turn much more; long splines have short spans and need fewer. */
    const int spans = batten_curve_spans(curve, NULL) - 1;
    return bat_min_int(256, bat_max_int(6, 1024 / bat_max_int(spans, 1)));
}

batten_status bat_divide_spans(int knot_count, const double *knots, int steps, size_t *count,
                               double **out)
{
    double *u = bat_array3((size_t)knot_count, (size_t)steps, sizeof *u);
    if (!u)
        return BATTEN_OUT_OF_MEMORY;
    size_t n = 0;
    for (int i = 0; i + 1 < knot_count; i++)
        for (int k = 0; k < steps; k++)
            u[n++] = knots[i] + (knots[i + 1] - knots[i]) * k / steps;
    u[n++] = knots[knot_count - 1];
    *count = n;
    *out = u;
    return BATTEN_OK;
}

static batten_status parameters_of(const batten_curve *curve, size_t *count, double **out)
{
    const int knot_count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, knots);
    const batten_status status =
        bat_divide_spans(knot_count, knots, stroke_steps(curve), count, out);
    bat_release(knots);
    return status;
}

/* From d coordinates to three, in place; the last point first, since rows grow. */
static void spread(size_t count, int dimension, double *points)
{
    for (size_t i = count; i-- > 0;)
        for (int k = 2; k >= 0; k--)
            points[3 * i + (size_t)k] =
                k < dimension ? points[i * (size_t)dimension + (size_t)k] : 0;
}

batten_status bat_stroke_curve(const batten_curve *curve, bat_stroke *out)
{
    size_t count = 0;
    double *u = NULL;
    batten_status status = parameters_of(curve, &count, &u);
    if (status != BATTEN_OK)
        return status;
    double *points = bat_array3(count, 3, sizeof *points);
    status = points ? batten_curve_evaluate_many(curve, count, u, 0, NULL, points)
                    : BATTEN_OUT_OF_MEMORY;
    bat_release(u);
    if (status != BATTEN_OK) {
        bat_release(points);
        return status;
    }
    spread(count, batten_curve_dimension(curve), points);
    *out = (bat_stroke){count, points};
    return BATTEN_OK;
}

batten_status bat_stroke_isoline(const batten_surface *surface, batten_direction direction,
                                 double at, bat_stroke *out)
{
    batten_curve *curve = NULL;
    batten_status status = batten_surface_isocurve(surface, direction, at, &curve);
    if (status == BATTEN_OK)
        status = bat_stroke_curve(curve, out);
    batten_curve_unref(curve);
    return status;
}

bool bat_stroke_is_point(const bat_stroke *stroke, double tolerance)
{
    for (size_t i = 1; i < stroke->count; i++)
        for (size_t k = 0; k < 3; k++)
            if (fabs(stroke->points[3 * i + k] - stroke->points[k]) > tolerance)
                return false;
    return true;
}

void bat_stroke_free(bat_stroke *stroke)
{
    bat_release(stroke->points);
    *stroke = (bat_stroke){0, NULL};
}

batten_status bat_strokes_add(bat_strokes *list, bat_stroke stroke)
{
    if (list->count == list->capacity) {
        const size_t capacity = 2 * list->capacity + 16;
        bat_stroke *strokes = bat_resize(list->strokes, capacity, sizeof *strokes);
        if (!strokes) {
            bat_stroke_free(&stroke);
            return BATTEN_OUT_OF_MEMORY;
        }
        list->strokes = strokes;
        list->capacity = capacity;
    }
    list->strokes[list->count++] = stroke;
    return BATTEN_OK;
}

void bat_strokes_free(bat_strokes *list)
{
    for (size_t i = 0; i < list->count; i++)
        bat_stroke_free(&list->strokes[i]);
    bat_release(list->strokes);
    *list = (bat_strokes){0, 0, NULL};
}
