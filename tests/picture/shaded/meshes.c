#include "picture/scenes.h"
#include "support/bodies.h"
#include "support/drilled_box.h"

#include <stdlib.h>

typedef batten_status drawer(const batten_model *model, const batten_draw_options *options,
                             const batten_job *job, char **data, size_t *size);

static batten_status draw_curves(const batten_model *model, const batten_draw_options *options,
                                 const batten_job *job, char **data, size_t *size)
{
    (void)job;
    return batten_draw(model, options, data, size);
}

static batten_draw_options from(double azimuth, double elevation)
{
    batten_draw_options options = batten_draw_defaults();
    options.width = 300;
    options.height = 200;
    options.azimuth = azimuth;
    options.elevation = elevation;
    options.view = BATTEN_VIEW_AXONOMETRIC;
    return options;
}

static scene_image image_of(drawer *draw, const batten_model *model,
                            batten_draw_options options)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(draw(model, &options, NULL, &data, &size));
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    return image;
}

static batten_model *model_of(batten_object object)
{
    batten_model *model = NULL;
    object.name = "it";
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &object));
    return model;
}

static batten_model *block(void)
{
    batten_body *body = NULL;
    CHECK_OK(drilled_box(&body));
    batten_model *model = model_of((batten_object){.kind = BATTEN_OBJECT_BODY, .body = body});
    batten_body_unref(body);
    return model;
}

/* The same as a mesh without normals. */
static batten_model *bare_mesh(void)
{
    batten_body *body = NULL;
    batten_mesh *mesh = NULL, *bare = NULL;
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_mesh_from_body(body, NULL, NULL, NULL, NULL, &mesh));
    batten_mesh_parts parts = *batten_mesh_view(mesh);
    parts.normals = NULL;
    parts.faces = NULL;
    CHECK_OK(batten_mesh_create(&parts, &bare));
    batten_model *model = model_of((batten_object){.kind = BATTEN_OBJECT_MESH, .mesh = bare});
    batten_mesh_unref(bare);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
    return model;
}

static int parts_of(int pixel, int part)
{
    return pixel >> (16 - 8 * part) & 255;
}

TEST(faces_of_a_body_have_their_colours)
{
    /* From above: the top is orange, but for the hole, through which nothing is seen. */
    batten_model *model = block();
    const scene_image image =
        image_of(batten_draw_shaded, model, from(-0.5 * 3.14159265358979323846, 1.5707));
    const int top = (int)scene_pixel(&image, 80, 60);
    CHECK(parts_of(top, 0) > parts_of(top, 1) + 30);
    CHECK(parts_of(top, 1) > parts_of(top, 2) + 30);
    CHECK(scene_pixel(&image, 150, 100) == scene_pixel(&image, 0, 100));
    batten_model_unref(model);
}

/* How many pixels are not background. */
static int covered(const scene_image *image)
{
    int count = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            count += scene_pixel(image, x, y) != scene_pixel(image, 0, y);
    return count;
}

TEST(a_mesh_covers_what_the_body_covers)
{
    batten_model *bodies = block(), *meshes = bare_mesh();
    for (int i = 0; i < test_cases(6); i++) {
        const batten_draw_options options = from(i, 0.3 * i - 0.8);
        const scene_image a = image_of(batten_draw_shaded, bodies, options);
        const int body = covered(&a);
        const scene_image b = image_of(batten_draw_shaded, meshes, options);
        CHECK(body > 5000);
        CHECK_NEAR(covered(&b), body, 0.01 * body);
    }
    batten_model_unref(bodies);
    batten_model_unref(meshes);
}

TEST(all_shadings_and_views_take_bodies_and_meshes)
{
    static drawer *const drawers[] = {draw_curves, batten_draw_shaded,
                                      batten_draw_surface_lines};
    batten_model *models[2] = {block(), bare_mesh()};
    for (int m = 0; m < 2; m++)
        for (int d = 0; d < 3; d++)
            for (int s = 0; s < (d == 1 ? 6 : 2); s++) {
                batten_draw_options options = from(0.5, 0.4);
                options.shading = d == 1 ? (batten_shading)s : BATTEN_SHADING_PLAIN;
                options.hidden = s ? BATTEN_HIDDEN_DROPPED : BATTEN_HIDDEN_SHOWN;
                options.silhouettes = s == 1;
                const scene_image image = image_of(drawers[d], models[m], options);
                CHECK(covered(&image) > 500);
            }
    batten_model_unref(models[0]);
    batten_model_unref(models[1]);
}

TEST(bodies_hide_their_own_edges)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){3, 2, 1});
    batten_model *model = model_of((batten_object){.kind = BATTEN_OBJECT_BODY, .body = box});
    batten_draw_options options = from(0.5, 0.4);
    options.hidden = BATTEN_HIDDEN_SHOWN;
    options.distance = 30;
    const scene_image all = image_of(batten_draw_surface_lines, model, options);
    const int shown = covered(&all);
    options.hidden = BATTEN_HIDDEN_DROPPED;
    const scene_image some = image_of(batten_draw_surface_lines, model, options);
    /* Three of twelve edges are behind. */
    CHECK(covered(&some) < 0.9 * shown);
    CHECK(covered(&some) > 0.6 * shown);
    batten_model_unref(model);
    batten_body_unref(box);
}

TEST(hidden_objects_and_instances)
{
    batten_model *part = block(), *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = "placed",
                                    .kind = BATTEN_OBJECT_INSTANCE,
                                    .definition = part,
                                    .is_hidden = i == 1,
                                    .place = batten_affine_translation(100.0 * i, 0, 0)}));
    const batten_draw_options options = from(0.5, 0.4);
    const scene_image one = image_of(batten_draw_shaded, part, options);
    const int alone = covered(&one);
    const scene_image two = image_of(batten_draw_shaded, model, options);
    CHECK_INT(covered(&two), alone);
    batten_model_unref(model);
    batten_model_unref(part);
}
