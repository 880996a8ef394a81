/*
 * Cures for creases that the sections do not have.
 *
 * Between two sections the surface is a blend of both, in homogeneous coordinates. At a knot
 * line it has a crease unless the first derivatives of all sections, those of weights too, do
 * not jump there, or all jump by the same factor. A section with a tangent everywhere can be
 * given such a parameter: polynomial ones by stretching spans; rational ones by a Moebius
 * change of the parameter of each piece, which has just the two freedoms that a joint asks for.
 * What cannot be cured so is replaced by polynomial sections within a tolerance.
 */
#include "numeric/rounding.h"
#include "shape/skin/steps.h"
#include "spline/curve/curve.h"
#include <batten/approximate.h>

#include <stdlib.h>
#include <string.h>

batten_status bat_skin_stretch(bat_skin *t)
{
    for (int k = 0; k < t->count; k++) {
        batten_curve *even = NULL;
        if (batten_curve_is_periodic(t->placed[k]))
            continue; /* it stays so */
        const batten_status status = bat_skin_even_speed(t->placed[k], &even);
        if (status != BATTEN_OK)
            return status;
        const bool stretched =
            batten_curve_point_count(even) == batten_curve_point_count(t->placed[k]) &&
            memcmp(batten_curve_knots(even), batten_curve_knots(t->placed[k]),
                   (size_t)batten_curve_knot_count(even) * sizeof(double)) != 0;
        if (stretched)
            t->found.cure = BATTEN_CURE_STRETCHED;
        bat_curve_take(&t->placed[k], even);
    }
    return BATTEN_OK;
}

batten_status bat_skin_polynomial(bat_skin *t)
{
    for (int k = 0; k < t->count; k++) {
        batten_curve *near = NULL;
        double error = 0;
        if (!batten_curve_is_rational(t->placed[k]))
            continue;
        const int degree = bat_max_int(3, batten_curve_degree(t->placed[k]));
        batten_status status = batten_curve_approximate(
            t->placed[k], degree, t->options->tolerance / 4, &error, &near);
        if (status != BATTEN_OK)
            return status;
        bat_curve_take(&t->placed[k], near);
        t->moved[k] += error;
    }
    /* Where the speed jumped it jumps still. */
    const batten_status status = bat_skin_stretch(t);
    t->found.cure = BATTEN_CURE_POLYNOMIAL;
    return status;
}

/* ---- weights rescaled ---- */

/* A piece of a rational section between knots of full multiplicity, as it is over [0, 1]: at
 * both ends w' / w and the speed. */
typedef struct {
    batten_curve *curve;
    double rate[2], speed[2];
    bool corner; /* it begins with one, or is the first */
    double m;    /* its parameter becomes s / (s + m (1 - s)) of the new one, s */
} link;

typedef struct {
    int count, degree;
    link *links;
} chain;

static void measure_piece(const batten_curve *curve, link *out)
{
    const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve),
              d = batten_curve_dimension(curve);
    const double *U = batten_curve_knots(curve), *P = batten_curve_points(curve),
                 *w = batten_curve_weights(curve);
    const double length = U[n] - U[p];
    const double first = (U[p + 1] - U[p]) / length, last = (U[n] - U[n - 1]) / length;
    const size_t end = (size_t)(n - 1) * (size_t)d;
    out->rate[0] = p * (w[1] / w[0] - 1) / first;
    out->rate[1] = p * (1 - w[n - 2] / w[n - 1]) / last;
    out->speed[0] = p * w[1] / w[0] * bat_distance(d, P, P + d) / first;
    out->speed[1] = p * w[n - 2] / w[n - 1] * bat_distance(d, P + end - d, P + end) / last;
}

