/* Vertices of PLY files: their numbers, colours, normals and further values. */
#include "exchange/meshes/meshes.h"

/* All types of numbers, in bytes of either order: the value is the same. */
static size_t put_number(char *data, int bytes, uint64_t bits, bool big)
{
    for (int k = 0; k < bytes; k++)
        data[big ? bytes - 1 - k : k] = (char)(unsigned char)(bits >> (8 * k));
    return (size_t)bytes;
}

TEST(bytes_of_either_order_and_every_type_are_read)
{
    static const struct {
        const char *name;
        int bytes;
        uint64_t bits; /* of -2, or 2 */
        double value;
    } types[] = {{"char", 1, 0xfe, -2},          {"uchar", 1, 2, 2},
                 {"short", 2, 0xfffe, -2},       {"ushort", 2, 2, 2},
                 {"int", 4, 0xfffffffe, -2},     {"uint", 4, 2, 2},
                 {"float", 4, 0xc0000000, -2},   {"double", 8, 0xc000000000000000, -2},
                 {"int8", 1, 0xfe, -2},          {"uint8", 1, 2, 2},
                 {"int16", 2, 0xfffe, -2},       {"uint16", 2, 2, 2},
                 {"int32", 4, 0xfffffffe, -2},   {"uint32", 4, 2, 2},
                 {"float32", 4, 0xc0000000, -2}, {"float64", 8, 0xc000000000000000, -2}};
    for (int i = 0; i < COUNT(types); i++)
        for (int big = 0; big < 2; big++) {
            char data[512];
            batten_model *model = NULL;
            size_t at = (size_t)snprintf(
                data, sizeof data,
                "ply\nformat binary_%s_endian 1.0\nelement vertex 1\nproperty %s x\n"
                "property %s y\nproperty %s z\nend_header\n",
                big ? "big" : "little", types[i].name, types[i].name, types[i].name);
            for (int k = 0; k < 3; k++)
                at += put_number(data + at, types[i].bytes, types[i].bits, big);
            CHECK_OK(read_bytes(data, at, BATTEN_FORMAT_AUTO, NULL, &model));
            CHECK(batten_model_object(model, 0)->kind == BATTEN_OBJECT_POINTS);
            CHECK_BITS(batten_model_object(model, 0)->points[2], types[i].value);
            batten_model_unref(model);
        }
}

TEST(vertices_without_faces_are_points_and_what_they_lose_is_told)
{
    batten_model *model =
        read_noting("ply\nformat ascii 1.0\nelement vertex 2\n"
                    "property float x\nproperty float y\nproperty float z\n"
                    "property float time\nend_header\n1 2 3 4\n5 6 7 8\n",
                    BATTEN_FORMAT_AUTO, "left out of 2 points: 1 further value");
    const batten_object *object = batten_model_object(model, 0);
    CHECK(object->kind == BATTEN_OBJECT_POINTS && object->point_count == 2);
    CHECK_BITS(object->points[5], 7.0);
    batten_model_unref(read_noting(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float nx\nproperty float ny\n"
        "property float nz\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float t\n"
        "property float u\nend_header\n0 0 1 1 2 3 255 0 0 4 5\n",
        BATTEN_FORMAT_AUTO, "left out of 1 point: normals, colours, 2 further values"));
    batten_model *back = check_second(model, BATTEN_FORMAT_PLY, false);
    CHECK(same_rows(batten_model_object(back, 0)->points, object->points, 6));
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(S2_a_header_of_a_thousand_million_vertices_is_refused)
{
    static const char *const forms[] = {"ascii", "binary_little_endian"};
    for (int i = 0; i < 2; i++) {
        char text[400];
        batten_limits limits = batten_limits_defaults();
        batten_read_options options = batten_read_defaults();
        batten_model *model = NULL;
        snprintf(text, sizeof text,
                 "ply\nformat %s 1.0\nelement vertex 1000000000\nproperty float x\nproperty "
                 "float y\nproperty float z\nelement face 1000000000\nproperty list int int "
                 "vertex_index\nend_header\n",
                 forms[i]);
        limits.memory_bytes = 65536;
        options.limits = &limits;
        CHECK_STATUS(batten_read_memory(text, strlen(text), &options, NULL, NULL, &model),
                     BATTEN_BAD_FORMAT);
        CHECK_MESSAGE("no vertex could be read");
    }
}

TEST(colours_and_normals_that_are_none_are_left_out_with_a_note)
{
    const char *text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty "
        "float y\nproperty float z\nproperty float red\nproperty float green\n"
        "property float blue\nproperty float nx\nproperty float ny\nproperty "
        "float nz\nproperty float a\nelement face 1\nproperty list uchar int "
        "vertex_index\nend_header\n0 0 0 0 0 200 0 0 5 inf\n1 0 0 0 0 0 0 0 1 2\n"
        "0 1 0 0 0 0 0 0 0 3\n3 0 1 2\n";
    static const char *const words[] = {"the colours are left out: part 3 of vertex 1 is 200",
                                        "that of vertex 1, (0, 0, 5), has not the length 1",
                                        "left out: its value at vertex 1 is not finite"};
    for (int i = 0; i < 3; i++) {
        batten_model *model = read_partly(text, strlen(text), BATTEN_FORMAT_PLY, words[i]);
        const batten_mesh_parts *p = mesh_at(model, 0);
        CHECK(!p->colours && !p->normals && p->attribute_count == 0);
        batten_model_unref(model);
    }
}

TEST(P2_vertices_without_properties_are_no_points)
{
    batten_model *model = NULL;
    const batten_status status =
        read_text("ply\nformat ascii 1.0\nelement vertex 1\nend_header\n\n", BATTEN_FORMAT_PLY,
                  NULL, &model);
    CHECK(status != BATTEN_OK && model == NULL);
}

/* A thousand million are announced and a hundred there: memory is asked for these alone. */
TEST(S2_memory_is_asked_for_as_many_vertices_as_the_file_may_have)
{
    enum { THERE = 100 };
    static const char *const forms[] = {"ascii", "binary_little_endian"};
    for (int i = 0; i < 2; i++) {
        char text[2000];
        batten_limits limits = batten_limits_defaults();
        batten_read_options options = batten_read_defaults();
        batten_model *model = NULL;
        size_t size = (size_t)snprintf(text, sizeof text,
                                       "ply\nformat %s 1.0\nelement vertex 1000000000\n"
                                       "property float x\nproperty float y\nproperty float z\n"
                                       "end_header\n",
                                       forms[i]);
        for (int k = 0; k < THERE; k++) {
            memcpy(text + size, i ? "\0\0\0\0\0\0\0\0\0\0\0\0" : "1 2 3\n", i ? 12 : 6);
            size += i ? 12 : 6;
        }
        limits.memory_bytes = 20000;
        options.limits = &limits;
        CHECK_STATUS(batten_read_memory(text, size, &options, NULL, NULL, &model),
                     BATTEN_PARTLY_READ);
        CHECK_INT(batten_model_object(model, 0)->point_count, THERE);
        batten_model_unref(model);
    }
}
