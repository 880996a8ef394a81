#include "support/bodies.h"
#include "support/test.h"

#include <batten/model.h>
#include <batten/skin.h>
#include <batten/standard.h>
#include <string.h>

static void add(batten_model *model, const batten_object *object)
{
    CHECK_OK(batten_model_add(model, object));
}

/* A definition with a box and a line, placed twice; a sphere beside. */
static batten_model *make_model(void)
{
    const batten_frame world = batten_frame_world();
    const double a[3] = {0, 0, 0}, b[3] = {1, 0, 0};
    batten_model *definition = NULL, *model = NULL;
    batten_curve *line = NULL;
    batten_surface *sphere = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    CHECK_OK(batten_model_create(0.001, &definition));
    CHECK_OK(batten_model_create(0.001, &model));
    add(definition, &(batten_object){.name = "box",
                                     .layer = "metal",
                                     .has_colour = true,
                                     .colour = {1, 0, 0},
                                     .kind = BATTEN_OBJECT_BODY,
                                     .body = box});
    add(definition,
        &(batten_object){.name = "line", .kind = BATTEN_OBJECT_CURVE, .curve = line});
    for (int i = 0; i < 2; i++)
        add(model, &(batten_object){.name = i ? "second" : "first",
                                    .kind = BATTEN_OBJECT_INSTANCE,
                                    .definition = definition,
                                    .place = batten_affine_translation(5 * i, 0, 0)});
    add(model,
        &(batten_object){.name = "ball", .kind = BATTEN_OBJECT_SURFACE, .surface = sphere});
    batten_curve_unref(line);
    batten_surface_unref(sphere);
    batten_body_unref(box);
    batten_model_unref(definition);
    return model;
}

TEST(a_model_is_meshed_and_definitions_once)
{
    batten_model *model = make_model(), *meshed = NULL;
    batten_mesh_facts facts;
    CHECK_OK(batten_model_meshed(model, NULL, NULL, NULL, &meshed));
    CHECK_INT(batten_model_count(meshed), 3);
    const batten_object *first = batten_model_object(meshed, 0);
    const batten_object *second = batten_model_object(meshed, 1);
    const batten_object *ball = batten_model_object(meshed, 2);
    CHECK(first->kind == BATTEN_OBJECT_INSTANCE);
    CHECK(first->definition == second->definition);
    const batten_object *box = batten_model_object(first->definition, 0);
    CHECK(box->kind == BATTEN_OBJECT_MESH && box->body == NULL);
    CHECK_TEXT(box->name, "box");
    CHECK_TEXT(box->layer, "metal");
    CHECK(box->has_colour && box->colour[0] == 1);
    CHECK(batten_model_object(first->definition, 1)->kind == BATTEN_OBJECT_CURVE);
    CHECK(ball->kind == BATTEN_OBJECT_MESH);
    CHECK_OK(batten_mesh_check(box->mesh, &facts));
    CHECK(facts.is_watertight);
    CHECK_NEAR(facts.volume, 6, 1e-12);
    CHECK_OK(batten_mesh_check(ball->mesh, &facts));
    CHECK(facts.is_watertight);
    batten_model_unref(meshed);
    batten_model_unref(model);
}

/* A red box whose faces `first` .. `last` are green. */
static batten_model *painted_box(int first, int last)
{
    batten_model *model = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}),
                *painted = NULL;
    batten_body_parts parts = *batten_body_view(box);
    batten_body_face faces[6];
    for (int i = 0; i < 6; i++) {
        faces[i] = parts.faces[i];
        faces[i].has_colour = i >= first && i <= last;
        faces[i].colour[1] = 1;
    }
    parts.faces = faces;
    CHECK_OK(batten_body_create(&parts, &painted));
    CHECK_OK(batten_model_create(0.001, &model));
    add(model, &(batten_object){.name = "box",
                                .has_colour = true,
                                .colour = {1, 0, 0},
                                .kind = BATTEN_OBJECT_BODY,
                                .body = painted});
    batten_body_unref(box);
    batten_body_unref(painted);
    return model;
}

