/* What may be asked of a mesh, and what is made of the defaults. */
#include "support/bodies.h"
#include "support/test.h"

#include <batten/mesh.h>
#include <math.h>

/* Of size 7. */
static batten_body *box_of_seven(void)
{
    return test_box((batten_vec3){0, 0, 0}, (batten_vec3){2, 3, 6});
}

TEST(S1_options_that_cannot_be_met_are_refused_and_named)
{
    static const struct {
        double chord, angle, longest;
        int most;
        const char *words;
    } cases[] = {{-1, 1, 0, 100, "the chord is -1; it must not be below 0"},
                 {INFINITY, 1, 0, 100, "the chord is inf"},
                 {NAN, 1, 0, 100, "the chord is"},
                 {1e-16, 1, 0, 100, "a chord of 1e-16 is in the roundoff of a body of size 7"},
                 {1, 0, 0, 100, "the angle is 0; it must be above 0"},
                 {1, -1, 0, 100, "the angle is -1"},
                 {1, INFINITY, 0, 100, "the angle is inf"},
                 {1, NAN, 0, 100, "the angle is"},
                 {1, 1, -1, 100, "the longest edge is -1; it must not be below 0"},
                 {1, 1, INFINITY, 100, "the longest edge is inf"},
                 {1, 1, NAN, 100, "the longest edge is"},
                 {1, 1, 0, 0, "0 triangles are allowed"},
                 {1, 1, 0, -5, "-5 triangles are allowed"}};
    batten_body *body = box_of_seven();
    for (int i = 0; i < COUNT(cases); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh *mesh = NULL;
        options.chord = cases[i].chord;
        options.angle = cases[i].angle;
        options.longest = cases[i].longest;
        options.most = cases[i].most;
        CHECK_STATUS(batten_mesh_from_body(body, &options, NULL, NULL, NULL, &mesh),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(cases[i].words);
        CHECK(!mesh);
    }
    batten_body_unref(body);
}

TEST(without_a_chord_a_thousandth_of_the_size_is_asked_for)
{
    batten_body *body = box_of_seven();
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    CHECK_OK(batten_mesh_from_body(body, NULL, NULL, NULL, &report, &mesh));
    CHECK_NEAR(report.asked, 7e-3, 1e-15);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 12);
    CHECK_INT(batten_mesh_view(mesh)->vertex_count, 8);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}

TEST(as_many_triangles_as_are_allowed_may_be_used_and_not_one_more)
{
    batten_body *body = box_of_seven();
    batten_mesh_options options = batten_mesh_defaults();
    batten_mesh *mesh = NULL;
    options.most = 12;
    CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, NULL, &mesh));
    batten_mesh_unref(mesh);
    mesh = NULL;
    options.most = 11;
    CHECK_STATUS(batten_mesh_from_body(body, &options, NULL, NULL, NULL, &mesh),
                 BATTEN_TOO_LARGE);
    batten_body_unref(body);
}

TEST(no_edge_is_longer_than_the_longest)
{
    batten_body *body = box_of_seven();
    static const double lengths[] = {4, 2, 1};
    for (int i = 0; i < COUNT(lengths); i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_mesh *mesh = NULL;
        options.longest = lengths[i];
        CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, NULL, &mesh));
        const batten_mesh_parts *made = batten_mesh_view(mesh);
        for (int t = 0; t < made->triangle_count; t++)
            for (int k = 0; k < 3; k++) {
                const double *a = made->points + 3 * made->corners[3 * t + k];
                const double *b = made->points + 3 * made->corners[3 * t + (k + 1) % 3];
                CHECK(hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]) <=
                      lengths[i] * (1 + 1e-9));
            }
        batten_mesh_unref(mesh);
    }
    batten_body_unref(body);
}

TEST(surfaces_of_the_plane_are_not_meshed)
{
    const batten_axis axis = {1, 2, (const double[]){0, 0, 1, 1}, false};
    batten_surface *flat = NULL;
    batten_mesh *mesh = NULL;
    for (int d = 1; d <= 2; d++) {
        CHECK_OK(batten_surface_create(d, &axis, &axis,
                                       (const double[]){0, 0, 0, 1, 1, 0, 1, 1}, NULL, &flat));
        CHECK_STATUS(batten_mesh_from_surface(flat, NULL, NULL, NULL, &mesh),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(d == 1 ? "the surface has 1 dimension, not 3"
                             : "the surface has 2 dimensions, not 3");
        batten_surface_unref(flat);
    }
    CHECK(!mesh);
}
