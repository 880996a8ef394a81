/* Meshes, instances and colours as 3MF. */
#include "exchange/3mf/3mf.h"
#include "exchange/meshes/meshes.h"
#include "exchange/reading/bytes.h"

/* CRC-32 by its definition: the remainder of a division of polynomials, bit by bit. */
static uint32_t remainder_of(const char *bytes, size_t length)
{
    uint32_t rest = 0xffffffffu;
    for (size_t i = 0; i < 8 * length; i++) {
        const uint32_t bit = (unsigned char)bytes[i / 8] >> i % 8 & 1;
        rest = (rest ^ bit) & 1 ? rest >> 1 ^ 0xedb88320u : rest >> 1;
    }
    return ~rest;
}

/* The last member of the archive, which is stored as it is. */
static char *model_of_archive(const char *data, size_t size)
{
    const char *end = data + size - 22;
    CHECK(memcmp(end, "PK\5\6", 4) == 0);
    CHECK_INT((long long)bat_bytes_get(end + 10, 2, false), 3);
    const char *central = data + bat_bytes_u32(end + 16);
    for (int k = 0; k < 2; k++)
        central += 46 + bat_bytes_get(central + 28, 2, false);
    const char *local = data + bat_bytes_u32(central + 42);
    const size_t length = bat_bytes_u32(local + 22);
    char *copy = test_array(length + 1, 1);
    memcpy(copy, local + 30 + bat_bytes_get(local + 26, 2, false), length);
    CHECK_INT(remainder_of(copy, length), bat_bytes_u32(local + 14));
    return copy;
}

static char *write_3mf(const batten_model *model)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(write_form(model, BATTEN_FORMAT_3MF, false, NULL, &data, &size));
    char *xml = model_of_archive(data, size);
    batten_release(data);
    return xml;
}

TEST(closed_meshes_are_models_and_open_ones_surfaces)
{
    batten_model *model = NULL;
    batten_mesh_parts parts = tetrahedron();
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, "a<b>&\"c\x01", &parts);
    parts.triangle_count = 3;
    add_mesh(model, "open", &parts);
    const char *xml = write_3mf(model);
    CHECK_CONTAINS(xml, "unit=\"millimeter\"");
    CHECK_CONTAINS(xml, "<object id=\"2\" type=\"model\" name=\"a&lt;b>&amp;&quot;c?\">");
    CHECK_CONTAINS(xml, "<object id=\"3\" type=\"surface\" name=\"open\">");
    CHECK_CONTAINS(xml, "<vertex x=\"1\" y=\"0\" z=\"0\"/>");
    CHECK_CONTAINS(xml, "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/>");
    CHECK_CONTAINS(xml, "<build>\n<item objectid=\"2\"/>\n<item objectid=\"3\"/>\n</build>");
    batten_model_unref(model);
}

TEST(instances_are_components_and_colours_base_materials)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_model *inner = NULL, *model = NULL;
    batten_mesh *mesh = NULL;
    batten_affine place = batten_affine_translation(1, 2, 3);
    place.m[0][0] = 0, place.m[0][1] = -1, place.m[1][0] = 1, place.m[1][1] = 0;
    CHECK_OK(batten_model_create(0.0254, &inner));
    CHECK_OK(batten_model_create(0.0254, &model));
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_model_add(inner, &(batten_object){.name = "bolt",
                                                      .has_colour = true,
                                                      .colour = {1, 0.5, 0},
                                                      .kind = BATTEN_OBJECT_MESH,
                                                      .mesh = mesh}));
    batten_mesh_unref(mesh);
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "left",
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = inner,
                                                      .place = place}));
    batten_model_unref(inner);
    const char *xml = write_3mf(model);
    CHECK_CONTAINS(xml, "unit=\"inch\"");
    CHECK_CONTAINS(xml, "<base displaycolor=\"#FF8000\" name=\"bolt\"/>");
    CHECK_CONTAINS(xml, "name=\"bolt\" pid=\"1\" pindex=\"0\">");
    CHECK_CONTAINS(xml, "<object id=\"3\" type=\"model\">\n<components>\n<component "
                        "objectid=\"2\"/>\n</components>\n</object>");
    CHECK_CONTAINS(xml, "<item objectid=\"3\" transform=\"0 1 0 -1 0 0 0 0 1 1 2 3\"/>");
    batten_model_unref(model);
}

