/* Ends of curves that meet, the number of joins that are listed, and searches that are watched. */
#include "support/test.h"

#include <batten/continuity.h>
#include <batten/standard.h>

enum { MOST = 8 };

static void check_ends(const batten_join *join, int a, int side_a, int b, int side_b)
{
    CHECK(join->shape[0] == a && join->shape[1] == b);
    CHECK(join->side[0] == side_a && join->side[1] == side_b);
    CHECK(join->part == -1 && join->edge == -1);
}

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
    check_ends(j, 0, 1, 1, 0);
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
    batten_surface *tiles[MOST] = {NULL};
    for (int i = 0; i < MOST; i++)
        CHECK_OK(batten_surface_bilinear((batten_vec3){i, 0, 0}, (batten_vec3){i + 1, 0, 0},
                                         (batten_vec3){i, 1, 0}, (batten_vec3){i + 1, 1, 0},
                                         &tiles[i]));
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

TEST(a_search_takes_a_step_for_each_end_and_for_edges_another_for_parts)
{
    batten_surface *tile = NULL;
    batten_curve *one = line(0, 0, 1, 0);
    batten_job job = BATTEN_JOB;
    batten_joins joins = {0, NULL, false};
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0},
                                     (batten_vec3){0, 1, 0}, (batten_vec3){1, 1, 0}, &tile));
    for (int curves = 0; curves < 2; curves++)
        for (int less = 0; less < 2; less++) {
            job.work_limit = (curves ? 2 : 8) - (unsigned)less;
            const batten_status status =
                curves ? batten_curves_joins(1, (const batten_curve *const *)&one, NULL, &job,
                                             &joins)
                       : batten_surfaces_joins(1, (const batten_surface *const *)&tile, NULL,
                                               &job, &joins);
            const batten_status due = less ? BATTEN_INCOMPLETE : BATTEN_OK;
            if (!test_memory_failed(status, due))
                CHECK_STATUS(status, due);
            batten_joins_release(&joins);
        }
    batten_curve_unref(one);
    batten_surface_unref(tile);
}
