#include "body/builder.h"
#include "body/traced.h"
#include "support/test.h"
#include <batten/body.h>
#include <batten/standard.h>
#include <stdlib.h>

/* ---- bodies by hand: edges by their curves, vertices found by place ---- */

typedef struct {
    bat_builder builder;
} model;

static model begin(void)
{
    model m;
    bat_builder_begin(&m.builder, 1e-6);
    CHECK_OK(bat_builder_shell(&m.builder, false));
    return m;
}

static int vertex_at(model *m, const double p[3])
{
    const batten_body_parts *parts = &m->builder.parts;
    int index = 0;
    for (int i = 0; i < parts->vertex_count; i++) {
        const double *q = parts->vertices + 3 * i;
        if (hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]) < 1e-9)
            return i;
    }
    CHECK_OK(bat_builder_vertex(&m->builder, p, &index));
    return index;
}

/* Takes the curve over. */
static int edge(model *m, batten_curve *curve)
{
    const batten_interval on = batten_curve_domain(curve);
    double a[3], b[3];
    int index = 0;
    CHECK_OK(batten_curve_evaluate(curve, on.a, 0, a));
    CHECK_OK(batten_curve_evaluate(curve, on.b, 0, b));
    const int start = vertex_at(m, a), end = vertex_at(m, b);
    CHECK_OK(bat_builder_edge(&m->builder, curve, start, end, &index));
    batten_curve_unref(curve);
    return index;
}

static int line(model *m, double x0, double y0, double z0, double x1, double y1, double z1)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_line(3, (double[]){x0, y0, z0}, (double[]){x1, y1, z1}, &curve));
    return edge(m, curve);
}

static const batten_frame WORLD = {.x = {1, 0, 0}, .z = {0, 0, 1}};

/* About the z-axis at this height, angles in degrees. */
static int arc(model *m, double radius, double z, double start, double angle)
{
    batten_frame frame = WORLD;
    batten_curve *curve = NULL;
    frame.origin.z = z;
    CHECK_OK(batten_curve_arc_in(&frame, radius, start * acos(-1) / 180, angle * acos(-1) / 180,
                                 &curve));
    return edge(m, curve);
}

/* Takes the surface over. */
static void face(model *m, batten_surface *surface, bool reversed)
{
    CHECK_OK(bat_builder_face(&m->builder,
                              &(batten_body_face){.surface = surface, .reversed = reversed}));
    batten_surface_unref(surface);
}

/* Edges from 1; a minus runs against the edge. */
static void loop(model *m, int count, const int *edges)
{
    CHECK_OK(bat_builder_loop(&m->builder));
    for (int i = 0; i < count; i++)
        CHECK_OK(bat_builder_use(&m->builder, abs(edges[i]) - 1, edges[i] < 0, NULL));
}
#define LOOP(m, ...) loop(m, COUNT(((int[]){__VA_ARGS__})), (int[]){__VA_ARGS__})

static batten_surface *cylinder(double radius, double height)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_cylinder(&WORLD, radius, height, &surface));
    return surface;
}

/* Trace it, look at what holds for all, and that it is the same the second time. */
static batten_body *trace(model *m, double tolerance, batten_trace_report *report)
{
    batten_body *body = NULL, *traced = NULL, *again = NULL;
    CHECK_OK(batten_body_create(&m->builder.parts, &body));
    bat_builder_end(&m->builder);
    CHECK_OK(batten_body_trace(body, tolerance, NULL, NULL, report, &traced));
    check_traced(traced, tolerance);
    CHECK(report->miss <= tolerance);
    CHECK_OK(batten_body_trace(traced, tolerance, NULL, NULL, NULL, &again));
    check_traced(again, tolerance);
    CHECK_INT(batten_body_view(again)->edge_count, batten_body_view(traced)->edge_count);
    CHECK_INT(batten_body_view(again)->use_count, batten_body_view(traced)->use_count);
    batten_body_unref(again);
    batten_body_unref(body);
    return traced;
}

