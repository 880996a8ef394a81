#include "design/expect.h"

/* Features that change curves: what they make of lines, polygons and circles follows from geometry. */

static const char shapes[] = "  one: {line: [[0, 0], [4, 0]]}\n"
                             "  two: {line: [[4, 0], [4, 3]]}\n"
                             "  far: {line: [[9, 9], [9, 8]]}\n"
                             "  corner: {polyline: [[0, 0], [4, 0], [4, 3]]}\n"
                             "  square: {polyline: [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]}\n"
                             "  open: {polyline: [[0, 0], [4, 0], [4, 4], [0, 4]]}\n"
                             "  both: {collect: [one, ring3]}\n"
                             "  ring: {circle: 2}\n"
                             "  ring3: {circle: 2, at: [0, 0, 3]}\n"
                             "  ducks: {points: [[0, 0], [1, 2], [3, 0]]}\n"
                             "  bow: {bezier: ducks}\n"
                             "  through: {interpolate: ducks}\n"
                             "  lines: {collect: [one, two]}\n"
                             "  net: {points: [[0, 0], [1, 0], [0, 1], [1, 1]], columns: 2}\n"
                             "  sheet: {bezier-surface: net}\n"
                             "  shifted: {move: sheet, by: [1, 0]}\n"
                             "  above: {move: sheet, by: [0, 1]}\n"
                             "  ball: {sphere: 1}\n"
                             "  drops: {points: [[0, 0], [1, 0], [0, 1]]}\n"
                             "  three: {bezier-triangle: drops}\n"
                             "  arcs: {arc-spline: ducks, ends: circular}\n"
                             "  s: {points: [[0, 0], [1, 1], [2, -1], [3, 0]]}\n"
                             "  wave: {bezier: s}\n";

TEST(moved_turned_scaled_and_mirrored_curves_are_where_the_map_puts_them)
{
    static const expect_row rows[] = {
        {"{move: one, by: [1, 2, 3]}", BATTEN_OK,
         "objects 1;named a;at 0 1 2 3;at 1 5 2 3;exact"},
        {"{move: lines, by: [0, 0, 1]}", BATTEN_OK,
         "objects 2;named one;on 0 0 1 1;object 1;on 0 0 1 1"},
        {"{mirror: two}", BATTEN_OK,
         "objects 2;named two;at 1 4 3 0;object 1;named two mirrored;at 1 4 -3 0"},
        {"{mirror: two, plane: y, keep: no}", BATTEN_OK, "objects 1;at 1 4 -3 0;at 0 4 0 0"},
        {"{mirror: two, plane: x, keep: no}", BATTEN_OK, "objects 1;at 1 -4 3 0"},
        {"{mirror: ring3, plane: z, at: 1, keep: no}", BATTEN_OK, "on 0 0 1 -1"},
        {"{mirror: two, plane: x, at: 1, keep: no}", BATTEN_OK, "at 1 -2 3 0"},
        /* In the diagonal plane x = y, then moved along its normal by the root of 2. */
        {"{mirror: two, normal: [3, -3, 0], keep: no}", BATTEN_OK, "at 0 0 4 0;at 1 3 4 0"},
        {"{mirror: two, normal: [3, -3, 0], at: 1.4142135623730951, keep: no}", BATTEN_OK,
         "at 0 2 2 0;at 1 5 2 0"},
        {"{mirror: two, normal: [0, 0, 0]}", BATTEN_BAD_ARGUMENT,
         "'normal' is 0 and has no direction"},
        {"{rotate: one, by: 90 deg}", BATTEN_OK, "at 0 0 0 0;at 1 0 4 0;exact"},
        {"{rotate: one, by: 90 deg, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT,
         "'axis' is 0 and has no direction"},
        {"{rotate: one, by: 90 deg, at: [4, 0, 1]}", BATTEN_OK, "at 0 4 -4 0;at 1 4 0 0"},
        {"{rotate: one, by: 90 deg, axis: [0, 2, 0]}", BATTEN_OK, "at 1 0 0 -4"},
        {"{scale: two, by: 2}", BATTEN_OK, "at 0 8 0 0;at 1 8 6 0;objects 1;named a"},
        {"{scale: two, by: [2, 3, 4], at: [1, 1, 1]}", BATTEN_OK, "at 0 7 -2 -3;at 1 7 7 -3"},
        {"{scale: two, by: [2, 3]}", BATTEN_BAD_ARGUMENT, "'by' has 1 or 3 factors, not 2"},
        {"{scale: two, by: [1, 0, 1]}", BATTEN_BAD_ARGUMENT,
         "a factor of 0 would leave nothing"},
        {"{scale: two, by: 0}", BATTEN_BAD_ARGUMENT, "a factor of 0 would leave nothing"},
        {"{reverse: sheet, direction: v}", BATTEN_OK, "at 0 0 0 1 0;at 1 0 1 1 0"},
        {"{reverse: sheet}", BATTEN_OK, "at 0 0 1 0 0;at 0 1 1 1 0"},
        {"{reverse: arcs}", BATTEN_OK, "spans 2;at 0 3 0 0"},
        {"{reverse: one}", BATTEN_OK, "at 0 4 0 0;at 1 0 0 0;length 4"},
        {"{reverse: through}", BATTEN_OK, "at 0 3 0 0"},
    };
    EXPECT(shapes, rows);
}

