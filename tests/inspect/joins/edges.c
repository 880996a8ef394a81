/* Edges that meet along a part, at corners, at poles and around seams: joins that are known. */
#include "support/test.h"

#include <batten/continuity.h>
#include <batten/standard.h>

/* A surface of degree 1, or 2 with knots that are double, along u, and 1 along v. */
static batten_surface *strip(int degree, int count, const double *knots, const double *points)
{
    static const double across[4] = {0, 0, 1, 1};
    const batten_axis u = {degree, count, knots, false}, v = {1, 2, across, false};
    batten_surface *out = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &out));
    return out;
}

/* A plane patch over [x0, x1] x [y0, y1], which may run from high to low. */
static batten_surface *plane(double x0, double x1, double y0, double y1)
{
    batten_surface *out = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){x0, y0, 0}, (batten_vec3){x1, y0, 0},
                                     (batten_vec3){x0, y1, 0}, (batten_vec3){x1, y1, 0}, &out));
    return out;
}

static batten_joins joins_of(int count, batten_surface *const *surfaces, double gap)
{
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_joins joins = {0, NULL, false};
    bounds.gap = gap;
    CHECK_OK(batten_surfaces_joins(count, (const batten_surface *const *)surfaces, &bounds,
                                   NULL, &joins));
    return joins;
}

static void release(int count, batten_surface **surfaces, batten_joins *joins)
{
    for (int i = 0; i < count; i++)
        batten_surface_unref(surfaces[i]);
    batten_joins_release(joins);
}

static void check_join(const batten_join *join, int a, int side_a, int b, int side_b, int part)
{
    CHECK(join->shape[0] == a && join->shape[1] == b);
    CHECK(join->side[0] == side_a && join->side[1] == side_b);
    CHECK_INT(join->part, part);
}

/* Three tiles along the long side of one: u low, u high, v low, v high are sides 0 to 3. */
TEST(edges_that_run_along_a_part_of_a_longer_one_are_found_in_any_order_and_direction)
{
    for (int back = 0; back < 2; back++)
        for (int last = 0; last < 2; last++) {
            batten_surface *tiles[4];
            const int first = last ? 0 : 1, wide = last ? 3 : 0;
            tiles[wide] = plane(0, 3, 0, 1);
            for (int i = 0; i < 3; i++)
                tiles[first + i] = back ? plane(i + 1, i, 1, 2) : plane(i, i + 1, 1, 2);
            batten_joins joins = joins_of(4, tiles, 1e-6);
            CHECK_INT(joins.count, 5);
            int between = 0, part = 0;
            for (int i = 0; i < joins.count; i++) {
                const batten_join *j = &joins.at[i];
                CHECK_INT(j->geometric, 3);
                CHECK_NEAR(j->gap.value, 0, 1e-15);
                if (j->part < 0) {
                    check_join(j, first + between, back ? 0 : 1, first + between + 1,
                               back ? 1 : 0, -1);
                    between++;
                } else if (last) {
                    check_join(j, part++, 2, 3, 3, 0);
                } else {
                    check_join(j, 0, 3, 1 + part, 2, 1);
                    part++;
                }
            }
            CHECK(between == 2 && part == 3);
            release(4, tiles, &joins);
        }
}

/* Beyond an end, beside, and above, each by a little less and a little more than the gap allowed. */
TEST(a_part_may_be_off_by_the_gap_and_no_more)
{
    for (int k = 0; k < 5; k++)
        for (int more = 0; more < 2; more++) {
            const double off = more ? 0.011 : 0.009,
                         x = k == 0   ? -off
                             : k == 1 ? 1 + off
                                      : 1,
                         y = k == 2   ? off
                             : k == 3 ? -off
                                      : 0,
                         z = k == 4 ? off : 0;
            const double end = k == 1 ? 3 + off : x + 1;
            const double start = k == 1 ? 2 : x;
            batten_surface *pair[2] = {plane(0, 3, -1, 0), NULL};
            CHECK_OK(batten_surface_bilinear(
                (batten_vec3){start, y, z}, (batten_vec3){end, y, z},
                (batten_vec3){start, 1, z}, (batten_vec3){end, 1, z}, &pair[1]));
            batten_joins joins = joins_of(2, pair, 0.01);
            CHECK_INT(joins.count, !more);
            if (!more) {
                check_join(&joins.at[0], 0, 3, 1, 2, 1);
                CHECK_NEAR(joins.at[0].gap.value, 0.009, 1e-12);
            }
            release(2, pair, &joins);
        }
}

