/*
 * The equations of a penalised fit: normal equations of the data and of the bending energy,
 * solved by a band or by conjugate gradients.
 */
#include "base/plural.h"
#include "numeric/banded.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/cloud/scattered.h"
#include "spline/spline.h"

#include <float.h>
#include <string.h>

enum { WIDE = BAT_SCATTER_WIDE };

/* ---- the penalty ---- */

/* Integrals of products of derivatives of order 0, 1, 2: [3][count][degree + 1], of functions i
 * and i + a. */
static void fill_gram(const bat_net_axis *axis, double *gram)
{
    const int p = axis->degree, n = axis->count;
    double x[BAT_MAX_GAUSS], w[BAT_MAX_GAUSS], basis[3 * WIDE];
    bat_gauss(p + 1, x, w);
    for (int k = p; k < n; k++)
        for (int g = 0; axis->knots[k] < axis->knots[k + 1] && g <= p; g++) {
            const double half = (axis->knots[k + 1] - axis->knots[k]) / 2;
            bat_basis(p, axis->knots, k, axis->knots[k] + half * (1 + x[g]), 2, basis);
            for (int order = 0; order < 3; order++)
                for (int i = 0; i <= p; i++)
                    for (int j = i; j <= p; j++)
                        gram[(order * n + k - p + i) * (p + 1) + j - i] +=
                            half * w[g] * basis[order * (p + 1) + i] *
                            basis[order * (p + 1) + j];
        }
}

static double gram_at(const double *gram, const bat_net_axis *axis, int order, int i, int j)
{
    const int low = bat_min_int(i, j), apart = bat_max_int(i - j, j - i);
    return apart > axis->degree
               ? 0
               : gram[(order * axis->count + low) * (axis->degree + 1) + apart];
}

static void fill_energy(const bat_scatter *s, const double *gu, const double *gv)
{
    const bat_net_axis *u = &s->axis[0], *v = &s->axis[1];
    const int q = v->degree;
    for (int i = 0; i < u->count; i++)
        for (int j = 0; j < v->count; j++) {
            double *to = s->system.energy +
                         ((size_t)i * (size_t)v->count + (size_t)j) * s->system.stencil;
            for (int a = 0; a <= u->degree && i + a < u->count; a++)
                for (int b = a > 0 ? -q : 0; b <= q; b++) {
                    if (j + b < 0 || j + b >= v->count)
                        continue;
                    double sum = 0;
                    for (int order = 0; order < 3; order++)
                        sum += (order == 1 ? 2 : 1) * gram_at(gu, u, order, i, i + a) *
                               gram_at(gv, v, 2 - order, j, j + b);
                    to[a * (2 * q + 1) + b + q] = sum;
                }
        }
}

