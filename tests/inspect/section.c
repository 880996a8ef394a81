#include "inspect/shapes.h"

#include <batten/nearest.h>

/* Every point on the plane and on the surface at its parameters, and no two neighbours equal.
 */
static void check_lines(const batten_surface *surface, batten_vec3 n, double offset,
                        const batten_polylines *lines)
{
    for (int l = 0; l < lines->count; l++) {
        const batten_polyline *line = &lines->lines[l];
        CHECK(line->count >= 2);
        for (int i = 0; i < line->count; i++) {
            const double *p = line->points + 3 * i;
            double at[3];
            CHECK_NEAR(n.x * p[0] + n.y * p[1] + n.z * p[2], offset, 1e-13);
            CHECK_OK(batten_surface_evaluate(surface, line->parameters[2 * i],
                                             line->parameters[2 * i + 1], 0, at));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(at[k], p[k], 1e-14);
            if (i > 0)
                CHECK(hypot(hypot(p[0] - p[-3], p[1] - p[-2]), p[2] - p[-1]) > 1e-13);
        }
    }
}

static double length_of(const batten_polyline *line)
{
    double length = 0;
    for (int i = line->closed ? 0 : 1; i < line->count; i++) {
        const double *a = line->points + 3 * i;
        const double *b = line->points + 3 * (i > 0 ? i - 1 : line->count - 1);
        length += hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
    }
    return length;
}

TEST(a_sphere_is_cut_in_circles_across_its_seam)
{
    const batten_vec3 normals[] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0.6, 0, 0.8}};
    const double offsets[] = {0, 0.5, -1.25, 1.9};
    batten_surface *sphere = NULL;
    CHECK_OK(shape_torus(0, 2, true, &sphere));
    for (int i = 0; i < COUNT(normals); i++)
        for (int j = 0; j < COUNT(offsets); j++) {
            batten_polylines lines = {0};
            CHECK_OK(batten_surface_section(sphere, normals[i], offsets[j], 64, 48, &lines));
            check_lines(sphere, normals[i], offsets[j], &lines);
            double length = 0;
            for (int l = 0; l < lines.count; l++) {
                length += length_of(&lines.lines[l]);
                for (int k = 0; k < lines.lines[l].count; k++) {
                    const double *p = lines.lines[l].points + 3 * k;
                    CHECK_NEAR(p[0] * p[0] + p[1] * p[1] + p[2] * p[2], 4, 1e-12);
                }
            }
            const double whole = 2 * PI * sqrt(4 - offsets[j] * offsets[j]);
            CHECK_NEAR(length, whole, 0.02 * whole);
            if (offsets[j] != 0) { /* planes that miss the poles leave one loop */
                CHECK_INT(lines.count, 1);
                CHECK(lines.lines[0].closed);
            }
            batten_polylines_release(&lines);
        }
    batten_surface_unref(sphere);
}

TEST(a_torus_is_cut_in_two_loops_or_one_and_the_saddle_is_decided)
{
    /* planes parallel to the axis: beyond the hole one oval, through the ring two */
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(3, 1, false, &torus));
    const double offsets[] = {0.3, 1.5, 2.5, 3.5};
    const int loops[] = {2, 2, 1, 1};
    for (int k = 0; k < COUNT(offsets); k++) {
        batten_polylines lines = {0};
        const batten_vec3 n = {1, 0, 0};
        CHECK_OK(batten_surface_section(torus, n, offsets[k], 60, 60, &lines));
        check_lines(torus, n, offsets[k], &lines);
        CHECK_INT(lines.count, loops[k]);
        for (int l = 0; l < lines.count; l++)
            CHECK(lines.lines[l].closed);
        batten_polylines_release(&lines);
    }
    batten_surface_unref(torus);
}

/* The bilinear patch z = x y over [-1, 1]^2, or a plane z = x. */
static void make_patch(bool saddle, batten_surface **out)
{
    const double z[2][4] = {{-1, -1, 1, 1}, {1, -1, -1, 1}}, knots[4] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    double points[12];
    for (int i = 0; i < 4; i++) {
        points[3 * i] = i / 2 * 2 - 1;
        points[3 * i + 1] = i % 2 * 2 - 1;
        points[3 * i + 2] = z[saddle][i];
    }
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, out));
}

TEST(nodes_on_the_plane_make_neither_gaps_nor_repeated_points)
{
    /* z = x cut at grid lines, at both rims, and between */
    const double offsets[] = {0, -1, 1, 0.5, 0.3};
    batten_surface *plane = NULL;
    make_patch(false, &plane);
    for (int k = 0; k < COUNT(offsets); k++) {
        batten_polylines lines = {0};
        const batten_vec3 n = {0, 0, 1};
        CHECK_OK(batten_surface_section(plane, n, offsets[k], 8, 8, &lines));
        check_lines(plane, n, offsets[k], &lines);
        CHECK_INT(lines.count, 1);
        CHECK(!lines.lines[0].closed);
        CHECK_INT(lines.lines[0].count, 9);
        CHECK_NEAR(length_of(&lines.lines[0]), 2, 1e-12);
        batten_polylines_release(&lines);
    }
    batten_surface_unref(plane);
}

