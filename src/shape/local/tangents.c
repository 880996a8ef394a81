/* Tangents at points from a few neighbours. */
#include "numeric/vector.h"
#include "shape/local/hermite_data.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

batten_tangents_options batten_tangents_defaults(void)
{
    return (batten_tangents_options){.size = sizeof(batten_tangents_options)};
}

/* The points on their way to tangents. */
typedef struct {
    int d, count;
    const double *points;
    const batten_tangents_options *options;
    double *l;                  /* lengths of the chords */
    double *t;                  /* [count], closed [count + 1]: the parameters */
    double *leaving, *arriving; /* [count][d] */
    batten_tangents_report report;
} tangent_rule;

static const double *vertex(const tangent_rule *t, int i)
{
    return t->points + (size_t)bat_around(t->count, i) * (size_t)t->d;
}

static bool closed(const tangent_rule *t)
{
    return t->options->closed;
}

static int span_count(const tangent_rule *t)
{
    return closed(t) ? t->count : t->count - 1;
}

static double length(const tangent_rule *t, int span)
{
    return t->l[bat_around(t->count, span)];
}

/* ---- chords, and what stands for them beyond an open end ---- */

/* The chord from point i, divided by `scale`; by its length when `scale` is 0. Beyond an end
 * chords are as long as the last one, and their directions continue in equal differences, as
 * Akima's slopes do. */
static void chord(const tangent_rule *t, int i, double scale, double *q)
{
    const int last = t->count - 2;
    const int from = closed(t) ? i : bat_max_int(0, bat_min_int(i, last));
    const double l = length(t, from), *a = vertex(t, from), *b = vertex(t, from + 1);
    for (int k = 0; k < t->d; k++)
        q[k] = (b[k] - a[k]) / (scale > 0 ? scale : l);
    if (from == i || t->count == 2)
        return;
    const int beyond = abs(i - from), next = i < 0 ? 1 : last - 1;
    const double by = length(t, next), *c = vertex(t, next), *d = vertex(t, next + 1);
    for (int k = 0; k < t->d; k++)
        q[k] += beyond * (q[k] - (d[k] - c[k]) / by * (scale > 0 ? l / scale : 1));
}

/* Twice the area between two rows, and its rounding: each row came from points of size
 * `size`. */
static double area(int d, const double *a, const double *b, double size, double *rounding)
{
    const batten_vec3 x = bat_vec3_of(d, a), y = bat_vec3_of(d, b);
    const double na = bat_norm(d, a), nb = bat_norm(d, b);
    *rounding = 8 * DBL_EPSILON * (na * nb + size * (na + nb));
    return bat_vec3_norm(bat_vec3_cross(x, y));
}

/* ---- rules inside the row: T is left without a length where the rule wants none ---- */

/* The derivative at the middle point of the parabola through three, of chord parameters: on a
 * circle it is at right angles to the radius. */
static void parabola_of_three(const tangent_rule *t, int i, double *T)
{
    double u[3], v[3];
    chord(t, i - 1, 0, u);
    chord(t, i, 0, v);
    const double part = length(t, i) / (length(t, i - 1) + length(t, i));
    for (int k = 0; k < t->d; k++)
        T[k] = part * u[k] + (1 - part) * v[k];
}

static void bisector(const tangent_rule *t, int i, double *T)
{
    double u[3], v[3];
    chord(t, i - 1, 0, u);
    chord(t, i, 0, v);
    for (int k = 0; k < t->d; k++)
        T[k] = u[k] + v[k];
}

/* Slopes of one coordinate i - 2 .. i + 1, with what rounding makes of their differences. */
static void akima(const tangent_rule *t, int i, double *T)
{
    double s[4][3], size = 0, least = HUGE_VAL;
    for (int j = 0; j < 4; j++) {
        chord(t, i - 2 + j, 0, s[j]);
        if (closed(t) || (i - 2 + j >= 0 && i - 1 + j < t->count)) {
            least = bat_min(least, length(t, i - 2 + j));
            size = bat_max(size, bat_largest(t->d, vertex(t, i - 2 + j)));
            size = bat_max(size, bat_largest(t->d, vertex(t, i - 1 + j)));
        }
    }
    const double zero = 8 * DBL_EPSILON * (1 + size / least);
    for (int k = 0; k < t->d; k++) {
        double after = fabs(s[3][k] - s[2][k]), before = fabs(s[1][k] - s[0][k]);
        if (after <= zero && before <= zero)
            after = before = 1;
        const double part = after / (after + before);
        T[k] = part * s[1][k] + (1 - part) * s[2][k];
    }
}

