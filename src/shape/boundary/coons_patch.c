/*
 * A Coons patch from its sides: what is known at the corners, and what happens where two sides
 * know different things.
 *
 * C_ij is seen from both sides: as derivative of line L_i at an end, and of line M_j. The
 * formula misses L_i by sum_j B_j (seen by M_j - C_ij), and M_j by sum_i A_i (seen by L_i -
 * C_ij). So correcting a line by such a sum, and leaving it to be missed by it, is one and the
 * same surface, and all policies are but choices of C_ij.
 *
 * A line that is not given is made of what is known at its ends, sum_j B_j C_ij. Then its terms
 * in the formula are terms of corners.
 */
#include "base/plural.h"
#include "shape/boundary/coons_formula.h"

#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

enum { SAMPLES = 64 };

/* Line 2 a + i of a direction is the derivative of order a across its end i. */
typedef struct {
    const batten_surface_coons_options *options;
    const batten_ribbon *sides;
    int dimension, order;
    bat_coons coons;
    batten_surface_coons_report report;
    /* [line along v][line along u]: as seen by the former, by the latter */
    double seen[2][6][6][3];
    double corner[6][6][3]; /* C */
    double allowed;         /* gaps: the tolerance, and the rounding of what was seen */
} patch;

batten_surface_coons_options batten_surface_coons_defaults(void)
{
    return (batten_surface_coons_options){.size = sizeof(batten_surface_coons_options),
                                          .order = 1,
                                          .tolerance = 1e-6, /* with metres, a micrometre */
                                          .twist = BATTEN_TWIST_GREGORY};
}

/* ---- lines ---- */

/* The edge at which line 2 a + i of direction k is known: u = 0, u = 1; v = 0, v = 1. */
static int edge_of(int k, int i)
{
    static const batten_edge edges[2][2] = {{BATTEN_EDGE_U0, BATTEN_EDGE_U1},
                                            {BATTEN_EDGE_V0, BATTEN_EDGE_V1}};
    return (int)edges[k][i % 2];
}

static const char *edge_name(int edge)
{
    static const char *const names[] = {"v = 0", "u = 1", "v = 1", "u = 0"};
    return names[edge];
}

static const batten_curve *part_of(const batten_ribbon *side, int a)
{
    return a == 0 ? side->curve : a == 1 ? side->slope : side->curvature;
}

/* Clamped, over [0, 1], and towards growing u or v: slopes at the far ends point against it. */
static batten_status take_line(const batten_curve *curve, bool negate, batten_curve **out)
{
    batten_curve *clamped = NULL, *unit = NULL;
    const batten_affine minus = batten_affine_scaling(-1, -1, -1);
    batten_status status = batten_curve_clamp(curve, &clamped);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(clamped, 0, 1, &unit);
    if (status == BATTEN_OK && negate)
        status = batten_curve_transform(unit, &minus, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(unit);
    batten_curve_unref(unit);
    batten_curve_unref(clamped);
    return status;
}

static batten_status take_lines(patch *p)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++)
        for (int i = 0; status == BATTEN_OK && i < 2 * p->order; i++) {
            const batten_curve *curve = part_of(&p->sides[edge_of(k, i)], i / 2);
            if (curve && curve->dimension != p->dimension)
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "edge %s has %d dimension%s, another side %d",
                                edge_name(edge_of(k, i)), curve->dimension,
                                bat_plural(curve->dimension), p->dimension);
            if (curve)
                status = take_line(curve, i == 3, &p->coons.line[k][i]);
        }
    return status;
}

static batten_status take_blends(patch *p)
{
    const batten_surface_coons_options *o = p->options;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const batten_blending family = k ? o->blending_v : o->blending_u;
        const batten_curve *const *given = k ? o->given_v : o->given_u;
        if (family != BATTEN_BLENDING_GIVEN) {
            status = batten_blending_functions(family, p->order, p->coons.blend[k]);
            continue;
        }
        if (!given)
            return bat_fail(BATTEN_BAD_ARGUMENT, "the blending functions in %c are missing",
                            k ? 'v' : 'u');
        status = batten_blending_check(p->order, given, p->order - 1);
        for (int i = 0; status == BATTEN_OK && i < 2 * p->order; i++)
            p->coons.blend[k][i] = batten_curve_ref(given[i]);
    }
    return status;
}

