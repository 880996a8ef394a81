#include "design/expect.h"

/* Least squares with lines, whose sums are made by hand: of (0, 0), (1, 1), (2, 0), (3, 2) the line is y = x / 2. */

static const char data[] =
    "  p: {points: [[0, 0], [1, 1], [2, 0], [3, 2]]}\n"
    "  ring: {points: [[5, 0], [4, 3], [0, 5], [-4, 3], [-5, 0], [-4, -3], [0, -5], [4, -3]]}\n";

#define LINE "{least-squares: p, as: function, degree: 1, points: 2"
#define FREE LINE ", hold-ends: no"

static const expect_row rows[] = {
    {FREE "}", BATTEN_OK,
     "degree 1;count 2;domain 0 3;at 0 0 0 0;at 1 3 1.5 0;error 1.0000001;reached"},
    {LINE "}", BATTEN_OK, "at 0 0 0 0;at 1 3 2 0"},
    {FREE ", weights: [0, 1, 1, 0]}", BATTEN_OK, "domain 0 3;at 0 0 2 0;at 1 3 -1 0"},
    {FREE ", weights: [3]}", BATTEN_OK, "at 0 0 0 0;at 1 3 1.5 0"},
    /* Through (0, 3): m is -11 / 14. */
    {FREE ", pass: [[0, 3]]}", BATTEN_OK, "within 1e-7;at 0 0 3 0;at 1 3 0.6428571428571429 0"},
    /* Above all it rests on points 2 and 4, below all on point 3. */
    {FREE ", side: over}", BATTEN_OK, "within 1e-7;at 0 0 0.5 0;at 1 3 2 0"},
    {FREE ", side: under}", BATTEN_OK,
     "within 1e-7;at 0 0 -0.3333333333333333 0;at 1 3 0.16666666666666666 0"},
    {FREE ", side: both}", BATTEN_OK, "at 0 0 0 0;at 1 3 1.5 0"},
    {FREE ", over: [[0, 1]]}", BATTEN_OK, "within 1e-7;at 0 0 1 0;at 1 3 1.2142857142857142 0"},
    {FREE ", over: [[0, -1]]}", BATTEN_OK, "within 1e-7;at 0 0 0 0;at 1 3 1.5 0"},
    {FREE ", under: [[3, 1]]}", BATTEN_OK,
     "within 1e-7;at 0 0 0.14285714285714285 0;at 1 3 1 0"},
    {FREE ", shape: decreasing}", BATTEN_OK, "within 1e-7;at 0 0 0.75 0;at 1 3 0.75 0"},
    {FREE ", shape: increasing}", BATTEN_OK, "within 1e-7;at 0 0 0 0;at 1 3 1.5 0"},
    /* No line is within less than 3/4 of all, the band of points 2, 3 and 4. */
    {FREE ", within: 0.9}", BATTEN_OK, "within 1e-7;error 0.9000001"},
    {FREE ", within: 0.2}", BATTEN_NOT_COMPATIBLE, "must be within 0.2 of point 2 cannot hold"},
    {"{least-squares: p, degree: 26}", BATTEN_BAD_DEGREE, "p: "},
    {"{least-squares: ring, closed: yes, corrections: 0}", BATTEN_OK, "closed 1;reached"},
    {"{least-squares: p, points: 4, corrections: 0}", BATTEN_OK,
     "count 4;degree 3;passes;error 1e-9"},
};

TEST(lines_of_least_squares_are_those_of_the_sums_and_of_their_conditions)
{
    EXPECT(data, rows);
}
