/* What is said of files of vertices and faces, to the letter. */
#include "exchange/listed.h"
#include "exchange/meshes/meshes.h"

#define THREE "0 0 0\n1 0 0\n0 1 0\n"

TEST(what_is_wrong_in_OFF_is_named_with_its_line)
{
    static const struct {
        const char *text;
        batten_status status;
        const char *listing;
    } cases[] = {
        {"OFF\n3 1 0\n" THREE "3 0 1 2\n", BATTEN_OK, ""},
        {"OFF\n3 1 0\n" THREE "3 0 1 2\nmore\n", BATTEN_OK,
         "0: 6 bytes follow where the file should end, at byte 35; not read\n"},
        {"OFF\n3 2 0\n" THREE "3 0 1 2\n", BATTEN_PARTLY_READ,
         "0: 1 of 2 faces are in the file\n"},
        {"OFF\n3 2 0\n" THREE "3 0 1 2 255 0 0\n3 2 1 0 1\n", BATTEN_OK,
         "0: the colours of 2 faces are left out\n"},
        {"OFF\n3 2 0\n" THREE "3 0 1 2\n3 0 1 # 2\n", BATTEN_PARTLY_READ,
         "7: face 2 is left out: its count or a corner is missing\n"},
        {"OFF\n3 2 0\n" THREE "x 0 1\n3 0 1 2\n", BATTEN_PARTLY_READ,
         "6: face 1 is left out: its count or a corner is missing\n"},
        {"OFF\n3 2 0\n" THREE "3 0 1 2\n3 0 1 3\n", BATTEN_PARTLY_READ,
         "7: face 2 is left out: its corner 3 is vertex 4, which does not exist\n"},
        {"OFF\n3 2 0\n" THREE "3 0 1 2\n2 0 1\n", BATTEN_PARTLY_READ,
         "7: face 2 is left out: it has 2 corners\n"},
        {"OFF\n4 1 0\n" THREE "0 1\n3 0 1 2\n", BATTEN_PARTLY_READ,
         "6: vertex 4 is left out: it is not of 3 numbers\n"},
        {"OFF\n4 1 0\n" THREE "0 1 x\n3 0 1 2\n", BATTEN_PARTLY_READ,
         "6: vertex 4 is left out: it is not of 3 numbers\n"},
        {"OFF\n4 1 0\n" THREE "0 x 1\n3 0 1 2\n", BATTEN_PARTLY_READ,
         "6: vertex 4 is left out: it is not of 3 numbers\n"},
        {"NOFF\n4 0 0\n0 0 0 0 0 1\n1 0 0 1 0 0\n2 0 0 0 0 1\n3 0 0 0 0\n", BATTEN_PARTLY_READ,
         "6: vertex 4 is left out: it is not of 6 numbers\n"
         "0: points: of points only coordinates are kept; left out of 3 points: normals\n"},
        {"OFF\n9 0 0\n" THREE, BATTEN_PARTLY_READ, "0: 3 of 9 vertices are in the file\n"},
        {"OFF\n1 0 0\n1 2 x\n", BATTEN_BAD_FORMAT,
         "3: vertex 1 is left out: it is not of 3 numbers\nt: no vertex could be read\n"},
        {"STOFF\n", BATTEN_UNSUPPORTED, "t: OFF files of the form STOFF are not read\n"},
        {"4OFF\n", BATTEN_UNSUPPORTED, "t: OFF files of the form 4OFF are not read\n"},
        {"nOFF\n", BATTEN_UNSUPPORTED, "t: OFF files of the form nOFF are not read\n"},
        {"STCNOFF\n", BATTEN_UNSUPPORTED, "t: OFF files of the form STCNOFF are not read\n"},
        {"STNOFF\n", BATTEN_UNSUPPORTED, "t: OFF files of the form STNOFF are not read\n"},
        {"STCOFF\n", BATTEN_UNSUPPORTED, "t: OFF files of the form STCOFF are not read\n"},
        {"OFF BINARY\n", BATTEN_UNSUPPORTED, "t: binary OFF files are not read\n"},
        {"# nothing\n", BATTEN_BAD_FORMAT, "t: the file is empty\n"},
        {"\nOF\n", BATTEN_BAD_FORMAT, "t:2: the first word is not OFF\n"},
        {"XFF\n3 1 0\n", BATTEN_BAD_FORMAT, "t:1: the first word is not OFF\n"},
        {"OFF\n3\n" THREE, BATTEN_BAD_FORMAT,
         "t:2: the counts of vertices and faces are missing\n"},
        {"OFF\n3 -1\n" THREE, BATTEN_BAD_FORMAT,
         "t:2: the counts of vertices and faces are missing\n"},
        {"OFF\nx 1\n" THREE, BATTEN_BAD_FORMAT,
         "t:2: the counts of vertices and faces are missing\n"}};
    for (int i = 0; i < COUNT(cases); i++)
        check_listed(cases[i].text, BATTEN_FORMAT_OFF, cases[i].status, cases[i].listing);
}

