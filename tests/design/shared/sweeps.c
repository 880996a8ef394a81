#include "design/expect.h"

/* Sweeps along a straight spine: what the laws for scale and twist do to a circle and a line. */

static const char shapes[] = "  ring: {circle: 1}\n"
                             "  bar: {line: [[0, 0], [1, 0]]}\n"
                             "  raised: {line: [[0, 0, 0], [1, 0, 0.5]]}\n"
                             "  spine: {line: [[0, 0, 0], [0, 0, 6]]}\n"
                             "  round: {circle: 3}\n"
                             "  bend: {polyline: [[0, 0, 0], [4, 0, 0], [4, 3, 0]]}\n"
                             "  thin: {circle: 0.1}\n"
                             "  tight: {circle: 0.5}\n";

TEST(laws_hold_at_the_ends_and_between)
{
    static const expect_row rows[] = {
        {"{sweep: ring, path: spine}", BATTEN_OK,
         "objects 1;named a;within 1e-3;along 1 0 0 0 0 0 1;area 37.69911184307752;notes sections"},
        {"{sweep: ring, path: spine, scale: 2}", BATTEN_OK, "within 1e-3;along 2 0 0 0 0 0 1"},
        {"{sweep: ring, path: spine, scale: [2, 2, 2]}", BATTEN_OK,
         "within 1e-3;along 2 0 0 0 0 0 1"},
        /* A cone from radius 1 to 3 over a height of 6: pi (1 + 3) times the root of 40. */
        {"{sweep: ring, path: spine, scale: [1, 3]}", BATTEN_OK, "within 1e-2;area 79.4767179"},
        {"{sweep: bar, path: spine, twist: [0, 90 deg]}", BATTEN_OK, "error 0.001"},
        {"{sweep: raised, path: spine}", BATTEN_OK,
         "notes the section is a space curve in the moving frame: its z, from 0 to 0.5, is taken along the spine"},
        {"{sweep: thin, path: round, frames: closing}", BATTEN_OK,
         "within 1e-3;area 11.8435252813"},
        {"{sweep: thin, path: bend, corners: split}", BATTEN_OK,
         "objects 2;named a 1;object 1;named a 2"},
        {"{sweep: thin, path: bend, corners: mitre}", BATTEN_OK, "error 0.001"},
        {"{sweep: thin, path: bend}", BATTEN_NOT_COMPATIBLE,
         "the spine has a corner of 90 degrees at 4: ask for a mitre, or split it there"},
        {"{sweep: ring, path: tight}", BATTEN_NOT_COMPATIBLE,
         "the sections run into each other"},
        {"{sweep: ring, path: tight, folds: yes}", BATTEN_OK,
         "notes the sections run into each other around"},
    };
    EXPECT(shapes, rows);
}

/* A cone of radius 1 and height 3: pi times the root of 10. */
TEST(one_point_is_a_section_at_an_end_alone)
{
    static const char ends[] = "  ring: {circle: 1}\n"
                               "  tip: {points: [[0, 0, 3]]}\n"
                               "  two: {points: [[0, 0, 3], [1, 0, 3]]}\n"
                               "  low: {line: [[0, 0, 0], [2, 0, 0]]}\n"
                               "  back: {line: [[2, 0, 1], [0, 0, 1]]}\n"
                               "  top: {line: [[0, 0, 2], [2, 0, 2]]}\n";
    static const expect_row rows[] = {
        {"{skin: [ring, tip]}", BATTEN_OK, "within 1e-6;area 9.934588265796101"},
        {"{skin: [tip, ring]}", BATTEN_OK, "within 1e-6;area 9.934588265796101"},
        {"{skin: [ring, two]}", BATTEN_BAD_ARGUMENT,
         "'two' is 2 points: one point may be the first or the last section; 'interpolate' makes "
         "a curve through several"},
        {"{skin: [ring, tip, ring]}", BATTEN_BAD_ARGUMENT,
         "'tip' is 1 point: one point may be the first or the last section"},
        {"{skin: [low, back, top]}", BATTEN_OK,
         "area 4;notes 1 section was reversed, the first of them section 2"},
        {"{skin: [low, top]}", BATTEN_OK, "area 4;lacks reversed"},
    };
    EXPECT(ends, rows);
}
