#include "exchange/step/reading.h"
#include "support/drilled_box.h"

static batten_model *new_model(void)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    return model;
}

static void place(batten_model *model, const char *name, const batten_model *definition,
                  batten_affine at)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = definition,
                                                      .place = at}));
}

static batten_model *block(void)
{
    batten_body *body = NULL;
    batten_model *model = new_model();
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "block", .kind = BATTEN_OBJECT_BODY, .body = body}));
    batten_body_unref(body);
    return model;
}

TEST(a_definition_is_one_product_however_often_it_is_placed)
{
    batten_model *part = block(), *pair = new_model(), *all = new_model();
    const batten_affine turn =
        batten_affine_rotation((batten_vec3){1, 2, 3}, (batten_vec3){0, 0, 1}, 0.5);
    place(pair, "first", part, batten_affine_identity());
    place(pair, "second", part, turn);
    place(all, "a", pair, batten_affine_translation(10, 0, 0));
    place(all, "b", pair, batten_affine_translation(0, 10, 0));
    place(all, "c", part, batten_affine_translation(0, 0, 10));
    const char *text = step_text(all, NULL);
    step_check(text);
    CHECK_INT(step_count(text, "PRODUCT"), 3);
    CHECK_INT(step_count(text, "MANIFOLD_SOLID_BREP"), 1);
    CHECK_INT(step_count(text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE"), 5);
    CHECK_INT(step_count(text, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION"), 5);
    CHECK_INT(step_count(text, "ITEM_DEFINED_TRANSFORMATION"), 5);
    CHECK_INT(step_count(text, "SHAPE_DEFINITION_REPRESENTATION"), 3);
    CHECK_CONTAINS(text, "=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','second','',#");
    CHECK_CONTAINS(text, "=PRODUCT('a','a','',(#");
    CHECK_CONTAINS(text, "=PRODUCT('hull','hull','',(#");
    batten_model_unref(all);
    batten_model_unref(pair);
    batten_model_unref(part);
}

TEST(what_is_mirrored_or_scaled_is_copied_with_a_note)
{
    batten_model *part = block(), *all = new_model();
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(5, &notes));
    place(all, "port", part,
          batten_affine_mirror((batten_vec3){0, -1, 0}, (batten_vec3){0, 1, 0}));
    place(all, "starboard", part, batten_affine_translation(0, 1, 0));
    place(all, "large", part, batten_affine_scaling(2, 2, 2));
    const char *text = step_text(all, notes);
    step_check(text);
    CHECK_INT(step_count(text, "PRODUCT"), 2);
    CHECK_INT(step_count(text, "MANIFOLD_SOLID_BREP"), 3);
    CHECK_INT(step_count(text, "NEXT_ASSEMBLY_USAGE_OCCURRENCE"), 1);
    CHECK_CONTAINS(text, "MANIFOLD_SOLID_BREP('port/block',");
    CHECK(batten_notes_dropped(notes) || has_note(notes, "scales, shears or mirrors"));
    batten_notes_free(notes);
    batten_model_unref(all);
    batten_model_unref(part);
}

TEST(what_a_definition_holds_that_STEP_does_not_is_noted)
{
    const batten_table_point side = {0, 1, 2, -1};
    const batten_table_station station = {"0", 0, 1, &side};
    const double point[3] = {1, 2, 3};
    batten_offset_table *offsets = NULL;
    batten_notes *notes = NULL;
    batten_model *part = new_model(), *all = new_model();
    CHECK_OK(batten_notes_create(5, &notes));
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 1, &station, &offsets));
    CHECK_OK(batten_model_add(part, &(batten_object){.name = "table",
                                                     .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                                     .offset_table = offsets}));
    CHECK_OK(batten_model_add(part, &(batten_object){.name = "mark",
                                                     .kind = BATTEN_OBJECT_POINTS,
                                                     .point_count = 1,
                                                     .points = point}));
    place(all, "hull", part, batten_affine_identity());
    const char *text = step_text(all, notes);
    step_check(text);
    CHECK_INT(step_count(text, "PRODUCT"), 2);
    CHECK(batten_notes_dropped(notes) || has_note(notes, "left out: STEP files hold points"));
    batten_notes_free(notes);
    batten_model_unref(all);
    batten_model_unref(part);
    batten_offset_table_unref(offsets);
}
