#include "design/expect.h"

/* Polynomials of least largest error: those of their degree come back, and what is refused. */

static const char data[] =
    "  p: {points: [[0, 0], [1, 1], [2, 1.5], [3, 0], [5, 1]]}\n"
    "  q: {points: [[0, 7, 0], [1, 7, 1], [2, 7, 4], [3, 7, 9], [5, 7, 25]]}\n"
    "  s: {points: [[0, 0, 1], [1, 1, 0], [2, 1, 1], [3, 0, 3], [5, 1, 2]]}\n"
    "  twice: {points: [[0, 0], [1, 1], [1, 1], [3, 0]]}\n";

static const expect_row rows[] = {
    {"{minimax: p}", BATTEN_OK, "reached"},
    {"{minimax: q, degree: 1}", BATTEN_OK, "reached;degree 1"},
    {"{minimax: q, degree: 2}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25;error 1e-9"},
    {"{minimax: q}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25;error 1e-9"},
    {"{minimax: p, degree: 4}", BATTEN_TOO_FEW_POINTS, "5 points"},
    {"{minimax: twice, degree: 1}", BATTEN_NOT_INCREASING, "rising abscissae"},
    /* The best line to x^2 at 0, 1, 2, 3, 5: the slope of the chord, halfway to the lowest point below it, at 2. */
    {"{minimax: q, degree: 1}", BATTEN_OK,
     "domain 0 5;at 0 0 7 -3;at 1 5 7 22;error 3.0000001"},
    {"{minimax: p, degree: 26}", BATTEN_BAD_DEGREE, "26"},
    {"{minimax: s, degree: 1}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
};

TEST(minimax_polynomials_reproduce_their_degree_and_tell_their_error)
{
    EXPECT(data, rows);
}
