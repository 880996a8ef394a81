/* Files of glTF: nodes, scenes, materials, primitives, and what is refused. */
#include "exchange/meshes/meshes.h"
#include "exchange/reading/bytes.h"
#include "support/json.h"

/* A tetrahedron, and two places of a model with one. */
static batten_model *placed_model(double unit)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_model *inner = NULL, *model = NULL;
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_model_create(unit, &inner));
    CHECK_OK(batten_model_create(unit, &model));
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_model_add(inner, &(batten_object){.name = "bolt \"M8\"",
                                                      .has_colour = true,
                                                      .colour = {1, 0.5, 0},
                                                      .kind = BATTEN_OBJECT_MESH,
                                                      .mesh = mesh}));
    batten_mesh_unref(mesh);
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = i ? "right" : "left",
                                    .kind = BATTEN_OBJECT_INSTANCE,
                                    .definition = inner,
                                    .place = batten_affine_translation(10 * i, 20, 30)}));
    add_mesh(model, "plate", &parts);
    batten_model_unref(inner);
    return model;
}

/* The chunk of JSON, ended by a zero byte, and that of bytes. */
static char *check_chunks(const char *data, size_t size, const char **bytes, size_t *count)
{
    CHECK(memcmp(data, "glTF", 4) == 0);
    CHECK_INT(bat_bytes_u32(data + 4), 2);
    CHECK_INT(bat_bytes_u32(data + 8), (long long)size);
    const size_t length = bat_bytes_u32(data + 12);
    CHECK(memcmp(data + 16, "JSON", 4) == 0);
    CHECK_INT((long long)(length % 4), 0);
    char *json = test_array(length + 1, 1);
    memcpy(json, data + 20, length);
    *count = bat_bytes_u32(data + 20 + length);
    CHECK(memcmp(data + 24 + length, "BIN\0", 4) == 0);
    *bytes = data + 28 + length;
    CHECK_INT((long long)(28 + length + *count), (long long)size);
    CHECK_INT((long long)(*count % 4), 0);
    return json;
}

TEST(instances_are_nodes_that_share_a_mesh)
{
    batten_model *model = placed_model(0.001);
    char *data = NULL;
    const char *bytes = NULL;
    size_t size = 0, count = 0;
    double matrix[16], low[3], high[3];
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
    const char *json = check_chunks(data, size, &bytes, &count);
    const char *nodes = json_key(json, "nodes");
    CHECK(json_item(nodes, 4) != NULL && json_item(nodes, 5) == NULL);
    CHECK(json_item(json_key(json, "meshes"), 1) != NULL);
    CHECK(json_item(json_key(json, "meshes"), 2) == NULL);
    for (int i = 0; i < 2; i++) {
        const int child =
            (int)json_number(json_item(json_key(json_item(nodes, i), "children"), 0));
        CHECK_INT(child, 3 + i);
        CHECK_INT((int)json_number(json_key(json_item(nodes, child), "mesh")), 1);
        CHECK_INT(json_numbers(json_key(json_item(nodes, i), "matrix"), 16, matrix), 16);
        CHECK_NEAR(matrix[12], 0.01 * i, 1e-15);
        CHECK_NEAR(matrix[13], 0.03, 1e-15);
        CHECK_NEAR(matrix[14], -0.02, 1e-15);
        CHECK(matrix[0] == 1 && matrix[5] == 1 && matrix[10] == 1 && matrix[15] == 1);
    }
    CHECK_CONTAINS(json, "\"name\":\"bolt \\\"M8\\\"\"");
    const char *accessor = json_item(json_key(json, "accessors"), 0);
    json_numbers(json_key(accessor, "min"), 3, low);
    json_numbers(json_key(accessor, "max"), 3, high);
    CHECK_BITS(high[0], (double)0.001f);
    CHECK_BITS(low[2], -(double)0.001f);
    CHECK_BITS(bat_bytes_float(bytes, false), 0.0);
    CHECK_INT((long long)json_number(json_key(accessor, "count")), 4);
    batten_release(data);
    batten_model_unref(model);
}

