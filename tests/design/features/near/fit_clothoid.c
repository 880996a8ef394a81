#include "design/expect.h"

/* The clothoid nearest to points: of an arc, of a spiral run either way, of a line, in a plane of space. */

static const char data[] =
    "  round: {points: [[5, 0], [4, 3], [3, 4], [0, 5], [-3, 4], [-4, 3]]}\n"
    "  back: {points: [[-4, 3], [-3, 4], [0, 5], [3, 4], [4, 3], [5, 0]]}\n"
    "  tilted: {points: [[7, 5, 0], [7, 4, 3], [7, 3, 4], [7, 0, 5]]}\n"
    "  straight: {points: [[0, 1], [3, 5], [6, 9], [9, 13]]}\n"
    /* Of curvature 0.5 + s, s from 0 to 2. */
    "  spiral: {points: [[0, 0], [0.4901704417553, 0.082435272261], [0.8767747088654, "
    "0.3865463465889], [0.9512358084283, 0.864967309909], [0.5965461533162, 1.1794458901472]]}\n"
    "  inwards: {points: [[0.5965461533162, 1.1794458901472], [0.9512358084283, 0.864967309909], "
    "[0.8767747088654, 0.3865463465889], [0.4901704417553, 0.082435272261], [0, 0]]}\n"
    "  three: {points: [[0, 0], [1, 0], [2, 1]]}\n"
    "  one: {points: [[1, 2], [1, 2], [1, 2], [1, 2]]}\n"
    "  skew: {points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 1], [0, 2, 3]]}\n";

static const expect_row rows[] = {
    {"{fit-clothoid: round}", BATTEN_OK,
     "spans 1;closed 0;within 1e-6;domain 0 12.490457723982544;distance 5 0 0 0;at 0 5 0 0;at 1 -4 3 0;"
     "bends 0 0.2;bends 1 0.2;notes 'round': a clothoid of length 12.490457;error 1e-6"},
    {"{fit-clothoid: back}", BATTEN_OK,
     "within 1e-6;at 0 -4 3 0;at 1 5 0 0;distance 5 0 0 0;notes curvature -0."},
    {"{fit-clothoid: tilted}", BATTEN_OK, "within 1e-6;spans 1;on 1 0 0 7;distance 5 7 0 0"},
    {"{fit-clothoid: straight}", BATTEN_OK,
     "within 1e-6;domain 0 15;at 0 0 1 0;at 0.5 4.5 7 0;at 1 9 13 0;error 1e-6"},
    {"{fit-clothoid: spiral}", BATTEN_OK,
     "within 1e-6;domain 0 2;bends 0 0.5;bends 1 2.5;notes length 2, curvature 0.5 to 2.5"},
    {"{fit-clothoid: inwards}", BATTEN_OK,
     "within 1e-6;domain 0 2;notes length 2, curvature -2.5 to -0.5"},
    {"{fit-clothoid: three}", BATTEN_TOO_FEW_POINTS, "no row has 4 points"},
    {"{fit-clothoid: one}", BATTEN_COINCIDENT, "coincide"},
    {"{fit-clothoid: skew}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
};

TEST(a_fitted_clothoid_has_the_length_and_the_curvatures_of_its_points)
{
    EXPECT(data, rows);
}