/* Where both runs are straight, T is the mean of the chords; true when they make a corner. */
static bool renner(const tangent_rule *t, int i, double *T)
{
    double q[4][3], scale = 0, size = 0, zero_a, zero_b, zero;
    for (int j = -2; j < 2; j++)
        if (closed(t) || (i + j >= 0 && i + j < t->count - 1)) {
            scale = bat_max(scale, length(t, i + j));
            size = bat_max(size, bat_largest(t->d, vertex(t, i + j)));
            size = bat_max(size, bat_largest(t->d, vertex(t, i + j + 1)));
        }
    for (int j = 0; j < 4; j++)
        chord(t, i - 2 + j, scale, q[j]);
    double before = area(t->d, q[0], q[1], size / scale, &zero_a);
    double after = area(t->d, q[2], q[3], size / scale, &zero_b);
    const bool straight = before <= zero_a && after <= zero_b;
    if (straight)
        before = after = 1;
    const double part = before / (before + after);
    for (int k = 0; k < t->d; k++)
        T[k] = (1 - part) * q[1][k] + part * q[2][k];
    return straight && area(t->d, q[1], q[2], size / scale, &zero) > zero;
}

/* The derivative at point i of the parabola nearest to five points about it, by polynomials
 * that are orthogonal on them. */
static void parabola_of_five(const tangent_rule *t, int i, double *T)
{
    const int n = t->count >= 5 ? 5 : closed(t) ? 3 : t->count;
    const int first =
        closed(t) ? i - n / 2 : bat_max_int(0, bat_min_int(i - n / 2, t->count - n));
    double at[5] = {0}, mean = 0, squares = 0, cubes = 0, quartics = 0;
    for (int j = i - 1; j >= first; j--)
        at[j - first] = at[j + 1 - first] - length(t, j);
    for (int j = i + 1; j < first + n; j++)
        at[j - first] = at[j - 1 - first] + length(t, j - 1);
    const double scale = at[n - 1] - at[0];
    for (int j = 0; j < n; j++)
        mean += at[j] / scale / n;
    for (int j = 0; j < n; j++) {
        const double x = at[j] / scale - mean;
        squares += x * x;
        cubes += x * x * x;
    }
    for (int j = 0; j < n; j++) {
        const double x = at[j] / scale - mean, p2 = x * x - cubes / squares * x - squares / n;
        quartics += p2 * p2;
    }
    memset(T, 0, (size_t)t->d * sizeof *T);
    for (int j = 0; j < n; j++) {
        const double x = at[j] / scale - mean, p2 = x * x - cubes / squares * x - squares / n;
        const double slope2 = -2 * mean - cubes / squares;
        const double weight = x / squares + (n > 2 ? p2 / quartics * slope2 : 0);
        for (int k = 0; k < t->d; k++)
            T[k] += weight / scale * (vertex(t, first + j)[k] - vertex(t, i)[k]);
    }
}

/* ---- ends, and points without direction ---- */

/* A circle's tangents at both ends of a chord are mirror images; so are the derivatives of a
 * parabola, about the middle of its span. */
static void end_of_three(const tangent_rule *t, int i, int inner, double *T)
{
    double inside[3], u[3], along = 1;
    chord(t, i == 0 ? 0 : i - 1, 0, u);
    if (t->options->rule == BATTEN_TANGENT_BESSEL) {
        parabola_of_three(t, inner, inside);
    } else {
        memcpy(inside, t->leaving + (size_t)inner * (size_t)t->d,
               (size_t)t->d * sizeof *inside);
        along = bat_dot(t->d, inside, u);
    }
    for (int k = 0; k < t->d; k++)
        T[k] = 2 * along * u[k] - inside[k];
}

/* At right angles to the chord before, towards the side to which the points beyond pass. */
static void sideways(const tangent_rule *t, int i, double *T)
{
    double u[3], v[3];
    const int n = t->count;
    chord(t, i - 1, 0, u);
    const double *a = vertex(t, closed(t) ? i - 2 : bat_max_int(i - 2, 0));
    const double *b = vertex(t, closed(t) ? i + 2 : bat_min_int(i + 2, n - 1));
    const double size = bat_max(bat_distance(t->d, a, b), DBL_MIN);
    for (int k = 0; k < t->d; k++)
        v[k] = (b[k] - a[k]) / size;
    double along = bat_dot(t->d, u, v), rest = 0;
    for (int k = 0; k < t->d; k++)
        rest += (v[k] - along * u[k]) * (v[k] - along * u[k]);
    if (rest <= DBL_EPSILON) { /* the angle is lost: the axis that is farthest from the chord */
        int axis = 0;
        for (int k = 1; k < t->d; k++)
            if (fabs(u[k]) < fabs(u[axis]))
                axis = k;
        memset(v, 0, sizeof v);
        v[axis] = 1;
        along = u[axis];
    }
    for (int k = 0; k < t->d; k++)
        T[k] = v[k] - along * u[k];
}