/* How many edges have exactly two uses, one each way. */
static int shared(const batten_body *body)
{
    const batten_body_parts *p = batten_body_view(body);
    int count = 0;
    for (int e = 0; e < p->edge_count; e++) {
        int uses[2] = {0, 0};
        for (int i = 0; i < p->use_count; i++)
            if (p->uses[i].edge == e)
                uses[p->uses[i].reversed]++;
        count += uses[0] == 1 && uses[1] == 1;
    }
    return count;
}

static void plate(model *m, double x0, double y0, double x1, double y1, double z)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){x0, y0, z}, (batten_vec3){x1, y0, z},
                                     (batten_vec3){x0, y1, z}, (batten_vec3){x1, y1, z},
                                     &surface));
    face(m, surface, false);
}

TEST(an_edge_in_a_plane_is_traced_exactly)
{
    model m = begin();
    batten_trace_report report;
    line(&m, 0, 0, 1, 4, 0, 1);
    line(&m, 4, 0, 1, 4, 3, 1);
    line(&m, 4, 3, 1, 0, 3, 1);
    line(&m, 0, 3, 1, 0, 0, 1);
    batten_frame frame = WORLD;
    frame.origin = (batten_vec3){2, 1.5, 1};
    batten_curve *circle = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, 1, 0, 2 * acos(-1), &circle));
    edge(&m, circle);
    plate(&m, -1, -1, 5, 5, 1);
    LOOP(&m, 1, 2, 3, 4);
    LOOP(&m, -5);
    batten_body *body = trace(&m, 1e-6, &report);
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->face_count, 1);
    CHECK_INT(p->faces[0].count, 2);
    CHECK_INT(report.rebuilt, 5);
    CHECK_NEAR(report.miss, 0, 1e-15);
    const batten_curve *hole = p->uses[4].parameters, *of = p->edges[p->uses[4].edge].curve;
    CHECK_INT(batten_curve_knot_count(hole), batten_curve_knot_count(of));
    for (int i = 0; i < batten_curve_point_count(of); i++)
        CHECK_BITS(batten_curve_weights(hole)[i], batten_curve_weights(of)[i]);
    batten_body_unref(body);
}

TEST(loops_that_run_the_wrong_way_are_turned)
{
    for (int side = 0; side < 2; side++) {
        model m = begin();
        batten_trace_report report;
        line(&m, 0, 0, 0, 4, 0, 0);
        line(&m, 4, 0, 0, 4, 3, 0);
        line(&m, 4, 3, 0, 0, 0, 0);
        line(&m, 3, 1, 0, 3.5, 1, 0);
        line(&m, 3.5, 1, 0, 3.5, 1.5, 0);
        line(&m, 3.5, 1.5, 0, 3, 1, 0);
        plate(&m, 0, 0, 4, 4, 0);
        ((batten_body_face *)(uintptr_t)m.builder.parts.faces)[0].reversed = side;
        LOOP(&m, 4, 5, 6);
        LOOP(&m, -3, -2, -1);
        batten_body *body = trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        batten_body_unref(body);
    }
}

TEST(a_cylinder_with_a_seam_edge_keeps_it)
{
    model m = begin();
    batten_trace_report report;
    arc(&m, 2, 0, 0, 360);
    arc(&m, 2, 5, 0, 360);
    line(&m, 2, 0, 0, 2, 0, 5);
    face(&m, cylinder(2, 5), false);
    LOOP(&m, 1, 3, -2, -3);
    batten_body *body = trace(&m, 1e-6, &report);
    CHECK_INT(report.seams, 0);
    CHECK_INT(batten_body_view(body)->edge_count, 3);
    CHECK_INT(shared(body), 1);
    batten_body_unref(body);
}

