/* What comes with the body: parameter curves good and bad, sides, maps; and what cannot be. */
#include "body/by_hand.h"
#include "body/trace/traced.h"
#include "body/trace/traced_body.h"
#include "support/bodies.h"
#include "support/test.h"
#include <batten/geometry.h>
#include <stdlib.h>

TEST(a_box_is_traced_with_its_edges_shared)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){3, 2, 1}), *traced = NULL;
    batten_body_trace_report report;
    CHECK_OK(batten_body_trace(box, 1e-6, NULL, NULL, &report, &traced));
    check_traced(traced, 1e-12);
    CHECK_INT(report.rebuilt, 24);
    CHECK_INT(report.failed, 0);
    CHECK_INT(hand_shared(traced), 12);
    CHECK_NEAR(hand_volume(traced), 6, 1e-9);
    batten_body_unref(box);
    batten_body_unref(traced);
}

TEST(a_mirrored_body_is_traced_as_well)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){3, 2, 1}),
                *mirrored = NULL, *traced = NULL, *again = NULL;
    batten_body_trace_report report;
    const batten_affine map =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0});
    CHECK_OK(batten_body_transform(box, &map, &mirrored));
    CHECK_OK(batten_body_trace(mirrored, 1e-6, NULL, NULL, &report, &traced));
    check_traced(traced, 1e-12);
    CHECK_NEAR(hand_volume(traced), 6, 1e-9);
    CHECK_INT(report.failed, 0);
    /* And mirrored after it was traced. */
    batten_body_unref(mirrored);
    CHECK_OK(batten_body_transform(traced, &map, &mirrored));
    check_traced(mirrored, 1e-12);
    CHECK_OK(batten_body_trace(mirrored, 1e-6, NULL, NULL, &report, &again));
    CHECK_INT(report.kept, 24);
    CHECK_NEAR(hand_volume(again), 6, 1e-9);
    batten_body_unref(again);
    batten_body_unref(mirrored);
    batten_body_unref(traced);
    batten_body_unref(box);
}

/* A quarter of a cylinder with given curves for the two arcs; `way` says what is wrong. */
static void quarter(int way, batten_body_trace_report *report)
{
    static const double points[][8] = {
        {0, 0, 0.25, 0, 0, 1, 0.25, 1},          /* right, of another domain */
        {0.25, 0, 0, 0, 0.25, 1, 0, 1},          /* run backwards */
        {0, 0.1, 0.25, 0.1, 0, 0.8, 0.25, 0.9},  /* beside */
        {-1, 0, -0.75, 0, 2, 1, 2.25, 1},        /* right, but periods away */
        {0, -1, 0.25, -1, 0, 2, 0.25, 2},        /* outside */
        {1e80, 0, 1e300, 0, -1e300, 0, 1e-80, 0} /* nonsense */
    };
    const double knots[] = {3, 3, 7, 7};
    hand m = hand_begin();
    hand_arc(&m, 2, 0, 0, 90);
    hand_line(&m, 0, 2, 0, 0, 2, 5);
    hand_arc(&m, 2, 5, 0, 90);
    hand_line(&m, 2, 0, 0, 2, 0, 5);
    hand_face(&m, hand_cylinder(2, 5), false);
    CHECK_OK(bat_builder_loop(&m.builder));
    for (int i = 0; i < 4; i++) {
        batten_curve *given = NULL;
        if (i % 2 == 0)
            CHECK_OK(batten_curve_create((batten_points){2, 2, points[way] + 2 * i}, 1, NULL,
                                         knots, &given));
        CHECK_OK(bat_builder_use(&m.builder, i, i >= 2, given));
        batten_curve_unref(given);
    }
    batten_body *body = hand_trace(&m, 1e-6, report);
    CHECK_NEAR(hand_area(body), 5 * acos(-1), 1e-5);
    CHECK_INT(batten_body_view(body)->edge_count, 4);
    batten_body_unref(body);
}

TEST(good_parameter_curves_are_kept_and_bad_ones_rebuilt)
{
    static const int kept[] = {2, 0, 0, 2, 0, 0};
    for (int way = 0; way < COUNT(kept); way++) {
        batten_body_trace_report report;
        quarter(way, &report);
        CHECK_INT(report.kept, kept[way]);
        CHECK_INT(report.rebuilt, 4 - kept[way]);
        CHECK_INT(report.failed, 0);
    }
}

static void check_note(const batten_notes *notes, const char *entity, const char *words)
{
    /* Lack of memory is borne, and counted. */
    if (batten_notes_count(notes) == 0) {
        CHECK(batten_notes_dropped(notes) > 0);
        return;
    }
    CHECK_CONTAINS(batten_notes_at(notes, 0)->entity, entity);
    CHECK_CONTAINS(batten_notes_at(notes, 0)->text, words);
}

