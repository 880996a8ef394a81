/* What a crossing of its loops leaves in doubt of the area of a face. */
#include "body/trace/passages.h"
#include "body/by_hand.h"
#include "support/test.h"

#include <batten/body.h>
#include <batten/standard.h>

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

/* A square, a bow that crosses itself beside its middle, and another square or a circle of one edge. */
TEST(only_the_length_of_the_loop_that_crosses_itself_counts)
{
    static const double square[][2] = {{-8, -8}, {8, -8}, {8, 8}, {-8, 8}};
    static const double bow[][2] = {{0, 0}, {4, 4}, {4, 0}, {0, 2}};
    const double shorter = sqrt(32) + 4 + sqrt(20) + 2 - 8.0 / 3 * sqrt(2) - 4 - sqrt(80.0 / 9);
    for (int last = 0; last < 2; last++) {
        hand m = polygon(4, square);
        for (int i = 0; i < 4; i++)
            hand_line(&m, bow[i][0], bow[i][1], 0, bow[(i + 1) % 4][0], bow[(i + 1) % 4][1], 0);
        const int circle = 1 + hand_arc(&m, 0.5, 0, 0, 360);
        batten_curve *aside = NULL;
        const batten_frame frame = {.origin = {-4, -4, 0}, .x = {1, 0, 0}, .z = {0, 0, 1}};
        CHECK_OK(batten_curve_arc_in(&frame, 1, 0, 2 * acos(-1), &aside));
        CHECK_INT(hand_edge(&m, aside), circle);
        if (last)
            HAND_LOOP(&m, -circle - 1);
        HAND_LOOP(&m, 5, 6, 7, 8);
        if (!last)
            HAND_LOOP(&m, -circle - 1);
        CHECK_NEAR(doubt_of(&m), shorter * shorter / acos(-1), 1e-5);
    }
}
