/* Isoparametric lines of any surface, handed to trace.c, which halves them until chords are near. */
#include "picture/lines/trace.h"

typedef struct {
    const batten_surface *surface;
    batten_direction direction; /* which parameter is fixed */
    double fixed;
    batten_side side; /* of the fixed parameter */
} isoline;

static batten_status point_of_isoline(const void *user, double at, bool from_left,
                                      double point[3])
{
    const isoline *line = user;
    const batten_side side = from_left ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
    const bool u_fixed = line->direction == BATTEN_U;
    return batten_surface_evaluate_side(
        line->surface, u_fixed ? line->fixed : at, u_fixed ? at : line->fixed,
        (batten_sides){u_fixed ? line->side : side, u_fixed ? side : line->side}, 0, point);
}

batten_status bat_stroke_isoline_within(const batten_surface *surface,
                                        batten_direction direction, double at, double tolerance,
                                        bat_stroke *out)
{
    const batten_direction along = direction == BATTEN_U ? BATTEN_V : BATTEN_U;
    const isoline line = {surface, direction, at,
                          at >= batten_surface_domain(surface, direction).b
                              ? BATTEN_FROM_LEFT
                              : BATTEN_FROM_RIGHT};
    const int count = batten_surface_spans(surface, along, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, along, knots);
    const bat_traced traced = {
        .point_at = point_of_isoline, .user = &line, .tolerance = tolerance};
    const batten_status status = bat_trace(&traced, count, knots, out);
    bat_release(knots);
    return status;
}
