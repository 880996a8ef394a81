#include "model/inherited_colours.h"
#include "support/bodies.h"
#include "support/test.h"

#include <batten/exchange.h>
#include <stdio.h>
#include <string.h>

static const double red[3] = {1, 0, 0}, blue[3] = {0, 0, 1}, green[3] = {0, 1, 0};

/* `colour`: NULL for none. */
static void add(batten_model *model, const char *name, const double *colour,
                const batten_object *what)
{
    batten_object object = *what;
    object.name = name;
    object.has_colour = colour != NULL;
    if (colour)
        memcpy(object.colour, colour, sizeof object.colour);
    CHECK_OK(batten_model_add(model, &object));
}

static void place(batten_model *model, const char *name, const double *colour,
                  const batten_model *definition, double x)
{
    add(model, name, colour,
        &(batten_object){.kind = BATTEN_OBJECT_INSTANCE,
                         .definition = definition,
                         .place = batten_affine_translation(x, 0, 0)});
}

/* A box, whose face 2 is green, and one of its own colour. */
static batten_model *make_part(void)
{
    batten_model *part = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}),
                *painted = NULL;
    batten_body_parts parts = *batten_body_view(box);
    batten_body_face faces[6];
    memcpy(faces, parts.faces, sizeof faces);
    faces[2].has_colour = true;
    memcpy(faces[2].colour, green, sizeof green);
    parts.faces = faces;
    CHECK_OK(batten_body_create(&parts, &painted));
    CHECK_OK(batten_model_create(0.001, &part));
    add(part, "plain", NULL, &(batten_object){.kind = BATTEN_OBJECT_BODY, .body = painted});
    add(part, "own", green, &(batten_object){.kind = BATTEN_OBJECT_BODY, .body = box});
    batten_body_unref(painted);
    batten_body_unref(box);
    return part;
}

/* The part in an arm, bare and in red; the arm bare, in blue twice and in red. */
static batten_model *make_model(void)
{
    batten_model *model = NULL, *arm = NULL, *part = make_part();
    CHECK_OK(batten_model_create(0.001, &arm));
    CHECK_OK(batten_model_create(0.001, &model));
    place(arm, "bare", NULL, part, 0);
    place(arm, "red", red, part, 5);
    place(model, "a", NULL, arm, 0);
    place(model, "b", blue, arm, 10);
    place(model, "c", blue, arm, 20);
    place(model, "d", red, arm, 30);
    batten_model_unref(arm);
    batten_model_unref(part);
    return model;
}

static const batten_model *definition_at(const batten_model *model, int index)
{
    return batten_model_object(model, index)->definition;
}

static void check_colour(const batten_object *object, const double *colour)
{
    CHECK_INT(object->has_colour, colour != NULL);
    CHECK(!colour || memcmp(object->colour, colour, sizeof object->colour) == 0);
}

TEST(what_is_placed_takes_the_colours_of_instances)
{
    batten_model *model = make_model(), *painted = NULL, *again = NULL;
    const double *const bare[] = {NULL, blue, blue, red};
    CHECK_OK(bat_model_painted(model, NULL, &painted));
    for (int i = 0; i < 4; i++) {
        const batten_model *arm = definition_at(painted, i);
        check_colour(batten_model_object(definition_at(arm, 0), 0), bare[i]);
        check_colour(batten_model_object(definition_at(arm, 1), 0), red);
        for (int k = 0; k < 2; k++) {
            check_colour(batten_model_object(definition_at(arm, k), 1), green);
            CHECK(batten_model_object(definition_at(arm, k), 0)->body ==
                  batten_model_object(definition_at(definition_at(model, 0), 0), 0)->body);
        }
        CHECK_BITS(batten_model_object(painted, i)->place.t[0], 10 * i);
    }
    CHECK(definition_at(painted, 1) == definition_at(painted, 2));
    CHECK(definition_at(definition_at(painted, 0), 1) ==
          definition_at(definition_at(painted, 3), 0));
    CHECK_OK(bat_model_painted(definition_at(painted, 0), NULL, &again));
    batten_model_unref(again);
    batten_model_unref(painted);
    batten_model_unref(model);
}

/* The same colours as of the model without instances. */
TEST(a_painted_model_is_flat_as_before)
{
    batten_model *model = make_model(), *painted = NULL, *flat = NULL, *before = NULL;
    CHECK_OK(bat_model_painted(model, NULL, &painted));
    CHECK_OK(batten_model_flat(model, &before));
    CHECK_OK(batten_model_flat(painted, &flat));
    CHECK_INT(batten_model_count(flat), batten_model_count(before));
    for (int i = 0; i < batten_model_count(flat); i++) {
        const batten_object *object = batten_model_object(before, i);
        CHECK_TEXT(batten_model_object(flat, i)->name, object->name);
        check_colour(batten_model_object(flat, i), object->has_colour ? object->colour : NULL);
    }
    batten_model_unref(flat);
    batten_model_unref(before);
    batten_model_unref(painted);
    batten_model_unref(model);
}

TEST(a_model_without_such_instances_stays_itself)
{
    batten_model *part = make_part(), *model = NULL, *painted = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    place(model, "bare", NULL, part, 0);
    CHECK_OK(bat_model_painted(model, NULL, &painted));
    CHECK(painted == model);
    batten_model_unref(painted);
    batten_model_unref(part);
    batten_model_unref(model);
}

TEST(instances_in_too_many_colours_are_counted)
{
    batten_model *part = make_part(), *model = NULL, *painted = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < 260; i++) {
        char name[16];
        snprintf(name, sizeof name, "i%d", i);
        place(model, name, (const double[]){i / 300.0, 0, 0}, part, i);
    }
    CHECK_OK(bat_model_painted(model, notes, &painted));
    check_colour(batten_model_object(definition_at(painted, 255), 0),
                 (const double[]){255 / 300.0, 0, 0});
    check_colour(batten_model_object(definition_at(painted, 256), 0), NULL);
    if (batten_notes_count(notes)) {
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "i256");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "instances without their colour: 4;");
    }
    batten_notes_free(notes);
    batten_model_unref(painted);
    batten_model_unref(part);
    batten_model_unref(model);
}

/* Faces without a colour have that of the instance; the shapes are meshed once. */
TEST(painted_shapes_are_meshed_once)
{
    batten_model *model = make_model(), *prepared = NULL;
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_GLTF;
    CHECK_OK(batten_write_prepare(model, &options, NULL, &prepared));
    for (int i = 0; i < 4; i += 3) {
        const batten_object *plain =
            batten_model_object(definition_at(definition_at(prepared, i), 0), 0);
        const batten_mesh_parts *p = batten_mesh_view(plain->mesh);
        for (int k = 0; k < p->triangle_count; k++) {
            const double *colour = p->triangle_colours + 3 * (size_t)k;
            CHECK_BITS(colour[0], p->faces[k] == 2 ? 0 : i ? 1 : 0.8);
        }
    }
    CHECK(batten_model_object(definition_at(definition_at(prepared, 0), 0), 1)->mesh ==
          batten_model_object(definition_at(definition_at(prepared, 3), 0), 1)->mesh);
    batten_model_unref(prepared);
    batten_model_unref(model);
}
