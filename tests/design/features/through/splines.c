#include "design/expect.h"
#include "support/test.h"

#include <batten/design.h>
#include <string.h>

/* Splines through points as operations: they pass the points of a row wherever it lies. */

static const char rows_of_points[] =
    "batten: 1\nfeatures:\n"
    "  p: {points: [[0, 0], [1, 1], [2, 1.5], [3, 0], [5, 1]]}\n"
    "  q: {points: [[0, 7, 0], [1, 7, 1], [2, 7, 1.5], [3, 7, 0], [5, 7, 1]]}\n"
    "  s: {points: [[0, 0, 1], [1, 1, 0], [2, 1, 1], [3, 0, 3], [5, 1, 2]]}\n"
    "  two: {points: [[0, 0], [3, 4]]}\n"
    "  one: {points: [[0, 0]]}\n";

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[2000];
    snprintf(text, sizeof text, "%s  a: %s\n", rows_of_points, feature);
    batten_design_options options = batten_design_defaults();
    options.file_name = "splines.yaml";
    batten_design *design = NULL;
    batten_status status = batten_design_parse(text, strlen(text), &options, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, "a", NULL, NULL);
    if (status == BATTEN_OK)
        *out = design;
    else
        batten_design_free(design);
    return status;
}

static void check_passes(const batten_object *object)
{
    CHECK(object->curve && object->parameters);
    for (int i = 0; i < object->point_count; i++) {
        double p[3];
        CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[i], 0, p));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(p[k], object->points[3 * i + k], 1e-12);
    }
}

TEST(splines_as_operations_pass_their_points)
{
    static const char *const features[] = {
        "{tension: p}",
        "{tension: q, amount: 3}",
        "{tension: s, amount: [1, 2, 3, 4], rule: convex}",
        "{tension: p, as: function, rule: monotone}",
        "{tension: q, as: function, start: clamped, start-vector: [2, 0], end: parabolic}",
        "{tension: s, closed: yes, parameters: centripetal}",
        "{tension: two}",
        "{nu-spline: p, nu: 3}",
        "{nu-spline: s, nu: [0, 1, 50, 1, 0], closed: yes}",
        "{nu-spline: q, as: function, ends: parabolic}",
        "{weighted-spline: p, as: function}",
        "{weighted-spline: s, weights: [1, 2, 5, 0.1]}",
        "{beta-spline: s, use: through, beta1: 1.2, beta2: 1}",
        "{beta-spline: p, use: through, closed: yes}",
        "{quadratic-spline: s}",
        "{quadratic-spline: s, knots: midpoints}",
        "{quadratic-spline: q, knots: sequential, slope: end, vector: [0, 1, 0], as: function}",
    };
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_model_count(model), 1);
        check_passes(batten_model_object(model, 0));
        batten_design_free(design);
    }
}

TEST(a_slope_of_a_function_in_tension_is_its_first_number)
{
    batten_design *design = NULL;
    CHECK_OK(
        evaluate("{tension: q, as: function, start: clamped, start-vector: [2, 0]}", &design));
    const batten_object *made =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    double p[6];
    CHECK_OK(batten_chain_evaluate(made->chain, 0, 1, p));
    CHECK_NEAR(p[3], 1, 1e-14);
    CHECK_NEAR(p[4], 0, 1e-14);
    CHECK_NEAR(p[5], 2, 1e-13);
    batten_design_free(design);
}

TEST(a_beta_spline_near_points_has_no_parameters_of_them)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{beta-spline: p, beta2: 3}", &design));
    const batten_object *made =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK(made->curve && !made->parameters);
    CHECK_INT(made->point_count, 5);
    batten_design_free(design);
}

TEST(splines_as_operations_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{tension: p, amount: [1, 2]}", "'amount' has 2 numbers for 4 spans"},
        {"{tension: p, amount: -1}", "the tension of span 1 is -1"},
        {"{tension: p, ends: fair}", "the start asks for one"},
        {"{tension: p, as: function, closed: yes}", "a function cannot be closed"},
        {"{tension: s, as: function}", "must lie in a plane"},
        {"{tension: one}", "no row has 2 points"},
        {"{nu-spline: p, nu: [1, 2]}", "'nu' has 2 numbers for 5 points"},
        {"{nu-spline: p, nu: -100}", "negative nu"},
        {"{weighted-spline: p, weights: 0}", "the weight of span 1 is 0"},
        {"{weighted-spline: p, as: function, closed: yes}", "a function cannot be closed"},
        {"{beta-spline: p, beta1: 0}", "beta1 is 0"},
        {"{quadratic-spline: p, knots: midpoints, as: function}", "are not mid-points"},
        {"{beta-spline: two, closed: yes}", "at least 3"},
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

static const char spaced[] = "  near: {points: [[0, 0], [1, 1], [1.0000004, 1], [2, 0]]}\n"
                             "  even: {points: [[0, 0], [1, 1], [1.00004, 1], [2, 0]]}\n"
                             "  far: {points: [[1e11, 0], [1e11, 100], [100000000100, 200]]}\n"
                             "  away: {points: [[1e6, 0], [1e6, 100], [1000100, 200]]}\n";

TEST(N2_points_at_the_mercy_of_rounding_are_noted)
{
    static const expect_row rows[] = {
        {"{interpolate: near}", BATTEN_OK,
         "notes points 2 and 3 are 4e-07 apart, others up to 1.41"},
        {"{interpolate: even}", BATTEN_OK, "silent"},
        {"{interpolate: far}", BATTEN_OK,
         "notes lose 0.0014 to rounding, more than the tolerance 0.001"},
        {"{interpolate: away}", BATTEN_OK, "silent"},
    };
    EXPECT(spaced, rows);
}
