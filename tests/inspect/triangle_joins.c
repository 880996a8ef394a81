/* How triangles meet: gaps, angles, slopes and tangent planes in closed forms. */
#include "support/test.h"

#include <batten/triangles.h>

/* Two triangles on the edge from the origin to (length, 0, 0): one in the plane z = 0 with its apex at (1, width),
 * the other turned up by an angle, with its apex (2, -other) before the turn. `at`: on which edge of each. */
static batten_triangles *make_fold(const int at[2], bool same_way, double angle, double shift,
                                   double weight)
{
    const double length = 3, width = 2, other = 1.5;
    const double a[3] = {0, 0, 0}, b[3] = {length, 0, 0}, apex[3] = {1, width, 0};
    const double c[3] = {0, shift, 0}, d[3] = {length, shift, 0};
    const double low[3] = {2, shift - other * cos(angle), other * sin(angle)};
    double points[2][3][3], weights[6];
    const double *first[3] = {apex, a, b}, *second[3] = {low, d, c};
    if (same_way) {
        second[1] = c;
        second[2] = d;
    }
    for (int i = 0; i < 3; i++) {
        memcpy(points[0][(at[0] + i) % 3], first[i], sizeof a);
        memcpy(points[1][(at[1] + i) % 3], second[i], sizeof a);
    }
    for (int i = 0; i < 6; i++)
        weights[i] = weight;
    batten_triangles *made = NULL;
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, 1, 2, points[0][0], weight == 1 ? NULL : weights, NULL},
        &made));
    return made;
}

static batten_triangle_join only_join(const batten_triangles *triangles, double tolerance)
{
    batten_triangle_joins joins = {0, NULL};
    CHECK_OK(batten_triangles_joins(triangles, tolerance, &joins));
    CHECK_INT(joins.count, 1);
    const batten_triangle_join join = joins.at[0];
    batten_triangle_joins_release(&joins);
    CHECK(joins.count == 0 && joins.at == NULL);
    return join;
}

/* E = (3, 0, 0), D0 = (1, 2, 0), D1 = (2, -1.5 cos, 1.5 sin): det = 9 sin, by the lengths 3, sqrt 5, 2.5. D is taken
 * from where the edge begins in each triangle. */
TEST(a_fold_has_its_angle_and_determinant_whichever_edges_meet)
{
    static const double angles[] = {0, 0.2, 1, 1.5, 2.5};
    for (int i = 0; i < COUNT(angles); i++)
        for (int k = 0; k < 18; k++) {
            const int at[2] = {k % 3, k / 3 % 3};
            const bool same_way = k >= 9;
            batten_triangles *fold = make_fold(at, same_way, angles[i], 0, 1);
            const batten_triangle_join join = only_join(fold, 1e-9);
            const double from_b = sqrt(1 + 2.25);
            CHECK_INT(join.triangle[0], 0);
            CHECK_INT(join.triangle[1], 1);
            CHECK_INT(join.edge[0], at[0]);
            CHECK_INT(join.edge[1], at[1]);
            CHECK_INT(join.same_way, same_way);
            CHECK_NEAR(join.gap, 0, 0);
            CHECK_NEAR(join.slope, -1, 0);
            CHECK_NEAR(join.angle, angles[i], 1e-14);
            CHECK_NEAR(join.coplanarity,
                       9 * sin(angles[i]) / (3 * sqrt(5) * (same_way ? 2.5 : from_b)), 1e-14);
            batten_triangles_unref(fold);
        }
}

TEST(a_higher_degree_and_equal_weights_leave_the_angle)
{
    const int at[2] = {1, 2};
    batten_triangles *fold = make_fold(at, false, 0.7, 0, 1), *higher = NULL,
                     *heavy = make_fold(at, false, 0.7, 0, 0.5);
    const batten_triangle_join plain = only_join(fold, 1e-9);
    CHECK_OK(batten_triangles_elevate(fold, 2, &higher));
    const batten_triangle_join raised = only_join(higher, 1e-9),
                               weighed = only_join(heavy, 1e-9);
    CHECK_NEAR(raised.angle, plain.angle, 1e-13);
    CHECK_NEAR(raised.coplanarity, plain.coplanarity, 1e-13);
    CHECK_NEAR(weighed.angle, plain.angle, 1e-13);
    CHECK_NEAR(weighed.coplanarity, plain.coplanarity, 1e-13);
    batten_triangles_unref(fold);
    batten_triangles_unref(higher);
    batten_triangles_unref(heavy);
}

