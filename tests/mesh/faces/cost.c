/* The work for triangles grows with their number, by the steps that a job counts. */
#include "body/builder.h"
#include "support/test.h"

#include <batten/mesh.h>
#include <batten/standard.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* ---- a face with one border of many corners, on z = (u^2 + bend v^2) / 2 ---- */

/* The height at a point, or, between two points, of the control point of their line. */
static double height(double bend, const double *a, const double *b)
{
    return (a[0] * b[0] + bend * a[1] * b[1]) / 2;
}

static batten_surface *trough(double bend)
{
    static const double knots[] = {-2, -2, -2, 2, 2, 2};
    static const double places[3] = {-2, 0, 2}, heights[3] = {2, -2, 2};
    const batten_axis axis = {2, 3, knots, false};
    double points[9][3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 9; i++) {
        points[i][0] = places[i / 3];
        points[i][1] = places[i % 3];
        points[i][2] = heights[i / 3] + bend * heights[i % 3];
    }
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0], NULL, &surface));
    return surface;
}

/* An edge that is straight in (u, v). */
static void add_line(bat_builder *builder, double bend, const double *a, const double *b,
                     const int ends[2])
{
    static const double straight[] = {0, 0, 1, 1}, bent[] = {0, 0, 0, 1, 1, 1};
    const double flat[2][2] = {{a[0], a[1]}, {b[0], b[1]}};
    const double lifted[3][3] = {{a[0], a[1], height(bend, a, a)},
                                 {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, height(bend, a, b)},
                                 {b[0], b[1], height(bend, b, b)}};
    batten_curve *curve = NULL, *parameters = NULL;
    int edge;
    CHECK_OK(batten_curve_create((batten_points){3, 3, lifted[0]}, 2, NULL, bent, &curve));
    CHECK_OK(
        batten_curve_create((batten_points){2, 2, flat[0]}, 1, NULL, straight, &parameters));
    CHECK_OK(bat_builder_edge(builder, curve, ends[0], ends[1], &edge));
    CHECK_OK(bat_builder_use(builder, edge, false, parameters));
    batten_curve_unref(parameters);
    batten_curve_unref(curve);
}

static batten_body *face_within(int count, const double (*corners)[2], double bend)
{
    bat_builder builder;
    batten_body *body = NULL;
    batten_surface *surface = trough(bend);
    bat_builder_begin(&builder, 1e-9);
    CHECK_OK(bat_builder_shell(&builder, false));
    CHECK_OK(bat_builder_face(&builder, &(batten_body_face){.surface = surface}));
    CHECK_OK(bat_builder_loop(&builder));
    for (int i = 0, vertex; i < count; i++) {
        const double *c = corners[i];
        CHECK_OK(
            bat_builder_vertex(&builder, (double[]){c[0], c[1], height(bend, c, c)}, &vertex));
    }
    for (int i = 0; i < count; i++) {
        const int ends[2] = {i, (i + 1) % count};
        add_line(&builder, bend, corners[i], corners[ends[1]], ends);
    }
    batten_surface_unref(surface);
    builder.parts.is_traced = true;
    const batten_status status = bat_builder_finish(&builder, false, &body);
    if (test_memory_failed(status, BATTEN_OK))
        SKIP("no memory for the body");
    CHECK(status == BATTEN_OK);
    return body;
}

/* ---- steps ---- */

/* So many steps for each triangle do, however many there are. The chord is such that there are
 * about as many triangles along the border as corners, in about sixteen rows. */
static void check_cost(void (*draw)(int count, double (*corners)[2]), int steps_each)
{
    for (int count = 400; count <= 6400; count *= 16) {
        const double square = (double)count * count;
        double(*corners)[2] = test_array((size_t)count, sizeof *corners);
        batten_mesh_options options = batten_mesh_defaults();
        batten_job job = BATTEN_JOB;
        batten_mesh *mesh = NULL, *again = NULL;
        options.chord = 40 / square;
        options.angle = 1;
        draw(count, corners);
        batten_body *body = face_within(count, (const double(*)[2])corners, 5000 / square);
        CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, NULL, &mesh));
        const int triangles = batten_mesh_view(mesh)->triangle_count;
        CHECK(triangles > count);
        job.work_limit = (uint64_t)steps_each * (uint64_t)triangles;
        CHECK_OK(batten_mesh_from_body(body, &options, &job, NULL, NULL, &again));
        CHECK_INT(batten_mesh_view(again)->triangle_count, triangles);
        batten_mesh_unref(again);
        batten_mesh_unref(mesh);
        batten_body_unref(body);
    }
}

static void draw_waves(int count, double (*corners)[2])
{
    for (int i = 0; i < count; i++) {
        const double angle = 2 * PI * i / count, radius = 1.5 + 0.3 * sin(11 * angle);
        corners[i][0] = radius * cos(angle);
        corners[i][1] = radius * sin(angle);
    }
}

TEST(the_cost_within_a_long_wavy_border)
{
    check_cost(draw_waves, 12);
}

/* Its long sides are bent within rounding. */
static void draw_rectangle(int count, double (*corners)[2])
{
    const int half = count / 2;
    for (int i = 0; i < count; i++) {
        const double x = -1.5 + 3.0 * (i % half) / (half - 1), y = 1 - 1e-15 * (x * x);
        corners[i][0] = i < half ? x : -x;
        corners[i][1] = i < half ? -y : y;
    }
}

TEST(the_cost_within_a_border_that_is_straight_but_for_rounding)
{
    check_cost(draw_rectangle, 12);
}

/* An L: lower side, right side, and two that bend within rounding, in the middle of the box and
 * at its left. */
static void draw_l(int count, double (*corners)[2])
{
    const int part = count / 4;
    for (int i = 0; i < count; i++) {
        const double x = 1.5 * (i % part) / part, bend = 1e-16 * sin(31 * x);
        const double places[4][2] = {
            {-1.5 + 2 * x, -1}, {1.5, -1 + x * 2 / 3}, {1.5 - x, bend}, {-x, 1 - x * 4 / 3}};
        memcpy(corners[i], places[i / part], sizeof corners[i]);
    }
}

TEST(the_cost_beside_an_inner_border_that_is_straight_but_for_rounding)
{
    check_cost(draw_l, 12);
}

TEST(one_surface_has_the_same_mesh_on_any_number_of_threads)
{
    static const int threads[] = {1, 2, 7};
    const batten_frame world = batten_frame_world();
    batten_mesh_options options = batten_mesh_defaults();
    batten_surface *torus = NULL;
    batten_mesh *meshes[3];
    options.chord = 6e-4;
    CHECK_OK(batten_surface_torus(&world, 1, 0.3, &torus));
    for (int k = 0; k < COUNT(threads); k++) {
        batten_job job = BATTEN_JOB;
        job.thread_count = threads[k];
        CHECK_OK(batten_mesh_from_surface(torus, &options, &job, NULL, &meshes[k]));
        const batten_mesh_parts *one = batten_mesh_view(meshes[0]),
                                *here = batten_mesh_view(meshes[k]);
        CHECK_INT(here->vertex_count, one->vertex_count);
        CHECK_INT(here->triangle_count, one->triangle_count);
        CHECK_INT(memcmp(here->points, one->points,
                         (size_t)one->vertex_count * 3 * sizeof *one->points),
                  0);
        CHECK_INT(memcmp(here->corners, one->corners,
                         (size_t)one->triangle_count * 3 * sizeof *one->corners),
                  0);
    }
    for (int k = 0; k < COUNT(threads); k++)
        batten_mesh_unref(meshes[k]);
    batten_surface_unref(torus);
}
