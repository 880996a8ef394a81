/* Triangles that are divided until they are near enough, and no further. */
#include "mesh/faces/plane_scene.h"

/* The surface (s^2, y, s^3): its normal is turned about along s = 0, at a cusp. */
static batten_body *cusp(void)
{
    const double u[] = {0, 0, 0, 0, 1, 1, 1, 1}, v[] = {0, 0, 2, 2};
    const double a = -0.371, b = 0.629; /* s there is in no middle */
    const double x[] = {a * a, (a * a + 2 * a * b) / 3, (b * b + 2 * a * b) / 3, b * b};
    const double z[] = {a * a * a, a * a * b, a * b * b, b * b * b};
    double points[8][3];
    const batten_axis along = {3, 4, u, false}, across = {1, 2, v, false};
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    for (int i = 0; i < 8; i++) {
        points[i][0] = x[i / 2];
        points[i][1] = i % 2 ? 2 : 0;
        points[i][2] = z[i / 2];
    }
    CHECK_OK(batten_surface_create(3, &along, &across, points[0], NULL, &surface));
    CHECK_OK(batten_body_from_surface("cusp", surface, 1e-9, &body));
    batten_surface_unref(surface);
    return body;
}

TEST(a_face_that_turns_about_is_divided_so_far_and_no_further)
{
    batten_mesh_report report;
    batten_mesh *mesh = NULL;
    batten_notes *notes = NULL;
    batten_mesh_options options = batten_mesh_defaults();
    batten_body *body = cusp();
    options.chord = 1e-5;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_mesh_from_body(body, &options, NULL, notes, &report, &mesh));
    CHECK_INT(report.failed, 0);
    CHECK(batten_mesh_view(mesh)->triangle_count < 100000);
    /* Twice where memory failed and it was meshed again. */
    CHECK(batten_notes_count(notes) + batten_notes_dropped(notes) >= 1);
    if (!batten_notes_dropped(notes))
        CHECK(strstr(batten_notes_at(notes, 0)->text, "face 1 was divided no further at"));
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}
/* A plane patch of which one coordinate is damaged: a needle around which the normal turns in
 * no length at all. */
TEST(S5_one_damaged_coordinate_does_not_divide_for_ever)
{
    static const int places[] = {2, 14, 8, 1};
    static const double values[] = {1e300, -1e300, 1e150, -1e200};
    for (int n = 0; n < COUNT(places); n++) {
        double points[16][3];
        batten_surface *needle = NULL;
        batten_mesh *mesh = NULL;
        const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
        const batten_axis axis = {.degree = 3, .point_count = 4, .knots = knots};
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                const double z = 5 / 3.0 + 0.0625 * i;
                double *point = points[4 * i + j];
                point[0] = 2;
                point[1] = i / 3.0 * (0.1875 + 0.8125 / 3 * j);
                point[2] = z + j / 3.0 * (0.5 - z);
            }
        points[places[n]][0] = values[n];
        CHECK_OK(batten_surface_create(3, &axis, &axis, points[0], NULL, &needle));
        CHECK_OK(batten_mesh_from_surface(needle, NULL, NULL, NULL, &mesh));
        CHECK(batten_mesh_view(mesh)->triangle_count < 200000);
        batten_mesh_unref(mesh);
        batten_surface_unref(needle);
    }
}