/* ---- corners ---- */

/* seen[k][i][j] for all j: derivatives of line i at both its ends. */
static batten_status look_along(patch *p, int k, int i)
{
    const batten_curve *line = p->coons.line[k][i];
    const int d = p->dimension;
    for (int end = 0; end < 2; end++) {
        double values[3 * 3];
        const batten_status status = batten_curve_evaluate_side(
            line, end, end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, p->order - 1, values);
        if (status != BATTEN_OK)
            return status;
        for (int b = 0; b < p->order; b++) {
            const int j = 2 * b + end;
            memcpy(k ? p->seen[1][j][i] : p->seen[0][i][j], values + b * d,
                   (size_t)d * sizeof *values);
        }
    }
    return BATTEN_OK;
}

/* Corners count from 1, around the patch from (0, 0) along the first side. */
static int corner_number(int i, int j)
{
    static const int numbers[2][2] = {{1, 4}, {2, 3}};
    return numbers[i % 2][j % 2];
}

/* The twist of the bilinear patch of the boundary at corner (i, j), the default. */
static void default_twist(const patch *p, int i, int j, double *out)
{
    const int d = p->dimension;
    if (p->options->twists) {
        memcpy(out, p->options->twists + (corner_number(i, j) - 1) * d,
               (size_t)d * sizeof *out);
        return;
    }
    for (int x = 0; x < d; x++)
        out[x] =
            p->seen[0][1][2 + j][x] - p->seen[0][0][2 + j][x] + p->seen[1][2 + i][1][x] -
            p->seen[1][2 + i][0][x] -
            (p->corner[1][1][x] - p->corner[1][0][x] - p->corner[0][1][x] + p->corner[0][0][x]);
}

static void widen(double gap, double *widest, int *where, int i, int j)
{
    if (gap > *widest) {
        *widest = gap;
        if (where)
            *where = corner_number(i, j);
    }
}

static batten_status refuse(const patch *p, const char *what, int i, int j, double gap)
{
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "corner %d, between edges %s and %s: %s differ by %g, more than %g",
                    corner_number(i, j), edge_name(edge_of(1, j)), edge_name(edge_of(0, i)),
                    what, gap, p->allowed);
}

static void choose_twists(int d, const double *a, const double *b, double share, double *out)
{
    for (int x = 0; x < d; x++)
        out[x] = a[x] + share * (b[x] - a[x]);
}

/* Twists that differ, by the policy of the caller. */
static batten_status choose_twist(patch *p, int i, int j, double gap)
{
    const double *a = p->seen[0][i][j], *b = p->seen[1][i][j];
    const bool differ = gap > p->allowed;
    batten_twist_policy policy = p->options->twist;
    if (differ && policy == BATTEN_TWIST_GREGORY && p->order > 2)
        policy = BATTEN_TWIST_REFUSE;
    if (differ && policy == BATTEN_TWIST_REFUSE)
        return refuse(p, "the twists", i, j, gap);
    const double share = policy == BATTEN_TWIST_KEEP_U   ? 1
                         : policy == BATTEN_TWIST_KEEP_V ? 0
                                                         : 0.5;
    choose_twists(p->dimension, a, b, share, p->corner[i][j]);
    if (differ && policy == BATTEN_TWIST_GREGORY) {
        p->coons.gregory = true;
        for (int x = 0; x < p->dimension; x++)
            p->coons.turn[i % 2][j % 2][x] = (a[x] - b[x]) / 2;
    }
    return BATTEN_OK;
}

/* By how much the boundary curve at a corner leaves the tangent plane of the side whose slope
 * does not fit it; one of i, j is below 2. */