TEST(an_edge_off_its_face_leaves_the_face_out)
{
    hand m = hand_begin();
    batten_body_trace_report report;
    batten_notes *notes = NULL;
    batten_body *body = NULL, *traced = NULL;
    hand_line(&m, 0, 0, 0, 1, 0, 0);
    hand_line(&m, 1, 0, 0, 0, 1, 0.01);
    hand_line(&m, 0, 1, 0.01, 0, 0, 0);
    hand_plate(&m, 0, 0, 1, 1, 0);
    HAND_LOOP(&m, 1, 2, 3);
    hand_line(&m, 0, 1, 0, 0, 0, 0);
    hand_line(&m, 1, 0, 0, 0, 1, 0);
    hand_plate(&m, 0, 0, 1, 1, 0);
    HAND_LOOP(&m, 1, 5, 4);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, &report, &traced));
    CHECK_INT(report.failed, 1);
    CHECK_INT(batten_body_view(traced)->face_count, 1);
    CHECK_INT(batten_body_view(traced)->edge_count, 3);
    batten_body_unref(traced);
    CHECK_STATUS(batten_body_trace(body, 0, NULL, notes, &report, &traced),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is 0");
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, notes, NULL, &traced));
    check_note(notes, "face 1", "left out: the edge is 0.01 off the surface at its end");
    batten_body_unref(traced);
    batten_body_unref(body);
    batten_notes_free(notes);
}

TEST(a_face_with_edges_a_little_off_is_traced_with_a_note)
{
    hand m = hand_begin();
    batten_body_trace_report report;
    batten_notes *notes = NULL;
    batten_body *body = NULL, *traced = NULL;
    hand_line(&m, 0, 0, 0, 1, 0, 0);
    hand_line(&m, 1, 0, 0, 0, 1, 5e-5);
    hand_line(&m, 0, 1, 5e-5, 0, 0, 0);
    hand_plate(&m, 0, 0, 1, 1, 0);
    HAND_LOOP(&m, 1, 2, 3);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, notes, &report, &traced));
    CHECK_INT(report.loose, 1);
    CHECK_INT(report.failed, 0);
    CHECK_NEAR(report.error, 5e-5, 1e-12);
    CHECK_NEAR(batten_body_view(traced)->tolerance, 5e-5, 1e-12);
    check_traced(traced, 5.1e-5);
    check_note(notes, "face 1", "its edges are more than 1e-06 off it");
    batten_body_unref(traced);
    batten_body_unref(body);
    batten_notes_free(notes);
}

TEST(huge_and_tiny_bodies_are_traced)
{
    static const double sizes[] = {1e80, 1e-80};
    for (int i = 0; i < COUNT(sizes); i++) {
        batten_body *box = test_box((batten_vec3){0, 0, 0},
                                    (batten_vec3){3 * sizes[i], 2 * sizes[i], sizes[i]}),
                    *traced = NULL;
        batten_body_trace_report report;
        CHECK_OK(batten_body_trace(box, 1e-6 * sizes[i], NULL, NULL, &report, &traced));
        check_traced(traced, 1e-12 * sizes[i]);
        CHECK_INT(report.failed, 0);
        batten_body_unref(box);
        batten_body_unref(traced);
    }
}

/* A closed cubic B-spline band with a cosine for its height, trimmed by plane curves of its own
 * border, and by circles at other heights that the follower has to find. */
static batten_surface *wavy_tube(bool periodic)
{
    enum { COUNT = 12 };
    double u[COUNT + 1], points[COUNT][4][3];
    const double v[] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int i = 0; i <= COUNT; i++)
        u[i] = i;
    for (int i = 0; i < COUNT; i++)
        for (int j = 0; j < 4; j++) {
            const double angle = 2 * acos(-1) * i / COUNT, r = 2 + 0.3 * (i % 2) + 0.2 * j;
            points[i][j][0] = r * cos(angle);
            points[i][j][1] = r * sin(angle);
            points[i][j][2] = 1.5 * j;
        }
    const batten_axis along = {3, COUNT, u, true}, across = {3, 4, v, false};
    batten_surface *surface = NULL, *clamped = NULL;
    CHECK_OK(batten_surface_create(3, &along, &across, &points[0][0][0], NULL, &surface));
    if (periodic)
        return surface;
    CHECK_OK(batten_surface_clamp(surface, BATTEN_U, &clamped));
    batten_surface_unref(surface);
    return clamped;
}

