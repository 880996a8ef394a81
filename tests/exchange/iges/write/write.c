#include "exchange/shapes.h"

#include "support/drilled_box.h"

#include <batten/mesh.h>
#include <batten/standard.h>
#include <stdio.h>
#include <stdlib.h>

static void check_records(const char *data, size_t size)
{
    CHECK(size % 81 == 0);
    for (size_t i = 80; i < size; i += 81)
        CHECK(data[i] == '\n' && strchr("SGDPT", data[i - 8]));
}

TEST(what_is_written_reads_back_bit_for_bit_and_writes_the_same_bytes)
{
    static const double units[] = {1, 0.001, 0.0254, 0.3048, 0.01};
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(60); i++) {
        batten_model *model = random_model(&random, units[i % 5]), *back = NULL;
        char *first = NULL, *second = NULL;
        size_t first_size = 0, second_size = 0;
        CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &first, &first_size));
        check_records(first, first_size);
        CHECK_OK(read_bytes(first, first_size, BATTEN_FORMAT_AUTO, NULL, &back));
        check_same_model(model, back);
        CHECK_OK(write_bytes(back, BATTEN_FORMAT_IGES, &second, &second_size));
        CHECK_INT((long long)second_size, (long long)first_size);
        CHECK(memcmp(first, second, first_size) == 0);
        batten_release(first);
        batten_release(second);
        batten_model_unref(back);
        batten_model_unref(model);
    }
}

static batten_model *model_with(const batten_curve *curve, double unit)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit, &model));
    add_curve(model, "keel", curve);
    return model;
}

static batten_model *round_trip(const batten_model *model)
{
    char *data = NULL;
    size_t size = 0;
    batten_model *back = NULL;
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &data, &size));
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    batten_release(data);
    return back;
}

TEST(a_periodic_curve_is_written_clamped)
{
    const double points[] = {0, 0, 2, 0, 2, 2, 0, 2}, knots[] = {0, 1, 2, 3, 4};
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){2, 4, points}, 3, NULL, knots, &curve));
    batten_model *model = model_with(curve, 1), *back = round_trip(model);
    const batten_curve *read = batten_model_object(back, 0)->curve;
    CHECK(batten_curve_is_clamped(read));
    CHECK_INT(batten_curve_dimension(read), 3);
    for (int i = 0; i <= 40; i++) {
        double p[2], q[3];
        CHECK_OK(batten_curve_evaluate(curve, i / 10.0, 0, p));
        CHECK_OK(batten_curve_evaluate(read, i / 10.0, 0, q));
        CHECK_NEAR(q[0], p[0], 1e-14);
        CHECK_NEAR(q[1], p[1], 1e-14);
    }
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(curve);
}

TEST(a_model_without_a_unit_is_written_as_mm_with_a_note)
{
    test_random random = test_random_begin(__func__);
    batten_curve *curve = random_curve(&random);
    const double units[] = {0, 2.5};
    for (int i = 0; i < 2; i++) {
        batten_model *model = model_with(curve, units[i]), *back = round_trip(model);
        CHECK_BITS(batten_model_unit_metres(back), 0.001);
        const double first = batten_curve_points(curve)[0];
        CHECK_NEAR(batten_curve_points(batten_model_object(back, 0)->curve)[0],
                   i ? 2500 * first : first, 1e-9 * fabs(first));
        batten_model_unref(back);
        batten_model_unref(model);
    }
    batten_curve_unref(curve);
}

TEST(N5_minus_0_and_denormal_numbers_pass_through_IGES)
{
    const double points[] = {-0.0, 4.9e-324, 1e-300, 1e300, -2.2250738585072014e-308, 0.1};
    const double knots[] = {-0.0, -0.0, 1e-310, 1e-310};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &curve));
    batten_model *model = model_with(curve, 1), *back = round_trip(model);
    check_same_model(model, back);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(curve);
}