/* A matrix that says nothing is not written: checkers of glTF object to it. */
TEST(an_instance_that_stays_in_place_has_no_matrix)
{
    batten_model *model = placed_model(0.001);
    const batten_model *inner = batten_model_object(model, 0)->definition;
    batten_model *still = NULL;
    char *data = NULL;
    const char *bytes = NULL;
    size_t size = 0, count = 0;
    CHECK_OK(batten_model_create(0.001, &still));
    CHECK_OK(batten_model_add(still, &(batten_object){.name = "bolt",
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = inner,
                                                      .place = batten_affine_identity()}));
    CHECK_OK(write_form(still, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
    const char *json = check_chunks(data, size, &bytes, &count);
    CHECK(strstr(json, "\"matrix\"") == NULL);
    CHECK_CONTAINS(json, "{\"name\":\"bolt\",\"children\":[1]}");
    batten_release(data);
    batten_model_unref(still);
    batten_model_unref(model);
}

/* The scene has the name of the model, quoted, and its nodes. */
TEST(a_scene_has_the_name_of_the_model_and_all_its_nodes)
{
    static const char *const names[] = {"", "hull \"7\""};
    for (int k = 0; k < 4; k++) {
        batten_model *model = NULL;
        const batten_mesh_parts parts = tetrahedron();
        char *data = NULL;
        const char *bytes = NULL;
        size_t size = 0, count = 0;
        double nodes[2] = {-1, -1};
        CHECK_OK(batten_model_create(1, &model));
        CHECK_OK(batten_model_set_name(model, names[k & 1]));
        for (int i = 0; i < 1 + k / 2; i++)
            add_mesh(model, "part", &parts);
        CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
        const char *json = check_chunks(data, size, &bytes, &count);
        const char *scene = json_item(json_key(json, "scenes"), 0);
        const char *name = json_try(scene, "name");
        CHECK((name != NULL) == (k & 1));
        CHECK(!name || strncmp(name, "\"hull \\\"7\\\"\"", 12) == 0);
        json_numbers(json_key(scene, "nodes"), 1 + k / 2, nodes);
        CHECK(nodes[0] == 0 && nodes[1] == (k / 2 ? 1 : -1));
        CHECK(json_item(json_key(json, "nodes"), k / 2) != NULL);
        batten_release(data);
        batten_model_unref(model);
    }
}

/* Of a mesh too small for floats no triangle is left; it stays as it is, as there is none without. */
TEST(a_mesh_that_rounding_takes_away_keeps_its_triangles)
{
    batten_model *model = NULL;
    double points[12];
    batten_mesh_parts parts = tetrahedron();
    char *data = NULL;
    const char *bytes = NULL;
    size_t size = 0, count = 0;
    for (int i = 0; i < 12; i++)
        points[i] = 1e-60 * tetrahedron_points[i];
    parts.points = points;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "dust", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
    const char *json = check_chunks(data, size, &bytes, &count);
    const char *accessors = json_key(json, "accessors");
    CHECK_INT((int)json_number(json_key(json_item(accessors, 0), "count")), 4);
    CHECK_INT((int)json_number(json_key(json_item(accessors, 1), "count")), 12);
    batten_release(data);
    batten_model_unref(model);
}

TEST(colours_become_materials_of_linear_light)
{
    batten_model *model = placed_model(1);
    char *data = NULL;
    const char *bytes = NULL;
    size_t size = 0, count = 0;
    double colour[4];
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
    const char *json = check_chunks(data, size, &bytes, &count);
    const char *material = json_item(json_key(json, "materials"), 0);
    json_numbers(json_key(json_key(material, "pbrMetallicRoughness"), "baseColorFactor"), 4,
                 colour);
    CHECK_NEAR(colour[0], 1, 1e-15);
    CHECK_NEAR(colour[1], 0.21404114048223255, 1e-12);
    CHECK(colour[2] == 0 && colour[3] == 1);
    batten_release(data);
    batten_model_unref(model);
}

TEST(corners_with_normals_of_their_own_are_vertices_of_their_own)
{
    batten_model *model = NULL;
    double normals[36] = {0}, colours[12] = {0};
    batten_mesh_parts parts = tetrahedron();
    char *data = NULL;
    const char *bytes = NULL;
    size_t size = 0, count = 0;
    for (int i = 0; i < 12; i++)
        normals[3 * i + i / 3 % 3] = 1;
    parts.normals = normals;
    parts.colours = colours;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "s", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
    const char *json = check_chunks(data, size, &bytes, &count);
    const char *accessors = json_key(json, "accessors");
    const int vertices = (int)json_number(json_key(json_item(accessors, 0), "count"));
    CHECK(vertices > 4 && vertices <= 12);
    CHECK_INT((int)json_number(json_key(json_item(accessors, 1), "count")), vertices);
    CHECK_INT((int)json_number(json_key(json_item(accessors, 3), "count")), 12);
    CHECK_CONTAINS(json, "\"attributes\":{\"POSITION\":0,\"NORMAL\":1,\"COLOR_0\":2}");
    /* The first normal, x, stays; the indices are those of vertices that there are. */
    CHECK_BITS(bat_bytes_float(bytes + 12 * vertices, false), 1.0);
    for (int i = 0; i < 12; i++)
        CHECK((int)bat_bytes_u32(bytes + 36 * vertices + 4 * i) < vertices);
    batten_release(data);
    batten_model_unref(model);
}

TEST(equal_models_give_equal_gltf)
{
    char *data[2] = {NULL, NULL};
    size_t size[2];
    for (int i = 0; i < 2; i++) {
        batten_model *model = placed_model(0.0254);
        CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data[i], &size[i]));
        batten_model_unref(model);
    }
    CHECK(size[0] == size[1] && memcmp(data[0], data[1], size[0]) == 0);
    batten_release(data[0]);
    batten_release(data[1]);
}

