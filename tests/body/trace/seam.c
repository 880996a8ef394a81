/* Seams of faces around closed surfaces: kept, moved, made, or not needed. */
#include "body/by_hand.h"
#include "support/test.h"
#include <batten/standard.h>

/* At the seam of the surface, which is at 0 degrees, and elsewhere. */
static void check_seam_edge(int turn)
{
    static const double starts[] = {0, 50, 180, -20};
    for (int i = 0; i < test_cases(COUNT(starts)) && i < COUNT(starts); i++) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        const double at = starts[i] * acos(-1) / 180, c = 2 * cos(at), s = 2 * sin(at);
        hand_arc(&m, 2, 0, starts[i], 360);
        hand_arc(&m, 2, 5, starts[i], 360);
        hand_line(&m, c, s, 0, c, s, 5);
        hand_face(&m, hand_cylinder(2, 5), false);
        HAND_LOOP(&m, 1, 3, -2, -3);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        CHECK_INT(report.seams, 0);
        CHECK_INT(batten_body_view(body)->edge_count, 3);
        CHECK_INT(hand_shared(body), 1);
        CHECK_NEAR(hand_area(body), 20 * acos(-1), 1e-5);
        batten_body_unref(body);
    }
}

TEST(a_seam_edge_of_a_cylinder_is_kept_wherever_it_is)
{
    hand_every_turn(check_seam_edge);
}

/* With lids, so that the circles are shared. */
static void check_between(int turn)
{
    static const double starts[][2] = {{0, 0}, {90, 90}, {30, 30}, {10, 200}, {0, 180}};
    const int i = turn % COUNT(starts);
    hand m = hand_turned(turn);
    batten_body_trace_report report;
    hand_arc(&m, 2, 0, starts[i][0], 360);
    hand_arc(&m, 2, 5, starts[i][1], 360);
    hand_face(&m, hand_cylinder(2, 5), false);
    HAND_LOOP(&m, 1);
    HAND_LOOP(&m, -2);
    hand_plate(&m, -3, -3, 3, 3, 0);
    batten_body_face *bottom = (batten_body_face *)(uintptr_t)m.builder.parts.faces + 1;
    bottom->reversed = !bottom->reversed;
    HAND_LOOP(&m, -1);
    hand_plate(&m, -3, -3, 3, 3, 5);
    HAND_LOOP(&m, 2);
    batten_body *body = hand_trace(&m, 1e-6, &report);
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->face_count, 3);
    CHECK_INT(report.seams, 1);
    CHECK_INT(p->edge_count, starts[i][0] == starts[i][1] ? 3 : 4);
    CHECK_INT(hand_shared(body), p->edge_count);
    CHECK_NEAR(hand_area(body), 28 * acos(-1), 1e-4);
    CHECK_NEAR(hand_volume(body), 20 * acos(-1), 1e-4);
    batten_body_unref(body);
}

TEST(a_cylinder_between_two_circles_gets_a_seam)
{
    hand_every_turn(check_between);
}

static void check_halves(int turn)
{
    static const double starts[] = {0, 90, 77, -90, 270.5};
    const int i = turn % COUNT(starts);
    hand m = hand_turned(turn);
    batten_body_trace_report report;
    const double at = starts[i] * acos(-1) / 180;
    const double c = 2 * cos(at), s = 2 * sin(at);
    hand_arc(&m, 2, 0, starts[i], 180);
    hand_arc(&m, 2, 5, starts[i], 180);
    hand_arc(&m, 2, 0, starts[i] + 180, 180);
    hand_arc(&m, 2, 5, starts[i] + 180, 180);
    hand_line(&m, c, s, 0, c, s, 5);
    hand_line(&m, -c, -s, 0, -c, -s, 5);
    hand_face(&m, hand_cylinder(2, 5), false);
    HAND_LOOP(&m, 1, 6, -2, -5);
    hand_face(&m, hand_cylinder(2, 5), false);
    HAND_LOOP(&m, 3, 5, -4, -6);
    batten_body *body = hand_trace(&m, 1e-6, &report);
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->face_count, 2);
    CHECK_INT(p->edge_count, 6);
    CHECK_INT(report.seams, 0);
    CHECK_INT(hand_shared(body), 2);
    CHECK_NEAR(hand_area(body), 20 * acos(-1), 1e-4);
    batten_body_unref(body);
}

TEST(half_cylinders_have_no_seam)
{
    hand_every_turn(check_halves);
}

