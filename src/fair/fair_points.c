/* Points of a curve faired within bounds: blunders first, then sweeps or the least energy. */
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
} springback;

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
static void set_frame(springback *s, int i)
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

static void set_bounds(springback *s)
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

static bat_ducks ducks_of(const springback *s, int first)
{
    const size_t w = (size_t)s->width, at = (size_t)first;
    return (bat_ducks){.width = s->width,
                       .centre = s->points + at * w,
                       .within = s->within + at,
                       .freedom = s->freedom + at,
                       .frames = s->frames + at * w * w};
}

/* Which duck is under the largest force of those that would move; -1 for none. `to` is where.
 */
static int worst_duck(const bat_batten *batten, const bat_ducks *ducks, const double *z,
                      const double *forces, double relaxation, double *to)
{
    const int w = ducks->width;
    const double zero[3] = {0};
    double worst = 0;
    int found = -1;
    for (int i = 0; i < batten->count; i++) {
        double place[3];
        const double force = bat_distance(w, forces + i * w, zero);
        if (ducks->freedom[i] == 0 || force <= worst)
            continue;
        /* A thousandth part of what the sweeps stop at: to release less is no gain. */
        bat_duck_release(batten, ducks, i, z + i * w, forces + i * w, relaxation, place);
        if (bat_distance(w, z + i * w, place) > 1e-9 * ducks->within[i]) {
            worst = force;
            found = i;
            memcpy(to, place, (size_t)w * sizeof *to);
        }
    }
    return found;
}

static batten_status worst_first(const springback *s, const bat_batten *batten, int first,
                                 double *z)
{
    const int n = batten->count, w = s->width;
    const bat_ducks ducks = ducks_of(s, first);
    const int most = s->options->max_moves > 0 ? s->options->max_moves : 20 * n;
    bat_work work = {s->job, 0};
    double *moments = bat_array3((size_t)n, 2 * (size_t)w, sizeof *moments);
    if (!moments)
        return BATTEN_OUT_OF_MEMORY;
    double *forces = moments + (size_t)n * (size_t)w, to[3];
    batten_status status = BATTEN_OK;
    bool done = false;
    for (int k = 0; status == BATTEN_OK && !done && k < most; k++) {
        bat_batten_bend(batten, w, z, moments, forces);
        const int i = worst_duck(batten, &ducks, z, forces, s->options->relaxation, to);
        done = i < 0;
        if (!done)
            memcpy(z + i * w, to, (size_t)w * sizeof *z);
        if (!done && s->options->stop_when_fair)
            status = bat_batten_is_fair(
                batten, &(bat_batten_points){w, s->points + first * w, s->within + first, z},
                &done);
        if (status == BATTEN_OK)
            status = bat_work_step(&work, (uint64_t)n, k / (double)most, "fairing");
    }
    bat_release(moments);
    return status;
}

/* Let every second duck go, from `parity` on, and hold the others where they are. */
static batten_status release_half(const springback *s, const bat_batten *batten, int first,
                                  int parity, double *centre, int *freedom, double *z,
                                  double *change)
{
    const int w = s->width;
    const size_t row = (size_t)w * sizeof *z;
    bat_ducks ducks = ducks_of(s, first);
    for (int i = 0; i < batten->count; i++) {
        const bool free = i % 2 == parity;
        freedom[i] = free ? ducks.freedom[i] : 0;
        memcpy(centre + i * w, free ? ducks.centre + i * w : z + i * w, row);
    }
    ducks.centre = centre;
    ducks.freedom = freedom;
    double *next = bat_array((size_t)batten->count, row), residual;
    if (!next)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = bat_batten_least(batten, &ducks, s->job, next, &residual);
    for (int i = 0; status == BATTEN_OK && i < batten->count; i++)
        if (freedom[i] > 0)
            *change =
                bat_max(*change, bat_distance(w, z + i * w, next + i * w) / ducks.within[i]);
    if (status == BATTEN_OK)
        memcpy(z, next, (size_t)batten->count * row);
    bat_release(next);
    return status;
}

static batten_status alternate(const springback *s, const bat_batten *batten, int first,
                               double *z)
{
    const int n = batten->count, rounds = s->options->max_moves > 0
                                              ? bat_max_int(1, s->options->max_moves / n)
                                              : 100;
    double *centre = bat_array3((size_t)n, (size_t)s->width, sizeof *centre);
    int *freedom = bat_array((size_t)n, sizeof *freedom);
    batten_status status = centre && freedom ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    double change = HUGE_VAL;
    for (int k = 0; status == BATTEN_OK && k < rounds && change > BAT_DUCK_AT_REST; k++) {
        change = 0;
        for (int parity = 0; status == BATTEN_OK && parity < 2; parity++)
            status = release_half(s, batten, first, parity, centre, freedom, z, &change);
    }
    bat_release(freedom);
    bat_release(centre);
    return status;
}

static batten_status release_ducks(const springback *s, const bat_batten *batten, int first,
                                   double *z)
{
    const bat_ducks ducks = ducks_of(s, first);
    double residual;
    if (s->options->order == BATTEN_FAIR_WORST_FIRST)
        return worst_first(s, batten, first, z);
    if (s->options->order == BATTEN_FAIR_ALTERNATE)
        return alternate(s, batten, first, z);
    return bat_batten_least(batten, &ducks, s->job, z, &residual);
}

/* Moves in the last places are roundoff, not fairing: those ducks keep their bits. */
static void settle_bounds(const springback *s, int first, int count)
{
    const int w = s->width;
    double size = 0;
    for (int i = first * w; i < (first + count) * w; i++)
        size = bat_max(size, fabs(s->points[i]));
    for (int i = first; i < first + count; i++)
        if (bat_distance(w, s->points + i * w, s->z + i * w) <= 16 * DBL_EPSILON * size)
            memcpy(s->z + i * w, s->points + i * w, (size_t)w * sizeof *s->z);
}

static batten_status fair_piece(springback *s, int first, int last)
{
    const int count = last - first + 1;
    bat_batten batten;
    batten_status status = bat_batten_begin(count, s->t + first, &batten);
    if (status != BATTEN_OK)
        return status;
    double *z = s->z + first * s->width;
    if (count >= 4) {
        status = release_ducks(s, &batten, first, z);
        settle_bounds(s, first, count);
    }
    const bat_ducks ducks = ducks_of(s, first);
    if (status == BATTEN_OK && s->tally)
        status = bat_tally_piece(s->tally, &batten, &ducks, false, 0, first, z);
    bat_batten_end(&batten);
    return status;
}

/* ---- the curve ---- */

static batten_status begin_fairing(springback *s)
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

static void end_fairing(springback *s)
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
    if (status != BATTEN_OK)
        return status;
    bat_fair_tally tally = {0};
    springback s = {.width = points.dimension,
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
