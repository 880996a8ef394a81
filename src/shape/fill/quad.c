/* One surface of a fill: the boolean sum of its four edges and the derivatives across them. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include "spline/curve/product.h"
#include <string.h>

/* Products grow knots that are not needed; the loop has size 1. */
static const double rounding = BAT_EXACT;

/* More control points than this are refused before they are made. */
enum { MOST_POINTS = 4000000 };

/* c0, r0, c1, r1: at the start of the other parameter point and derivative, then at its end. */
typedef struct {
    batten_curve *curves[4];
} edge_set;

static void free_edges(edge_set *edges)
{
    for (int k = 0; k < 4; k++)
        batten_curve_unref(edges->curves[k]);
}

/* The sum of curves over [0, 1]; gives their references back. */
static batten_status sum_of(batten_status status, int count, batten_curve **curves,
                            batten_curve **out)
{
    batten_curve *same[3] = {NULL};
    double *points = NULL;
    if (status == BATTEN_OK)
        status = batten_curves_unify(count, (const batten_curve *const *)curves, same);
    if (status == BATTEN_OK) {
        const size_t size = 3 * (size_t)batten_curve_point_count(same[0]);
        points = bat_array(size, sizeof *points);
        status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
        for (int k = 0; points && k < count; k++)
            for (size_t j = 0; j < size; j++)
                points[j] += batten_curve_points(same[k])[j];
    }
    batten_curve *sum = NULL;
    if (status == BATTEN_OK)
        status = batten_curve_create(
            (batten_points){3, batten_curve_point_count(same[0]), points},
            batten_curve_degree(same[0]), NULL, batten_curve_knots(same[0]), &sum);
    if (status == BATTEN_OK)
        status = batten_curve_remove_knots(sum, rounding, NULL, NULL, out);
    batten_curve_unref(sum);
    bat_release(points);
    for (int k = 0; k < count; k++) {
        batten_curve_unref(same[k]);
        batten_curve_unref(curves[k]);
    }
    return status;
}

/* factor C' of a polynomial curve without corners. */
static batten_status derivative(const batten_curve *curve, double factor, batten_curve **out)
{
    batten_curve *raised = NULL, *pieces = NULL;
    double *points = NULL, *breaks = NULL;
    batten_status status = batten_curve_elevate(curve, batten_curve_degree(curve) < 2, &raised);
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(raised, &pieces);
    if (status == BATTEN_OK) {
        const int p = batten_curve_degree(pieces), count = batten_curve_spans(pieces, NULL) - 1;
        points = bat_array((size_t)count * (size_t)(p - 1) + 1, 3 * sizeof *points);
        breaks = bat_array((size_t)batten_curve_point_count(pieces) + 1, sizeof *breaks);
        if (points && breaks) {
            const double *P = batten_curve_points(pieces);
            batten_curve_spans(pieces, breaks);
            for (int k = 0; k < count; k++)
                for (int j = 0; j < 3 * p; j++)
                    points[3 * k * (p - 1) + j] = factor * p *
                                                  (P[3 * k * p + j + 3] - P[3 * k * p + j]) /
                                                  (breaks[k + 1] - breaks[k]);
            status = batten_curve_from_bezier(3, (batten_pieces){p - 1, count, breaks}, points,
                                              NULL, out);
        } else {
            status = BATTEN_OUT_OF_MEMORY;
        }
    }
    bat_release(breaks);
    bat_release(points);
    batten_curve_unref(pieces);
    batten_curve_unref(raised);
    return status;
}

