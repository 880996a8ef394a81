#include "support/surfaces.h"
#include "support/test.h"

#include <batten/mesh.h>
#include <batten/standard.h>

static const double PI = 3.14159265358979323846;

static batten_mesh_options with_chord(double chord)
{
    batten_mesh_options options = batten_mesh_defaults();
    options.chord = chord;
    return options;
}

/* Mesh, check, and give the mesh back when the caller does not want it. */
static batten_mesh_facts mesh_of(batten_surface *surface, const batten_mesh_options *options,
                                 batten_mesh_report *report, batten_mesh **out)
{
    batten_mesh *mesh = NULL;
    batten_mesh_facts facts;
    CHECK_OK(batten_mesh_from_surface(surface, options, NULL, report, &mesh));
    CHECK_OK(batten_mesh_check(mesh, &facts));
    CHECK_INT(report->failed, 0);
    CHECK_INT(facts.wrong_edges + facts.crowded_edges + facts.loose_vertices, 0);
    CHECK_INT(facts.flat_triangles, 0);
    batten_surface_unref(surface);
    if (out)
        *out = mesh;
    else
        batten_mesh_unref(mesh);
    return facts;
}

TEST(a_sphere_is_closed_and_near)
{
    const batten_frame world = batten_frame_world();
    const double chords[] = {0.2, 0.05, 0.01, 1e-3, 3e-4};
    for (int i = 0; i < COUNT(chords); i++) {
        const batten_mesh_options options = with_chord(chords[i]);
        batten_surface *sphere = NULL;
        batten_mesh_report report;
        CHECK_OK(batten_surface_sphere(&world, 2, &sphere));
        const batten_mesh_facts f = mesh_of(sphere, &options, &report, NULL);
        CHECK(f.is_watertight);
        CHECK_INT(f.euler, 2);
        CHECK_INT(f.pieces, 1);
        CHECK(report.chord <= chords[i]);
        CHECK(report.angle <= options.angle * 1.0001);
        CHECK(f.volume < 32 * PI / 3);
        CHECK(f.volume > 32 * PI / 3 - 16 * PI * chords[i]);
        CHECK_NEAR(f.centroid[2], 0, chords[i]);
    }
}

TEST(a_torus_has_a_hole)
{
    const batten_frame world = batten_frame_world();
    const batten_mesh_options options = with_chord(0.01);
    batten_surface *torus = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_surface_torus(&world, 3, 1, &torus));
    const batten_mesh_facts f = mesh_of(torus, &options, &report, NULL);
    CHECK(f.is_watertight);
    CHECK_INT(f.euler, 0);
    CHECK(report.chord <= 0.01);
    CHECK_NEAR(f.volume, 6 * PI * PI, 0.01 * 12 * PI * PI);
}

/* z = f(x, y) over the unit square, bicubic through a grid of control points. */
static batten_surface *wavy(int count, double height)
{
    batten_surface *surface = NULL;
    const int n = count;
    double *points = test_array((size_t)(n * n), 3 * sizeof *points);
    double *knots = test_array((size_t)(n + 4), sizeof *knots);
    for (int i = 0; i < n + 4; i++)
        knots[i] = i < 4 ? 0 : i >= n ? n - 3 : i - 3;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double *p = &points[3 * (i * n + j)];
            p[0] = i / (n - 1.0);
            p[1] = j / (n - 1.0);
            p[2] = height * sin(5 * p[0]) * cos(7 * p[1]);
        }
    const batten_axis axis = {.degree = 3, .point_count = n, .knots = knots};
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

TEST(a_wavy_surface_is_near)
{
    const batten_mesh_options options = with_chord(3e-5);
    batten_mesh_report report;
    const batten_mesh_facts f = mesh_of(wavy(40, 0.1), &options, &report, NULL);
    CHECK_INT(f.euler, 1);
    CHECK(report.chord <= 3e-5);
}

static double distance_to_triangle(const double *p, const double *a, const double *b,
                                   const double *c)
{
    /* The nearest of many points of the triangle: slow and plain. */
    double best = HUGE_VAL;
    enum { STEPS = 24 };
    for (int i = 0; i <= STEPS; i++)
        for (int j = 0; i + j <= STEPS; j++) {
            double square = 0;
            for (int k = 0; k < 3; k++) {
                const double x = (i * a[k] + j * b[k] + (STEPS - i - j) * c[k]) / STEPS;
                square += (x - p[k]) * (x - p[k]);
            }
            best = fmin(best, sqrt(square));
        }
    return best;
}