TEST(the_same_curve_is_kept_with_another_degree_or_knots)
{
    static const expect_row rows[] = {
        {"{elevate: bow}", BATTEN_OK, "degree 3;at 0.5 1.25 1 0;count 4;exact"},
        {"{elevate: through, by: 2}", BATTEN_OK, "degree 4;passes"},
        {"{elevate: sheet}", BATTEN_OK, "degree 2 1;at 0.5 0.5 0.5 0.5 0"},
        {"{elevate: sheet, direction: v, by: 3}", BATTEN_OK, "degree 1 4"},
        {"{elevate: three, by: 2}", BATTEN_OK, "degree 3;on 0 0 1 0"},
        {"{elevate: drops}", BATTEN_BAD_ARGUMENT, "drops"},
        {"{refine: bow, knots: [0.5]}", BATTEN_OK, "degree 2;count 4;at 0.5 1.25 1 0"},
        {"{refine: bow, knots: [0.25, 0.5, 0.5]}", BATTEN_OK, "count 6;at 0.5 1.25 1 0"},
        {"{refine: through, knots: [0.3]}", BATTEN_OK, "count 4;passes"},
        {"{refine: sheet, knots: [0.5]}", BATTEN_OK, "count 3 2"},
        {"{refine: sheet, knots: [0.5], direction: v}", BATTEN_OK, "count 2 3"},
        {"{refine: bow, knots: [7]}", BATTEN_OUT_OF_DOMAIN,
         "knot 1 to insert is 7, not in the domain"},
        {"{swap: sheet}", BATTEN_OK, "at 1 0 0 1 0;at 0 1 1 0 0"},
        {"{swap: bow}", BATTEN_BAD_ARGUMENT, "bow"},
    };
    EXPECT(shapes, rows);
}

