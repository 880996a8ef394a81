/* The elements of PLY files: vertices, faces and others, whole or cut. */
#include "exchange/meshes/meshes.h"

static const char square[] = "ply\n"
                             "format ascii 1.0\n"
                             "comment two triangles\n"
                             "obj_info by hand\n"
                             "element vertex 4\n"
                             "property float x\n"
                             "property float y\n"
                             "property double z\n"
                             "property uchar red\n"
                             "property uchar green\n"
                             "property uchar blue\n"
                             "property float32 nx\n"
                             "property float32 ny\n"
                             "property float32 nz\n"
                             "property float quality\n"
                             "element face 1\n"
                             "property uchar flags\n"
                             "property list uint8 int32 vertex_indices\n"
                             "end_header\n"
                             "0 0 0 255 0 0 0 0 1 0.5\n"
                             "1 0 0 0 255 0 0 0 1 1.5\n"
                             "1 1 0 0 0 255 0 0 1 2.5\n"
                             "0 1 0.25 51 51 51 0 0 1 3.5\n"
                             "7 4 0 1 2 3\n";

TEST(vertices_carry_colours_normals_and_further_numbers)
{
    batten_model *model =
        read_noting(square, BATTEN_FORMAT_AUTO, "property 'flags' of the faces is left out");
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(p->vertex_count, 4);
    CHECK_INT(p->triangle_count, 2);
    CHECK_BITS(p->points[11], 0.25);
    CHECK_NEAR(p->colours[9], 0.2, 1e-15);
    CHECK_BITS(p->normals[17], 1.0);
    CHECK_INT(p->attribute_count, 1);
    CHECK_TEXT(p->attributes[0].name, "quality");
    CHECK_BITS(p->attributes[0].values[3], 3.5);
    for (int as_text = 0; as_text < 2; as_text++) {
        batten_model *back = check_second(model, BATTEN_FORMAT_PLY, as_text);
        check_same_mesh(p, mesh_at(back, 0));
        batten_model_unref(back);
    }
    batten_model_unref(model);
}

static const char start[] = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 2\n"
                            "property list char int vertex_index\nend_header\n";

static batten_model *read_body(const char *body, const char *words)
{
    char text[1024];
    snprintf(text, sizeof text, "%s%s", start, body);
    return read_partly(text, strlen(text), BATTEN_FORMAT_PLY, words);
}

TEST(N1_vertices_that_are_no_numbers_go_and_faces_with_them_too)
{
    batten_model *model = read_body("nan 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 1 2 3\n",
                                    "vertex 1 is left out: a coordinate is not finite");
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(p->vertex_count, 3);
    CHECK_INT(p->triangle_count, 1);
    CHECK(p->corners[0] == 0 && p->corners[1] == 1 && p->corners[2] == 2);
    batten_model_unref(model);
}

