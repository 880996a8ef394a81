#include "exchange/shapes.h"
#include "support/bodies.h"
#include "support/drilled_box.h"

/* What comes back of a STEP file; its second writing is the same. */
static batten_model *twice(const batten_model *model, const batten_write_options *asked)
{
    batten_write_options options = *asked;
    options.format = BATTEN_FORMAT_STEP;
    return there_and_back(model, &options, NULL);
}

static batten_model *model_with(batten_body *body)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "block",
                                                      .has_colour = true,
                                                      .colour = {0.1, 0.2, 0.3},
                                                      .layer = "solids",
                                                      .is_hidden = true,
                                                      .kind = BATTEN_OBJECT_BODY,
                                                      .body = body}));
    batten_body_unref(body);
    return model;
}

TEST(a_solid_reads_back_and_writes_the_same_bytes_in_all_schemas)
{
    for (int k = 0; k < 6; k++) {
        batten_write_options options = batten_write_defaults();
        batten_body *body = NULL;
        options.schema = (batten_step_schema)(k / 2);
        options.no_parameter_curves = k % 2;
        CHECK_OK(drilled_box(&body));
        batten_model *model = model_with(body), *back = twice(model, &options);
        CHECK_INT(batten_model_count(back), 1);
        const batten_object *object = batten_model_object(back, 0);
        CHECK_INT(object->kind, BATTEN_OBJECT_BODY);
        CHECK_TEXT(object->name, "block");
        const batten_body_parts *p = batten_body_view(object->body);
        CHECK(p->is_solid);
        CHECK_INT(p->face_count, DRILLED_FACES);
        CHECK_INT(p->edge_count, DRILLED_EDGES);
        CHECK_INT(p->vertex_count, DRILLED_VERTICES);
        CHECK(p->faces[6].reversed && !p->faces[0].reversed);
        if (options.schema != BATTEN_STEP_AP203) {
            CHECK(object->is_hidden && object->has_colour && p->faces[5].has_colour);
            CHECK_TEXT(object->layer, "solids");
        }
        batten_model_unref(back);
        batten_model_unref(model);
    }
}

TEST(a_body_without_parameter_curves_gets_them)
{
    const batten_write_options options = batten_write_defaults();
    batten_model *model = model_with(test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}));
    batten_model *back = twice(model, &options);
    const batten_body_parts *p = batten_body_view(batten_model_object(back, 0)->body);
    CHECK_INT(p->edge_count, 12);
    for (int u = 0; u < p->use_count; u++)
        CHECK(p->uses[u].parameters != NULL);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(an_assembly_reads_back_and_writes_the_same_bytes)
{
    const batten_write_options options = batten_write_defaults();
    batten_body *body = NULL;
    batten_model *pair = NULL, *all = NULL;
    CHECK_OK(drilled_box(&body));
    batten_model *part = model_with(body);
    CHECK_OK(batten_model_create(0.001, &pair));
    CHECK_OK(batten_model_create(0.001, &all));
    batten_object object = {.name = "left",
                            .kind = BATTEN_OBJECT_INSTANCE,
                            .definition = part,
                            .place = batten_affine_identity()};
    CHECK_OK(batten_model_add(pair, &object));
    object.name = "right";
    object.place = batten_affine_rotation((batten_vec3){1, 2, 3}, (batten_vec3){0, 0, 1}, 0.5);
    CHECK_OK(batten_model_add(pair, &object));
    object.definition = pair;
    object.name = "one";
    object.place = batten_affine_translation(10, 20, 0.1);
    CHECK_OK(batten_model_add(all, &object));
    object.name = "two";
    CHECK_OK(batten_model_add(all, &object));
    batten_model *back = twice(all, &options);
    CHECK_INT(batten_model_count(back), 2);
    const batten_object *one = batten_model_object(back, 0),
                        *two = batten_model_object(back, 1);
    CHECK_INT(one->kind, BATTEN_OBJECT_INSTANCE);
    CHECK_TEXT(two->name, "two");
    CHECK(one->definition == two->definition);
    CHECK_INT(batten_model_depth(back), 2);
    batten_model_unref(back);
    batten_model_unref(all);
    batten_model_unref(pair);
    batten_model_unref(part);
}

TEST(curves_and_surfaces_read_back_bit_for_bit_from_STEP)
{
    static const double units[] = {1, 0.001, 0.0254, 0.01};
    const batten_write_options options = batten_write_defaults();
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(20); i++) {
        batten_model *model = NULL;
        batten_surface *surface = random_surface(&random);
        batten_curve *curve = random_curve(&random);
        CHECK_OK(batten_model_create(units[i % 4], &model));
        add_surface(model, "side", surface);
        add_curve(model, "keel", curve);
        batten_model *back = twice(model, &options);
        check_same_model(model, back);
        batten_model_unref(back);
        batten_model_unref(model);
        batten_surface_unref(surface);
        batten_curve_unref(curve);
    }
}

TEST(what_is_smaller_than_a_micrometre_reads_back)
{
    const batten_write_options options = batten_write_defaults();
    const batten_affine small = {{{1e-7, 0, 0}, {0, 1e-7, 0}, {0, 0, 1e-7}}, {0, 0, 0}};
    const double points[] = {0, 0, 0, 0, 3e-9, 0, 2e-9, 0, 0, 2e-9, 3e-9, 1e-9};
    const double knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_body *body = NULL, *made = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_body_transform(body, &small, &made));
    batten_body_unref(body);
    batten_model *model = model_with(made), *back = twice(model, &options);
    CHECK_INT(batten_body_view(batten_model_object(back, 0)->body)->face_count, DRILLED_FACES);
    batten_model_unref(model);
    batten_model_unref(back);
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    CHECK_OK(batten_model_create(0.001, &model));
    add_surface(model, "speck", surface);
    back = twice(model, &options);
    CHECK_INT(batten_model_object(back, 0)->kind, BATTEN_OBJECT_SURFACE);
    batten_model_unref(model);
    batten_model_unref(back);
    batten_surface_unref(surface);
}
