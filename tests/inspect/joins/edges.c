/* Edges that meet along a part, at corners, at poles and around seams, and ends of curves: joins that are known. */
#include "support/test.h"

#include <batten/continuity.h>
#include <batten/standard.h>

enum { MOST = 8 };

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
    static const double wide[4] = {0, 0, 1e6, 1e6}, narrow[4] = {0, 0, 1e-6, 1e-6};
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

/* ---- ends of curves ---- */

static batten_curve *line(double x0, double y0, double x1, double y1)
{
    const double a[2] = {x0, y0}, b[2] = {x1, y1};
    batten_curve *out = NULL;
    CHECK_OK(batten_curve_line(2, a, b, &out));
    return out;
}

TEST(a_line_and_an_arc_join_with_a_jump_of_curvature)
{
    batten_curve *curves[2] = {line(2, -3, 2, -0.005), NULL};
    batten_curve_continuity_options bounds = batten_curve_continuity_defaults();
    batten_joins joins = {0, NULL, false};
    bounds.gap = 0.01;
    CHECK_OK(batten_curve_arc(2, 1, &curves[1]));
    CHECK_OK(
        batten_curves_joins(2, (const batten_curve *const *)curves, &bounds, NULL, &joins));
    CHECK_INT(joins.count, 1);
    const batten_join *j = &joins.at[0];
    check_join(j, 0, 1, 1, 0, -1);
    CHECK_INT(j->edge, -1);
    CHECK_NEAR(j->gap.value, 0.005, 1e-15);
    CHECK_NEAR(j->angle.value, 0, 1e-15);
    CHECK_NEAR(j->curvature.value, 1, 1e-14);
    CHECK_NEAR(j->curvature_difference, 0.5, 1e-14);
    CHECK_NEAR(j->rate_difference, 0, 1e-13);
    CHECK_INT(j->geometric, 1);
    CHECK_INT(j->parametric, 0);
    const batten_join_worst worst[4] = {j->gap, j->angle, j->curvature, j->rate};
    for (int k = 0; k < 4; k++)
        CHECK(worst[k].at.x == 2 && worst[k].at.y == -0.005 && worst[k].at.z == 0);
    batten_joins_release(&joins);
    bounds.gap = 0.0049;
    CHECK_OK(
        batten_curves_joins(2, (const batten_curve *const *)curves, &bounds, NULL, &joins));
    CHECK_INT(joins.count, 0);
    for (int i = 0; i < 2; i++)
        batten_curve_unref(curves[i]);
}

TEST(the_gap_allowed_is_a_millionth_of_the_size_of_all)
{
    for (int more = 0; more < 2; more++) {
        const double off = (more ? 1.001e-6 : 0.999e-6) * 5;
        batten_curve *curves[3] = {line(0, 0, 1, 0), line(1 + off, 0, 3, 0), line(0, 1, 1, 4)};
        batten_joins joins = {0, NULL, false};
        CHECK_OK(
            batten_curves_joins(3, (const batten_curve *const *)curves, NULL, NULL, &joins));
        CHECK_INT(joins.count, !more);
        batten_joins_release(&joins);
        for (int i = 0; i < 3; i++)
            batten_curve_unref(curves[i]);
    }
}

TEST(curves_of_two_dimensions_do_not_join)
{
    const double a[3] = {1, 0, 0}, b[3] = {2, 0, 0};
    batten_curve *curves[2] = {line(0, 0, 1, 0), NULL};
    batten_joins joins = {3, NULL, true};
    CHECK_OK(batten_curve_line(3, a, b, &curves[1]));
    CHECK_STATUS(
        batten_curves_joins(2, (const batten_curve *const *)curves, NULL, NULL, &joins),
        BATTEN_NOT_COMPATIBLE);
    CHECK(joins.count == 3 && joins.left_out);
    for (int i = 0; i < 2; i++)
        batten_curve_unref(curves[i]);
}

/* Stars: n lines from one point are n (n - 1) / 2 joins; 141, 16 and 5 of them make ten thousand. */
TEST(ten_thousand_joins_are_listed_and_one_more_is_left_out)
{
    static const int stars[] = {141, 16, 5, 2};
    static batten_curve *curves[164];
    for (int more = 0; more < 2; more++) {
        batten_joins joins = {0, NULL, false};
        int count = 0;
        for (int s = 0; s < 3 + more; s++)
            for (int i = 0; i < stars[s]; i++)
                curves[count++] = line(10 * s, 0, 10 * s + cos(i / 25.), sin(i / 25.));
        CHECK_OK(batten_curves_joins(count, (const batten_curve *const *)curves, NULL, NULL,
                                     &joins));
        CHECK_INT(joins.count, 10000);
        CHECK_INT(joins.left_out, more);
        for (int i = 1; i < joins.count; i++) {
            const batten_join *a = &joins.at[i - 1], *b = &joins.at[i];
            CHECK(a->shape[0] < b->shape[0] ||
                  (a->shape[0] == b->shape[0] && a->shape[1] < b->shape[1]));
        }
        batten_joins_release(&joins);
        CHECK(joins.count == 0 && !joins.left_out);
        for (int i = 0; i < count; i++)
            batten_curve_unref(curves[i]);
    }
}

/* ---- who asks is told ---- */

typedef struct {
    int calls, most;
    double last;
} asked;

static void note_progress(void *user, double fraction, const char *what)
{
    asked *a = user;
    CHECK_CONTAINS(what, "joins");
    CHECK(fraction >= a->last && fraction <= 1);
    a->last = fraction;
}

static bool is_cancelled(void *user)
{
    asked *a = user;
    return ++a->calls > a->most;
}

TEST(a_search_for_joins_can_be_watched_and_cancelled)
{
    batten_surface *tiles[MOST];
    for (int i = 0; i < MOST; i++)
        tiles[i] = plane(i, i + 1, 0, 1);
    batten_job job = BATTEN_JOB;
    asked a = {0, 1 << 30, 0};
    job.progress = note_progress;
    job.is_cancelled = is_cancelled;
    job.user = &a;
    batten_joins joins = {5, NULL, true};
    for (a.most = 0; a.most < 3; a.most++) {
        a.calls = 0;
        a.last = 0;
        const batten_status status = batten_surfaces_joins(
            MOST, (const batten_surface *const *)tiles, NULL, &job, &joins);
        if (!test_memory_failed(status, BATTEN_CANCELLED))
            CHECK_STATUS(status, BATTEN_CANCELLED);
        CHECK(joins.count == 5 && joins.left_out);
    }
    for (int i = 0; i < MOST; i++)
        batten_surface_unref(tiles[i]);
}
