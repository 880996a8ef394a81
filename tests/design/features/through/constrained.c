#include "design/evaluate.h"

/* A feature `a` of the points p, which rise in steps in a plane y = 1. */
static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[1000];
    snprintf(text, sizeof text,
             "batten: 1\nfeatures:\n  p: {points: [[0, 1, 0], [1, 1, 0], [2, 1, 0.05], [3, 1, "
             "1], [4, 1, 1.05], [5, 1, 1.1]]}\n  a: %s\n",
             feature);
    return evaluate_design(text, "a", NULL, out);
}

TEST(constrained_keeps_to_its_side_of_lines_as_curve_and_as_function)
{
    static const char *const ways[] = {"curve", "function"};
    for (int i = 0; i < 2; i++) {
        char feature[300];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature,
                 "{constrained: p, as: %s, lines: [[0, 1, 0], [5, 1, 1.1]], sides: [[0, 0, 1], "
                 "[0.02, 0, -1]], forward: [[0, 0, 1]], to: [0, 5], from: [1, 2]}",
                 ways[i]);
        CHECK_OK(evaluate(feature, &design));
        const batten_object *object =
            batten_model_object(batten_design_result(design, "a")->value, 0);
        const batten_interval domain = batten_curve_domain(object->curve);
        double before = 0;
        for (int k = 0; k <= 500; k++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(object->curve,
                                           domain.a + (domain.b - domain.a) * k / 500, 0, at));
            CHECK_NEAR(at[1], 1, 1e-12);
            CHECK(at[2] >= before - 1e-12);
            CHECK(at[0] < 1 || at[0] > 4 || at[2] <= 1.1 + 0.02 * (at[0] - 5) + 1e-12);
            before = at[2];
        }
        batten_design_free(design);
    }
}

TEST(constrained_names_what_contradicts_and_lists_that_do_not_fit)
{
    batten_design *design = NULL;
    CHECK_STATUS(
        evaluate("{constrained: p, lines: [[0, 1, 0.5]], sides: [[0, 0, 1]]}", &design),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("constraint 1 (value, from point 1 to 6) cannot hold");
    CHECK_STATUS(evaluate("{constrained: p, lines: [[0, 1, 0.5]]}", &design),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("'lines' has 1 and 'sides' 0");
    CHECK_STATUS(
        evaluate("{constrained: p, as: function, at: [2], directions: [[0, 0, 1]]}", &design),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("upright");
}
