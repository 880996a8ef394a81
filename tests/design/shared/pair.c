#include "design/expect.h"

/* Pairs of curves: from which end of the first to which end of the second a feature goes. */

static const char lines[] = "  f: {line: [[0, 0], [4, 0]]}\n"
                            "  g: {line: [[9, 3], [9, 7]]}\n"
                            "  h: {line: [[4, 0], [4, 3]]}\n"
                            "  both: {collect: [f, g, h]}\n"
                            /* Of the parameters -4 to 0. */
                            "  ends: {points: [[-4, 0], [-1, 0], [0, 0]]}\n"
                            "  before: {minimax: ends, degree: 1}\n"
                            "  up: {line: [[0, 0], [0, 3]]}\n";

TEST(a_pair_goes_between_the_ends_that_are_named)
{
    static const expect_row rows[] = {
        {"{blend: [f, g], first: G0, second: G0}", BATTEN_OK, "at 0 4 0 0;at 1 9 3 0"},
        {"{blend: [f, g], first: G0, second: G0, ends: nearest}", BATTEN_OK,
         "at 0 4 0 0;at 1 9 3 0"},
        {"{blend: [f, g], first: G0, second: G0, ends: end-start}", BATTEN_OK,
         "at 0 4 0 0;at 1 9 3 0"},
        {"{blend: [f, g], first: G0, second: G0, ends: end-end}", BATTEN_OK,
         "at 0 4 0 0;at 1 9 7 0"},
        {"{blend: [f, g], first: G0, second: G0, ends: start-start}", BATTEN_OK,
         "at 0 0 0 0;at 1 9 3 0"},
        {"{blend: [f, g], first: G0, second: G0, ends: start-end}", BATTEN_OK,
         "at 0 0 0 0;at 1 9 7 0"},
        {"{blend: [g, f], first: G0, second: G0}", BATTEN_OK, "at 0 9 3 0;at 1 4 0 0"},
        /* The whole: the far end of the first, the blend, the far end of the second. */
        {"{blend: [f, g], first: G0, second: G0, whole: yes}", BATTEN_OK,
         "at 0 0 0 0;at 1 9 7 0;within 1e-8;length 13.8309518948453"},
        {"{blend: [f, g], first: G0, second: G0, whole: yes, ends: start-end}", BATTEN_OK,
         "at 0 4 0 0;at 1 9 3 0;within 1e-8;length 19.40175425099138"},
        {"{blend: both}", BATTEN_NOT_COMPATIBLE, "two curves are needed, there are 3"},
        {"{blend: f}", BATTEN_NOT_COMPATIBLE, "two curves are needed, there are 1"},
        /* All of the first curve goes into the arc, and nothing of it is left to join. */
        {"{fillet: [f, h], radius: 3}", BATTEN_OK,
         "within 1e-6;at 0 0 0 0;at 1 4 3 0;length 5.71238898038469"},
        {"{chamfer: [before, up], by: [4, 3]}", BATTEN_OK,
         "within 1e-6;length 5;at 0 -4 0 0;at 1 0 3 0"},
        {"{chamfer: [f, h], by: [2, 3]}", BATTEN_OK,
         "within 1e-6;length 5.605551275463989;at 0 0 0 0;at 1 4 3 0"},
        {"{chamfer: [f, h], by: [4, 1]}", BATTEN_OK,
         "within 1e-6;length 6.123105625617661;at 0 0 0 0;at 1 4 3 0"},
        {"{chamfer: [f, h], by: [4, 3]}", BATTEN_OK,
         "within 1e-6;length 5;at 0 0 0 0;at 1 4 3 0"},
    };
    EXPECT(lines, rows);
}
