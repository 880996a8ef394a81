/* The box around a body holds it, also where faces swell beyond their edges. */
#include "body/measure/box.h"
#include "body/by_hand.h"
#include "numeric/box.h"
#include "support/test.h"

#include <batten/mesh.h>
#include <batten/standard.h>

static batten_box box_of(const batten_body *body)
{
    batten_box box;
    CHECK_OK(bat_body_find_box(body, &box));
    return box;
}

static void check_box(batten_box box, const double low[3], const double high[3], double room)
{
    const double a[3] = {box.low.x, box.low.y, box.low.z},
                 b[3] = {box.high.x, box.high.y, box.high.z};
    for (int k = 0; k < 3; k++) {
        CHECK(a[k] <= low[k] + 1e-6 && a[k] >= low[k] - room);
        CHECK(b[k] >= high[k] - 1e-6 && b[k] <= high[k] + room);
    }
}

static double size_of(batten_box box)
{
    return hypot(hypot(box.high.x - box.low.x, box.high.y - box.low.y), box.high.z - box.low.z);
}

/* As far as rounding goes: parts of surfaces have control points of their own. */
static bool holds(batten_box outer, batten_box inner)
{
    const double room = 1e-12 * size_of(outer);
    return inner.low.x >= outer.low.x - room && inner.low.y >= outer.low.y - room &&
           inner.low.z >= outer.low.z - room && inner.high.x <= outer.high.x + room &&
           inner.high.y <= outer.high.y + room && inner.high.z <= outer.high.z + room;
}

/* A wide box holds at least what the box does, and nothing beyond edges and surfaces. */
static void check_wide(const batten_body *body, batten_box box)
{
    const batten_box wide = bat_body_wide_box(body);
    const batten_body_parts *parts = batten_body_view(body);
    batten_box most = bat_body_edge_box(body);
    for (int i = 0; i < parts->face_count; i++)
        bat_box_join(&most, batten_surface_box(parts->faces[i].surface));
    CHECK(holds(wide, box) && holds(most, wide));
}

/* As it is, and traced; the second time it is known. */
static void check_both(hand *m, const double low[3], const double high[3], double room)
{
    batten_body *body = NULL, *traced = NULL;
    m->builder.parts.tolerance = 1e-6;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, NULL, &traced));
    for (int k = 0; k < 2; k++) {
        batten_body_measures measured;
        check_box(box_of(k ? traced : body), low, high, room);
        check_box(batten_body_box(k ? traced : body), low, high, room);
        check_wide(k ? traced : body, box_of(k ? traced : body));
        CHECK_OK(batten_body_measure(k ? traced : body, 1e-9, NULL, &measured));
        check_box(measured.box, low, high, 1e-6);
        CHECK(measured.box_error <= 1e-8 * size_of(measured.box));
    }
    batten_body_unref(body);
    batten_body_unref(traced);
}

static batten_surface *ball(double radius)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_sphere(&hand_world, radius, &surface));
    return surface;
}

TEST(a_cap_of_a_ball_reaches_to_its_pole)
{
    static const struct {
        int edge;
        double low, high;
        bool reversed;
    } cases[] = {{1, 0, 2, false}, {-1, -2, 0, false}, {1, -2, 0, true}};
    for (int k = 0; k < COUNT(cases); k++) {
        hand m = hand_begin();
        hand_arc(&m, 2, 0, 0, 360);
        hand_face(&m, ball(2), cases[k].reversed);
        HAND_LOOP(&m, cases[k].edge);
        const double low[] = {-2, -2, cases[k].low}, high[] = {2, 2, cases[k].high};
        check_both(&m, low, high, 1e-6);
    }
}

/* One around its pole, and one at its side. */
TEST(a_ball_with_a_small_hole_is_as_large_as_the_ball)
{
    for (int side = 0; side < 2; side++) {
        const double at = sqrt(1e6 - 0.25);
        hand m = hand_begin();
        batten_frame frame = hand_world;
        batten_curve *circle = NULL;
        if (side)
            frame = (batten_frame){{at, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
        else
            frame = (batten_frame){{0, 0, at}, {1, 0, 0}, {0, 0, -1}};
        CHECK_OK(batten_curve_arc_in(&frame, 0.5, 0, 2 * BAT_PI, &circle));
        hand_edge(&m, circle);
        hand_face(&m, ball(1000), false);
        HAND_LOOP(&m, 1);
        const double low[] = {-1000, -1000, -1000};
        const double high[] = {side ? at : 1000, 1000, side ? 1000 : at};
        check_both(&m, low, high, 0.01);
    }
}

/* The chord that is taken when none is asked for goes by the size of the ball. */
TEST(a_ball_with_a_small_hole_has_a_mesh_as_coarse_as_a_ball)
{
    hand m = hand_begin();
    batten_frame frame = {{0, 0, sqrt(1e6 - 0.25)}, {1, 0, 0}, {0, 0, -1}};
    batten_curve *circle = NULL;
    batten_body *body = NULL;
    batten_mesh *mesh = NULL;
    const batten_mesh_options options = batten_mesh_defaults();
    CHECK_OK(batten_curve_arc_in(&frame, 0.5, 0, 2 * BAT_PI, &circle));
    hand_edge(&m, circle);
    hand_face(&m, ball(1000), false);
    HAND_LOOP(&m, 1);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, NULL, &mesh));
    CHECK(batten_mesh_view(mesh)->triangle_count < 20000);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}

