#include "design/expect.h"

/* Operators without equations, and polynomials of least largest error, as a user writes them. */

static const char data[] =
    "  p: {points: [[0, 0], [1, 1], [2, 1.5], [3, 0], [5, 1]]}\n"
    "  q: {points: [[0, 7, 0], [1, 7, 1], [2, 7, 4], [3, 7, 9], [5, 7, 25]]}\n"
    "  s: {points: [[0, 0, 1], [1, 1, 0], [2, 1, 1], [3, 0, 3], [5, 1, 2]]}\n"
    "  twice: {points: [[0, 0], [1, 1], [1, 1], [3, 0]]}\n";

static const expect_row rows[] = {
    {"{schoenberg: p}", BATTEN_OK, "reached"},
    {"{schoenberg: s, degree: 2, closed: yes}", BATTEN_OK, "reached;closed 1;degree 2"},
    {"{schoenberg: q, as: function, degree: 4, knots: none}", BATTEN_OK,
     "reached;degree 4;count 5"},
    {"{quasi-interpolant: p, as: function}", BATTEN_OK, "reached"},
    {"{quasi-interpolant: s, closed: yes, parameters: centripetal}", BATTEN_OK,
     "reached;closed 1"},
    {"{quasi-interpolant: q, degree: 2}", BATTEN_OK, "reached;degree 2"},
    {"{minimax: p}", BATTEN_OK, "reached"},
    {"{minimax: q, degree: 1}", BATTEN_OK, "reached;degree 1"},
    /* The parabola z = x^2 at y = 7. */
    {"{quasi-interpolant: q, as: function, degree: 2}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25"},
    {"{quasi-interpolant: q, as: function}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25"},
    {"{minimax: q, degree: 2}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25;error 1e-9"},
    {"{minimax: q}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25;error 1e-9"},
    {"{schoenberg: p, degree: 26}", BATTEN_BAD_DEGREE, "the degree is 26"},
    {"{schoenberg: twice}", BATTEN_COINCIDENT, "twice: points 2 and 3 coincide"},
    {"{schoenberg: s, as: function}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
    {"{schoenberg: s, closed: yes, knots: none}", BATTEN_BAD_ARGUMENT,
     "makes no closed curves"},
    {"{schoenberg: p, as: function, closed: yes}", BATTEN_BAD_ARGUMENT,
     "a function cannot be closed"},
    {"{quasi-interpolant: p, degree: 10}", BATTEN_BAD_DEGREE,
     "the degree is 10; it must be in 1..9"},
    {"{quasi-interpolant: p, as: function, closed: yes}", BATTEN_BAD_ARGUMENT,
     "a function cannot be closed"},
    {"{minimax: p, degree: 4}", BATTEN_TOO_FEW_POINTS, "5 points"},
    {"{minimax: twice, degree: 1}", BATTEN_NOT_INCREASING, "rising abscissae"},
};

TEST(operators_reproduce_what_they_promise_and_tell_how_far_they_are)
{
    EXPECT(data, rows);
}