TEST(colours_of_faces_are_those_of_their_triangles)
{
    batten_model *model = painted_box(2, 2), *meshed = NULL;
    CHECK_OK(batten_model_meshed(model, NULL, NULL, NULL, &meshed));
    const batten_object *object = batten_model_object(meshed, 0);
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    CHECK(object->has_colour && object->colour[0] == 1);
    CHECK(p->triangle_colours != NULL);
    for (int i = 0; p->triangle_colours && i < p->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            CHECK_BITS(p->triangle_colours[3 * i + k], k == (p->faces[i] == 2 ? 1 : 0));
    batten_model_unref(meshed);
    batten_model_unref(model);
}

TEST(faces_of_one_colour_give_it_to_the_mesh)
{
    batten_model *model = painted_box(0, 5), *meshed = NULL;
    CHECK_OK(batten_model_meshed(model, NULL, NULL, NULL, &meshed));
    const batten_object *object = batten_model_object(meshed, 0);
    CHECK(object->has_colour && object->colour[0] == 0 && object->colour[1] == 1);
    CHECK(batten_mesh_view(object->mesh)->triangle_colours == NULL);
    batten_model_unref(meshed);
    batten_model_unref(model);
}

/* A quarter of a cylinder with the radius 10 in a body with edges that are `off` it outwards.
 */
static batten_model *with_edges_off(double off)
{
    batten_model *model = NULL;
    batten_body *around = NULL, *body = NULL;
    batten_surface *quarters[2] = {NULL, NULL};
    for (int i = 0; i < 2; i++) {
        batten_curve *flat = NULL, *arc = NULL;
        CHECK_OK(batten_curve_arc(i ? 10 + off : 10, 1.5, &flat));
        CHECK_OK(batten_curve_to_dimension(flat, 3, &arc));
        CHECK_OK(batten_surface_extruded(arc, (batten_vec3){0, 0, 30}, &quarters[i]));
        batten_curve_unref(flat);
        batten_curve_unref(arc);
    }
    CHECK_OK(batten_body_from_surface("quarter", quarters[1], 1e-9, &around));
    batten_body_parts parts = *batten_body_view(around);
    batten_body_face face = parts.faces[0];
    face.surface = quarters[0];
    parts.faces = &face;
    CHECK_OK(batten_body_create(&parts, &body));
    CHECK_OK(batten_model_create(0.001, &model));
    add(model, &(batten_object){.name = "sheet", .kind = BATTEN_OBJECT_BODY, .body = body});
    batten_body_unref(body);
    batten_body_unref(around);
    batten_surface_unref(quarters[0]);
    batten_surface_unref(quarters[1]);
    return model;
}

TEST(a_chord_that_is_not_met_is_a_note_with_the_reason)
{
    static const char what[] = "the chord of 0.02 is not met: ";
    for (int i = 0; i < 2; i++) {
        batten_mesh_options options = batten_mesh_defaults();
        batten_model *model = with_edges_off(i ? 0.05 : 0.015), *meshed = NULL;
        batten_notes *notes = NULL;
        int found = 0;
        options.chord = 0.02;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_model_meshed(model, &options, NULL, notes, &meshed));
        for (int k = 0; k < batten_notes_count(notes); k++) {
            const batten_note *note = batten_notes_at(notes, k);
            if (strncmp(note->text, what, sizeof what - 1) != 0)
                continue;
            found++;
            CHECK(!note->is_remark);
            CHECK_TEXT(note->entity, "sheet");
            CHECK_CONTAINS(note->text, "edges are up to 0.05 off their faces");
        }
        CHECK(i ? found > 0 || batten_notes_dropped(notes) > 0 : found == 0);
        batten_notes_free(notes);
        batten_model_unref(meshed);
        batten_model_unref(model);
    }
}

TEST(S5_what_is_allowed_is_for_all_objects_together)
{
    batten_mesh_options options = batten_mesh_defaults();
    batten_model *model = NULL, *meshed = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < 3; i++)
        add(model, &(batten_object){.name = i == 2 ? "last" : "box",
                                    .kind = BATTEN_OBJECT_BODY,
                                    .body = box});
    options.most = 24;
    CHECK_STATUS(batten_model_meshed(model, &options, NULL, NULL, &meshed), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("the shapes up to 'last' have more than the 24 triangles");
    options.most = 36;
    CHECK_OK(batten_model_meshed(model, &options, NULL, NULL, &meshed));
    batten_model_unref(meshed);
    batten_model_unref(model);
    batten_body_unref(box);
}

