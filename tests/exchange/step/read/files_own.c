/* What Batten writes it reads back, bit for bit. */
#include "exchange/step/reading.h"

#include <batten/standard.h>

/* Written, read and written again. */
static batten_model *again(const batten_model *model)
{
    const char *first = step_text(model, NULL);
    batten_model *read = NULL;
    CHECK_OK(read_text(first, BATTEN_FORMAT_STEP, NULL, &read));
    const char *second = step_text(read, NULL);
    CHECK_TEXT(second, first);
    return read;
}

/* The objects of a kind, in their order, are those from `next` on. */
static int check_kind(const batten_model *model, const batten_model *read,
                      batten_object_kind kind, int next)
{
    for (int k = 0; k < batten_model_count(model); k++) {
        const batten_object *a = batten_model_object(model, k);
        if (a->kind != kind)
            continue;
        CHECK(next < batten_model_count(read));
        const batten_object *b = batten_model_object(read, next++);
        CHECK_INT(b->kind, kind);
        CHECK_TEXT(b->name, a->name);
        CHECK_TEXT(b->layer, a->layer);
        CHECK_INT(b->has_colour, a->has_colour);
        for (int i = 0; a->has_colour && i < 3; i++)
            CHECK_BITS(b->colour[i], a->colour[i]);
        if (a->curve)
            check_same_curve(a->curve, b->curve);
        if (a->surface)
            check_same_surface(a->surface, b->surface);
    }
    return next;
}

TEST(curves_and_surfaces_read_back_bit_for_bit)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(100); i++) {
        batten_model *model = random_model(&random, i % 2 ? 0.001 : 0.0254);
        batten_model *read = again(model);
        CHECK_BITS(batten_model_unit_metres(read), batten_model_unit_metres(model));
        int next = check_kind(model, read, BATTEN_OBJECT_SURFACE, 0);
        next = check_kind(model, read, BATTEN_OBJECT_CURVE, next);
        CHECK_INT(batten_model_count(read), next);
        batten_model_unref(read);
        batten_model_unref(model);
    }
}

TEST(closed_surfaces_and_poles_read_back_as_surfaces)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *surfaces[5] = {NULL};
    batten_model *model = NULL;
    CHECK_OK(batten_surface_cylinder(&frame, 2, 5, &surfaces[0]));
    CHECK_OK(batten_surface_cone(&frame, 2, 0, 5, &surfaces[1]));
    CHECK_OK(batten_surface_sphere(&frame, 2, &surfaces[2]));
    CHECK_OK(batten_surface_torus(&frame, 5, 1, &surfaces[3]));
    CHECK_OK(batten_surface_cone(&frame, 2, 1, 5, &surfaces[4]));
    CHECK_OK(batten_model_create(1, &model));
    for (int k = 0; k < COUNT(surfaces); k++)
        add_surface(model, "shape", surfaces[k]);
    batten_model *read = again(model);
    CHECK_INT(batten_model_count(read), COUNT(surfaces));
    for (int k = 0; k < COUNT(surfaces); k++) {
        CHECK_INT(batten_model_object(read, k)->kind, BATTEN_OBJECT_SURFACE);
        check_same_surface(surfaces[k], batten_model_object(read, k)->surface);
        batten_surface_unref(surfaces[k]);
    }
    batten_model_unref(read);
    batten_model_unref(model);
}

TEST(looks_of_all_kinds_of_objects_read_back)
{
    static const double points[] = {0, 0, 0, 1, 2, 3, 4, 5, 7};
    test_random random = test_random_begin(__func__);
    batten_model *model = NULL;
    batten_surface *surface = random_surface(&random);
    batten_curve *curve = random_curve(&random);
    CHECK_OK(batten_model_create(0.001, &model));
    const batten_object objects[] = {{.name = "shell",
                                      .layer = "hull",
                                      .group = "ship/outer",
                                      .has_colour = true,
                                      .colour = {0.25, 0.5, 1},
                                      .kind = BATTEN_OBJECT_SURFACE,
                                      .surface = surface},
                                     {.name = "sheer",
                                      .layer = "lines",
                                      .is_hidden = true,
                                      .kind = BATTEN_OBJECT_CURVE,
                                      .curve = curve},
                                     {.name = "marks",
                                      .has_colour = true,
                                      .colour = {1, 0, 0},
                                      .kind = BATTEN_OBJECT_POINTS,
                                      .point_count = 3,
                                      .points = points}};
    for (int k = 0; k < COUNT(objects); k++)
        CHECK_OK(batten_model_add(model, &objects[k]));
    batten_model *read = again(model);
    CHECK_INT(batten_model_count(read), COUNT(objects));
    for (int k = 0; k < COUNT(objects); k++) {
        const batten_object *a = batten_model_object(model, k),
                            *b = batten_model_object(read, k);
        CHECK_TEXT(b->name, a->name);
        CHECK_TEXT(b->layer, a->layer);
        CHECK_TEXT(b->group, a->group);
        CHECK_INT(b->is_hidden, a->is_hidden);
        CHECK_INT(b->kind, a->kind);
        CHECK_INT(b->has_colour, a->has_colour);
        for (int i = 0; a->has_colour && i < 3; i++)
            CHECK_BITS(b->colour[i], a->colour[i]);
        CHECK_INT(b->point_count, a->point_count);
    }
    batten_model_unref(read);
    batten_model_unref(model);
    batten_surface_unref(surface);
    batten_curve_unref(curve);
}

TEST(bodies_and_instances_read_back)
{
    const batten_frame frame = batten_frame_world();
    const batten_affine place =
        batten_affine_rotation((batten_vec3){1, 2, 3}, (batten_vec3){0.3, -0.4, 0.5}, 0.7);
    batten_model *part = NULL, *model = NULL;
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_torus(&frame, 5, 1, &surface));
    CHECK_OK(batten_body_from_surface("ring", surface, 1e-6, &body));
    batten_body_parts solid = *batten_body_view(body);
    solid.is_solid = true;
    batten_body *made = NULL;
    CHECK_OK(batten_body_create(&solid, &made));
    CHECK_OK(batten_model_create(0.001, &part));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        part, &(batten_object){.name = "ring", .kind = BATTEN_OBJECT_BODY, .body = made}));
    for (int k = 0; k < 2; k++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = k ? "second" : "first",
                                                          .kind = BATTEN_OBJECT_INSTANCE,
                                                          .definition = part,
                                                          .place = place}));
    batten_model *read = again(model);
    CHECK_INT(batten_model_count(read), 2);
    CHECK_TEXT(batten_model_object(read, 1)->name, "second");
    const batten_object *ring =
        batten_model_object(batten_model_object(read, 0)->definition, 0);
    CHECK(batten_body_view(ring->body)->is_solid);
    check_same_surface(surface, batten_body_view(ring->body)->faces[0].surface);
    CHECK(batten_body_view(ring->body)->uses[0].parameters != NULL);
    batten_model_unref(read);
    batten_model_unref(part);
    batten_model_unref(model);
    batten_body_unref(made);
    batten_body_unref(body);
    batten_surface_unref(surface);
}
