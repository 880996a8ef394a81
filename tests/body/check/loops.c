/* Loops that cross and touch, near and at a distance, and what a crossing leaves in doubt. */
#include "body/by_hand.h"
#include "body/check/parts.h"
#include "body/check/sheet.h"
#include "support/test.h"

#include <batten/body.h>
#include <batten/standard.h>

static int crossing_loops(const batten_body *body)
{
    batten_body_faults faults = {.gaps = -1};
    CHECK_OK(batten_body_check(body, 1e-6, NULL, NULL, &faults));
    return faults.crossing_loops;
}

/* Two triangles whose corners are this far apart. Corners are one place within 1e-7 of the box of all, which has
 * sides of 4. */
static int touching(double x, double y, double dx, double dy)
{
    static const int three[] = {3, 3};
    const double corners[6][2] = {
        {x, y},           {x - 0.5, y - 0.1},           {x - 0.1, y - 0.5},
        {x + dx, y + dy}, {x + dx + 0.5, y + dy + 0.1}, {x + dx + 0.1, y + dy + 0.5}};
    batten_body *body = sheet_with_loops(6, corners, three, 2);
    const int count = crossing_loops(body);
    batten_body_unref(body);
    return count;
}

TEST(corners_within_the_limit_touch_wherever_they_lie)
{
    test_random random = test_random_begin("corners");
    for (int i = 0; i < test_cases(40); i++) {
        const double x = test_random_in(&random, 1, 3), y = test_random_in(&random, 1, 3);
        const double angle = test_random_in(&random, -0.7, 2.2), c = cos(angle), s = sin(angle);
        CHECK_INT(touching(x, y, 3.6e-7 * c, 3.6e-7 * s), 2);
        CHECK_INT(touching(x, y, 4.4e-7 * c, 4.4e-7 * s), 0);
    }
}

/* ---- what a crossing leaves open ---- */

static double doubt_of(hand *m)
{
    batten_body *body = NULL, *traced = NULL;
    double area = -1;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, NULL, &traced));
    CHECK_OK(bat_loops_doubt(batten_body_view(traced), 0, &area));
    batten_body_unref(traced);
    batten_body_unref(body);
    return area;
}

/* A polygon on a plate, its sides one after the other. */
static hand polygon(int count, const double (*corners)[2])
{
    hand m = hand_begin();
    int edges[8];
    for (int i = 0; i < count; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % count];
        edges[i] = 1 + hand_line(&m, a[0], a[1], 0, b[0], b[1], 0);
    }
    hand_plate(&m, -9, -9, 9, 9, 0);
    hand_loop(&m, count, edges);
    return m;
}

/* The circle about as long as the loop that is cut off: its area is length^2 / (4 pi); four times that is taken. */
TEST(a_crossing_leaves_the_shorter_part_of_its_loop_in_doubt)
{
    static const double bow[][2] = {{0, 0}, {4, 4}, {4, 0}, {0, 2}};
    /* Sides 0 and 2 cross at (4/3, 4/3). */
    const double whole = sqrt(32) + 4 + sqrt(20) + 2;
    const double part = 8.0 / 3 * sqrt(2) + 4 + sqrt(64.0 / 9 + 16.0 / 9);
    const double shorter = fmin(part, whole - part);
    for (int first = 0; first < 4; first++) {
        double turned[4][2];
        for (int i = 0; i < 4; i++)
            memcpy(turned[i], bow[(i + first) % 4], sizeof turned[i]);
        hand m = polygon(4, (const double(*)[2])turned);
        CHECK_NEAR(doubt_of(&m), shorter * shorter / acos(-1), 1e-5);
    }
}

TEST(loops_that_do_not_cross_leave_nothing_in_doubt)
{
    static const double square[][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    hand m = polygon(4, square);
    hand_arc(&m, 0.5, 0, 30, 360);
    CHECK_NEAR(doubt_of(&m), 0, 0);
}

/* Two crossings, each with the whole of the shorter loop: the circle, whose length is taken by chords. */
TEST(of_two_loops_that_cross_the_shorter_is_in_doubt)
{
    static const double square[][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    hand m = polygon(4, square);
    const double length = 2 * acos(-1) * 0.75;
    const int circle = 1 + hand_arc(&m, 0.75, 0, 30, 360);
    HAND_LOOP(&m, -circle);
    CHECK_NEAR(doubt_of(&m), 2 * length * length / acos(-1),
               0.06 * 2 * length * length / acos(-1));
}

/* Two arcs that end in each other: each follows the other, and both ends are joints. */
TEST(a_lens_of_two_edges_does_not_cross_at_its_ends)
{
    for (int k = 0; k < 2; k++) {
        hand m = hand_begin();
        const double apart = k ? 1 : 0.1; /* of the centres; the circles have radius 2 */
        const double h = sqrt(4 - apart * apart), angle = 2 * atan2(h, apart);
        batten_frame left = hand_world, right = hand_world;
        batten_curve *arcs[2] = {NULL, NULL};
        batten_body *body = NULL;
        left.origin.x = -apart;
        right.origin.x = apart;
        CHECK_OK(batten_curve_arc_in(&left, 2, -angle / 2, angle, &arcs[0]));
        CHECK_OK(batten_curve_arc_in(&right, 2, acos(-1) - angle / 2, angle, &arcs[1]));
        hand_edge(&m, arcs[0]);
        hand_edge(&m, arcs[1]);
        hand_plate(&m, -9, -9, 9, 9, 0);
        HAND_LOOP(&m, 1, 2);
        CHECK_OK(batten_body_create(&m.builder.parts, &body));
        bat_builder_end(&m.builder);
        CHECK_INT(crossing_loops(body), 0);
        batten_body_unref(body);
    }
}
