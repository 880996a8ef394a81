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

TEST(other_columns_are_refused)
{
    check_refused("x,y,w\n1,2,3\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "column 1: 'x' is not a number");
    check_refused("a b\n1 2\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT, "'a' is not a number");
    check_refused("1 2 3 4\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "a point has 2 or 3 coordinates, not 4");
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
