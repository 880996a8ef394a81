/* Why faces are left out: the edge and the numbers in the notes. */
#include "body/by_hand.h"
#include "support/test.h"

#include <batten/standard.h>

/* Trace a body of one face that is left out, and look at the note. */
static void check_left_out(hand *m, const char *words)
{
    batten_body_trace_report report;
    batten_notes *notes = NULL;
    batten_body *body = NULL, *traced = NULL;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, notes, &report, &traced));
    CHECK_INT(report.failed, 1);
    CHECK_INT(batten_body_view(traced)->face_count, 0);
    if (batten_notes_count(notes) == 0) {
        CHECK(batten_notes_dropped(notes) > 0); /* for want of memory */
    } else {
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "face 1");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, words);
    }
    batten_body_unref(traced);
    batten_body_unref(body);
    batten_notes_free(notes);
}

/* A plate at z = 0 in a triangle whose second edge ends or begins too high. */
TEST(an_end_off_the_surface_is_named)
{
    hand m = hand_begin();
    hand_line(&m, 0, 0, 0, 1, 0, 0);
    hand_line(&m, 1, 0, 0, 0, 1, 0.25);
    hand_line(&m, 0, 1, 0.25, 0, 0, 0);
    hand_plate(&m, -1, -1, 2, 2, 0);
    HAND_LOOP(&m, 1, 2, 3);
    check_left_out(&m, "left out: the edge is 0.25 off the surface at its end, more than");
    m = hand_begin();
    hand_line(&m, 0, 1, 0.25, 0, 0, 0);
    hand_line(&m, 0, 0, 0, 1, 0, 0);
    hand_line(&m, 1, 0, 0, 0, 1, 0.25);
    hand_plate(&m, -1, -1, 2, 2, 0);
    HAND_LOOP(&m, 1, 2, 3);
    check_left_out(&m, "left out: the edge is 0.25 off the surface at its start, more than");
}

TEST(a_loop_without_an_area_is_named)
{
    hand m = hand_begin();
    hand_line(&m, 0, 0, 0, 1, 0, 0);
    hand_line(&m, 1, 0, 0, 2, 0, 0);
    hand_line(&m, 2, 0, 0, 0, 0, 0);
    hand_plate(&m, -1, -1, 2, 2, 0);
    HAND_LOOP(&m, 1, 2, 3);
    check_left_out(&m, "its outer loop holds no area");
}

/* Three rims around a cylinder. */
TEST(loops_that_cross_a_seam_the_same_way_are_named)
{
    hand m = hand_begin();
    hand_arc(&m, 2, 1, 0, 360);
    hand_arc(&m, 2, 2, 0, 360);
    hand_arc(&m, 2, 4, 0, 360);
    hand_face(&m, hand_cylinder(2, 5), false);
    HAND_LOOP(&m, 1);
    HAND_LOOP(&m, 2);
    HAND_LOOP(&m, -3);
    check_left_out(&m, "twice the same way, at edges 1 and 2");
}

/* The second edge begins beside the end of the first. */
TEST(a_gap_in_a_loop_is_named_with_the_edge_behind_it)
{
    static const double corners[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const double starts[3][3] = {{0, 0, 0}, {1, 0.25, 0}, {0, 1, 0}};
    hand m = hand_begin();
    int vertices[3], edge;
    for (int i = 0; i < 3; i++)
        CHECK_OK(bat_builder_vertex(&m.builder, corners[i], &vertices[i]));
    for (int i = 0; i < 3; i++) {
        batten_curve *line = NULL;
        CHECK_OK(batten_curve_line(3, starts[i], corners[(i + 1) % 3], &line));
        CHECK_OK(bat_builder_edge(&m.builder, line, vertices[i], vertices[(i + 1) % 3], &edge));
        batten_curve_unref(line);
    }
    hand_plate(&m, -1, -1, 2, 2, 0);
    HAND_LOOP(&m, 1, 2, 3);
    check_left_out(&m, "left out: its loop has a gap of 0.25 before edge 2, more than twice");
}
