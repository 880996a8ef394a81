#include "exchange/meshes/meshes.h"

TEST(vertices_and_faces_of_off_are_read)
{
    static const char *const texts[] = {"OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
                                        "# a square\nOFF # form\n\n4 1\n# vertices\n0 0 0\r\n1 "
                                        "0 0 # second\n\n1 1 0\n0 1 0\n\n4 "
                                        "0 1 2 3"};
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_noting(texts[i], BATTEN_FORMAT_OFF, "");
        CHECK_INT(mesh_at(model, 0)->vertex_count, 4);
        CHECK_INT(mesh_at(model, 0)->triangle_count, 2);
        CHECK(!mesh_at(model, 0)->colours && !mesh_at(model, 0)->normals);
        batten_model_unref(model);
    }
    batten_model_unref(read_noting(texts[0], BATTEN_FORMAT_AUTO, ""));
}

TEST(colours_of_off_are_parts_of_1_or_of_255)
{
    static const char *const texts[] = {
        "COFF\n3 1 0\n0 0 0 255 0 51\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n",
        "OFF\n3 1 0\n0 0 0 1.0 0 0.2 1\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n"};
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_noting(texts[i], BATTEN_FORMAT_AUTO, "");
        CHECK_BITS(mesh_at(model, 0)->colours[0], 1.0);
        CHECK_NEAR(mesh_at(model, 0)->colours[2], 0.2, 1e-15);
        batten_model_unref(model);
    }
    batten_model *model =
        read_noting("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 "
                    "2 255 0 0\n",
                    BATTEN_FORMAT_AUTO, "the colours of 1 faces are left out");
    CHECK_BITS(mesh_at(model, 0)->normals[8], 1.0);
    batten_model_unref(model);
}

TEST(N4_faces_and_vertices_of_off_that_are_none_are_left_out)
{
    static const struct {
        const char *body, *words;
    } cases[] = {
        {"0 0 0\n1 0 0\n0 1 0\n9 9\n3 0 1 2\n3 0 1 3\n", "vertex 4 is left out"},
        {"0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n3 0 1 4\n", "its corner 3 is vertex 5"},
        {"0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n3 0 1\n", "face 2 is left out: its count"},
        {"0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\nx 0 1 2\n", "face 2 is left out: its count"},
        {"0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n3 0 1 y\n", "its corner 3 is vertex 0"},
        {"0 0 0\n1 0 0\n0 1 0\n9 9 nan\n3 0 1 2\n3 0 1 3\n", "vertex 4 is left out"},
        {"0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n", "1 of 2 faces are in the file"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[200];
        snprintf(text, sizeof text, "OFF\n4 2 0\n%s", cases[i].body);
        batten_model *model =
            read_partly(text, strlen(text), BATTEN_FORMAT_OFF, cases[i].words);
        CHECK_INT(mesh_at(model, 0)->triangle_count, 1);
        batten_model_unref(model);
    }
}

TEST(F1_headers_of_off_that_are_none_are_refused)
{
    check_refused("", BATTEN_FORMAT_OFF, BATTEN_BAD_FORMAT, "the file is empty");
    check_refused("x", BATTEN_FORMAT_OFF, BATTEN_BAD_FORMAT, "the first word is not OFF");
    check_refused("OFF\n", BATTEN_FORMAT_OFF, BATTEN_BAD_FORMAT, "the counts of vertices");
    check_refused("OFF\n-3 1\n", BATTEN_FORMAT_OFF, BATTEN_BAD_FORMAT,
                  "the counts of vertices");
    check_refused("4OFF\n", BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED, "of the form 4OFF");
    check_refused("OFF BINARY\n", BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED, "binary OFF");
}

TEST(S2_a_thousand_million_vertices_in_a_small_off_are_refused)
{
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    batten_model *model = NULL;
    static const char text[] = "OFF\n1000000000 1000000000 0\n";
    limits.memory_bytes = 4096;
    options.limits = &limits;
    options.format = BATTEN_FORMAT_OFF;
    CHECK_STATUS(batten_read_memory(text, sizeof text - 1, &options, NULL, NULL, &model),
                 BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("no vertex could be read");
}

TEST(F2_off_that_is_cut_anywhere_is_refused_or_read_in_part)
{
    const char *text = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    check_cuts(text, strlen(text) - 2, BATTEN_FORMAT_OFF);
}