TEST(a_seam_edge_elsewhere_than_that_of_the_surface_is_kept)
{
    model m = begin();
    batten_trace_report report;
    arc(&m, 2, 0, 50, 360);
    arc(&m, 2, 5, 50, 360);
    const double c = 2 * cos(50 * acos(-1) / 180), s = 2 * sin(50 * acos(-1) / 180);
    line(&m, c, s, 0, c, s, 5);
    face(&m, cylinder(2, 5), false);
    LOOP(&m, 1, 3, -2, -3);
    batten_body *body = trace(&m, 1e-6, &report);
    CHECK_INT(report.seams, 0);
    CHECK_INT(batten_body_view(body)->edge_count, 3);
    batten_body_unref(body);
}

/* With lids, so that the circles are shared. */
TEST(a_cylinder_between_two_circles_gets_a_seam)
{
    static const double starts[][2] = {{0, 0}, {90, 90}, {30, 30}, {10, 200}, {0, 180}};
    for (int i = 0; i < COUNT(starts); i++) {
        model m = begin();
        batten_trace_report report;
        arc(&m, 2, 0, starts[i][0], 360);
        arc(&m, 2, 5, starts[i][1], 360);
        face(&m, cylinder(2, 5), false);
        LOOP(&m, 1);
        LOOP(&m, -2);
        plate(&m, -3, -3, 3, 3, 0);
        ((batten_body_face *)(uintptr_t)m.builder.parts.faces)[1].reversed = true;
        LOOP(&m, -1);
        plate(&m, -3, -3, 3, 3, 5);
        LOOP(&m, 2);
        batten_body *body = trace(&m, 1e-6, &report);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 3);
        CHECK_INT(report.seams, 1);
        CHECK_INT(p->edge_count, starts[i][0] == starts[i][1] ? 3 : 4);
        CHECK_INT(shared(body), p->edge_count);
        batten_body_unref(body);
    }
}

TEST(half_cylinders_have_no_seam)
{
    static const double starts[] = {0, 90, 77, -90, 270.5};
    for (int i = 0; i < COUNT(starts); i++) {
        model m = begin();
        batten_trace_report report;
        const double at = starts[i] * acos(-1) / 180;
        const double c = 2 * cos(at), s = 2 * sin(at);
        arc(&m, 2, 0, starts[i], 180);
        arc(&m, 2, 5, starts[i], 180);
        arc(&m, 2, 0, starts[i] + 180, 180);
        arc(&m, 2, 5, starts[i] + 180, 180);
        line(&m, c, s, 0, c, s, 5);
        line(&m, -c, -s, 0, -c, -s, 5);
        face(&m, cylinder(2, 5), false);
        LOOP(&m, 1, 6, -2, -5);
        face(&m, cylinder(2, 5), false);
        LOOP(&m, 3, 5, -4, -6);
        batten_body *body = trace(&m, 1e-6, &report);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 2);
        CHECK_INT(p->edge_count, 6);
        CHECK_INT(report.seams, 0);
        CHECK_INT(shared(body), 2);
        batten_body_unref(body);
    }
}

/* A window from -20 to 30 degrees; as a face, and as a hole of the band. */
static void window(model *m, int first)
{
    const double a = -20 * acos(-1) / 180, b = 30 * acos(-1) / 180;
    CHECK_INT(m->builder.parts.edge_count, first - 1);
    arc(m, 2, 1, -20, 50);
    line(m, 2 * cos(b), 2 * sin(b), 1, 2 * cos(b), 2 * sin(b), 3);
    arc(m, 2, 3, -20, 50);
    line(m, 2 * cos(a), 2 * sin(a), 1, 2 * cos(a), 2 * sin(a), 3);
}

