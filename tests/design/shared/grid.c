#include "design/expect.h"

/* Rows of points as a grid, and contours by their field. */

static const char rows_of_points[] =
    "  net: {points: [[0, 0, 0], [1, 0, 5], [2, 0, 0], [0, 3, 0], [1, 3, 0], [2, 3, 7]], columns: 3}\n"
    "  first: {points: [[0, 0], [1, 0], [2, 0]]}\n"
    "  second: {points: [[0, 3], [1, 3], [2, 3]]}\n"
    "  short: {points: [[0, 0], [1, 0]]}\n"
    "  lone: {points: [[0, 0]]}\n"
    "  line: {line: [[0, 0], [1, 0]]}\n"
    "  tilt: {bilinear: [[0, 0, 0], [4, 0, 0], [4, 3, 4], [0, 3, 4]]}\n"
    "  ball: {sphere: 2}\n"
    "  uneven: {points: [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [1.0000001, 1], [0, 2], [1, 2], [2, 2]], columns: 3}\n"
    "  turned: {points: [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2], [2, 0], [1.0000001, 1], [2, 2]], columns: 3}\n";

TEST(u_runs_along_the_rows_and_v_across_them)
{
    static const expect_row rows[] = {
        {"{bezier-surface: net}", BATTEN_OK,
         "degree 2 1;at 1 0 2 0 0;at 0 1 0 3 0;at 1 1 2 3 7;control 0 0 0 0;control 1 0 3 0;control 2 1 0 5;control 5 2 3 7"},
        {"{b-spline-surface: [first, second], degree-u: 2, degree-v: 1}", BATTEN_OK,
         "area 6;at 1 0 2 0 0"},
        {"{b-spline-surface: [second, first], degree-u: 2, degree-v: 1}", BATTEN_OK,
         "at 0 0 0 3 0;at 0 1 0 0 0"},
        {"{b-spline-surface: [first, short]}", BATTEN_NOT_COMPATIBLE,
         "'short' has 2 points, and the first row has 3"},
        {"{b-spline-surface: [short, first]}", BATTEN_NOT_COMPATIBLE,
         "'first' has 3 points, and the first row has 2"},
        {"{b-spline-surface: [first, lone]}", BATTEN_NOT_COMPATIBLE,
         "'lone' has 1 point, and the first row has 3"},
        {"{b-spline-surface: line}", BATTEN_BAD_ARGUMENT, "line"},
        {"{bezier-surface: net}", BATTEN_OK, "silent"},
        {"{bezier-surface: uneven}", BATTEN_OK,
         "notes 'bezier-surface': points 2 and 3 of row 2 are 1e-07 apart, others of it up to 1;lacks column"},
        {"{bezier-surface: turned}", BATTEN_OK,
         "notes 'bezier-surface': points 2 and 3 of column 2 are 1e-07 apart, others of it up to 1;lacks row"},
    };
    EXPECT(rows_of_points, rows);
}

TEST(contours_are_those_of_their_field)
{
    static const expect_row rows[] = {
        {"{contours: tilt, levels: [2]}", BATTEN_OK, "on 0 0 1 2"},
        {"{contours: tilt, levels: [1.5], direction: y}", BATTEN_OK, "on 0 1 0 1.5;length 4"},
        {"{contours: tilt, levels: [1], direction: x}", BATTEN_OK, "on 1 0 0 1;length 5"},
        {"{contours: tilt, of: gaussian}", BATTEN_NOT_FOUND,
         "the field is 0 everywhere: it has no levels"},
        {"{contours: ball, levels: [0], direction: [1, 1, 0]}", BATTEN_OK,
         "within 0.01;on 1 1 0 0;distance 2 0 0 0"},
    };
    EXPECT(rows_of_points, rows);
}
