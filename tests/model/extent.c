/* The box of a model: of its objects, and of what its instances place. */
#include "support/bodies.h"
#include "support/test.h"

#include <batten/model.h>

static batten_model *make_model(void)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    return model;
}

static void add_points(batten_model *model, int count, const double *points)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = count,
                                                      .points = points}));
}

static void place(batten_model *model, const batten_model *definition, batten_affine at)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = definition,
                                                      .place = at}));
}

static void check_model_box(const batten_model *model, batten_vec3 low, batten_vec3 high,
                            double room)
{
    batten_box box;
    CHECK(batten_model_box(model, &box));
    CHECK_NEAR(box.low.x, low.x, room);
    CHECK_NEAR(box.low.y, low.y, room);
    CHECK_NEAR(box.low.z, low.z, room);
    CHECK_NEAR(box.high.x, high.x, room);
    CHECK_NEAR(box.high.y, high.y, room);
    CHECK_NEAR(box.high.z, high.z, room);
}

TEST(the_box_of_an_instance_is_that_of_the_placed_corners)
{
    const double ends[] = {0, 0, 0, 2, 4, 6};
    const batten_affine turn = batten_affine_rotation((batten_vec3){0, 0, 0},
                                                      (batten_vec3){0, 0, 1}, atan(1)),
                        mirror = {.m = {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, .t = {1, 1, 1}};
    batten_model *part = make_model(), *turned = make_model(), *mirrored = make_model();
    add_points(part, 2, ends);
    place(turned, part, turn);
    place(mirrored, part, mirror);
    /* Corners (x, y) go to (x - y, x + y) / sqrt(2). */
    const double h = sqrt(0.5);
    check_model_box(turned, (batten_vec3){-4 * h, 0, 0}, (batten_vec3){2 * h, 6 * h, 6}, 1e-14);
    check_model_box(mirrored, (batten_vec3){-1, -3, -5}, (batten_vec3){1, 1, 1}, 0);
    batten_model_unref(part);
    batten_model_unref(turned);
    batten_model_unref(mirrored);
}

TEST(the_box_holds_meshes_and_bodies_that_are_placed)
{
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 9};
    const int corners[] = {0, 1, 2};
    const batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners};
    batten_mesh *mesh = NULL;
    batten_body *body = test_box((batten_vec3){-3, 0, 0}, (batten_vec3){1, 5, 1});
    batten_model *part = make_model(), *whole = make_model();
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(
        batten_model_add(part, &(batten_object){.kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    CHECK_OK(
        batten_model_add(part, &(batten_object){.kind = BATTEN_OBJECT_BODY, .body = body}));
    place(whole, part, batten_affine_translation(10, 0, 0));
    check_model_box(part, (batten_vec3){-3, 0, 0}, (batten_vec3){1, 5, 9}, 0);
    check_model_box(whole, (batten_vec3){7, 0, 0}, (batten_vec3){11, 5, 9}, 0);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
    batten_model_unref(part);
    batten_model_unref(whole);
}

TEST(a_definition_without_objects_adds_nothing_to_the_box)
{
    const double point[] = {5, 6, 7};
    batten_model *nothing = make_model(), *whole = make_model();
    batten_box box = {{7, 7, 7}, {7, 7, 7}};
    place(whole, nothing, batten_affine_translation(-100, 0, 0));
    CHECK(!batten_model_box(whole, &box));
    CHECK(box.low.x == 7 && box.high.z == 7);
    add_points(whole, 1, point);
    check_model_box(whole, (batten_vec3){5, 6, 7}, (batten_vec3){5, 6, 7}, 0);
    batten_model_unref(nothing);
    batten_model_unref(whole);
}

TEST(the_box_is_that_of_all_objects_however_often_it_was_asked_for)
{
    const double first[] = {1, 1, 1}, second[] = {-2, 0, 3};
    batten_model *part = make_model(), *before = make_model(), *after = make_model();
    add_points(part, 1, first);
    place(before, part, batten_affine_identity());
    for (int i = 0; i < 2; i++)
        check_model_box(before, (batten_vec3){1, 1, 1}, (batten_vec3){1, 1, 1}, 0);
    add_points(part, 1, second);
    check_model_box(part, (batten_vec3){-2, 0, 1}, (batten_vec3){1, 1, 3}, 0);
    place(after, part, batten_affine_translation(1, 0, 0));
    check_model_box(after, (batten_vec3){-1, 0, 1}, (batten_vec3){2, 1, 3}, 0);
    batten_model_unref(part);
    batten_model_unref(before);
    batten_model_unref(after);
}

/* 3^32 places of one point and of one body, whose box needs memory. */
TEST(S4_the_box_is_found_in_linear_time_with_and_without_memory)
{
    const double point[] = {1, 2, 3};
    batten_body *body = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1});
    batten_model *inner = make_model();
    add_points(inner, 1, point);
    CHECK_OK(
        batten_model_add(inner, &(batten_object){.kind = BATTEN_OBJECT_BODY, .body = body}));
    for (int depth = 0; depth < 32; depth++) {
        batten_model *outer = make_model();
        for (int i = 0; i < 3; i++)
            place(outer, inner, batten_affine_translation(0, i, 0));
        batten_model_unref(inner);
        inner = outer;
    }
    check_model_box(inner, (batten_vec3){0, 0, 0}, (batten_vec3){1, 66, 3}, 0);
    batten_model_unref(inner);
    batten_body_unref(body);
}
