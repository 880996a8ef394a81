/*
 * Multilevel B-splines: bicubic lattices, each half as wide as the one before, each near what
 * the sum of those before leaves. The sum is kept on the last lattice. Lattices reach one span
 * beyond the domain on every side, with even knots; the result is clamped.
 */
#include "base/plural.h"
#include "numeric/dense.h"
#include "shape/cloud/scattered.h"
#include "spline/spline.h"
#include "spline/surface/surface.h"

#include <string.h>

enum { USUAL_LEVELS = 9, MOST_POINTS = 4000000, MOST_EACH = 8 };

typedef struct {
    int spans[2]; /* (spans + 3)^2 control points */
    double h[2];
    double *sum;  /* [spans u + 3][spans v + 3][d] */
    double *rest; /* [count][d] */
} lattice;

static size_t lattice_size(const lattice *l)
{
    return (size_t)(l->spans[0] + 3) * (size_t)(l->spans[1] + 3);
}

/* The uniform cubic functions at datum t: first lattice indices and values. */
static void basis_at(const bat_scatter *s, const lattice *l, size_t t, int first[2],
                     double values[2][4])
{
    for (int k = 0; k < 2; k++) {
        const double x = s->uv[2 * t + (size_t)k] / l->h[k];
        first[k] = bat_min_int(l->spans[k] - 1, (int)x);
        const double r = x - first[k], q = 1 - r;
        values[k][0] = q * q * q / 6;
        values[k][1] = (3 * r * r * r - 6 * r * r + 4) / 6;
        values[k][2] = (3 * q * q * q - 6 * q * q + 4) / 6;
        values[k][3] = r * r * r / 6;
    }
}

/* Of every datum the least control values that meet it; of every control point their mean,
 * weighted by how much it bears on each. */
static batten_status fit_rest(const bat_scatter *s, const lattice *l, double *add)
{
    const size_t d = (size_t)s->dimension, nv = (size_t)l->spans[1] + 3;
    double *below = bat_array(lattice_size(l), sizeof *below);
    if (!below)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t t = 0; t < s->count; t++) {
        int first[2];
        double f[2][4], squares[2] = {0};
        basis_at(s, l, t, first, f);
        for (int k = 0; k < 2; k++)
            for (int a = 0; a < 4; a++)
                squares[k] += f[k][a] * f[k][a];
        for (int a = 0; a < 4; a++)
            for (int b = 0; b < 4; b++) {
                const size_t at = (size_t)(first[0] + a) * nv + (size_t)(first[1] + b);
                const double w = f[0][a] * f[1][b], ww = s->weights[t] * w * w;
                const double phi = ww * w / (squares[0] * squares[1]);
                below[at] += ww;
                for (size_t c = 0; c < d; c++)
                    add[at * d + c] += phi * l->rest[t * d + c];
            }
    }
    for (size_t at = 0; at < lattice_size(l); at++)
        for (size_t c = 0; c < d; c++)
            add[at * d + c] = below[at] > 0 ? add[at * d + c] / below[at] : 0;
    bat_release(below);
    return BATTEN_OK;
}

/* What the added lattice leaves. */
static void take_off(const bat_scatter *s, const lattice *l, const double *add)
{
    const size_t d = (size_t)s->dimension, nv = (size_t)l->spans[1] + 3;
    for (size_t t = 0; t < s->count; t++) {
        int first[2];
        double f[2][4];
        basis_at(s, l, t, first, f);
        for (int a = 0; a < 4; a++)
            for (int b = 0; b < 4; b++) {
                const size_t at = (size_t)(first[0] + a) * nv + (size_t)(first[1] + b);
                for (size_t c = 0; c < d; c++)
                    l->rest[t * d + c] -= f[0][a] * f[1][b] * add[at * d + c];
            }
    }
}

/* One direction of knots halved: values [n + 3][width] to [2 n + 3][width]; the rows of
 * Pascal's triangle, (1 6 1) / 8 and (4 4) / 8. */
