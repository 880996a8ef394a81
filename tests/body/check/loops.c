/* Loops that cross and touch, near and at a distance. */
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

/* Corners of two triangles at one place, in any cell of the four grids: told once, with its edges. The square has the
 * edges 1 to 4. */
TEST(a_touch_is_told_once_with_its_edges_loops_and_place)
{
    static const int three[] = {3, 3};
    static const double places[][2] = {{2, 2}, {1.3, 2.7}, {1.0000001, 3.0000003}};
    for (int i = 0; i < COUNT(places); i++) {
        const double x = places[i][0], y = places[i][1];
        const double corners[6][2] = {{x, y}, {x - 0.5, y - 0.1}, {x - 0.1, y - 0.5},
                                      {x, y}, {x + 0.5, y + 0.1}, {x + 0.1, y + 0.5}};
        batten_body *body = sheet_with_loops(6, corners, three, 2);
        batten_notes *notes = NULL;
        batten_body_faults faults;
        char words[120];
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_body_check(body, 1e-6, NULL, notes, &faults));
        CHECK_INT(faults.crossing_loops, 2);
        snprintf(words, sizeof words,
                 "edges 5 and 8 of its loops 2 and 3 touch at (u, v) = (%.9g, %.9g)", x, y);
        int touches = 0;
        for (int k = 0; k < batten_notes_count(notes); k++)
            touches += strstr(batten_notes_at(notes, k)->text, words) != NULL;
        if (batten_notes_dropped(notes) == 0)
            CHECK_INT(touches, 1);
        batten_notes_free(notes);
        batten_body_unref(body);
    }
}

/* Of two plates one has its circle far above it. */
TEST(a_face_whose_loops_do_not_close_is_named)
{
    for (int bad = 0; bad < 2; bad++) {
        hand m = hand_begin();
        batten_body *body = NULL;
        batten_notes *notes = NULL;
        batten_body_faults faults;
        int named = 0;
        for (int k = 0; k < 2; k++) {
            hand_arc(&m, 1, 3 * k, 0, 360);
            hand_plate(&m, -2, -2, 2, 2, k == bad ? 3 * k + 1 : 3 * k);
            hand_loop(&m, 1, (const int[]){k + 1});
        }
        CHECK_OK(batten_body_create(&m.builder.parts, &body));
        bat_builder_end(&m.builder);
        CHECK_OK(batten_notes_create(20, &notes));
        CHECK_OK(batten_body_check(body, 1e-6, NULL, notes, &faults));
        for (int i = 0; i < batten_notes_count(notes); i++) {
            const batten_note *note = batten_notes_at(notes, i);
            if (!strstr(note->text, "its loops cannot be closed in the parameters"))
                continue;
            named++;
            CHECK_TEXT(note->entity, bad ? "face 2" : "face 1");
        }
        if (batten_notes_dropped(notes) == 0)
            CHECK(named >= 1);
        batten_notes_free(notes);
        batten_body_unref(body);
    }
}

static batten_body_faults faults_of(const batten_body *body)
{
    batten_body_faults f = {.gaps = -1};
    CHECK_OK(batten_body_check(body, 1e-6, NULL, NULL, &f));
    return f;
}

static int crossing_in(int count, const double (*corners)[2], const int *sizes, int loops)
{
    batten_body *body = sheet_with_loops(count, corners, sizes, loops);
    const batten_body_faults f = faults_of(body);
    CHECK_INT(f.loose + f.gaps, 0);
    batten_body_unref(body);
    return f.crossing_loops;
}

TEST(G8_loops_that_cross_or_touch_are_found)
{
    static const double inside[][2] = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
    static const double over_rim[][2] = {{3, 1}, {3, 2}, {5, 2}, {5, 1}};
    static const double bow_tie[][2] = {{1, 1}, {2, 2}, {2, 1}, {1, 2}};
    static const double two[][2] = {{1, 1},     {1, 2},   {2, 2}, {2, 1},
                                    {1.5, 1.5}, {1.5, 3}, {3, 3}, {3, 1.5}};
    static const double at_corner[][2] = {{0, 0}, {1, 2}, {2, 1}};
    static const double at_each_other[][2] = {{1, 1}, {1, 2}, {2, 2}, {2, 2}, {2, 3}, {3, 2}};
    static const double apart[][2] = {{1, 1}, {1, 2}, {2, 2}, {2.5, 2}, {2.5, 3}, {3, 2}};
    static const int four[] = {4, 4}, three[] = {3, 3};
    static const double twice[][2] = {{1, 1}, {1, 2}, {2, 2}, {2, 1},
                                      {1, 1}, {1, 2}, {2, 2}, {2, 1}};
    /* between the two that touch, one beside them: in v, and in u */
    static const double beside[2][9][2] = {{{1, 1},
                                            {0.5, 0.9},
                                            {0.9, 0.5},
                                            {1, 2},
                                            {0.5, 1.9},
                                            {0.9, 1.5},
                                            {1, 1},
                                            {1.5, 1.1},
                                            {1.1, 1.5}},
                                           {{1, 1},
                                            {0.5, 0.9},
                                            {0.9, 0.5},
                                            {2, 1},
                                            {1.5, 0.9},
                                            {1.9, 0.5},
                                            {1, 1},
                                            {1.5, 1.1},
                                            {1.1, 1.5}}};
    static const int thrice[] = {3, 3, 3};
    for (int k = 0; k < 2; k++)
        CHECK_INT(crossing_in(9, beside[k], thrice, 3), 2);
    CHECK_INT(crossing_in(8, twice, four, 2), 2);
    CHECK_INT(crossing_in(0, NULL, NULL, 0), 0);
    CHECK_INT(crossing_in(4, inside, four, 1), 0);
    CHECK_INT(crossing_in(4, over_rim, four, 1), 2);
    CHECK_INT(crossing_in(4, bow_tie, four, 1), 1);
    CHECK_INT(crossing_in(8, two, four, 2), 2);
    CHECK_INT(crossing_in(3, at_corner, three, 1), 2);
    CHECK_INT(crossing_in(6, at_each_other, three, 2), 2);
    CHECK_INT(crossing_in(6, apart, three, 2), 0);
}

TEST(G8_a_crossing_is_named_with_its_place)
{
    static const double over_rim[][2] = {{3, 1}, {3, 2}, {5, 2}, {5, 1}};
    static const int four[] = {4};
    batten_body *body = sheet_with_loops(4, over_rim, four, 1);
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    batten_body_faults f;
    CHECK_OK(batten_body_check(body, 1e-6, NULL, notes, &f));
    if (batten_notes_dropped(notes) == 0) {
        CHECK(batten_notes_count(notes) >= 2);
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "face 1 \"sheet\"");
        CHECK_INT(batten_notes_at(notes, 0)->line, 0);
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text,
                       "edges 2 and 8 of its loops 1 and 2 cross at (u, v) = (4, 1)");
    }
    batten_notes_free(notes);
    batten_body_unref(body);
}