static bool turns_back(const tangent_rule *t, int i)
{
    double sum[3];
    if (!closed(t) && (i == 0 || i == t->count - 1))
        return false;
    bisector(t, i, sum);
    /* Both unit vectors were rounded a few times. */
    return bat_norm(t->d, sum) <= 16 * DBL_EPSILON;
}

/* ---- the whole ---- */

/* The rule gives a derivative that is wanted as it is. */
static bool keeps_length(const batten_tangents_options *o)
{
    return o->length == BATTEN_LENGTH_RULE &&
           (o->rule == BATTEN_TANGENT_BESSEL || o->rule == BATTEN_TANGENT_AKIMA ||
            o->rule == BATTEN_TANGENT_PARABOLA || o->rule == BATTEN_TANGENT_GIVEN);
}

static void make_unit(const tangent_rule *t, double *T)
{
    const double size = bat_norm(t->d, T);
    for (int k = 0; k < t->d; k++)
        T[k] /= size;
}

static void one_tangent(tangent_rule *t, int i)
{
    const batten_tangents_options *o = t->options;
    double *T = t->leaving + (size_t)i * (size_t)t->d,
           *before = t->arriving + (size_t)i * (size_t)t->d;
    const bool end = !o->closed && (i == 0 || i == t->count - 1), keeps = keeps_length(o);
    bool corner = false;
    if (!keeps && turns_back(t, i)) {
        sideways(t, i, T);
        if (t->report.turned_back++ == 0)
            t->report.first_turned_back = i;
    } else if (o->rule == BATTEN_TANGENT_AKIMA) {
        akima(t, i, T);
    } else if (o->rule == BATTEN_TANGENT_RENNER) {
        corner = renner(t, i, T) && o->corners == BATTEN_CORNER_KEEP;
    } else if (o->rule == BATTEN_TANGENT_PARABOLA) {
        parabola_of_five(t, i, T);
    } else if (end) {
        end_of_three(t, i, i == 0 ? 1 : t->count - 2, T);
    } else if (o->rule == BATTEN_TANGENT_BISECTOR) {
        bisector(t, i, T);
    } else {
        parabola_of_three(t, i, T);
    }
    if (!keeps && !(bat_norm(t->d, T) > 16 * DBL_EPSILON))
        chord(t, end && i > 0 ? i - 1 : i, 0, T);
    if (!keeps)
        make_unit(t, T);
    memcpy(before, T, (size_t)t->d * sizeof *T);
    if (corner) {
        chord(t, i - 1, 0, before);
        chord(t, i, 0, T);
        t->report.corners++;
    }
}

