/* What is said of objects of GoTools, to the letter and the line. */
#include "exchange/listed.h"
#include "exchange/meshes/meshes.h"

#define LINE "100 1 0 0\n3 0\n2 2\n0 0 1 1\n0 0 0\n1 2 3\n"
#define READ(n) "~0: spline curve: " n " read\n"

TEST(what_is_wrong_in_G2_is_named_with_its_line)
{
    static const struct {
        const char *text;
        batten_status status;
        const char *listing;
    } cases[] = {
        {LINE LINE, BATTEN_OK, READ("2")},
        {LINE "7 8\n" LINE, BATTEN_PARTLY_READ,
         "7: spline curve 1: words after its end that belong to no object: 2; left out\n" READ(
             "2")},
        {LINE "100 1 0 0\n3 0\n2 2\n0 0 1 1\n0 0 0\n1 x 3\n" LINE, BATTEN_PARTLY_READ,
         "12: curve 2: a coordinate is 'x', not a number; left out\n0: curve: 2 read, 1 left out\n"},
        {"7 8\n" LINE, BATTEN_BAD_FORMAT, "t:1: expected the header of an object here\n"}};
    for (int i = 0; i < 2; i++)
        check_listed(cases[i].text, BATTEN_FORMAT_G2, cases[i].status, cases[i].listing);
    check_listed(cases[3].text, BATTEN_FORMAT_G2, cases[3].status, cases[3].listing);
    batten_model_unref(read_so(cases[2].text, BATTEN_FORMAT_G2, BATTEN_PARTLY_READ,
                               "is 'x', not a number; left out"));
}

TEST(segments_are_curves_from_end_to_end)
{
    static const char text[] = "410 1 0 0\n2\n0 1 2 3 4 5\n6 7 8 9 10 12\n";
    batten_model *model = NULL;
    CHECK_OK(read_text(text, BATTEN_FORMAT_G2, NULL, &model));
    CHECK_INT(batten_model_count(model), 2);
    static const double due[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12};
    for (int i = 0; i < 2; i++) {
        const batten_object *object = batten_model_object(model, i);
        CHECK_INT(object->kind, BATTEN_OBJECT_CURVE);
        for (int k = 0; k < 6; k++)
            CHECK_BITS(batten_curve_points(object->curve)[k], due[6 * i + k]);
    }
    batten_model_unref(model);
}

TEST(points_may_have_a_parameter_before_them)
{
    static const char *const texts[] = {"400 1 0 0\n2\n1 2 3\n4 5 6\n",
                                        "400 1 0 0\n2\n0.5 1 2 3\n0.75 4 5 6\n"};
    for (int i = 0; i < 2; i++) {
        batten_model *model = NULL;
        CHECK_OK(read_text(texts[i], BATTEN_FORMAT_G2, NULL, &model));
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->point_count, 2);
        for (int k = 0; k < 6; k++)
            CHECK_BITS(object->points[k], k + 1);
        CHECK_INT(object->parameters != NULL, i);
        if (i)
            CHECK(object->parameters[0] == 0.5 && object->parameters[1] == 0.75);
        batten_model_unref(model);
    }
}

static int asked;

static bool say_no_but_count(void *user)
{
    (void)user;
    return asked++ > 0;
}

TEST(reading_of_objects_can_be_cancelled_between_them)
{
    batten_job job = BATTEN_JOB;
    batten_model *model = NULL;
    batten_read_options options = batten_read_defaults();
    options.format = BATTEN_FORMAT_G2;
    job.is_cancelled = say_no_but_count;
    asked = 0;
    CHECK_STATUS(batten_read_memory(LINE LINE LINE, strlen(LINE LINE LINE), &options, &job,
                                    NULL, &model),
                 BATTEN_CANCELLED);
    CHECK(model == NULL);
    CHECK_INT(asked, 2);
}

TEST(objects_of_a_file_are_limited)
{
    batten_read_options options = batten_read_defaults();
    batten_limits limits = batten_limits_defaults();
    batten_model *model = NULL;
    options.limits = &limits;
    options.format = BATTEN_FORMAT_G2;
    limits.entities = 1;
    CHECK_STATUS(batten_read_memory(LINE LINE, strlen(LINE LINE), &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("line 7: 2 objects; the limit is 1");
    limits.entities = 2;
    CHECK_OK(batten_read_memory(LINE LINE, strlen(LINE LINE), &options, NULL, NULL, &model));
    batten_model_unref(model);
}

TEST(triangles_have_the_points_and_corners_of_the_file)
{
    static const char text[] =
        "310 1 0 0\n4 3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\n3 0 1 2\n3 0 3 1\n3 2 1 3\n";
    static const int corners[] = {0, 1, 2, 0, 3, 1, 2, 1, 3};
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    batten_model *model = NULL;
    CHECK_OK(read_text(text, BATTEN_FORMAT_G2, NULL, &model));
    const batten_mesh_parts *mesh = batten_mesh_view(batten_model_object(model, 0)->mesh);
    CHECK_INT(mesh->triangle_count, 3);
    CHECK_INT(mesh->vertex_count, 4);
    for (int i = 0; i < COUNT(corners); i++)
        CHECK_INT(mesh->corners[i], corners[i]);
    for (int i = 0; i < COUNT(points); i++)
        CHECK_BITS(mesh->points[i], points[i]);
    batten_model_unref(model);
}

TEST(what_is_wrong_in_triangles_is_named)
{
    static const struct {
        const char *text, *words;
    } cases[] = {
        {"310 1 0 0\n3 1\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 0\n",
         "the number of corners of a triangle is 4"},
        {"310 1 0 0\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a corner is 3"},
        {"310 1 0 0\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a corner is -1"},
        {"310 1 0 0\n3 -1\n", "the number of points or triangles is -1"},
        {"410 1 0 0\n-1\n", "the number of segments is -1"},
        {"400 1 0 4 255 0 0 256\n1\n1 2 3\n", "a part of the colour is 256"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_refused(cases[i].text, BATTEN_FORMAT_G2, BATTEN_UNSUPPORTED, cases[i].words);
}