TEST(curves_are_cut_at_parameters_and_in_pieces)
{
    static const expect_row rows[] = {
        {"{split: bow, parameter: 0.5}", BATTEN_OK,
         "objects 2;named bow 1;at 0 0 0 0;at 1 1.25 1 0;object 1;named bow 2;at 0 1.25 1 0;at 1 3 0 0"},
        {"{split: sheet, parameter: 0.25}", BATTEN_OK,
         "objects 2;named sheet 1;area 0.25;at 1 0 0.25 0 0;object 1;named sheet 2;area 0.75"},
        {"{split: sheet, parameter: 0.25, direction: v}", BATTEN_OK,
         "area 0.25;at 0 1 0 0.25 0"},
        {"{split: corner, pieces: spans}", BATTEN_OK,
         "objects 2;named corner 1;length 4;object 1;named corner 2;length 3"},
        {"{split: one, pieces: spans}", BATTEN_OK, "objects 1;named a;length 4"},
        {"{split: lines, pieces: spans}", BATTEN_OK, "objects 2;named one;object 1;named two"},
        {"{split: arcs, pieces: spans}", BATTEN_OK, "spans 1;joins 0 1 1 0"},
        {"{split: arcs, parameter: 1}", BATTEN_OK, "objects 2;joins 0 1 1 0"},
        /* The cubic with y control 0, 1, -1, 0 has its inflection in the middle. */
        {"{split: wave, pieces: convex}", BATTEN_OK, "objects 2;within 1e-6;at 1 1.5 0 0"},
        {"{split: wave, pieces: monotone, along: y}", BATTEN_OK, "objects 3"},
        {"{split: wave, pieces: spans, along: y}", BATTEN_BAD_ARGUMENT,
         "'along' is for monotone pieces"},
        {"{split: bow}", BATTEN_BAD_ARGUMENT, "either 'parameter' or 'pieces' must be given"},
        {"{split: bow, parameter: 0.5, pieces: spans}", BATTEN_BAD_ARGUMENT,
         "either 'parameter' or 'pieces' must be given"},
        {"{split: bow, parameter: 5}", BATTEN_OUT_OF_DOMAIN, "5"},
        {"{split: sheet, pieces: spans}", BATTEN_BAD_ARGUMENT, "sheet"},
    };
    EXPECT(shapes, rows);
}

TEST(curves_are_trimmed_by_parameters_lengths_points_and_planes)
{
    static const expect_row rows[] = {
        {"{trim: bow, between: [0.25, 0.5]}", BATTEN_OK, "at 0 0.5625 0.75 0;at 1 1.25 1 0"},
        {"{trim: corner, lengths: [1, 5]}", BATTEN_OK, "length 4;at 0 1 0 0;at 1 4 1 0"},
        {"{trim: corner, lengths: [1, -1]}", BATTEN_OK, "length 5;at 0 1 0 0;at 1 4 2 0"},
        {"{trim: corner, lengths: [-2, -1]}", BATTEN_OK, "length 1;at 0 4 1 0;at 1 4 2 0"},
        {"{trim: corner, points: [[1, -5], [9, 2]]}", BATTEN_OK,
         "within 1e-7;at 0 1 0 0;at 1 4 2 0"},
        {"{trim: one, points: [[1, 1], [3, -2]]}", BATTEN_OK,
         "within 1e-7;at 0 1 0 0;at 1 3 0 0"},
        {"{trim: one, plane: x, at: 1}", BATTEN_OK, "length 3;at 0 1 0 0;at 1 4 0 0;named a"},
        {"{trim: one, plane: x, at: 1, side: back}", BATTEN_OK,
         "length 1;at 0 0 0 0;at 1 1 0 0"},
        {"{trim: two, plane: y, at: 1}", BATTEN_OK, "length 2"},
        {"{trim: ring3, plane: z, at: 1}", BATTEN_OK, "within 1e-7;length 12.566370614359172"},
        {"{trim: ring3, plane: z, at: 4}", BATTEN_NOT_FOUND, "nothing is left"},
        {"{trim: both, plane: z, at: 1}", BATTEN_OK,
         "objects 1;within 1e-7;length 12.566370614359172;notes 'one' has nothing on that side"},
        {"{trim: one, normal: [2, 0, 0], at: 1}", BATTEN_OK, "length 3;silent"},
        {"{trim: one, normal: [-2, 0, 0], at: -1}", BATTEN_OK, "length 1"},
        /* The start of a closed curve is no end: what is left is one part. */
        {"{trim: square, plane: x, at: 1}", BATTEN_OK, "within 1e-7;length 10"},
        {"{trim: square, plane: x, at: 1, side: back}", BATTEN_OK,
         "objects 1;within 1e-7;length 6"},
        {"{trim: open, plane: x, at: 1, side: back}", BATTEN_OK,
         "objects 2;named open 1;within 1e-7;length 1;object 1;named open 2;length 1"},
        {"{trim: one, normal: [0, 0, 0]}", BATTEN_BAD_ARGUMENT, "'normal' is 0"},
        {"{trim: one}", BATTEN_BAD_ARGUMENT,
         "one of 'between', 'lengths', 'points' and a plane must be given"},
        {"{trim: one, plane: x, between: [0, 1]}", BATTEN_BAD_ARGUMENT, "one of 'between'"},
        {"{trim: one, lengths: [0, 1], between: [0, 1]}", BATTEN_BAD_ARGUMENT,
         "one of 'between'"},
        {"{trim: one, between: [0, 1, 2]}", BATTEN_BAD_ARGUMENT,
         "'between' must be two, there are 3"},
        {"{trim: one, lengths: [1]}", BATTEN_BAD_ARGUMENT,
         "'lengths' must be two, there are 1"},
        {"{trim: sheet, between: [0, 1]}", BATTEN_BAD_ARGUMENT, "sheet"},
    };
    EXPECT(shapes, rows);
}