TEST(a_gap_within_the_tolerance_is_measured_and_a_wider_one_parts_them)
{
    const int at[2] = {0, 0};
    batten_triangles *fold = make_fold(at, false, 0.3, 0.01, 1);
    batten_triangle_joins none = {0, NULL};
    CHECK_NEAR(only_join(fold, 0.0101).gap, 0.01, 1e-15);
    CHECK_OK(batten_triangles_joins(fold, 0.0099, &none));
    CHECK_INT(none.count, 0);
    batten_triangle_joins_release(&none);
    batten_triangles_unref(fold);
}

/* f is linear on each triangle: the second apex is off the first plane by this much. */
TEST(over_a_domain_the_slope_is_how_far_the_second_is_off_the_first)
{
    static const double places[4][2] = {{0, 0}, {2, 0}, {0.5, 1}, {1, -2}};
    static const int corners[2][6] = {{0, 1, 2, 0, 3, 1}, {2, 0, 1, 3, 1, 0}};
    for (int k = 0; k < 2; k++) {
        const batten_triangulation domain = {4, places[0], corners[k]};
        const double off = 0.375;
        double values[6];
        for (int i = 0; i < 6; i++) {
            const double *p = places[corners[k][i]];
            values[i] = 1 + 2 * p[0] - 3 * p[1] + (corners[k][i] == 3 ? off : 0);
        }
        batten_triangles *triangles = NULL;
        CHECK_OK(batten_triangles_create(
            &(batten_triangles_parts){1, 1, 2, values, NULL, &domain}, &triangles));
        const batten_triangle_join join = only_join(triangles, 1e-9);
        CHECK_NEAR(join.slope, off, 1e-14);
        CHECK_NEAR(join.gap, 0, 0);
        CHECK_NEAR(join.angle, -1, 0);
        CHECK_NEAR(join.coplanarity, -1, 0);
        batten_triangles_unref(triangles);
    }
}

/* Three around one edge, and triangles with an edge of no length. */
TEST(three_at_one_edge_are_two_pairs_and_edges_of_no_length_meet_nothing)
{
    const double apexes[3][3] = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}};
    const double a[3] = {0, 0, 0}, b[3] = {2, 0, 0};
    double points[3][3][3], pinched[2][3][3];
    for (int i = 0; i < 3; i++) {
        memcpy(points[i][0], a, sizeof a);
        memcpy(points[i][1], b, sizeof b);
        memcpy(points[i][2], apexes[i], sizeof a);
    }
    for (int i = 0; i < 2; i++) { /* both have an edge at the origin that is a point */
        memcpy(pinched[i][0], a, sizeof a);
        memcpy(pinched[i][1], a, sizeof a);
        memcpy(pinched[i][2], apexes[i], sizeof a);
    }
    batten_triangles *fan = NULL, *pinch = NULL;
    batten_triangle_joins joins = {0, NULL};
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, 1, 3, points[0][0], NULL, NULL}, &fan));
    CHECK_OK(batten_triangles_joins(fan, 1e-9, &joins));
    CHECK_INT(joins.count, 2);
    for (int i = 0; i < joins.count; i++) {
        CHECK_INT(joins.at[i].triangle[0], 0);
        CHECK_INT(joins.at[i].triangle[1], i + 1);
        CHECK(joins.at[i].same_way);
        CHECK_INT(joins.at[i].edge[0], 2);
    }
    batten_triangle_joins_release(&joins);
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, 1, 2, pinched[0][0], NULL, NULL}, &pinch));
    CHECK_OK(batten_triangles_joins(pinch, 1e-9, &joins));
    CHECK_INT(joins.count, 2); /* each with itself, along its two others */
    for (int i = 0; i < joins.count; i++)
        CHECK(joins.at[i].triangle[0] == i && joins.at[i].triangle[1] == i);
    batten_triangle_joins_release(&joins);
    CHECK_STATUS(batten_triangles_joins(fan, 0, &joins), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is 0");
    CHECK_STATUS(batten_triangles_joins(fan, INFINITY, &joins), BATTEN_BAD_ARGUMENT);
    batten_triangles_unref(fan);
    batten_triangles_unref(pinch);
}

