/*
 * The tensor product of splines in tension. On a cell the surface is
 *
 *     S = sum phi_a(u) C_ab psi_b(v),   phi = (1 - x, x, the shapes of the second derivatives),
 *
 * so that of each grid point four vectors are kept: P, P_uu, P_vv, P_uuvv. They come of three
 * passes: along the lines of P in u, along those of P in v, along those of P_uu in v.
 */
#include "numeric/vector.h"
#include "shape/formula/formula.h"
#include "shape/grid/tensor.h"
#include "spline/chain/chain.h"
#include <batten/interpolate.h>

#include <string.h>

enum { POINT, UU, VV, UUVV, VECTORS };

typedef struct {
    int count, spans;
    bool closed;
    double *parameters; /* [spans + 1] */
    double *tensions;   /* [spans], by the unit of the parameter */
} strips;

typedef struct {
    int dimension;
    strips u, v;
    double *vectors; /* [count_u][count_v][VECTORS][dimension] */
} tension_surface;

batten_surface_tension_options batten_surface_tension_defaults(void)
{
    return (batten_surface_tension_options){.size = sizeof(batten_surface_tension_options)};
}

/* ---- evaluation ---- */

static double *vector_of(const tension_surface *s, int i, int j, int which)
{
    const size_t at = (size_t)(i % s->u.count) * (size_t)s->v.count + (size_t)(j % s->v.count);
    return s->vectors + (at * VECTORS + (size_t)which) * (size_t)s->dimension;
}

/* The span that holds a parameter, and what belongs to its ends there: weights [end][value,
 * second derivative], each with three derivatives. */
typedef struct {
    int span;
    double weight[2][2][4];
} strip_place;

static strip_place place_on(const strips *s, double at, batten_side side)
{
    const int low = bat_breaks_span(s->spans + 1, s->parameters, at, side);
    const double a = s->parameters[low], b = s->parameters[low + 1], h = b - a;
    const double x = (at - a) / h, rest = (b - at) / h, z = s->tensions[low] * h;
    double up[4], down[4];
    bat_tension_shape(z, x, rest, up);
    bat_tension_shape(z, rest, x, down);
    strip_place p = {.span = low};
    p.weight[0][0][0] = rest;
    p.weight[0][0][1] = -1 / h;
    p.weight[1][0][0] = x;
    p.weight[1][0][1] = 1 / h;
    const double unit[4] = {h * h, h, 1, 1 / h};
    for (int k = 0; k < 4; k++) {
        p.weight[0][1][k] = (k % 2 ? -1 : 1) * down[k] * unit[k];
        p.weight[1][1][k] = up[k] * unit[k];
    }
    return p;
}

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const tension_surface *s = data;
    const int d = s->dimension;
    const strip_place pu = place_on(&s->u, at->u, at->sides.u),
                      pv = place_on(&s->v, at->v, at->sides.v);
    memset(out, 0, (size_t)BATTEN_SURFACE_DERIVATIVES(order) * (size_t)d * sizeof *out);
    for (int corner = 0; corner < 4; corner++)
        for (int which = 0; which < VECTORS; which++) {
            const int a = corner / 2, b = corner % 2;
            const double *c = vector_of(s, pu.span + a, pv.span + b, which);
            const double *f = pu.weight[a][which == UU || which == UUVV];
            const double *g = pv.weight[b][which == VV || which == UUVV];
            for (int n = 0; n <= order; n++)
                for (int l = 0; l <= n; l++) {
                    const double weight = f[n - l] * g[l];
                    double *sum = out + BATTEN_SURFACE_DERIVATIVE(n - l, l) * d;
                    for (int x = 0; x < d; x++)
                        sum[x] += weight * c[x];
                }
        }
    return BATTEN_OK;
}

static void free_strips(strips *s)
{
    bat_release(s->parameters);
    bat_release(s->tensions);
}

static void free_surface(void *data)
{
    tension_surface *s = data;
    free_strips(&s->u);
    free_strips(&s->v);
    bat_release(s->vectors);
    bat_release(s);
}

static const bat_formula formula = {"tension", evaluate, NULL, free_surface};

/* ---- the three passes ---- */

/* The second derivatives of the splines along one family of lines, from one of the vectors of
 * the grid points into another. */
typedef struct {
    const char *direction;
    tension_surface *surface;
    const strips *along;
    int lines;
    bool is_u;
    batten_chain_tension_options options;
    double *points; /* [along->count][dimension] */
} pass;

static double *on_line(const pass *p, int line, int i, int which)
{
    return vector_of(p->surface, p->is_u ? i : line, p->is_u ? line : i, which);
}