TEST(curves_are_made_longer_at_either_end)
{
    static const expect_row rows[] = {
        {"{extend: one, end: 2}", BATTEN_OK,
         "length 6;at 0 0 0 0;at 1 6 0 0;notes the end joins with G"},
        {"{extend: one, start: 2}", BATTEN_OK,
         "length 6;at 0 -2 0 0;notes the start joins with G"},
        {"{extend: one, start: 1, end: 2, shape: line}", BATTEN_OK,
         "length 7;at 0 -1 0 0;at 1 6 0 0"},
        {"{extend: lines, end: 1}", BATTEN_OK,
         "objects 2;named one;length 5;object 1;named two;length 4"},
        {"{extend: bow, end: 1, shape: line}", BATTEN_OK,
         "heads 1 0.7071067811865476 -0.7071067811865476 0;at 1 3.7071067811865476 -0.7071067811865476 0"},
        {"{extend: bow, end: 1, shape: spiral}", BATTEN_OK, "notes the end joins with G"},
        /* The parabola continues as itself. */
        {"{extend: bow, to: 2, shape: natural}", BATTEN_OK, "at 1 8 -8 0;at 0 0 0 0"},
        {"{extend: bow, from: -1, shape: natural}", BATTEN_OK, "at 0 -1 -8 0;at 1 3 0 0"},
        {"{extend: one, start: 1, from: -1}", BATTEN_BAD_ARGUMENT,
         "'start' and 'from' set the same thing; give one of them"},
        {"{extend: one, end: 1, to: 2}", BATTEN_BAD_ARGUMENT,
         "'end' and 'to' set the same thing; give one of them"},
        {"{extend: one}", BATTEN_BAD_ARGUMENT, "'start', 'end', 'from' or 'to' must be given"},
        {"{extend: one, by: 1}", BATTEN_BAD_ARGUMENT,
         "'start', 'end', 'from' or 'to' must be given"},
        {"{extend: sheet, end: 1}", BATTEN_BAD_ARGUMENT,
         "'sheet' is a surface: 'by' and 'edges' must be given"},
        {"{extend: sheet, by: 1}", BATTEN_BAD_ARGUMENT, "'by' and 'edges' must be given"},
        {"{extend: sheet, edges: u1}", BATTEN_BAD_ARGUMENT, "'by' and 'edges' must be given"},
        {"{extend: one, end: -1}", BATTEN_BAD_ARGUMENT, "one: the end: "},
        {"{extend: one, start: -1}", BATTEN_BAD_ARGUMENT, "one: the start: "},
        {"{extend: sheet, by: 1, edges: u1}", BATTEN_OK,
         "area 2;box 0 0 0 2 1 0;notes u1 is longer by 1 to 1"},
        {"{extend: sheet, by: 1, edges: [v0, u0]}", BATTEN_OK, "area 4;box -1 -1 0 1 1 0"},
        {"{extend: sheet, by: 2, edges: v1}", BATTEN_OK, "area 3;box 0 0 0 1 3 0"},
        {"{extend: sheet, by: -1, edges: v1}", BATTEN_BAD_ARGUMENT, "sheet: v1: "},
    };
    EXPECT(shapes, rows);
}

