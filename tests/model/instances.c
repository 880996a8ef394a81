#include "support/bodies.h"
#include "support/test.h"

#include <batten/exchange.h>
#include <batten/model.h>

static void add_point(batten_model *model, const char *name, double x)
{
    const double point[] = {x, 0, 0};
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 1,
                                                      .points = point}));
}

static void add_instance(batten_model *model, const char *name, const batten_model *definition,
                         batten_affine place)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = definition,
                                                      .place = place}));
}

/* An arm with a bolt at 1, moved by 10 and turned about z: the bolt's point is at (10, 1). */
static batten_model *make_assembly(void)
{
    batten_model *bolt = NULL, *arm = NULL, *whole = NULL;
    CHECK_OK(batten_model_create(1, &bolt));
    CHECK_OK(batten_model_create(1, &arm));
    CHECK_OK(batten_model_create(1, &whole));
    add_point(bolt, "head", 0);
    add_instance(arm, "bolt", bolt, batten_affine_translation(1, 0, 0));
    add_point(arm, "end", 2);
    const batten_affine turn =
        batten_affine_rotation((batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, acos(0));
    add_instance(whole, "left arm", arm,
                 batten_affine_compose(turn, batten_affine_translation(10, 0, 0)));
    add_instance(whole, "right arm", arm, batten_affine_identity());
    batten_model_unref(bolt);
    batten_model_unref(arm);
    return whole;
}

TEST(instances_are_replaced_by_what_they_place)
{
    batten_model *whole = make_assembly(), *flat = NULL, *same = NULL;
    CHECK_INT(batten_model_depth(whole), 2);
    CHECK_OK(batten_model_flat(whole, &flat));
    CHECK_INT(batten_model_count(flat), 4);
    const batten_object *head = batten_model_object(flat, 0);
    CHECK_TEXT(head->name, "left arm/bolt/head");
    CHECK_NEAR(head->points[0], 10, 1e-14);
    CHECK_NEAR(head->points[1], 1, 1e-15);
    CHECK_TEXT(batten_model_object(flat, 3)->name, "right arm/end");
    CHECK_NEAR(batten_model_object(flat, 3)->points[0], 2, 0);
    CHECK_OK(batten_model_flat(flat, &same));
    CHECK(same == flat);
    batten_box box;
    CHECK(batten_model_box(whole, &box));
    CHECK_NEAR(box.high.x, 10, 1e-14);
    CHECK_NEAR(box.high.y, 2, 1e-14);
    batten_model_unref(same);
    batten_model_unref(flat);
    batten_model_unref(whole);
}

TEST(a_definition_is_scaled_once_however_often_it_is_placed)
{
    batten_model *whole = make_assembly(), *scaled = NULL, *flat = NULL;
    CHECK_OK(batten_model_to_unit(whole, 0.001, &scaled));
    const batten_object *left = batten_model_object(scaled, 0);
    CHECK(left->definition == batten_model_object(scaled, 1)->definition);
    CHECK_NEAR(left->place.t[0], 10000, 1e-10);
    CHECK_OK(batten_model_flat(scaled, &flat));
    CHECK_NEAR(batten_model_object(flat, 0)->points[0], 10000, 1e-9);
    CHECK_NEAR(batten_model_object(flat, 0)->points[1], 1000, 1e-9);
    batten_model_unref(flat);
    batten_model_unref(scaled);
    batten_model_unref(whole);
}

TEST(S4_instances_within_instances_have_a_limit)
{
    batten_model *inner = NULL, *outer = NULL;
    batten_status status = BATTEN_OK;
    CHECK_OK(batten_model_create(1, &inner));
    add_point(inner, "p", 1);
    for (int depth = 0; depth < 32; depth++) {
        CHECK_OK(batten_model_create(1, &outer));
        add_instance(outer, "i", inner, batten_affine_translation(1, 0, 0));
        batten_model_unref(inner);
        inner = outer;
    }
    batten_model *flat = NULL;
    CHECK_OK(batten_model_flat(inner, &flat));
    CHECK_NEAR(batten_model_object(flat, 0)->points[0], 33, 1e-13);
    batten_model_unref(flat);
    const batten_object deeper = {.name = "i",
                                  .kind = BATTEN_OBJECT_INSTANCE,
                                  .definition = inner,
                                  .place = batten_affine_identity()};
    CHECK_OK(batten_model_create(1, &outer));
    status = batten_model_add(outer, &deeper);
    CHECK(status == BATTEN_TOO_LARGE);
    CHECK_MESSAGE("more than 32 deep");
    batten_model_unref(outer);
    batten_model_unref(inner);
}

/* 30 models, each of which places the next twice: 2^30 places of what is in the last. */
static batten_model *make_doubling(bool has_point)
{
    batten_model *inner = NULL, *outer = NULL;
    CHECK_OK(batten_model_create(1, &inner));
    if (has_point)
        add_point(inner, "p", 1);
    for (int depth = 0; depth < 30; depth++) {
        CHECK_OK(batten_model_create(1, &outer));
        add_instance(outer, "a", inner, batten_affine_identity());
        add_instance(outer, "b", inner, batten_affine_translation(1, 0, 0));
        batten_model_unref(inner);
        inner = outer;
    }
    return inner;
}

TEST(S4_instances_that_double_cost_what_they_say_and_not_what_they_place)
{
    const batten_format formats[] = {BATTEN_FORMAT_STEP, BATTEN_FORMAT_IGES};
    batten_model *doubling = make_doubling(true), *scaled = NULL, *flat = NULL;
    batten_box box;
    CHECK(batten_model_box(doubling, &box));
    CHECK_BITS(box.low.x, 1.0);
    CHECK_BITS(box.high.x, 31.0);
    CHECK_OK(batten_model_to_unit(doubling, 0.001, &scaled));
    batten_model_unref(scaled);
    for (int i = 0; i < COUNT(formats); i++) {
        batten_write_options options = batten_write_defaults();
        char *data = NULL;
        size_t size = 0;
        options.format = formats[i];
        CHECK_OK(batten_write_memory(doubling, &options, NULL, &data, &size));
        CHECK(size < 100000);
        batten_release(data);
    }
    batten_model *nothing = make_doubling(false);
    CHECK(!batten_model_box(nothing, &box));
    CHECK_STATUS(batten_model_flat(nothing, &flat), BATTEN_TOO_LARGE);
    batten_model_unref(nothing);
    batten_model_unref(doubling);
}

/* 6 deep, 12 wide: about 3 million places of one point, which 73 objects ask for. */
TEST(S2_what_instances_place_is_counted_before_it_is_placed)
{
    batten_model *inner = NULL, *outer = NULL, *flat = NULL, *once = NULL;
    CHECK_OK(batten_model_create(1, &inner));
    add_point(inner, "p", 1);
    for (int depth = 0; depth < 6; depth++) {
        CHECK_OK(batten_model_create(1, &outer));
        for (int i = 0; i < 12; i++)
            add_instance(outer, "i", inner, batten_affine_translation(1, 0, 0));
        batten_model_unref(inner);
        inner = outer;
        if (depth == 3) { /* 12^4 points, and 12^4 + ... + 12 instances */
            CHECK_OK(batten_model_flat(inner, &flat));
            CHECK_INT(batten_model_count(flat), 20736);
            batten_model_unref(flat);
        }
        if (depth == 4) {
            CHECK_STATUS(batten_model_flat(inner, &flat), BATTEN_TOO_LARGE);
            CHECK_MESSAGE("61 objects hold instances which place 520284 objects and instances; "
                          "the limit is 102440");
        }
    }
    CHECK_STATUS(batten_model_flat(inner, &flat), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("73 objects hold instances which place 6243420 ");
    CHECK_OK(batten_model_once(inner, &once));
    CHECK_INT(batten_model_count(once), 1);
    CHECK_TEXT(batten_model_object(once, 0)->name, "i/p");
    batten_model_unref(once);
    batten_model_unref(inner);
}

TEST(S2_points_that_instances_place_are_counted_before_they_are_placed)
{
    enum { POINTS = 100000 };
    batten_model *inner = NULL, *outer = NULL, *flat = NULL;
    double *points = test_array(3 * POINTS, sizeof *points);
    CHECK_OK(batten_model_create(1, &inner));
    CHECK_OK(batten_model_create(1, &outer));
    CHECK_OK(batten_model_add(inner, &(batten_object){.name = "scan",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = POINTS,
                                                      .points = points}));
    for (int i = 0; i < 141; i++)
        add_instance(outer, "i", inner, batten_affine_identity());
    CHECK_STATUS(batten_model_flat(outer, &flat), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("100000 points are in instances which place 14100000 points; the limit is "
                  "14000000");
    batten_model_unref(inner);
    batten_model_unref(outer);
}

TEST(many_instances_of_one_are_many_objects)
{
    batten_model *inner = NULL, *outer = NULL, *flat = NULL;
    CHECK_OK(batten_model_create(1, &inner));
    add_point(inner, "p", 1);
    for (int depth = 0; depth < 5; depth++) {
        CHECK_OK(batten_model_create(1, &outer));
        add_instance(outer, "a", inner, batten_affine_identity());
        add_instance(outer, "b", inner, batten_affine_identity());
        batten_model_unref(inner);
        inner = outer;
    }
    CHECK_OK(batten_model_flat(inner, &flat));
    CHECK_INT(batten_model_count(flat), 32);
    CHECK_TEXT(batten_model_object(flat, 31)->name, "b/b/b/b/b/p");
    batten_model_unref(flat);
    batten_model_unref(inner);
}

TEST(an_instance_must_fit_its_model)
{
    batten_model *metres = NULL, *millimetres = NULL;
    CHECK_OK(batten_model_create(1, &metres));
    CHECK_OK(batten_model_create(0.001, &millimetres));
    batten_object instance = {.name = "part",
                              .kind = BATTEN_OBJECT_INSTANCE,
                              .definition = millimetres,
                              .place = batten_affine_identity()};
    CHECK_STATUS(batten_model_add(metres, &instance), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("another unit");
    instance.definition = metres;
    CHECK_STATUS(batten_model_add(metres, &instance), BATTEN_BAD_ARGUMENT);
    instance.place.t[1] = NAN;
    batten_model *other = NULL;
    CHECK_OK(batten_model_create(1, &other));
    CHECK_STATUS(batten_model_add(other, &instance), BATTEN_NOT_FINITE);
    batten_model_unref(other);
    batten_model_unref(millimetres);
    batten_model_unref(metres);
}

TEST(bodies_and_meshes_are_mapped_as_objects)
{
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const int corners[] = {0, 1, 2};
    const batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners};
    batten_body *body = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1});
    batten_mesh *mesh = NULL;
    batten_model *model = NULL, *scaled = NULL;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "box",
                                                      .group = "parts",
                                                      .is_hidden = true,
                                                      .kind = BATTEN_OBJECT_BODY,
                                                      .body = body}));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "m", .kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    CHECK_OK(batten_model_to_unit(model, 0.001, &scaled));
    const batten_object *box = batten_model_object(scaled, 0);
    CHECK_TEXT(box->group, "parts");
    CHECK(box->is_hidden);
    CHECK_NEAR(batten_body_box(box->body).high.z, 1000, 1e-10);
    CHECK_NEAR(batten_mesh_box(batten_model_object(scaled, 1)->mesh).high.x, 1000, 1e-10);
    batten_model_unref(scaled);
    batten_model_unref(model);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}