static double off_plane(const patch *p, int i, int j)
{
    const double *a = p->seen[0][i][j], *b = p->seen[1][i][j];
    if (p->dimension != 3)
        return 0;
    if (i < 2) /* a is the curve u = i, b the slope across v = j % 2 */
        return bat_coons_off_plane(a, b, p->seen[1][2 + i][j % 2]);
    return bat_coons_off_plane(b, a, p->seen[0][i % 2][2 + j]);
}

/* A slope that differs from the boundary curve: by vectors per unit of the parameter. */
static batten_status refuse_slope(const patch *p, int i, int j, double gap, double angle)
{
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "corner %d, between edges %s and %s: slope and boundary curve differ by %g "
                    "per unit of the parameter, more than %g; the curve leaves the tangent "
                    "plane at %.3g degree%s",
                    corner_number(i, j), edge_name(edge_of(1, j)), edge_name(edge_of(0, i)),
                    gap, p->allowed, angle * 180 / BAT_PI,
                    bat_plural_real(angle * 180 / BAT_PI, 3));
}

/* Both sides know something of the corner. */
static batten_status settle_corner(patch *p, int i, int j)
{
    const double *a = p->seen[0][i][j], *b = p->seen[1][i][j];
    const double gap = bat_distance(p->dimension, a, b);
    const bool differ = !(gap <= p->allowed);
    batten_surface_coons_report *r = &p->report;
    if (i < 2 && j < 2) {
        widen(gap, &r->corner_gap, &r->corner, i, j);
        choose_twists(p->dimension, a, b, 0.5, p->corner[i][j]);
        return differ ? refuse(p, "the boundary curves", i, j, gap) : BATTEN_OK;
    }
    if (i < 2 || j < 2) {
        /* The boundary curve is right, the slope or curvature gives way. */
        const bool slope = i < 4 && j < 4;
        const double angle = slope ? off_plane(p, i, j) : 0;
        if (slope && gap > r->slope_gap)
            r->slope_angle = angle;
        widen(gap, slope ? &r->slope_gap : &r->higher_gap, slope ? &r->slope_corner : NULL, i,
              j);
        choose_twists(p->dimension, a, b, i < 2 ? 1 : 0, p->corner[i][j]);
        if (!differ || p->options->repair)
            return BATTEN_OK;
        return slope ? refuse_slope(p, i, j, gap, angle)
                     : refuse(p, "curvature and boundary curve", i, j, gap);
    }
    if (i < 4 && j < 4) {
        widen(gap, &r->twist_gap, &r->twist_corner, i, j);
        return choose_twist(p, i, j, gap);
    }
    widen(gap, &r->higher_gap, NULL, i, j);
    choose_twists(p->dimension, a, b, 0.5, p->corner[i][j]);
    return BATTEN_OK;
}

/* Derivatives at the corners are differences of control points: some hundred roundings. */
static void allow_for_rounding(patch *p)
{
    double largest = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2 * p->order; i++)
            for (int j = 0; j < 2 * p->order; j++)
                largest = bat_max(largest, bat_largest(p->dimension, p->seen[k][i][j]));
    p->allowed = p->options->tolerance + 256 * DBL_EPSILON * largest;
}

static batten_status settle_corners(patch *p)
{
    batten_status status = BATTEN_OK;
    const int n = 2 * p->order, d = p->dimension;
    allow_for_rounding(p);
    for (int i = 0; i < n; i++)
        for (int j = 0; status == BATTEN_OK && j < n; j++) {
            const bool by_u = p->coons.line[0][i], by_v = p->coons.line[1][j];
            if (by_u && by_v)
                status = settle_corner(p, i, j);
            else if (by_u || by_v)
                memcpy(p->corner[i][j], p->seen[by_u ? 0 : 1][i][j],
                       (size_t)d * sizeof(double));
            else if (i >= 2 && i < 4 && j >= 2 && j < 4)
                default_twist(p, i % 2, j % 2, p->corner[i][j]);
        }
    return status;
}

/* K = -C, and + C for each line that is made of its corners. */
static void fill_corners(patch *p)
{
    const int n = 2 * p->order, d = p->dimension;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const int made = !p->coons.line[0][i] + !p->coons.line[1][j];
            for (int x = 0; x < d; x++)
                p->coons.corner[(i * n + j) * d + x] = (made - 1) * p->corner[i][j][x];
        }
}