static batten_status take_given(tangent_rule *t)
{
    const size_t n = (size_t)t->count * (size_t)t->d;
    const bool keeps = keeps_length(t->options);
    memcpy(t->leaving, t->options->given, n * sizeof *t->leaving);
    for (int i = 0; i < t->count && !keeps; i++) {
        double *T = t->leaving + (size_t)i * (size_t)t->d;
        if (!(bat_norm(t->d, T) > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the tangent at point %d has no length",
                            i + 1);
        make_unit(t, T);
    }
    memcpy(t->arriving, t->leaving, n * sizeof *t->leaving);
    return BATTEN_OK;
}

/* Inner points first: the ends look at them. */
static void find_tangents(tangent_rule *t)
{
    const int n = t->count, first = !closed(t);
    if (n == 2) {
        for (int i = 0; i < 2; i++) {
            chord(t, 0, 0, t->leaving + i * t->d);
            chord(t, 0, 0, t->arriving + i * t->d);
        }
        return;
    }
    for (int i = first; i < n - first; i++)
        one_tangent(t, i);
    if (first) {
        one_tangent(t, 0);
        one_tangent(t, n - 1);
    }
}

double bat_middle_leg(int d, const double *u, const double *t0, const double *t1)
{
    double sum[3];
    for (int k = 0; k < d; k++)
        sum[k] = t0[k] + t1[k];
    const double along = bat_dot(d, u, sum);
    /* A third of the positive root of (16 - s^2) a^2 + 12 along a - 36 = 0, s = |t0 + t1|,
     * written so that nothing cancels. */
    const double square = 16 - bat_dot(d, sum, sum), root = sqrt(along * along + square);
    return along > 0 ? 2 / (along + root) : 2 * (root - along) / square;
}

static batten_status find_steps(tangent_rule *t)
{
    double sum = 0;
    for (int i = 0; i < span_count(t); i++) {
        const size_t a = (size_t)i * (size_t)t->d,
                     b = (size_t)bat_around(t->count, i + 1) * (size_t)t->d;
        double u[3];
        chord(t, i, 0, u);
        const double step =
            3 * length(t, i) * bat_middle_leg(t->d, u, t->leaving + a, t->arriving + b);
        t->t[i] = sum;
        if (!(sum + step > sum && isfinite(sum + step)))
            return bat_fail(BATTEN_OVERFLOW, "the step of span %d, %g, is lost after %g", i + 1,
                            step, sum);
        sum += step;
    }
    t->t[span_count(t)] = sum;
    return BATTEN_OK;
}

static batten_status find(tangent_rule *t)
{
    batten_status status = bat_parametrize((batten_points){t->d, t->count, t->points},
                                           BATTEN_CHORD, closed(t), t->t);
    if (status != BATTEN_OK)
        return status;
    bat_steps((batten_points){t->d, t->count, t->points}, BATTEN_CHORD, closed(t), t->l);
    t->report.first_turned_back = -1;
    if (t->options->rule == BATTEN_TANGENT_GIVEN)
        status = take_given(t);
    else
        find_tangents(t);
    if (status == BATTEN_OK && t->options->length == BATTEN_LENGTH_MIDDLE)
        status = find_steps(t);
    return status;
}

static batten_status check_options(const batten_tangents_options *o, int dimension, int count)
{
    if (dimension < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "tangents need a plane or space; a function of one "
                        "variable has slopes");
    if ((int)o->rule < 0 || o->rule > BATTEN_TANGENT_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown rule %d for tangents", (int)o->rule);
    if ((int)o->length < 0 || o->length > BATTEN_LENGTH_RULE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown rule %d for the length of tangents",
                        (int)o->length);
    if (o->rule != BATTEN_TANGENT_GIVEN)
        return BATTEN_OK;
    if (!o->given)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tangents must be given, and are missing");
    return bat_local_check_rows(dimension, count, o->given, "tangent");
}

static void copy_tangents(const tangent_rule *t, double *parameters, double *leaving,
                          double *arriving, batten_tangents_report *report)
{
    const size_t size = (size_t)t->count * (size_t)t->d * sizeof *leaving;
    memcpy(parameters, t->t, (size_t)(t->count + closed(t)) * sizeof *parameters);
    memcpy(leaving, t->leaving, size);
    if (arriving)
        memcpy(arriving, t->arriving, size);
    if (report)
        *report = t->report;
}

batten_status batten_tangents(batten_points points, const batten_tangents_options *options,
                              double *parameters, batten_tangents_report *report,
                              double *leaving, double *arriving)
{
    assert(points.at && parameters && leaving);
    batten_tangents_options chosen = batten_tangents_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_tangents_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    tangent_rule t = {
        .d = points.dimension, .count = points.count, .points = points.at, .options = &chosen};
    status = bat_points_check(points.dimension, points.count, points.at, closed(&t) ? 3 : 2);
    if (status == BATTEN_OK)
        status = check_options(t.options, points.dimension, points.count);
    if (status != BATTEN_OK)
        return status;
    t.t = bat_array((size_t)points.count + 1, sizeof *t.t);
    t.l = bat_array((size_t)points.count, sizeof *t.l);
    t.leaving = bat_array3((size_t)points.count, (size_t)points.dimension, sizeof *t.leaving);
    t.arriving = bat_array3((size_t)points.count, (size_t)points.dimension, sizeof *t.arriving);
    status = BATTEN_OUT_OF_MEMORY;
    if (t.t && t.l && t.leaving && t.arriving)
        status = find(&t);
    if (status == BATTEN_OK)
        copy_tangents(&t, parameters, leaving, arriving, report);
    bat_release(t.t);
    bat_release(t.l);
    bat_release(t.leaving);
    bat_release(t.arriving);
    return status;
}
