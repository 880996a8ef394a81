#include "design/expect.h"

/* Curves and surfaces end to end, as given or in any order. */

/* A square of side 2 in pieces, one of them an arc's polygon of its own; and what does not meet it. */
static const char loose[] =
    "  a1: {line: [[0, 0], [2, 0]]}\n"
    "  a2: {line: [[2, 2], [2, 0.001]]}\n"
    "  a3: {line: [[0, 2], [0, 0]]}\n"
    "  a4: {line: [[0, 2], [2, 2]]}\n"
    "  out: {line: [[5, 5], [6, 5]]}\n"
    "  ring: {circle: 1}\n"
    "  spur: {line: [[2, 2], [3, 3]]}\n"
    /* Ends 0.002 apart at x = 4, and ends that branch. */
    "  left: {line: [[1, 3, 2], [4, 3, 2]]}\n  right: {line: [[4.002, 3, 2], [7, 3, 2]]}\n"
    "  up: {line: [[7, 3.001, 2], [7, 5, 2]]}\n  also: {line: [[4, 3, 2], [4, 8, 2]]}\n"
    "  ducks: {points: [[0, 0], [1, 2], [3, 0]]}\n  arcs: {arc-spline: ducks, ends: circular}\n"
    "  halves: {split: arcs, parameter: 1}\n  first: {select: halves, names: arcs 1}\n  second: {select: halves, names: arcs 2}\n  back: {reverse: second}\n  on: {line: [[3, 0], [4, 0]]}\n"
    "  north: {move: sheet, by: [0, 1, 0]}\n  pole: {move: sheet, by: [0, 2, 0]}\n"
    "  east: {move: sheet, by: [1.0005, 0, 0]}\n"
    "  sheet: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}\n";

TEST(loose_curves_are_joined_in_any_order_and_direction)
{
    static const expect_row rows[] = {
        {"{join: [a1, a2, a3, a4], order: any, within: 0.01}", BATTEN_OK,
         "objects 1;named a;within 1e-2;length 8;closed 1;notes largest gap closed is 0.001"},
        {"{join: [a3, a2, a1], order: any, within: 0.01}", BATTEN_OK,
         "objects 1;within 1e-2;length 6;closed 0;at 0 0 2 0;at 1 2 2 0"},
        {"{join: [a1, a3, a2, a4], order: any, within: 1e-6}", BATTEN_OK,
         "objects 1;closed 0;length 7.999;notes gap closed is 0"},
        {"{join: [out, a2, a4, ring], order: any}", BATTEN_OK,
         "objects 3;length 1;object 1;length 3.999;object 2;closed 1;notes 4 curves join to 3, 1 of them closed"},
        {"{join: [a4, a2, spur], order: any}", BATTEN_OK,
         "notes 3 ends have more than one other within"},
        {"{join: [a1, a3]}", BATTEN_NOT_COMPATIBLE, ""},
        {"{join: [sheet], order: any}", BATTEN_OK, "objects 1"},
    };
    EXPECT(loose, rows);
}

static const expect_row of_gaps[] = {
    {"{join: [left, right], order: any, within: 0.01}", BATTEN_OK,
     "objects 1;named a;at 0 1 3 2;at 1 7 3 2;length 6;notes 2 curves join to 1, 0 of them closed;"
     "notes 1 gap is closed, both ends moved to the middle; notes the largest gap closed is 0.002, "
     "at (4.001, 3, 2)"},
    {"{join: [right, up, left], order: any, within: 0.01}", BATTEN_OK,
     "objects 1;notes 2 gaps are closed;notes gap closed is 0.002, at (4.001, 3, 2)"},
    {"{join: left, order: any}", BATTEN_OK,
     "objects 1;length 3;notes 1 curve joins to 1, 0 of them closed;notes all ends that meet agree; "
     "notes the largest gap closed is 0"},
    {"{join: [left, out], order: any}", BATTEN_OK,
     "objects 2;named a 1;length 3;object 1;named a 2;length 1;notes 2 curves join to 2"},
    {"{join: [left, right, also], order: any, within: 0.01}", BATTEN_OK,
     "objects 2;notes more than one other within 0.01; notes the smallest gaps are closed first"},
    /* Within half of the tolerance of the design nothing meets here. */
    {"{join: [left, right], order: any}", BATTEN_OK, "objects 2"},
    {"{join: [left, right], within: 0.01}", BATTEN_OK, "objects 1;silent"},
    {"{join: [left, right]}", BATTEN_NOT_COMPATIBLE, ""},
};

TEST(gaps_are_closed_in_the_middle_counted_and_placed)
{
    EXPECT(loose, of_gaps);
}

static const expect_row of_chains[] = {
    {"{join: arcs}", BATTEN_OK, "spans 2"},
    {"{join: [first, second]}", BATTEN_OK, "spans 3;at 0 0 0 0;at 1 3 0 0"},
    /* One that runs the other way is turned. */
    {"{join: [first, back], order: any}", BATTEN_OK, "objects 1;spans 3"},
    {"{join: [back, first], order: any}", BATTEN_OK, "objects 1;spans 3"},
    {"{join: [first, back]}", BATTEN_NOT_COMPATIBLE, ""},
    /* A line is none, so the whole is none. */
    {"{join: [arcs, on], order: any}", BATTEN_OK, "objects 1;spans 0"},
    {"{join: [on, arcs], order: any}", BATTEN_OK, "objects 1;spans 0"},
    {"{join: [arcs, on]}", BATTEN_OK, "spans 0;at 0 0 0 0;at 1 4 0 0"},
};

TEST(chains_stay_chains_when_all_of_them_are)
{
    EXPECT(loose, of_chains);
}

static const expect_row of_surfaces[] = {
    {"{join: [sheet, north, pole], direction: v}", BATTEN_OK,
     "objects 1;named a;area 3;box 0 0 0 1 3 0"},
    {"{join: [sheet, east], within: 0.001}", BATTEN_OK, "objects 1;within 1e-3;area 2"},
    {"{join: [sheet, east], within: 0.0001}", BATTEN_NOT_COMPATIBLE, ""},
    {"{join: sheet, direction: v}", BATTEN_OK, "area 1"},
    {"{join: [sheet, north, a1], direction: v}", BATTEN_NOT_COMPATIBLE,
     "curves and surfaces cannot be joined: 'sheet', 'a1'"},
};

TEST(surfaces_are_joined_one_after_another)
{
    EXPECT(loose, of_surfaces);
}
