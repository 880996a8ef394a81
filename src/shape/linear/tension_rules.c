/* How much tension keeps the turns of the data, or their rise and fall. */
#include "shape/linear/tension.h"
#include "spline/chain/chain.h"

#include <float.h>
#include <string.h>

/* One span more: from 1 by its length, by halves. */
static void raise_tension(bat_tension *t, int span)
{
    const double least = 1 / (t->u[span + 1] - t->u[span]);
    t->sigma[span] = t->sigma[span] < least ? least : 1.5 * t->sigma[span];
}

/* One round of a rule marks the spans that need more; `worst` is a point where. */
typedef bool (*mark_spans)(const bat_tension *t, const void *rule, unsigned char *marks,
                           int *worst);

static batten_status raise_until(bat_tension *t, mark_spans mark, const void *rule,
                                 const char *what)
{
    unsigned char *marks = bat_array((size_t)t->spans, 1);
    if (!marks)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    int worst = 0;
    for (int round = 0; status == BATTEN_OK && mark(t, rule, marks, &worst); round++) {
        if (round == BAT_TENSION_ROUNDS) {
            status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                              "after %d rounds the curve is not yet %s at point %d", round,
                              what, worst + 1);
            break;
        }
        for (int i = 0; i < t->spans; i++)
            if (marks[i])
                raise_tension(t, i);
        memset(marks, 0, (size_t)t->spans);
        status = bat_tension_solve(t);
    }
    bat_release(marks);
    return status;
}

/* The spans on both sides of a point; -1 where there is none. */
static int span_before(const bat_tension *t, int i)
{
    return i > 0 ? i - 1 : t->closed ? t->spans - 1 : -1;
}

static int span_after(const bat_tension *t, int i)
{
    return i < t->spans ? i : -1;
}

static void mark_both(const bat_tension *t, int i, unsigned char *marks)
{
    if (span_before(t, i) >= 0)
        marks[span_before(t, i)] = 1;
    if (span_after(t, i) >= 0)
        marks[span_after(t, i)] = 1;
}

/* ---- convexity ---- */

typedef enum { FREE, TURNS, IN_LINE } corner_kind;

/* What the polygon does at a point: `normal` is the product of the slopes before and after. */
typedef struct {
    corner_kind kind;
    batten_vec3 normal;
    double bound; /* IN_LINE: of the product of the slopes of the curve and of the line */
} corner;

typedef struct {
    corner *corners; /* [count] */
} convexity;

/* A function is its graph. */
static batten_vec3 slope_of(const bat_tension *t, const double *slope)
{
    return t->dimension == 1 ? (batten_vec3){1, slope[0], 0} : bat_vec3_of(t->dimension, slope);
}

static batten_vec3 chord_slope(const bat_tension *t, int span)
{
    return slope_of(t, t->slopes + span * t->dimension);
}

static batten_vec3 moment_of(const bat_tension *t, int i)
{
    const double *M = t->moments + i * t->dimension;
    return t->dimension == 1 ? (batten_vec3){0, M[0], 0} : bat_vec3_of(t->dimension, M);
}

static batten_vec3 curve_slope(const bat_tension *t, int i)
{
    double slope[3];
    if (span_after(t, i) >= 0)
        bat_tension_slope(t, i, 0, slope);
    else
        bat_tension_slope(t, i - 1, 1, slope);
    return slope_of(t, slope);
}

/* By how much rounding of the points moves the slope of a chord. */
static double slope_rounding(const bat_tension *t, int span)
{
    const int d = t->dimension;
    const double size = bat_max(bat_largest(d, t->points + span * d),
                                bat_largest(d, t->points + bat_tension_next(t, span) * d));
    return 4 * DBL_EPSILON * size / (t->u[span + 1] - t->u[span]);
}

/* The slopes before and after a point; at a clamped end one of them is given. */
static bool slopes_at(const bat_tension *t, int i, batten_vec3 *before, batten_vec3 *after,
                      double *rounding)
{
    const int left = span_before(t, i), right = span_after(t, i);
    const int end = left < 0 ? 0 : 1;
    if ((left < 0 || right < 0) && t->ends.kinds[end] != BATTEN_END_CLAMPED)
        return false;
    *before = left < 0 ? slope_of(t, t->ends.values[0]) : chord_slope(t, left);
    *after = right < 0 ? slope_of(t, t->ends.values[1]) : chord_slope(t, right);
    *rounding = (left < 0 ? 0 : slope_rounding(t, left) * bat_vec3_norm(*after)) +
                (right < 0 ? 0 : slope_rounding(t, right) * bat_vec3_norm(*before));
    return true;
}