static batten_status run_line(const pass *p, int line, int from, int to)
{
    const size_t d = (size_t)p->surface->dimension;
    batten_chain *chain = NULL;
    for (int i = 0; i < p->along->count; i++)
        memcpy(p->points + (size_t)i * d, on_line(p, line, i, from), d * sizeof(double));
    const batten_status status =
        batten_chain_tension((batten_points){p->surface->dimension, p->along->count, p->points},
                             &p->options, NULL, &chain);
    for (int i = 0; status == BATTEN_OK && i < p->along->count; i++) {
        const int span = bat_min_int(i, p->along->spans - 1);
        memcpy(on_line(p, line, i, to), batten_chain_span(chain, span)->bend[i > span],
               d * sizeof(double));
    }
    for (int i = 0; status == BATTEN_OK && i < p->along->spans; i++)
        p->along->tensions[i] = batten_chain_span(chain, i)->tension;
    batten_chain_unref(chain);
    return status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY
               ? status
               : bat_line_fails(status, p->direction, line);
}

static batten_status run_pass(tension_surface *s, bool is_u, double tension,
                              const double *tensions, int from, int to)
{
    const strips *along = is_u ? &s->u : &s->v;
    pass p = {.direction = is_u ? "u" : "v",
              .surface = s,
              .along = along,
              .lines = is_u ? s->v.count : s->u.count,
              .is_u = is_u,
              .options = batten_chain_tension_defaults()};
    p.options.parameters = BATTEN_GIVEN;
    p.options.given = along->parameters;
    p.options.closed = along->closed;
    p.options.tension = tension;
    p.options.tensions = tensions;
    p.points = bat_array3((size_t)along->count, (size_t)s->dimension, sizeof *p.points);
    batten_status status = p.points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int line = 0; status == BATTEN_OK && line < p.lines; line++)
        status = run_line(&p, line, from, to);
    bat_release(p.points);
    return status;
}

/* ---- making ---- */

/* The strips own their parameters, whatever becomes of the rest. */
static strips strips_of(int count, bool closed, double *parameters)
{
    return (strips){count, closed ? count : count - 1, closed, parameters, NULL};
}

/* Parameters and points of a surface whose second derivatives are still to be found. */
static batten_status prepare_axes(int dimension, int count_u, int count_v, const double *points,
                                  const batten_surface_tension_options *o, tension_surface *s)
{
    const size_t d = (size_t)dimension, total = (size_t)count_u * (size_t)count_v;
    bat_grid_parameters at = {NULL, NULL, {0, 0}};
    const batten_status status = bat_grid_parameters_of(
        (batten_grid){dimension, count_u, count_v, points}, BATTEN_CHORD,
        (const bool[2]){o->closed_u, o->closed_v}, (const double *const[2]){o->u, o->v}, &at);
    s->dimension = dimension;
    s->u = strips_of(count_u, o->closed_u, at.u);
    s->v = strips_of(count_v, o->closed_v, at.v);
    if (status != BATTEN_OK)
        return status;
    s->u.tensions = bat_array((size_t)s->u.spans, sizeof *s->u.tensions);
    s->v.tensions = bat_array((size_t)s->v.spans, sizeof *s->v.tensions);
    s->vectors = bat_array3(total, VECTORS * d, sizeof *s->vectors);
    if (!s->u.tensions || !s->v.tensions || !s->vectors)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < total; i++)
        memcpy(s->vectors + i * VECTORS * d, points + i * d, d * sizeof *points);
    return BATTEN_OK;
}

static batten_status hand_over_patches(tension_surface *s, size_t total, batten_surface **out)
{
    const bat_formula_axis u = {s->u.spans + 1, s->u.parameters, 2},
                           v = {s->v.spans + 1, s->v.parameters, 2};
    double largest = 0;
    for (size_t i = 0; i < total; i++)
        largest =
            bat_max(largest,
                    bat_largest(s->dimension, s->vectors + i * VECTORS * (size_t)s->dimension));
    return bat_formula_create(&formula, s, s->dimension, &u, &v, largest, out);
}

batten_status batten_surface_tension(batten_grid points,
                                     const batten_surface_tension_options *options,
                                     batten_surface **out)
{
    assert(points.at && out);
    batten_surface_tension_options chosen = batten_surface_tension_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_tension_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_tension_options *o = &chosen;
    status = bat_grid_check(points.dimension, points.count_u, points.count_v, points.at,
                            o->closed_u, o->closed_v);
    if (status != BATTEN_OK)
        return status;
    tension_surface *s = bat_array(1, sizeof *s);
    if (!s)
        return BATTEN_OUT_OF_MEMORY;
    status = prepare_axes(points.dimension, points.count_u, points.count_v, points.at, o, s);
    if (status == BATTEN_OK)
        status = run_pass(s, true, o->tension_u, o->tensions_u, POINT, UU);
    if (status == BATTEN_OK)
        status = run_pass(s, false, o->tension_v, o->tensions_v, POINT, VV);
    if (status == BATTEN_OK)
        status = run_pass(s, false, o->tension_v, o->tensions_v, UU, UUVV);
    if (status == BATTEN_OK)
        status = hand_over_patches(s, (size_t)points.count_u * (size_t)points.count_v, out);
    if (status != BATTEN_OK)
        free_surface(s);
    return status;
}