/* A window from -20 to 30 degrees; as a face, and as a hole of the band. */
static void window(hand *m, int first)
{
    const double a = -20 * acos(-1) / 180, b = 30 * acos(-1) / 180;
    CHECK_INT(m->builder.parts.edge_count, first - 1);
    hand_arc(m, 2, 1, -20, 50);
    hand_line(m, 2 * cos(b), 2 * sin(b), 1, 2 * cos(b), 2 * sin(b), 3);
    hand_arc(m, 2, 3, -20, 50);
    hand_line(m, 2 * cos(a), 2 * sin(a), 1, 2 * cos(a), 2 * sin(a), 3);
}

static void check_face_across(int turn)
{
    hand m = hand_turned(turn);
    batten_body_trace_report report;
    window(&m, 1);
    hand_face(&m, hand_cylinder(2, 5), false);
    HAND_LOOP(&m, 1, 2, -3, -4);
    batten_body *body = hand_trace(&m, 1e-6, &report);
    CHECK_INT(batten_body_view(body)->face_count, 1);
    CHECK_INT(batten_body_view(body)->edge_count, 4);
    CHECK_INT(report.seams, 0);
    CHECK_NEAR(hand_area(body), 4 * 50 * acos(-1) / 180, 1e-5);
    batten_body_unref(body);
}

TEST(a_face_across_the_seam_of_a_cylinder_is_one_face_of_a_surface_with_another_seam)
{
    hand_every_turn(check_face_across);
}

static void check_hole_across(int turn)
{
    hand m = hand_turned(turn);
    batten_body_trace_report report;
    hand_arc(&m, 2, 0, 0, 360);
    hand_arc(&m, 2, 5, 0, 360);
    window(&m, 3);
    hand_face(&m, hand_cylinder(2, 5), false);
    HAND_LOOP(&m, 1);
    HAND_LOOP(&m, -2);
    HAND_LOOP(&m, 6, 5, -4, -3);
    hand_face(&m, hand_cylinder(2, 5), true);
    HAND_LOOP(&m, 3, 4, -5, -6);
    batten_body *body = hand_trace(&m, 1e-6, &report);
    CHECK_INT(batten_body_view(body)->face_count, 2);
    CHECK_INT(report.seams, 1);
    CHECK_NEAR(hand_area(body), 20 * acos(-1), 1e-4);
    CHECK_INT(hand_shared(body), 5);
    batten_body_unref(body);
}

TEST(a_hole_across_the_seam_of_a_band_moves_the_seam)
{
    hand_every_turn(check_hole_across);
}

static void check_bands(int turn)
{
    for (int side = 0; side < 2; side++) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        /* The circles on top and below, outside or inside of which the band is. */
        hand_arc(&m, 3, 1, 20, 360);
        hand_arc(&m, 3, -1, 50, 360);
        hand_face(&m, hand_torus(), false);
        HAND_LOOP(&m, side ? 1 : -1);
        HAND_LOOP(&m, side ? -2 : 2);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        CHECK(report.seams >= 1 && report.seams <= 2);
        CHECK_NEAR(hand_area(body), 2 * acos(-1) * (3 * acos(-1) + (side ? -2 : 2)), 1e-4);
        batten_body_unref(body);
    }
}

TEST(bands_around_a_torus_get_a_seam)
{
    hand_every_turn(check_bands);
}

static void check_bend(int turn)
{
    for (int side = 0; side < 2; side++) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        batten_curve *circle = NULL;
        const batten_frame first = {.origin = {3, 0, 0}, .x = {1, 0, 0}, .z = {0, -1, 0}};
        const batten_frame second = {.origin = {0, 3, 0}, .x = {0, 1, 0}, .z = {1, 0, 0}};
        CHECK_OK(batten_curve_arc_in(&first, 1, 0.4, 2 * acos(-1), &circle));
        hand_edge(&m, circle);
        CHECK_OK(batten_curve_arc_in(&second, 1, 1.4, 2 * acos(-1), &circle));
        hand_edge(&m, circle);
        hand_face(&m, hand_torus(), false);
        HAND_LOOP(&m, side ? 1 : -1);
        HAND_LOOP(&m, side ? -2 : 2);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        CHECK(report.seams >= 1 && report.seams <= 2);
        CHECK_NEAR(hand_area(body), acos(-1) * acos(-1) * (side ? 9 : 3), 1e-4);
        batten_body_unref(body);
    }
}

TEST(a_pipe_bend_between_two_circles_gets_a_seam)
{
    hand_every_turn(check_bend);
}
