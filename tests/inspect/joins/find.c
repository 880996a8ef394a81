/* Common edges of models, with their worst gap, angle, jumps and places in closed form, and against a dense search. */
#include "support/test.h"

#include <batten/continuity.h>
#include <batten/curvature.h>
#include <batten/standard.h>
#include <stdlib.h>

/* A height of degree 3 in x and in y: the sum of c[i][j] x^i y^j. */
typedef struct {
    double c[4][4];
} height;

static double height_at(const height *h, double x, double y)
{
    double z = 0;
    for (int i = 3; i >= 0; i--)
        z = z * x + ((h->c[i][3] * y + h->c[i][2]) * y + h->c[i][1]) * y + h->c[i][0];
    return z;
}

/* Where a patch lies; from high to low it runs backwards. */
typedef struct {
    double x[2], y[2];
    bool swapped; /* u runs along y */
} plot;

/* The bicubic Bezier patch of a height: its control points from its values at thirds. */
static batten_surface *graph(const height *h, const plot *p)
{
    static const double inverse[4][4] = {{1, 0, 0, 0},
                                         {-5 / 6., 3, -3 / 2., 1 / 3.},
                                         {1 / 3., -3 / 2., 3, -5 / 6.},
                                         {0, 0, 0, 1}};
    static const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const batten_axis axis = {3, 4, knots, false};
    double points[4][4][3];
    for (int n = 0; n < 16; n++) {
        const int i = n / 4, j = n % 4;
        double *at = p->swapped ? points[j][i] : points[i][j];
        at[0] = p->x[0] + (p->x[1] - p->x[0]) * i / 3;
        at[1] = p->y[0] + (p->y[1] - p->y[0]) * j / 3;
        at[2] = 0;
        for (int k = 0; k < 16; k++)
            at[2] += inverse[i][k / 4] * inverse[j][k % 4] *
                     height_at(h, p->x[0] + (p->x[1] - p->x[0]) * (k / 4) / 3,
                               p->y[0] + (p->y[1] - p->y[0]) * (k % 4) / 3);
    }
    batten_surface *out = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0][0], NULL, &out));
    return out;
}

static batten_join only_join(batten_surface *const pair[2], double gap)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_joins joins = {0, NULL, false};
    bounds.gap = gap;
    CHECK_OK(
        batten_surfaces_joins(2, (const batten_surface *const *)pair, &bounds, NULL, &joins));
    CHECK_INT(joins.count, 1);
    const batten_join join = joins.count ? joins.at[0] : (batten_join){.part = 9};
    batten_joins_release(&joins);
    CHECK(joins.at == NULL && joins.count == 0);
    return join;
}

static void check_worst(batten_join_worst worst, double value, double y, double tolerance)
{
    CHECK_NEAR(worst.value, value, tolerance);
    CHECK_NEAR(worst.at.x, 0, 1e-15);
    CHECK_NEAR(worst.at.y, y, 2e-3);
}

/* For x > 0 the height has m b(y) x^k more, with b = 27/4 y^2 (1 - y), which is greatest, 1, at 2/3. */
static void check_jump(int k, double m, bool back, bool swapped)
{
    height h = {{{0}}};
    if (k >= 2)
        h.c[k][0] = 0.5;
    const plot left = {{-2, 0}, {0, 1}, swapped},
               right = {{back ? 1 : 0, back ? 0 : 1}, {0, 1}, false};
    batten_surface *pair[2];
    pair[0] = graph(&h, &left);
    h.c[k][2] += m * 27 / 4;
    h.c[k][3] -= m * 27 / 4;
    pair[1] = graph(&h, &right);
    const batten_join join = only_join(pair, 1e-3);
    CHECK_INT(join.geometric, k == 0 ? 3 : k - 1);
    CHECK(join.shape[0] == 0 && join.shape[1] == 1);
    CHECK_INT(join.side[0], swapped ? 3 : 1);
    CHECK_INT(join.side[1], back ? 1 : 0);
    CHECK_INT(join.part, -1);
    CHECK_INT(join.edge, -1);
    CHECK_INT(join.parametric, -1);
    if (k == 0)
        check_worst(join.gap, m, 2 / 3., 1e-4 * m);
    else
        CHECK_NEAR(join.gap.value, 0, 1e-14);
    if (k == 1)
        check_worst(join.angle, atan(m), 2 / 3., 1e-6);
    else
        CHECK_NEAR(join.angle.value, 0, 1e-12);
    if (k == 2) {
        check_worst(join.curvature, m / (0.5 + m), 2 / 3., 1e-6);
        CHECK_NEAR(join.curvature_difference, 2 * m, 1e-5 * m);
    }
    if (k == 3) {
        CHECK_NEAR(join.curvature_difference, 0, 1e-11);
        check_worst(join.rate, m / (0.5 + m), 2 / 3., 1e-6);
        CHECK_NEAR(join.rate_difference, 6 * m, 1e-5 * m);
    }
    for (int i = 0; i < 2; i++)
        batten_surface_unref(pair[i]);
}

