#include "design/evaluate.h"

static batten_status evaluate(const char *feature, batten_design **out)
{
    static const char rows[] =
        "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0, 2], [4, 1, "
        "2], [4, 2, 2]]}\n"
        "  q: {points: [[0, 0, 2], [1, 0.5, 1], [2, 0.3, 2], [3, 1, 2], [4, 0, 0]]}\n"
        "  f: {points: [[0, 1, 0], [1, 1, 0], [2, 1, 0.1], [3, 1, 2], [4, 1, 2]]}\n"
        "  one: {points: [[1, 1], [1, 1], [1, 1]]}\n"
        "  few: {points: [[1, 1]]}\n"
        "  c: {circle: 1}\n  s: {euler-spiral: p}\n  i: {interpolate: p}\n";
    char text[2000];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s  a: %s\n", rows, feature);
    return evaluate_design(text, "a", NULL, out);
}

TEST(curves_within_a_bound_pass_their_points_and_tell_how_far)
{
    static const char *const features[] = {
        "{fit-within: p, within: 10 cm}",
        "{fit-within: p, within: 1 cm, corner: 60 deg}",
        "{fit-within: p, within: 1 cm, corners: [5], by: bezier}",
        "{fit-within: q, within: 30 cm, by: remove, degree: 2}",
        "{fit-within: q, within: 10 cm, closed: yes, by: insert}",
        "{fit-within: f, within: 20 cm, as: function}"};
    static const double within[] = {0.1, 0.01, 0.01, 0.3, 0.1, 0.2};
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design));
        const batten_feature_result *result = batten_design_result(design, "a");
        const batten_object *object = batten_model_object(result->value, 0);
        double largest = 0;
        for (int k = 0; k < object->point_count; k++) {
            double at[3], sum = 0;
            CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[k], 0, at));
            for (int c = 0; c < 3; c++)
                sum += pow(at[c] - object->points[3 * k + c], 2);
            largest = fmax(largest, sqrt(sum));
        }
        CHECK(result->has_error);
        CHECK_NEAR(result->error_max, largest, 1e-12);
        CHECK(largest <= within[i]);
        batten_design_free(design);
    }
}

TEST(curves_within_a_bound_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{fit-within: p, within: 0}", "it must be above 0"},
        {"{fit-within: p, within: -1}", "it must be above 0"},
        {"{fit-within: few, within: 1}", "no row has 2 points"},
        {"{fit-within: one, within: 1 cm}", "same parameter"},
        {"{fit-within: p, within: 1 cm, corners: [8]}", "corner 1 is point 8"},
        {"{fit-within: p, within: 1 cm, degree: 5, by: bezier}", "cubics"},
        {"{fit-within: p, within: 1 cm, as: function}", "rising abscissae"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, &design);
        if (test_memory_failed(status, BATTEN_BAD_ARGUMENT))
            status = evaluate(rows[i].feature, &design);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i].says);
    }
}

TEST(approximations_keep_parameters_and_tell_their_bound)
{
    static const char *const features[] = {"{approximate: c, within: 1 mm}",
                                           "{approximate: s, within: 1 mm, degree: 5}",
                                           "{approximate: i, within: 5 cm}"};
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design));
        const batten_feature_result *result = batten_design_result(design, "a");
        const batten_object *object = batten_model_object(result->value, 0);
        CHECK(!batten_curve_is_rational(object->curve));
        CHECK_INT(batten_curve_degree(object->curve), i == 1 ? 5 : 3);
        CHECK(object->chain == NULL);
        CHECK(result->has_error && result->error_max <= (i == 2 ? 0.05 : 1e-3));
        for (int k = 0; k < object->point_count; k++) {
            double at[3], sum = 0;
            CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[k], 0, at));
            for (int c = 0; c < 3; c++)
                sum += pow(at[c] - object->points[3 * k + c], 2);
            CHECK(sqrt(sum) <= result->error_max + 1e-9);
        }
        batten_design_free(design);
    }
    batten_design *design = NULL;
    CHECK_STATUS(evaluate("{approximate: c, within: 0}", &design), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(evaluate("{approximate: p, within: 1}", &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("curves are needed");
}
