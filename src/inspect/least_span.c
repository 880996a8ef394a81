/* The shortest spans of a surface: what knots that nearly coincide leave between them. */
#include "numeric/vector.h"
#include <batten/measure.h>

/* Lines across which a span is followed, and its parts on each. */
enum { LINES = 9, PARTS = 2 };

/* Points at both ends of each span and between, on each of the lines: [places][LINES][d], or with the lines outside for spans
 * along v. */
static batten_status evaluate_lines(const batten_surface *surface, batten_direction direction,
                                    int spans, const double *knots, double *points)
{
    const int count = PARTS * spans + 1;
    const batten_interval other =
        batten_surface_domain(surface, direction == BATTEN_U ? BATTEN_V : BATTEN_U);
    double across[LINES], *along = bat_array((size_t)count, sizeof *along);
    if (!along)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < LINES; i++)
        across[i] = bat_min(other.b, other.a + (other.b - other.a) * i / (LINES - 1));
    for (int i = 0; i < count; i++) {
        const double *span = knots + i / PARTS;
        along[i] = i % PARTS ? span[0] + (span[1] - span[0]) * (i % PARTS) / PARTS : span[0];
    }
    const bool is_u = direction == BATTEN_U;
    const batten_uv_grid grid = {(size_t)(is_u ? count : LINES), (size_t)(is_u ? LINES : count),
                                 is_u ? along : across, is_u ? across : along};
    const batten_status status = batten_surface_evaluate_grid(surface, grid, 0, NULL, points);
    bat_release(along);
    return status;
}

/* The longest of the lines over a span whose first points are `at`.
 * @param step  from a place to the next, and from a line to the next */
static double span_length(int d, const double *at, const size_t step[2])
{
    double longest = 0;
    for (size_t line = 0; line < LINES; line++) {
        double length = 0;
        for (size_t part = 0; part < PARTS; part++) {
            const double *from = at + line * step[1] + part * step[0];
            length += bat_distance(d, from, from + step[0]);
        }
        longest = bat_max(longest, length);
    }
    return longest;
}

/* @param points  as of evaluate_lines */
static batten_least_span find_least(const batten_surface *surface, batten_direction direction,
                                    int count, const double *knots, const double *points)
{
    const batten_interval whole = batten_surface_domain(surface, direction);
    const int d = batten_surface_dimension(surface);
    const size_t width = (size_t)d, long_way = (PARTS * (size_t)count + 1) * width;
    const bool is_u = direction == BATTEN_U;
    const size_t step[2] = {is_u ? LINES * width : width, is_u ? width : long_way};
    batten_least_span found = {HUGE_VAL, HUGE_VAL, whole.a, whole.b, 0};
    for (int k = 0; k < count; k++) {
        const double length = span_length(d, points + PARTS * (size_t)k * step[0], step);
        found.share = bat_min(found.share, (knots[k + 1] - knots[k]) / (whole.b - whole.a));
        found.total += length;
        if (length < found.length) {
            found.length = length;
            found.from = knots[k];
            found.to = knots[k + 1];
        }
    }
    return found;
}

batten_status batten_surface_least_span(const batten_surface *surface,
                                        batten_direction direction, batten_least_span *out)
{
    const int count = batten_surface_spans(surface, direction, NULL) - 1;
    const size_t places = PARTS * (size_t)count + 1;
    double *knots = bat_array((size_t)count + 1, sizeof *knots),
           *points = bat_array3(places, LINES * (size_t)batten_surface_dimension(surface),
                                sizeof *points);
    batten_status status = knots && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_surface_spans(surface, direction, knots);
        status = evaluate_lines(surface, direction, count, knots, points);
    }
    if (status == BATTEN_OK)
        *out = find_least(surface, direction, count, knots, points);
    bat_release(knots);
    bat_release(points);
    return status;
}