TEST(points_of_a_triangle_are_near_the_surface)
{
    const batten_frame world = batten_frame_world();
    const batten_mesh_options options = with_chord(0.01);
    batten_surface *torus = NULL;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    test_random random = test_random_begin("points_of_a_triangle_are_near_the_surface");
    CHECK_OK(batten_surface_torus(&world, 3, 1, &torus));
    mesh_of(torus, &options, &report, &mesh);
    const batten_mesh_parts *m = batten_mesh_view(mesh);
    for (int t = 0; t < m->triangle_count; t++)
        for (int i = 0; i < 3; i++) {
            double w[3], sum = 0, p[3] = {0, 0, 0};
            for (int k = 0; k < 3; k++)
                sum += w[k] = test_random_unit(&random) + 1e-6;
            for (int k = 0; k < 9; k++)
                p[k % 3] += w[k / 3] / sum * m->points[3 * m->corners[3 * t + k / 3] + k % 3];
            const double off = fabs(hypot(hypot(p[0], p[1]) - 3, p[2]) - 1);
            CHECK(off <= 0.01);
        }
    batten_mesh_unref(mesh);
}

TEST(a_surface_is_near_the_triangles)
{
    batten_surface *surface = wavy(8, 0.4);
    const batten_mesh_options options = with_chord(0.01);
    batten_mesh_report report;
    batten_mesh *mesh = NULL;
    test_random random = test_random_begin("a_surface_is_near_the_triangles");
    batten_surface *kept = batten_surface_ref(surface);
    mesh_of(surface, &options, &report, &mesh);
    const batten_mesh_parts *m = batten_mesh_view(mesh);
    for (int i = 0; i < test_cases(40); i++) {
        double p[3], best = HUGE_VAL;
        CHECK_OK(batten_surface_evaluate(kept, test_random_in(&random, 0, 5),
                                         test_random_in(&random, 0, 5), 0, p));
        for (int t = 0; t < m->triangle_count; t++) {
            const double *c[3];
            for (int k = 0; k < 3; k++)
                c[k] = &m->points[3 * m->corners[3 * t + k]];
            const double near = hypot(p[0] - c[0][0], p[1] - c[0][1]);
            if (near < 0.3)
                best = fmin(best, distance_to_triangle(p, c[0], c[1], c[2]));
        }
        CHECK(best <= 0.013); /* the samples of a triangle are up to 0.007 apart */
    }
    batten_surface_unref(kept);
    batten_mesh_unref(mesh);
}

TEST(cylinders_cones_and_paraboloids_meet_at_their_seams)
{
    const batten_frame world = batten_frame_world();
    const batten_mesh_options options = with_chord(0.01);
    batten_surface *surface = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_surface_cylinder(&world, 1, 20, &surface));
    batten_mesh_facts f = mesh_of(surface, &options, &report, NULL);
    CHECK_INT(f.euler, 0);
    CHECK_NEAR(f.area, 40 * PI, 40 * PI * 0.01);
    CHECK(f.edges < 400); /* nothing bends along the axis */
    CHECK(report.chord <= 0.01);
    CHECK_OK(batten_surface_cone(&world, 1, 0, 2, &surface));
    f = mesh_of(surface, &options, &report, NULL);
    CHECK_INT(f.euler, 1);
    CHECK(report.chord <= 0.01);
    CHECK_NEAR(f.area, PI * sqrt(5), 0.05);
    CHECK_OK(batten_surface_paraboloid(&world, 1, 2, 3, &surface));
    f = mesh_of(surface, &options, &report, NULL);
    CHECK_INT(f.euler, 1);
    CHECK(report.chord <= 0.01);
}

TEST(a_plane_is_two_triangles)
{
    batten_surface *plane = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){3, 0, 0},
                                     (batten_vec3){0, 2, 0}, (batten_vec3){3, 2, 0}, &plane));
    batten_mesh *mesh = NULL;
    const batten_mesh_facts f = mesh_of(plane, NULL, &report, &mesh);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 2);
    CHECK_NEAR(f.area, 6, 1e-15);
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(batten_mesh_view(mesh)->normals[3 * i + 2], 1, 0);
    CHECK_NEAR(report.chord, 0, 1e-15);
    batten_mesh_unref(mesh);
}