/* Do two pieces meet with one tangent? */
static bool is_smooth(const batten_curve *a, const batten_curve *b)
{
    const int d = batten_curve_dimension(a);
    const double *A = batten_curve_points(a) +
                      (size_t)(batten_curve_point_count(a) - 2) * (size_t)d,
                 *B = batten_curve_points(b);
    double in[3], out[3];
    for (int c = 0; c < d; c++) {
        in[c] = A[d + c] - A[c];
        out[c] = B[d + c] - B[c];
    }
    return bat_dot(d, in, out) > bat_cos(bat_skin_corner) * bat_norm(d, in) * bat_norm(d, out);
}

static void free_chain(chain *c)
{
    for (int i = 0; c->links && i < c->count; i++)
        batten_curve_unref(c->links[i].curve);
    bat_release(c->links);
}

/* Cut a clamped rational section at its knots of full multiplicity. */
static batten_status cut_at_creases(const batten_curve *section, chain *out)
{
    const int p = batten_curve_degree(section), n = batten_curve_point_count(section);
    const double *U = batten_curve_knots(section);
    out->degree = p;
    out->links = bat_array((size_t)n, sizeof *out->links);
    if (!out->links)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = p, next; i < n; i = next) {
        for (next = i + 1; next < n && !(U[next] > U[i] && U[next] == U[next + p - 1]); next++)
            ;
        link *here = &out->links[out->count];
        const batten_status status =
            batten_curve_subrange(section, U[i], U[next], &here->curve);
        if (status != BATTEN_OK)
            return status;
        measure_piece(here->curve, here);
        here->corner = out->count == 0 || !is_smooth(here[-1].curve, here->curve);
        out->count++;
        while (next < n && U[next + 1] == U[next])
            next++;
    }
    return BATTEN_OK;
}

/*
 * The m of all links from `first` up to the next corner, when that of the first is given. With
 * s the rate w' / w becomes (rate[0] + p (1 - m)) / m at the start and rate[1] m + p (1 - m) at
 * the end, the speed speed[0] / m and speed[1] m; stretching the span divides all by its
 * length. Their quotient must not jump. The largest of m and 1 / m; infinity where one is
 * negative.
 */
static double march(chain *c, int first, double m)
{
    const int p = c->degree;
    double worst = bat_max(m, 1 / m);
    c->links[first].m = m;
    for (int i = first + 1; i < c->count && !c->links[i].corner; i++) {
        const link *before = &c->links[i - 1];
        link *here = &c->links[i];
        const double rate = before->rate[1] * before->m + p * (1 - before->m),
                     speed = before->speed[1] * before->m;
        here->m = (here->rate[0] + p - rate / speed * here->speed[0]) / p;
        if (!(here->m > 0))
            return INFINITY;
        worst = bat_max(worst, bat_max(here->m, 1 / here->m));
    }
    return worst;
}

/* Beyond this the parameter would run through a piece so unevenly that the surface suffers more
 * than from a polynomial section. */
static const double most_uneven = 16;

/* The start from which the march stays evenest: from a table, then by halving steps. */
static bool solve_cure(chain *c, int first)
{
    double best = 0, least = march(c, first, 1);
    for (double step = 0.5; step > 1e-6; step /= 2)
        for (int turn = 0; turn < 16; turn++) {
            const double low = march(c, first, bat_exp(best - step)),
                         high = march(c, first, bat_exp(best + step));
            if (!(bat_min(low, high) < least))
                break;
            best += low < high ? -step : step;
            least = bat_min(low, high);
        }
    return march(c, first, bat_exp(best)) <= most_uneven;
}

/* A link with its new parameter, weights from `weight` on and the speed `speed` at its start, 0
 * for any; these become those at its end. */