TEST(whole_edges_may_be_off_by_the_gap_and_no_more)
{
    for (int k = 0; k < 4; k++)
        for (int more = 0; more < 2; more++) {
            const double off = more ? 0.011 : 0.009;
            const double x = k == 0   ? off
                             : k == 1 ? -off
                                      : 0,
                         y = k == 2   ? off
                             : k == 3 ? -off
                                      : 0;
            batten_surface *pair[2] = {plane(0, 1, -1, 0), plane(x, 1 + x, y, 1)};
            batten_joins joins = joins_of(2, pair, 0.01);
            CHECK_INT(joins.count, !more);
            if (!more) {
                check_join(&joins.at[0], 0, 3, 1, 2, -1);
                CHECK_NEAR(joins.at[0].gap.value, 0.009, 1e-12);
                CHECK_INT(joins.at[0].geometric, 3);
            }
            release(2, pair, &joins);
        }
}

/* A gap of 1/4 has no rounding: what is allowed is found, as a whole edge alone. */
TEST(an_edge_off_by_just_the_gap_is_found_once_and_as_a_whole)
{
    for (int way = 0; way < 2; way++) {
        const double x = way ? -0.25 : 0.25;
        batten_surface *pair[2] = {plane(0, 4, -1, 0), plane(x, 4 + x, 0, 1)};
        batten_joins joins = joins_of(2, pair, 0.25);
        CHECK_INT(joins.count, 1);
        check_join(&joins.at[0], 0, 3, 1, 2, -1);
        CHECK_NEAR(joins.at[0].gap.value, 0.25, 0);
        release(2, pair, &joins);
    }
}

TEST(an_edge_of_just_eight_gaps_is_no_part_of_another)
{
    batten_surface *pair[2] = {plane(0, 4, -1, 0), plane(1, 3, 0, 1)};
    batten_joins joins = joins_of(2, pair, 0.25);
    CHECK_INT(joins.count, 0);
    release(2, pair, &joins);
}

/* Both lie on z = x y, whose tangent plane turns along x = 0; one shrinks to a point of it, where it has none. */
TEST(where_an_edge_has_no_tangent_plane_that_of_the_place_before_does_not_count)
{
    static const double to_a_point[] = {0, 0, 0, 0,   0.5, 0,   0, 1, 0,
                                        1, 0, 0, 0.5, 0.5, 0.5, 0, 1, 0};
    static const double one[] = {0, 0, 1, 1}, two[] = {0, 0, 0, 1, 1, 1};
    const batten_axis u = {1, 2, one, false}, v = {2, 3, two, false};
    for (int swap = 0; swap < 2; swap++) {
        batten_surface *pair[2] = {NULL, NULL};
        CHECK_OK(batten_surface_create(3, &u, &v, to_a_point, NULL, &pair[swap]));
        CHECK_OK(batten_surface_bilinear((batten_vec3){-1, 0, 0}, (batten_vec3){0, 0, 0},
                                         (batten_vec3){-1, 1, -1}, (batten_vec3){0, 1, 0},
                                         &pair[!swap]));
        batten_joins joins = joins_of(2, pair, 1e-6);
        CHECK_INT(joins.count, 1);
        CHECK_NEAR(joins.at[0].angle.value, 0, 1e-12);
        CHECK_NEAR(joins.at[0].curvature_difference, 0, 1e-9);
        CHECK_INT(joins.at[0].geometric, 3);
        release(2, pair, &joins);
    }
}

TEST(an_edge_shorter_than_eight_gaps_is_no_part_of_another)
{
    for (int longer = 0; longer < 2; longer++) {
        batten_surface *pair[2] = {plane(0, 3, -1, 0), plane(1, longer ? 1.81 : 1.79, 0, 1)};
        batten_joins joins = joins_of(2, pair, 0.1);
        CHECK_INT(joins.count, longer);
        release(2, pair, &joins);
    }
}

TEST(edges_that_meet_at_their_ends_alone_do_not_join)
{
    static const double points[] = {0,  0,   0, -1, 0, 0, -0.5, 0.5, 0.4,
                                    -1, 0.5, 0, 0,  1, 0, -1,   1,   0},
                        knots[] = {0, 0, 0, 1, 1, 1};
    for (int swap = 0; swap < 2; swap++) {
        batten_surface *pair[2];
        pair[swap] = plane(0, 1, 0, 1);
        pair[!swap] = strip(2, 3, knots, points);
        batten_joins joins = joins_of(2, pair, 1e-3);
        CHECK_INT(joins.count, 0);
        release(2, pair, &joins);
    }
}

