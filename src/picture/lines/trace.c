/* How finely a drawn line follows its curve: spans are halved until their chords are near. */
#include "picture/lines/trace.h"
#include "base/list.h"
#include "numeric/vector.h"

#include <string.h>

/* A span is cut in so many parts at most, in fewer where there are many spans, and each part is
 * halved so often at most. */
enum { PARTS = 4, ENOUGH_PARTS = 4096, DEPTH = 12 };

typedef struct {
    double at, point[3];
} spot;

typedef struct {
    const bat_traced *traced;
    size_t count, capacity;
    double (*points)[3];
} polyline;

static batten_status evaluate(const polyline *line, double at, bool from_left, spot *out)
{
    double point[3] = {0, 0, 0};
    const batten_status status =
        line->traced->point_at(line->traced->user, at, from_left, point);
    out->at = at;
    memcpy(out->point, point, sizeof point);
    return status;
}

static batten_status add_point(polyline *line, const double point[3])
{
    const batten_status status = BAT_LIST_GROW(line->points, line->count, line->capacity, 1);
    if (status == BATTEN_OK)
        memcpy(line->points[line->count++], point, sizeof *line->points);
    return status;
}

/* From `here`, which is there already, to `end`. A chord is kept when the points in its middle
 * and at its first quarter are near: two, for an inflection may lie in the middle. */
static batten_status subdivide(polyline *line, spot here, spot end)
{
    const double tolerance = line->traced->tolerance;
    spot stack[DEPTH + 1] = {end}, middle, quarter;
    int depth = 0;
    batten_status status = BATTEN_OK;
    while (depth >= 0 && status == BATTEN_OK) {
        const spot next = stack[depth];
        status = evaluate(line, 0.5 * (here.at + next.at), false, &middle);
        double off = bat_segment_distance(3, here.point, next.point, middle.point);
        if (status == BATTEN_OK && off <= tolerance) {
            status = evaluate(line, 0.75 * here.at + 0.25 * next.at, false, &quarter);
            off = bat_max(off, bat_segment_distance(3, here.point, next.point, quarter.point));
        }
        if (off > tolerance && depth < DEPTH) {
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

/* From `here` at knots[0] to knots[1], where `here` is then. */
static batten_status trace_span(polyline *line, int parts, const double *knots, spot *here)
{
    batten_status status = BATTEN_OK;
    for (int k = 1; k <= parts && status == BATTEN_OK; k++) {
        const bool last = k == parts;
        const double at = last ? knots[1] : knots[0] + (knots[1] - knots[0]) * k / parts;
        spot next;
        status = evaluate(line, at, last, &next);
        if (status == BATTEN_OK)
            status = line->traced->is_straight ? add_point(line, next.point)
                                               : subdivide(line, *here, next);
        *here = next;
    }
    return status;
}

static batten_status trace_spans(polyline *line, int count, const double *knots)
{
    const int parts = line->traced->is_straight
                          ? 1
                          : bat_max_int(1, bat_min_int(PARTS, ENOUGH_PARTS / count));
    spot here;
    batten_status status = evaluate(line, knots[0], false, &here);
    if (status == BATTEN_OK)
        status = add_point(line, here.point);
    for (int i = 0; i + 1 < count && status == BATTEN_OK; i++) {
        if (i > 0 && line->traced->jumps) {
            status = evaluate(line, knots[i], false, &here);
            if (status == BATTEN_OK)
                status = add_point(line, here.point);
        }
        if (status == BATTEN_OK)
            status = trace_span(line, parts, knots + i, &here);
    }
    return status;
}

batten_status bat_trace(const bat_traced *traced, int knot_count, const double *knots,
                        bat_stroke *out)
{
    polyline line = {.traced = traced};
    const batten_status status = trace_spans(&line, knot_count, knots);
    if (status == BATTEN_OK)
        *out = (bat_stroke){line.count, line.points[0]};
    else
        bat_release(line.points);
    return status;
}