static batten_status rescale(const link *from, double *weight, double *speed,
                             batten_curve **out)
{
    batten_curve *unit = NULL, *moved = NULL;
    const int p = batten_curve_degree(from->curve), d = batten_curve_dimension(from->curve);
    const batten_interval domain = batten_curve_domain(from->curve);
    const double m = from->m;
    const double length = *speed > 0 ? from->speed[0] / m / *speed : domain.b - domain.a;
    batten_status status = batten_curve_set_domain(from->curve, 0, 1, &unit);
    if (status == BATTEN_OK && m != 1)
        status = batten_curve_moebius(unit, m, 0, m - 1, 1, &moved);
    else if (status == BATTEN_OK)
        moved = batten_curve_ref(unit);
    batten_curve_unref(unit);
    if (status != BATTEN_OK)
        return status;
    const int n = batten_curve_point_count(moved);
    const double *w = batten_curve_weights(moved);
    double *weights = bat_array((size_t)n, sizeof *weights);
    double *knots = bat_array((size_t)(n + p + 1), sizeof *knots);
    status = weights && knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n + p + 1; i++)
        knots[i] = batten_curve_knots(moved)[i] * length;
    for (int i = 0; status == BATTEN_OK && i < n; i++)
        weights[i] = w[i] * (*weight / w[0]);
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){d, n, batten_curve_points(moved)}, p,
                                     weights, knots, out);
    if (status == BATTEN_OK) {
        *weight = weights[n - 1];
        *speed = from->speed[1] * m / length;
    }
    bat_release(knots);
    bat_release(weights);
    batten_curve_unref(moved);
    return status;
}

/* All links joined again; at a smooth joint the knot then stands once less. */
static batten_status join_pieces(const chain *c, double size, batten_curve **out)
{
    batten_curve *whole = NULL;
    double weight = 1, speed = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < c->count; i++) {
        batten_curve *next = NULL, *joined = NULL, *thinner = NULL;
        if (c->links[i].corner)
            speed = 0;
        status = rescale(&c->links[i], &weight, &speed, &next);
        if (status == BATTEN_OK && !whole) {
            whole = next;
            continue;
        }
        const double at = whole ? batten_curve_domain(whole).b : 0;
        if (status == BATTEN_OK)
            status = batten_curve_join(whole, next, BAT_MEANT_SAME * size, &joined);
        if (status == BATTEN_OK && !c->links[i].corner) {
            status = batten_curve_remove_knot(joined, (batten_knot){at, 1},
                                              BAT_MEANT_SAME * size, NULL, NULL, &thinner);
            if (status == BATTEN_OK)
                bat_curve_take(&joined, thinner);
        }
        if (status == BATTEN_OK) {
            bat_curve_take(&whole, joined);
            joined = NULL;
        }
        batten_curve_unref(joined);
        batten_curve_unref(next);
    }
    if (status == BATTEN_OK)
        *out = whole;
    else
        batten_curve_unref(whole);
    return status;
}

/* *out is NULL where no rescaling helps. */
static batten_status rescale_section(const batten_curve *section, batten_curve **out)
{
    batten_curve *clamped = NULL;
    chain c = {0};
    double size = 0;
    *out = NULL;
    batten_status status = batten_curve_clamp(section, &clamped);
    if (status == BATTEN_OK)
        status = cut_at_creases(clamped, &c);
    const int n = batten_curve_point_count(section) * batten_curve_dimension(section);
    for (int i = 0; i < n; i++)
        size = bat_max(size, fabs(batten_curve_points(section)[i]));
    bool solved = status == BATTEN_OK;
    for (int i = 0; solved && i < c.count; i++)
        solved = !c.links[i].corner || solve_cure(&c, i);
    if (solved)
        status = join_pieces(&c, size, out);
    free_chain(&c);
    batten_curve_unref(clamped);
    return status;
}

batten_status bat_skin_rescale(bat_skin *t, bool *done)
{
    *done = true;
    for (int k = 0; *done && k < t->count; k++) {
        batten_curve *rescaled = NULL;
        if (!batten_curve_is_rational(t->placed[k]) || t->point[k])
            continue;
        const batten_status status = rescale_section(t->placed[k], &rescaled);
        if (status != BATTEN_OK)
            return status;
        *done = rescaled != NULL;
        if (rescaled)
            bat_curve_take(&t->placed[k], rescaled);
    }
    if (*done)
        t->found.cure = BATTEN_CURE_RESCALED;
    return BATTEN_OK;
}
