/* Strokes: polylines in space, with room for their parameters; and curves as strokes. */
#include "base/list.h"
#include "numeric/box.h"
#include "picture/lines/trace.h"

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

/* Of its size: 0.03 pixels in a picture of 1200, less than half a pixel in the largest. */
static const double share_of_size = 1.0 / 40000;

static batten_status point_of_curve(const void *user, double at, bool from_left,
                                    double point[3])
{
    const batten_side side = from_left ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
    return batten_curve_evaluate_side(user, at, side, 0, point);
}

batten_status bat_stroke_curve(const batten_curve *curve, bat_stroke *out)
{
    const int knot_count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, knots);
    const bat_traced traced = {
        .point_at = point_of_curve,
        .user = curve,
        .tolerance = share_of_size * bat_box_diagonal(batten_curve_box(curve)),
        .is_straight = batten_curve_degree(curve) == 1 && !batten_curve_is_rational(curve)};
    const batten_status status = bat_trace(&traced, knot_count, knots, out);
    bat_release(knots);
    return status;
}

batten_status bat_stroke_isoline(const batten_surface *surface, batten_direction direction,
                                 double at, bat_stroke *out)
{
    return bat_stroke_isoline_within(
        surface, direction, at, share_of_size * bat_box_diagonal(batten_surface_box(surface)),
        out);
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
    const batten_status status =
        BAT_LIST_ADD(list->strokes, list->count, list->capacity, stroke);
    if (status != BATTEN_OK)
        bat_stroke_free(&stroke);
    return status;
}

void bat_strokes_free(bat_strokes *list)
{
    for (size_t i = 0; i < list->count; i++)
        bat_stroke_free(&list->strokes[i]);
    bat_release(list->strokes);
    *list = (bat_strokes){0, 0, NULL};
}
