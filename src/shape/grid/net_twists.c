/*
 * Twists estimated from a net. Most are differences: an operator D along u and one along v,
 * each with weights for the point before, the point itself and the one after.
 */
#include "shape/grid/net_twists.h"
#include "base/plural.h"
#include "numeric/rounding.h"

#include "numeric/vector.h"
#include <batten/grid.h>
#include <batten/interpolate.h>

#include <string.h>

/* Weights of the values at index first .. first + 2. */
typedef struct {
    int first;
    double weights[3];
} difference;

/* The mean of the slopes of the chords beside a point. */
static difference mean_slope(int count, const double *t, int i)
{
    const bool before = i > 0, after = i + 1 < count;
    const double share = before && after ? 0.5 : 1;
    difference d = {i - 1, {0, 0, 0}};
    if (before) {
        d.weights[0] -= share / (t[i] - t[i - 1]);
        d.weights[1] += share / (t[i] - t[i - 1]);
    }
    if (after) {
        d.weights[1] -= share / (t[i + 1] - t[i]);
        d.weights[2] += share / (t[i + 1] - t[i]);
    }
    return d;
}

/* The slope of the chord from the point before to the one after. */
static difference long_chord(int count, const double *t, int i)
{
    const int low = bat_max_int(0, i - 1), high = bat_min_int(count - 1, i + 1);
    difference d = {i - 1, {0, 0, 0}};
    d.weights[high - i + 1] += 1 / (t[high] - t[low]);
    d.weights[low - i + 1] -= 1 / (t[high] - t[low]);
    return d;
}

/* The slope of the parabola through three points, the first or last three at the ends. */
static difference parabola(int count, const double *t, int i)
{
    if (count < 3)
        return long_chord(count, t, i);
    const int first = bat_max_int(0, bat_min_int(i - 1, count - 3));
    const double *x = t + first, at = t[i];
    difference d = {first, {0, 0, 0}};
    for (int k = 0; k < 3; k++) {
        const double a = x[(k + 1) % 3], b = x[(k + 2) % 3];
        d.weights[k] = ((at - a) + (at - b)) / ((x[k] - a) * (x[k] - b));
    }
    return d;
}

typedef difference (*stencil)(int count, const double *t, int i);

static void add_term(int d, double factor, const double *from, double *to)
{
    for (int x = 0; factor != 0 && x < d; x++)
        to[x] += factor * from[x];
}

/* D along u, along v, or both, of `values` at (i, j). */
static void differ(const bat_net *net, stencil along_u, stencil along_v, const double *values,
                   int i, int j, double *out)
{
    const difference none = {0, {1, 0, 0}};
    difference u = none, v = none;
    u.first = i;
    v.first = j;
    if (along_u)
        u = along_u(net->count[0], net->at[0], i);
    if (along_v)
        v = along_v(net->count[1], net->at[1], j);
    memset(out, 0, (size_t)net->dimension * sizeof *out);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            if (u.weights[a] != 0 && v.weights[b] != 0)
                add_term(net->dimension, u.weights[a] * v.weights[b],
                         values + bat_net_index(net, u.first + a, v.first + b), out);
}

/* d/du of Sv, and d/dv of Su, less what both have in common: exact for the bilinear Coons
 * patch around the point. */
static void adini(const bat_net *net, int i, int j, double *out)
{
    double by_v[3], both[3];
    differ(net, long_chord, NULL, net->sv, i, j, out);
    differ(net, NULL, long_chord, net->su, i, j, by_v);
    differ(net, long_chord, long_chord, net->points, i, j, both);
    add_term(net->dimension, 1, by_v, out);
    add_term(net->dimension, -1, both, out);
}

/* ---- splines ---- */

/* The slopes at all points of the cubic spline through values [count][d] with these end slopes.
 */
static batten_status spline_slopes(int d, int count, const double *t, const double *values,
                                   const double *start, const double *end, double *slopes)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = t;
    options.start.kind = options.end.kind = BATTEN_END_CLAMPED;
    memcpy(options.start.vector, start, (size_t)d * sizeof *start);
    memcpy(options.end.vector, end, (size_t)d * sizeof *end);
    batten_curve *spline = NULL;
    batten_status status =
        batten_curve_interpolate((batten_points){d, count, values}, &options, NULL, &spline);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        double out[6];
        status = batten_curve_evaluate(spline, t[i], 1, out);
        memcpy(slopes + i * d, out + d, (size_t)d * sizeof *out);
    }
    batten_curve_unref(spline);
    return status;
}

/* Twists along one line of the net from the tangents across it: `k` is the direction of the
 * line, `fixed` its index. Its end twists are known. share of them is added. */
