#include "body/by_hand.h"
#include "support/test.h"
#include <batten/standard.h>

TEST(an_edge_in_a_plane_is_traced_exactly)
{
    hand m = hand_begin();
    batten_body_trace_report report;
    hand_line(&m, 0, 0, 1, 4, 0, 1);
    hand_line(&m, 4, 0, 1, 4, 3, 1);
    hand_line(&m, 4, 3, 1, 0, 3, 1);
    hand_line(&m, 0, 3, 1, 0, 0, 1);
    batten_frame frame = hand_world;
    frame.origin = (batten_vec3){2, 1.5, 1};
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, 1, 0, 2 * acos(-1), &circle));
    hand_edge(&m, circle);
    hand_plate(&m, -1, -1, 5, 5, 1);
    HAND_LOOP(&m, 1, 2, 3, 4);
    HAND_LOOP(&m, -5);
    batten_body *body = hand_trace(&m, 1e-6, &report);
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->face_count, 1);
    CHECK_INT(p->faces[0].count, 2);
    CHECK_INT(report.rebuilt, 5);
    CHECK_NEAR(report.error, 0, 1e-15);
    const batten_curve *hole = p->uses[4].parameters, *of = p->edges[p->uses[4].edge].curve;
    CHECK_INT(batten_curve_knot_count(hole), batten_curve_knot_count(of));
    for (int i = 0; i < batten_curve_point_count(of); i++)
        CHECK_BITS(batten_curve_weights(hole)[i], batten_curve_weights(of)[i]);
    CHECK_NEAR(hand_area(body), 12 - acos(-1), 1e-7);
    batten_body_unref(body);
}

TEST(loops_that_run_the_wrong_way_are_turned)
{
    for (int side = 0; side < 2; side++) {
        hand m = hand_begin();
        batten_body_trace_report report;
        hand_line(&m, 0, 0, 0, 4, 0, 0);
        hand_line(&m, 4, 0, 0, 4, 3, 0);
        hand_line(&m, 4, 3, 0, 0, 0, 0);
        hand_line(&m, 3, 1, 0, 3.5, 1, 0);
        hand_line(&m, 3.5, 1, 0, 3.5, 1.5, 0);
        hand_line(&m, 3.5, 1.5, 0, 3, 1, 0);
        hand_plate(&m, 0, 0, 4, 4, 0);
        ((batten_body_face *)(uintptr_t)m.builder.parts.faces)[0].reversed = side;
        HAND_LOOP(&m, 4, 5, 6);
        HAND_LOOP(&m, -3, -2, -1);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        batten_body_unref(body);
    }
}

static void check_sphere(int turn)
{
    hand m = hand_turned(turn);
    batten_body_trace_report report;
    batten_surface *sphere = NULL;
    CHECK_OK(batten_surface_sphere(&hand_world, 2, &sphere));
    hand_face(&m, sphere, true);
    batten_body *body = hand_trace(&m, 1e-6, &report);
    CHECK_INT(report.seams, 1);
    CHECK_INT(report.poles, 2);
    CHECK_INT(batten_body_view(body)->edge_count, 3);
    CHECK_NEAR(hand_area(body), 16 * acos(-1), 1e-5);
    CHECK_NEAR(hand_volume(body), -32 * acos(-1) / 3, 1e-5);
    batten_body_unref(body);
}

TEST(a_sphere_without_loops_gets_its_border)
{
    hand_every_turn(check_sphere);
}

static void check_hemispheres(int turn)
{
    for (int side = 0; side < 2; side++) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        batten_surface *sphere = NULL;
        hand_arc(&m, 2, 0, 10, 360);
        CHECK_OK(batten_surface_sphere(&hand_world, 2, &sphere));
        hand_face(&m, sphere, false);
        HAND_LOOP(&m, side ? -1 : 1);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(report.seams, 1);
        CHECK_INT(report.poles, 1);
        CHECK_INT(p->edge_count, 3);
        for (int i = 0; i < p->use_count; i++) {
            double uv[2], s[3];
            CHECK_OK(batten_curve_evaluate(
                p->uses[i].parameters, batten_curve_domain(p->uses[i].parameters).a, 0, uv));
            CHECK_OK(batten_surface_evaluate(p->faces[0].surface, uv[0], uv[1], 0, s));
            CHECK(side ? s[2] < 1e-6 : s[2] > -1e-6);
        }
        CHECK_NEAR(hand_area(body), 8 * acos(-1), 1e-5);
        batten_body_unref(body);
    }
}

TEST(hemispheres_get_a_seam_and_a_pole)
{
    hand_every_turn(check_hemispheres);
}

static void check_caps(int turn)
{
    for (int side = 0; side < 2; side++) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        batten_surface *sphere = NULL;
        batten_curve *circle = NULL;
        const batten_frame frame = {.origin = {1.6, 0, 0}, .x = {0, 1, 0}, .z = {1, 0, 0}};
        CHECK_OK(batten_curve_arc_in(&frame, 1.2, 0.3, 2 * acos(-1), &circle));
        hand_edge(&m, circle);
        CHECK_OK(batten_surface_sphere(&hand_world, 2, &sphere));
        hand_face(&m, sphere, false);
        HAND_LOOP(&m, side ? -1 : 1);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 1);
        CHECK_INT(p->faces[0].count, side ? 2 : 1);
        CHECK_INT(report.poles, side ? 2 : 0);
        CHECK_INT(report.seams, side ? 1 : 0);
        CHECK_NEAR(hand_area(body), (side ? 14.4 : 1.6) * acos(-1), 1e-5);
        batten_body_unref(body);
    }
}

