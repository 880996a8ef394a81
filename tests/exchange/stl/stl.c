#include "exchange/meshes/meshes.h"

static const char one_triangle[] = "solid part one\n"
                                   "facet normal 0 0 1\n"
                                   "outer loop\n"
                                   "vertex 0 0 0\n"
                                   "vertex 1 0 0\n"
                                   "vertex 0 1.5 0\n"
                                   "endloop\n"
                                   "endfacet\n"
                                   "endsolid part one\n";

/* The bytes of triangles with these corners; the memory is the test's. */
static char *bytes_of(int count, const float *corners, size_t *size)
{
    *size = 84 + 50 * (size_t)count;
    char *data = test_array(*size, 1);
    memcpy(data, "solid that is none", 18);
    data[80] = (char)count;
    for (int i = 0; i < count; i++)
        memcpy(data + 84 + 50 * i + 12, corners + 9 * i, 36);
    return data;
}

static const float two_triangles[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

TEST(a_solid_of_text_is_a_mesh_of_that_name)
{
    batten_model *model = read_noting(one_triangle, BATTEN_FORMAT_AUTO, "");
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(batten_model_object(model, 0)->name, "part one");
    CHECK_INT(p->vertex_count, 3);
    CHECK_INT(p->triangle_count, 1);
    CHECK_BITS(p->points[7], 1.5);
    CHECK_BITS(batten_model_unit_metres(model), 0);
    batten_model_unref(model);
}

TEST(F3_case_blanks_and_ends_of_lines_of_solids_do_not_matter)
{
    static const char *const texts[] = {
        "solid a\r\nfacet\r\nouter loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop "
        "endfacet\r\nendsolid",
        "  SOLID a\rFACET NORMAL 0 0 1\rOUTER LOOP\rVERTEX 0 0 0\rVERTEX 1 0 0\r\tVERTEX 0 1 "
        "0\rENDLOOP\rENDFACET\rENDSOLID a\r\x1a",
        "\xef\xbb\xbfsolid a\nfacet normal nan nan nan\nouter loop\nvertex 0e0 0. -.0\nvertex "
        "+1 0 0\n\nvertex 0 1E0 0\nendloop\nendfacet\nendsolid\n\n",
    };
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_noting(texts[i], BATTEN_FORMAT_AUTO, "");
        CHECK_TEXT(batten_model_object(model, 0)->name, "a");
        CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
        CHECK(mesh_at(model, 0)->points[3] == 1 && mesh_at(model, 0)->points[7] == 1);
        batten_model_unref(model);
    }
}

TEST(the_size_tells_bytes_from_text_and_corners_are_shared)
{
    size_t size = 0;
    char *data = bytes_of(2, two_triangles, &size);
    batten_model *model = NULL;
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &model));
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(p->triangle_count, 2);
    CHECK_INT(p->vertex_count, 4);
    CHECK(p->corners[3] == 1 && p->corners[4] == 3 && p->corners[5] == 2);
    batten_model_unref(model);
}

TEST(two_solids_are_two_objects)
{
    const char *text =
        "solid\nfacet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 "
        "1 0 endloop endfacet\nendsolid\nsolid b\nfacet normal 0 0 0 outer loop "
        "vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid b\n";
    batten_model *model = read_noting(text, BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 2);
    CHECK_TEXT(batten_model_object(model, 0)->name, "mesh");
    CHECK_TEXT(batten_model_object(model, 1)->name, "b");
    batten_model *back = check_second(model, BATTEN_FORMAT_STL, true);
    CHECK_INT(batten_model_count(back), 2);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(P2_triangles_outside_of_solids_are_left_out)
{
    const char *facet = "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                        "endloop\nendfacet\n";
    char text[600];
    snprintf(text, sizeof text, "solid a\n%sendsolid a\n%s%s", facet, facet, facet);
    batten_model *model = read_partly(text, strlen(text), BATTEN_FORMAT_STL,
                                      "a triangle outside of a solid is left out");
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
    snprintf(text, sizeof text, "solid a\n%scolour 1 0 0\n%sendsolid a\n", facet, facet);
    model = read_noting(text, BATTEN_FORMAT_STL, "unexpected word 'colour' in a solid");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 2);
    batten_model_unref(model);
}

TEST(N1_triangles_with_coordinates_that_are_no_numbers_are_left_out)
{
    size_t size = 0;
    float corners[18];
    memcpy(corners, two_triangles, sizeof corners);
    corners[4] = (float)INFINITY;
    char *data = bytes_of(2, corners, &size);
    batten_model *model =
        read_partly(data, size, BATTEN_FORMAT_STL,
                    "triangle 1 is left out: y of its corner 2 is not finite");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);

    const char *text =
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex nan 0 0\n"
        "vertex 0 1e400 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
        "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    model = read_partly(text, strlen(text), BATTEN_FORMAT_STL,
                        "triangle 1 is left out: x of its corner 2 is not finite");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
}

