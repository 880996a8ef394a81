/* Points of a curve faired within bounds: what was given is checked, cut at corners, and handed piece by piece to a method. */
#include "fair/fair_points.h"
#include "base/plural.h"
#include "base/work.h"
#include "fair/fairness.h"
#include "numeric/vector.h"
#include <batten/interpolate.h>

#include <float.h>
#include <string.h>

/* One call: all ducks of the curve, in pieces between corners. */
typedef struct {
    int width, count;
    const double *points, *t;
    const batten_fair_options *options;
    const batten_job *job;
    double *within;        /* [count] */
    int *freedom;          /* [count] */
    double *frames;        /* [count][width][width] */
    double *z;             /* [count][width] */
    bool *is_corner;       /* [count], both ends too */
    double *own_t;         /* [count], when no parameters were given */
    bat_fair_tally *tally; /* NULL when no report is wanted */
} fairing;

/* ---- what the caller gave ---- */

static batten_status check_points(int dimension, int count, const double *points,
                                  const double *parameters, const batten_fair_options *options)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "points have %d coordinates, not 1 to 3",
                        dimension);
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there %s %d point%s, at least 2 are needed",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    const size_t bad = bat_first_not_finite(points, (size_t)count * (size_t)dimension);
    if (bad < (size_t)count * (size_t)dimension)
        return bat_fail(BATTEN_NOT_FINITE, "point %zu is not finite",
                        bad / (size_t)dimension + 1);
    if (dimension == 1 && !parameters)
        return bat_fail(BATTEN_BAD_ARGUMENT, "points of one coordinate need parameters");
    for (int i = 0; parameters && i < count; i++) {
        if (!isfinite(parameters[i]))
            return bat_fail(BATTEN_NOT_FINITE, "parameter %d is %g", i + 1, parameters[i]);
        if (i > 0 && !(parameters[i] > parameters[i - 1]))
            return bat_fail(BATTEN_NOT_INCREASING, "parameter %d is %g, not above %g before it",
                            i + 1, parameters[i], parameters[i - 1]);
    }
    return bat_fair_check_options(count, options);
}

static batten_status check_method(int dimension, batten_fair_method method)
{
    if (method == BATTEN_FAIR_CIRCLE_RATE && dimension != 2)
        return bat_fail(
            BATTEN_UNSUPPORTED,
            "circle rates are of points of the plane, and these have %d coordinate%s",
            dimension, bat_plural(dimension));
    if (method == BATTEN_FAIR_LEAST_CHANGE && dimension == 3)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "the least change removes inflections, and curves in space have none");
    return BATTEN_OK;
}

/* ---- how ducks may move ---- */

/* Complete the unit vector in the last row to an orthonormal frame. */
static void complete_frame(int width, double *frame)
{
    const double *t = frame + (width - 1) * width;
    if (width == 2) {
        frame[0] = -t[1];
        frame[1] = t[0];
        return;
    }
    int least = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(t[k]) < fabs(t[least]))
            least = k;
    double axis[3] = {0};
    axis[least] = 1;
    double cross[3];
    bat_cross(t, axis, cross);
    const double size = bat_hypot(bat_hypot(cross[0], cross[1]), cross[2]);
    for (int k = 0; k < 3; k++)
        frame[k] = cross[k] / size;
    bat_cross(t, frame, frame + 3);
}

/* At right angles to the chord from the last to the next duck; where these coincide, and for a
 * function, freely. */
static void set_frame(fairing *s, int i)
{
    const int w = s->width, before = bat_max_int(i - 1, 0),
              after = bat_min_int(i + 1, s->count - 1);
    double *frame = s->frames + (size_t)i * (size_t)w * (size_t)w;
    const double *a = s->points + (size_t)before * (size_t)w,
                 *b = s->points + (size_t)after * (size_t)w;
    const double chord = bat_distance(w, a, b);
    const bool straight = w > 1 && chord > 0;
    s->freedom[i] = straight ? w - 1 : w;
    for (int k = 0; k < w; k++)
        for (int j = 0; j < w; j++)
            frame[k * w + j] = k == j;
    if (!straight)
        return;
    for (int j = 0; j < w; j++)
        frame[(w - 1) * w + j] = (b[j] - a[j]) / chord;
    complete_frame(w, frame);
}

static void set_bounds(fairing *s)
{
    const batten_fair_options *options = s->options;
    double size = 0;
    for (int i = 0; i < s->count * s->width; i++)
        size = bat_max(size, fabs(s->points[i]));
    s->is_corner[0] = s->is_corner[s->count - 1] = true;
    for (int k = 0; k < options->corner_count; k++)
        s->is_corner[options->corners[k]] = true;
    for (int i = 0; i < s->count; i++) {
        set_frame(s, i);
        s->within[i] = options->within_each ? options->within_each[i] : options->within;
        const bool end = i == 0 || i == s->count - 1;
        const bool held = end ? options->hold_ends : s->is_corner[i];
        /* A bound below the last places of the coordinates leaves no room. */
        if (held || s->within[i] <= 16 * DBL_EPSILON * size)
            s->freedom[i] = 0;
    }
    for (int k = 0; k < options->corner_count; k++)
        s->freedom[options->corners[k]] = 0;
    for (int i = 0; i < s->count; i++)
        if (s->freedom[i] == 0)
            s->within[i] = 0;
}