TEST(S5_a_shape_that_needs_too_many_triangles_is_left_out_alone)
{
    const batten_frame world = batten_frame_world();
    batten_mesh_options options = batten_mesh_defaults();
    batten_model *model = NULL, *meshed = NULL;
    batten_notes *notes = NULL;
    batten_surface *sphere = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_create(0.001, &model));
    add(model,
        &(batten_object){.name = "ball", .kind = BATTEN_OBJECT_SURFACE, .surface = sphere});
    options.chord = 1e-9;
    CHECK_STATUS(batten_model_meshed(model, &options, NULL, NULL, &meshed), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("10000000 are allowed");
    add(model, &(batten_object){.name = "box", .kind = BATTEN_OBJECT_BODY, .body = box});
    CHECK_OK(batten_model_meshed(model, &options, NULL, notes, &meshed));
    CHECK_INT(batten_model_count(meshed), 1);
    CHECK_INT(batten_mesh_view(batten_model_object(meshed, 0)->mesh)->triangle_count, 12);
    if (batten_notes_dropped(notes) == 0) { /* else memory failed for the note alone */
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "ball");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text,
                       "left out, as this surface cannot be meshed");
    }
    batten_notes_free(notes);
    batten_model_unref(meshed);
    batten_model_unref(model);
    batten_surface_unref(sphere);
    batten_body_unref(box);
}

/* Spheres, of which each is another piece of work. */
static batten_model *make_spheres(int count)
{
    const batten_frame world = batten_frame_world();
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < count; i++) {
        batten_surface *sphere = NULL;
        CHECK_OK(batten_surface_sphere(&world, 1 + i, &sphere));
        add(model, &(batten_object){.name = i % 2 ? "odd" : "even",
                                    .kind = BATTEN_OBJECT_SURFACE,
                                    .surface = sphere});
        batten_surface_unref(sphere);
    }
    return model;
}

static void check_same_mesh(const batten_mesh *first, const batten_mesh *second)
{
    const batten_mesh_parts *a = batten_mesh_view(first), *b = batten_mesh_view(second);
    CHECK_INT(a->vertex_count, b->vertex_count);
    CHECK_INT(a->triangle_count, b->triangle_count);
    CHECK(memcmp(a->points, b->points, 3 * sizeof(double) * (size_t)a->vertex_count) == 0);
    CHECK(memcmp(a->corners, b->corners, 3 * sizeof(int) * (size_t)a->triangle_count) == 0);
    CHECK(memcmp(a->normals, b->normals, 9 * sizeof(double) * (size_t)a->triangle_count) == 0);
}

/* The last `count` of each: a try that ran out of memory noted some before. */
static void check_same_notes(int count, const batten_notes *first, const batten_notes *second)
{
    if (batten_notes_dropped(first) || batten_notes_dropped(second))
        return;
    const int ends[2] = {batten_notes_count(first), batten_notes_count(second)};
    CHECK(ends[0] >= count && ends[1] >= count);
    for (int i = 1; i <= count; i++)
        CHECK_TEXT(batten_notes_at(second, ends[1] - i)->text,
                   batten_notes_at(first, ends[0] - i)->text);
}

TEST(T1_any_number_of_threads_gives_the_same_triangles_and_notes)
{
    enum { SPHERES = 7 };
    batten_model *model = make_spheres(SPHERES), *alone = NULL;
    batten_notes *said = NULL;
    CHECK_OK(batten_notes_create(100, &said));
    CHECK_OK(batten_model_meshed(model, NULL, NULL, said, &alone));
    for (int threads = 0; threads <= 4; threads++) {
        batten_job job = BATTEN_JOB;
        batten_model *meshed = NULL;
        batten_notes *notes = NULL;
        job.thread_count = threads;
        CHECK_OK(batten_notes_create(100, &notes));
        CHECK_OK(batten_model_meshed(model, NULL, &job, notes, &meshed));
        for (int i = 0; i < SPHERES; i++)
            check_same_mesh(batten_model_object(alone, i)->mesh,
                            batten_model_object(meshed, i)->mesh);
        check_same_notes(SPHERES, said, notes);
        batten_notes_free(notes);
        batten_model_unref(meshed);
    }
    batten_notes_free(said);
    batten_model_unref(alone);
    batten_model_unref(model);
}
