/* What is said of triangles in text and bytes, to the letter and the line. */
#include "exchange/listed.h"
#include "exchange/meshes/meshes.h"

#define LOOP(x) "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 " x " 0\nendloop\nendfacet\n"
#define FACET "facet normal 0 0 1\n" LOOP("1")

TEST(what_is_wrong_in_solids_is_named_with_its_line)
{
    static const struct {
        const char *text;
        batten_status status;
        const char *listing;
    } cases[] = {
        {"solid a\n" FACET "endsolid a\n", BATTEN_OK, ""},
        {"solid a\n" FACET FACET, BATTEN_PARTLY_READ, ""},
        {"solid a\n" FACET "facet normal 0 0 1\nouter loop\nvertex 0", BATTEN_PARTLY_READ,
         "9: the file ends within triangle 2\n"},
        {"solid a\n" FACET "facet normal 0 0 1\nouter loup\nvertex 0 0 0\nendfacet\n" FACET
         "endsolid\n",
         BATTEN_PARTLY_READ,
         "9: triangle 2 is left out: line 10 is not what follows in a facet\n"},
        {"solid a\n" FACET "facet normal 0 0 1\n" LOOP("x") "endsolid\n", BATTEN_PARTLY_READ,
         "9: triangle 2 is left out: y of its corner 3 is not finite\n"},
        {"solid a\n" FACET "facet normal 0 0 1\n" LOOP("1,5") "endsolid\n", BATTEN_PARTLY_READ,
         "9: triangle 2 is left out: '1,5' is not a number; decimals follow a point\n"},
        {"solid a\n" FACET "facet normal 0,5 0 1\n" LOOP("1") "endsolid\n", BATTEN_OK, ""},
        {"solid a\n" FACET "word\nmore\n" FACET "endsolid\n", BATTEN_OK,
         "9: unexpected word 'word' in a solid\n"},
        {"solid a\n" FACET "endsolid a\n" FACET, BATTEN_PARTLY_READ,
         "10: a triangle outside of a solid is left out: 'facet'\n"},
        {"solid a\nfacet normal 0 0 -1\n" LOOP("1") FACET "endsolid\nsolid b\n" FACET
                                                          "endsolid\n",
         BATTEN_OK,
         "0: a: the normals of 1 of 2 triangles contradict the order of their corners; the order "
         "is kept\n"},
        {"solid\nfacet normal 0 0 1\n" LOOP("0") FACET "endsolid\n", BATTEN_OK,
         "~0: mesh: 1 of 2 triangles have no area; kept\n"},
        {"solid a\n" FACET "endsolid a\nsolid b\nfacet normal 0 0 1\n" LOOP("x") FACET
         "endsolid\n",
         BATTEN_PARTLY_READ, "11: triangle 1 is left out: y of its corner 3 is not finite\n"},
        {"solid a\nfacet normal 0 0 1\n" LOOP("1e-999") "endsolid\n", BATTEN_OK,
         "6: the number 1e-999 is too small for a double; read as 0\n"
         "~0: a: 1 of 1 triangles have no area; kept\n"},
        {"solid a\nfacet normal 0 0 1\n" LOOP("x") "endsolid\n", BATTEN_BAD_FORMAT,
         "2: triangle 1 is left out: y of its corner 3 is not finite\n"
         "t: no triangle could be read\n"},
        {"solid a\nsolid\n", BATTEN_BAD_FORMAT,
         "t: this is not STL: it has neither 'solid' and 'facet' nor a header of 84 bytes and "
         "triangles\n"}};
    for (int i = 0; i < COUNT(cases); i++)
        check_listed(cases[i].text, BATTEN_FORMAT_STL, cases[i].status, cases[i].listing);
}

/* A header, a count and triangles of floats, with the attribute bytes of each. */
static char *bytes_of(int said, int count, const char *attributes, size_t *size)
{
    static const float corners[] = {0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0};
    *size = 84 + 50 * (size_t)count;
    char *data = test_array(*size + 60, 1);
    memset(data, 'x', 80);
    data[80] = (char)said;
    for (int i = 0; i < count; i++) {
        memcpy(data + 84 + 50 * i, corners, 48);
        memcpy(data + 84 + 50 * i + 48, attributes + 2 * i, 2);
    }
    return data;
}

