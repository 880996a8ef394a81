#include "design/evaluate.h"

/* Least squares under conditions, and robust, as a user writes them. */

static const char rows_of_points[] =
    "batten: 1\nfeatures:\n"
    "  p: {points: [[0, 0], [1, 1], [2, 1.5], [3, 2.5], [4, 2.2], [5, 3], [6, 2.9], [7, "
    "3.2]]}\n"
    "  far: {points: [[0, 0], [1, 1.01], [2, 1.98], [3, 9], [4, 4.02], [5, 4.97], [6, 6.01], "
    "[7, 7]]}\n"
    "  s: {points: [[0, 0, 1], [1, 1, 0], [2, 1, 1], [3, 0, 3], [5, 1, 2], [6, 2, 2]]}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[2000];
    snprintf(text, sizeof text, "%s  a: %s\n", rows_of_points, feature);
    return evaluate_design(text, "a", notes, out);
}

static const batten_object *made_of(const batten_design *design)
{
    return batten_model_object(batten_design_result(design, "a")->value, 0);
}

TEST(least_squares_as_an_operation_passes_and_keeps_its_shape)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{least-squares: p, as: function, points: 6, hold-ends: no, "
                      "shape: [increasing, concave], pass: [[2, 1.6]], under: [[7, 3.1]], "
                      "start-direction: [1, 1.2]}",
                      NULL, &design));
    const batten_curve *curve = made_of(design)->curve;
    double before = -HUGE_VAL, slope = HUGE_VAL;
    for (int i = 0; i <= 70; i++) {
        double at[6];
        CHECK_OK(batten_curve_evaluate(curve, i / 10.0, 1, at));
        CHECK_NEAR(at[0], i / 10.0, 1e-12);
        CHECK(at[1] >= before && at[4] / at[3] <= slope + 1e-12);
        before = at[1];
        slope = at[4] / at[3];
        if (i == 0)
            CHECK_NEAR(slope, 1.2, 1e-11);
        if (i == 20)
            CHECK_NEAR(at[1], 1.6, 1e-11);
        if (i == 70)
            CHECK(at[1] <= 3.1 + 1e-12);
    }
    batten_design_free(design);
}

TEST(least_squares_of_a_curve_takes_directions_points_and_weights)
{
    batten_design *design = NULL;
    CHECK_OK(
        evaluate("{least-squares: s, points: 5, pass: [[3, 0, 3]], start-direction: [1, 0, 0], "
                 "end-direction: z, weights: [1, 1, 1, 1, 0, 1]}",
                 NULL, &design));
    const batten_object *made = made_of(design);
    double at[6];
    CHECK_OK(batten_curve_evaluate(made->curve, made->parameters[3], 0, at));
    CHECK_NEAR(at[0], 3, 1e-11);
    CHECK_NEAR(at[1], 0, 1e-11);
    CHECK_NEAR(at[2], 3, 1e-11);
    CHECK_OK(batten_curve_evaluate(made->curve, made->parameters[0], 1, at));
    CHECK(at[3] > 0);
    CHECK_NEAR(at[4], 0, 1e-11);
    CHECK_NEAR(at[5], 0, 1e-11);
    batten_design_free(design);
}

TEST(a_robust_fit_lists_its_outliers)
{
    static const char *const words[] = {"huber", "absolute", "tukey"};
    for (int i = 0; i < 3; i++) {
        char text[160];
        snprintf(text, sizeof text, "{least-squares: far, points: 4, as: function, robust: %s}",
                 words[i]);
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        CHECK_OK(batten_notes_create(100, &notes));
        CHECK_OK(evaluate(text, notes, &design));
        /* A note that finds no memory is only counted. */
        bool said = batten_notes_dropped(notes) > 0;
        for (int k = 0; k < batten_notes_count(notes); k++)
            said =
                said || strstr(batten_notes_at(notes, k)->text, "times the median distance: 4");
        CHECK(said);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}

TEST(least_squares_says_what_cannot_be_met)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{least-squares: p, shape: convex}", "'shape' is for functions: add 'as: function'"},
        {"{least-squares: p, side: over}", "'side' is for functions"},
        {"{least-squares: p, over: [[1, 1]]}", "'over' is for functions"},
        {"{least-squares: p, as: function, shape: decreasing}", "the shape between"},
        {"{least-squares: p, as: function, pass: [[9, 1]]}", "outside 0 .. 7"},
        {"{least-squares: p, pass: [[9, 1]]}", "point 1 of 'pass' is not one of the points"},
        {"{least-squares: p, as: function, start-direction: [-1, 0]}", "must go forward"},
        {"{least-squares: s, closed: yes, start-direction: [-1, 0]}", "has no ends"},
        {"{least-squares: p, within: 0}", "'within' is 0"},
        {"{least-squares: p, within: 1 mm, points: 4}", "within 0.001 of point"},
        {"{least-squares: p, weights: [1, 2]}", "'weights' has 2 numbers for 8 points"},
        {"{least-squares: p, weights: -1}", "the weight of point 1 is -1"},
        {"{least-squares: p, as: function, over: [[3, 2]], under: [[3, 1]]}",
         "cannot hold together with the others"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, NULL, &design);
        if (test_memory_failed(status, BATTEN_BAD_ARGUMENT))
            status = evaluate(rows[i].feature, NULL, &design);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i].says);
    }
}