TEST(what_IGES_cannot_hold_is_noted)
{
    const batten_table_point side = {0, 1, 2, -1};
    const batten_table_station station = {"0", 0, 1, &side};
    batten_offset_table *offsets = NULL;
    batten_model *model = NULL, *back = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_IGES;
    options.date = "2026-11-21T10:25:30";
    test_random random = test_random_begin(__func__);
    batten_curve *curve = random_curve(&random);
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 1, &station, &offsets));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "table",
                                                      .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                                      .offset_table = offsets}));
    CHECK_OK(batten_model_add(
        model,
        &(batten_object){.name = "two\nlines", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    CHECK(batten_notes_dropped(notes) ||
          has_note(notes, "left out: IGES files hold points, curves, surfaces and bodies"));
    CHECK(strstr(data, "15H20261121.102530") != NULL);
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_TEXT(batten_model_object(back, 0)->name, "two lines");
    batten_release(data);
    batten_notes_free(notes);
    batten_offset_table_unref(offsets);
    batten_curve_unref(curve);
    batten_model_unref(back);
    batten_model_unref(model);
}

/* Writing what was read gives the same bytes. */
static void check_twice(const batten_model *model)
{
    batten_model *back = NULL;
    char *first = NULL, *second = NULL;
    size_t first_size = 0, second_size = 0;
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &first, &first_size));
    check_records(first, first_size);
    CHECK_OK(read_bytes(first, first_size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_OK(write_bytes(back, BATTEN_FORMAT_IGES, &second, &second_size));
    CHECK_INT((long long)second_size, (long long)first_size);
    CHECK(memcmp(first, second, first_size) == 0);
    batten_release(first);
    batten_release(second);
    batten_model_unref(back);
}

TEST(points_groups_levels_and_what_is_hidden_read_back)
{
    static const struct {
        const char *name, *group, *layer;
        bool is_hidden;
        int count;
    } rows[] = {{"keel", "", "", false, 1},
                {"stem", "hull", "12", true, 2},
                {"bilge", "hull/port", "7", false, 7},
                {"chine", "hull/port", "", true, 3},
                {"boom", "rig", "spars and sails", false, 1},
                {"mast", "rig", "3", false, 1}};
    const double points[] = {1, 2, 3, -0.0, 0.1, 1e-9, 7, 8, 9, 1, 1,
                             1, 2, 2, 2,    3,   3,    3, 4, 4, 4};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = rows[i].name,
                                                          .group = rows[i].group,
                                                          .layer = rows[i].layer,
                                                          .is_hidden = rows[i].is_hidden,
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = rows[i].count,
                                                          .points = points}));
    batten_model *back = round_trip(model);
    CHECK_INT(batten_model_count(back), COUNT(rows));
    for (int i = 0; i < COUNT(rows); i++) {
        const batten_object *object = batten_model_object(back, i);
        CHECK_TEXT(object->name, rows[i].name);
        CHECK_TEXT(object->group, rows[i].group);
        CHECK_TEXT(object->layer, rows[i].layer);
        CHECK_INT(object->is_hidden, rows[i].is_hidden);
        CHECK_INT(object->kind, BATTEN_OBJECT_POINTS);
        CHECK_INT(object->point_count, rows[i].count);
        CHECK(memcmp(object->points, points, (size_t)rows[i].count * 3 * sizeof *points) == 0);
    }
    check_twice(model);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(layers_with_names_get_levels_beyond_those_with_numbers)
{
    static const char *const layers[] = {"rig", "40", "hull", "rig", "007", "0"};
    const double point[] = {1, 2, 3};
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < COUNT(layers); i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "p",
                                                          .layer = layers[i],
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 1,
                                                          .points = point}));
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_IGES, &data, &size));
    check_records(data, size);
    const char *at = data;
    static const char *const texts[] = {"406,2,41,1H0;", "406,2,42,3H007;", "406,2,43,4Hhull;",
                                        "406,2,44,3Hrig;"};
    for (int i = 0; i < COUNT(texts); i++) {
        at = strstr(at, texts[i]);
        CHECK(at != NULL);
    }
    CHECK(strstr(data, "     406       1       0       0      41") != NULL);
    CHECK(strstr(data, "     406       4       0       0      44") != NULL);
    CHECK(strstr(data, "     116       6       0       0      44") != NULL);
    batten_release(data);
    batten_model_unref(model);
}

/* How many entries of the type the directory has. */
static int entries(const char *data, int type)
{
    char field[16];
    int count = 0;
    snprintf(field, sizeof field, "%8d", type);
    for (const char *at = data; *at; at += 81)
        count += at[72] == 'D' && memcmp(at, field, 8) == 0;
    return count / 2;
}

TEST(faces_are_trimmed_surfaces_in_a_group)
{
    batten_body *body = NULL;
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_IGES;
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "block", .kind = BATTEN_OBJECT_BODY, .body = body}));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    check_records(data, size);
    CHECK_INT(entries(data, 144), DRILLED_FACES);
    CHECK_INT(entries(data, 142), DRILLED_FACES + 2);
    CHECK_INT(entries(data, 102), 2 * (DRILLED_FACES + 2));
    CHECK_INT(entries(data, 110) + entries(data, 126), 2 * DRILLED_USES);
    CHECK_INT(entries(data, 402), 1);
    CHECK(strstr(data, "7Hblock.7;") != NULL);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "its 8 faces are written as trimmed surfaces"));
    batten_release(data);
    batten_notes_free(notes);
    batten_body_unref(body);
    batten_model_unref(model);
}

