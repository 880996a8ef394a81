/* The models that instances place, each once, and which of their objects are alike. */
#include "model/definitions.h"
#include "model/placed_counts.h"
#include "support/bodies.h"
#include "support/test.h"

#include <batten/standard.h>

static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
static const int corners[] = {0, 1, 2};

static batten_mesh *triangle(void)
{
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_mesh_create(
        &(batten_mesh_parts){
            .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners},
        &mesh));
    return mesh;
}

static batten_model *empty(const char *name)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_set_name(model, name));
    return model;
}

static void add_points(batten_model *model, const char *name, int count)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = count,
                                                      .points = points}));
}

static void place(batten_model *model, const char *name, const batten_model *definition)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = definition,
                                                      .place = batten_affine_identity()}));
}

/* The root has 2 points, then places `outer` twice and `inner` once; outer has a point and
 * places inner three times; inner has 3 points. */
static batten_model *nested(void)
{
    batten_model *root = empty(""), *outer = empty(""), *inner = empty("pin");
    add_points(inner, "inside", 3);
    add_points(outer, "between", 1);
    for (int i = 0; i < 3; i++)
        place(outer, "in", inner);
    add_points(root, "outside", 2);
    place(root, "first", outer);
    place(root, "second", outer);
    place(root, "alone", inner);
    batten_model_unref(outer);
    batten_model_unref(inner);
    return root;
}

typedef struct {
    char said[200];
} story;

static batten_status tell(void *context, int index, const char *name)
{
    story *s = context;
    sprintf(s->said + strlen(s->said), "%d %s;", index, name);
    return BATTEN_OK;
}

TEST(each_model_that_is_placed_is_found_once_and_comes_after_those_that_it_places)
{
    batten_model *root = nested();
    bat_definitions found = {0};
    story s = {""};
    const char *names[3];
    int order[3];
    CHECK_OK(bat_definitions_find(root, &found));
    CHECK_INT(found.count, 3);
    CHECK(found.models[0] == root);
    static const int first[] = {0, 4, 8, 9};
    for (int i = 0; i < 4; i++)
        CHECK_INT(found.first[i], first[i]);
    for (int i = 0; i < 3; i++)
        CHECK_INT(bat_definitions_index(&found, found.models[i]), i);
    CHECK_INT(batten_model_count(found.models[1]), 4); /* outer comes up first */
    bat_definitions_rising(&found, order);
    CHECK(order[0] == 2 && order[1] == 1 && order[2] == 0);
    bat_definitions_names(&found, names);
    CHECK_TEXT(names[0], "");
    CHECK_TEXT(names[1], "first"); /* it has no name of its own */
    CHECK_TEXT(names[2], "pin");
    CHECK_OK(bat_definitions_each(&found, tell, &s));
    if (test_cases(1000) >= 1000)
        CHECK_TEXT(s.said, "2 pin;1 first;0 ;");
    bat_definitions_end(&found);
    batten_model_unref(root);
}

TEST(what_instances_place_is_counted_without_placing_it)
{
    batten_model *root = nested();
    bat_placed own = {0}, placed = {0};
    CHECK_OK(bat_count_placed(root, &own, &placed));
    CHECK_BITS(own.objects, 4 + 4 + 1);
    CHECK_BITS(own.points, 2 + 1 + 3);
    /* inner: 1 object; outer: 4 + 3; root: 4 + 2 * 7 + 1 */
    CHECK_BITS(placed.objects, 4 + 2 * 7 + 1);
    CHECK_BITS(placed.points, 2 + 2 * (1 + 3 * 3) + 3);
    batten_model_unref(root);
}

/* A box has six faces of four points, and twelve edges of two. */
TEST(points_of_every_kind_of_object_are_counted)
{
    batten_model *model = empty("");
    bat_placed own = {0}, placed = {0};
    batten_mesh *mesh = triangle();
    batten_curve *curve = NULL;
    batten_body *body = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, points}, &curve));
    static const double due[] = {3, 6, 10, 6 * 4 + 12 * 2 + 10};
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "curve", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "mesh", .kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    add_points(model, "points", 1);
    CHECK_OK(bat_count_placed(model, &own, &placed));
    CHECK_BITS(own.points, due[0] + due[1] - 3 + 1);
    const batten_surface *face = batten_body_view(body)->faces[0].surface;
    CHECK_OK(batten_model_add(
        model,
        &(batten_object){.name = "face", .kind = BATTEN_OBJECT_SURFACE, .surface = face}));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "box", .kind = BATTEN_OBJECT_BODY, .body = body}));
    CHECK_OK(bat_count_placed(model, &own, &placed));
    CHECK_BITS(own.points, 7 + 4 + 6 * 4 + 12 * 2);
    CHECK_BITS(placed.points, own.points);
    batten_body_unref(body);
    batten_curve_unref(curve);
    batten_mesh_unref(mesh);
    batten_model_unref(model);
}

/* Objects of one mesh; of these, those of one name and colour. */
TEST(objects_of_one_mesh_are_known_and_those_that_look_alike)
{
    static const struct {
        const char *name;
        int mesh;
        bool has_colour;
        double colour[3];
        int same_mesh, same_look;
    } objects[] = {{"a", 0, false, {0}, 0, 0},         {"a", 1, false, {0}, 1, 1},
                   {"a", 0, false, {0}, 0, 0},         {"b", 0, false, {0}, 0, 3},
                   {"a", 0, true, {1, 0, 0}, 0, 4},    {"a", 0, true, {1, 0, 0.5}, 0, 5},
                   {"a", 0, true, {1, 0, 0}, 0, 4},    {"b", 1, false, {0}, 1, 7},
                   {"a", 1, false, {0}, 1, 1},         {"a", 0, true, {0, 1, 0}, 0, 9},
                   {"a", 0, true, {1, 0.25, 0}, 0, 10}};
    batten_mesh *meshes[] = {triangle(), triangle()};
    batten_model *model = empty("");
    bat_definitions found = {0};
    int mesh[COUNT(objects) + 1], look[COUNT(objects) + 1];
    for (int i = 0; i < COUNT(objects); i++) {
        batten_object object = {.name = objects[i].name,
                                .kind = BATTEN_OBJECT_MESH,
                                .mesh = meshes[objects[i].mesh],
                                .has_colour = objects[i].has_colour};
        memcpy(object.colour, objects[i].colour, sizeof object.colour);
        CHECK_OK(batten_model_add(model, &object));
    }
    add_points(model, "p", 1);
    CHECK_OK(bat_definitions_find(model, &found));
    CHECK_OK(bat_definitions_meshes(&found, mesh, look));
    for (int i = 0; i < COUNT(objects); i++) {
        CHECK_INT(mesh[i], objects[i].same_mesh);
        CHECK_INT(look[i], objects[i].same_look);
    }
    CHECK_INT(mesh[COUNT(objects)], COUNT(objects));
    CHECK_INT(look[COUNT(objects)], COUNT(objects));
    bat_definitions_end(&found);
    batten_model_unref(model);
    batten_mesh_unref(meshes[0]);
    batten_mesh_unref(meshes[1]);
}
