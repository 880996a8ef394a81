/* Surfaces of nets with derivatives on their rim, and the patch through sixteen points. */
#include "design/expect.h"

/* z = x^2 y over a grid of four by four. */
static const char grid[] =
    "  net:\n    points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0],\n"
    "             [0, 1, 0], [1, 1, 1], [2, 1, 4], [3, 1, 9],\n"
    "             [0, 2, 0], [1, 2, 2], [2, 2, 8], [3, 2, 18],\n"
    "             [0, 3, 0], [1, 3, 3], [2, 3, 12], [3, 3, 27]]\n"
    "    columns: 4\n"
    "  short: {points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]], columns: 3}\n";

TEST(a_patch_passes_sixteen_points)
{
    static const expect_row rows[] = {
        {"{sixteen-points: net}", BATTEN_OK,
         "within 1e-12;at 0.5 0.5 1.5 1.5 3.375;at 0.1 0.9 0.3 2.7 0.243"},
        {"{sixteen-points: short}", BATTEN_BAD_ARGUMENT, "4 rows of 4 points, not 2 of 3"},
    };
    EXPECT(grid, rows);
}

#define RIM_U                                                                              \
    "du: [[3, 0, 0], [3, 0, 0], [3, 0, 0], [3, 0, 0], [3, 0, 0], [3, 0, 18], [3, 0, 36], " \
    "[3, 0, 54]]"
#define RIM_V                                                                               \
    "dv: [[0, 3, 0], [0, 3, 3], [0, 3, 12], [0, 3, 27], [0, 3, 0], [0, 3, 3], [0, 3, 12], " \
    "[0, 3, 27]]"
#define NET "{interpolate-grid: net, parameters: uniform, knots: data, "

TEST(a_surface_through_a_grid_has_the_derivatives_given_on_its_rim)
{
    static const expect_row rows[] = {
        {NET RIM_U ", " RIM_V ", twists: [[0, 0, 0], [0, 0, 54], [0, 0, 54], [0, 0, 0]]}",
         BATTEN_OK, "within 1e-11;at 0.5 0.5 1.5 1.5 3.375;at 0.1 0.9 0.3 2.7 0.243"},
        {NET RIM_U ", " RIM_V "}", BATTEN_OK, "within 1e-11;at 0.1 0.9 0.3 2.7 0.243"},
        {NET "du: [[3, 0, 0]]}", BATTEN_BAD_ARGUMENT, "'du' has 1 vector, not 8"},
        {NET RIM_U ", twists: [[1, 0, 0], [1, 0, 0], [1, 0, 0], [1, 0, 0]]}",
         BATTEN_BAD_ARGUMENT, "'twists' need both 'du' and 'dv'"},
        {NET RIM_U ", " RIM_V ", twists: [[1, 0, 0]]}", BATTEN_BAD_ARGUMENT,
         "'twists' has 1 vector, not 4"},
    };
    EXPECT(grid, rows);
}

TEST(places_of_a_surface_are_pulled_where_they_are_wanted)
{
    static const char patch[] =
        "  net:\n    points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [0, 1, 0], [1, 1, 1],\n"
        "             [2, 1, 4], [3, 1, 9], [0, 2, 0], [1, 2, 2], [2, 2, 8], [3, 2, 18],\n"
        "             [0, 3, 0], [1, 3, 3], [2, 3, 12], [3, 3, 27]]\n    columns: 4\n"
        "  hood: {sixteen-points: net}\n  rim: {line: [[0, 0, 0], [1, 0, 0]]}\n";
    static const expect_row rows[] = {
        {"{pull: hood, at: [[0.5, 0.5]], by: [[0, 0, 2]]}", BATTEN_OK,
         "within 1e-12;at 0.5 0.5 1.5 1.5 5.375;notes control points move by up to"},
        {"{pull: hood, at: [[0.5, 0.5]], to: [[1, 1, 1]], keep: edges}", BATTEN_OK,
         "within 1e-12;at 0.5 0.5 1 1 1;at 0.5 0 1.5 0 0;at 1 0.5 3 1.5 13.5"},
        {"{pull: hood, at: [[0.2, 0.5], [0.8, 0.5]], by: [[0, 0, 1]]}", BATTEN_OK,
         "within 1e-12;at 0.2 0.5 0.6 1.5 1.54;at 0.8 0.5 2.4 1.5 9.64"},
        {"{pull: hood, at: [[0.5, 0.5]], by: [[0, 0, 1]], keep: tangent-planes}",
         BATTEN_BAD_ARGUMENT, "the control points that act there are kept"},
        {"{pull: hood, at: [[0.5, 0.5]]}", BATTEN_BAD_ARGUMENT, "either 'by' or 'to'"},
        {"{pull: hood, at: [[0.5, 0.5]], by: [[1, 0, 0], [0, 1, 0]]}", BATTEN_BAD_ARGUMENT,
         "'by' has 2 values for 1 place"},
        {"{pull: rim, at: [[0.5, 0.5]], by: [[1, 0, 0]]}", BATTEN_BAD_ARGUMENT, "'rim'"},
    };
    EXPECT(patch, rows);
}

/* Two points 1e-7 apart in the second row, and in the second column. */
static const char near_by[] =
    "  near: {points: [[0, 0], [1, 0], [2, 0], [0, 1], [1.9999999, 1], [2, 1], [0, 2], [1, 2], [2, 2]], columns: 3}\n"
    "  beside: {points: [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1], [0, 2], [1, 1.0000001], [2, 2]], columns: 3}\n"
    "  far: {points: [[1e11, 0], [100000000001, 0], [1e11, 1], [100000000001, 1]], columns: 2}\n"
    "  even: {points: [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2], [2, 2]], columns: 3}\n"
    "  row: {points: [[0, 0, 0], [1, 0, 0], [1.0000001, 0, 0]]}\n  other: {points: [[0, 0, 1], [1, 0, 1], [2, 0, 1]]}\n";

TEST(N2_grids_at_the_mercy_of_rounding_are_noted)
{
    static const expect_row rows[] = {
        {"{interpolate-grid: near, degree-u: 2, degree-v: 2}", BATTEN_OK,
         "notes points 2 and 3 of row 2 are 1e-07 apart, others of it up to 2"},
        {"{interpolate-grid: beside, degree-u: 2, degree-v: 2}", BATTEN_OK,
         "notes points 2 and 3 of column 2 are 1e-07 apart"},
        {"{interpolate-grid: far, degree-u: 1, degree-v: 1}", BATTEN_OK,
         "notes more than the tolerance 0.001"},
        {"{interpolate-grid: even, degree-u: 2, degree-v: 2}", BATTEN_OK, "silent"},
        {"{skin-rows: [row, other], degree-u: 1, degree-v: 1}", BATTEN_OK,
         "notes points 2 and 3 are 1e-07 apart"},
    };
    EXPECT(near_by, rows);
}
