#include "design/expect.h"

/* The circle nearest to points: of four at 4 and 6 from the origin in turn, each method has its own radius. */

static const char data[] = "  four: {points: [[4, 0], [0, 6], [-4, 0], [0, -6]]}\n"
                           "  arc: {points: [[5, 0, 7], [3, 4, 7], [0, 5, 7], [-3, 4, 7]]}\n"
                           "  ring: {points: [[6, 2, 3], [4, 2, 7], [1, 2, 8], [-2, 2, 7]]}\n"
                           "  flat: {points: [[0, 0], [1, 0], [2, 0], [3, 0]]}\n"
                           "  pair: {points: [[0, 0], [1, 1]]}\n";

static const expect_row rows[] = {
    /* The mean; the root of the mean square, 26; the fourth root of the mean fourth power, 776. */
    {"{fit-circle: four}", BATTEN_OK,
     "closed 1;domain 0 1;distance 5 0 0 0;error 1.0000001;notes a circle of radius 5 about ["},
    {"{fit-circle: four, by: kasa}", BATTEN_OK, "distance 5.0990195135927845 0 0 0"},
    {"{fit-circle: four, by: taubin}", BATTEN_OK, "distance 5.0990195135927845 0 0 0"},
    {"{fit-circle: four, by: pratt}", BATTEN_OK, "distance 5.277951928008461 0 0 0"},
    {"{fit-circle: arc, whole: no}", BATTEN_OK,
     "closed 0;distance 5 0 0 7;at 0 5 0 7;at 1 -3 4 7"},
    {"{fit-circle: arc}", BATTEN_OK, "closed 1;distance 5 0 0 7;length 31.41592653589793"},
    {"{fit-circle: ring}", BATTEN_OK, "distance 5 1 2 3;on 0 1 0 2;notes [1, 2, 3]"},
    {"{fit-circle: flat}", BATTEN_SINGULAR_SYSTEM, "lie on a line"},
    {"{fit-circle: pair}", BATTEN_TOO_FEW_POINTS, "no row has 3 points"},
};

TEST(circles_are_those_of_their_method_and_end_beside_their_points)
{
    EXPECT(data, rows);
}