TEST(a_facet_that_is_none_is_left_out_and_the_next_is_read)
{
    const char *text = "solid s\nfacet normal 0 0 1\nouter ring\nvertex 0 0 0\nendloop\n"
                       "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                       "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    batten_model *model =
        read_partly(text, strlen(text), BATTEN_FORMAT_AUTO, "triangle 1 is left out: line 3");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
}

TEST(normals_that_contradict_the_corners_and_triangles_without_area_are_told)
{
    const char *text = "solid s\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                       "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    batten_model_unref(
        read_noting(text, BATTEN_FORMAT_STL, "the normals of 1 of 1 triangles contradict"));
    text = "solid s\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
           "vertex 2 0 0\nendloop\nendfacet\nendsolid\n";
    batten_model *model =
        read_noting(text, BATTEN_FORMAT_STL, "1 of 1 triangles have no area; kept");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
}

TEST(S2_a_header_of_a_thousand_million_triangles_is_refused)
{
    char data[100] = {0};
    data[83] = 0x3b; /* 989,855,744 */
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    batten_model *model = NULL;
    limits.memory_bytes = 4096;
    options.limits = &limits;
    options.format = BATTEN_FORMAT_STL;
    CHECK_STATUS(batten_read_memory(data, sizeof data, &options, NULL, NULL, &model),
                 BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("the header promises 989855744 triangles, and 16 bytes follow it");
    CHECK(model == NULL);
}

TEST(S1_counts_that_do_not_match_the_bytes_are_told)
{
    size_t size = 0;
    char *data = bytes_of(2, two_triangles, &size);
    data[80] = 3;
    batten_model *model = read_partly(data, size, BATTEN_FORMAT_STL,
                                      "promises 3 triangles; the file has room for 2");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 2);
    batten_model_unref(model);
    data[80] = 1;
    model = read_partly(data, size, BATTEN_FORMAT_STL, "promises 1 triangle; 1 more, left out");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
    CHECK_OK(read_bytes(data, size - 3, BATTEN_FORMAT_STL, NULL, &model));
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
    data[80] = 0;
    CHECK_OK(read_bytes(data, 84, BATTEN_FORMAT_STL, NULL, &model));
    CHECK_INT(batten_model_count(model), 0);
    batten_model_unref(model);
}

TEST(S1_more_triangles_than_the_limit_are_refused)
{
    size_t size = 0;
    char *data = bytes_of(2, two_triangles, &size);
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    batten_model *model = NULL;
    limits.entities = 1;
    options.limits = &limits;
    CHECK_STATUS(batten_read_memory(data, size, &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("2 triangles; the limit is 1");
}

TEST(F1_what_is_no_stl_is_refused)
{
    check_refused("", BATTEN_FORMAT_STL, BATTEN_BAD_FORMAT, "the file is empty");
    check_refused("x", BATTEN_FORMAT_STL, BATTEN_BAD_FORMAT, "this is not STL");
    check_refused("solid only", BATTEN_FORMAT_STL, BATTEN_BAD_FORMAT, "this is not STL");
    check_refused("solid s\nfacet\n", BATTEN_FORMAT_STL, BATTEN_BAD_FORMAT,
                  "no triangle could be read");
}

TEST(F2_solids_that_are_cut_anywhere_are_refused_or_read_in_part)
{
    size_t size = 0;
    check_cuts(one_triangle, strlen(one_triangle) - strlen(" part one\n"), BATTEN_FORMAT_STL);
    const char *data = bytes_of(2, two_triangles, &size);
    check_cuts(data, size, BATTEN_FORMAT_STL);
}

TEST(F4_a_zero_byte_in_a_solid_of_text_is_refused)
{
    char text[sizeof one_triangle];
    batten_model *model = NULL;
    memcpy(text, one_triangle, sizeof text);
    text[60] = 0;
    CHECK_STATUS(read_bytes(text, sizeof text - 1, BATTEN_FORMAT_STL, NULL, &model),
                 BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("byte 60 is zero");
}

/* ---- writing ---- */

static batten_model *model_of(const batten_mesh_parts *parts, const char *name)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, name, parts);
    return model;
}

TEST(text_is_written_so)
{
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1.5, 0};
    static const int corners[] = {0, 1, 2};
    const batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners};
    batten_model *model = model_of(&parts, " part one ");
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(write_form(model, BATTEN_FORMAT_STL, true, NULL, &data, &size));
    CHECK_TEXT(data, one_triangle);
    batten_release(data);
    batten_model_unref(model);
}