TEST(a_face_across_the_seam_of_a_cylinder_is_one_face_of_a_surface_with_another_seam)
{
    model m = begin();
    batten_trace_report report;
    window(&m, 1);
    face(&m, cylinder(2, 5), false);
    LOOP(&m, 1, 2, -3, -4);
    batten_body *body = trace(&m, 1e-6, &report);
    CHECK_INT(batten_body_view(body)->face_count, 1);
    CHECK_INT(batten_body_view(body)->edge_count, 4);
    CHECK_INT(report.seams, 0);
    batten_body_unref(body);
}

TEST(a_hole_across_the_seam_of_a_band_moves_the_seam)
{
    model m = begin();
    batten_trace_report report;
    arc(&m, 2, 0, 0, 360);
    arc(&m, 2, 5, 0, 360);
    window(&m, 3);
    face(&m, cylinder(2, 5), false);
    LOOP(&m, 1);
    LOOP(&m, -2);
    LOOP(&m, 6, 5, -4, -3);
    face(&m, cylinder(2, 5), true);
    LOOP(&m, 3, 4, -5, -6);
    batten_body *body = trace(&m, 1e-6, &report);
    CHECK_INT(batten_body_view(body)->face_count, 2);
    CHECK_INT(report.seams, 1);
    batten_body_unref(body);
}

TEST(a_sphere_without_loops_gets_its_border)
{
    model m = begin();
    batten_trace_report report;
    batten_surface *sphere = NULL;
    CHECK_OK(batten_surface_sphere(&WORLD, 2, &sphere));
    face(&m, sphere, true);
    batten_body *body = trace(&m, 1e-6, &report);
    CHECK_INT(report.seams, 1);
    CHECK_INT(report.poles, 2);
    CHECK_INT(batten_body_view(body)->edge_count, 3);
    batten_body_unref(body);
}

TEST(hemispheres_get_a_seam_and_a_pole)
{
    for (int side = 0; side < 2; side++) {
        model m = begin();
        batten_trace_report report;
        batten_surface *sphere = NULL;
        arc(&m, 2, 0, 10, 360);
        CHECK_OK(batten_surface_sphere(&WORLD, 2, &sphere));
        face(&m, sphere, false);
        LOOP(&m, side ? -1 : 1);
        batten_body *body = trace(&m, 1e-6, &report);
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
        batten_body_unref(body);
    }
}

TEST(a_circle_on_a_sphere_bounds_a_cap_or_all_but_a_cap)
{
    for (int side = 0; side < 2; side++) {
        model m = begin();
        batten_trace_report report;
        batten_surface *sphere = NULL;
        batten_curve *circle = NULL;
        const batten_frame frame = {.origin = {1.6, 0, 0}, .x = {0, 1, 0}, .z = {1, 0, 0}};
        CHECK_OK(batten_curve_arc_in(&frame, 1.2, 0.3, 2 * acos(-1), &circle));
        edge(&m, circle);
        CHECK_OK(batten_surface_sphere(&WORLD, 2, &sphere));
        face(&m, sphere, false);
        LOOP(&m, side ? -1 : 1);
        batten_body *body = trace(&m, 1e-6, &report);
        const batten_body_parts *p = batten_body_view(body);
        CHECK_INT(p->face_count, 1);
        CHECK_INT(p->faces[0].count, side ? 2 : 1);
        CHECK_INT(report.poles, side ? 2 : 0);
        CHECK_INT(report.seams, side ? 1 : 0);
        batten_body_unref(body);
    }
}

TEST(an_octant_of_a_sphere_has_a_pole)
{
    model m = begin();
    batten_trace_report report;
    batten_surface *sphere = NULL;
    batten_curve *curve = NULL;
    const batten_frame xz = {.x = {1, 0, 0}, .z = {0, -1, 0}},
                       yz = {.x = {0, 1, 0}, .z = {1, 0, 0}};
    arc(&m, 2, 0, 0, 90);
    CHECK_OK(batten_curve_arc_in(&yz, 2, 0, acos(-1) / 2, &curve));
    edge(&m, curve);
    CHECK_OK(batten_curve_arc_in(&xz, 2, 0, acos(-1) / 2, &curve));
    edge(&m, curve);
    CHECK_OK(batten_surface_sphere(&WORLD, 2, &sphere));
    face(&m, sphere, false);
    LOOP(&m, 1, 2, -3);
    batten_body *body = trace(&m, 1e-6, &report);
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->edge_count, 4);
    CHECK_INT(report.poles, 1);
    batten_body_unref(body);
}