static void halve_lines(int n, size_t width, const double *from, double *to)
{
    for (int i = 0; i < 2 * n + 3; i++)
        for (size_t c = 0; c < width; c++) {
            const double *p = from + (size_t)(i / 2) * width + c;
            to[(size_t)i * width + c] =
                i % 2 == 0 ? (p[0] + p[width]) / 2 : (p[0] + 6 * p[width] + p[2 * width]) / 8;
        }
}

static batten_status halve_lattice(const bat_scatter *s, lattice *l)
{
    const size_t d = (size_t)s->dimension;
    const int nu = l->spans[0], nv = l->spans[1], wide = 2 * nu + 3;
    double *a = bat_array3((size_t)wide, (size_t)(nv + 3) * d, sizeof *a);
    double *b = bat_array3((size_t)wide, (size_t)(nv + 3) * d, sizeof *b);
    double *c = bat_array3((size_t)wide, (size_t)(2 * nv + 3) * d, sizeof *c);
    double *sum = bat_array3((size_t)wide, (size_t)(2 * nv + 3) * d, sizeof *sum);
    const bool good = a && b && c && sum;
    if (good) {
        halve_lines(nu, (size_t)(nv + 3) * d, l->sum, a);
        bat_transpose(wide, nv + 3, d, a, b);
        halve_lines(nv, (size_t)wide * d, b, c);
        bat_transpose(2 * nv + 3, wide, d, c, sum);
        bat_release(l->sum);
        l->sum = sum;
        for (int k = 0; k < 2; k++) {
            l->spans[k] *= 2;
            l->h[k] = s->side[k] / l->spans[k];
        }
    } else {
        bat_release(sum);
    }
    bat_release(c);
    bat_release(b);
    bat_release(a);
    return good ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void measure_rest(bat_scatter *s, const lattice *l)
{
    const size_t d = (size_t)s->dimension;
    for (size_t t = 0; t < s->count; t++) {
        double square = 0;
        for (size_t c = 0; c < d; c++)
            square += l->rest[t * d + c] * l->rest[t * d + c];
        s->away[t] = sqrt(square);
    }
}

static double worst_of(const bat_scatter *s, size_t *worst)
{
    double most = 0;
    for (size_t t = 0; t < s->count; t++)
        if (s->weights[t] > 0 && s->away[t] > most) {
            most = s->away[t];
            *worst = t;
        }
    return most;
}

static batten_status fit_level(bat_scatter *s, lattice *l)
{
    const size_t size = lattice_size(l) * (size_t)s->dimension;
    double *add = bat_array(size, sizeof *add);
    batten_status status = add ? fit_rest(s, l, add) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        take_off(s, l, add);
        for (size_t i = 0; i < size; i++)
            l->sum[i] += add[i];
        measure_rest(s, l);
        status = bat_work_step(&s->work, s->count, 0.5, "scattered data");
    }
    bat_release(add);
    return status;
}

static double rms_of(const bat_scatter *s, double most)
{
    double sum = 0, weight = 0;
    for (size_t t = 0; t < s->count && most > 0; t++) {
        const double share = s->weights[t] > 0 ? s->away[t] / most : 0;
        sum += s->weights[t] * share * share;
        weight += s->weights[t];
    }
    return most > 0 ? most * sqrt(sum / weight) : 0;
}

/* What speaks against another level, after those that were made; `gain` is by how much the last
 * let the root of the mean square fall. */
static batten_levels_end reason_to_end(const bat_scatter *s, const lattice *l, double most,
                                       double gain)
{
    const batten_surface_scattered_options *o = s->options;
    const double next = (2.0 * l->spans[0] + 3) * (2.0 * l->spans[1] + 3);
    if (most <= o->tolerance)
        return BATTEN_LEVELS_MET;
    if (s->report.rounds >= (o->levels ? o->levels : USUAL_LEVELS))
        return BATTEN_LEVELS_MOST;
    if (next > (o->most_points ? o->most_points : MOST_POINTS))
        return BATTEN_LEVELS_LARGE;
    if (o->tolerance > 0 || o->levels)
        return BATTEN_LEVELS_NONE;
    if (next > MOST_EACH * (double)s->count)
        return BATTEN_LEVELS_FEW;
    return s->report.rounds > 2 && gain < 0.1 ? BATTEN_LEVELS_NO_GAIN : BATTEN_LEVELS_NONE;
}

