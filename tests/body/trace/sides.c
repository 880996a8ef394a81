/* Which way loops run, which loops are holes of which face, and planes that grow to their loops. */
#include "body/by_hand.h"
#include "body/trace/chart.h"
#include "support/test.h"

#include <batten/standard.h>

/* Trace a body as it is; its notes stay. */
static batten_body *trace_with_notes(hand *m, batten_body_trace_report *report,
                                     batten_notes **notes)
{
    batten_body *body = NULL, *traced = NULL;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    CHECK_OK(batten_notes_create(10, notes));
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, *notes, report, &traced));
    batten_body_unref(body);
    return traced;
}

/* With failing memory the same may be said again, or be dropped. */
static void check_said(const batten_notes *notes, const char *words)
{
    if (batten_notes_dropped(notes) > 0)
        return;
    CHECK(batten_notes_count(notes) > 0);
    for (int i = 0; i < batten_notes_count(notes); i++)
        CHECK_CONTAINS(batten_notes_at(notes, i)->text, words);
}

static void put_rectangle(hand *m, double x0, double y0, double x1, double y1)
{
    hand_line(m, x0, y0, 0, x1, y0, 0);
    hand_line(m, x1, y0, 0, x1, y1, 0);
    hand_line(m, x1, y1, 0, x0, y1, 0);
    hand_line(m, x0, y1, 0, x0, y0, 0);
}

/* ---- planes ---- */

/* The plane of the first three is crooked in space: (u, v) is at (3, 1, 2) + u (2, 0, 1) + v (0, 1, 1). */
static batten_surface *slanting_plane(void)
{
    batten_surface *plane = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){3, 1, 2}, (batten_vec3){5, 1, 3},
                                     (batten_vec3){3, 2, 3}, (batten_vec3){5, 2, 4}, &plane));
    return plane;
}

static void place(double u, double v, double at[3])
{
    at[0] = 3 + 2 * u;
    at[1] = 1 + v;
    at[2] = 2 + u + v;
}

TEST(a_plane_grows_to_its_loop_on_each_side_alone)
{
    static const double windows[][4] = {{-1.5, 0.25, 0.75, 0.75}, {0.25, -2, 0.75, 0.75},
                                        {0.25, 0.25, 2.5, 0.75},  {0.25, 0.25, 0.75, 4},
                                        {-1, -0.5, 3, 2},         {0.25, 0.25, 0.5, 0.5}};
    for (int i = 0; i < COUNT(windows); i++) {
        const double *w = windows[i];
        const double corners[4][2] = {{w[0], w[1]}, {w[2], w[1]}, {w[2], w[3]}, {w[0], w[3]}};
        hand m = hand_begin();
        batten_body_trace_report report;
        for (int k = 0; k < 4; k++) {
            double a[3], b[3];
            place(corners[k][0], corners[k][1], a);
            place(corners[(k + 1) % 4][0], corners[(k + 1) % 4][1], b);
            hand_line(&m, a[0], a[1], a[2], b[0], b[1], b[2]);
        }
        hand_face(&m, slanting_plane(), false);
        HAND_LOOP(&m, 1, 2, 3, 4);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 1);
        const batten_surface *plane = p->faces[0].surface;
        const batten_interval u = batten_surface_domain(plane, BATTEN_U),
                              v = batten_surface_domain(plane, BATTEN_V);
        CHECK_NEAR(u.a, fmin(0, w[0]), 1e-12);
        CHECK_NEAR(u.b, fmax(1, w[2]), 1e-12);
        CHECK_NEAR(v.a, fmin(0, w[1]), 1e-12);
        CHECK_NEAR(v.b, fmax(1, w[3]), 1e-12);
        for (int k = 0; k < 4; k++) {
            const double at[2] = {k % 2 ? u.b : u.a, k / 2 ? v.b : v.a};
            double q[3], due[3];
            place(at[0], at[1], due);
            CHECK_OK(batten_surface_evaluate(plane, at[0], at[1], 0, q));
            for (int j = 0; j < 3; j++)
                CHECK_NEAR(q[j], due[j], 1e-11);
        }
        batten_body_unref(body);
    }
}

