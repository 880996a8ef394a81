/* Gregory patches over the square and the triangle. */
#include "numeric/jet.h"
#include "shape/formula/formula.h"
#include <batten/fill.h>

#include "numeric/vector.h"
#include "spline/spline.h"
#include <float.h>
#include <string.h>

/* Nearer to a corner than this the parameters are rounding. */
static const double corner = 1e-14;

/* a p + b q over a + b: halfway where both vanish. Numbers are parameters or barycentric
 * coordinates, none negative. */
static void blend_two(bat_jet a, bat_jet b, const double p[3], const double q[3],
                      bat_jet out[3])
{
    bat_jet share = bat_jet_constant(0.5);
    if (a.d[0] + b.d[0] > corner)
        share = bat_jet_divide(a, bat_jet_add(a, b));
    for (int c = 0; c < 3; c++)
        out[c] = bat_jet_add(bat_jet_constant(q[c]), bat_jet_scale(p[c] - q[c], share));
}

/* out += weight point */
static void add_weighted(bat_jet weight, const double point[3], bat_jet out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = bat_jet_add(out[c], bat_jet_scale(point[c], weight));
}

/* The jets of three coordinates as derivatives [..][3]. */
static void copy_derivatives(const bat_jet point[3], int order, double *out)
{
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
        for (int c = 0; c < 3; c++)
            out[3 * i + c] = point[c].d[i];
}

/* The surface of a formula over the unit square whose data [count] start with its points. */
static batten_status create_patch(const bat_formula *formula, const double *points,
                                  size_t count, batten_surface **out)
{
    static const double ends[2] = {0, 1};
    const bat_formula_axis axis = {2, ends, 2};
    const size_t bad = bat_first_not_finite(points, 3 * count);
    if (bad < 3 * count)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of point %zu is not finite",
                        bad % 3 + 1, bad / 3 + 1);
    double *data = bat_array(3 * count, sizeof *data);
    if (!data)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(data, points, 3 * count * sizeof *data);
    const double size = bat_largest((int)(3 * count), points);
    const batten_status status = bat_formula_create(formula, data, 3, &axis, &axis, size, out);
    if (status != BATTEN_OK)
        bat_release(data);
    return status;
}

/* ---- the square ---- */

/* Bernstein polynomials of degree n of the jet t: out [n + 1]. */
static void bernstein(int n, bat_jet t, bat_jet *out)
{
    const bat_jet s = bat_jet_subtract(bat_jet_constant(1), t);
    for (int i = 0; i <= n; i++) {
        out[i] = bat_jet_constant(bat_binomials[n][i]);
        for (int k = 0; k < n; k++)
            out[i] = bat_jet_multiply(out[i], k < i ? t : s);
    }
}

/* data [4][4][3], [2][2][2][3] */
static batten_status evaluate_square(const void *data, const bat_surface_place *at, int order,
                                     double *out)
{
    const double *points = data, *inner = points + 48;
    const bat_jet one = bat_jet_constant(1), u = bat_jet_u(at->u), v = bat_jet_v(at->v);
    const bat_jet from_u[2] = {u, bat_jet_subtract(one, u)};
    const bat_jet from_v[2] = {v, bat_jet_subtract(one, v)};
    bat_jet Bu[4], Bv[4], sum[3] = {{{0}}, {{0}}, {{0}}};
    bernstein(3, u, Bu);
    bernstein(3, v, Bv);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            const bat_jet weight = bat_jet_multiply(Bu[i], Bv[j]);
            if (i == 0 || i == 3 || j == 0 || j == 3) {
                add_weighted(weight, points + 3 * (4 * i + j), sum);
                continue;
            }
            /* near v = 0 the point that this edge sees counts: u its weight */
            const double *two = inner + 6 * (2 * (i - 1) + (j - 1));
            bat_jet point[3];
            blend_two(from_u[i - 1], from_v[j - 1], two, two + 3, point);
            for (int c = 0; c < 3; c++)
                sum[c] = bat_jet_add(sum[c], bat_jet_multiply(weight, point[c]));
        }
    copy_derivatives(sum, order, out);
    return BATTEN_OK;
}

static const bat_formula square = {"gregory", evaluate_square, NULL, batten_release};

batten_status batten_surface_gregory(const double *points, const double *inner,
                                     batten_surface **out)
{
    double all[24][3];
    memcpy(all[0], points, 16 * sizeof all[0]);
    memcpy(all[16], inner, 8 * sizeof all[0]);
    for (int i = 1; i < 3; i++) /* not looked at: they may be anything */
        for (int j = 1; j < 3; j++)
            memcpy(all[4 * i + j], points, sizeof all[0]);
    return create_patch(&square, all[0], 24, out);
}

/* ---- the triangle ---- */

static bat_jet power(bat_jet a, int n)
{
    bat_jet product = bat_jet_constant(1);
    for (int k = 0; k < n; k++)
        product = bat_jet_multiply(product, a);
    return product;
}

/* data [3][5][3], [3][2][3]. Point k of edge e has 4 - k times corner e and k times the next.
 */
static batten_status evaluate_triangle(const void *data, const bat_surface_place *at, int order,
                                       double *out)
{
    const double *edges = data, *inner = edges + 45;
    const bat_jet one = bat_jet_constant(1), u = bat_jet_u(at->u), v = bat_jet_v(at->v);
    const bat_jet uv = bat_jet_multiply(u, v);
    const bat_jet b[3] = {bat_jet_subtract(one, u), bat_jet_subtract(u, uv), uv};
    bat_jet sum[3] = {{{0}}, {{0}}, {{0}}};
    for (int e = 0; e < 3; e++) {
        const int next = (e + 1) % 3, last = (e + 2) % 3;
        for (int k = 0; k < 4; k++) {
            const bat_jet weight = bat_jet_multiply(power(b[e], 4 - k), power(b[next], k));
            add_weighted(bat_jet_scale(bat_binomials[4][k], weight), edges + 3 * (5 * e + k),
                         sum);
        }
        /* On the edge to the next corner b[last] is 0, and the point that it sees counts. At
         * the pole both vanish, but their ratio is that of 1 - v and v. */
        const bat_jet p = e == 0 ? bat_jet_subtract(one, v) : b[next];
        const bat_jet q = e == 0 ? v : b[last];
        const bat_jet weight = bat_jet_scale(
            12, bat_jet_multiply(power(b[e], 2), bat_jet_multiply(b[next], b[last])));
        bat_jet point[3];
        blend_two(p, q, inner + 6 * e, inner + 6 * e + 3, point);
        for (int c = 0; c < 3; c++)
            sum[c] = bat_jet_add(sum[c], bat_jet_multiply(weight, point[c]));
    }
    copy_derivatives(sum, order, out);
    return BATTEN_OK;
}

static const bat_formula triangle = {"gregory-triangle", evaluate_triangle, NULL,
                                     batten_release};

batten_status batten_surface_gregory_triangle(const double *edges, const double *inner,
                                              batten_surface **out)
{
    double all[21][3];
    memcpy(all[0], edges, 15 * sizeof all[0]);
    memcpy(all[15], inner, 6 * sizeof all[0]);
    for (int e = 0; e < 3; e++) {
        const double *end = all[5 * e + 4], *start = all[5 * ((e + 1) % 3)];
        const double gap = bat_distance(3, end, start);
        if (gap > 8 * DBL_EPSILON * bat_max(bat_largest(3, end), bat_largest(3, start)))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "edge %d of the triangle ends %g away from where edge %d begins",
                            e + 1, gap, (e + 1) % 3 + 1);
    }
    return create_patch(&triangle, all[0], 21, out);
}