static batten_status line_twists(const bat_net *net, int k, int fixed, double share,
                                 double *room, double *twists)
{
    const int d = net->dimension, n = net->count[k];
    const double *across = k ? net->su : net->sv;
    double *values = room, *slopes = room + (size_t)n * (size_t)d, ends[2][3];
    for (int i = 0; i < n; i++)
        memcpy(values + i * d,
               across + (k ? bat_net_index(net, fixed, i) : bat_net_index(net, i, fixed)),
               (size_t)d * sizeof *values);
    for (int e = 0; e < 2; e++)
        memcpy(ends[e],
               twists + (k ? bat_net_index(net, fixed, e ? n - 1 : 0)
                           : bat_net_index(net, e ? n - 1 : 0, fixed)),
               (size_t)d * sizeof *values);
    const batten_status status =
        spline_slopes(d, n, net->at[k], values, ends[0], ends[1], slopes);
    for (int i = 1; status == BATTEN_OK && i < n - 1; i++)
        add_term(d, share, slopes + i * d,
                 twists + (k ? bat_net_index(net, fixed, i) : bat_net_index(net, i, fixed)));
    return status;
}

/* Corners by Adini, then the rim, then the inside along both families, which agree when the
 * net's curves are splines; else the mean. */
static batten_status spline_twists(const bat_net *net, double *twists)
{
    const int n = net->count[0], m = net->count[1];
    const size_t longest = (size_t)bat_max_int(n, m);
    double *room = bat_array3(2 * longest, (size_t)net->dimension, sizeof *room);
    if (!room)
        return BATTEN_OUT_OF_MEMORY;
    memset(twists, 0, (size_t)n * (size_t)m * (size_t)net->dimension * sizeof *twists);
    for (int c = 0; c < 4; c++) {
        const int i = c / 2 ? n - 1 : 0, j = c % 2 ? m - 1 : 0;
        adini(net, i, j, twists + bat_net_index(net, i, j));
    }
    batten_status status = BATTEN_OK;
    for (int e = 0; status == BATTEN_OK && e < 2; e++) {
        status = line_twists(net, 0, e ? m - 1 : 0, 1, room, twists);
        if (status == BATTEN_OK)
            status = line_twists(net, 1, e ? n - 1 : 0, 1, room, twists);
    }
    for (int j = 1; status == BATTEN_OK && j < m - 1; j++)
        status = line_twists(net, 0, j, 0.5, room, twists);
    for (int i = 1; status == BATTEN_OK && i < n - 1; i++)
        status = line_twists(net, 1, i, 0.5, room, twists);
    bat_release(room);
    return status;
}

/* ---- Selesnick ---- */

/* d/du (Su . Su) or d/dv, by parabolas. */
static double square_rate(const bat_net *net, int k, const double *tangents, int i, int j)
{
    const difference by = parabola(net->count[k], net->at[k], k ? j : i);
    double sum = 0;
    for (int a = 0; a < 3; a++) {
        const int at = by.first + a;
        if (by.weights[a] == 0) /* also what a chord has beyond the net */
            continue;
        const double *t =
            tangents + (k ? bat_net_index(net, i, at) : bat_net_index(net, at, j));
        sum += by.weights[a] * bat_dot(3, t, t);
    }
    return sum;
}

/* x_uv = alpha Su + beta Sv + mu n: Su . x_uv = (Su . Su)_v / 2, Sv . x_uv = (Sv . Sv)_u / 2,
 * and mu^2 = L N - K (E G - F^2). The sign is that of Adini's twist. */
static void selesnick(const bat_net *net, const batten_twist_shape *shape, int i, int j,
                      double *out, int *clamped)
{
    const size_t at = bat_net_index(net, i, j);
    const double *su = net->su + at, *sv = net->sv + at;
    const double e = bat_dot(3, su, su), f = bat_dot(3, su, sv), g = bat_dot(3, sv, sv);
    const double area2 = e * g - f * f;
    double guess[3];
    adini(net, i, j, guess);
    /* The square of a sine of 1e-10, below which there is no normal. */
    if (!(area2 > 1e-20 * e * g)) {
        memcpy(out, guess, sizeof guess);
        return;
    }
    const double rate_e = square_rate(net, 1, net->su, i, j) / 2;
    const double rate_g = square_rate(net, 0, net->sv, i, j) / 2;
    const double alpha = (rate_e * g - rate_g * f) / area2;
    const double beta = (rate_g * e - rate_e * f) / area2;
    const batten_vec3 normal =
        bat_vec3_scale(bat_vec3_cross(bat_vec3_of(3, su), bat_vec3_of(3, sv)), 1 / sqrt(area2));
    const double bend_u = bat_vec3_dot(bat_vec3_of(3, shape->suu + at), normal);
    const double bend_v = bat_vec3_dot(bat_vec3_of(3, shape->svv + at), normal);
    const double k = shape->gaussian[i * net->count[1] + j];
    double square = bend_u * bend_v - k * area2;
    if (square < 0) {
        *clamped += square < -BAT_ROUNDING * (fabs(bend_u * bend_v) + fabs(k) * area2);
        square = 0;
    }
    const double mu = copysign(sqrt(square), bat_vec3_dot(bat_vec3_of(3, guess), normal));
    const double n[3] = {normal.x, normal.y, normal.z};
    for (int x = 0; x < 3; x++)
        out[x] = alpha * su[x] + beta * sv[x] + mu * n[x];
}