TEST(the_branches_of_a_saddle_do_not_cross)
{
    batten_surface *saddle = NULL;
    make_patch(true, &saddle);
    const double offsets[] = {0.01, -0.01, 0.25};
    for (int k = 0; k < COUNT(offsets); k++)
        for (int cells = 1; cells < 8; cells += 2) {
            batten_polylines lines = {0};
            const batten_vec3 n = {0, 0, 1};
            CHECK_OK(batten_surface_section(saddle, n, offsets[k], cells, cells, &lines));
            check_lines(saddle, n, offsets[k], &lines);
            CHECK_INT(lines.count, 2);
            for (int l = 0; l < 2; l++)
                for (int i = 1; i < lines.lines[l].count;
                     i++) /* x keeps its sign along a branch */
                    CHECK(lines.lines[l].points[0] * lines.lines[l].points[3 * i] > 0);
            batten_polylines_release(&lines);
        }
    batten_surface_unref(saddle);
}

TEST(a_plane_that_misses_gives_nothing_and_a_bad_one_is_refused)
{
    batten_surface *plane = NULL;
    batten_polylines lines = {0};
    const batten_vec3 up = {0, 0, 1}, none = {0, 0, 0}, bad = {NAN, 0, 0};
    make_patch(false, &plane);
    CHECK_OK(batten_surface_section(plane, up, 7, 4, 4, &lines));
    CHECK_INT(lines.count, 0);
    batten_polylines_release(&lines);
    CHECK_STATUS(batten_surface_section(plane, none, 0, 4, 4, &lines), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_section(plane, bad, 0, 4, 4, &lines), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_section(plane, up, 0, 0, 4, &lines), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_section(plane, up, 0, 100000, 100000, &lines),
                 BATTEN_TOO_LARGE);
    batten_surface_unref(plane);
}

/* Rounding is that of the coordinates: a torus is cut alike whatever its size. */
TEST(a_torus_of_any_size_is_cut_in_the_same_lines)
{
    static const double sizes[] = {1e-12, 1e-6, 1e6, 1e12},
                        offsets[] = {0, 0.5, 1.75, 2.5, 3.9};
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(3, 1, false, &torus));
    for (int i = 0; i < COUNT(sizes); i++) {
        const double s = sizes[i];
        batten_surface *other = NULL;
        CHECK_OK(shape_torus(3 * s, s, false, &other));
        for (int k = 0; k < COUNT(offsets); k++) {
            const batten_vec3 normal = {0.6, 0, 0.8};
            batten_polylines lines = {0}, scaled = {0};
            CHECK_OK(batten_surface_section(torus, normal, offsets[k], 24, 20, &lines));
            CHECK_OK(batten_surface_section(other, normal, s * offsets[k], 24, 20, &scaled));
            CHECK_INT(scaled.count, lines.count);
            for (int l = 0; l < lines.count; l++) {
                CHECK_INT(scaled.lines[l].count, lines.lines[l].count);
                CHECK_INT(scaled.lines[l].closed, lines.lines[l].closed);
                CHECK_NEAR(length_of(&scaled.lines[l]) / s, length_of(&lines.lines[l]), 1e-9);
            }
            batten_polylines_release(&lines);
            batten_polylines_release(&scaled);
        }
        batten_surface_unref(other);
    }
    batten_surface_unref(torus);
}

TEST(planes_and_cells_that_cannot_be_are_refused_each)
{
    static const double knots[4] = {0, 0, 1, 1}, flat[8] = {0, 0, 0, 1, 1, 0, 1, 1};
    static const batten_vec3 normals[] = {
        {NAN, 0, 1}, {0, INFINITY, 1}, {1, 0, NAN}, {0, 0, 1}};
    const batten_axis axis = {1, 2, knots, false};
    const batten_vec3 up = {0, 0, 1};
    batten_surface *plane = NULL, *space = NULL;
    batten_polylines lines = {0};
    CHECK_OK(batten_surface_create(2, &axis, &axis, flat, NULL, &plane));
    CHECK_OK(shape_torus(0, 2, true, &space));
    CHECK_STATUS(batten_surface_section(plane, up, 0, 4, 4, &lines), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("a surface in 2 dimensions has no plane section");
    for (int i = 0; i < 4; i++)
        CHECK_STATUS(
            batten_surface_section(space, normals[i], i == 3 ? (double)NAN : 0, 4, 4, &lines),
            BATTEN_NOT_FINITE);
    for (int i = 0; i < 2; i++)
        CHECK_STATUS(batten_surface_section(space, up, 0, i ? 4 : 0, i ? 0 : 4, &lines),
                     BATTEN_BAD_ARGUMENT);
    CHECK(lines.count == 0 && !lines.lines);
    batten_surface_unref(plane);
    batten_surface_unref(space);
}
