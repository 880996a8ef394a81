#include "design/evaluate.h"

/* Operators without equations, and polynomials of least largest error, as a user writes them.
 */

static const char rows_of_points[] =
    "batten: 1\nfeatures:\n"
    "  p: {points: [[0, 0], [1, 1], [2, 1.5], [3, 0], [5, 1]]}\n"
    "  q: {points: [[0, 7, 0], [1, 7, 1], [2, 7, 4], [3, 7, 9], [5, 7, 25]]}\n"
    "  s: {points: [[0, 0, 1], [1, 1, 0], [2, 1, 1], [3, 0, 3], [5, 1, 2]]}\n"
    "  twice: {points: [[0, 0], [1, 1], [1, 1], [3, 0]]}\n";

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[2000];
    snprintf(text, sizeof text, "%s  a: %s\n", rows_of_points, feature);
    return evaluate_design(text, "a", NULL, out);
}

TEST(operators_are_as_far_from_their_points_as_they_say)
{
    static const char *const features[] = {
        "{schoenberg: p}",
        "{schoenberg: s, degree: 2, closed: yes}",
        "{schoenberg: q, as: function, degree: 4, knots: none}",
        "{quasi-interpolant: p, as: function}",
        "{quasi-interpolant: s, closed: yes, parameters: centripetal}",
        "{quasi-interpolant: q, degree: 2}",
        "{minimax: p}",
        "{minimax: q, degree: 1}",
    };
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design));
        const batten_feature_result *result = batten_design_result(design, "a");
        const batten_object *made = batten_model_object(result->value, 0);
        double most = 0;
        for (int k = 0; k < made->point_count; k++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(made->curve, made->parameters[k], 0, at));
            const double *q = made->points + 3 * k;
            most = fmax(most, hypot(hypot(at[0] - q[0], at[1] - q[1]), at[2] - q[2]));
        }
        CHECK(most > 1e-3);
        CHECK_NEAR(result->error_max, most, 1e-12);
        batten_design_free(design);
    }
}

TEST(a_parabola_is_reproduced_by_the_operators_that_promise_it)
{
    static const char *const features[] = {
        "{quasi-interpolant: q, as: function, degree: 2}",
        "{quasi-interpolant: q, as: function}",
        "{minimax: q, degree: 2}",
        "{minimax: q}",
    };
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design));
        const batten_object *made =
            batten_model_object(batten_design_result(design, "a")->value, 0);
        for (int k = 0; k <= 50; k++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(made->curve, k / 10.0, 0, at));
            CHECK_NEAR(at[0], k / 10.0, 1e-13);
            CHECK_NEAR(at[1], 7, 1e-14);
            CHECK_NEAR(at[2], k * k / 100.0, 1e-12);
        }
        batten_design_free(design);
    }
}

TEST(operators_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{schoenberg: p, degree: 26}", "the degree is 26"},
        {"{schoenberg: twice}", "twice: points 2 and 3 coincide"},
        {"{schoenberg: s, as: function}", "must lie in a plane"},
        {"{schoenberg: s, closed: yes, knots: none}", "makes no closed curves"},
        {"{quasi-interpolant: p, degree: 10}", "the degree is 10; it must be in 1..9"},
        {"{quasi-interpolant: p, as: function, closed: yes}", "a function cannot be closed"},
        {"{minimax: p, degree: 4}", "5 points"},
        {"{minimax: twice, degree: 1}", "rising abscissae"},
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
