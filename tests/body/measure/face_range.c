/* The part of a surface that a face takes up: places on the face are in it, those well beyond its border are not. */
#include "body/by_hand.h"
#include "body/measure/box.h"
#include "numeric/vector.h"
#include "support/test.h"

#include <batten/standard.h>

/* Is a place of the surface on the face? 1: yes, -1: well beyond its range, 0: neither is asked. */
typedef int where(const double p[3]);

static bool is_in(const bat_face_range *range, const double uv[2])
{
    bool in[2] = {false, false};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < range->count[k]; i++)
            in[k] = in[k] || (uv[k] >= range->at[k][i].a && uv[k] <= range->at[k][i].b);
    return in[0] && in[1];
}

static void check_range(const batten_body_parts *parts, double size, where *place)
{
    enum { EACH = 72 };
    bat_face_range range = {0};
    int of[2] = {0, 0};
    CHECK_OK(bat_face_range_find(parts, 0, size, &range));
    batten_interval domain[2];
    for (int k = 0; k < 2; k++) {
        domain[k] = batten_surface_domain(range.surface, k ? BATTEN_V : BATTEN_U);
        CHECK(range.count[k] == 1 || range.count[k] == 2);
        for (int i = 0; i < range.count[k]; i++) {
            CHECK(range.at[k][i].a < range.at[k][i].b);
            CHECK(range.at[k][i].a >= domain[k].a && range.at[k][i].b <= domain[k].b);
        }
    }
    for (int i = 0; i <= EACH; i++)
        for (int j = 0; j <= EACH; j++) {
            const double uv[2] = {domain[0].a + (domain[0].b - domain[0].a) * i / EACH,
                                  domain[1].a + (domain[1].b - domain[1].a) * j / EACH};
            double p[3];
            CHECK_OK(batten_surface_evaluate(range.surface, uv[0], uv[1], 0, p));
            const int at = place(p);
            if (at == 0)
                continue;
            CHECK_INT(is_in(&range, uv), at > 0);
            of[at > 0]++;
        }
    CHECK(of[0] > 0 && of[1] > 0);
    batten_surface_unref(range.surface);
}

/* As it is, and traced. */
static void check_face(hand *m, double size, where *place)
{
    batten_body *body = NULL, *traced = NULL;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    check_range(batten_body_view(body), size, place);
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, NULL, &traced));
    check_range(batten_body_view(traced), size, place);
    batten_body_unref(traced);
    batten_body_unref(body);
}

/* From -1 to 1 inside, beyond 1.3 out; between them what the face swells by is not asked. */
static int rate(double beyond)
{
    return beyond < 0.99 ? 1 : beyond > 1.3 ? -1 : 0;
}

static int both(int a, int b)
{
    return a < 0 || b < 0 ? -1 : a > 0 && b > 0;
}

/* ---- a window of a cylinder, 40 degrees to both sides of an angle, from z = 2 to 4 ---- */

static double window_at; /* degrees */

static int in_window(const double p[3])
{
    const double angle = atan2(p[1], p[0]) * 180 / BAT_PI - window_at;
    const double off = angle - 360 * nearbyint(angle / 360);
    return both(rate(fabs(off) / 40), rate(fabs(p[2] - 3)));
}

static void add_window(hand *m, double radius)
{
    const double a = (window_at - 40) * BAT_PI / 180, b = (window_at + 40) * BAT_PI / 180;
    const double x = radius * cos(b), y = radius * sin(b), x0 = radius * cos(a),
                 y0 = radius * sin(a);
    hand_arc(m, radius, 2, window_at - 40, 80);
    hand_line(m, x, y, 2, x, y, 4);
    hand_arc(m, radius, 4, window_at - 40, 80);
    hand_line(m, x0, y0, 2, x0, y0, 4);
}

TEST(a_window_of_a_cylinder_has_its_range_wherever_the_seam_is)
{
    static const double places[] = {0, 20, 90, 180, 270, 340};
    for (int i = 0; i < COUNT(places); i++)
        for (int backwards = 0; backwards < 2; backwards++) {
            hand m = hand_begin();
            window_at = places[i];
            add_window(&m, 5);
            hand_face(&m, hand_cylinder(5, 6), backwards);
            if (backwards)
                HAND_LOOP(&m, 4, 3, -2, -1);
            else
                HAND_LOOP(&m, 1, 2, -3, -4);
            check_face(&m, 12, in_window);
        }
}

/* A hole from one angle to another, from z = 2.5 to 3.5: its edges are the next four. */
static void add_hole(hand *m, double radius, double from, double to)
{
    const double a = from * BAT_PI / 180, b = to * BAT_PI / 180;
    const double x0 = radius * cos(a), y0 = radius * sin(a), x1 = radius * cos(b),
                 y1 = radius * sin(b);
    hand_arc(m, radius, 2.5, from, to - from);
    hand_line(m, x1, y1, 2.5, x1, y1, 3.5);
    hand_arc(m, radius, 3.5, from, to - from);
    hand_line(m, x0, y0, 2.5, x0, y0, 3.5);
}

