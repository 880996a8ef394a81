#include "design/evaluate.h"
#include "design/expect.h"

#include <math.h>

/* The line nearest to points: distances at right angles to it, feet from 0 to 1 between the outermost. */

static const char data[] =
    "  straight: {points: [[0, 0, 1], [1, 2, 3], [2, 4, 5], [4, 8, 9]]}\n"
    "  bent: {points: [[0, 1], [10, -2], [20, 1]]}\n"
    "  upright: {points: [[1, 7, 0], [-2, 7, 10], [1, 7, 20]]}\n"
    "  beyond: {points: [[1, 2], [-3, 2], [5, 2], [9, 2], [3, 2]]}\n"
    "  square: {points: [[0, 0], [1, 0], [1, 1], [0, 1]]}\n"
    "  one: {points: [[1, 2], [1, 2], [1, 2]]}\n"
    "  lone: {points: [[1, 2]]}\n";

static const expect_row rows[] = {
    {"{fit-line: straight}", BATTEN_OK,
     "degree 1;count 2;at 0 0 0 1;at 1 4 8 9;passes;reached;error 1e-14"},
    /* Distances 1, 2 and 1 on either side of the x-axis, which no turn makes less. */
    {"{fit-line: bent}", BATTEN_OK, "at 0 0 0 0;at 1 20 0 0;reached;error 2.0000001"},
    {"{fit-line: upright}", BATTEN_OK, "at 0 0 7 0;at 1 0 7 20;reached;error 2.0000001"},
    {"{fit-line: beyond}", BATTEN_OK, "at 0 -3 2 0;at 1 9 2 0"},
    {"{fit-line: square}", BATTEN_SINGULAR_SYSTEM, "spread alike"},
    {"{fit-line: one}", BATTEN_COINCIDENT, "coincide"},
    {"{fit-line: lone}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
};

TEST(a_fitted_line_runs_between_the_outermost_feet_of_its_points)
{
    EXPECT(data, rows);
}

static void check_feet(const char *points, int count, const double *feet)
{
    char text[1500];
    batten_design *design = NULL;
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s  a: {fit-line: %s}\n", data, points);
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    const batten_object *object =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK_INT(object->point_count, count);
    for (int i = 0; i < count; i++)
        CHECK_NEAR(object->parameters[i], feet[i], 1e-14);
    batten_design_free(design);
}

TEST(the_feet_of_points_on_a_fitted_line_are_its_parameters)
{
    check_feet("straight", 4, (const double[]){0, 0.25, 0.5, 1});
    check_feet("bent", 3, (const double[]){0, 0.5, 1});
    check_feet("beyond", 5, (const double[]){1 / 3.0, 0, 2 / 3.0, 1, 0.5});
}

/* In directions of no round numbers. */
TEST(no_foot_on_a_fitted_line_is_outside_of_it)
{
    for (int i = 1; i <= 30; i++) {
        char text[300];
        batten_design *design = NULL;
        snprintf(
            text, sizeof text,
            "batten: 1\nfeatures:\n  p: {points: [[0.1, %g, 0.3], [%g, 0.7, %g], [%g, 1.1, "
            "7.3]]}\n  a: {fit-line: p}\n",
            0.17 * i, 1.3 + 0.01 * i, 2.3 - 0.013 * i, 3.1 + 0.019 * i);
        CHECK_OK(evaluate_design(text, "a", NULL, &design));
        const double *at =
            batten_model_object(batten_design_result(design, "a")->value, 0)->parameters;
        CHECK(at[0] >= 0 && at[0] < 1e-14 && at[2] <= 1 && at[2] > 1 - 1e-14);
        batten_design_free(design);
    }
}
