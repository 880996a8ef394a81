/* Rows of points thinned out. */
#include "numeric/vector.h"
#include "spline/data_check.h"
#include <batten/approximate.h>

#include <float.h>

typedef struct {
    int dimension, count;
    const double *points;
    double tolerance, slack;
    bool *keep; /* [count] */
    double work, most;
} thinning;

/* Of a closed row indices continue beyond the end. */
static const double *point_at(const thinning *t, int i)
{
    return t->points + (size_t)(i % t->count) * (size_t)t->dimension;
}

static double chord_distance(const thinning *t, int from, int to, int i)
{
    return bat_segment_distance(t->dimension, point_at(t, from), point_at(t, to),
                                point_at(t, i));
}

/* The point between two that is farthest from their chord; the first of several. */
static int farthest(thinning *t, int from, int to, double *distance)
{
    int worst = from;
    *distance = -1;
    for (int i = from + 1; i < to; i++) {
        const double here = chord_distance(t, from, to, i);
        if (here > *distance) {
            *distance = here;
            worst = i;
        }
    }
    t->work += to - from;
    return worst;
}

static bool fits(thinning *t, int from, int to)
{
    double distance;
    farthest(t, from, to, &distance);
    return distance <= t->tolerance + t->slack;
}

/* Chords as long as can be, found by doubling and then by halves. */
static void walk(thinning *t, int from, int to)
{
    for (int at = from; at < to;) {
        int good = at + 1, bad = to + 1, step = 2;
        while (bad - good > 1) {
            const int next = bad > to ? bat_min_int(to, at + step) : good + (bad - good) / 2;
            if (fits(t, at, next))
                good = next;
            else
                bad = next;
            step *= 2;
        }
        t->keep[good % t->count] = true;
        at = good;
    }
}

/* Split at the farthest point. The larger part waits, so no more than one part for each halving
 * of the row does. */
static void split(thinning *t, int from, int to)
{
    struct {
        int from, to;
    } waiting[32];
    int depth = 0;
    t->keep[from % t->count] = t->keep[to % t->count] = true;
    for (;;) {
        double distance = -1;
        const int at = t->work < t->most ? farthest(t, from, to, &distance) : from;
        if (t->work >= t->most)
            walk(t, from, to);
        const bool done = at == from || !(distance > t->tolerance + t->slack);
        if (done && depth == 0)
            return;
        if (done) {
            depth--;
            from = waiting[depth].from;
            to = waiting[depth].to;
            continue;
        }
        t->keep[at % t->count] = true;
        const bool first = at - from < to - at;
        waiting[depth].from = first ? at : from;
        waiting[depth++].to = first ? to : at;
        from = first ? from : at;
        to = first ? at : to;
    }
}

static int farthest_from(const thinning *t, int from)
{
    int worst = from;
    double most = 0;
    for (int i = 0; i < t->count; i++) {
        const double here = bat_distance(t->dimension, point_at(t, i), point_at(t, from));
        if (here > most) {
            most = here;
            worst = i;
        }
    }
    return worst;
}

/* Two points that no chord could do without: far apart. */
static void split_ring(thinning *t)
{
    const int a = farthest_from(t, 0), b = farthest_from(t, a);
    const int first = bat_min_int(a, b), second = bat_max_int(a, b);
    if (first == second) { /* one place */
        t->keep[0] = t->keep[t->count - 1] = true;
        return;
    }
    split(t, first, second);
    split(t, second, first + t->count);
}

static void measure_thinned(const thinning *t, const int *kept, int kept_count, bool closed,
                            batten_points_thin_report *report)
{
    double squares = 0;
    *report = (batten_points_thin_report){.worst = kept[0]};
    for (int j = 0; j < kept_count - !closed; j++) {
        const int from = kept[j], to = j + 1 < kept_count ? kept[j + 1] : kept[0] + t->count;
        for (int i = from + 1; i < to; i++) {
            const double distance = chord_distance(t, from, to, i);
            squares += distance * distance;
            if (distance > report->error) {
                report->error = distance;
                report->worst = i % t->count;
            }
        }
    }
    report->rms = sqrt(squares / t->count);
}

/* Squares of what lies between two such coordinates are numbers. */
#define MOST_COORDINATE 0x1p500

batten_status batten_points_thin(batten_points points, double tolerance, bool closed,
                                 batten_points_thin_report *report, int *kept, int *kept_count)
{
    assert(points.at && kept && kept_count);
    batten_status status = bat_points_check(points.dimension, points.count, points.at, 1);
    if (status == BATTEN_OK && points.dimension < 2)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 2 or 3",
                          points.dimension);
    if (status == BATTEN_OK && !(tolerance >= 0))
        status = bat_fail(isnan(tolerance) ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT,
                          "the tolerance is %g; it must not be negative", tolerance);
    const double largest =
        status == BATTEN_OK ? bat_largest(points.dimension * points.count, points.at) : 0;
    if (status == BATTEN_OK && largest > MOST_COORDINATE)
        status = bat_fail(BATTEN_OVERFLOW, "a coordinate of %g is too large to measure with",
                          largest);
    if (status != BATTEN_OK)
        return status;
    thinning t = {.dimension = points.dimension,
                  .count = points.count,
                  .points = points.at,
                  .tolerance = tolerance,
                  .most = 32.0 * points.count * (1 + bat_log2(points.count))};
    t.keep = bat_array((size_t)points.count, sizeof *t.keep);
    if (!t.keep)
        return BATTEN_OUT_OF_MEMORY;
    /* A foot on a chord is rounded a few times. */
    t.slack = 4 * DBL_EPSILON * largest;
    if (closed)
        split_ring(&t);
    else
        split(&t, 0, points.count - 1);
    *kept_count = 0;
    for (int i = 0; i < points.count; i++)
        if (t.keep[i])
            kept[(*kept_count)++] = i;
    if (report)
        measure_thinned(&t, kept, *kept_count, closed, report);
    bat_release(t.keep);
    return BATTEN_OK;
}