/* ---- what is missed ---- */

/* The largest of sum over lines of the other direction of their blends times (seen - C). */
static batten_status measure_line(patch *p, int k, int line)
{
    const int n = 2 * p->order, d = p->dimension;
    double *worst = &p->report.missed[edge_of(k, line)][line / 2];
    for (int s = 0; s <= SAMPLES; s++) {
        double sum[3] = {0};
        for (int other = 0; other < n; other++) {
            const int i = k ? other : line, j = k ? line : other;
            const bool twist = i >= 2 && i < 4 && j >= 2 && j < 4;
            double blend;
            if (!p->coons.line[1 - k][other] || (twist && p->coons.gregory))
                continue;
            const batten_status status = batten_curve_evaluate(p->coons.blend[1 - k][other],
                                                               (double)s / SAMPLES, 0, &blend);
            if (status != BATTEN_OK)
                return status;
            for (int x = 0; x < d; x++)
                sum[x] += blend * (p->seen[1 - k][i][j][x] - p->corner[i][j][x]);
        }
        *worst = bat_max(*worst, bat_norm(d, sum));
    }
    return BATTEN_OK;
}

static batten_status measure_sides(patch *p)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++)
        for (int i = 0; status == BATTEN_OK && i < 2 * p->order; i++)
            if (p->coons.line[k][i])
                status = measure_line(p, k, i);
    return status;
}

/* ---- all ---- */

static batten_status check_options(const batten_ribbon *sides,
                                   const batten_surface_coons_options *o)
{
    if (o->order < 1 || o->order > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order of a patch is %d, not 1 to 3",
                        o->order);
    if (!(o->tolerance >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, below 0", o->tolerance);
    for (int e = 0; e < 4; e++)
        if (!sides[e].curve)
            return bat_fail(BATTEN_BAD_ARGUMENT, "the patch has no curve at %s", edge_name(e));
    const size_t count = 4 * (size_t)sides[0].curve->dimension;
    if (o->twists && bat_first_not_finite(o->twists, count) < count)
        return bat_fail(BATTEN_NOT_FINITE, "a twist is not finite");
    return BATTEN_OK;
}

static batten_status build_patch(patch *p, batten_surface **out)
{
    batten_status status = bat_coons_begin(p->dimension, 2 * p->order, 2 * p->order, &p->coons);
    if (status == BATTEN_OK)
        status = take_blends(p);
    if (status == BATTEN_OK)
        status = take_lines(p);
    for (int k = 0; k < 2; k++)
        for (int i = 0; status == BATTEN_OK && i < 2 * p->order; i++)
            if (p->coons.line[k][i])
                status = look_along(p, k, i);
    if (status == BATTEN_OK)
        status = settle_corners(p);
    if (status == BATTEN_OK)
        status = measure_sides(p);
    if (status != BATTEN_OK)
        return status;
    fill_corners(p);
    return bat_coons_surface(&p->coons, &p->report.exact, out);
}

batten_status batten_surface_coons(const batten_ribbon sides[4],
                                   const batten_surface_coons_options *options,
                                   batten_surface_coons_report *report, batten_surface **out)
{
    assert(sides && out);
    batten_surface_coons_options chosen = batten_surface_coons_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_coons_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_coons_options *o = &chosen;
    status = check_options(sides, o);
    if (status != BATTEN_OK)
        return status;
    patch *p = bat_array(1, sizeof *p);
    if (!p)
        return BATTEN_OUT_OF_MEMORY;
    p->options = o;
    p->sides = sides;
    p->dimension = sides[0].curve->dimension;
    p->order = o->order;
    batten_surface *made = NULL;
    status = build_patch(p, &made);
    if (status == BATTEN_OK && o->order > 1)
        status = bat_coons_angles(sides, made, p->report.angle);
    if (report && (status == BATTEN_OK || status == BATTEN_NOT_COMPATIBLE))
        *report = p->report;
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_surface_unref(made);
    bat_coons_clear(&p->coons);
    bat_release(p);
    return status;
}
