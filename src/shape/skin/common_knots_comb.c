/* Combs: knots that many curves share. */
#include "numeric/rounding.h"
#include "shape/skin/common_knots_parts.h"

#include <float.h>
#include <string.h>

batten_status bat_comb_make(int capacity, bat_comb *c)
{
    c->capacity = capacity;
    c->knots = bat_array(2 * (size_t)capacity + 2, sizeof *c->knots);
    c->held = bat_array((size_t)capacity + 1, sizeof *c->held);
    return c->knots && c->held ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

void bat_comb_free(bat_comb *c)
{
    bat_release(c->knots);
    bat_release(c->held);
}

void bat_comb_insert(bat_comb *c, double u, bool held)
{
    int i = c->inner++;
    for (; i > 0 && c->knots[i - 1] > u; i--) {
        c->knots[i] = c->knots[i - 1];
        c->held[i] = c->held[i - 1];
    }
    c->knots[i] = u;
    c->held[i] = held;
}

void bat_comb_remove(bat_comb *c, int at)
{
    c->inner--;
    for (int i = at; i < c->inner; i++) {
        c->knots[i] = c->knots[i + 1];
        c->held[i] = c->held[i + 1];
    }
}

void bat_comb_copy(const bat_comb *from, bat_comb *to)
{
    to->inner = from->inner;
    memcpy(to->knots, from->knots, (size_t)from->inner * sizeof *to->knots);
    memcpy(to->held, from->held, (size_t)from->inner * sizeof *to->held);
}

/* How often a knot stands there, and its value to the bit. */
static int comb_times(const bat_comb *c, double *u)
{
    int times = 0;
    for (int i = 0; i < c->inner; i++)
        if (fabs(c->knots[i] - *u) <= 16 * DBL_EPSILON) {
            *u = c->knots[i];
            times++;
        }
    return times;
}

static bool comb_is_free(const bat_comb *c, double u, double around)
{
    for (int i = 0; i < c->inner; i++)
        if (fabs(c->knots[i] - u) <= around)
            return false;
    return true;
}

/* The whole knot vector [inner + 2 p + 2]. */
void bat_comb_write(const bat_comb *c, int p, double *U)
{
    for (int i = 0; i <= p; i++) {
        U[i] = 0;
        U[p + 1 + c->inner + i] = 1;
    }
    memcpy(U + p + 1, c->knots, (size_t)c->inner * sizeof *U);
}

/* Does a knot of full multiplicity bend the section visibly? A bend of the derivative by j,
 * rounded off over the spans beside it, h, moves the curve by at least j h / 32. */
static bool is_corner(const bat_fitting *f, const bat_spline *s, int i)
{
    const int p = s->degree;
    const double *U = s->knots;
    const double before = U[i] - U[i - 1], after = U[i + p] - U[i + p - 1];
    const double *row = s->values + (size_t)(i - 1) * f->width; /* the point on the knot */
    double jump[4];
    for (size_t c = 0; c < f->width; c++)
        jump[c] = p * ((row[f->width + c] - row[c]) / after -
                       (row[c] - *(row - f->width + c)) / before);
    return bat_norm((int)f->width, jump) * bat_min(before, after) / 32 > f->tolerance / 4;
}

/* The two conditions at a seam take control points that are not held themselves. */
bool bat_comb_hold(const bat_fitting *f, bat_comb *c)
{
    enum { FOR_SEAM = 3 };
    if (f->request->held_count + FOR_SEAM > f->limit)
        return f->request->held_count == 0 && !f->request->seam;
    for (int i = 0; i < f->request->held_count; i++)
        bat_comb_insert(c, f->request->held[i], true);
    for (int i = 1; f->request->seam && i <= FOR_SEAM && c->inner < FOR_SEAM; i++)
        if (comb_is_free(c, i / 4.0, 0.05))
            bat_comb_insert(c, i / 4.0, true);
    return true;
}

/* Knots i .. i + p - 1 of each section that are one corner; false when they are too many. */
bool bat_comb_corners(const bat_fitting *f, bat_comb *c)
{
    const int p = f->degree;
    for (int k = 0; k < f->count; k++) {
        const bat_spline *s = &f->given[k];
        for (int i = p + 1; i + p <= s->count; i++) {
            double u = s->knots[i];
            if (u == s->knots[i - 1] || u != s->knots[i + p - 1] || comb_times(c, &u) >= p ||
                !is_corner(f, s, i))
                continue;
            if (c->inner + p > f->limit)
                return false;
            for (int times = comb_times(c, &u); times < p; times++)
                bat_comb_insert(c, u, true);
        }
    }
    return true;
}

/* The x-quantile of a section's simple inner knots: a rising function of x in [0, 1] from 0
 * to 1. */
static double quantile(const bat_spline *s, double x)
{
    const int p = s->degree, spans = s->count - p;
    const double place = x * spans;
    const int i = bat_min_int((int)place, spans - 1);
    return s->knots[p + i] + (place - i) * (s->knots[p + i + 1] - s->knots[p + i]);
}

/* As many knots as the median section has, each the average of those at its place. */
void bat_comb_average(const bat_fitting *f, int wanted, bat_comb *c)
{
    for (int j = 1; j <= wanted && c->inner < f->limit; j++) {
        double sum = 0;
        for (int k = 0; k < f->count; k++)
            sum += quantile(&f->given[k], (double)j / (wanted + 1));
        const double u = sum / f->count;
        /* Beside a held knot there is no need, and a sliver would be left. */
        if (u > 0 && u < 1 && comb_is_free(c, u, 0.05 / (wanted + 1)))
            bat_comb_insert(c, u, false);
    }
}

/* ---- symmetry ---- */

/* The distance of two control points of a section, i the first. */
static double leg_length(const bat_fitting *f, const bat_spline *s, int i, int by)
{
    const int d = f->dimension;
    const double *a = s->values + (size_t)i * f->width, *b = a + (size_t)by * f->width;
    double step[3];
    for (int c = 0; c < d; c++)
        step[c] = f->rational ? b[c] / b[d] - a[c] / a[d] : b[c] - a[c];
    return bat_norm(d, step);
}

/* Is a section its own mirror image when it runs backwards? Knots say so, weights, and the
 * distances of points up to three apart, which fix their shape. */
static bool is_symmetric(const bat_fitting *f, const bat_spline *s)
{
    const int last = s->count + s->degree, n = s->count;
    double size = 0;
    for (int i = 0; i <= last; i++)
        if (fabs(s->knots[i] + s->knots[last - i] - 1) > 16 * DBL_EPSILON)
            return false;
    for (int i = 0; i + 1 < n; i++)
        size = bat_max(size, leg_length(f, s, i, 1));
    for (int by = 1; by <= 3; by++)
        for (int i = 0; i + by < n; i++)
            if (fabs(leg_length(f, s, i, by) - leg_length(f, s, n - 1 - i - by, by)) >
                BAT_ROUNDING * size)
                return false;
    for (int i = 0; i < n && f->rational; i++) {
        const double a = s->values[(size_t)i * f->width + f->width - 1],
                     b = s->values[(size_t)(n - 1 - i) * f->width + f->width - 1];
        if (fabs(a - b) > BAT_ROUNDING * bat_max(a, b))
            return false;
    }
    return true;
}

bool bat_common_symmetry(const bat_fitting *f)
{
    bool symmetric = true;
    for (int k = 0; symmetric && k < f->count; k++)
        symmetric = is_symmetric(f, &f->given[k]);
    return symmetric;
}

void bat_comb_mirror(bat_comb *c)
{
    for (int i = 0; 2 * i < c->inner; i++) {
        const int j = c->inner - 1 - i;
        if (!c->held[i] && !c->held[j])
            c->knots[j] = i == j ? 0.5 : 1 - c->knots[i];
    }
}