TEST(N4_faces_whose_corners_or_counts_are_none_are_left_out)
{
    static const struct {
        const char *face, *words;
    } cases[] = {
        {"3 0 1 4", "face 1 is left out: its corner 3 is vertex 5, which does not exist"},
        {"3 0 1 -1", "face 1 is left out: its corner 3 is vertex 0, which does not exist"},
        {"3 0 1 1.5", "face 1 is left out: its corner 3"},
        {"2 0 1", "face 1 is left out: it has 2 corners"},
        {"0", "face 1 is left out: it has 0 corners"},
        {"-3 0 1 2", "face 1 is left out: a number is missing, or its count is invalid"},
        {"3 0 1", "face 1 is left out: a number is missing"},
        {"1e9 0 1 2", "face 1 is left out: a number is missing"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char body[200];
        snprintf(body, sizeof body, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n%s\n3 0 1 2\n", cases[i].face);
        batten_model *model = read_body(body, cases[i].words);
        CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
        batten_model_unref(model);
    }
}

TEST(polygons_are_cut_into_triangles_that_cover_them)
{
    /* An L, turned into space, beginning at a corner from which no fan covers it. */
    const char *text = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty "
                       "float y\nproperty float z\nelement face 1\nproperty list uchar int "
                       "vertex_index\nend_header\n0 2 2\n0 0 0\n2 0 0\n2 1 1\n1 1 1\n1 2 2\n"
                       "6 0 1 2 3 4 5\n";
    batten_model *model = read_noting(text, BATTEN_FORMAT_PLY, "");
    const batten_mesh_parts *p = mesh_at(model, 0);
    double area = 0;
    CHECK_INT(p->triangle_count, 4);
    for (int i = 0; i < 4; i++) {
        const double *a = p->points + 3 * p->corners[3 * i],
                     *b = p->points + 3 * p->corners[3 * i + 1],
                     *c = p->points + 3 * p->corners[3 * i + 2];
        const double part = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        CHECK(part > 0);
        area += part / 2;
    }
    CHECK_NEAR(area, 3, 1e-15);
    batten_model_unref(model);
}

TEST(a_polygon_that_crosses_itself_is_told)
{
    const char *text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
                       "float y\nproperty float z\nelement face 1\nproperty list uchar int "
                       "vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n2 2 0\n4 0 1 2 3\n";
    batten_model_unref(read_noting(text, BATTEN_FORMAT_PLY, "1 of 1 faces cross themselves"));
}

TEST(other_elements_are_left_out_by_name)
{
    const char *text =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty "
        "float y\nproperty float z\nelement edge 2\nproperty int vertex1\n"
        "property int vertex2\nelement void 1000000000\nend_header\n0 2 2\n0 1\n1 "
        "0\n";
    batten_model *model =
        read_partly(text, strlen(text), BATTEN_FORMAT_PLY, "the 2 items 'edge' are left out");
    batten_model_unref(model);
}

TEST(S2_a_list_longer_than_the_file_ends_the_reading)
{
    char data[400];
    size_t at = (size_t)snprintf(data, sizeof data,
                                 "ply\nformat binary_little_endian 1.0\nelement vertex 1\n"
                                 "property char x\nproperty char y\nproperty char z\nelement "
                                 "face 1\nproperty list uint int vertex_index\nend_header\n");
    memcpy(data + at, "\1\2\3\xff\xff\xff\x7f\0\0\0\0", 11);
    batten_model *model =
        read_partly(data, at + 11, BATTEN_FORMAT_PLY, "0 of 1 items 'face' are in the file");
    CHECK_INT(batten_model_object(model, 0)->point_count, 1);
    batten_model_unref(model);
}

TEST(F2_meshes_in_ply_that_are_cut_anywhere_are_refused_or_read_in_part)
{
    batten_model *model =
        read_noting(square, BATTEN_FORMAT_PLY, "property 'flags' of the faces is left out");
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(write_form(model, BATTEN_FORMAT_PLY, false, NULL, &data, &size));
    check_cuts(data, size, BATTEN_FORMAT_PLY);
    batten_release(data);
    check_cuts(square, strlen(square) - 2, BATTEN_FORMAT_PLY);
    batten_model_unref(model);
}

TEST(F3_ends_of_lines_of_ply_do_not_matter)
{
    static const char *const ends[] = {"\r\n", "\r"};
    for (int e = 0; e < 2; e++) {
        char text[1024];
        size_t at = 0;
        for (const char *c = square; *c; c++) {
            const char *put = *c == '\n' ? ends[e] : (char[2]){*c, 0};
            memcpy(text + at, put, strlen(put));
            at += strlen(put);
        }
        batten_model *model = NULL;
        CHECK_OK(read_bytes(text, at, BATTEN_FORMAT_AUTO, NULL, &model));
        CHECK_INT(mesh_at(model, 0)->triangle_count, 2);
        batten_model_unref(model);
    }
}

TEST(an_element_without_properties_is_passed_over)
{
    batten_model *model = NULL;
    CHECK_OK(read_text("ply\nformat ascii 1.0\nelement vertex 0\nelement face 9\nend_header\n",
                       BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_INT(batten_model_count(model), 0);
    batten_model_unref(model);
}

TEST(colours_of_faces_that_are_none_are_left_out_with_a_note)
{
    const char *text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                       "property double y\nproperty double z\nelement face 1\n"
                       "property list uchar int vertex_indices\nproperty float red\n"
                       "property float green\nproperty float blue\nend_header\n"
                       "0 0 0\n1 0 0\n1 1 0\n3 0 1 2 0 255 0\n";
    batten_model *model =
        read_partly(text, strlen(text), BATTEN_FORMAT_AUTO, "part 2 of triangle 1 is 255 of 1");
    CHECK(mesh_at(model, 0)->triangle_colours == NULL);
    batten_model_unref(model);
}

/* Two elements of faces, one before the vertices, in text and in bytes: nothing is left out. */
TEST(faces_may_stand_before_the_vertices)
{
    static const char header[] =
        "ply\nformat %s 1.0\nelement extra %d\nproperty uchar a\nelement face 2\n"
        "property list uchar uchar vertex_indices\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nelement vertex 4\nproperty char x\nproperty char y\n"
        "property char z\nelement face 1\nproperty list uchar uchar vertex_index\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n%s";
    static const unsigned char bytes[] = {3, 0,   1, 2, 255, 0, 0, 3, 0, 2, 3,
                                          0, 255, 0, 0, 0,   0, 1, 0, 0, 1, 1,
                                          0, 0,   1, 1, 3,   0, 1, 3, 0, 0, 255};
    for (int as_text = 0; as_text < 2; as_text++) {
        char data[1024];
        batten_model *model = NULL;
        snprintf(data, sizeof data, header, as_text ? "ascii" : "binary_little_endian", 0,
                 as_text ? "3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n"
                           "3 0 1 3 0 0 255\n"
                         : "");
        size_t size = strlen(data);
        if (!as_text) {
            memcpy(data + size, bytes, sizeof bytes);
            size += sizeof bytes;
        }
        CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &model));
        const batten_mesh_parts *p = mesh_at(model, 0);
        CHECK_INT(p->vertex_count, 4);
        CHECK_INT(p->triangle_count, 3);
        CHECK(p->triangle_colours != NULL);
        double sums[3] = {0};
        for (int i = 0; p->triangle_colours && i < 9; i++)
            sums[i % 3] += p->triangle_colours[i];
        CHECK(sums[0] == 1 && sums[1] == 1 && sums[2] == 1);
        CHECK_BITS(p->points[11], 1.0);
        batten_model_unref(model);
    }
}

TEST(faces_before_vertices_that_are_not_there_are_left_out)
{
    static const char header[] = "ply\nformat ascii 1.0\nelement face 2\n"
                                 "property list uchar int vertex_indices\nelement vertex 3\n"
                                 "property float x\nproperty float y\nproperty float z\n"
                                 "end_header\n3 0 1 2\n3 0 1 7\n";
    char text[512];
    snprintf(text, sizeof text, "%s0 0 0\n1 0 0\n0 1 0\n", header);
    batten_model *model = read_partly(text, strlen(text), BATTEN_FORMAT_PLY,
                                      "face 2 is left out: its corner 3 is vertex 8");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
    model = NULL;
    CHECK_STATUS(read_text(header, BATTEN_FORMAT_PLY, NULL, &model), BATTEN_BAD_FORMAT);
    CHECK(!model);
    CHECK_MESSAGE("no vertex could be read");
}