static void find_corners(const bat_tension *t, corner *corners, double slack)
{
    const int n = t->count;
    for (int i = 0; i < n; i++) {
        batten_vec3 before, after;
        double rounding;
        if (!slopes_at(t, i, &before, &after, &rounding))
            continue;
        corners[i].normal = bat_vec3_cross(before, after);
        corners[i].kind = TURNS;
        if (bat_vec3_norm(corners[i].normal) <= rounding) {
            /* A polygon that runs back upon itself has no line to keep to. */
            corners[i].kind = bat_vec3_dot(before, after) > 0 ? IN_LINE : FREE;
            corners[i].normal = (batten_vec3){0, 0, 0};
        }
    }
    for (int i = 0; i < n; i++) {
        const int left = i > 0       ? i - 1
                         : t->closed ? n - 1
                                     : 0,
                  right = i + 1 < n   ? i + 1
                          : t->closed ? 0
                                      : n - 1;
        corners[i].bound = slack * bat_max(bat_vec3_norm(corners[left].normal),
                                           bat_vec3_norm(corners[right].normal));
    }
}

/* (P' x P'') . normal on a span at x of its length, and its derivative by x. */
static double bend_at(const bat_tension *t, int i, batten_vec3 normal, double x,
                      double *derivative)
{
    const double h = t->u[i + 1] - t->u[i], z = t->sigma[i] * h;
    const batten_vec3 M = moment_of(t, i), N = moment_of(t, bat_tension_next(t, i));
    double up[4], down[4];
    bat_tension_shape(z, x, 1 - x, up);
    bat_tension_shape(z, 1 - x, x, down);
    const batten_vec3 first =
        bat_vec3_along(bat_vec3_along(chord_slope(t, i), h * up[1], N), -h * down[1], M);
    const batten_vec3 second = bat_vec3_along(bat_vec3_scale(N, up[2]), down[2], M);
    const batten_vec3 third = bat_vec3_along(bat_vec3_scale(N, up[3]), -down[3], M);
    *derivative = bat_vec3_dot(bat_vec3_cross(first, third), normal);
    return bat_vec3_dot(bat_vec3_cross(first, second), normal);
}

/*
 * Does the span bend about `normal` from end to end? Along it the bend is U sinh z (1 - x) +
 * V sinh z x + W, so that between falling and rising it is convex, with one lowest place: above
 * the tangents at both ends, and found by halving.
 */
static bool keeps_its_bend(const bat_tension *t, int i, batten_vec3 normal)
{
    const double h = t->u[i + 1] - t->u[i];
    const double bends =
        bat_vec3_norm(moment_of(t, i)) + bat_vec3_norm(moment_of(t, bat_tension_next(t, i)));
    const double zero = 16 * DBL_EPSILON * bends * bat_vec3_norm(normal) *
                        (bat_vec3_norm(chord_slope(t, i)) + h * bends);
    double fall, rise, a = 0, b = 1, slope;
    const double at_start = bend_at(t, i, normal, 0, &fall),
                 at_end = bend_at(t, i, normal, 1, &rise);
    if (at_start < -zero || at_end < -zero)
        return false;
    if (!(fall < 0 && rise > 0))
        return true;
    const double x = (at_end - rise - at_start) / (fall - rise);
    if (at_start + fall * x >= 0)
        return true;
    for (int step = 0; step < 30; step++) { /* the lowest value is flat: half the digits do */
        const double middle = (a + b) / 2;
        if (bend_at(t, i, normal, middle, &slope) < -zero)
            return false;
        if (slope < 0)
            a = middle;
        else
            b = middle;
    }
    return true;
}

static bool corner_fails(const bat_tension *t, const corner *c, int i)
{
    const batten_vec3 slope = curve_slope(t, i), M = moment_of(t, i);
    if (c->kind == TURNS) {
        const double size = bat_vec3_norm(slope) * bat_vec3_norm(M) * bat_vec3_norm(c->normal);
        return bat_vec3_dot(bat_vec3_cross(slope, M), c->normal) < -16 * DBL_EPSILON * size;
    }
    if (c->kind == FREE || c->bound == 0)
        return false;
    const batten_vec3 line = chord_slope(t, span_after(t, i) >= 0 ? i : i - 1);
    return bat_vec3_norm(bat_vec3_cross(slope, line)) > c->bound;
}

static bool mark_bends(const bat_tension *t, const void *rule, unsigned char *marks, int *worst)
{
    const corner *corners = ((const convexity *)rule)->corners;
    bool any = false;
    for (int i = 0; i < t->count; i++)
        if (corner_fails(t, &corners[i], i)) {
            mark_both(t, i, marks);
            *worst = i;
            any = true;
        }
    for (int i = 0; i < t->spans; i++) {
        const batten_vec3 a = corners[i].normal, b = corners[bat_tension_next(t, i)].normal;
        if (marks[i] || !(bat_vec3_dot(a, b) > 0))
            continue;
        if (keeps_its_bend(t, i, a) && (t->dimension < 3 || keeps_its_bend(t, i, b)))
            continue;
        marks[i] = 1;
        *worst = i;
        any = true;
    }
    return any;
}

