#include "design/expect.h"

/* Plates laid flat: lengths and areas of cylinders, cones and planes are kept. */

static const char plates[] =
    "  can: {cylinder: 1, height: 4}\n"
    "  cap: {cone: 3, height: 4}\n"
    "  frustum: {cone: 3, top: 1.5, height: 2}\n"
    "  net: {points: [[0, 0, 0], [2, 0, 0], [0, 1, 0], [2, 1, 0]], columns: 2}\n"
    "  plank: {bezier-surface: net}\n"
    "  seam: {line: [[1, 0, 0], [1, 0, 4]]}\n  both: {collect: [plank, plank]}\n"
    "  hoop: {arc: 1, at: [0, 0, 2], start: 90 deg, angle: 180 deg}\n"
    "  off: {circle: 2, at: [0, 0, 2]}\n"
    "  wedge: {bilinear: [[0, 0, 0], [2, 0, 0], [0, 1, 0], [0, 1, 0]]}\n"
    "  twisted: {bilinear: [[0, 0, 0], [2, 0, 0], [2, 1, 1], [0, 1, 0]]}\n"
    "  slant: {line: [[0.5, 0.25], [1.5, 0.75]]}\n"
    "  rim: {arc: 0.5, at: [1, 0], angle: 180 deg}\n"
    "  above: {line: [[0.5, 0.25, 0.1], [1.5, 0.75, 0.1]]}\n";

static const expect_row lengths[] = {
    {"{unroll: can, lines: 0, within: 0.0001}", BATTEN_OK,
     "objects 1;layer cut;closed 1;within 1e-3;length 20.566370614359172;on 0 0 1 0"},
    {"{unroll: can, within: 0.0001}", BATTEN_OK,
     "objects 13;object 1;layer rulings;within 1e-3;length 4;object 12;length 4"},
    {"{unroll: can, lines: 0, marks: seam, within: 0.0001}", BATTEN_OK,
     "objects 2;object 1;layer marks;within 1e-3;length 4"},
    {"{unroll: can, lines: 0, marks: [hoop, seam], within: 0.0001}", BATTEN_OK,
     "objects 3;object 1;layer marks;within 1e-3;length 3.141592653589793;object 2;length 4"},
    /* A sector of radius 5 whose arc is the rim of the cone. */
    {"{unroll: cap, lines: 0, within: 0.0001}", BATTEN_OK,
     "within 1e-3;length 28.84955592153876;closed 1"},
    {"{unroll: frustum, lines: 1, within: 0.0001}", BATTEN_OK,
     "objects 2;within 1e-3;length 33.274333882308136;object 1;length 2.5"},
    {"{unroll: plank, lines: 0}", BATTEN_OK, "within 1e-9;length 6"},
    {"{unroll: plank, lines: 2, rulings: u}", BATTEN_OK, "objects 3;object 1;length 2"},
    {"{unroll: plank, lines: 2, rulings: v}", BATTEN_OK, "objects 3;object 1;length 1"},

    /* Edges and area stay as they are: a plank of 2 x 1. */
    {"{unroll: plank, lines: 0, rulings: v}", BATTEN_OK,
     "notes edges 2 and 2 long, flat 2 and 2; notes area 2, flat 2; notes turned by 0 degrees; "
     "notes strain at most 0.00e+00"},
    {"{unroll: plank, lines: 1000}", BATTEN_OK, "objects 1001"},
    {"{unroll: plank, lines: 1, rulings: v}", BATTEN_OK,
     "objects 2;object 1;layer rulings;length 1;at 0.5 1 0.5 0"},
    {"{unroll: can, lines: 0, within: 0.0001}", BATTEN_OK, "notes turned by 0 degrees"},
    {"{unroll: can, lines: 0, strain: 1e-3}", BATTEN_OK, "objects 1"},
    {"{unroll: both}", BATTEN_BAD_ARGUMENT, "one surface is unrolled at a time, not 2"},
    {"{unroll: plank, lines: 1001}", BATTEN_BAD_ARGUMENT, "there may be 0 to 1000"},
    {"{unroll: [can, cap]}", BATTEN_BAD_FORMAT, "unroll"},
    {"{unroll: can, marks: off}", BATTEN_NOT_COMPATIBLE, "from the surface at its parameter"},
    {"{unroll: can, strain: -1}", BATTEN_NOT_COMPATIBLE, "more than -1"},
    /* A triangle with the sides 1, 2 and sqrt 5, whose rulings shrink towards its tip. */
    {"{unroll: wedge, lines: 2, rulings: u}", BATTEN_OK,
     "objects 3;closed 1;length 5.23606797749979;object 1;length 1.3333333333333333;object "
     "2;length 0.6666666666666666"},
    {"{unroll: plank, marks: plank}", BATTEN_BAD_ARGUMENT,
     "curves are needed, and 'plank' has none"},
    {"{unroll: plank, marks: above}", BATTEN_NOT_COMPATIBLE,
     "a mark is 0.1 from the surface at its parameter 0"},
};

