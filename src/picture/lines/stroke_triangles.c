/* Strokes on Bezier triangles: their edges and lines of equal parameter. */
#include "picture/lines/stroke.h"

enum { STEPS = 32 };

/* The line b[e] = `at`, from edge to edge. */
static batten_status inner_line(const batten_triangles *triangles, int t, int e, double at,
                                bat_strokes *lines)
{
    double places[3 * (STEPS + 1)];
    int which[STEPS + 1];
    for (int i = 0; i <= STEPS; i++) {
        which[i] = t;
        places[3 * i + e] = at;
        places[3 * i + (e + 2) % 3] = (1 - at) * i / STEPS;
        places[3 * i + (e + 1) % 3] = (1 - at) * (STEPS - i) / STEPS;
    }
    double *points = bat_array3(STEPS + 1, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_triangles_evaluate_many(
        triangles, (batten_triangle_places){STEPS + 1, which, places}, 0, NULL, points);
    if (status == BATTEN_OK)
        return bat_strokes_add(lines, (bat_stroke){STEPS + 1, points});
    bat_release(points);
    return status;
}

static batten_status edge_line(const batten_triangles *triangles, int t, int e,
                               bat_strokes *lines)
{
    batten_curve *edge = NULL;
    bat_stroke stroke = {0, NULL};
    batten_status status = batten_triangles_edge(triangles, t, e, &edge);
    if (status == BATTEN_OK)
        status = bat_stroke_curve(edge, &stroke);
    if (status == BATTEN_OK)
        status = bat_strokes_add(lines, stroke);
    batten_curve_unref(edge);
    return status;
}

batten_status bat_stroke_triangles(const batten_triangles *triangles, int isolines,
                                   bat_strokes *lines)
{
    const int count = batten_triangles_count(triangles);
    const int steps = (int)(isolines / sqrt(count));
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 3 * count && status == BATTEN_OK; i++)
        status = edge_line(triangles, i / 3, i % 3, lines);
    for (int i = 0; i < 3 * count && status == BATTEN_OK; i++)
        for (int k = 1; k < steps && status == BATTEN_OK; k++)
            status = inner_line(triangles, i / 3, i % 3, (double)k / steps, lines);
    return status;
}
