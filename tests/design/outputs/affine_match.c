#include "design/expect.h"

/* The output 'affine-match': matrices, parameters and distances, for people and with all digits. */

static const char curves[] =
    "  net: {points: [[0, 0], [1, 2], [3, -2], [4, 0.5], [5, 3]]}\n"
    "  wave: {b-spline: net}\n"
    "  big: {scale: wave, by: [2, 3, 1]}\n"
    "  moved: {move: big, by: [5, -7, 0]}\n"
    "  lifted: {move: wave, by: [0, 0, 2]}\n"
    "  back: {reverse: wave}\n"
    "  bent: {points: [[0, 0], [1, 2], [3, -2], [4, 0.5], [5, 4]]}\n"
    "  other: {b-spline: bent}\n"
    "  four: {points: [[0, 0], [1, 2], [3, -2], [4, 0.5]]}\n"
    "  cubic: {bezier: four}\n"
    "  half: {part: cubic, from: 0.25, to: 0.75}\n"
    "  twisted: {points: [[0, 0, 0], [1, 2, 0], [3, -2, 1], [4, 0.5, 2]]}\n"
    "  screw: {bezier: twisted}\n"
    "  wide: {scale: screw, by: [2, 3, 4]}\n"
    "  tip: {rotate: screw, by: 90 deg, axis: [0, 1, 0]}\n"
    "  ring: {circle: 1}\n";

TEST(maps_of_the_plane_have_two_rows_and_all_others_three)
{
    static const expect_row rows[] = {
        {"a.txt: {affine-match: [wave, moved]}", BATTEN_OK,
         "moved: an affine image of wave, to |e-1|\n  x' = 2 x |e-16 y + 5\n  y' = |x + 3 y - "
         "7\n  parameter of wave = 1 v + 0\n|!z' =|!another part"},
        {"a.txt: {affine-match: [wave, lifted]}", BATTEN_OK,
         "\n  x' = 1 x |\n  y' = | 1 y |\n  z' = | x | y + 1 z + 2\n  parameter of wave"},
        {"a.txt: {affine-match: [wave, back]}", BATTEN_OK,
         "\n  parameter of wave = -1 v + |!z' ="},
        {"a.txt: {affine-match: [screw, wide]}", BATTEN_OK,
         "\n  x' = 2 x | y |\n  y' = | + 3 y |\n  z' = | + 4 z |\n  parameter of screw = 1 v "},
        {"a.txt: {affine-match: [screw, tip]}", BATTEN_OK,
         "\n  x' = | + 1 z |\n  y' = | + 1 y |\n  z' = -1 x |\n  parameter of screw = 1 v "},
        {"a.txt: {affine-match: [cubic, half]}", BATTEN_OK,
         "half: an affine image of cubic, to |, of another part of the same curve\n  x' = 1 x "
         "|\n  y' = | + 1 y |\n  parameter of cubic = 1 v "},
    };
    EXPECT_OUTPUTS(curves, rows);
}

/* The nearest one is named where there is one to name. */
TEST(curves_that_are_no_images_have_a_distance_or_none)
{
    static const expect_row rows[] = {
        {"a.txt: {affine-match: [wave, other, screw]}", BATTEN_OK,
         "other: not an affine image of wave; the nearest found is 0.249 away\nscrew: not an "
         "affine image of wave\n|!x' |!parameter"},
        {"a.json: {affine-match: [wave, other, screw]}", BATTEN_OK,
         "{\n  \"matches\": [\n    {\"from\": \"wave\", \"to\": \"other\", \"found\": false, "
         "\"error\": 0.24934761303|},\n    {\"from\": \"wave\", \"to\": \"screw\", \"found\": "
         "false, \"error\": null}\n  ]\n}\n|!map|!whole"},
        {"a.txt: {affine-match: [wave, other], within: 0.5}", BATTEN_OK,
         "other: an affine image of wave, to 0.249\n  x' = "},
        {"a.txt: {affine-match: [wave, other], within: 0.24}", BATTEN_OK,
         "other: not an affine image of wave; the nearest found is 0.249 away\n"},
    };
    EXPECT_OUTPUTS(curves, rows);
}

TEST(matches_in_json_have_all_digits)
{
    static const expect_row rows[] = {
        {"a.json: {affine-match: [wave, moved, back]}", BATTEN_OK,
         "\"found\": true, \"error\": |, \"whole\": false, \"map\": [[2|, 0], [0, |, 0], [0, 0, "
         "|]], \"offset\": [|, -7, 0], \"c\": 1, \"f\": 0},\n    {\"from\": \"wave\", \"to\": "
         "\"back\", |, \"c\": -1, \"f\": |}\n  ]\n}\n"},
        {"a.json: {affine-match: [cubic, half]}", BATTEN_OK, "\"found\": true|\"whole\": true"},
        {"a: {affine-match: [wave, back]}", BATTEN_OK, "back: an affine image of wave"},
    };
    EXPECT_OUTPUTS(curves, rows);
}

TEST(what_cannot_be_compared_is_named_with_its_partner)
{
    static const expect_row rows[] = {
        {"a.txt: {affine-match: [wave, ring]}", BATTEN_UNSUPPORTED, "wave and ring: "},
        {"a.txt: {affine-match: wave}", BATTEN_BAD_ARGUMENT,
         "'affine-match' compares two curves or more, not 1"},
        {"a.txt: {affine-match: [wave, net]}", BATTEN_BAD_ARGUMENT,
         "'affine-match' takes curves, and 'net' is points"},
    };
    EXPECT_OUTPUTS(curves, rows);
}