TEST(a_closed_spline_between_two_of_its_lines_gets_a_seam)
{
    for (int periodic = 0; periodic < 2; periodic++) {
        hand m = hand_begin();
        batten_body_trace_report report;
        batten_surface *tube = wavy_tube(periodic != 0);
        batten_surface *middle = NULL;
        batten_body *whole = NULL;
        CHECK_OK(batten_surface_subrange(tube, BATTEN_V, 0.25, 0.75, &middle));
        CHECK_OK(batten_body_from_surface("", middle, 1e-6, &whole));
        const double area = hand_area(whole);
        for (int k = 0; k < 2; k++) {
            batten_curve *ring = NULL, *low = NULL, *high = NULL, *turned = NULL;
            CHECK_OK(batten_surface_isocurve(tube, BATTEN_V, k ? 0.75 : 0.25, &ring));
            /* Begun elsewhere than the surface. */
            const batten_interval on = batten_curve_domain(ring);
            CHECK_OK(batten_curve_split(ring, on.a + 3.3 + k, &low, &high));
            CHECK_OK(batten_curve_join(high, low, 1e-9, &turned));
            batten_curve_unref(ring);
            batten_curve_unref(low);
            batten_curve_unref(high);
            hand_edge(&m, turned);
        }
        hand_face(&m, tube, false);
        HAND_LOOP(&m, 1);
        HAND_LOOP(&m, -2);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        CHECK_INT(report.seams, 1);
        CHECK_NEAR(hand_area(body), area, 1e-4);
        batten_body_unref(body);
        batten_body_unref(whole);
        batten_surface_unref(middle);
    }
}

/* A strip that goes around a cylinder two and a half times, and its area. */
static double winding_strip(hand *m)
{
    enum { COUNT = 121 };
    const double turns = 2.5, height = 6, width = 1;
    const int first = m->builder.parts.edge_count;
    double t[COUNT], values[COUNT][2][3];
    for (int k = 0; k < 2; k++) {
        batten_curve *helix = NULL;
        for (int i = 0; i < COUNT; i++) {
            const double angle = 2 * acos(-1) * turns * i / (COUNT - 1) + 0.4;
            t[i] = angle;
            values[i][0][0] = 2 * cos(angle);
            values[i][0][1] = 2 * sin(angle);
            values[i][0][2] = 1 + k * width + height * i / (COUNT - 1);
            values[i][1][0] = -2 * sin(angle);
            values[i][1][1] = 2 * cos(angle);
            values[i][1][2] = height / (2 * acos(-1) * turns);
        }
        CHECK_OK(batten_curve_from_hermite(3, COUNT, 2, t, &values[0][0][0], &helix));
        hand_edge(m, helix);
    }
    const double a = 0.4, b = 2 * acos(-1) * turns + 0.4;
    hand_line(m, 2 * cos(a), 2 * sin(a), 1, 2 * cos(a), 2 * sin(a), 1 + width);
    hand_line(m, 2 * cos(b), 2 * sin(b), 1 + height, 2 * cos(b), 2 * sin(b),
              1 + height + width);
    hand_face(m, hand_cylinder(2, 10), false);
    HAND_LOOP(m, first + 1, first + 4, -first - 2, -first - 3);
    return 2 * (b - a) * width;
}

TEST(a_strip_that_winds_around_is_cut_into_faces)
{
    hand m = hand_begin();
    batten_body_trace_report report;
    const double area = winding_strip(&m);
    batten_body *body = hand_trace(&m, 1e-4, &report);
    CHECK(batten_body_view(body)->face_count >= 3);
    CHECK_INT(report.failed, 0);
    CHECK_NEAR(hand_area(body), area, 1e-2);
    CHECK_INT(hand_shared(body), report.seams);
    batten_body_unref(body);
}

/* One that cannot be traced, one that becomes several, and one that stays itself. */
TEST(every_traced_face_knows_the_given_face_it_came_from)
{
    hand m = hand_begin();
    batten_body *body = NULL;
    bat_traced traced = {0};
    hand_line(&m, 0, 0, 20, 1, 0, 20);
    hand_line(&m, 1, 0, 20, 0, 1, 20.1);
    hand_line(&m, 0, 1, 20.1, 0, 0, 20);
    hand_plate(&m, 0, 0, 1, 1, 20);
    HAND_LOOP(&m, 1, 2, 3);
    winding_strip(&m);
    hand_line(&m, 0, 0, 30, 1, 0, 30);
    hand_line(&m, 1, 0, 30, 0, 1, 30);
    hand_line(&m, 0, 1, 30, 0, 0, 30);
    hand_plate(&m, 0, 0, 1, 1, 30);
    HAND_LOOP(&m, 8, 9, 10);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(bat_body_trace(body, 1e-4, NULL, NULL, NULL, &traced));
    const batten_body_parts *parts = batten_body_view(traced.body);
    CHECK(parts->face_count >= 4);
    for (int i = 0; i < parts->face_count; i++)
        CHECK_INT(bat_traced_number(&traced, i), i + 1 < parts->face_count ? 1 : 2);
    bat_traced_end(&traced);
    batten_body_unref(body);
}