/* ---- one piece ---- */

static bat_ducks ducks_of(const fairing *s, int first)
{
    const size_t w = (size_t)s->width, at = (size_t)first;
    return (bat_ducks){.width = s->width,
                       .centre = s->points + at * w,
                       .within = s->within + at,
                       .freedom = s->freedom + at,
                       .frames = s->frames + at * w * w};
}

static batten_status (*const methods[])(const bat_fair_piece *piece, double *z) = {
    [BATTEN_FAIR_SPRINGBACK] = bat_fair_springback,
    [BATTEN_FAIR_CIRCLE_RATE] = bat_fair_circle_rate,
    [BATTEN_FAIR_KJELLANDER] = bat_fair_kjellander,
    [BATTEN_FAIR_LEAST_CHANGE] = bat_fair_least_change,
};

/* Moves in the last places are roundoff, not fairing: those ducks keep their bits. */
static void settle_bounds(const fairing *s, int first, int count)
{
    const int w = s->width;
    double size = 0;
    for (int i = first * w; i < (first + count) * w; i++)
        size = bat_max(size, fabs(s->points[i]));
    for (int i = first; i < first + count; i++)
        if (bat_distance(w, s->points + i * w, s->z + i * w) <= 16 * DBL_EPSILON * size)
            memcpy(s->z + i * w, s->points + i * w, (size_t)w * sizeof *s->z);
}

static batten_status fair_piece(fairing *s, int first, int last)
{
    const int count = last - first + 1;
    bat_batten batten;
    batten_status status = bat_batten_begin(count, s->t + first, &batten);
    if (status != BATTEN_OK)
        return status;
    double *z = s->z + first * s->width;
    const bat_ducks ducks = ducks_of(s, first);
    if (count >= 4) {
        const bat_fair_piece piece = {&batten, ducks, s->options, s->job};
        status = methods[s->options->method](&piece, z);
        settle_bounds(s, first, count);
    }
    if (status == BATTEN_OK && s->tally)
        status = bat_tally_piece(s->tally, &batten, &ducks, false, 0, first, z);
    bat_batten_end(&batten);
    return status;
}

/* ---- the curve ---- */

static batten_status begin_fairing(fairing *s)
{
    const size_t n = (size_t)s->count, w = (size_t)s->width;
    s->within = bat_array(n, sizeof *s->within);
    s->freedom = bat_array(n, sizeof *s->freedom);
    s->frames = bat_array3(n, w * w, sizeof *s->frames);
    s->z = bat_array3(n, w, sizeof *s->z);
    s->is_corner = bat_array(n, sizeof *s->is_corner);
    s->own_t = bat_array(n, sizeof *s->own_t);
    if (!s->within || !s->freedom || !s->frames || !s->z || !s->is_corner || !s->own_t)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(s->z, s->points, n * w * sizeof *s->z);
    set_bounds(s);
    if (s->t)
        return BATTEN_OK;
    s->t = s->own_t;
    return batten_parametrize((batten_points){s->width, s->count, s->points}, BATTEN_CHORD,
                              false, s->own_t);
}

static void end_fairing(fairing *s)
{
    bat_release(s->within);
    bat_release(s->freedom);
    bat_release(s->frames);
    bat_release(s->z);
    bat_release(s->is_corner);
    bat_release(s->own_t);
}

batten_status batten_fair_points(batten_points points, const double *parameters,
                                 const batten_fair_options *options, const batten_job *job,
                                 batten_fair_report *report, double *faired)
{
    assert(options);
    batten_fair_options chosen = batten_fair_defaults(0);
    batten_status status = BAT_TAKE_OPTIONS(batten_fair_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    status = check_points(points.dimension, points.count, points.at, parameters, options);
    if (status == BATTEN_OK)
        status = check_method(points.dimension, options->method);
    if (status != BATTEN_OK)
        return status;
    bat_fair_tally tally = {0};
    fairing s = {.width = points.dimension,
                 .count = points.count,
                 .points = points.at,
                 .t = parameters,
                 .options = options,
                 .job = job,
                 .tally = report ? &tally : NULL};
    status = begin_fairing(&s);
    for (int i = 0, next; status == BATTEN_OK && i < points.count - 1; i = next) {
        for (next = i + 1; !s.is_corner[next];)
            next++;
        status = fair_piece(&s, i, next);
    }
    for (int i = 0; status == BATTEN_OK && report && i < points.count; i++)
        status = bat_tally_point(&tally, points.dimension, 0, i,
                                 points.at + i * points.dimension, s.z + i * points.dimension);
    if (status == BATTEN_OK) {
        memcpy(faired, s.z, (size_t)points.count * (size_t)points.dimension * sizeof *faired);
        if (report)
            bat_tally_finish(&tally, report);
    }
    bat_tally_end(&tally);
    end_fairing(&s);
    return status;
}