/* ---- all ---- */

batten_status bat_net_check_axis(char name, int count, const double *t)
{
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "the net has %d line%s in %c, fewer than 2",
                        count, bat_plural(count), name);
    for (int i = 0; i < count; i++) {
        if (!isfinite(t[i]))
            return bat_fail(BATTEN_NOT_FINITE, "parameter %d in %c is %g", i + 1, name, t[i]);
        if (i > 0 && !(t[i] > t[i - 1]))
            return bat_fail(BATTEN_NOT_INCREASING, "parameter %d in %c is %g, after %g", i + 1,
                            name, t[i], t[i - 1]);
    }
    return BATTEN_OK;
}

static batten_status check_values(const bat_net *net, const char *what, const double *values)
{
    const size_t count = (size_t)net->count[0] * (size_t)net->count[1] * (size_t)net->dimension;
    const size_t i = bat_first_not_finite(values, count);
    if (i == count)
        return BATTEN_OK;
    const size_t node = i / (size_t)net->dimension;
    return bat_fail(BATTEN_NOT_FINITE, "the %s at (%zu, %zu) of the net is not finite", what,
                    node / (size_t)net->count[1] + 1, node % (size_t)net->count[1] + 1);
}

static batten_status check_net(const bat_net *net, batten_twists method,
                               const batten_twist_shape *shape)
{
    if (net->dimension < 1 || net->dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        net->dimension);
    if (method < BATTEN_TWISTS_ZERO || method > BATTEN_TWISTS_SELESNICK)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no method %d for twists", (int)method);
    if (method == BATTEN_TWISTS_SELESNICK && (net->dimension != 3 || !shape))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "Selesnick's twists need three dimensions, second derivatives and "
                        "curvatures");
    batten_status status = bat_net_check_axis('u', net->count[0], net->at[0]);
    if (status == BATTEN_OK)
        status = bat_net_check_axis('v', net->count[1], net->at[1]);
    if (status == BATTEN_OK)
        status = check_values(net, "point", net->points);
    if (status == BATTEN_OK)
        status = check_values(net, "tangent along u", net->su);
    if (status == BATTEN_OK)
        status = check_values(net, "tangent along v", net->sv);
    return status;
}

static void at_point(const bat_net *net, batten_twists method, const batten_twist_shape *shape,
                     int i, int j, double *out, int *clamped)
{
    if (method == BATTEN_TWISTS_BILINEAR)
        differ(net, mean_slope, mean_slope, net->points, i, j, out);
    else if (method == BATTEN_TWISTS_BESSEL)
        differ(net, parabola, parabola, net->points, i, j, out);
    else if (method == BATTEN_TWISTS_ADINI)
        adini(net, i, j, out);
    else if (method == BATTEN_TWISTS_SELESNICK)
        selesnick(net, shape, i, j, out, clamped);
    else
        memset(out, 0, (size_t)net->dimension * sizeof *out);
}

batten_status batten_net_twists(batten_twists method, const batten_net *given,
                                const batten_twist_shape *shape, int *clamped, double *twists)
{
    assert(given->u && given->v && given->points && given->su && given->sv && twists);
    const bat_net net = {given->dimension,
                         {given->count_u, given->count_v},
                         {given->u, given->v},
                         given->points,
                         given->su,
                         given->sv};
    const batten_status status = check_net(&net, method, shape);
    int lost = 0;
    if (status != BATTEN_OK)
        return status;
    if (method == BATTEN_TWISTS_SPLINE)
        return spline_twists(&net, twists);
    if (method == BATTEN_TWISTS_ENERGY)
        return bat_net_energy_twists(&net, twists);
    for (int i = 0; i < given->count_u; i++)
        for (int j = 0; j < given->count_v; j++)
            at_point(&net, method, shape, i, j, twists + bat_net_index(&net, i, j), &lost);
    if (clamped)
        *clamped = lost;
    return BATTEN_OK;
}
