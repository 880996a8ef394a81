#include "picture/sheet/flat.h"

#include "picture/scenes.h"
#include "support/bodies.h"

static batten_model *flatten_shaded(batten_model *model, int width, int height,
                                    batten_shading shading)
{
    batten_draw_options options = batten_draw_defaults();
    batten_model *flat = NULL;
    options.width = width;
    options.height = height;
    options.shading = shading;
    CHECK_OK(bat_picture_model(model, &options, NULL, &flat));
    batten_model_unref(model);
    return flat;
}

static batten_model *flatten_model(batten_model *model, int width, int height)
{
    return flatten_shaded(model, width, height, BATTEN_SHADING_PLAIN);
}

static void add_body(batten_model *model, const batten_body *body)
{
    CHECK_OK(batten_model_add(
        model, &(batten_object){
                   .name = "block", .layer = "", .kind = BATTEN_OBJECT_BODY, .body = body}));
}

/* A box 2 x 3 x 4 whose faces have these colours; below 0: none of their own. */
static batten_body *coloured_box(const double reds[6])
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){2, 3, 4}), *made = NULL;
    batten_body_parts parts = *batten_body_view(box);
    batten_body_face faces[6];
    for (int i = 0; i < 6; i++) {
        faces[i] = parts.faces[i];
        faces[i].has_colour = reds[i] >= 0;
        faces[i].colour[0] = reds[i];
        faces[i].colour[1] = faces[i].colour[2] = 0.5;
    }
    parts.faces = faces;
    CHECK_OK(batten_body_create(&parts, &made));
    batten_body_unref(box);
    return made;
}

static double area_of(const batten_mesh_parts *mesh)
{
    double area = 0;
    for (int t = 0; t < mesh->triangle_count; t++) {
        const double *a = mesh->points + 3 * mesh->corners[3 * t],
                     *b = mesh->points + 3 * mesh->corners[3 * t + 1],
                     *c = mesh->points + 3 * mesh->corners[3 * t + 2];
        const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                     v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        area += hypot(hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2]),
                      u[0] * v[1] - u[1] * v[0]) /
                2;
    }
    return area;
}

TEST(a_body_becomes_a_mesh_for_each_colour_of_its_faces)
{
    static const double reds[] = {0.25, -1, 0.25, 0.75, -1, -1};
    batten_model *model = scene_empty();
    batten_body *box = coloured_box(reds);
    add_body(model, box);
    batten_body_unref(box);
    batten_model *flat = flatten_model(model, 1200, 800);
    CHECK_INT(batten_model_count(flat), 3);
    double whole = 0;
    for (int i = 0; i < 3; i++) {
        const batten_object *object = batten_model_object(flat, i);
        const batten_mesh_parts *mesh = batten_mesh_view(object->mesh);
        CHECK_INT(object->kind, BATTEN_OBJECT_MESH);
        CHECK(object->body == NULL && mesh->faces != NULL && mesh->normals != NULL);
        for (int t = 0; t < mesh->triangle_count; t++) {
            const double red = reds[mesh->faces[t]];
            CHECK(object->has_colour == (red >= 0));
            if (object->has_colour)
                CHECK_NEAR(object->colour[0], red, 0);
        }
        whole += area_of(mesh);
    }
    CHECK_NEAR(whole, 2 * (2 * 3 + 3 * 4 + 4 * 2), 1e-9);
    batten_model_unref(flat);
}

TEST(faces_of_one_colour_stay_one_mesh)
{
    static const double reds[] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5},
                        none[] = {-1, -1, -1, -1, -1, -1};
    for (int k = 0; k < 2; k++) {
        batten_model *model = scene_empty();
        batten_body *box = coloured_box(k ? none : reds);
        add_body(model, box);
        batten_body_unref(box);
        batten_model *flat = flatten_model(model, 1200, 800);
        CHECK_INT(batten_model_count(flat), 1);
        const batten_mesh_parts *mesh = batten_mesh_view(batten_model_object(flat, 0)->mesh);
        CHECK_INT(mesh->triangle_count, 12);
        CHECK_NEAR(area_of(mesh), 52, 1e-9);
        for (int t = 0; t < mesh->triangle_count; t++)
            for (int c = 0; c < 3; c++) {
                const double *n = mesh->normals + 9 * t + 3 * c;
                CHECK_NEAR(hypot(hypot(n[0], n[1]), n[2]), 1, 1e-12);
            }
        batten_model_unref(flat);
    }
}

TEST(hidden_objects_are_left_out_unless_all_are_hidden)
{
    for (int hidden = 0; hidden <= 2; hidden++) {
        batten_model *model = scene_empty();
        for (int i = 0; i < 2; i++) {
            batten_curve *circle = scene_circle(1 + i);
            CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "b" : "a",
                                                              .layer = "",
                                                              .kind = BATTEN_OBJECT_CURVE,
                                                              .is_hidden = i < hidden,
                                                              .curve = circle}));
            batten_curve_unref(circle);
        }
        batten_model *flat = flatten_model(model, 1200, 800);
        CHECK_INT(batten_model_count(flat), hidden == 1 ? 1 : 2);
        CHECK_TEXT(batten_model_object(flat, 0)->name, hidden == 1 ? "b" : "a");
        batten_model_unref(flat);
    }
}

TEST(a_larger_picture_has_a_finer_mesh_of_a_body)
{
    int counts[2];
    for (int k = 0; k < 2; k++) {
        batten_model *model = scene_empty();
        batten_surface *sphere = scene_sphere(1);
        batten_body *body = NULL;
        CHECK_OK(batten_body_from_surface("ball", sphere, 1e-6, &body));
        batten_surface_unref(sphere);
        add_body(model, body);
        batten_body_unref(body);
        batten_model *flat = flatten_model(model, k ? 4000 : 200, 100);
        counts[k] = batten_mesh_view(batten_model_object(flat, 0)->mesh)->triangle_count;
        batten_model_unref(flat);
    }
    CHECK(counts[1] > 4 * counts[0]);
}

/* Of a flat face a plain picture needs few triangles; stripes follow normals that may turn on it. */
TEST(stripes_have_small_triangles_where_plain_shades_have_large_ones)
{
    int counts[2];
    for (int k = 0; k < 2; k++) {
        static const double plain[6] = {-1, -1, -1, -1, -1, -1};
        batten_model *model = scene_empty();
        batten_body *box = coloured_box(plain);
        add_body(model, box);
        batten_body_unref(box);
        batten_model *flat = flatten_shaded(model, 1200, 800,
                                            k ? BATTEN_SHADING_ZEBRA : BATTEN_SHADING_ISOLINES);
        counts[k] = batten_mesh_view(batten_model_object(flat, 0)->mesh)->triangle_count;
        batten_model_unref(flat);
    }
    CHECK_INT(counts[0], 12);
    CHECK(counts[1] > 10000); /* edges of a hundredth of the picture */
}