TEST(a_name_of_control_characters_is_written_as_none)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_model *model = model_of(&parts, "\x14 \t");
    batten_model *back = check_second(model, BATTEN_FORMAT_STL, true);
    CHECK_TEXT(batten_model_object(back, 0)->name, "mesh");
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(bytes_are_written_so)
{
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1.5, 0};
    static const int corners[] = {0, 1, 2};
    static const unsigned char expected[54] = {
        1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xc0, 0x3f};
    const batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners};
    batten_model *model = model_of(&parts, "s");
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(write_form(model, BATTEN_FORMAT_STL, false, NULL, &data, &size));
    CHECK_INT((long long)size, 134);
    CHECK(memcmp(data, "solid", 5) != 0);
    CHECK(memcmp(data + 80, expected, 54) == 0);
    batten_release(data);
    batten_model_unref(model);
}

TEST(meshes_in_bytes_and_text_come_back_and_are_written_the_same)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_model *model = model_of(&parts, "tetrahedron");
    for (int as_text = 0; as_text < 2; as_text++) {
        batten_model *back = check_second(model, BATTEN_FORMAT_STL, as_text);
        const batten_mesh_parts *p = mesh_at(back, 0);
        CHECK_INT(p->vertex_count, 4);
        CHECK_INT(p->triangle_count, 4);
        for (int i = 0; i < 12; i++)
            for (int k = 0; k < 3; k++)
                CHECK_BITS(p->points[3 * p->corners[i] + k],
                           parts.points[3 * parts.corners[i] + k]);
        batten_model_unref(back);
    }
    batten_model_unref(model);
}

TEST(N5_text_keeps_every_bit_and_bytes_say_how_much_they_round)
{
    static const double points[] = {0.1, 1e-300, 4.9e-324, 1 / 3.0, 0, 0, 0, 1e300, 0.7};
    static const int corners[] = {0, 1, 2};
    batten_mesh_parts parts = {
        .vertex_count = 3, .points = points, .triangle_count = 1, .corners = corners};
    batten_model *model = model_of(&parts, "s");
    batten_model *back = check_second(model, BATTEN_FORMAT_STL, true);
    CHECK(same_rows(mesh_at(back, 0)->points, points, 9));
    batten_model_unref(back);
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(write_form(model, BATTEN_FORMAT_STL, false, NULL, &data, &size),
                 BATTEN_OVERFLOW);
    CHECK_MESSAGE("y of vertex 3 of 's' is 1e+300");
    batten_model_unref(model);

    batten_notes *notes = NULL;
    parts.vertex_count = 2;
    static const int flat[] = {0, 1, 1};
    parts.corners = flat;
    model = model_of(&parts, "s");
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(write_form(model, BATTEN_FORMAT_STL, false, notes, &data, &size));
    if (batten_notes_dropped(notes) == 0) {
        CHECK(has_note(notes, "rounded to 32 bits: at most 9.93e-09 off"));
        CHECK(has_note(notes, "STL files name no unit; the numbers are in units of 0.001 m"));
    }
    batten_notes_free(notes);
    batten_release(data);
    batten_model_unref(model);
}

TEST(F1_a_byte_order_mark_before_a_header_that_is_cut_short_is_refused)
{
    /* Long enough with the mark, not without it; zero bytes make it no text. */
    for (size_t size = 85; size <= 87; size++) {
        char *bytes = test_array(size, 1);
        batten_model *model = NULL;
        memcpy(bytes, "\xef\xbb\xbfsolid", 8);
        CHECK_STATUS(read_bytes(bytes, size, BATTEN_FORMAT_STL, NULL, &model),
                     size < 87 ? BATTEN_BAD_FORMAT : BATTEN_OK);
        if (size < 87)
            CHECK_MESSAGE("a header has 84 bytes");
        batten_model_unref(model);
    }
}

/* Blanks instead of the ends of lines. */
static char *on_one_line(const char *text)
{
    char *copy = test_array(strlen(text) + 1, 1);
    for (size_t i = 0; text[i]; i++)
        copy[i] = text[i] == '\n' ? ' ' : text[i];
    return copy;
}

TEST(F3_solids_may_stand_on_one_line)
{
    static const char solid[] =
        "solid %s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\nfacet\nouter loop\nvertex 0 0 0\n"
        "vertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\nendsolid %s\n";
    char one[400], two[900];
    snprintf(one, sizeof one, solid, "a facet", "a facet");
    snprintf(two, sizeof two, "%s%s", one, one);
    for (int i = 0; i < 2; i++) {
        batten_model *model = read_noting(i ? on_one_line(two) : two, BATTEN_FORMAT_AUTO, "");
        CHECK_INT(batten_model_count(model), 2);
        for (int k = 0; k < 2; k++) {
            CHECK_TEXT(batten_model_object(model, k)->name, "a facet");
            CHECK_INT(mesh_at(model, k)->triangle_count, 2);
        }
        batten_model_unref(model);
    }
}

TEST(N1_decimal_commas_are_named)
{
    const char *text = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                       "vertex 1,5 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
                       "facet normal 0,0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                       "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    batten_model *model = read_partly(text, strlen(text), BATTEN_FORMAT_STL,
                                      "triangle 1 is left out: '1,5' is not a number");
    CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
    batten_model_unref(model);
}