TEST(a_circle_through_a_pole_is_divided_there)
{
    model m = begin();
    batten_trace_report report;
    batten_surface *sphere = NULL;
    batten_curve *circle = NULL;
    /* The circle in the plane x + z = 2 of the sphere: through (0, 0, 2) and (2, 0, 0). */
    const double h = sqrt(0.5);
    const batten_frame frame = {.origin = {1, 0, 1}, .x = {0, 1, 0}, .z = {h, 0, h}};
    CHECK_OK(batten_curve_arc_in(&frame, sqrt(2), 0.2, 2 * acos(-1), &circle));
    edge(&m, circle);
    CHECK_OK(batten_surface_sphere(&WORLD, 2, &sphere));
    face(&m, sphere, false);
    LOOP(&m, 1);
    batten_body *body = trace(&m, 1e-5, &report);
    CHECK_INT(batten_body_view(body)->face_count, 1);
    CHECK_INT(report.poles, 1);
    batten_body_unref(body);
}

TEST(a_cone_from_its_rim_to_its_apex_gets_a_seam)
{
    for (int turned = 0; turned < 2; turned++) {
        model m = begin();
        batten_trace_report report;
        batten_surface *cone = NULL;
        arc(&m, 2, 0, 70, 360);
        CHECK_OK(batten_surface_cone(&WORLD, 2, 0, 3, &cone));
        face(&m, cone, false);
        LOOP(&m, turned ? -1 : 1);
        batten_body *body = trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->edge_count, 3);
        CHECK_INT(report.seams, 1);
        CHECK_INT(report.poles, 1);
        batten_body_unref(body);
    }
}

static batten_surface *torus(void)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_torus(&WORLD, 3, 1, &surface));
    return surface;
}

TEST(bands_around_a_torus_get_a_seam)
{
    for (int side = 0; side < 2; side++) {
        model m = begin();
        batten_trace_report report;
        /* The circles on top and below, outside or inside of which the band is. */
        arc(&m, 3, 1, 20, 360);
        arc(&m, 3, -1, 50, 360);
        face(&m, torus(), false);
        LOOP(&m, side ? 1 : -1);
        LOOP(&m, side ? -2 : 2);
        batten_body *body = trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        CHECK(report.seams >= 1 && report.seams <= 2);
        batten_body_unref(body);
    }
}

TEST(a_pipe_bend_between_two_circles_gets_a_seam)
{
    for (int side = 0; side < 2; side++) {
        model m = begin();
        batten_trace_report report;
        batten_curve *circle = NULL;
        const batten_frame first = {.origin = {3, 0, 0}, .x = {1, 0, 0}, .z = {0, -1, 0}};
        const batten_frame second = {.origin = {0, 3, 0}, .x = {0, 1, 0}, .z = {1, 0, 0}};
        CHECK_OK(batten_curve_arc_in(&first, 1, 0.4, 2 * acos(-1), &circle));
        edge(&m, circle);
        CHECK_OK(batten_curve_arc_in(&second, 1, 1.4, 2 * acos(-1), &circle));
        edge(&m, circle);
        face(&m, torus(), false);
        LOOP(&m, side ? 1 : -1);
        LOOP(&m, side ? -2 : 2);
        batten_body *body = trace(&m, 1e-6, &report);
        CHECK_INT(batten_body_view(body)->face_count, 1);
        CHECK(report.seams >= 1 && report.seams <= 2);
        batten_body_unref(body);
    }
}