batten_status bat_tension_convex(bat_tension *t, double slack)
{
    convexity rule = {bat_array((size_t)t->count, sizeof *rule.corners)};
    if (!rule.corners)
        return BATTEN_OUT_OF_MEMORY;
    find_corners(t, rule.corners, slack);
    const batten_status status = raise_until(t, mark_bends, &rule, "convex");
    bat_release(rule.corners);
    return status;
}

/* ---- monotony ---- */

/* One coordinate of one span: the slopes of the data before, on and after it, where known. */
typedef struct {
    double before, on, after;
    bool has_before, has_after;
    double start, end; /* slopes of the curve */
    double M, N;       /* second derivatives */
} rise;

static rise rise_of(const bat_tension *t, int i, int k)
{
    const int d = t->dimension, next = bat_tension_next(t, i);
    const int left = span_before(t, i), right = span_after(t, i + 1 < t->count ? i + 1 : 0);
    double start[3], end[3];
    bat_tension_slope(t, i, 0, start);
    bat_tension_slope(t, i, 1, end);
    rise r = {.on = t->slopes[i * d + k],
              .start = start[k],
              .end = end[k],
              .M = t->moments[i * d + k],
              .N = t->moments[next * d + k]};
    r.has_before = left >= 0 || t->ends.kinds[0] == BATTEN_END_CLAMPED;
    r.before = left >= 0 ? t->slopes[left * d + k] : t->ends.values[0][k];
    if (!t->closed && i + 1 == t->spans) {
        r.has_after = t->ends.kinds[1] == BATTEN_END_CLAMPED;
        r.after = t->ends.values[1][k];
    } else {
        r.has_after = true;
        r.after = t->slopes[right * d + k];
    }
    return r;
}

/* The slope where it is extreme inside a span, which it is where the second derivative
 * vanishes: e^(2 z x) = (M e^z - N) / (M e^-z - N) with M and N of opposite signs. */
static double extreme_slope(const bat_tension *t, int i, const rise *r)
{
    const double h = t->u[i + 1] - t->u[i], z = t->sigma[i] * h;
    const double q = -r->N / r->M, e = bat_exp(-z);
    /* Below this tension the quotient is that of the cubic within the square of z. */
    const double x = z < 1e-5 ? 1 / (1 + q) : (z + bat_log((1 + q * e) / (q + e))) / (2 * z);
    double up[4], down[4];
    bat_tension_shape(z, x, 1 - x, up);
    bat_tension_shape(z, 1 - x, x, down);
    return r->on + h * (r->N * up[1] - r->M * down[1]);
}

/* Bits of what fails: 1 the start, 2 the end, 4 the span itself. */
static int failure(const bat_tension *t, int i, const rise *r, double slack, double zero)
{
    if (r->on == 0) {
        const bool start = r->has_before && fabs(r->start) > slack * fabs(r->before) + zero,
                   end = r->has_after && fabs(r->end) > slack * fabs(r->after) + zero;
        return start || end ? 4 : 0;
    }
    const double s = r->on > 0 ? 1 : -1;
    int fails = 0;
    if ((!r->has_before || s * r->before > 0) && s * r->start < -zero)
        fails |= 1;
    if ((!r->has_after || s * r->after > 0) && s * r->end < -zero)
        fails |= 2;
    /* Where the data are level or turn beside the span its end may fall a little; the dip
     * inside may not, which is of the size of the slope at the other end. */
    const double h = t->u[i + 1] - t->u[i], reach = h / bat_max(1, t->sigma[i] * h);
    const double rounding =
        16 * DBL_EPSILON * (fabs(r->on) + reach * (fabs(r->M) + fabs(r->N)));
    if (!fails && s * r->M < 0 && s * r->N > 0 && s * extreme_slope(t, i, r) < -rounding)
        fails |= 4;
    return fails;
}

static bool mark_rises(const bat_tension *t, const void *rule, unsigned char *marks, int *worst)
{
    const double slack = *(const double *)rule;
    bool any = false;
    for (int i = 0; i < t->spans; i++)
        for (int k = 0; k < t->dimension; k++) {
            const rise r = rise_of(t, i, k);
            const double h = t->u[i + 1] - t->u[i];
            const double zero = 16 * DBL_EPSILON * (fabs(r.on) + h * (fabs(r.M) + fabs(r.N)));
            const int fails = failure(t, i, &r, slack, zero);
            if (!fails)
                continue;
            marks[i] = 1;
            if (fails & 1)
                mark_both(t, i, marks);
            if (fails & 2)
                mark_both(t, bat_tension_next(t, i), marks);
            *worst = i;
            any = true;
        }
    return any;
}

batten_status bat_tension_monotone(bat_tension *t, double slack)
{
    return raise_until(t, mark_rises, &slack, "monotone");
}