/* From right to left: the order of the shapes is not that of their places. */
TEST(parts_are_found_when_the_shapes_come_from_right_to_left)
{
    enum { TILES = 12 };
    batten_surface *tiles[TILES + 1];
    tiles[0] = plane(3, 9, 0, 1);
    for (int i = 1; i <= TILES; i++)
        tiles[i] = plane(TILES - i, TILES - i + 1, 1, 2);
    batten_joins joins = joins_of(TILES + 1, tiles, 1e-6);
    CHECK_INT(joins.count, 6 + TILES - 1);
    for (int i = 0; i < 6; i++)
        check_join(&joins.at[i], 0, 3, i + 4, 2, 1);
    for (int i = 1; i < TILES; i++)
        check_join(&joins.at[i + 5], i, 0, i + 1, 1, -1);
    release(TILES + 1, tiles, &joins);
}

/* The last is a strip that bends around: the start of its end lies along its own long side. */
TEST(a_part_may_be_the_same_side_of_another_or_another_side_of_the_same)
{
    static const double points[] = {4,  0, 0, 4, -1, 0, 0, 0, 0, 0, -1,  0, 0, 2, 0,
                                    -1, 2, 0, 3, 2,  0, 3, 3, 0, 3, 0.0, 0, 2, 0, 0};
    static const double knots[] = {0, 0, 1, 2, 3, 4, 4};
    batten_surface *pair[2] = {plane(0, 4, -1, 0), plane(1, 3, 1, 0)};
    batten_joins joins = joins_of(2, pair, 1e-6);
    CHECK_INT(joins.count, 1);
    check_join(&joins.at[0], 0, 3, 1, 3, 1);
    release(2, pair, &joins);
    pair[0] = strip(1, 5, knots, points);
    joins = joins_of(1, pair, 1e-6);
    CHECK_INT(joins.count, 1);
    check_join(&joins.at[0], 0, 1, 0, 2, 0);
    release(1, pair, &joins);
}

/* An L in one plane whose inner edge turns at a knot: at the corner the plate that fills it meets one of both ways on. */
TEST(at_a_corner_that_foot_counts_which_agrees)
{
    static const double points[][18] = {
        {0, 0, 0, 0, 1, 0, 1, 0, 0, 2, 1, 0, 1, -1, 0, 2, -1, 0},
        {1, -1, 0, 2, -1, 0, 1, 0, 0, 2, 1, 0, 0, 0, 0, 0, 1, 0}};
    static const double knots[] = {0, 0, 1, 2, 2};
    for (int way = 0; way < 2; way++) {
        batten_surface *pair[2] = {plane(0, 1, -1, 0), strip(1, 3, knots, points[way])};
        batten_joins joins = joins_of(2, pair, 1e-6);
        CHECK_INT(joins.count, 2);
        check_join(&joins.at[0], 0, 1, 1, 2, 0);
        check_join(&joins.at[1], 0, 3, 1, 2, 0);
        for (int i = 0; i < joins.count; i++) {
            CHECK_NEAR(joins.at[i].angle.value, 0, 1e-12);
            CHECK_INT(joins.at[i].geometric, 3);
        }
        release(2, pair, &joins);
    }
}

/* A strip whose edge runs straight and then bends upwards, z = (x - 1)^2, and goes off askew: its curvature square to
 * the edge jumps at the knot, and the plate beside the straight half meets it without a jump. */
TEST(of_feet_with_one_tangent_plane_that_counts_whose_curvature_agrees)
{
    static const double points[2][30] = {{0, 0, 0, 1,   1, 0, 0.5, 0, 0, 1.5, 1, 0, 1, 0, 0,
                                          2, 1, 0, 1.5, 0, 0, 2.5, 1, 0, 2,   0, 1, 3, 1, 1},
                                         {2, 0, 1, 3,   1, 1, 1.5, 0, 0, 2.5, 1, 0, 1, 0, 0,
                                          2, 1, 0, 0.5, 0, 0, 1.5, 1, 0, 0,   0, 0, 1, 1, 0}};
    static const double knots[] = {0, 0, 0, 1, 1, 2, 2, 2};
    for (int way = 0; way < 2; way++) {
        batten_surface *pair[2] = {plane(0, 1, -1, 0), strip(2, 5, knots, points[way])};
        batten_joins joins = joins_of(2, pair, 1e-6);
        CHECK_INT(joins.count, 1);
        check_join(&joins.at[0], 0, 3, 1, 2, 0);
        CHECK_NEAR(joins.at[0].curvature_difference, 0, 1e-9);
        CHECK_INT(joins.at[0].geometric, 3);
        release(2, pair, &joins);
    }
}

