/*
 * Curvature taken over along the sides. To a fill with the right tangent planes is added, in
 * both quads of a side,
 *
 *     H(v) N(u) + c N(1) X(u) Y(v),   H = v^2 (1 - v)^3 / 2, Y = v H' - 2 H, X = u^3 (u - 1),
 *
 * (v across the side, u from its corner to its middle): N is added to S_vv along the side, and
 * position, slopes and all else on the other edges stay, but that the spoke moves by H N(1).
 * The second term lets both quads keep one tangent plane along it, as l = 2 c v ties S_u to S_v
 * there (side_fields.c): with N' = m + 2 c N and -m + 2 c N at the middle, seen from both
 * corners.
 */
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include <batten/interpolate.h>
#include <string.h>

enum { NODES = 24 };

/* N along the half of a side from its corner to its middle. */
typedef struct {
    batten_curve *curve; /* NULL where nothing is to be added */
    double middle[3];    /* N(1) */
} bend;

/* Where N is known: closer near the corner, where it begins with 0. */
static double node(int k)
{
    const double t = (double)k / NODES;
    return t * sqrt(t);
}

/* How N dies away towards a corner where it does not vanish by itself: there the sides say
 * different things of the curvature. */
static double fade(double u)
{
    const double t = bat_min(1, 4 * u);
    return t * t * t * (10 - 15 * t + 6 * t * t);
}

static batten_status sample(const bat_fill_loop *loop, int side, int half,
                            const batten_surface *patch, double values[NODES + 1][3])
{
    double largest = 0, first = 0;
    for (int k = 1; k <= NODES; k++) {
        const batten_status status = bat_fill_lack(loop, side, half, patch, node(k), values[k]);
        if (status != BATTEN_OK)
            return status;
        largest = bat_max(largest, bat_norm(3, values[k]));
        if (node(k) < 1.0 / 16)
            first = bat_max(first, bat_norm(3, values[k]));
    }
    memset(values[0], 0, sizeof values[0]);
    for (int k = 1; k <= NODES && first > 0.1 * largest; k++)
        for (int c = 0; c < 3; c++)
            values[k][c] *= fade(node(k));
    return BATTEN_OK;
}

/* The spline through the samples, 0 with two derivatives in the corner, `slope` at the middle.
 */
static batten_status through(const double values[NODES + 1][3], const double slope[3],
                             int degree, bend *out)
{
    double nodes[NODES + 1];
    batten_derivative conditions[3] = {{0, 1, {0}}, {0, 2, {0}}, {NODES, 1, {0}}};
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    for (int k = 0; k <= NODES; k++)
        nodes[k] = node(k);
    memcpy(conditions[2].value, slope, 3 * sizeof *slope);
    memcpy(out->middle, values[NODES], sizeof out->middle);
    options.degree = degree;
    options.parameters = BATTEN_GIVEN;
    options.given = nodes;
    options.knots_at_data = false;
    options.derivative_count = 3;
    options.derivatives = conditions;
    return batten_curve_interpolate((batten_points){3, NODES + 1, values[0]}, &options, NULL,
                                    &out->curve);
}

/* That of the surface in the half of side i, so that N brings its own knots alone; up to 9
 * interpolation is safe. */
static int degree_along(batten_surface *const *patches, int count, int i, int half)
{
    const int degree =
        batten_surface_degree(patches[(i + half) % count], half == 0 ? BATTEN_U : BATTEN_V);
    return bat_min_int(degree, 9);
}

/* Both halves of side i: N is one vector in the middle, and m the mean of its derivatives. */
static batten_status bend_side(const bat_fill_loop *loop, int i, double c,
                               batten_surface *const *patches, bend halves[2])
{
    double values[2][NODES + 1][3], mean[3];
    batten_status status = BATTEN_OK;
    for (int h = 0; status == BATTEN_OK && h < 2; h++)
        status = sample(loop, i, h, patches[(i + h) % loop->count], values[h]);
    if (status != BATTEN_OK)
        return status;
    const double step = 1 - node(NODES - 1);
    for (int k = 0; k < 3; k++) {
        mean[k] = (values[1][NODES - 1][k] - values[0][NODES - 1][k]) / (2 * step);
        values[0][NODES][k] = values[1][NODES][k] =
            (values[0][NODES][k] + values[1][NODES][k]) / 2;
    }
    for (int h = 0; status == BATTEN_OK && h < 2; h++) {
        double slope[3];
        for (int k = 0; k < 3; k++)
            slope[k] = (h == 0 ? mean[k] : -mean[k]) + 2 * c * values[h][NODES][k];
        status = through((const double(*)[3])values[h], slope,
                         degree_along(patches, loop->count, i, h), &halves[h]);
    }
    return status;
}

/* ---- adding to a quad ---- */

/* H, X, Y as coordinates of a quintic. */
static batten_status functions(batten_curve **out)
{
    static const double points[6][3] = {{0, 0, 0},        {0, 0, 0},    {0.05, 0, 0},
                                        {0, -0.1, -0.15}, {0, -0.2, 0}, {0, 0, 0}};
    static const double ends[2] = {0, 1};
    return batten_curve_from_bezier(3, (batten_pieces){5, 1, ends}, points[0], NULL, out);
}

/* One direction: N (zero where there is none) and the functions on the knots of the surface to
 * come. */
typedef struct {
    batten_curve *N, *functions;
} direction_set;