TEST(corners_are_cut_off_or_rounded)
{
    static const expect_row rows[] = {
        /* Instead of 1 + 1 along the corner, the root of 2 across it. */
        {"{chamfer: corner, by: 1}", BATTEN_OK,
         "within 1e-7;length 6.414213562373095;at 0 0 0 0;at 1 4 3 0"},
        {"{chamfer: corner, by: [1, 2]}", BATTEN_OK, "within 1e-7;length 6.23606797749979"},
        {"{chamfer: corner, by: [2, 1]}", BATTEN_OK,
         "within 1e-7;length 6.23606797749979;box 0 0 0 4 3 0"},
        {"{chamfer: [one, two], by: [1, 2]}", BATTEN_OK,
         "objects 1;named a;within 1e-7;length 6.23606797749979;at 0 0 0 0;at 1 4 3 0"},
        {"{chamfer: [one, two, far], by: 1}", BATTEN_OK, "objects 3;notes 'one' has no corner"},
        {"{chamfer: lines, by: 1}", BATTEN_OK, "objects 2;notes 'two' has no corner"},
        {"{chamfer: corner, by: [1, 2, 3]}", BATTEN_BAD_ARGUMENT,
         "'by' has 3 lengths, at most 2 are used"},
        {"{chamfer: corner, by: 1, at: start}", BATTEN_BAD_FORMAT, ""},
        {"{chamfer: corner, by: -1}", BATTEN_BAD_ARGUMENT, "corner: "},
        {"{chamfer: ducks, by: 1}", BATTEN_BAD_ARGUMENT, "ducks"},
        /* A quarter of a circle of radius 1 instead of 1 + 1. */
        {"{fillet: corner, radius: 1}", BATTEN_OK,
         "within 1e-6;length 6.570796326794897;silent"},
        {"{fillet: open, radius: [1, 0]}", BATTEN_OK,
         "within 1e-6;length 11.570796326794897;at 1 0 4 0"},
        {"{fillet: corner, radius: [1, 2]}", BATTEN_BAD_ARGUMENT, "corner: "},
        {"{fillet: one, radius: 1}", BATTEN_OK, "length 4;notes has no corner"},
        {"{fillet: [one, two], radius: 1}", BATTEN_OK,
         "objects 1;within 1e-6;length 6.570796326794897;at 0 0 0 0;at 1 4 3 0;silent;error 1e-6"},
        {"{fillet: [one, two], radius: 1, whole: no}", BATTEN_OK,
         "objects 1;within 1e-6;length 1.5707963267948966;distance 1 3 1 0"},
        {"{fillet: [one, two], radius: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "two curves have one corner and one radius"},
        {"{fillet: [one, two, far], radius: 1}", BATTEN_OK, "objects 3"},
        {"{fillet: [one, ring3], radius: 1}", BATTEN_NOT_COMPATIBLE, "plane"},
    };
    EXPECT(shapes, rows);
}

TEST(offsets_keep_their_distance_on_the_side_that_is_asked_for)
{
    static const expect_row rows[] = {
        {"{offset: one, by: 1}", BATTEN_OK, "objects 1;on 0 1 0 1;length 4;named a"},
        {"{offset: one, by: 1, side: right}", BATTEN_OK, "objects 1;on 0 1 0 -1"},
        {"{offset: one, by: -1}", BATTEN_OK, "on 0 1 0 -1"},
        {"{offset: one, by: 1, side: both}", BATTEN_OK,
         "objects 2;on 0 1 0 1;object 1;on 0 1 0 -1"},
        {"{offset: one, by: 1, normal: y}", BATTEN_OK, "on 0 0 1 -1"},
        {"{offset: ring, by: 0.5}", BATTEN_OK, "within 1e-4;distance 1.5 0 0 0;error 1e-4"},
        {"{offset: ring, by: -0.5}", BATTEN_OK, "within 1e-4;distance 2.5 0 0 0"},
        {"{offset: ring, by: 3}", BATTEN_NOT_FOUND, "nothing is left"},
        {"{offset: both, by: 3}", BATTEN_OK, "objects 1;notes has nothing as far inside as 3"},
        {"{offset: corner, by: -1}", BATTEN_OK, "within 1e-4;length 8.570796326794897"},
        {"{offset: corner, by: -1, corners: mitre}", BATTEN_OK, "within 1e-6;length 9"},
        {"{offset: corner, by: -1, corners: mitre, mitre-limit: 1}", BATTEN_OK,
         "within 1e-6;length 8.65685424949238"},
        {"{offset: corner, by: -1, corners: square}", BATTEN_OK,
         "within 1e-6;length 8.65685424949238"},
        {"{offset: corner, by: 1}", BATTEN_OK, "within 1e-6;length 5"},
        {"{offset: sheet, by: 2}", BATTEN_OK, "on 0 0 1 2;notes the offset is exact"},
        {"{offset: sheet, by: 2, side: both}", BATTEN_OK,
         "objects 2;on 0 0 1 2;object 1;on 0 0 1 -2"},
        {"{offset: ball, by: 1}", BATTEN_OK, "within 1e-3;distance 2 0 0 0"},
        {"{offset: ducks, by: 1}", BATTEN_BAD_ARGUMENT, "ducks"},
        {"{offset: one, by: 1, within: 0}", BATTEN_BAD_ARGUMENT, "one: "},
    };
    EXPECT(shapes, rows);
}

TEST(curves_and_surfaces_are_joined_where_they_meet)
{
    static const expect_row rows[] = {
        {"{join: [one, two]}", BATTEN_OK,
         "objects 1;named a;length 7;at 0 0 0 0;at 1 4 3 0;spans 0"},
        {"{join: one}", BATTEN_OK, "length 4"},
        {"{join: [one, far]}", BATTEN_NOT_COMPATIBLE, ""},
        {"{join: [one, sheet]}", BATTEN_NOT_COMPATIBLE,
         "curves and surfaces cannot be joined: 'one', 'sheet'"},
        {"{join: [sheet, shifted]}", BATTEN_OK, "objects 1;area 2;box 0 0 0 2 1 0"},
        {"{join: [sheet, above], direction: v}", BATTEN_OK, "area 2;box 0 0 0 1 2 0"},
        {"{join: [sheet, above]}", BATTEN_NOT_COMPATIBLE, ""},
        {"{join: [arcs, one]}", BATTEN_NOT_COMPATIBLE, ""},
    };
    EXPECT(shapes, rows);
}

TEST(matched_curves_join_as_smoothly_as_asked)
{
    static const char pair[] =
        "  p: {points: [[0, 0], [1, 0], [2, 1], [3, 1]]}\n"
        "  q: {points: [[3, 1.1], [4, 2], [5, 2], [6, 1]]}\n"
        "  left: {bezier: p}\n  right: {bezier: q}\n  both: {collect: [left, right]}\n"
        "  net: {points: [[0, 0], [1, 0], [0, 1], [1, 1]], columns: 2}\n  sheet: {bezier-surface: net}\n";
    static const expect_row rows[] = {
        {"{match: [left, right], continuity: G0}", BATTEN_OK,
         "objects 2;named left;at 1 3 1 0;object 1;named right;at 0 3 1 0;joins 0 1 1 0;error 0.2"},
        {"{match: [left, right], continuity: G1}", BATTEN_OK,
         "joins 0 1 1 0;heads 1 1 0 0;object 1;heads 0 1 0 0"},
        {"{match: [left, right], moves: first, continuity: G1}", BATTEN_OK,
         "joins 0 1 1 0;at 1 3 1.1 0;heads 1 0.7432941462471664 0.6689647316224497 0"},
        {"{match: [left, right], moves: both, continuity: C1}", BATTEN_OK, "joins 0 1 1 0"},
        {"{match: [left, right, left]}", BATTEN_NOT_COMPATIBLE,
         "two curves or two surfaces are needed, there are 3"},
        {"{match: [left, sheet]}", BATTEN_NOT_COMPATIBLE,
         "a curve and a surface; two of one kind are needed"},
        {"{match: [sheet, sheet], moves: both, continuity: G1}", BATTEN_UNSUPPORTED,
         "surfaces join with G0, G1 or G2"},
        {"{match: [sheet, sheet], continuity: C1}", BATTEN_UNSUPPORTED,
         "only one of them moves"},
    };
    EXPECT(pair, rows);
}

TEST(blends_follow_the_curves_that_they_join)
{
    static const expect_row rows[] = {
        {"{blend: [one, far], first: G1, second: G1}", BATTEN_OK,
         "objects 1;at 0 4 0 0;at 1 9 8 0;heads 0 1 0 0;heads 1 0 1 0;notes joins with G"},
        {"{blend: [one, far], first: G0, second: G0}", BATTEN_OK, "length 9.433981132056603"},
        {"{blend: [one, far], whole: yes}", BATTEN_OK, "at 0 0 0 0;at 1 9 9 0"},
        {"{blend: [one, far], bulge: [1, 2, 3]}", BATTEN_BAD_ARGUMENT,
         "'bulge' has 3 factors, at most 2 are used"},
        {"{blend: [one, far], first: G2, second: G2, bulge: [1, 2]}", BATTEN_OK,
         "bends 0 0;bends 1 0;heads 0 1 0 0;heads 1 0 1 0"},
        {"{blend: [sheet, shifted], edges: u1}", BATTEN_BAD_ARGUMENT,
         "surfaces are blended between two 'edges', 1 are given"},
        {"{blend: [sheet, shifted], edges: [u1, u0], parts: [0, 1]}", BATTEN_BAD_ARGUMENT,
         "'parts' are four numbers, 2 are given"},
        {"{blend: [sheet, shifted], edges: [u1, u0], bulge: [1, 2, 3]}", BATTEN_BAD_ARGUMENT,
         "'bulge' has 3 factors"},
        {"{blend: [sheet, shifted, above], edges: [u1, u0]}", BATTEN_NOT_COMPATIBLE,
         "two surfaces are needed, there are 3"},
    };
    EXPECT(shapes, rows);
}

TEST(curves_of_even_speed_run_through_their_length)
{
    static const expect_row rows[] = {
        {"{even-speed: one}", BATTEN_OK, "domain 0 4;notes the speed is 1 to within"},
        {"{even-speed: ring, within: 1e-6}", BATTEN_OK,
         "within 1e-5;distance 2 0 0 0;at 0.125 1.4142135623730951 1.4142135623730951 0;error 1e-6"},
        {"{even-speed: ring, within: 0}", BATTEN_BAD_ARGUMENT, ""},
        {"{even-speed: sheet}", BATTEN_BAD_ARGUMENT, "sheet"},
    };
    EXPECT(shapes, rows);
}

TEST(without_within_errors_are_below_a_tenth_of_the_tolerance_of_the_design)
{
    static const char ovals[] = "  oval: {ellipse: 2, b: 1}\n"
                                "  p: {points: [[0, 0], [1, 1.5], [2.5, -1], [4, 0]]}\n"
                                "  bow: {bezier: p}\n"
                                "  sheet: {extrude: bow, along: [0, 0.4, 3]}\n";
    static const expect_row rows[] = {
        {"{even-speed: oval}", BATTEN_OK, "error 1e-4;within 2e-4;length 9.688448220547675"},
        {"{even-speed: oval, within: 1e-2}", BATTEN_OK, "error 1e-2"},
        {"{even-speed: oval, within: 1e-7}", BATTEN_OK, "error 1e-7"},
        {"{offset: oval, by: 0.3}", BATTEN_OK, "error 1e-4"},
        {"{offset: oval, by: 0.3, within: 1e-7}", BATTEN_OK, "error 1e-7"},
        {"{offset: sheet, by: 0.05}", BATTEN_OK, "error 1e-4;notes within the tolerance"},
        {"{offset: sheet, by: 0.05, within: 1e-3}", BATTEN_OK, "error 1e-3"},
    };
    EXPECT(ovals, rows);
}