TEST(a_plane_grows_ten_thousand_times_and_no_more)
{
    static const double far[] = {9999.5, 10001.5};
    for (int k = 0; k < 8; k++) {
        const double to = far[k / 4];
        const bool low = k % 2, along_v = k / 2 % 2;
        hand m = hand_begin();
        batten_body_trace_report report;
        batten_notes *notes = NULL;
        const double a = low ? 1 - to : 0.25, b = low ? 0.75 : to;
        put_rectangle(&m, along_v ? 0.25 : a, along_v ? a : 0.25, along_v ? 0.75 : b,
                      along_v ? b : 0.75);
        hand_plate(&m, 0, 0, 1, 1, 0);
        HAND_LOOP(&m, 1, 2, 3, 4);
        batten_body *body = trace_with_notes(&m, &report, &notes);
        CHECK_INT(report.failed, k / 4);
        CHECK_INT(batten_body_view(body)->face_count, 1 - k / 4);
        if (report.failed) {
            char words[120];
            snprintf(words, sizeof words,
                     "a loop runs to %c = %g, where its plane has 0 to 1: a coordinate",
                     along_v ? 'v' : 'u', low ? a : b);
            check_said(notes, words);
        }
        batten_notes_free(notes);
        batten_body_unref(body);
    }
}

/* ---- loops ---- */

TEST(a_hole_that_runs_as_its_outer_loop_is_turned)
{
    for (int last = 0; last < 2; last++) {
        hand m = hand_begin();
        batten_body_trace_report report;
        batten_notes *notes = NULL;
        put_rectangle(&m, 0, 0, 4, 4);
        put_rectangle(&m, 1, 1, 2, 2);
        hand_plate(&m, 0, 0, 4, 4, 0);
        if (last)
            HAND_LOOP(&m, 5, 6, 7, 8);
        HAND_LOOP(&m, 1, 2, 3, 4);
        if (!last)
            HAND_LOOP(&m, 5, 6, 7, 8);
        batten_body *body = trace_with_notes(&m, &report, &notes);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 1);
        CHECK_INT(p->loop_count, 2);
        for (int i = 0; i < p->use_count; i++)
            CHECK_INT(p->uses[i].reversed, i >= 4);
        CHECK_NEAR(hand_area(body), 15, 1e-9);
        check_said(notes, "a hole runs counter-clockwise; it was turned");
        batten_notes_free(notes);
        batten_body_unref(body);
    }
}

/* The lower circle has to have the surface on its left, and the upper one against it. */
TEST(of_two_circles_around_a_cylinder_those_that_run_the_wrong_way_are_turned)
{
    static const char *const words[] = {
        "", "its two loops run around it the same way; one was turned",
        "its two loops run around it the same way; one was turned",
        "its loops run clockwise as seen from its outside; they were turned"};
    for (int k = 0; k < 8; k++) {
        const int wrong = k % 4, swap = k / 4;
        hand m = hand_begin();
        batten_body_trace_report report;
        batten_notes *notes = NULL;
        hand_arc(&m, 2, 1, 0, 360);
        hand_arc(&m, 2, 4, 0, 360);
        hand_face(&m, hand_cylinder(2, 5), false);
        const int low[1] = {wrong & 1 ? -1 : 1}, high[1] = {wrong & 2 ? 2 : -2};
        hand_loop(&m, 1, swap ? high : low);
        hand_loop(&m, 1, swap ? low : high);
        batten_body *body = trace_with_notes(&m, &report, &notes);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 1);
        CHECK_INT(p->loop_count, 1);
        CHECK_INT(report.seams, 1);
        for (int i = 0; i < p->use_count; i++)
            if (p->uses[i].edge < 2)
                CHECK_INT(p->uses[i].reversed, p->uses[i].edge == 1);
        CHECK_NEAR(hand_area(body), 12 * acos(-1), 1e-5);
        if (wrong)
            check_said(notes, words[wrong]);
        else
            CHECK_INT(batten_notes_count(notes), 0);
        batten_notes_free(notes);
        batten_body_unref(body);
    }
}

