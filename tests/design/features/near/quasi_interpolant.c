#include "design/expect.h"

/* Splines of full order near points: polynomials of their degree come back, and what is refused. */

static const char data[] =
    "  p: {points: [[0, 0], [1, 1], [2, 1.5], [3, 0], [5, 1]]}\n"
    "  q: {points: [[0, 7, 0], [1, 7, 1], [2, 7, 4], [3, 7, 9], [5, 7, 25]]}\n"
    "  s: {points: [[0, 0, 1], [1, 1, 0], [2, 1, 1], [3, 0, 3], [5, 1, 2]]}\n"
    "  twice: {points: [[0, 0], [1, 1], [1, 1], [3, 0]]}\n";

static const expect_row rows[] = {
    {"{quasi-interpolant: p, as: function}", BATTEN_OK, "reached"},
    {"{quasi-interpolant: s, closed: yes, parameters: centripetal}", BATTEN_OK,
     "reached;closed 1"},
    {"{quasi-interpolant: q, degree: 2}", BATTEN_OK, "reached;degree 2"},
    {"{quasi-interpolant: q, as: function, degree: 2}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25"},
    {"{quasi-interpolant: q, as: function}", BATTEN_OK,
     "domain 0 5;on 0 1 0 7;at 0.1 0.5 7 0.25;at 0.5 2.5 7 6.25;at 0.9 4.5 7 20.25"},
    {"{quasi-interpolant: p, degree: 10}", BATTEN_BAD_DEGREE,
     "the degree is 10; it must be in 1..9"},
    {"{quasi-interpolant: p, as: function, closed: yes}", BATTEN_BAD_ARGUMENT,
     "a function cannot be closed"},
    {"{quasi-interpolant: p, degree: 0}", BATTEN_BAD_DEGREE,
     "the degree is 0; it must be in 1..9"},
    {"{quasi-interpolant: twice}", BATTEN_COINCIDENT, "twice: points 2 and 3 coincide"},
    {"{quasi-interpolant: s, as: function}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
    {"{quasi-interpolant: p}", BATTEN_OK, "degree 3;closed 0;reached"},
};

TEST(quasi_interpolants_reproduce_their_degree_and_tell_how_far_they_are)
{
    EXPECT(data, rows);
}
