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

TEST(F1_headers_that_are_none_are_refused_by_line)
{
    static const struct {
        const char *text, *words;
        batten_status status;
    } cases[] = {
        {"", "the file is empty", BATTEN_BAD_FORMAT},
        {"plx\n", "the first line is not 'ply'", BATTEN_BAD_FORMAT},
        {"ply\n", "t:2: the file ends within the header", BATTEN_BAD_FORMAT},
        {"ply\nend_header\n", "t:2: bad header: the format line is missing", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 2.0\n", "t:2: unknown PLY form 'ascii' 2.0", BATTEN_UNSUPPORTED},
        {"ply\nformat text 1.0\n", "unknown PLY form 'text'", BATTEN_UNSUPPORTED},
        {"ply\nformat ascii\n", "t:2: bad header: expected a format and its version",
         BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement vertex -1\n", "t:3: bad header", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement vertex 1e3\n", "t:3: bad header", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nproperty float x\n", "t:3: bad header", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement v 1\nproperty half x\n",
         "a property needs a known type", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement v 1\nproperty list float int x\n",
         "a property needs a known type", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n",
         "vertices have no x, y and z", BATTEN_BAD_FORMAT},
        {"ply\nformat ascii 1.0\nnonsense\n", "unknown header line", BATTEN_BAD_FORMAT},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_refused(cases[i].text, BATTEN_FORMAT_PLY, cases[i].status, cases[i].words);
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

TEST(ply_is_written_so)
{
    batten_model *model = NULL;
    const batten_mesh_parts parts = {.vertex_count = 3,
                                     .points = tetrahedron_points,
                                     .triangle_count = 1,
                                     .corners = (const int[]){0, 1, 2}};
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, "s", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_PLY, true, NULL, &data, &size));
    CHECK_TEXT(data, "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty "
                     "double y\nproperty double z\nelement face 1\nproperty list uchar int "
                     "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    batten_release(data);
    batten_model_unref(model);
}

TEST(objects_become_one_mesh_in_ply_with_their_colours)
{
    batten_model *model = NULL;
    batten_mesh *mesh = NULL;
    const batten_mesh_parts parts = tetrahedron();
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, "plain", &parts);
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "red",
                                                      .has_colour = true,
                                                      .colour = {1, 0, 0},
                                                      .kind = BATTEN_OBJECT_MESH,
                                                      .mesh = mesh}));
    batten_mesh_unref(mesh);
    batten_model *back = check_second(model, BATTEN_FORMAT_PLY, false);
    const batten_mesh_parts *p = mesh_at(back, 0);
    CHECK_INT(p->vertex_count, 8);
    CHECK_INT(p->triangle_count, 8);
    CHECK_INT(p->corners[12], 4);
    CHECK(p->colours[12] == 1 && p->colours[13] == 0);
    CHECK_NEAR(p->colours[0], 0.8, 1e-15);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(normals_that_differ_at_a_vertex_are_left_out_of_ply_with_a_note)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    double normals[36] = {0};
    batten_mesh_parts parts = tetrahedron();
    char *data = NULL;
    size_t size = 0;
    for (int i = 0; i < 12; i++)
        normals[3 * i + i / 3 % 3] = 1;
    parts.normals = normals;
    CHECK_OK(batten_model_create(0, &model));
    add_mesh(model, "s", &parts);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(write_form(model, BATTEN_FORMAT_PLY, true, notes, &data, &size));
    CHECK(strstr(data, "nx") == NULL);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "they differ between the faces at a vertex"));
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* Of two objects none, one or both have normals at their corners. */
TEST(normals_are_written_when_all_objects_have_them)
{
    for (int k = 0; k < 4; k++) {
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        double normals[36] = {0};
        char *data = NULL;
        size_t size = 0;
        for (int i = 0; i < 12; i++)
            normals[3 * i + 2] = 1;
        CHECK_OK(batten_model_create(1, &model));
        CHECK_OK(batten_notes_create(10, &notes));
        for (int i = 0; i < 2; i++) {
            batten_mesh_parts parts = tetrahedron();
            parts.normals = k >> i & 1 ? normals : NULL;
            add_mesh(model, "s", &parts);
        }
        CHECK_OK(write_form(model, BATTEN_FORMAT_PLY, true, notes, &data, &size));
        CHECK((strstr(data, "property double nx") != NULL) == (k == 3));
        CHECK((strstr(data, "\n1 0 0 0 0 1\n") != NULL) == (k == 3));
        if (batten_notes_dropped(notes) == 0)
            CHECK(has_note(notes, "the normals are left out: not all objects have them") ==
                  (k == 1 || k == 2));
        batten_release(data);
        batten_notes_free(notes);
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

TEST(P2_vertices_without_properties_are_no_points)
{
    batten_model *model = NULL;
    const batten_status status =
        read_text("ply\nformat ascii 1.0\nelement vertex 1\nend_header\n\n", BATTEN_FORMAT_PLY,
                  NULL, &model);
    CHECK(status != BATTEN_OK && model == NULL);
}

TEST(faces_have_colours_that_come_back)
{
    const char *text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
                       "property double y\nproperty double z\nelement face 2\n"
                       "property list uchar int vertex_indices\nproperty uchar red\n"
                       "property uchar green\nproperty uchar blue\nproperty uchar flags\n"
                       "end_header\n0 0 0\n1 0 0\n1 1 0\n0 0 1\n4 0 1 2 3 255 0 51 1\n"
                       "3 0 1 3 0 255 0 2\n";
    batten_model *model =
        read_noting(text, BATTEN_FORMAT_AUTO, "property 'flags' of the faces is left out");
    batten_model *back = check_second(model, BATTEN_FORMAT_PLY, true);
    for (int m = 0; m < 2; m++) {
        const batten_mesh_parts *p = mesh_at(m ? back : model, 0);
        CHECK_INT(p->triangle_count, 3);
        CHECK(p->triangle_colours != NULL && !p->colours);
        for (int i = 0; p->triangle_colours && i < 3; i++) {
            CHECK_NEAR(p->triangle_colours[3 * i], i < 2 ? 1 : 0, 1e-15);
            CHECK_NEAR(p->triangle_colours[3 * i + 2], i < 2 ? 0.2 : 0, 1e-15);
        }
    }
    batten_model_unref(back);
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