/* Within the faces of all objects, as they are turned: a sixth of the triangles' determinants.
 */
static double volume_of_faces(const batten_model *model)
{
    double six = 0;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        const batten_mesh_options options = batten_mesh_defaults();
        batten_mesh *mesh = NULL;
        CHECK_INT(object->kind, BATTEN_OBJECT_BODY);
        CHECK_OK(batten_mesh_from_body(object->body, &options, NULL, NULL, NULL, &mesh));
        const batten_mesh_parts *m = batten_mesh_view(mesh);
        for (int t = 0; t < m->triangle_count; t++) {
            const double *a = m->points + 3 * m->corners[3 * t];
            const double *b = m->points + 3 * m->corners[3 * t + 1];
            const double *c = m->points + 3 * m->corners[3 * t + 2];
            six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
        batten_mesh_unref(mesh);
    }
    return six / 6;
}

TEST(faces_keep_their_outside_on_surfaces_that_are_reversed_for_them)
{
    const double hole = 2 * acos(-1);
    batten_body *body = NULL;
    batten_model *model = NULL;
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "block", .kind = BATTEN_OBJECT_BODY, .body = body}));
    batten_model *back = round_trip(model);
    CHECK_NEAR(volume_of_faces(back), 48 - hole, 0.05);
    const batten_body_parts *wall = batten_body_view(batten_model_object(back, 6)->body);
    CHECK(!wall->faces[0].reversed);
    CHECK_BITS(batten_surface_domain(wall->faces[0].surface, BATTEN_U).a, -2);
    check_twice(model);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_body_unref(body);
}

TEST(edges_that_miss_their_vertices_are_moved_to_them)
{
    static const double miss = 0.05;
    double vertices[DRILLED_VERTICES][3];
    batten_body *body = NULL, *loose = NULL;
    batten_model *model = NULL, *back = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_IGES;
    CHECK_OK(drilled_box(&body));
    batten_body_parts parts = *batten_body_view(body);
    memcpy(vertices, drilled_vertices, sizeof vertices);
    vertices[7][0] += miss; /* in the plane of the top and of the back */
    parts.vertices = vertices[0];
    parts.tolerance = miss;
    CHECK_OK(batten_body_create(&parts, &loose));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "block", .kind = BATTEN_OBJECT_BODY, .body = loose}));
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "ends of edges that miss their vertices, by 0.05 at most: 3"));
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_INT(batten_model_count(back), DRILLED_FACES);
    const batten_body_parts *top = batten_body_view(batten_model_object(back, 5)->body);
    int met = 0;
    for (int k = 0; k < top->vertex_count; k++)
        met += memcmp(top->vertices + 3 * k, vertices[7], sizeof vertices[7]) == 0;
    CHECK_INT(met, 1);
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_body_unref(loose);
    batten_body_unref(body);
}

TEST(faces_of_bodies_read_back_and_write_the_same_bytes)
{
    const batten_frame frame = batten_frame_world();
    batten_body *bodies[2] = {NULL, NULL};
    batten_surface *sphere = NULL;
    batten_model *model = NULL;
    CHECK_OK(drilled_box(&bodies[0]));
    CHECK_OK(batten_surface_sphere(&frame, 2, &sphere));
    CHECK_OK(batten_body_from_surface("ball", sphere, 1e-6, &bodies[1]));
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "ball" : "block",
                                                          .group = "parts",
                                                          .layer = "solids",
                                                          .kind = BATTEN_OBJECT_BODY,
                                                          .body = bodies[i]}));
    check_twice(model);
    batten_model *back = round_trip(model);
    CHECK_INT(batten_model_count(back), DRILLED_FACES + 1);
    CHECK_TEXT(batten_model_object(back, 6)->name, "block.7");
    CHECK(!batten_model_object(back, 6)->has_colour);
    CHECK(batten_model_object(back, 5)->has_colour);
    for (int k = 0; k < 3; k++) /* that of the face */
        CHECK_NEAR(batten_model_object(back, 5)->colour[k], 1 - 0.5 * k, 0);
    CHECK_TEXT(batten_model_object(back, 6)->group, "parts/block");
    CHECK_TEXT(batten_model_object(back, 6)->layer, "solids");
    CHECK_TEXT(batten_model_object(back, DRILLED_FACES)->group, "parts");
    batten_model_unref(back);
    batten_model_unref(model);
    batten_surface_unref(sphere);
    for (int i = 0; i < 2; i++)
        batten_body_unref(bodies[i]);
}