static batten_status climb_levels(bat_scatter *s, lattice *l)
{
    const double tolerance = s->options->tolerance;
    size_t worst = 0;
    double most = HUGE_VAL, before = HUGE_VAL;
    s->report.end = BATTEN_LEVELS_NONE;
    for (int i = 0; s->report.end == BATTEN_LEVELS_NONE; i++) {
        batten_status status = i > 0 ? halve_lattice(s, l) : BATTEN_OK;
        if (status == BATTEN_OK)
            status = fit_level(s, l);
        if (status != BATTEN_OK)
            return status;
        most = worst_of(s, &worst);
        const double rms = rms_of(s, most);
        s->report.rounds = i + 1;
        s->report.end = reason_to_end(s, l, most, 1 - rms / before);
        before = rms;
    }
    if (tolerance > 0 && most > tolerance)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "after %d level%s datum %zu is missed by %g, more than %g",
                        s->report.rounds, bat_plural(s->report.rounds), worst + 1, most,
                        tolerance);
    return BATTEN_OK;
}

/* Clamped knots; the sum is refined to them direction by direction. */
static batten_status clamp_ends(bat_scatter *s, const lattice *l)
{
    double *knots[2] = {NULL, NULL};
    batten_surface *open = NULL, *half = NULL, *clamped = NULL;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        const int n = l->spans[k] + 3;
        knots[k] = bat_array((size_t)n + 4, sizeof *knots[k]);
        if (!knots[k])
            status = BATTEN_OUT_OF_MEMORY;
        for (int i = 0; status == BATTEN_OK && i < n + 4; i++)
            knots[k][i] = i - 3 == l->spans[k] ? s->side[k] : (i - 3) * l->h[k];
    }
    if (status == BATTEN_OK) {
        const batten_axis u = {3, l->spans[0] + 3, knots[0], false};
        const batten_axis v = {3, l->spans[1] + 3, knots[1], false};
        status = batten_surface_create(s->dimension, &u, &v, l->sum, NULL, &open);
    }
    if (status == BATTEN_OK)
        status = batten_surface_clamp(open, BATTEN_U, &half);
    if (status == BATTEN_OK)
        status = batten_surface_clamp(half, BATTEN_V, &clamped);
    if (status == BATTEN_OK)
        status = bat_scatter_take(s, clamped);
    batten_surface_unref(clamped);
    batten_surface_unref(half);
    batten_surface_unref(open);
    bat_release(knots[1]);
    bat_release(knots[0]);
    return status;
}

static int first_spans(const bat_scatter *s, int k)
{
    const int given = k ? s->options->spans_v : s->options->spans_u;
    const double ratio = s->side[k] / s->side[1 - k];
    return given ? given : bat_max_int(1, bat_min_int(64, (int)(ratio + 0.5)));
}

batten_status bat_scatter_levels(bat_scatter *s)
{
    const size_t d = (size_t)s->dimension;
    lattice l = {.spans = {first_spans(s, 0), first_spans(s, 1)}};
    for (int k = 0; k < 2; k++)
        l.h[k] = s->side[k] / l.spans[k];
    l.sum = bat_array3(lattice_size(&l), d, sizeof *l.sum);
    l.rest = bat_array3(s->count, d, sizeof *l.rest);
    batten_status status = l.sum && l.rest ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < s->count * d; i++)
        l.rest[i] = s->values[i] - s->centre[i % d];
    if (status == BATTEN_OK)
        status = climb_levels(s, &l);
    if (status == BATTEN_OK)
        status = clamp_ends(s, &l);
    bat_release(l.rest);
    bat_release(l.sum);
    return status;
}
