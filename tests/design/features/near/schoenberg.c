#include "design/expect.h"

/* Variation diminishing splines: straight lines stay, parabolas rise by what Bernstein adds, and what is refused. */

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
    {"{schoenberg: p, degree: 26}", BATTEN_BAD_DEGREE, "the degree is 26"},
    {"{schoenberg: twice}", BATTEN_COINCIDENT, "twice: points 2 and 3 coincide"},
    {"{schoenberg: s, as: function}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
    {"{schoenberg: s, closed: yes, knots: none}", BATTEN_BAD_ARGUMENT,
     "makes no closed curves"},
    {"{schoenberg: p, as: function, closed: yes}", BATTEN_BAD_ARGUMENT,
     "a function cannot be closed"},
    {"{schoenberg: p, degree: 0}", BATTEN_BAD_DEGREE, "the degree is 0"},
    {"{schoenberg: p, as: function, degree: 1}", BATTEN_OK,
     "degree 1;domain 0 5;at 0.2 1 1 0;at 0.5 2.5 0.75 0;error 1e-12;reached"},
    /* At the knots of a cubic over 0, 1, 2, 3, 5 no more than its ends are kept. */
    {"{schoenberg: p, as: function}", BATTEN_OK, "degree 3;domain 0 5;at 0 0 0 0;at 1 5 1 0"},
    /* Bernstein's polynomial of degree n raises x^2 by x (5 - x) / n. */
    {"{schoenberg: q, as: function, degree: 5, knots: none}", BATTEN_OK,
     "degree 5;count 6;on 0 1 0 7;at 0 0 7 0;at 1 5 7 25"},
};

TEST(splines_of_schoenberg_keep_lines_and_tell_how_far_they_are)
{
    EXPECT(data, rows);
}