/* The chord of 0.02 radians at a radius of 1000, over the seam; the surface is all around. */
TEST(a_small_part_of_a_large_cylinder_has_a_small_box)
{
    const double half = 0.01, degrees = half * 180 / BAT_PI;
    for (int turned = 0; turned < 2; turned++) {
        const double middle = turned ? BAT_PI / 2 : 0, start = middle - half;
        const double x = 1000 * cos(middle - half), y = 1000 * sin(middle - half);
        const double x1 = 1000 * cos(middle + half), y1 = 1000 * sin(middle + half);
        hand m = hand_begin();
        hand_arc(&m, 1000, 1, start * 180 / BAT_PI, 2 * degrees);
        hand_line(&m, x1, y1, 1, x1, y1, 5);
        hand_arc(&m, 1000, 5, start * 180 / BAT_PI, 2 * degrees);
        hand_line(&m, x, y, 1, x, y, 5);
        hand_face(&m, hand_cylinder(1000, 6), false);
        HAND_LOOP(&m, 1, 2, -3, -4);
        const double low[] = {bat_min(x, x1), bat_min(y, y1), 1},
                     high[] = {turned ? x : 1000, turned ? 1000 : y1, 5};
        check_both(&m, low, high, 0.06);
    }
}

TEST(a_plane_reaches_beyond_its_face_and_its_box_does_not)
{
    static const double corners[] = {-9, -9, 1, -9, 9, 1, 9, -9, 1, 9, 9, 1};
    static const double knots[] = {-9, -9, 9, 9};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *plane = NULL;
    hand m = hand_begin();
    hand_arc(&m, 2, 1, 0, 360);
    CHECK_OK(batten_surface_create(3, &axis, &axis, corners, NULL, &plane));
    hand_face(&m, plane, false);
    HAND_LOOP(&m, 1);
    const double low[] = {-2, -2, 1}, high[] = {2, 2, 1};
    check_both(&m, low, high, 1e-9);
}

/* A cylinder whose surface is 6 high, of which 1 to 5 count; and one with a window as well. */
TEST(a_face_all_around_ends_at_its_loops)
{
    for (int window = 0; window < 2; window++) {
        hand m = hand_begin();
        const double c = 3 * cos(0.5), s = 3 * sin(0.5), degrees = 0.5 * 180 / BAT_PI;
        hand_arc(&m, 3, 1, 0, 360);
        hand_arc(&m, 3, 5, 0, 360);
        if (window) {
            hand_arc(&m, 3, 2, -degrees, 2 * degrees);
            hand_line(&m, c, s, 2, c, s, 4);
            hand_arc(&m, 3, 4, -degrees, 2 * degrees);
            hand_line(&m, c, -s, 2, c, -s, 4);
        }
        hand_face(&m, hand_cylinder(3, 6), false);
        HAND_LOOP(&m, 1);
        HAND_LOOP(&m, -2);
        if (window)
            HAND_LOOP(&m, 6, 5, -4, -3);
        const double low[] = {-3, -3, 1}, high[] = {3, 3, 5};
        check_both(&m, low, high, window ? 0.5 : 1e-6); /* control points of the window */
    }
}

/* Half of a cone: both its lines end in the apex, where its surface has no direction. */
TEST(a_face_that_meets_a_pole_is_held)
{
    hand m = hand_begin();
    batten_surface *cone = NULL;
    CHECK_OK(batten_surface_cone(&hand_world, 2, 0, 3, &cone));
    hand_arc(&m, 2, 0, -90, 180);
    hand_line(&m, 0, 2, 0, 0, 0, 3);
    hand_line(&m, 0, 0, 3, 0, -2, 0);
    hand_face(&m, cone, false);
    HAND_LOOP(&m, 1, 2, 3);
    const double low[] = {0, -2, 0}, high[] = {2, 2, 3};
    check_both(&m, low, high, 2 + 1e-6);
}
