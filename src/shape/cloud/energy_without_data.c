/*
 * The bending energy over the places that no data hold. Where data press against the penalty
 * its weight may fall to almost nothing; beyond them nothing would then stop the surface from
 * swinging. Places are open where a bin, wide enough for some data, holds none.
 */
#include "numeric/quadrature.h"
#include "shape/cloud/scattered.h"
#include "spline/spline.h"

enum { WIDE = BAT_SCATTER_WIDE, EACH = 4, MOST_BINS = 512 };

typedef struct {
    int counts[2];
    bool *held; /* [counts u][counts v] */
} bins;

/* Of an axis: Gauss points of each span, and there the derivatives of order 0, 1, 2. */
typedef struct {
    double *x, *w; /* [count][degree + 1], by knot span */
    double *basis; /* [count][degree + 1][3][degree + 1] */
} quadrature_places;

/* ---- bins ---- */

static int bin_of(const bat_scatter *s, const bins *b, int k, double x)
{
    return bat_min_int(b->counts[k] - 1, (int)(x / s->side[k] * b->counts[k]));
}

static void mark_held(const bat_scatter *s, bins *b)
{
    for (size_t t = 0; t < s->count; t++)
        if (s->weights[t] > 0)
            b->held[bin_of(s, b, 0, s->uv[2 * t]) * b->counts[1] +
                    bin_of(s, b, 1, s->uv[2 * t + 1])] = true;
}

/* Bins for some data each, were they spread evenly. */
static batten_status find_bins(const bat_scatter *s, bins *b)
{
    for (int k = 0; k < 2; k++) {
        const double wanted = sqrt((double)s->counted / EACH * s->side[k] / s->side[1 - k]);
        b->counts[k] = (int)bat_min(MOST_BINS, bat_max(1, wanted));
    }
    b->held = bat_array3((size_t)b->counts[0], (size_t)b->counts[1], sizeof *b->held);
    if (!b->held)
        return BATTEN_OUT_OF_MEMORY;
    mark_held(s, b);
    return BATTEN_OK;
}

/* ---- the energy ---- */

static void places_end(quadrature_places *at)
{
    bat_release(at->x);
    bat_release(at->w);
    bat_release(at->basis);
}

static batten_status find_places(const bat_net_axis *axis, quadrature_places *at)
{
    const size_t wide = (size_t)axis->degree + 1, n = (size_t)axis->count;
    double x[BAT_MAX_GAUSS], w[BAT_MAX_GAUSS];
    at->x = bat_array3(n, wide, sizeof *at->x);
    at->w = bat_array3(n, wide, sizeof *at->w);
    at->basis = bat_array3(n, 3 * wide * wide, sizeof *at->basis);
    if (!at->x || !at->w || !at->basis)
        return BATTEN_OUT_OF_MEMORY;
    bat_gauss(axis->degree + 1, x, w);
    for (size_t k = wide - 1; k < n; k++) {
        const double half = (axis->knots[k + 1] - axis->knots[k]) / 2;
        for (size_t g = 0; half > 0 && g < wide; g++) {
            at->x[k * wide + g] = axis->knots[k] + half * (1 + x[g]);
            at->w[k * wide + g] = half * w[g];
            bat_basis(axis->degree, axis->knots, (int)k, at->x[k * wide + g], 2,
                      at->basis + (k * wide + g) * 3 * wide);
        }
    }
    return BATTEN_OK;
}

/* A place in knot spans (i, j) with its weight; derivatives of basis functions along u and v. */
typedef struct {
    int i, j;
    double weight;
    const double *u, *v;
} weighted_place;

static void add_place(const bat_scatter *s, const weighted_place *place)
{
    const int i = place->i, j = place->j;
    const double w = place->weight, *u = place->u, *v = place->v;
    const int p = s->axis[0].degree, q = s->axis[1].degree, row = 2 * q + 1;
    const double factors[3] = {w, 2 * w, w};
    double second[3][WIDE * WIDE];
    for (int order = 0; order < 3; order++)
        for (int a = 0; a <= p; a++)
            for (int b = 0; b <= q; b++)
                second[order][a * (q + 1) + b] =
                    u[order * (p + 1) + a] * v[(2 - order) * (q + 1) + b];
    for (int a = 0; a <= p; a++)
        for (int b = 0; b <= q; b++) {
            const size_t at =
                (size_t)(i - p + a) * (size_t)s->axis[1].count + (size_t)(j - q + b);
            double *to = s->system.open + at * s->system.stencil + q - b;
            for (int order = 0; order < 3; order++) {
                const double f = factors[order] * second[order][a * (q + 1) + b];
                for (int c = a; c <= p; c++)
                    for (int e = c == a ? b : 0; e <= q; e++)
                        to[(c - a) * row + e] += f * second[order][c * (q + 1) + e];
            }
        }
}

static void add_cell(const bat_scatter *s, const bins *b, const quadrature_places at[2], int i,
                     int j)
{
    const int m = s->axis[0].degree + 1, n = s->axis[1].degree + 1;
    for (int g = 0; g < m; g++)
        for (int h = 0; h < n; h++) {
            const int here[2] = {i * m + g, j * n + h};
            const double w = at[0].w[here[0]] * at[1].w[here[1]];
            const int bin = bin_of(s, b, 0, at[0].x[here[0]]) * b->counts[1] +
                            bin_of(s, b, 1, at[1].x[here[1]]);
            const weighted_place place = {i, j, w, at[0].basis + here[0] * 3 * m,
                                          at[1].basis + here[1] * 3 * n};
            if (w > 0 && !b->held[bin])
                add_place(s, &place);
        }
}

batten_status bat_scatter_open(bat_scatter *s)
{
    bins b = {{0, 0}, NULL};
    quadrature_places at[2] = {{NULL, NULL, NULL}, {NULL, NULL, NULL}};
    batten_status status = find_bins(s, &b);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = find_places(&s->axis[k], &at[k]);
    for (int i = s->axis[0].degree; status == BATTEN_OK && i < s->axis[0].count; i++)
        for (int j = s->axis[1].degree; j < s->axis[1].count; j++)
            add_cell(s, &b, at, i, j);
    places_end(&at[1]);
    places_end(&at[0]);
    bat_release(b.held);
    return status;
}
