#include "design/evaluate.h"

TEST(polylines_take_corners_or_features_with_points)
{
    static const struct {
        const char *feature, *says;
        int count, points;
    } rows[] = {
        {"{polyline: [[0, 0], [1, 2, 1], [3, 2]]}", NULL, 1, 3},
        {"{polyline: [origin, x, [3, 2]]}", NULL, 1, 3},
        {"{polyline: row}", NULL, 1, 4},
        {"{polyline: [row, grid]}", NULL, 4, 4},
        {"{polyline: grid}", NULL, 3, 2},
        {"{polyline: [row, [1, 2, 3]]}",
         "corner 2 is a point, and another is the feature 'row'", 0, 0},
        {"{polyline: rwo}", "no feature is named 'rwo'; did you mean 'row'?", 0, 0},
        {"{polyline: a}", "a", 0, 0},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char text[600];
        batten_design *design = NULL;
        snprintf(
            text, sizeof text,
            "batten: 1\nunits: m\nfeatures:\n"
            "  row: {points: [[0, 0, 1], [1, 0, 2], [2, 1, 1], [4, 1, 0]]}\n"
            "  grid: {points: [[0, 0], [1, 0], [0, 1], [1, 1], [0, 2], [1, 2]], columns: 2}\n"
            "  a: %s\n",
            rows[i].feature);
        const batten_status status = evaluate_design(text, "a", NULL, &design);
        if (status == BATTEN_OUT_OF_MEMORY)
            continue;
        CHECK((status == BATTEN_OK) == !rows[i].says);
        if (status == BATTEN_OK) {
            const batten_model *model = batten_design_result(design, "a")->value;
            CHECK_INT(batten_model_count(model), rows[i].count);
            const batten_curve *curve = batten_model_object(model, 0)->curve;
            CHECK_INT(batten_curve_point_count(curve), rows[i].points);
            CHECK_INT(batten_curve_degree(curve), 1);
        } else {
            CHECK_MESSAGE(rows[i].says);
        }
        batten_design_free(design);
    }
}