TEST(attribute_bytes_are_counted_by_triangles)
{
    static const struct {
        char bytes[6];
        const char *listing;
    } cases[] = {{{0, 0, 0, 0, 0, 0}, ""},
                 {{1, 0, 0, 0, 0, 0}, "~0: the attribute bytes of 1 triangles are not read\n"},
                 {{0, 0, 0, 7, 0, 0}, "~0: the attribute bytes of 1 triangles are not read\n"},
                 {{1, 1, 0, 2, 3, 0}, "~0: the attribute bytes of 3 triangles are not read\n"}};
    for (int i = 0; i < COUNT(cases); i++) {
        size_t size = 0;
        const char *data = bytes_of(3, 3, cases[i].bytes, &size);
        batten_model *model =
            read_listed(data, size, BATTEN_FORMAT_STL, BATTEN_OK, cases[i].listing);
        const batten_mesh_parts *p = mesh_at(model, 0);
        CHECK_TEXT(batten_model_object(model, 0)->name, "mesh");
        CHECK_INT(p->triangle_count, 3);
        CHECK_INT(p->vertex_count, 3);
        CHECK(p->points[3] == 2 && p->points[7] == 3);
        batten_model_unref(model);
    }
}

TEST(counts_that_are_not_those_of_the_bytes_are_listed)
{
    static const char none[12] = {0};
    static const struct {
        int said, count, more;
        batten_status status;
        const char *listing;
    } cases[] = {
        {3, 2, 0, BATTEN_PARTLY_READ,
         "0: the header promises 3 triangles; the file has room for 2\n"},
        {1, 2, 0, BATTEN_PARTLY_READ, "0: the header promises 1 triangle; 1 more, left out\n"},
        {2, 4, 0, BATTEN_PARTLY_READ, "0: the header promises 2 triangles; 2 more, left out\n"},
        {2, 2, 7, BATTEN_OK, "0: bytes after the last of 2 triangles: 7; not read\n"},
        {0, 1, 0, BATTEN_BAD_FORMAT,
         "t: the header promises 0 triangles, and 50 bytes follow it\n"},
        {5, 0, 1, BATTEN_BAD_FORMAT,
         "t: the header promises 5 triangles, and 1 bytes follow it\n"}};
    for (int i = 0; i < COUNT(cases); i++) {
        size_t size = 0;
        const char *data = bytes_of(cases[i].said, cases[i].count, none, &size);
        batten_model *model = read_listed(data, size + (size_t)cases[i].more, BATTEN_FORMAT_STL,
                                          cases[i].status, cases[i].listing);
        batten_model_unref(model);
    }
}

TEST(bytes_that_are_cut_are_recognised_by_the_name_of_the_file)
{
    static const struct {
        const char *name;
        bool is_stl;
    } cases[] = {{"a.stl", true}, {"A.STL", true}, {"a.sla", false},
                 {".stl", false}, {"", false},     {"stl", false}};
    size_t size = 0;
    const char *data = bytes_of(9, 2, "\0\0\0", &size);
    for (int i = 0; i < COUNT(cases); i++) {
        batten_read_options options = batten_read_defaults();
        batten_model *model = NULL;
        options.file_name = cases[i].name;
        const batten_status status =
            batten_read_memory(data, size, &options, NULL, NULL, &model);
        if (!test_memory_failed(status, BATTEN_PARTLY_READ))
            CHECK_INT(status == BATTEN_PARTLY_READ, cases[i].is_stl);
        batten_model_unref(model);
    }
}

TEST(a_header_of_text_without_zero_bytes_is_not_taken_for_bytes_by_its_name)
{
    char text[200];
    batten_read_options options = batten_read_defaults();
    batten_model *model = NULL;
    memset(text, 'x', sizeof text);
    options.file_name = "a.stl";
    CHECK(batten_read_memory(text, sizeof text, &options, NULL, NULL, &model) != BATTEN_OK);
    CHECK(model == NULL);
    memset(text, 0, 60); /* zero bytes, and no room for a header */
    CHECK(batten_read_memory(text, 83, &options, NULL, NULL, &model) != BATTEN_OK);
    CHECK(model == NULL);
}

TEST(writing_bytes_remarks_what_is_joined_and_rounded)
{
    batten_mesh_parts parts = tetrahedron();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(batten_model_create(0, &model));
    add_mesh(model, "a", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_STL, false, NULL, &data, &size));
    batten_release(data);
    add_mesh(model, "b", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_STL, false, notes, &data, &size));
    CHECK_INT((long long)size, 84 + 50 * 8);
    if (!batten_notes_dropped(notes)) {
        CHECK(has_note(notes, "2 objects become one: binary STL does not keep them apart"));
        CHECK(!has_note(notes, "rounded"));
    }
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}