TEST(an_edge_that_ends_in_a_pole_is_smooth_up_to_it)
{
    for (int swap = 0; swap < 2; swap++) {
        batten_surface *pair[2] = {NULL, NULL};
        pair[!swap] = plane(-1, 0, 0, 1);
        CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0},
                                         (batten_vec3){0, 1, 0}, (batten_vec3){0, 1, 0},
                                         &pair[swap]));
        batten_joins joins = joins_of(2, pair, 1e-6);
        CHECK_INT(joins.count, 1);
        check_join(&joins.at[0], 0, swap ? 1 : 0, 1, swap ? 0 : 1, -1);
        CHECK_INT(joins.at[0].geometric, 3);
        release(2, pair, &joins);
    }
}

TEST(the_seam_of_a_sphere_joins_and_its_poles_do_not)
{
    const batten_frame world = batten_frame_world();
    batten_surface *ball = NULL;
    CHECK_OK(batten_surface_sphere(&world, 2, &ball));
    batten_joins joins = joins_of(1, &ball, 0);
    CHECK_INT(joins.count, 1);
    check_join(&joins.at[0], 0, 0, 0, 1, -1);
    CHECK_INT(joins.at[0].geometric, 3);
    CHECK_NEAR(joins.at[0].curvature_difference, 0, 1e-12);
    release(1, &ball, &joins);
}

/* Whole circles are one edge; turned, each runs along a part of the other. */
TEST(rims_of_tubes_join_wherever_their_seams_are)
{
    for (int turned = 0; turned < 2; turned++) {
        const batten_frame low = batten_frame_world();
        batten_frame high = low;
        batten_surface *pair[2] = {NULL, NULL};
        high.origin.z = 2;
        if (turned)
            high.x = (batten_vec3){0, 1, 0};
        CHECK_OK(batten_surface_cylinder(&low, 1, 2, &pair[0]));
        CHECK_OK(batten_surface_cylinder(&high, 1, 3, &pair[1]));
        batten_joins joins = joins_of(2, pair, 1e-9);
        CHECK_INT(joins.count, 3 + turned);
        check_join(&joins.at[0], 0, 0, 0, 1, -1);
        check_join(&joins.at[1], 0, 3, 1, 2, turned ? 0 : -1);
        if (turned)
            check_join(&joins.at[2], 0, 3, 1, 2, 1);
        check_join(&joins.at[2 + turned], 1, 0, 1, 1, -1);
        for (int i = 0; i < joins.count; i++)
            CHECK_INT(joins.at[i].geometric, 3);
        release(2, pair, &joins);
    }
}

/* Parameters that run very unevenly make no pole. */
TEST(wide_and_narrow_domains_change_no_join)
{
    static const double wide[4] = {-5e5, -5e5, 5e5, 5e5},
                        narrow[4] = {-5e-7, -5e-7, 5e-7, 5e-7};
    static const double left[12] = {-1, 0, 0, -1, 1, 0, 0, 0, 0, 0, 1, 0},
                        right[12] = {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1};
    const batten_axis u = {1, 2, wide, false}, v = {1, 2, narrow, false};
    for (int swap = 0; swap < 2; swap++) {
        batten_surface *pair[2] = {NULL, NULL};
        CHECK_OK(
            batten_surface_create(3, swap ? &v : &u, swap ? &u : &v, left, NULL, &pair[0]));
        CHECK_OK(
            batten_surface_create(3, swap ? &u : &v, swap ? &v : &u, right, NULL, &pair[1]));
        batten_joins joins = joins_of(2, pair, 1e-6);
        CHECK_INT(joins.count, 1);
        CHECK_NEAR(joins.at[0].angle.value, acos(-1) / 4, 1e-12);
        CHECK_INT(joins.at[0].geometric, 0);
        release(2, pair, &joins);
    }
}

/* Where both are all but straight, a difference is measured by the gap over the square of the size of the larger. */
TEST(a_bulge_below_the_gap_counts_as_straight)
{
    static const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const double gap = 0.01, c = 1e-5;
    double points[8][3];
    const double x[4] = {0, 1 / 3., 2 / 3., 1}, square[4] = {0, 0, 1 / 3., 1};
    for (int i = 0; i < 8; i++) {
        points[i][0] = x[i / 2];
        points[i][1] = i % 2 ? 3 : 0;
        points[i][2] = c * square[i / 2];
    }
    for (int swap = 0; swap < 2; swap++) {
        batten_surface *pair[2];
        pair[swap] = strip(3, 4, knots, points[0]);
        pair[!swap] = plane(-4, 0, 0, 3);
        batten_joins joins = joins_of(2, pair, gap);
        CHECK_INT(joins.count, 1);
        CHECK_NEAR(joins.at[0].curvature_difference, 2 * c, 1e-12);
        CHECK_NEAR(joins.at[0].curvature.value, 2 * c * 25 / gap, 1e-8);
        release(2, pair, &joins);
    }
}
