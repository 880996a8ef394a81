#include "design/expect.h"

/* Curves within a bound of points, and splines within a bound of curves. */

static const char data[] =
    "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0, 2], [4, 1, 2], [4, 2, 2]]}\n"
    "  q: {points: [[0, 0, 2], [1, 0.5, 1], [2, 0.3, 2], [3, 1, 2], [4, 0, 0]]}\n"
    "  f: {points: [[0, 1, 0], [1, 1, 0], [2, 1, 0.1], [3, 1, 2], [4, 1, 2]]}\n"
    "  one: {points: [[1, 1], [1, 1], [1, 1]]}\n"
    "  few: {points: [[1, 1]]}\n"
    "  c: {circle: 1}\n  s: {euler-spiral: p}\n  i: {interpolate: p}\n";

static const expect_row within[] = {
    {"{fit-within: p, within: 10 cm}", BATTEN_OK, "reached;error 0.1"},
    {"{fit-within: p, within: 1 cm, corner: 60 deg}", BATTEN_OK, "reached;error 0.01"},
    {"{fit-within: p, within: 1 cm, corners: [5], by: bezier}", BATTEN_OK,
     "reached;error 0.01"},
    {"{fit-within: q, within: 30 cm, by: remove, degree: 2}", BATTEN_OK, "reached;error 0.3"},
    {"{fit-within: q, within: 10 cm, closed: yes, by: insert}", BATTEN_OK,
     "reached;closed 1;error 0.1"},
    {"{fit-within: f, within: 20 cm, as: function}", BATTEN_OK, "reached;error 0.2"},
    {"{fit-within: p, within: 0}", BATTEN_BAD_ARGUMENT, "it must be above 0"},
    {"{fit-within: p, within: -1}", BATTEN_BAD_ARGUMENT, "it must be above 0"},
    {"{fit-within: few, within: 1}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
    {"{fit-within: one, within: 1 cm}", BATTEN_COINCIDENT, "same parameter"},
    {"{fit-within: p, within: 1 cm, corners: [8]}", BATTEN_BAD_ARGUMENT, "corner 1 is point 8"},
    {"{fit-within: p, within: 1 cm, degree: 5, by: bezier}", BATTEN_BAD_ARGUMENT, "cubics"},
    {"{fit-within: p, within: 1 cm, as: function}", BATTEN_NOT_INCREASING, "rising abscissae"},
};

TEST(curves_within_a_bound_pass_their_points_and_tell_how_far)
{
    EXPECT(data, within);
}

static const expect_row near_curves[] = {
    {"{approximate: c, within: 1 mm}", BATTEN_OK,
     "rational 0;degree 3;spans 0;error 0.001;within 0.001;distance 1 0 0 0;closed 1"},
    {"{approximate: s, within: 1 mm, degree: 5}", BATTEN_OK,
     "rational 0;degree 5;spans 0;error 0.001;within 0.001;passes"},
    {"{approximate: i, within: 5 cm}", BATTEN_OK,
     "rational 0;degree 3;spans 0;error 0.05;within 0.05;passes"},
    {"{approximate: c, within: 0}", BATTEN_BAD_ARGUMENT, "c: "},
    {"{approximate: p, within: 1}", BATTEN_BAD_ARGUMENT, "curves are needed"},
};

TEST(approximations_keep_parameters_and_tell_their_bound)
{
    EXPECT(data, near_curves);
}
