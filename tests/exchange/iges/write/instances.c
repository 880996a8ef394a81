/* Subfigures and their instances, written. */
#include "exchange/iges/write/writing.h"

#include "exchange/shapes.h"

#include "support/drilled_box.h"

#include <stdio.h>

static void add_body(batten_model *model, const char *name)
{
    batten_body *body = NULL;
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_BODY, .body = body}));
    batten_body_unref(body);
}

static void add_point(batten_model *model, const char *name, double x)
{
    const double point[3] = {x, 2, 3};
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .layer = "marks",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 1,
                                                      .points = point}));
}

static void place(batten_model *model, const char *name, batten_model *definition,
                  batten_affine at)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .layer = "parts",
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = definition,
                                                      .place = at}));
}

static batten_model *new_model(void)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    return model;
}

static batten_model *as_iges(const batten_model *model, batten_notes *notes)
{
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_IGES;
    return there_and_back(model, &options, notes);
}

TEST(what_IGES_can_place_stays_an_instance_with_its_bits)
{
    const batten_vec3 base = {1, 2, 3}, axis = {0.6, 0, 0.8};
    const batten_affine places[] = {
        batten_affine_identity(),
        batten_affine_translation(0.1, -20, 1e6),
        batten_affine_rotation(base, axis, 0.7),
        batten_affine_mirror(base, axis),
        batten_affine_scaling(25.4, 25.4, 25.4),
        batten_affine_compose(batten_affine_scaling(2, 2, 2),
                              batten_affine_rotation(base, axis, 1))};
    batten_model *part = new_model(), *all = new_model();
    add_point(part, "mark", 1);
    for (int i = 0; i < COUNT(places); i++)
        place(all, "copy", part, places[i]);
    batten_model *back = as_iges(all, NULL);
    CHECK_INT(batten_model_count(back), COUNT(places));
    for (int i = 0; i < COUNT(places); i++) {
        const batten_object *object = batten_model_object(back, i);
        CHECK_INT(object->kind, BATTEN_OBJECT_INSTANCE);
        CHECK_TEXT(object->name, "copy");
        CHECK_TEXT(object->layer, "parts");
        CHECK(object->definition == batten_model_object(back, 0)->definition);
        for (int k = 0; k < 9; k++)
            CHECK_BITS(object->place.m[k / 3][k % 3], places[i].m[k / 3][k % 3] + 0.0);
        for (int k = 0; k < 3; k++)
            CHECK_BITS(object->place.t[k], places[i].t[k] + 0.0);
    }
    const batten_object *mark =
        batten_model_object(batten_model_object(back, 0)->definition, 0);
    CHECK_TEXT(mark->layer, "marks");
    batten_model_unref(back);
    batten_model_unref(all);
    batten_model_unref(part);
}

TEST(what_IGES_cannot_place_is_copied_with_a_note)
{
    batten_notes *notes = NULL;
    batten_model *part = new_model(), *pair = new_model(), *all = new_model();
    CHECK_OK(batten_notes_create(20, &notes));
    add_point(part, "mark", 1);
    place(pair, "one", part, batten_affine_identity());
    place(pair, "other", part, batten_affine_translation(1, 0, 0));
    place(all, "flat", pair, batten_affine_scaling(1, 2, 1));
    batten_model *back = as_iges(all, notes);
    CHECK_INT(batten_model_count(back), 2);
    CHECK_TEXT(batten_model_object(back, 1)->name, "flat/other/mark");
    CHECK_BITS(batten_model_object(back, 1)->points[0], 2.0);
    CHECK_BITS(batten_model_object(back, 1)->points[1], 4.0);
    CHECK(batten_notes_dropped(notes) || has_note(notes, "scales, shears or mirrors as IGES"));
    batten_model_unref(back);
    batten_model_unref(all);
    batten_model_unref(pair);
    batten_model_unref(part);
    batten_notes_free(notes);
}

TEST(definitions_lie_in_one_another_and_bodies_in_them_keep_together)
{
    batten_model *part = new_model(), *pair = new_model(), *all = new_model(), *flat = NULL;
    add_body(part, "block");
    add_body(pair, "base");
    add_point(pair, "mark", 5);
    place(pair, "upper", part, batten_affine_translation(0, 0, 10));
    place(all, "left", pair, batten_affine_identity());
    place(all, "right", pair, batten_affine_translation(100, 0, 0));
    batten_model *back = as_iges(all, NULL);
    CHECK_INT(batten_model_count(back), 2);
    const batten_model *both = batten_model_object(back, 0)->definition;
    CHECK(both == batten_model_object(back, 1)->definition);
    CHECK_INT(batten_model_count(both), 3);
    CHECK_TEXT(batten_model_object(both, 0)->name, "base");
    CHECK_INT(batten_model_object(both, 0)->kind, BATTEN_OBJECT_INSTANCE);
    CHECK_INT(batten_model_count(batten_model_object(both, 0)->definition), 8);
    CHECK_INT(batten_model_count(batten_model_object(both, 2)->definition), 8);
    CHECK_OK(batten_model_flat(back, &flat));
    CHECK_INT(batten_model_count(flat), 2 * (8 + 1 + 8));
    batten_model_unref(flat);
    batten_model_unref(back);
    batten_model_unref(all);
    batten_model_unref(pair);
    batten_model_unref(part);
}

TEST(an_instance_of_nothing_is_left_out_with_a_note)
{
    batten_notes *notes = NULL;
    batten_model *part = new_model(), *all = new_model();
    CHECK_OK(batten_notes_create(5, &notes));
    place(all, "ghost", part, batten_affine_identity());
    add_point(all, "mark", 1);
    batten_model *back = as_iges(all, notes);
    CHECK_INT(batten_model_count(back), 1);
    CHECK(batten_notes_dropped(notes) || has_note(notes, "places nothing"));
    batten_model_unref(back);
    batten_model_unref(all);
    batten_model_unref(part);
    batten_notes_free(notes);
}

/* Rotations and mirrors, scaled alike in all directions, to 1e-10; nothing else. */
TEST(places_of_subfigures_are_similarities)
{
    static const struct {
        double m[3][3];
        bool can;
    } cases[] = {
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, true},
        {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, true},
        {{{0, -3, 0}, {3, 0, 0}, {0, 0, 3}}, true},
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, true},
        {{{1, 1e-11, 0}, {0, 1, 0}, {0, 0, 1}}, true},
        {{{1, 0, 0}, {0, 1 + 1e-11, 0}, {0, 0, 1}}, true},
        {{{1, 1e-9, 0}, {0, 1, 0}, {0, 0, 1}}, false},
        {{{1, 0, 0}, {0, 1 + 1e-9, 0}, {0, 0, 1}}, false},
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1 - 1e-9}}, false},
        {{{1, 0, 0}, {0, 1, 0}, {0, 1e-9, 1}}, false},
        {{{1, 0, 0}, {0, 1, 0}, {1e-9, 0, 1}}, false},
        {{{1, 0, 0}, {0, 2, 0}, {0, 0, 1}}, false},
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, false},
        {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, false},
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, false},
        {{{1e200, 0, 0}, {0, 1e200, 0}, {0, 0, 1e200}}, false},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_affine place = batten_affine_translation(1, -2, 1e9);
        memcpy(place.m, cases[i].m, sizeof place.m);
        CHECK_INT(bat_iges_can_place(&place), cases[i].can);
    }
}