static batten_status make_energy(const bat_scatter *s)
{
    double *gram[2];
    for (int k = 0; k < 2; k++) {
        const bat_net_axis *axis = &s->axis[k];
        gram[k] =
            bat_array3(3 * (size_t)axis->count, (size_t)axis->degree + 1, sizeof *gram[k]);
    }
    const bool good = gram[0] && gram[1];
    for (int k = 0; good && k < 2; k++)
        fill_gram(&s->axis[k], gram[k]);
    if (good)
        fill_energy(s, gram[0], gram[1]);
    bat_release(gram[0]);
    bat_release(gram[1]);
    return good ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- beginning ---- */

void bat_scatter_release(bat_net_system *system)
{
    bat_release(system->data);
    bat_release(system->energy);
    bat_release(system->open);
    bat_release(system->right);
    bat_release(system->solved);
    bat_release(system->factor);
    *system = (bat_net_system){0};
}

/* Solved directly where the factor costs less than some hundred steps of conjugate gradients.
 */
static bool is_cheap(size_t unknowns, int lower)
{
    const double n = (double)unknowns, w = lower + 1;
    return n * w * w <= 2e9 && n * w <= 2e7;
}

batten_status bat_scatter_make(bat_scatter *s)
{
    const bat_net_axis *u = &s->axis[0], *v = &s->axis[1];
    bat_net_system *y = &s->system;
    bat_scatter_release(y);
    y->unknowns = (size_t)u->count * (size_t)v->count;
    y->stencil = (size_t)(u->degree + 1) * (size_t)(2 * v->degree + 1);
    y->rights = s->dimension + s->probes;
    y->inner = v->count <= u->count ? 1 : 0;
    y->lower =
        s->axis[1 - y->inner].degree * s->axis[y->inner].count + s->axis[y->inner].degree;
    y->data = bat_array3(y->unknowns, y->stencil, sizeof *y->data);
    y->energy = bat_array3(y->unknowns, y->stencil, sizeof *y->energy);
    y->open = bat_array3(y->unknowns, y->stencil, sizeof *y->open);
    y->right = bat_array3(y->unknowns, (size_t)y->rights, sizeof *y->right);
    y->solved = bat_array3(y->unknowns, (size_t)y->rights, sizeof *y->solved);
    if (!y->data || !y->energy || !y->open || !y->right || !y->solved)
        return BATTEN_OUT_OF_MEMORY;
    if (is_cheap(y->unknowns, y->lower)) {
        y->factor = bat_array3(y->unknowns, (size_t)y->lower + 1, sizeof *y->factor);
        if (!y->factor)
            return BATTEN_OUT_OF_MEMORY;
    }
    bat_release(s->control);
    s->control = bat_array3(y->unknowns, (size_t)s->dimension, sizeof *s->control);
    return s->control ? make_energy(s) : BATTEN_OUT_OF_MEMORY;
}

/* ---- the data ---- */

/* A sign for each datum and probe: splitmix64, so the same on every machine. */
static double sign_of(size_t datum, int probe)
{
    uint64_t x = (uint64_t)datum * 64 + (uint64_t)probe + 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return (x >> 40) & 1 ? 1 : -1;
}

/* With few data every one is a probe, and the trace exact. */
static double probe_of(const bat_scatter *s, size_t datum, int probe)
{
    if ((size_t)s->probes >= s->count)
        return datum == (size_t)probe;
    return sign_of(datum, probe);
}

static void add_right(const bat_scatter *s, size_t t, size_t at, double f)
{
    const bat_net_system *y = &s->system;
    const double w = s->weights[t];
    for (int c = 0; c < s->dimension; c++)
        y->right[(size_t)c * y->unknowns + at] +=
            w * f * (s->values[t * (size_t)s->dimension + (size_t)c] - s->centre[c]);
    for (int k = 0; k < s->probes; k++)
        y->right[(size_t)(s->dimension + k) * y->unknowns + at] +=
            sqrt(w) * f * probe_of(s, t, k);
}

static void add_datum(const bat_scatter *s, size_t t)
{
    const int p = s->axis[0].degree, q = s->axis[1].degree, row = 2 * q + 1;
    const size_t nv = (size_t)s->axis[1].count;
    const double w = s->weights[t];
    double u[WIDE], v[WIDE], uu[WIDE * WIDE];
    int first[2];
    bat_scatter_basis(s, t, first, u, v);
    for (int a = 0; a <= p; a++)
        for (int c = a; c <= p; c++)
            uu[a * WIDE + c - a] = w * u[a] * u[c];
    for (int a = 0; a <= p; a++)
        for (int b = 0; b <= q; b++) {
            const size_t at = (size_t)(first[0] + a) * nv + (size_t)(first[1] + b);
            double *to = s->system.data + at * s->system.stencil + q - b;
            add_right(s, t, at, u[a] * v[b]);
            for (int e = b; e <= q; e++)
                to[e] += uu[a * WIDE] * v[b] * v[e];
            for (int c = 1; c <= p - a; c++) {
                const double f = uu[a * WIDE + c] * v[b];
                for (int e = 0; e <= q; e++)
                    to[c * row + e] += f * v[e];
            }
        }
}

batten_status bat_scatter_assemble(bat_scatter *s)
{
    bat_net_system *y = &s->system;
    const size_t middle = (size_t)s->axis[1].degree;
    memset(y->data, 0, y->unknowns * y->stencil * sizeof *y->data);
    memset(y->open, 0, y->unknowns * y->stencil * sizeof *y->open);
    memset(y->right, 0, y->unknowns * (size_t)y->rights * sizeof *y->right);
    s->weight = 0;
    s->counted = 0;
    for (size_t t = 0; t < s->count; t++)
        if (s->weights[t] > 0) {
            add_datum(s, t);
            s->weight += s->weights[t];
            s->counted++;
        }
    double data = 0, energy = 0;
    for (size_t i = 0; i < y->unknowns; i++) {
        data += y->data[i * y->stencil + middle];
        energy += y->energy[i * y->stencil + middle];
    }
    y->scale = energy > 0 ? data / energy : 1;
    y->floor = s->hold * y->scale;
    const batten_status status = y->floor > 0 ? bat_scatter_open(s) : BATTEN_OK;
    return status == BATTEN_OK ? bat_work_step(&s->work, s->count, 0.3, "scattered data")
                               : status;
}

/* ---- solving by a band ---- */

static size_t place_in_band(const bat_scatter *s, size_t i, size_t j)
{
    return s->system.inner == 1 ? i * (size_t)s->axis[1].count + j
                                : j * (size_t)s->axis[0].count + i;
}

static void fill_band(const bat_scatter *s, double lambda)
{
    const bat_net_system *y = &s->system;
    const int q = s->axis[1].degree, nu = s->axis[0].count, nv = s->axis[1].count;
    const size_t wide = (size_t)y->lower + 1;
    memset(y->factor, 0, y->unknowns * wide * sizeof *y->factor);
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            const size_t at = ((size_t)i * (size_t)nv + (size_t)j) * y->stencil;
            const size_t here = place_in_band(s, (size_t)i, (size_t)j);
            for (int a = 0; a <= s->axis[0].degree && i + a < nu; a++)
                for (int b = a > 0 ? -q : 0; b <= q; b++) {
                    if (j + b < 0 || j + b >= nv)
                        continue;
                    const size_t k = at + (size_t)(a * (2 * q + 1) + b + q);
                    const size_t there = place_in_band(s, (size_t)(i + a), (size_t)(j + b));
                    const size_t row = here > there ? here : there, column = here + there - row;
                    y->factor[row * wide + (size_t)y->lower - (row - column)] =
                        bat_net_entry(y, k, lambda);
                }
        }
}