TEST(a_fold_anywhere_in_space_has_its_angle_and_determinant)
{
    const int at[2] = {2, 0};
    const batten_affine turn =
        batten_affine_rotation((batten_vec3){1, 2, 3}, (batten_vec3){1, -1, 0.3}, 0.9);
    batten_triangles *fold = make_fold(at, true, 0.7, 0, 1), *turned = NULL;
    CHECK_OK(batten_triangles_transform(fold, &turn, &turned));
    const batten_triangle_join plain = only_join(fold, 1e-9), join = only_join(turned, 1e-9);
    CHECK_NEAR(join.angle, 0.7, 1e-14);
    CHECK_NEAR(join.coplanarity, plain.coplanarity, 1e-13);
    batten_triangles_unref(fold);
    batten_triangles_unref(turned);
}

/* Of degree 2: a control point beside an end of the edge falls into that end, where the plane then has no normal. */
TEST(a_place_without_a_normal_does_not_change_the_angle)
{
    static const double ends[2][3] = {{0, 0, 0}, {3, 0, 0}}, apex[3] = {1, 2, 0};
    const int at[2] = {1, 2};
    for (int end = 0; end < 2; end++) {
        batten_triangles *fold = make_fold(at, false, 0.7, 0, 1), *higher = NULL,
                         *pinched = NULL;
        double points[36];
        int moved = 0;
        CHECK_OK(batten_triangles_elevate(fold, 1, &higher));
        memcpy(points, batten_triangles_points(higher), sizeof points);
        for (int i = 0; i < 6; i++) {
            double *p = points + 3 * i, off = 0;
            for (int c = 0; c < 3; c++)
                off += fabs(p[c] - (ends[end][c] + apex[c]) / 2);
            moved += off < 1e-12;
            if (off < 1e-12)
                memcpy(p, ends[end], sizeof ends[end]);
        }
        CHECK_INT(moved, 1);
        CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 2, 2, points, NULL, NULL},
                                         &pinched));
        CHECK_NEAR(only_join(pinched, 1e-9).angle, 0.7, 1e-13);
        batten_triangles_unref(pinched);
        batten_triangles_unref(higher);
        batten_triangles_unref(fold);
    }
}

/* Around triangle 2 lie three others: over its first edge triangle 3, over the second 1, over the third 0. */
TEST(joins_come_in_order_of_triangles_and_edges)
{
    static const double corner[6][3] = {{0, 0, 0}, {2, 0, 0},  {0, 2, 0},
                                        {2, 2, 0}, {2, -2, 0}, {-2, 2, 0}};
    static const int of[4][3] = {{2, 0, 5}, {3, 2, 1}, {0, 1, 2}, {4, 1, 0}};
    double points[4][3][3];
    batten_triangles *made = NULL;
    batten_triangle_joins joins = {0, NULL};
    for (int i = 0; i < 12; i++)
        memcpy(points[i / 3][i % 3], corner[of[i / 3][i % 3]], sizeof corner[0]);
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, 1, 4, points[0][0], NULL, NULL}, &made));
    CHECK_OK(batten_triangles_joins(made, 1e-9, &joins));
    CHECK_INT(joins.count, 3);
    for (int i = 0; i < 3; i++)
        CHECK_INT(joins.at[i].triangle[0] == 2 ? joins.at[i].triangle[1]
                                               : joins.at[i].triangle[0],
                  i == 2 ? 3 : i);
    for (int i = 1; i < 3; i++) {
        const batten_triangle_join *a = &joins.at[i - 1], *b = &joins.at[i];
        CHECK(a->triangle[0] < b->triangle[0] ||
              (a->triangle[0] == b->triangle[0] && a->edge[0] < b->edge[0]));
    }
    batten_triangle_joins_release(&joins);
    /* The middle one first: its edges decide. */
    double turned[4][3][3];
    for (int i = 0; i < 4; i++)
        memcpy(turned[i], points[(i + 2) % 4], sizeof turned[i]);
    batten_triangles *again = NULL;
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){3, 1, 4, turned[0][0], NULL, NULL}, &again));
    CHECK_OK(batten_triangles_joins(again, 1e-9, &joins));
    CHECK_INT(joins.count, 3);
    for (int i = 0; i < 3; i++) {
        CHECK_INT(joins.at[i].triangle[0], 0);
        CHECK_INT(joins.at[i].edge[0], i);
    }
    batten_triangle_joins_release(&joins);
    batten_triangles_unref(again);
    batten_triangles_unref(made);
}
