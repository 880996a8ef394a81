#include "design/expect.h"

/* Patches between boundary curves, in any direction and in any number on a side. */

static const char curves[] = "  s: {line: [[0, 0], [4, 0]]}\n"
                             "  e: {line: [[4, 0], [4, 3]]}\n"
                             "  n: {line: [[4, 3], [0, 3]]}\n"
                             "  w: {line: [[0, 3], [0, 0]]}\n"
                             "  back: {line: [[0, 3], [4, 3]]}\n"
                             "  e1: {line: [[4, 0], [4, 1]]}\n"
                             "  e2: {line: [[4, 1], [4, 3]]}\n"
                             "  gap: {line: [[0, 3], [0, 0.5]]}\n"
                             "  beside: {bilinear: [[0, 0], [4, 0], [4, -2], [0, -2]]}\n"
                             "  ds: {line: [[0, 3, 0], [0, 3, 6]]}\n"
                             "  dn: {line: [[0, -3, 4], [0, -3, 8]]}\n"
                             "  far: {bilinear: [[0, 10], [4, 10], [4, 12], [0, 12]]}\n";

TEST(sides_of_a_patch_may_run_either_way_and_have_parts)
{
    static const expect_row rows[] = {
        {"{coons: [s, e, n, w]}", BATTEN_OK, "area 12;on 0 0 1 0;box 0 0 0 4 3 0"},
        {"{coons: [s, e, back, w]}", BATTEN_OK,
         "area 12;notes 'back' runs against the first curve and is reversed"},
        {"{coons: [s, e1, e2, n, w], sides: [1, 2, 1, 1]}", BATTEN_OK, "area 12;on 0 0 1 0"},
        {"{coons: [s, e, n, w], sides: [1, 1, 1, 1]}", BATTEN_OK, "area 12"},
        {"{coons: [s, e1, e2, n, w]}", BATTEN_BAD_ARGUMENT, "the number on each side is given"},
        {"{coons: [s, e, n, w], sides: [1, 1, 2]}", BATTEN_BAD_ARGUMENT,
         "'sides' has 3 counts, not 4"},
        {"{coons: [s, e, n, gap]}", BATTEN_NOT_COMPATIBLE, "is open by 0.5"},
        {"{coons: [s, e, n, w], kind: second, along: beside}", BATTEN_OK,
         "area 12;on 0 0 1 0;notes side 1 lies along 'beside'"},
        {"{coons: [s, e, n, w], kind: second, along: far}", BATTEN_NOT_FOUND,
         "'far' has no edge along a side of the patch within"},
        {"{coons: [s, e, n, w], kind: first, along: beside}", BATTEN_BAD_ARGUMENT,
         "a patch of the first kind takes no slopes from 'along'"},
    };
    EXPECT(curves, rows);
}

TEST(slopes_stand_for_the_curve_of_their_place_and_run_as_it_does)
{
    static const expect_row rows[] = {
        {"{coons: [s, e, n, w], kind: second, slopes: [ds, de, dn, dw, ds]}",
         BATTEN_BAD_ARGUMENT, "there are 5 'slopes' for 4 curves"},
        {"{coons: [s, e, n, w], kind: first, slopes: [ds]}", BATTEN_BAD_ARGUMENT,
         "a patch of the first kind takes no 'slopes'"},
        {"{coons: [s, e1, e2, n, w], sides: [1, 2, 1, 1], kind: second, slopes: [ds, ds]}",
         BATTEN_BAD_ARGUMENT,
         "'ds' is the slope of curve 2, which shares its side with others: join them first"},
    };
    static const char more[] = "  de: {line: [[-4, 0], [-4, 0, 1]]}\n"
                               "  dw: {line: [[4, 0], [4, 0, 1]]}\n";
    char before[2000];
    snprintf(before, sizeof before, "%s%s", curves, more);
    EXPECT(before, rows);
}

/* Splines with a corner in the middle, and with corners at a third and two thirds; that of the first faces none. */
TEST(corners_within_a_side_are_remarked_upon_and_noted_where_they_face_each_other)
{
    static const char sides[] =
        "  one: {points: [[0, 0], [0, 0], [0, 0], [1, 0.5], [1, 0.5], [1, 0.5], [2, 0], [2, 0], "
        "[2, 0]]}\n"
        "  two: {points: [[0, 2], [0, 2], [0, 2], [0.5, 2.5], [0.5, 2.5], [0.5, 2.5], [1.5, 2.5], "
        "[1.5, 2.5], [1.5, 2.5], [2, 2], [2, 2], [2, 2]]}\n"
        "  s: {b-spline: one, ends: free}\n  n: {b-spline: two, ends: free}\n"
        "  above: {move: s, by: [0, 2, 0]}\n"
        "  w: {line: [[0, 0], [0, 2]]}\n  e: {line: [[2, 0], [2, 2]]}\n";
    static const expect_row rows[] = {
        {"{coons: [s, e, n, w], blend: coons}", BATTEN_OK,
         "notes side 1 stands still at 0.5 of its parameter;notes side 3 stands still at "
         "0.3333;notes side 3 stands still at 0.6667;lacks face each other"},
        {"{coons: [s, e, above, w], blend: coons}", BATTEN_OK,
         "notes the corners of sides 1 and 3 at 0.5 of their parameters face each other"},
        {"{coons: [w, s, e, above], blend: coons}", BATTEN_OK,
         "notes the corners of sides 2 and 4 at 0.5 of their parameters face each other"},
    };
    EXPECT(sides, rows);
}
