/* Faces that are left out because of their borders in (u, v): which face, where, and how far. */
#include "mesh/faces/plane_scene.h"

#include <batten/standard.h>

static const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/* A face of the unit square whose edges have these parameters, one straight line after another. */
static void add_face(bat_builder *b, const char *name, const batten_surface *plane,
                     const double (*uv)[2])
{
    int vertices[4], edge;
    CHECK_OK(bat_builder_face(b, &(batten_body_face){.name = name, .surface = plane}));
    CHECK_OK(bat_builder_loop(b));
    for (int i = 0; i < 4; i++)
        CHECK_OK(
            bat_builder_vertex(b, (double[]){square[i][0], square[i][1], 0}, &vertices[i]));
    for (int i = 0; i < 4; i++) {
        const int next = (i + 1) % 4;
        const double from[3] = {square[i][0], square[i][1], 0};
        const double to[3] = {square[next][0], square[next][1], 0};
        batten_curve *line = NULL, *flat = NULL;
        CHECK_OK(batten_curve_line(3, from, to, &line));
        CHECK_OK(batten_curve_line(2, uv[i], uv[next], &flat));
        CHECK_OK(bat_builder_edge(b, line, vertices[i], vertices[next], &edge));
        CHECK_OK(bat_builder_use(b, edge, false, flat));
        batten_curve_unref(flat);
        batten_curve_unref(line);
    }
}

/* A good face, and one with these parameters. */
static batten_body *two_faces(const char *name, const double (*uv)[2])
{
    batten_surface *plane = NULL;
    batten_body *body = NULL;
    bat_builder b;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0},
                                     (batten_vec3){0, 1, 0}, (batten_vec3){1, 1, 0}, &plane));
    bat_builder_begin(&b, 1e-9);
    CHECK_OK(bat_builder_shell(&b, false));
    add_face(&b, "", plane, square);
    add_face(&b, name, plane, uv);
    batten_surface_unref(plane);
    b.parts.is_traced = true;
    const batten_status status = bat_builder_finish(&b, false, &body);
    if (test_memory_failed(status, BATTEN_OK))
        SKIP("no memory for the body");
    return body;
}

static const struct {
    double uv[4][2];
    const char *name, *entity, *text;
} rows[] = {
    {{{0, 0}, {5000, 0}, {1, 1}, {0, 1}},
     "",
     "face 2",
     "face 2 is left out of the mesh: its border runs to u = 5000, far outside its surface, which "
     "ends at 1; correct the curve that bounds it there"},
    {{{0, 0}, {1, 0}, {1, 1}, {-4000, 1}},
     "lid",
     "lid",
     "face 2 is left out of the mesh: its border runs to u = -4000, far outside its surface, "
     "which ends at 0"},
    {{{0, 0}, {1, 0}, {1, 3000}, {0, 1}},
     "",
     "face 2",
     "its border runs to v = 3000, far outside its surface, which ends at 1"},
    {{{0, -2000}, {1, 0}, {1, 1}, {0, 1}},
     "",
     "face 2",
     "its border runs to v = -2000, far outside its surface, which ends at 0"},
    {{{0, 0.25}, {1, 0.25}, {0.75, 0.25}, {0.5, 0.25}},
     "",
     "face 2",
     "its border is a line in (u, v), at v = 0.25"},
    {{{0.75, 0}, {0.75, 1}, {0.75, 0.7}, {0.75, 0.2}},
     "",
     "face 2",
     "its border is a line in (u, v), at u = 0.75"},
    {{{0, 0}, {1, 1}, {1, 0}, {0, 1}},
     "",
     "face 2",
     "its border crosses or touches itself in (u, v)"},
};

TEST(faces_with_borders_that_cannot_be_are_left_out_with_their_number_and_place)
{
    for (int i = 0; i < COUNT(rows); i++) {
        batten_body *body = two_faces(rows[i].name, rows[i].uv);
        batten_mesh_report report;
        batten_notes *notes = NULL;
        batten_mesh *mesh = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_mesh_from_body(body, NULL, NULL, notes, &report, &mesh));
        CHECK_INT(report.failed, 1);
        CHECK_INT(batten_mesh_view(mesh)->triangle_count, 2);
        CHECK_INT(batten_mesh_view(mesh)->faces[1], 0);
        CHECK(batten_notes_count(notes) + batten_notes_dropped(notes) >= 1);
        if (batten_notes_count(notes)) {
            CHECK_TEXT(batten_notes_at(notes, 0)->entity, rows[i].entity);
            CHECK_CONTAINS(batten_notes_at(notes, 0)->text, rows[i].text);
        }
        batten_notes_free(notes);
        batten_mesh_unref(mesh);
        batten_body_unref(body);
    }
}

/* A thousand widths are not yet far: such a border is tried. */
TEST(a_border_may_leave_its_surface_by_a_thousand_widths)
{
    static const double wide[4][2] = {{-999, -999}, {999, -999}, {999, 999}, {-999, 999}};
    batten_body *body = two_faces("", wide);
    batten_notes *notes = NULL;
    batten_mesh_report report;
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_mesh_from_body(body, NULL, NULL, notes, &report, &mesh));
    for (int i = 0; i < batten_notes_count(notes); i++)
        CHECK(!strstr(batten_notes_at(notes, i)->text, "far outside"));
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}

TEST(a_face_that_crosses_itself_is_left_out_with_a_note)
{
    static const double crossed[4][2] = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    static const double wider[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    plane_face s;
    batten_mesh_report report;
    batten_notes *notes = NULL;
    batten_mesh *mesh = NULL;
    plane_begin(&s, 2, 2);
    plane_polygon(&s, 4, crossed);
    CHECK_OK(
        bat_builder_face(&s.builder, &(batten_body_face){.name = "good", .surface = s.plane}));
    plane_polygon(&s, 4, wider);
    batten_body *body = plane_end(&s);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_mesh_from_body(body, NULL, NULL, notes, &report, &mesh));
    CHECK_INT(report.failed, 1);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 2);
    CHECK_INT(batten_mesh_view(mesh)->faces[0], 1);
    if (batten_notes_count(notes)) {
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "plane");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "crosses or touches itself");
    }
    batten_notes_free(notes);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}

/* However fine their samples, they stay on one another: that must not take time with the square
 * of the samples, nor go on beyond what is allowed. */
TEST(S3_a_border_that_lies_on_itself_is_given_up_in_time)
{
    plane_face s;
    batten_mesh *mesh = NULL;
    batten_mesh_report report;
    batten_mesh_options options = batten_mesh_defaults();
    options.most = 5000;
    plane_begin(&s, 4, 4);
    plane_circle(&s, 2, 2, 1.5, false);
    plane_circle(&s, 2, 2, 1, true);
    plane_circle(&s, 2, 2, 1, true);
    batten_body *body = plane_end(&s);
    CHECK_OK(batten_mesh_from_body(body, &options, NULL, NULL, &report, &mesh));
    CHECK_INT(report.failed, 1);
    CHECK_INT(batten_mesh_view(mesh)->triangle_count, 0);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}
