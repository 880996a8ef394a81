#include "design/evaluate.h"

static batten_status evaluate(const char *feature, batten_design **out)
{
    static const char rows[] =
        "  p: {points: [[0, 0, 1], [1, 0.01, 1], [2, 0, 1], [3, 0.01, 1], [3, 1, 1]]}\n"
        "  ring: {points: [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]]}\n"
        "  line: {polyline: [[0, 0], [1, 0.01], [2, 0], [3, 1]]}\n"
        "  c: {circle: 1}\n";
    char text[2000];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s  a: %s\n", rows, feature);
    return evaluate_design(text, "a", NULL, out);
}

TEST(points_and_polylines_are_thinned_and_the_distance_is_told)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{thin-points: [p, line], within: 2 cm}", &design));
    const batten_feature_result *result = batten_design_result(design, "a");
    CHECK_INT(batten_model_count(result->value), 2);
    const batten_object *row = batten_model_object(result->value, 0),
                        *line = batten_model_object(result->value, 1);
    CHECK(row->kind == BATTEN_OBJECT_POINTS);
    CHECK_INT(row->point_count, 3);
    CHECK_TEXT(row->name, "p");
    static const double stay[9] = {0, 0, 1, 3, 0.01, 1, 3, 1, 1};
    for (int i = 0; i < 9; i++)
        CHECK_NEAR(row->points[i], stay[i], 0);
    CHECK(line->kind == BATTEN_OBJECT_CURVE);
    CHECK_INT(batten_curve_degree(line->curve), 1);
    CHECK_INT(batten_curve_point_count(line->curve), 3);
    CHECK(result->has_error);
    CHECK_NEAR(result->error_max, 0.01, 1e-4);
    batten_design_free(design);
}

TEST(a_ring_keeps_its_corners)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{thin-points: ring, within: 0, closed: yes}", &design));
    const batten_object *row = batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK_INT(row->point_count, 4);
    for (int i = 0; i < 12; i++)
        CHECK(row->points[i] == 0 || row->points[i] == 2);
    batten_design_free(design);
}

TEST(curves_that_bend_and_tolerances_below_0_are_refused)
{
    batten_design *design = NULL;
    CHECK_STATUS(evaluate("{thin-points: c, within: 1 cm}", &design), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("not a polyline");
    CHECK_STATUS(evaluate("{thin-points: p, within: -1 cm}", &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("must not be negative");
}
