/* The shortest spans of a surface: what knots that nearly coincide leave between them. */
#include "numeric/vector.h"
#include <batten/measure.h>

/* Lines across which a span is followed, and its parts on each. */
enum { LINES = 9, PARTS = 2 };

static batten_status line_length(const batten_surface *surface, batten_direction direction,
                                 batten_interval span, double across, double *length)
{
    double before[3] = {0}, point[3] = {0};
    const int d = batten_surface_dimension(surface);
    *length = 0;
    for (int i = 0; i <= PARTS; i++) {
        const double t = span.a + (span.b - span.a) * i / PARTS;
        const double at = i == PARTS ? span.b : t;
        const batten_status status =
            batten_surface_evaluate(surface, direction == BATTEN_U ? at : across,
                                    direction == BATTEN_U ? across : at, 0, point);
        if (status != BATTEN_OK)
            return status;
        if (i > 0)
            *length += bat_distance(d, before, point);
        for (int c = 0; c < d; c++)
            before[c] = point[c];
    }
    return BATTEN_OK;
}

/* The longest of the lines over a span. */
static batten_status span_length(const batten_surface *surface, batten_direction direction,
                                 batten_interval span, double *length)
{
    const batten_interval other =
        batten_surface_domain(surface, direction == BATTEN_U ? BATTEN_V : BATTEN_U);
    *length = 0;
    for (int i = 0; i < LINES; i++) {
        double here;
        const batten_status status = line_length(
            surface, direction, span,
            bat_min(other.b, other.a + (other.b - other.a) * i / (LINES - 1)), &here);
        if (status != BATTEN_OK)
            return status;
        *length = bat_max(*length, here);
    }
    return BATTEN_OK;
}

batten_status batten_surface_least_span(const batten_surface *surface,
                                        batten_direction direction, batten_least_span *out)
{
    const int count = batten_surface_spans(surface, direction, NULL) - 1;
    const batten_interval whole = batten_surface_domain(surface, direction);
    batten_least_span found = {HUGE_VAL, HUGE_VAL, whole.a, whole.b, 0};
    double *knots = bat_array((size_t)count + 1, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, direction, knots);
    batten_status status = BATTEN_OK;
    for (int k = 0; k < count && status == BATTEN_OK; k++) {
        double length = 0;
        const batten_interval span = {knots[k], knots[k + 1]};
        status = span_length(surface, direction, span, &length);
        found.share = bat_min(found.share, (span.b - span.a) / (whole.b - whole.a));
        found.total += length;
        if (length < found.length) {
            found.length = length;
            found.from = span.a;
            found.to = span.b;
        }
    }
    bat_release(knots);
    if (status == BATTEN_OK)
        *out = found;
    return status;
}