TEST(the_worst_gap_angle_jump_of_curvature_and_of_its_rate_are_found_with_their_places)
{
    static const double jumps[4] = {5e-4, 0.25, 0.75, 0.75};
    for (int k = 0; k < 4; k++)
        for (int way = 0; way < 4; way++)
            check_jump(k, jumps[k], way % 2, way / 2);
}

TEST(a_cubic_that_is_cut_in_two_joins_in_all_orders)
{
    height h = {{{1, 2, -3, 1}, {0.5, -1, 2, 1}, {-1, 1, 1, -2}, {1, 0.5, 0.25, 1}}};
    const plot left = {{-1, 0}, {1, 0}, true}, right = {{0, 2}, {0, 1}, false};
    batten_surface *pair[2] = {graph(&h, &left), graph(&h, &right)};
    const batten_join join = only_join(pair, 0);
    CHECK_INT(join.geometric, 3);
    CHECK_NEAR(join.rate_difference, 0, 1e-9);
    CHECK_NEAR(join.curvature_difference, 0, 1e-11);
    CHECK_NEAR(join.angle.value, 0, 1e-13);
    for (int i = 0; i < 2; i++)
        batten_surface_unref(pair[i]);
}

/* ---- against a dense search ---- */

static batten_vec3 sum(batten_vec3 a, double factor, batten_vec3 b)
{
    return (batten_vec3){a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

static double product(batten_vec3 a, batten_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* The normal curvature square to an edge x = 0 with the slope `along`, by Euler's formula, times the normal; the
 * direction across, towards larger x. */
static batten_vec3 curvature_across(const batten_surface *surface, double u, double v,
                                    double along, batten_vec3 *across)
{
    batten_surface_local at;
    CHECK_OK(batten_surface_local_at(surface, u, v, &at));
    const double length = sqrt(1 + along * along);
    const batten_vec3 t = {0, 1 / length, along / length}, n = at.normal;
    *across =
        (batten_vec3){t.y * n.z - t.z * n.y, t.z * n.x - t.x * n.z, t.x * n.y - t.y * n.x};
    const double c = product(*across, at.direction1), s = product(*across, at.direction2);
    return sum((batten_vec3){0, 0, 0}, at.kappa1 * c * c + at.kappa2 * s * s, n);
}

static double slope_of(const height *h, double y)
{
    return h->c[0][1] + y * (2 * h->c[0][2] + y * 3 * h->c[0][3]);
}

TEST(angles_and_jumps_of_curvature_are_those_of_a_dense_search)
{
    static const plot left = {{-1, 0}, {0, 1}, false}, right = {{0, 1}, {0, 1}, false};
    enum { PLACES = 4000 };
    test_random random = test_random_begin("dense search of joins");
    for (int trial = 0; trial < test_cases(10); trial++) {
        const int order = 1 + trial % 2; /* a crease, or a jump of curvature */
        height h[2];
        for (int k = 0; k < 16; k++)
            h[0].c[k / 4][k % 4] = h[1].c[k / 4][k % 4] = test_random_in(&random, -1, 1);
        for (int j = 0; j < 4; j++)
            h[1].c[order][j] = test_random_in(&random, -1, 1);
        batten_surface *pair[2] = {graph(&h[0], &left), graph(&h[1], &right)};
        double angle = 0, difference = 0;
        for (int i = 0; i <= PLACES; i++) {
            const double y = (double)i / PLACES;
            batten_vec3 across[2];
            const batten_vec3 a = curvature_across(pair[0], 1, y, slope_of(&h[0], y),
                                                   &across[0]),
                              b = curvature_across(pair[1], 0, y, slope_of(&h[0], y),
                                                   &across[1]);
            const batten_vec3 apart = sum(a, -1, b), turn = sum(across[0], -1, across[1]);
            difference = fmax(difference, sqrt(product(apart, apart)));
            angle = fmax(angle, 2 * asin(sqrt(product(turn, turn)) / 2));
        }
        const batten_join join = only_join(pair, 0);
        if (order == 1)
            CHECK_NEAR(join.angle.value, angle, 1e-5 * angle);
        else
            CHECK_NEAR(join.curvature_difference, difference, 1e-4 * difference);
        CHECK_INT(join.geometric, order - 1);
        for (int i = 0; i < 2; i++)
            batten_surface_unref(pair[i]);
    }
}

/* Nine patches of one cubic in any order and direction: twelve edges are common, whatever the order. */
TEST(every_common_edge_of_a_patchwork_is_found_and_no_other)
{
    static const int order[9] = {4, 0, 8, 2, 6, 1, 3, 7, 5};
    height h = {{{0.1, 2, -3, 1}, {0.5, -1, 2, 1}, {-1, 1, 1, -2}, {1, 0.5, 0.25, 1}}};
    batten_surface *patches[9];
    for (int k = 0; k < 9; k++) {
        const double x = order[k] / 3, y = order[k] % 3;
        plot p = {{x, x + 1}, {y, y + 1}, k % 2};
        if (k % 3 == 1)
            p = (plot){{x + 1, x}, {y + 1, y}, k % 2};
        patches[k] = graph(&h, &p);
    }
    batten_joins joins = {0, NULL, false};
    CHECK_OK(
        batten_surfaces_joins(9, (const batten_surface *const *)patches, NULL, NULL, &joins));
    CHECK_INT(joins.count, 12);
    for (int i = 0; i < joins.count; i++) {
        const int a = order[joins.at[i].shape[0]], b = order[joins.at[i].shape[1]];
        CHECK_INT(abs(a / 3 - b / 3) + abs(a % 3 - b % 3), 1);
        CHECK_INT(joins.at[i].geometric, 3);
    }
    batten_joins_release(&joins);
    for (int k = 0; k < 9; k++)
        batten_surface_unref(patches[k]);
}

TEST(curves_that_meet_are_found_whichever_way_they_run)
{
    static const double points[3][2][2] = {
        {{0, 0}, {1, 0}}, {{1, 1}, {1, 0}}, {{0, 0}, {-1, 0}}};
    batten_curve *curves[3] = {NULL, NULL, NULL};
    batten_joins joins = {0, NULL, false};
    for (int i = 0; i < 3; i++)
        CHECK_OK(batten_curve_polyline((batten_points){2, 2, points[i][0]}, &curves[i]));
    CHECK_OK(batten_curves_joins(3, (const batten_curve *const *)curves, NULL, NULL, &joins));
    CHECK_INT(joins.count, 2);
    CHECK(joins.at[0].shape[0] == 0 && joins.at[0].shape[1] == 1);
    CHECK(joins.at[0].side[0] == 1 && joins.at[0].side[1] == 1);
    CHECK_NEAR(joins.at[0].angle.value, acos(-1) / 2, 1e-15);
    CHECK_INT(joins.at[0].geometric, 0);
    CHECK_NEAR(joins.at[0].angle.at.x, 1, 0);
    CHECK(joins.at[1].shape[0] == 0 && joins.at[1].shape[1] == 2);
    CHECK(joins.at[1].side[0] == 0 && joins.at[1].side[1] == 0);
    CHECK_INT(joins.at[1].geometric, 3);
    batten_joins_release(&joins);
    for (int i = 0; i < 3; i++)
        batten_curve_unref(curves[i]);
}

TEST(ends_apart_by_just_the_gap_meet)
{
    static const double points[2][2][2] = {{{0, 0}, {1, 0}}, {{1.25, 0}, {2, 0}}};
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_curve *curves[2] = {NULL, NULL};
    batten_joins joins = {0, NULL, false};
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_curve_polyline((batten_points){2, 2, points[i][0]}, &curves[i]));
    for (int more = 0; more < 2; more++) {
        bounds.gap = more ? 0.25 : 0.25 * (1 - DBL_EPSILON);
        CHECK_OK(
            batten_curves_joins(2, (const batten_curve *const *)curves, &bounds, NULL, &joins));
        CHECK_INT(joins.count, more);
        if (more) {
            CHECK(joins.at[0].side[0] == 1 && joins.at[0].side[1] == 0);
            CHECK_NEAR(joins.at[0].gap.value, 0.25, 0);
        }
        batten_joins_release(&joins);
    }
    for (int i = 0; i < 2; i++)
        batten_curve_unref(curves[i]);
}

TEST(nothing_joins_nothing_and_bounds_below_zero_are_refused)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_joins joins = {0, NULL, true};
    CHECK_OK(batten_surfaces_joins(0, NULL, NULL, NULL, &joins));
    CHECK(joins.count == 0 && !joins.left_out);
    CHECK_OK(batten_curves_joins(0, NULL, NULL, NULL, &joins));
    CHECK_INT(joins.count, 0);
    batten_joins_release(&joins);
    bounds.angle = -1;
    CHECK_STATUS(batten_surfaces_joins(0, NULL, &bounds, NULL, &joins), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curves_joins(0, NULL, &bounds, NULL, &joins), BATTEN_BAD_ARGUMENT);
}
