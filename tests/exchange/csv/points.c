#include "exchange/reading.h"

TEST(points_stand_in_two_or_three_columns)
{
    const struct {
        const char *text;
        double point[3];
        double unit;
    } cases[] = {
        {"1 2\n0 0\n", {1, 2, 0}, 0},
        {"1,2,3\n0,0,0\n", {1, 2, 3}, 0},
        {"x y z\n1 2 3\n0 0 0\n", {1, 2, 3}, 0},
        {"z_mm;x_mm;y_mm\n3;1;2\n0;0;0\n", {1, 2, 3}, 0.001},
        {"\"x\",\"y\"\n1,2\n0,0\n", {1, 2, 0}, 0},
        {"# points\n1\t2\n0\t0\n", {1, 2, 0}, 0},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = read_noting(cases[i].text, BATTEN_FORMAT_AUTO, "");
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(batten_model_count(model), 1);
        CHECK_INT(object->point_count, 2);
        CHECK_TEXT(object->name, "points");
        for (int k = 0; k < 3; k++)
            CHECK_BITS(object->points[k], cases[i].point[k]);
        CHECK_BITS(batten_model_unit_metres(model), cases[i].unit);
        batten_model_unref(model);
    }
}

TEST(blank_lines_separate_rows_of_points)
{
    batten_model *model =
        read_noting("\n1 2\n3 4\n\n\n5 6\n# note\n7 8\n\n9 9\n", BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 3);
    CHECK_INT(batten_model_object(model, 1)->point_count, 2);
    CHECK_BITS(batten_model_object(model, 1)->points[0], 5.0);
    CHECK_TEXT(batten_model_object(model, 2)->name, "points 3");
    batten_model_unref(model);
}

/* Also what could be half-breadths, were there a word of hulls. */
TEST(columns_that_are_no_coordinates_are_left_out_and_counted)
{
    const struct {
        const char *text, *words;
        double point[3];
    } cases[] = {
        {"contour,z_mm,x_mm,y_mm\n0,3,1,2\n1,6,4,5\n",
         "1 column is left out, 'contour'",
         {1, 2, 3}},
        {"x,y,z,intensity\n1,2,3,70\n4,5,6,80\n",
         "1 column is left out, 'intensity'",
         {1, 2, 3}},
        {"x y z r g b\n1 2 3 255 0 0\n4 5 6 0 0 255\n",
         "3 columns are left out, 'r', 'g', 'b'",
         {1, 2, 3}},
        {"1 2 3 255 0 0\n4 5 6 0 0 255\n",
         "3 columns are left out: points have x, y and z",
         {1, 2, 3}},
        {"x,y,w\n1,2,3\n4,5,6\n", "'w'", {1, 2, 0}},
        {"id,x,y,height\n9,1,2,3\n8,4,5,6\n",
         "2 columns are left out, 'id', 'height'",
         {1, 2, 0}},
    };
    const batten_format formats[] = {BATTEN_FORMAT_AUTO, BATTEN_FORMAT_POINTS};
    for (int i = 0; i < 2 * COUNT(cases); i++) {
        batten_model *model =
            read_noting(cases[i / 2].text, formats[i % 2], cases[i / 2].words);
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->kind, BATTEN_OBJECT_POINTS);
        CHECK_INT(object->point_count, 2);
        for (int k = 0; k < 3; k++)
            CHECK_BITS(object->points[k], cases[i / 2].point[k]);
        batten_model_unref(model);
    }
}

TEST(what_is_no_point_is_refused)
{
    check_refused("a b\n1 2\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT, "'a' is not a number");
    check_refused("1\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "a point has 2 or 3 coordinates, not 1");
    check_refused("x,y,w,x\n1,2,3,4\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "'x' is not a number");
    check_refused("x,y\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT, "there is no point");
    check_refused("1,2\n,3\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:2: column 1: '' is not");
}

TEST(S1_more_points_or_objects_than_the_limit_are_refused)
{
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    batten_model *model = NULL;
    static const char text[] = "1 2\n3 4\n\n5 6\n";
    options.limits = &limits;
    limits.points = 2;
    CHECK_STATUS(batten_read_memory(text, sizeof text - 1, &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("3 points; the limit is 2");
    limits.points = 3;
    limits.entities = 1;
    CHECK_STATUS(batten_read_memory(text, sizeof text - 1, &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("2 objects; the limit is 1");
    limits.entities = 2;
    limits.memory_bytes = 100;
    CHECK_STATUS(batten_read_memory(text, sizeof text - 1, &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("more memory than the limit of 100 bytes");
}
