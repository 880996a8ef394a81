/* Faces with a corner at a pole of their surface. */
#include "body/by_hand.h"
#include "support/test.h"
#include <batten/standard.h>

static const double DEGREE = 0.017453292519943295;

/* From a latitude of the sphere of radius 2 up to its pole, along a meridian, or down. */
static int meridian(hand *m, double latitude, double longitude, bool down)
{
    batten_curve *curve = NULL;
    const double c = cos(DEGREE * longitude), s = sin(DEGREE * longitude);
    const batten_frame from_equator = {.x = {c, s, 0}, .z = {s, -c, 0}},
                       from_pole = {.x = {0, 0, 1}, .z = {-s, c, 0}};
    CHECK_OK(batten_curve_arc_in(down ? &from_pole : &from_equator, 2,
                                 down ? 0 : DEGREE * latitude, DEGREE * (90 - latitude),
                                 &curve));
    return hand_edge(m, curve);
}

/* The part of the sphere above the latitude from one meridian to another; its loop begins with
 * any of its edges. */
static batten_body *triangle(double longitude, double angle, int first, bool all_but_it,
                             double tolerance, int turn)
{
    static const int loops[3][3] = {{1, 2, 3}, {2, 3, 1}, {3, 1, 2}};
    static const int around[3][3] = {{-2, -1, -3}, {-1, -3, -2}, {-3, -2, -1}};
    const double latitude = 20;
    hand m = hand_turned(turn);
    batten_body_trace_report report;
    batten_surface *sphere = NULL;
    const double height = 2 * sin(DEGREE * latitude), radius = 2 * cos(DEGREE * latitude);
    hand_arc(&m, radius, height, longitude, angle);
    meridian(&m, latitude, longitude + angle, false);
    meridian(&m, latitude, longitude, true);
    CHECK_OK(batten_surface_sphere(&hand_world, 2, &sphere));
    hand_face(&m, sphere, false);
    hand_loop(&m, 3, (all_but_it ? around : loops)[first]);
    batten_body *body = hand_trace(&m, tolerance, &report);
    CHECK_INT(report.failed, 0);
    return body;
}

/* The edges leave the pole at any angle, along the seam too, and whatever the tolerance: places
 * nearer to the pole than it say nothing of their meridian. */
TEST(a_triangle_with_a_corner_at_a_pole_has_its_own_area)
{
    static const double angles[] = {35, 90, 120, 180, 250}, starts[] = {0, 30, 270};
    const double all = 16 * acos(-1);
    for (size_t i = 0; i < COUNT(angles); i++)
        for (size_t k = 0; k < COUNT(starts); k++)
            for (int first = 0; first < 3; first++)
                for (int side = 0; side < 2; side++) {
                    const double tolerance = first == 1 ? 1e-6 : 1e-3;
                    batten_body *body = triangle(starts[k], angles[i], first, side, tolerance,
                                                 (int)(i + 3 * k + first + 4 * side) % 8);
                    batten_body_faults faults;
                    const double own = 4 * DEGREE * angles[i] * (1 - sin(DEGREE * 20));
                    CHECK_NEAR(hand_area(body), side ? all - own : own, 20 * tolerance);
                    CHECK_OK(batten_body_check(body, tolerance, NULL, NULL, &faults));
                    CHECK_INT(faults.crossing_loops, 0);
                    batten_body_unref(body);
                }
}

/* As a file has it that cannot say that two sides are one edge. */
TEST(a_torus_cut_open_along_edges_of_its_own_is_the_whole_of_it)
{
    static const int loops[][4] = {
        {1, 2, -3, -4}, {-1, 2, 3, -4}, {2, 1, -4, -3}, {-2, 1, 4, -3}};
    for (int side = 0; side < 2; side++)
        for (size_t i = 0; i < COUNT(loops); i++) {
            hand m = hand_begin();
            batten_body_trace_report report;
            const batten_frame across = {.origin = {3, 0, 0}, .x = {1, 0, 0}, .z = {0, -1, 0}};
            hand_arc(&m, 4, 0, 0, 360);
            for (int k = 0; k < 3; k++) {
                batten_curve *circle = NULL;
                CHECK_OK(batten_curve_arc_in(&across, 1, 0, 2 * acos(-1), &circle));
                if (k == 1) {
                    batten_curve_unref(circle);
                    hand_arc(&m, 4, 0, 0, 360);
                } else {
                    hand_edge(&m, circle);
                }
            }
            hand_face(&m, hand_torus(), side);
            hand_loop(&m, 4, loops[i]);
            batten_body *body = hand_trace(&m, 1e-6, &report);
            CHECK_INT(report.failed, 0);
            CHECK_INT(batten_body_view(body)->face_count, 1);
            CHECK_NEAR(hand_area(body), 12 * acos(-1) * acos(-1), 1e-4);
            batten_body_unref(body);
        }
}