/* The knots that a surface lacks, in its direction. */
static batten_status refine_to(const batten_surface *surface, batten_direction direction,
                               const batten_curve *model, batten_surface **out)
{
    const int count = batten_curve_knot_count(model);
    const int have = batten_surface_knot_count(surface, direction);
    const double *all = batten_curve_knots(model);
    const double *old = batten_surface_knots(surface, direction);
    double *missing = bat_array((size_t)count, sizeof *missing);
    int lacking = 0;
    if (!missing)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0, j = 0; i < count; i++) {
        if (j < have && old[j] == all[i])
            j++;
        else
            missing[lacking++] = all[i];
    }
    const batten_status status =
        batten_surface_refine(surface, direction, lacking, missing, out);
    bat_release(missing);
    return status;
}

/* Bring N, the functions and the surface to the same degree and knots. */
static batten_status unify(batten_surface **surface, batten_direction direction,
                           const batten_curve *N, direction_set *out)
{
    batten_curve *plain = NULL, *edge = NULL, *same[3] = {NULL};
    batten_surface *raised = NULL, *refined = NULL;
    batten_status status = functions(&plain);
    if (status == BATTEN_OK)
        status = batten_surface_isocurve(*surface, direction == BATTEN_U ? BATTEN_V : BATTEN_U,
                                         0, &edge);
    if (status == BATTEN_OK) {
        const batten_curve *all[3] = {edge, plain, N ? N : plain};
        status = batten_curves_unify(3, all, same);
    }
    if (status == BATTEN_OK)
        status = batten_surface_elevate(
            *surface, direction,
            batten_curve_degree(same[0]) - batten_surface_degree(*surface, direction), &raised);
    if (status == BATTEN_OK)
        status = refine_to(raised, direction, same[0], &refined);
    if (status == BATTEN_OK) {
        batten_surface_unref(*surface);
        *surface = refined;
        out->functions = same[1];
        out->N = N ? same[2] : NULL;
        same[1] = NULL;
        same[2] = N ? NULL : same[2];
    }
    batten_surface_unref(raised);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(same[k]);
    batten_curve_unref(edge);
    batten_curve_unref(plain);
    return status;
}

/* points + H(v) N(u) + c N(1) X(u) Y(v), and the same for v. */
static void add_terms(const direction_set set[2], const bend *const bends[2], double c,
                      int count_u, int count_v, double *points)
{
    for (int i = 0; i < count_u; i++)
        for (int j = 0; j < count_v; j++, points += 3) {
            const int at[2] = {i, j};
            for (int d = 0; d < 2; d++) {
                if (!set[d].N)
                    continue;
                const double *along = batten_curve_points(set[d].functions) + 3 * at[d];
                const double *across =
                    batten_curve_points(set[1 - d].functions) + 3 * at[1 - d];
                const double *N = batten_curve_points(set[d].N) + 3 * at[d];
                for (int k = 0; k < 3; k++)
                    points[k] +=
                        across[0] * N[k] + c * bends[d]->middle[k] * along[1] * across[2];
            }
        }
}

static batten_status add_to_quad(const bend *along_u, const bend *along_v, double c,
                                 batten_surface **patch)
{
    const bend *const bends[2] = {along_u, along_v};
    direction_set set[2] = {{NULL, NULL}, {NULL, NULL}};
    batten_surface *made = NULL, *work = batten_surface_ref(*patch);
    batten_status status = BATTEN_OK;
    for (int d = 0; status == BATTEN_OK && d < 2; d++)
        status = unify(&work, d == 0 ? BATTEN_U : BATTEN_V, bends[d]->curve, &set[d]);
    if (status == BATTEN_OK) {
        const int count_u = batten_surface_point_count(work, BATTEN_U);
        const int count_v = batten_surface_point_count(work, BATTEN_V);
        const size_t size = 3 * (size_t)count_u * (size_t)count_v;
        const batten_axis axes[2] = {{batten_surface_degree(work, BATTEN_U), count_u,
                                      batten_surface_knots(work, BATTEN_U), false},
                                     {batten_surface_degree(work, BATTEN_V), count_v,
                                      batten_surface_knots(work, BATTEN_V), false}};
        double *points = bat_array(size, sizeof *points);
        status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
        if (points) {
            memcpy(points, batten_surface_points(work), size * sizeof *points);
            add_terms(set, bends, c, count_u, count_v, points);
            status = batten_surface_create(3, &axes[0], &axes[1], points, NULL, &made);
        }
        bat_release(points);
    }
    for (int d = 0; d < 2; d++) {
        batten_curve_unref(set[d].N);
        batten_curve_unref(set[d].functions);
    }
    batten_surface_unref(work);
    if (status == BATTEN_OK) {
        batten_surface_unref(*patch);
        *patch = made;
    }
    return status;
}

batten_status bat_fill_bend(const bat_fill_loop *loop, batten_surface **patches)
{
    bend halves[BATTEN_FILL_SIDES][2] = {{{NULL, {0}}}};
    const int n = loop->count;
    const double c = n == 4 ? 0 : bat_cos(2 * BAT_PI / n);
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < n; i++)
        if (loop->sides[i].bend)
            status = bend_side(loop, i, c, patches, halves[i]);
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        const bend *before = &halves[(i + n - 1) % n][1];
        if (halves[i][0].curve || before->curve)
            status = add_to_quad(&halves[i][0], before, c, &patches[i]);
    }
    for (int i = 0; i < n; i++)
        for (int h = 0; h < 2; h++)
            batten_curve_unref(halves[i][h].curve);
    return status;
}
