#include "design/evaluate.h"
#include "design/expect.h"

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

TEST(conditions_out_of_place_are_refused_by_their_whole_sentence)
{
    static const char ducks[] =
        "  ducks: {points: [[0, 0], [1, 1], [2, -1], [3, 1], [4, 0]]}\n";
    static const expect_row rows[] = {
        {"{least-squares: ducks, points: 4, start-direction: [1, 0], closed: yes}",
         BATTEN_BAD_ARGUMENT, "a closed curve has no ends: 'start-direction'"},
        {"{least-squares: ducks, points: 4, end-direction: [1, 0], closed: yes}",
         BATTEN_BAD_ARGUMENT, "a closed curve has no ends: 'end-direction'"},
        {"{least-squares: ducks, points: 4, pass: [[1, 1.5]]}", BATTEN_BAD_ARGUMENT,
         "point 1 of 'pass' is not one of the points: the nearest, point 2, is 0.5 away"},
        {"{least-squares: ducks, points: 4, pass: [[1, 1], [4.03, 0.04]]}", BATTEN_BAD_ARGUMENT,
         "point 2 of 'pass' is not one of the points: the nearest, point 5, is 0.05 away"},
        {"{least-squares: ducks, points: 4, pass: [[0, 0]]}", BATTEN_OK, "at 0 0 0 0"},
        {"{least-squares: ducks, points: 4, over: [[1, 1]]}", BATTEN_BAD_ARGUMENT,
         "'over' is for functions: add 'as: function'"},
        {"{least-squares: ducks, points: 4, under: [[1, 1]]}", BATTEN_BAD_ARGUMENT,
         "'under' is for functions: add 'as: function'"},
        {"{least-squares: ducks, points: 4, shape: convex}", BATTEN_BAD_ARGUMENT,
         "'shape' is for functions: add 'as: function'"},
        {"{least-squares: ducks, points: 4, side: over}", BATTEN_BAD_ARGUMENT,
         "'side' is for functions: add 'as: function'"},
        {"{least-squares: ducks, points: 4, within: 0}", BATTEN_BAD_ARGUMENT,
         "'within' is 0; it must be above 0"},
        {"{least-squares: ducks, points: 4, as: function, start-direction: [0, 1]}",
         BATTEN_BAD_ARGUMENT,
         "'start-direction' must go forward along the abscissa of the function"},
        {"{least-squares: ducks, points: 4, as: function, end-direction: [-1, 1]}",
         BATTEN_BAD_ARGUMENT,
         "'end-direction' must go forward along the abscissa of the function"},
        {"{least-squares: ducks, points: 4, as: function, start-direction: [2, 1], "
         "end-direction: [1, 3]}",
         BATTEN_OK, "heads 0 0.8944271909999159 0.447213595499958 0;heads 1 0.3162277660168379 0.9486832980505138 0"},
        {"{least-squares: ducks, points: 4, start-direction: [0, 1], end-direction: [1, 1]}",
         BATTEN_OK, "heads 0 0 1 0;heads 1 0.7071067811865476 0.7071067811865476 0"},
    };
    EXPECT(ducks, rows);
}