static const batten_mesh_parts *parts_of(const char *text, batten_model **model)
{
    *model = read_listed(text, strlen(text), BATTEN_FORMAT_OFF, BATTEN_OK, "");
    return mesh_at(*model, 0);
}

TEST(vertices_of_OFF_are_coordinates_then_normals_then_colours)
{
    batten_model *model = NULL;
    const batten_mesh_parts *p =
        parts_of("CNOFF\n3 1 0\n1 2 3 0 0 1 .1 .2 .3\n4 5 6 0 1 0 .4 .5 .6 .9\n"
                 "7 8 8 1 0 0 .7 .8 .9 1 5\n3 0 1 2\n",
                 &model);
    static const double points[] = {1, 2, 3, 4, 5, 6, 7, 8, 8};
    for (int i = 0; i < 9; i++) {
        CHECK_BITS(p->points[i], points[i]);
        CHECK_NEAR(p->colours[i], (i + 1) / 10.0, 1e-16);
        CHECK_BITS(p->normals[i], i == 2 || i == 4 || i == 6);
    }
    batten_model_unref(model);
}

TEST(colours_of_OFF_are_of_255_when_all_are_whole_and_one_is_above_1)
{
    static const struct {
        const char *vertices;
        double due[9];
    } cases[] = {{"0 0 0 255 51 0\n1 0 0 0 1 0\n0 1 0 0 0 102\n",
                  {1, 0.2, 0, 0, 1 / 255.0, 0, 0, 0, 0.4}},
                 {"0 0 0 1 1 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n", {1, 1, 0, 0, 1, 0, 0, 0, 1}},
                 {"0 0 0 1 .5 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n", {1, 0.5, 0, 0, 1, 0, 0, 0, 1}}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[200];
        batten_model *model = NULL;
        snprintf(text, sizeof text, "COFF\n3 1 0\n%s3 0 1 2\n", cases[i].vertices);
        const batten_mesh_parts *p = parts_of(text, &model);
        for (int k = 0; k < 9; k++)
            CHECK_NEAR(p->colours[k], cases[i].due[k], 1e-16);
        batten_model_unref(model);
    }
}

TEST(colours_of_OFF_are_there_only_when_each_vertex_has_one)
{
    batten_model *model = NULL;
    CHECK(!parts_of("OFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 1 1\n0 1 0 1 1 1\n3 0 1 2\n", &model)
               ->colours);
    batten_model_unref(model);
    /* One that could not be read has no say. */
    const char *text = "OFF\n4 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\nx\n3 0 1 2\n";
    model = read_listed(text, strlen(text), BATTEN_FORMAT_OFF, BATTEN_PARTLY_READ,
                        "6: vertex 4 is left out: it is not of 3 numbers\n");
    CHECK(mesh_at(model, 0)->colours != NULL);
    CHECK_INT(mesh_at(model, 0)->vertex_count, 3);
    batten_model_unref(model);
}

static int steps;
static bool count_and_stop(void *user)
{
    return ++steps > *(int *)user;
}

TEST(reading_of_many_vertices_and_faces_can_be_cancelled)
{
    enum { COUNT_OF_EACH = 10001 };
    char *text = test_array(24 * COUNT_OF_EACH + 100, 1), *at = text;
    if (test_cases(1000) < 1000)
        SKIP("long");
    at += sprintf(at, "OFF\n%d %d 0\n", COUNT_OF_EACH, COUNT_OF_EACH);
    for (int i = 0; i < COUNT_OF_EACH; i++)
        at += sprintf(at, "%d 0 %d\n", i, i % 7);
    for (int i = 0; i < COUNT_OF_EACH; i++)
        at += sprintf(at, "3 0 1 %d\n", i);
    for (int allowed = 0; allowed < 2; allowed++) {
        batten_job job = BATTEN_JOB;
        batten_model *model = NULL;
        steps = 0;
        job.user = &allowed;
        job.is_cancelled = count_and_stop;
        batten_read_options options = batten_read_defaults();
        options.format = BATTEN_FORMAT_OFF;
        CHECK_STATUS(batten_read_memory(text, strlen(text), &options, &job, NULL, &model),
                     BATTEN_CANCELLED);
        CHECK(model == NULL);
        CHECK_INT(steps, allowed + 1);
    }
}