/* Half of a side over [0, 1], from its corner to its middle. */
static batten_status half_of(const batten_curve *curve, int half, batten_curve **out)
{
    batten_curve *part = NULL, *turned = NULL;
    batten_status status = batten_curve_subrange(curve, half, half + 1, &part);
    if (status == BATTEN_OK && half == 1)
        status = batten_curve_reverse(part, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(half == 1 ? turned : part, 0, 1, out);
    batten_curve_unref(turned);
    batten_curve_unref(part);
    return status;
}

/* ---- derivatives across a side ---- */

/* What D and D' must be at the corner and at the middle: [end][order][3]. */
static void wanted(const bat_fill *fill, const bat_fill_fields *side, int half,
                   double out[2][2][3])
{
    const int station[2] = {half == 0 ? FILL_START : FILL_END,
                            half == 0 ? FILL_BEFORE : FILL_AFTER};
    for (int end = 0; end < 2; end++) {
        bat_fill_vector(fill, side->across[station[end]][0], out[end][0]);
        bat_fill_vector(fill, side->across[station[end]][1], out[end][1]);
        for (int c = 0; c < 3 && half == 1; c++)
            out[end][1][c] = -out[end][1][c];
    }
}

/* a T or b C', over [0, 1] from the corner. */
static batten_status product_of(const bat_fill *fill, const bat_fill_fields *side, int half,
                                int which, const batten_curve *vector, batten_curve **out)
{
    const int station[2] = {half == 0 ? FILL_START : FILL_END,
                            half == 0 ? FILL_BEFORE : FILL_AFTER};
    const double sign = half == 0 ? 1 : -1, ends[2] = {0, 1};
    double values[4];
    batten_curve *factor = NULL;
    for (int end = 0; end < 2; end++) {
        values[2 * end] = bat_fill_number(fill, side->factor[station[end]][which][0]);
        values[2 * end + 1] =
            sign * bat_fill_number(fill, side->factor[station[end]][which][1]);
    }
    batten_status status = batten_curve_from_hermite(1, 2, 2, ends, values, &factor);
    if (status == BATTEN_OK)
        status = bat_curve_product(factor, vector, out);
    batten_curve_unref(factor);
    return status;
}

/* How wide the zone at an end is in which D leaves the tangent planes: such that a bump of
 * slope |off| turns them by `angle` at most, 4/27 of slope and width being its height. */
static double zone(const double value[3], const double turn[3], const double D[3],
                   const double along[3], double angle)
{
    const batten_vec3 across = bat_vec3_cross(bat_vec3_of(3, D), bat_vec3_of(3, along));
    const double height = bat_vec3_norm(across) / bat_norm(3, along);
    const double slope = bat_norm(3, turn);
    double width = 0.25;
    if (bat_norm(3, value) > rounding) /* the planes differ in the corner itself */
        width = 1.0 / 64;
    if (slope > 0)
        width = bat_min(width, 27.0 / 4 * height * angle / slope);
    return bat_max(width, 1e-4);
}

/* What is to be added to D so that both ends are as wanted; nothing where they are. */
static batten_status correction(const batten_curve *D, const batten_curve *curve,
                                const double want[2][2][3], double angle, batten_curve **out)
{
    double values[4][2][3] = {{{0}}}, width[2] = {0, 0};
    for (int end = 0; end < 2; end++) {
        double have[2][3], along[2][3];
        batten_status status = batten_curve_evaluate(D, end, 1, have[0]);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(curve, end, 1, along[0]);
        if (status != BATTEN_OK)
            return status;
        double(*bump)[3] = values[3 * end];
        for (int m = 0; m < 2; m++)
            for (int c = 0; c < 3; c++)
                bump[m][c] = want[end][m][c] - have[m][c];
        if (bat_norm(3, bump[0]) > 10 * rounding || bat_norm(3, bump[1]) > 1e3 * rounding)
            width[end] = zone(bump[0], bump[1], want[end][0], along[1], angle);
        else
            memset(bump, 0, 2 * sizeof *bump);
    }
    const double breaks[4] = {0, width[0] > 0 ? width[0] : 0.25,
                              1 - (width[1] > 0 ? width[1] : 0.25), 1};
    if (width[0] == 0 && width[1] == 0)
        return BATTEN_OK;
    return batten_curve_from_hermite(3, 4, 2, breaks, values[0][0], out);
}

static batten_status across_side(const bat_fill *fill, int i, int half,
                                 const batten_curve *curve, double angle, batten_curve **out)
{
    const bat_fill_fields *side = &fill->side[i];
    const double ends[2] = {0, 1};
    double want[2][2][3];
    wanted(fill, side, half, want);
    if (!side->has_slope)
        return batten_curve_from_hermite(3, 2, 2, ends, want[0][0], out);
    batten_curve *slope = NULL, *along = NULL, *D = NULL, *parts[2] = {NULL}, *bump = NULL;
    batten_status status = half_of(fill->loop->sides[i].slope, half, &slope);
    if (status == BATTEN_OK)
        status = derivative(curve, half == 0 ? 1 : -1, &along);
    if (status == BATTEN_OK)
        status = product_of(fill, side, half, 0, slope, &parts[0]);
    if (status == BATTEN_OK)
        status = product_of(fill, side, half, 1, along, &parts[1]);
    status = sum_of(status, 2, parts, &D);
    if (status == BATTEN_OK)
        status = correction(D, curve, (const double(*)[2][3])want, angle, &bump);
    if (status == BATTEN_OK && bump) {
        parts[0] = D;
        parts[1] = bump;
        D = NULL;
        status = sum_of(BATTEN_OK, 2, parts, out);
    } else if (status == BATTEN_OK) {
        *out = batten_curve_ref(D);
    }
    batten_curve_unref(D);
    batten_curve_unref(along);
    batten_curve_unref(slope);
    return status;
}

/* ---- spokes ---- */

/* The spoke, and sign W + c t G' across it. */
static batten_status spoke_edges(const bat_fill *fill, int i, double sign, batten_curve **spoke,
                                 batten_curve **across)
{
    const bat_fill_fields *side = &fill->side[i];
    const double ends[2] = {0, 1}, c = fill->cosine, linear[2] = {0, c};
    double G[2][3][3], W[2][2][3];
    batten_curve *factor = NULL, *along = NULL, *parts[2] = {NULL};
    for (int end = 0; end < 2; end++)
        for (int m = 0; m < 3; m++) {
            bat_fill_vector(fill, side->spoke[end][m], G[end][m]);
            if (m < 2)
                bat_fill_vector(fill, side->turn[end][m], W[end][m]);
            for (int k = 0; k < 3 && m < 2; k++)
                W[end][m][k] *= sign;
        }
    batten_status status = batten_curve_from_hermite(3, 2, 3, ends, G[0][0], spoke);
    if (status == BATTEN_OK)
        status = batten_curve_from_hermite(3, 2, 2, ends, W[0][0], &parts[0]);
    if (status == BATTEN_OK)
        status = derivative(*spoke, 1, &along);
    if (status == BATTEN_OK)
        status =
            batten_curve_from_bezier(1, (batten_pieces){1, 1, ends}, linear, NULL, &factor);
    if (status == BATTEN_OK)
        status = bat_curve_product(factor, along, &parts[1]);
    batten_curve_unref(factor);
    batten_curve_unref(along);
    return sum_of(status, 2, parts, across);
}

static batten_status edges_of(const bat_fill *fill, int quad, int direction, double angle,
                              edge_set *out)
{
    const int before = (quad + fill->count - 1) % fill->count;
    const int side = direction == 0 ? quad : before, spoke = direction == 0 ? before : quad;
    batten_status status = half_of(fill->loop->sides[side].curve, direction, &out->curves[0]);
    if (status == BATTEN_OK)
        status = across_side(fill, side, direction, out->curves[0], angle, &out->curves[1]);
    if (status == BATTEN_OK)
        status =
            spoke_edges(fill, spoke, direction == 0 ? -1 : 1, &out->curves[2], &out->curves[3]);
    return status;
}

/* ---- the boolean sum ---- */

/* Edges and blends of one direction with the same degree and knots; the curve of the blends
 * has F0, G0, G1 as its coordinates. */
typedef struct {
    batten_curve *curves[5];
    int count;
} direction_set;

static batten_status unify(const edge_set *edges, direction_set *out)
{
    static const double points[4][3] = {
        {1, 0, 0}, {1, 1.0 / 3, 0}, {0, 0, -1.0 / 3}, {0, 0, 0}};
    static const double ends[2] = {0, 1};
    batten_curve *blends = NULL;
    batten_status status =
        batten_curve_from_bezier(3, (batten_pieces){3, 1, ends}, points[0], NULL, &blends);
    if (status == BATTEN_OK) {
        const batten_curve *all[5] = {edges->curves[0], edges->curves[1], edges->curves[2],
                                      edges->curves[3], blends};
        status = batten_curves_unify(5, all, out->curves);
    }
    if (status == BATTEN_OK)
        out->count = batten_curve_point_count(out->curves[0]);
    batten_curve_unref(blends);
    return status;
}

/* Blends belonging to the curves c0, r0, c1, r1, at control point i. */
static void blends_at(const direction_set *set, int i, double out[4])
{
    const double *b = batten_curve_points(set->curves[4]) + (size_t)3 * (size_t)i;
    out[0] = b[0];
    out[1] = b[1];
    out[2] = 1 - b[0];
    out[3] = b[2];
}

/* [along u: point, derivative at 0, at 1][function of u][3] */
static batten_status corner_values(const direction_set *u, double out[4][4][3])
{
    for (int f = 0; f < 4; f++)
        for (int end = 0; end < 2; end++) {
            double value[2][3];
            const batten_status status = batten_curve_evaluate(u->curves[f], end, 1, value[0]);
            if (status != BATTEN_OK)
                return status;
            memcpy(out[2 * end][f], value[0], sizeof value[0]);
            memcpy(out[2 * end + 1][f], value[1], sizeof value[1]);
        }
    return BATTEN_OK;
}

static void fill_net(const direction_set *u, const direction_set *v,
                     const double corners[4][4][3], double *net)
{
    for (int i = 0; i < u->count; i++)
        for (int j = 0; j < v->count; j++, net += 3) {
            double A[4], B[4];
            blends_at(u, i, A);
            blends_at(v, j, B);
            for (int f = 0; f < 4; f++)
                for (int c = 0; c < 3; c++) {
                    double across = batten_curve_points(v->curves[f])[3 * j + c];
                    for (int g = 0; g < 4; g++)
                        across -= B[g] * corners[f][g][c];
                    net[c] +=
                        B[f] * batten_curve_points(u->curves[f])[3 * i + c] + A[f] * across;
                }
        }
}

/* The four edges keep the bits of their curves. */
static void set_edges(const direction_set *u, const direction_set *v, double *net)
{
    const size_t row = 3 * (size_t)v->count, point = 3 * sizeof(double);
    for (int end = 0; end < 2; end++) {
        const size_t last = end == 0 ? 0 : (size_t)(u->count - 1);
        memcpy(net + last * row, batten_curve_points(v->curves[2 * end]), row * sizeof *net);
    }
    for (int i = 0; i < u->count; i++)
        for (int end = 0; end < 2; end++)
            memcpy(net + (size_t)i * row + (end == 0 ? 0 : row - 3),
                   batten_curve_points(u->curves[2 * end]) + (size_t)3 * (size_t)i, point);
}

static batten_status boolean_sum(const direction_set *u, const direction_set *v,
                                 batten_surface **out)
{
    double corners[4][4][3];
    if ((double)u->count * v->count > MOST_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "a surface of the fill would have %d x %d control points; %d in all "
                        "are the most",
                        u->count, v->count, MOST_POINTS);
    batten_status status = corner_values(u, corners);
    double *net = bat_array3((size_t)u->count, (size_t)v->count, 3 * sizeof *net);
    if (!net)
        return BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const batten_axis axes[2] = {{batten_curve_degree(u->curves[0]), u->count,
                                      batten_curve_knots(u->curves[0]), false},
                                     {batten_curve_degree(v->curves[0]), v->count,
                                      batten_curve_knots(v->curves[0]), false}};
        fill_net(u, v, (const double(*)[4][3])corners, net);
        set_edges(u, v, net);
        status = batten_surface_create(3, &axes[0], &axes[1], net, NULL, out);
    }
    bat_release(net);
    return status;
}

batten_status bat_fill_patch(const bat_fill *fill, int quad, double angle, batten_surface **out)
{
    edge_set edges[2] = {{{NULL}}};
    direction_set sets[2] = {{{NULL}, 0}};
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = edges_of(fill, quad, k, angle, &edges[k]);
        if (status == BATTEN_OK)
            status = unify(&edges[k], &sets[k]);
    }
    if (status == BATTEN_OK)
        status = boolean_sum(&sets[0], &sets[1], out);
    for (int k = 0; k < 2; k++) {
        free_edges(&edges[k]);
        for (int f = 0; f < 5; f++)
            batten_curve_unref(sets[k].curves[f]);
    }
    return status;
}
