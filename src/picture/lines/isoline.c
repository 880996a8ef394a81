/* Isoparametric lines of any surface as adaptive polylines. */
#include "picture/lines/stroke.h"

#include <string.h>

/* A span is cut in so many parts, and each halved so often at most. */
enum { PARTS = 4, DEPTH = 12 };

typedef struct {
    double at, point[3];
} spot;

typedef struct {
    const batten_surface *surface;
    batten_direction direction; /* which parameter is fixed */
    double fixed, tolerance;
    batten_side side; /* of the fixed parameter */
    size_t count, capacity;
    double *points;
} isoline;

static batten_status evaluate(const isoline *line, double at, bool from_left, spot *out)
{
    double point[3] = {0, 0, 0};
    const batten_side side = from_left ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
    const bool u_fixed = line->direction == BATTEN_U;
    const batten_status status = batten_surface_evaluate_side(
        line->surface, u_fixed ? line->fixed : at, u_fixed ? at : line->fixed,
        (batten_sides){u_fixed ? line->side : side, u_fixed ? side : line->side}, 0, point);
    out->at = at;
    memcpy(out->point, point, sizeof point);
    return status;
}

static batten_status add_point(isoline *line, const double point[3])
{
    if (line->count == line->capacity) {
        const size_t capacity = 2 * line->capacity + 32;
        double *larger = bat_resize(line->points, capacity, 3 * sizeof *larger);
        if (!larger)
            return BATTEN_OUT_OF_MEMORY;
        line->points = larger;
        line->capacity = capacity;
    }
    memcpy(line->points + 3 * line->count++, point, 3 * sizeof *point);
    return BATTEN_OK;
}

/* The distance of p from the segment from a to b. */
static double off_chord(const double *a, const double *b, const double *p)
{
    double length2 = 0, dot = 0, sum = 0;
    for (int k = 0; k < 3; k++) {
        length2 += (b[k] - a[k]) * (b[k] - a[k]);
        dot += (b[k] - a[k]) * (p[k] - a[k]);
    }
    const double s = length2 > 0 ? bat_max(0, bat_min(1, dot / length2)) : 0;
    for (int k = 0; k < 3; k++) {
        const double d = p[k] - a[k] - s * (b[k] - a[k]);
        sum += d * d;
    }
    return sqrt(sum);
}

/* From `here`, which is there already, to `end`. A chord is kept when the points in its middle
 * and at its first quarter are near: two, for an inflection may lie in the middle. */
static batten_status subdivide(isoline *line, spot here, spot end)
{
    spot stack[DEPTH + 1] = {end}, middle, quarter;
    int depth = 0;
    batten_status status = BATTEN_OK;
    while (depth >= 0 && status == BATTEN_OK) {
        const spot next = stack[depth];
        status = evaluate(line, 0.5 * (here.at + next.at), false, &middle);
        double off = off_chord(here.point, next.point, middle.point);
        if (status == BATTEN_OK && off <= line->tolerance) {
            status = evaluate(line, 0.75 * here.at + 0.25 * next.at, false, &quarter);
            off = bat_max(off, off_chord(here.point, next.point, quarter.point));
        }
        if (off > line->tolerance && depth < DEPTH) {
            stack[++depth] = middle;
            continue;
        }
        depth--;
        here = next;
        if (status == BATTEN_OK)
            status = add_point(line, here.point);
    }
    return status;
}

static batten_status trace_isoline(isoline *line, int count, const double *knots)
{
    spot here, next;
    batten_status status = evaluate(line, knots[0], false, &here);
    if (status == BATTEN_OK)
        status = add_point(line, here.point);
    for (int i = 0; i + 1 < count; i++)
        for (int k = 1; k <= PARTS && status == BATTEN_OK; k++) {
            const bool last = k == PARTS;
            const double at =
                last ? knots[i + 1] : knots[i] + (knots[i + 1] - knots[i]) * k / PARTS;
            status = evaluate(line, at, last, &next);
            if (status == BATTEN_OK)
                status = subdivide(line, here, next);
            here = next;
        }
    return status;
}

batten_status bat_stroke_isoline_within(const batten_surface *surface,
                                        batten_direction direction, double at, double tolerance,
                                        bat_stroke *out)
{
    const batten_direction along = direction == BATTEN_U ? BATTEN_V : BATTEN_U;
    isoline line = {.surface = surface,
                    .direction = direction,
                    .fixed = at,
                    .tolerance = tolerance,
                    .side = at >= batten_surface_domain(surface, direction).b
                                ? BATTEN_FROM_LEFT
                                : BATTEN_FROM_RIGHT};
    const int count = batten_surface_spans(surface, along, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, along, knots);
    const batten_status status = trace_isoline(&line, count, knots);
    bat_release(knots);
    if (status == BATTEN_OK)
        *out = (bat_stroke){line.count, line.points};
    else
        bat_release(line.points);
    return status;
}