TEST(unrolled_plates_have_their_lengths)
{
    EXPECT(plates, lengths);
}

static const expect_row layers[] = {
    {"{unroll: plank, lines: 3, rulings: v, marks: [slant, rim]}", BATTEN_OK,
     "objects 6;named a;layer cut;colour 0 0 0;closed 1;box 0 0 0 2 1 0;"
     "object 1;layer rulings;colour 0.6 0.6 0.6;on 1 0 0 0.5;length 1;"
     "object 2;layer rulings;on 1 0 0 1;object 3;on 1 0 0 1.5;length 1;"
     "object 4;named slant;layer marks;colour 0 0 1;at 0 0.5 0.25 0;at 1 1.5 0.75 0;length "
     "1.118033988749895;"
     "object 5;named rim;layer marks;colour 0 0 1;within 1e-3;distance 0.5 1 0 0;at 0 1.5 0 0;at 1 "
     "0.5 0 0;error 1e-3"},
    {"{unroll: plank, lines: 0, rulings: v, marks: rim, within: 1e-5}", BATTEN_OK,
     "object 1;within 1e-5;distance 0.5 1 0 0;error 1e-5"},
    {"{unroll: plank, lines: 3, rulings: u}", BATTEN_OK, "object 1;length 2;object 3;length 2"},
};

TEST(outline_rulings_and_marks_have_layers_and_colours_of_their_own)
{
    EXPECT(plates, layers);
}

/* The rim of a cone is 6 pi, its side 5, its area 15 pi: a sector of 6 pi / 5 = 216 degrees. */
static const expect_row notes[] = {
    {"{unroll: cap, lines: 0}", BATTEN_OK,
     "notes edges 18.849556 and 0 long, flat 18.849556 and 0; notes area 47.12389, flat 47.12389; "
     "notes turned by 216 degrees; notes at (; notes rulings straight within"},
    {"{unroll: frustum, lines: 0}", BATTEN_OK,
     "notes edges 18.849556 and 9.424778 long, flat 18.849556 and 9.424778; notes area 35.342917, "
     "flat 35.342917; notes turned by 216 degrees"},
    {"{unroll: can, lines: 0}", BATTEN_OK,
     "notes edges 6.2831853 and 6.2831853 long; notes area 25.132741, flat 25.132741; notes turned "
     "by 0 degrees"},
    {"{unroll: twisted, strain: 0.5}", BATTEN_OK,
     "notes edges 2 and 2.236068 long, flat 1.9; notes area 2.36"},
    {"{unroll: twisted, strain: 0.01}", BATTEN_NOT_COMPATIBLE,
     "laid flat the sheet undergoes a strain of 0.02"},
    {"{unroll: plank, strain: 0}", BATTEN_OK, "objects 13"},
};

TEST(lengths_areas_and_strains_are_told_in_space_and_flat)
{
    EXPECT(plates, notes);
}