/* Right sides one beside the other, in the order of the band, and back. */
static batten_status solve_band(const bat_scatter *s, double lambda)
{
    const bat_net_system *y = &s->system;
    const size_t nu = (size_t)s->axis[0].count, nv = (size_t)s->axis[1].count,
                 m = (size_t)y->rights;
    double *x = bat_array3(y->unknowns, m, sizeof *x);
    if (!x)
        return BATTEN_OUT_OF_MEMORY;
    fill_band(s, lambda);
    const batten_status status = bat_symmetric_factor((int)y->unknowns, y->lower, y->factor);
    for (size_t i = 0; status == BATTEN_OK && i < nu; i++)
        for (size_t j = 0; j < nv; j++)
            for (size_t k = 0; k < m; k++)
                x[place_in_band(s, i, j) * m + k] = y->right[k * y->unknowns + i * nv + j];
    if (status == BATTEN_OK)
        bat_symmetric_solve((int)y->unknowns, y->lower, y->factor, m, x);
    for (size_t i = 0; status == BATTEN_OK && i < nu; i++)
        for (size_t j = 0; j < nv; j++)
            for (size_t k = 0; k < m; k++)
                y->solved[k * y->unknowns + i * nv + j] = x[place_in_band(s, i, j) * m + k];
    bat_release(x);
    return status;
}

/* The control points, coordinates innermost. */
static void take_solution(bat_scatter *s)
{
    const bat_net_system *y = &s->system;
    const size_t d = (size_t)s->dimension;
    for (size_t i = 0; i < y->unknowns; i++)
        for (size_t c = 0; c < d; c++)
            s->control[i * d + c] = y->solved[c * y->unknowns + i];
}

batten_status bat_scatter_solve(bat_scatter *s, double lambda)
{
    const bat_net_system *y = &s->system;
    const batten_status status =
        y->factor ? solve_band(s, lambda) : bat_scatter_solve_gradients(s, lambda);
    if (status != BATTEN_OK)
        return status;
    take_solution(s);
    s->lambda = lambda;
    bat_scatter_measure(s);
    return BATTEN_OK;
}

double bat_scatter_freedom(const bat_scatter *s)
{
    const bat_net_system *y = &s->system;
    double sum = 0;
    for (size_t k = 0; k < (size_t)s->probes; k++) {
        const size_t at = ((size_t)s->dimension + k) * y->unknowns;
        for (size_t i = 0; i < y->unknowns; i++)
            sum += y->right[at + i] * y->solved[at + i];
    }
    return (size_t)s->probes >= s->count ? sum : sum / bat_max_int(s->probes, 1);
}