/* A window of a cylinder of radius 2, from 40 to 80 degrees, of height 1/2. */
static void put_window(hand *m, double z)
{
    const int first = m->builder.parts.edge_count + 1;
    const double a = 40 * acos(-1) / 180, b = 80 * acos(-1) / 180;
    hand_arc(m, 2, z, 40, 40);
    hand_line(m, 2 * cos(b), 2 * sin(b), z, 2 * cos(b), 2 * sin(b), z + 0.5);
    hand_arc(m, 2, z + 0.5, 40, 40);
    hand_line(m, 2 * cos(a), 2 * sin(a), z, 2 * cos(a), 2 * sin(a), z + 0.5);
    HAND_LOOP(m, first + 3, first + 2, -first - 1, -first);
}

/* Two bands given as one face, with a window in one of them or in each. */
static void check_bands(int turn)
{
    for (int windows = 1; windows < 4; windows++) {
        hand m = hand_turned(turn);
        batten_body_trace_report report;
        static const double z[4] = {1, 2, 3, 4};
        for (int i = 0; i < 4; i++)
            hand_arc(&m, 2, z[i], 0, 360);
        hand_face(&m, hand_cylinder(2, 5), false);
        for (int k = 0; k < 2; k++)
            if (windows >> k & 1)
                put_window(&m, k ? 3.25 : 1.25);
        HAND_LOOP(&m, 1);
        HAND_LOOP(&m, -2);
        HAND_LOOP(&m, 3);
        HAND_LOOP(&m, -4);
        batten_body *body = hand_trace(&m, 1e-6, &report);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 2);
        for (int f = 0; f < p->face_count; f++) {
            const batten_body_use *outer = &p->uses[p->loops[p->faces[f].first].first];
            bool upper = false;
            for (int i = 0; i < p->loops[p->faces[f].first].count; i++)
                upper = upper || outer[i].edge == 2 || outer[i].edge == 3;
            CHECK_INT(p->faces[f].count, 1 + (windows >> upper & 1));
        }
        const double window = 2 * 40 * acos(-1) / 180 * 0.5;
        CHECK_NEAR(hand_area(body), 8 * acos(-1) - (windows == 3 ? 2 : 1) * window, 1e-5);
        batten_body_unref(body);
    }
}

TEST(of_two_bands_in_one_face_each_keeps_the_windows_in_it)
{
    for (int turn = 0; turn < 8; turn += 3)
        check_bands(turn);
}

/* ---- charts ---- */

static batten_status miss_of(const batten_surface *surface, const batten_curve *curve,
                             int places, double *miss)
{
    bat_chart chart;
    batten_status status = bat_chart_begin(surface, 1e-6, &chart);
    if (status == BATTEN_OK)
        status = bat_chart_miss(&chart, curve, places, miss);
    bat_chart_end(&chart);
    return status;
}

/* A line that climbs off the plane z = 0: of 4 places, at 1/8, 3/8, 5/8 and 7/8, the last is the farthest. */
TEST(a_curve_is_as_far_off_a_chart_as_its_farthest_place)
{
    batten_surface *plane = NULL;
    batten_curve *line = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){4, 0, 0},
                                     (batten_vec3){0, 4, 0}, (batten_vec3){4, 4, 0}, &plane));
    for (int back = 0; back < 2; back++) {
        const double ends[2][3] = {{1, 1, 0.25}, {3, 2, 8.25}};
        double miss = -1;
        CHECK_OK(batten_curve_line(3, ends[back], ends[!back], &line));
        CHECK_OK(miss_of(plane, line, 4, &miss));
        CHECK_NEAR(miss, 7.25, 1e-12);
        CHECK_OK(miss_of(plane, line, 1, &miss));
        CHECK_NEAR(miss, 4.25, 1e-12);
        batten_curve_unref(line);
    }
    batten_surface_unref(plane);
}