TEST(a_circle_on_a_sphere_bounds_a_cap_or_all_but_a_cap)
{
    hand_every_turn(check_caps);
}

static void check_octant(int turn)
{
    hand m = hand_turned(turn);
    batten_body_trace_report report;
    batten_surface *sphere = NULL;
    batten_curve *curve = NULL;
    const batten_frame xz = {.x = {1, 0, 0}, .z = {0, -1, 0}},
                       yz = {.x = {0, 1, 0}, .z = {1, 0, 0}};
    hand_arc(&m, 2, 0, 0, 90);
    CHECK_OK(batten_curve_arc_in(&yz, 2, 0, acos(-1) / 2, &curve));
    hand_edge(&m, curve);
    CHECK_OK(batten_curve_arc_in(&xz, 2, 0, acos(-1) / 2, &curve));
    hand_edge(&m, curve);
    CHECK_OK(batten_surface_sphere(&hand_world, 2, &sphere));
    hand_face(&m, sphere, false);
    HAND_LOOP(&m, 1, 2, -3);
    batten_body *body = hand_trace(&m, 1e-6, &report);
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->edge_count, 4);
    CHECK_INT(report.poles, 1);
    CHECK_NEAR(hand_area(body), 2 * acos(-1), 1e-5);
    batten_body_unref(body);
}

TEST(an_octant_of_a_sphere_has_a_pole)
{
    hand_every_turn(check_octant);
}

/* The pole is within the box of the circle's points, or, where a quarter ends at the pole, at its rim. */
static void check_through_pole(int turn)
{
    static const double starts[] = {0.2, 0, 1.2};
    const int i = turn % COUNT(starts);
    for (int side = -1; side <= 1; side += 2) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        batten_surface *sphere = NULL;
        batten_curve *circle = NULL;
        /* In the plane x + z = 2 of the sphere: through (0, 0, 2) and (2, 0, 0); or its image below. */
        const double h = sqrt(0.5);
        const batten_frame frame = {
            .origin = {1, 0, side}, .x = {0, 1, 0}, .z = {h, 0, side * h}};
        CHECK_OK(batten_curve_arc_in(&frame, sqrt(2), starts[i], 2 * acos(-1), &circle));
        hand_edge(&m, circle);
        CHECK_OK(batten_surface_sphere(&hand_world, 2, &sphere));
        hand_face(&m, sphere, false);
        HAND_LOOP(&m, 1);
        batten_body *body = hand_trace(&m, 1e-5, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        CHECK_INT(report.poles, 1);
        CHECK_NEAR(hand_area(body), 4 * acos(-1) * (2 - sqrt(2)), 1e-4);
        batten_body_unref(body);
    }
}

TEST(a_circle_through_a_pole_is_divided_there)
{
    hand_every_turn(check_through_pole);
}

static void check_cone(int turn)
{
    for (int turned = 0; turned < 2; turned++) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        batten_surface *cone = NULL;
        hand_arc(&m, 2, 0, 70, 360);
        CHECK_OK(batten_surface_cone(&hand_world, 2, 0, 3, &cone));
        hand_face(&m, cone, false);
        HAND_LOOP(&m, turned ? -1 : 1);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->edge_count, 3);
        CHECK_INT(report.seams, 1);
        CHECK_INT(report.poles, 1);
        CHECK_NEAR(hand_area(body), 2 * acos(-1) * sqrt(13), 1e-5);
        batten_body_unref(body);
    }
}

TEST(a_cone_from_its_rim_to_its_apex_gets_a_seam)
{
    hand_every_turn(check_cone);
}

/* All edges begin and end in one vertex: the order in which they come may be another way
 * around. */
TEST(a_torus_cut_open_along_two_circles_is_the_whole_of_it)
{
    static const int loops[][4] = {
        {1, 2, -1, -2}, {-1, 2, 1, -2}, {2, 1, -2, -1}, {-2, 1, 2, -1}};
    for (int side = 0; side < 2; side++)
        for (size_t i = 0; i < COUNT(loops); i++) {
            hand m = hand_begin();
            batten_body_trace_report report;
            batten_curve *circle = NULL;
            const batten_frame across = {.origin = {3, 0, 0}, .x = {1, 0, 0}, .z = {0, -1, 0}};
            hand_arc(&m, 4, 0, 0, 360);
            CHECK_OK(batten_curve_arc_in(&across, 1, 0, 2 * acos(-1), &circle));
            hand_edge(&m, circle);
            hand_face(&m, hand_torus(), side);
            hand_loop(&m, 4, loops[i]);
            batten_body *body = hand_trace(&m, 1e-6, &report);
            CHECK_INT(report.failed, 0);
            CHECK_INT(report.seams, 0);
            CHECK_INT(batten_body_view(body)->face_count, 1);
            CHECK_INT(hand_shared(body), 2);
            CHECK_NEAR(hand_area(body), 12 * acos(-1) * acos(-1), 1e-4);
            CHECK_NEAR(hand_volume(body), (side ? -6 : 6) * acos(-1) * acos(-1), 1e-4);
            batten_body_unref(body);
        }
}