TEST(normals_are_those_of_the_surface_also_at_poles)
{
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    mesh_of(sphere, NULL, &report, &mesh);
    const batten_mesh_parts *m = batten_mesh_view(mesh);
    for (int i = 0; i < 9 * m->triangle_count; i++)
        CHECK_NEAR(m->normals[i], m->points[3 * m->corners[i / 3] + i % 3], 1e-6);
    batten_mesh_unref(mesh);
}

TEST(long_edges_are_divided)
{
    batten_surface *plane = NULL;
    batten_mesh_report report;
    batten_mesh *mesh = NULL;
    batten_mesh_options options = batten_mesh_defaults();
    options.longest = 0.5;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){3, 0, 0},
                                     (batten_vec3){0, 2, 0}, (batten_vec3){3, 2, 0}, &plane));
    const batten_mesh_facts f = mesh_of(plane, &options, &report, &mesh);
    CHECK_NEAR(f.area, 6, 1e-14);
    const batten_mesh_parts *m = batten_mesh_view(mesh);
    for (int i = 0; i < 3 * m->triangle_count; i++) {
        const double *a = &m->points[3 * m->corners[i]];
        const double *b = &m->points[3 * m->corners[i % 3 == 2 ? i - 2 : i + 1]];
        CHECK(hypot(a[0] - b[0], a[1] - b[1]) <= 0.5 * 1.0000001);
    }
    batten_mesh_unref(mesh);
}

TEST(S5_what_cannot_be_meshed_is_refused_before_the_work)
{
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    batten_mesh *mesh = NULL;
    batten_mesh_options options = with_chord(1e-10);
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    CHECK_STATUS(batten_mesh_from_surface(sphere, &options, NULL, NULL, &mesh),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("10000000 are allowed");
    options = with_chord(1e-4);
    options.most = 1000;
    CHECK_STATUS(batten_mesh_from_surface(sphere, &options, NULL, NULL, &mesh),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("1000 are allowed, for which no chord would do"); /* the angle asks for 900 */
    options.most = 20000;
    CHECK_STATUS(batten_mesh_from_surface(sphere, &options, NULL, NULL, &mesh),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("20000 are allowed, for which a chord of 0.0016 would do");
    options.chord = 0.0016;
    CHECK_OK(batten_mesh_from_surface(sphere, &options, NULL, NULL, &mesh));
    batten_mesh_unref(mesh);
    mesh = NULL;
    options = with_chord(1e-17);
    CHECK_STATUS(batten_mesh_from_surface(sphere, &options, NULL, NULL, &mesh),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("roundoff");
    options = with_chord(NAN);
    CHECK_STATUS(batten_mesh_from_surface(sphere, &options, NULL, NULL, &mesh),
                 BATTEN_BAD_ARGUMENT);
    options = batten_mesh_defaults();
    options.angle = 0;
    CHECK_STATUS(batten_mesh_from_surface(sphere, &options, NULL, NULL, &mesh),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("angle");
    batten_surface_unref(sphere);
    CHECK(mesh == NULL);
}

TEST(spheres_of_any_size_are_meshed)
{
    const double sizes[] = {1e80, 1e-80};
    for (int i = 0; i < 2; i++) {
        const batten_frame world = batten_frame_world();
        batten_surface *sphere = NULL;
        batten_mesh_report report;
        CHECK_OK(batten_surface_sphere(&world, sizes[i], &sphere));
        const batten_mesh_facts f = mesh_of(sphere, NULL, &report, NULL);
        CHECK(f.is_watertight);
        CHECK(report.chord <= 3.5e-3 * sizes[i]);
    }
}

static bool cancel(void *user)
{
    return --*(int *)user < 0;
}

TEST(meshing_can_be_cancelled)
{
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    batten_mesh *mesh = NULL;
    int left = 20;
    batten_job job = BATTEN_JOB;
    job.is_cancelled = cancel;
    job.user = &left;
    const batten_mesh_options options = with_chord(1e-4);
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    const batten_status status = batten_mesh_from_surface(sphere, &options, &job, NULL, &mesh);
    CHECK(status == BATTEN_CANCELLED || status == BATTEN_OUT_OF_MEMORY);
    batten_surface_unref(sphere);
}