/* A definition in two colours: what has its own colour is written once. */
TEST(instances_of_other_colours_are_objects_of_their_own)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_model *inner = NULL, *model = NULL;
    batten_mesh *mesh = NULL;
    CHECK_OK(batten_model_create(0.001, &inner));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(inner, &(batten_object){.name = i ? "own" : "bare",
                                                          .has_colour = i,
                                                          .colour = {0, 1, 0},
                                                          .kind = BATTEN_OBJECT_MESH,
                                                          .mesh = mesh}));
    batten_mesh_unref(mesh);
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "i",
                                                          .has_colour = true,
                                                          .colour = {!i, 0, i},
                                                          .kind = BATTEN_OBJECT_INSTANCE,
                                                          .definition = inner,
                                                          .place = batten_affine_identity()}));
    batten_model_unref(inner);
    const char *xml = write_3mf(model);
    CHECK_CONTAINS(xml, "displaycolor=\"#FF0000\" name=\"bare\"");
    CHECK_CONTAINS(xml, "displaycolor=\"#0000FF\" name=\"bare\"");
    const char *own = strstr(xml, "type=\"model\" name=\"own\"");
    CHECK(own && !strstr(own + 10, "type=\"model\" name=\"own\""));
    const char *bare = strstr(xml, "type=\"model\" name=\"bare\"");
    CHECK(bare && strstr(bare + 10, "type=\"model\" name=\"bare\""));
    batten_model_unref(model);
}

TEST(units_that_3mf_has_not_become_millimetres_and_flat_triangles_go)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    const batten_mesh_parts parts = {.vertex_count = 4,
                                     .points = tetrahedron_points,
                                     .triangle_count = 2,
                                     .corners = (const int[]){0, 1, 2, 0, 1, 1}};
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_create(1000, &model));
    add_mesh(model, "s", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_3MF, false, notes, &data, &size));
    const char *xml = model_of_archive(data, size);
    CHECK_CONTAINS(xml, "<vertex x=\"1000000\" y=\"0\" z=\"0\"/>");
    CHECK(strstr(xml, "<triangle v1=\"0\" v2=\"1\" v3=\"1\"/>") == NULL);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "3MF has no unit of 1000 m; what is written is in millimetres") &&
              has_note(notes, "triangles with two corners at one vertex: 1; left out"));
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(triangles_name_their_colours)
{
    batten_mesh_parts parts = tetrahedron();
    const double colours[] = {1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, "plain", &parts);
    parts.triangle_colours = colours;
    for (int i = 0; i < 2; i++)
        add_mesh(model, "tip", &parts);
    const char *xml = write_3mf(model);
    CHECK_CONTAINS(xml,
                   "<basematerials id=\"1\">\n<base displaycolor=\"#00FF00\" name=\"tip\"/>\n"
                   "<base displaycolor=\"#FF0000\" name=\"tip\"/>\n<base");
    CHECK_CONTAINS(xml, "name=\"plain\">");
    CHECK_CONTAINS(xml, "id=\"4\" type=\"model\" name=\"tip\" pid=\"1\" pindex=\"2\">");
    CHECK_CONTAINS(xml, "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/>");
    CHECK_CONTAINS(xml, "<triangle v1=\"0\" v2=\"2\" v3=\"1\" pid=\"1\" p1=\"1\"/>\n"
                        "<triangle v1=\"0\" v2=\"1\" v3=\"3\" pid=\"1\" p1=\"0\"/>");
    CHECK_CONTAINS(xml, "<triangle v1=\"0\" v2=\"1\" v3=\"3\" pid=\"1\" p1=\"2\"/>");
    batten_model_unref(model);
}