/* The feet of a hole may be found whole turns beside those of the outer loop. */
TEST(a_hole_in_a_window_does_not_widen_it_on_either_side_of_the_seam)
{
    static const double places[] = {0, 20, 340, 180}, holes[] = {-30, -5, 15};
    for (int i = 0; i < COUNT(places); i++)
        for (int k = 0; k < COUNT(holes); k++) {
            hand m = hand_begin();
            window_at = places[i];
            add_window(&m, 5);
            const double from = fmod(places[i] + holes[k] + 360, 360);
            add_hole(&m, 5, from, from + 10);
            hand_face(&m, hand_cylinder(5, 6), false);
            if (k % 2) {
                HAND_LOOP(&m, 1, 2, -3, -4);
                HAND_LOOP(&m, 8, 7, -6, -5);
            } else {
                HAND_LOOP(&m, 8, 7, -6, -5);
                HAND_LOOP(&m, 1, 2, -3, -4);
            }
            batten_body *body = NULL;
            CHECK_OK(batten_body_create(&m.builder.parts, &body));
            bat_builder_end(&m.builder);
            check_range(batten_body_view(body), 12, in_window);
            batten_body_unref(body);
        }
}

/* ---- a band of a cylinder between two circles ---- */

static int in_band(const double p[3])
{
    return rate(fabs(p[2] - 3));
}

TEST(a_band_around_a_cylinder_is_all_around_and_ends_at_its_circles)
{
    for (int reversed = 0; reversed < 2; reversed++) {
        hand m = hand_begin();
        hand_arc(&m, 5, 2, 30, 360);
        hand_arc(&m, 5, 4, 200, 360);
        hand_face(&m, hand_cylinder(5, 6), reversed);
        if (reversed) {
            HAND_LOOP(&m, 2);
            HAND_LOOP(&m, -1);
        } else {
            HAND_LOOP(&m, 1);
            HAND_LOOP(&m, -2);
        }
        check_face(&m, 12, in_band);
    }
}

/* ---- caps of a ball and of a cone ---- */

static double cap_from, cap_sign;

static int above(const double p[3])
{
    const double z = cap_sign * (p[2] - cap_from);
    return z > 0.05 ? 1 : z < -0.3 ? -1 : 0;
}

TEST(a_cap_goes_up_to_the_pole_on_its_side)
{
    for (int k = 0; k < 8; k++) {
        hand m = hand_begin();
        const bool down = k & 1, reversed = k & 2, is_cone = k & 4;
        cap_from = is_cone ? 2 : 1;
        cap_sign = is_cone || !down ? 1 : -1;
        const double radius = is_cone ? 3 : sqrt(3);
        batten_surface *surface = NULL;
        if (is_cone)
            CHECK_OK(batten_surface_cone(&hand_world, 5, 0, 5, &surface));
        else
            CHECK_OK(batten_surface_sphere(&hand_world, 2, &surface));
        hand_arc(&m, radius, cap_from, 77, 360);
        hand_face(&m, surface, reversed);
        /* Of a cone the side with the pole is the face, however the loop runs. */
        HAND_LOOP(&m, down != reversed ? -1 : 1);
        batten_body *body = NULL;
        CHECK_OK(batten_body_create(&m.builder.parts, &body));
        bat_builder_end(&m.builder);
        check_range(batten_body_view(body), 5, above);
        batten_body_unref(body);
    }
}

/* ---- parts of a torus with radii 3 and 1 ---- */

/* The circle across the torus at an angle in degrees. */
static void add_ring(hand *m, double degrees)
{
    const double c = cos(degrees * BAT_PI / 180), s = sin(degrees * BAT_PI / 180);
    const batten_frame frame = {{3 * c, 3 * s, 0}, {c, s, 0}, {s, -c, 0}};
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, 1, 0, 2 * BAT_PI, &circle));
    hand_edge(m, circle);
}

static void check_whole(const batten_body_parts *parts, double size)
{
    bat_face_range range = {0};
    CHECK_OK(bat_face_range_find(parts, 0, size, &range));
    for (int k = 0; k < 2; k++) {
        const batten_interval domain =
            batten_surface_domain(range.surface, k ? BATTEN_V : BATTEN_U);
        CHECK_INT(range.count[k], 1);
        CHECK_NEAR(range.at[k][0].a, domain.a, 0);
        CHECK_NEAR(range.at[k][0].b, domain.b, 0);
    }
    batten_surface_unref(range.surface);
}

/* A face that goes around a surface which is closed both ways has all of it: what its loops leave out is not
 * known. An elbow between two rings of the tube, or a band between its tops and bottoms. */
TEST(a_face_around_a_torus_has_all_of_its_range)
{
    for (int i = 0; i < 4; i++) {
        hand m = hand_begin();
        if (i < 2) {
            add_ring(&m, i ? 130 : -40);
            add_ring(&m, i ? 230 : 60);
        } else {
            hand_arc(&m, 3, 1, 20, 360);
            hand_arc(&m, 3, -1, 200, 360);
        }
        hand_face(&m, hand_torus(), i % 2);
        HAND_LOOP(&m, 1);
        HAND_LOOP(&m, -2);
        check_whole(&m.builder.parts, 8);
        bat_builder_end(&m.builder);
    }
}

/* ---- edges that are off ---- */

TEST(where_edges_are_off_the_surface_the_range_is_all_of_it)
{
    hand m = hand_begin();
    window_at = 0;
    add_window(&m, 6); /* the cylinder has radius 5 */
    hand_face(&m, hand_cylinder(5, 6), false);
    HAND_LOOP(&m, 1, 2, -3, -4);
    check_whole(&m.builder.parts, 12);
    bat_builder_end(&m.builder);
}