TEST(what_gltf_cannot_say_is_told)
{
    static const double points[] = {0, 0, 0, 1e300, 0, 0, 0, 1, 0};
    const batten_mesh_parts parts = {.vertex_count = 3,
                                     .points = points,
                                     .triangle_count = 1,
                                     .corners = (const int[]){0, 1, 2}};
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "far", &parts);
    CHECK_STATUS(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size),
                 BATTEN_OVERFLOW);
    CHECK_MESSAGE("a coordinate of vertex 2 of 'far' is 1e+300 m");
    batten_model_unref(model);
}

TEST(S5_instances_within_instances_beyond_a_million_nodes_are_refused)
{
    batten_model *inner = NULL;
    const batten_mesh_parts parts = tetrahedron();
    CHECK_OK(batten_model_create(1, &inner));
    add_mesh(inner, "s", &parts);
    for (int depth = 0; depth < 24; depth++) {
        batten_model *outer = NULL;
        CHECK_OK(batten_model_create(1, &outer));
        for (int k = 0; k < 2; k++)
            CHECK_OK(
                batten_model_add(outer, &(batten_object){.name = "i",
                                                         .kind = BATTEN_OBJECT_INSTANCE,
                                                         .definition = inner,
                                                         .place = batten_affine_identity()}));
        batten_model_unref(inner);
        inner = outer;
    }
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(write_form(inner, BATTEN_FORMAT_GLTF, false, NULL, &data, &size),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("more than 1000000 nodes");
    /* 3MF shares what is placed: it needs one object for each depth. */
    CHECK_OK(write_form(inner, BATTEN_FORMAT_3MF, false, NULL, &data, &size));
    CHECK(size < 16384);
    batten_release(data);
    batten_model_unref(inner);
}

TEST(triangles_of_one_colour_are_a_primitive)
{
    batten_mesh_parts parts = tetrahedron();
    const double colours[] = {1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0};
    batten_model *model = NULL;
    char *data = NULL;
    const char *bytes = NULL;
    size_t size = 0, count = 0;
    double number;
    CHECK_OK(batten_model_create(1, &model));
    parts.triangle_colours = colours;
    add_mesh(model, "tip", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
    const char *json = check_chunks(data, size, &bytes, &count);
    const char *primitives = json_key(json_item(json_key(json, "meshes"), 0), "primitives");
    CHECK(json_item(primitives, 1) != NULL && json_item(primitives, 2) == NULL);
    for (int i = 0; i < 2; i++) {
        const char *primitive = json_item(primitives, i);
        double colour[4];
        json_numbers(json_key(primitive, "indices"), 1, &number);
        const char *indices = json_item(json_key(json, "accessors"), (int)number);
        json_numbers(json_key(indices, "count"), 1, &number);
        CHECK_NEAR(number, i ? 9 : 3, 0);
        json_numbers(json_key(primitive, "material"), 1, &number);
        const char *material = json_item(json_key(json, "materials"), (int)number);
        json_numbers(json_key(json_key(material, "pbrMetallicRoughness"), "baseColorFactor"), 4,
                     colour);
        CHECK(colour[0] == i && colour[1] == 1 - i && colour[2] == 0);
    }
    /* The second triangle stands first; vertices are numbered as corners name them. */
    const char *view = json_item(json_key(json, "bufferViews"), 1);
    json_numbers(json_key(view, "byteOffset"), 1, &number);
    CHECK_INT(bat_bytes_u32(bytes + (size_t)number), 0);
    CHECK_INT(bat_bytes_u32(bytes + (size_t)number + 4), 2);
    CHECK_INT(bat_bytes_u32(bytes + (size_t)number + 8), 3);
    batten_release(data);
    batten_model_unref(model);
}

/* One mesh as it is and in two colours: the numbers once, materials of their own. */
TEST(instances_of_other_colours_share_accessors)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_model *inner = NULL, *model = NULL;
    char *data = NULL;
    const char *bytes = NULL;
    size_t size = 0, count = 0;
    CHECK_OK(batten_model_create(1, &inner));
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(inner, "bolt", &parts);
    for (int i = 0; i < 4; i++)
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = "bolt",
                                    .has_colour = i > 0,
                                    .colour = {i == 1, 0, i > 1},
                                    .kind = BATTEN_OBJECT_INSTANCE,
                                    .definition = inner,
                                    .place = batten_affine_translation(i, 0, 0)}));
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, NULL, &data, &size));
    const char *json = check_chunks(data, size, &bytes, &count);
    const char *meshes = json_key(json, "meshes"), *materials = json_key(json, "materials");
    CHECK(json_item(meshes, 2) && !json_item(meshes, 3));
    CHECK(json_item(materials, 1) && !json_item(materials, 2));
    CHECK(json_item(json_key(json, "accessors"), 1) &&
          !json_item(json_key(json, "accessors"), 2));
    for (int i = 0; i < 4; i++) {
        const char *node = json_item(json_key(json, "nodes"), 4 + i);
        const int mesh = (int)json_number(json_key(node, "mesh"));
        const char *primitive = json_item(json_key(json_item(meshes, mesh), "primitives"), 0);
        double colour[4];
        CHECK_INT((int)json_number(json_key(primitive, "indices")), 1);
        if (i == 0)
            continue;
        const char *material =
            json_item(materials, (int)json_number(json_key(primitive, "material")));
        json_numbers(json_key(json_key(material, "pbrMetallicRoughness"), "baseColorFactor"), 4,
                     colour);
        CHECK(colour[0] == (i == 1) && colour[2] == (i > 1));
    }
    batten_release(data);
    batten_model_unref(inner);
    batten_model_unref(model);
}
