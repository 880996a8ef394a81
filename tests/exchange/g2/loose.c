/* Faces whose edges are farther off than the tolerance of their body. */
#include "body/builder.h"
#include "exchange/g2/g2.h"
#include "exchange/reading.h"

#include <batten/standard.h>

#include <stdlib.h>

/* A square of side 2 in the plane z = 0; one of its edges rises by that much in its middle. */
static batten_body *square_with_bulge(double height)
{
    static const double at[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    bat_builder b;
    batten_surface *plane = NULL;
    batten_body *body = NULL;
    int index;
    bat_builder_begin(&b, 1e-6);
    for (int i = 0; i < 4; i++)
        CHECK_OK(bat_builder_vertex(&b, at[i], &index));
    for (int i = 0; i < 4; i++) {
        const double *p = at[i], *q = at[(i + 1) % 4];
        const double points[9] = {
            p[0], p[1], 0, (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, i == 2 ? 2 * height : 0,
            q[0], q[1], 0};
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL,
                                     (double[]){0, 0, 0, 1, 1, 1}, &curve));
        CHECK_OK(bat_builder_edge(&b, curve, i, (i + 1) % 4, &index));
        batten_curve_unref(curve);
    }
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){2, 0, 0},
                                     (batten_vec3){0, 2, 0}, (batten_vec3){2, 2, 0}, &plane));
    CHECK_OK(bat_builder_shell(&b, false));
    CHECK_OK(bat_builder_face(&b, &(batten_body_face){.surface = plane}));
    CHECK_OK(bat_builder_loop(&b));
    for (int i = 0; i < 4; i++)
        CHECK_OK(bat_builder_use(&b, i, false, NULL));
    batten_surface_unref(plane);
    CHECK_OK(batten_body_create(&b.parts, &body));
    bat_builder_end(&b);
    return body;
}

/* Written and read again; *said: the writer told of it, where its note was not lost. */
static batten_body *pass_through_g2(batten_body *body, bool *said)
{
    batten_model *model = NULL, *back = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_G2;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "square", .kind = BATTEN_OBJECT_BODY, .body = body}));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    if (!batten_notes_dropped(notes))
        *said =
            has_note(notes, "the edges of 1 face are farther off it than the tolerance 1e-06");
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    batten_body *read = batten_body_ref(batten_model_object(back, 0)->body);
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(back);
    batten_model_unref(model);
    return read;
}

TEST(a_face_whose_edges_are_off_it_says_so_and_can_be_measured)
{
    static const double heights[] = {0, 0.02};
    for (int i = 0; i < 2; i++) {
        bool said = i == 1;
        batten_body *body = square_with_bulge(heights[i]);
        batten_body *read = pass_through_g2(body, &said);
        batten_body_measures m = {.area = 0};
        const double tolerance = batten_body_view(read)->tolerance;
        CHECK(said == (i == 1));
        CHECK(i == 1 ? tolerance >= 0.02 && tolerance < 0.04 : tolerance == 1e-6);
        CHECK_OK(batten_body_measure(read, 1e-6, NULL, &m));
        CHECK_NEAR(m.area, 4, 1e-6);
        batten_body_unref(read);
        batten_body_unref(body);
    }
}

/* The note on each of several bodies is about its own edges. */
TEST(each_body_says_its_own_largest_tolerance)
{
    static const double heights[] = {0.02, 0.01, 0};
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    int said = 0;
    options.format = BATTEN_FORMAT_G2;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < COUNT(heights); i++) {
        batten_body *body = square_with_bulge(heights[i]);
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = "b", .kind = BATTEN_OBJECT_BODY, .body = body}));
        batten_body_unref(body);
    }
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    const bool is_usual = test_cases(1000) >= 1000; /* else it is written twice */
    for (int i = 0; i < batten_notes_count(notes) && is_usual; i++) {
        const char *text = strstr(batten_notes_at(notes, i)->text, "tolerances up to ");
        if (text) /* half as much again as the edge is off, at 16 places */
            CHECK_NEAR(strtod(text + strlen("tolerances up to "), NULL), 1.5 * heights[said++],
                       0.05 * heights[0]);
    }
    CHECK(!is_usual || said == 2);
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* Curves on the plane that end beside their vertices, along it. */
TEST(edges_that_end_beside_their_vertices_are_loose_too)
{
    static const double beside[] = {0, 0.005, 0.01};
    for (int i = 0; i < COUNT(beside); i++) {
        batten_body *body = square_with_bulge(0);
        const batten_body_parts *from = batten_body_view(body);
        double vertices[12], tolerance = 0;
        batten_body_parts parts = *from;
        memcpy(vertices, from->vertices, sizeof vertices);
        vertices[3] +=
            beside[i]; /* x of the second, of one end of an edge and the start of another */
        parts.vertices = vertices;
        CHECK_OK(
            bat_g2_loop_tolerance(&parts, &parts.faces[0], parts.faces[0].surface, &tolerance));
        CHECK_NEAR(tolerance, i ? 1.5 * beside[i] : 1e-6, 1e-9);
        batten_body_unref(body);
    }
}
