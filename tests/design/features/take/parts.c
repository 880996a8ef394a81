#include "design/expect.h"

/* Features that take something from shapes: curves on surfaces, points on curves, frames, parts, meshes. */

static const char shapes[] =
    "  net: {points: [[0, 0, 0], [2, 0, 0], [0, 1, 3], [2, 1, 3]], columns: 2}\n"
    "  slope: {bezier-surface: net}\n"
    "  flat: {points: [[0, 0, 5], [2, 0, 5], [0, 1, 5], [2, 1, 5]], columns: 2}\n"
    "  level: {bezier-surface: flat}\n"
    "  steep: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 12], [0, 1, 12]]}\n"
    "  steeper: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 24], [0, 1, 24]]}\n"
    "  tall: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 60], [0, 1, 60]]}\n"
    "  taller: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 120], [0, 1, 120]]}\n"
    "  tallest: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 121], [0, 1, 121]]}\n"
    "  drops: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}\n"
    "  three: {bezier-triangle: drops}\n"
    "  ball: {sphere: 2}\n"
    "  tube: {cylinder: 1, height: 4}\n"
    "  ring: {circle: 2}\n"
    "  bend: {arc: 2, angle: 180 deg}\n"
    "  corner: {polyline: [[0, 0], [4, 0], [4, 3]]}\n"
    "  tilted: {line: [[0, 0, 0], [1, 2, 2]]}\n"
    "  vee: {points: [[-1, 1], [0, -1], [1, 1]]}\n  bow: {bezier: vee}\n"
    "  one: {line: [[0, 0], [4, 0]]}\n"
    "  c1: {line: [[0, 0], [2, 0]]}\n  c2: {line: [[2, 0], [2, 1]]}\n  c3: {line: [[2, 1], [1, 1]]}\n"
    "  c4: {line: [[1, 1], [1, 2]]}\n  c5: {line: [[1, 2], [0, 2]]}\n  c6: {line: [[0, 2], [0, 0]]}\n"
    "  hole: {fill: [c1, c2, c3, c4, c5, c6], form: sheet}\n"
    "  raised: {move: slope, by: [0, 0, 1]}\n"
    "  lines: {collect: [one, corner]}\n  twos: {collect: [one, one]}\n";

TEST(curves_of_surfaces_lie_at_their_parameters)
{
    static const expect_row rows[] = {
        {"{curve-of: slope, u: 0.5}", BATTEN_OK,
         "objects 1;degree 1;at 0 1 0 0;at 1 1 1 3;length 3.1622776601683795"},
        {"{curve-of: slope, v: [0, 1]}", BATTEN_OK,
         "objects 2;named slope v=0;at 1 2 0 0;object 1;named slope v=1;at 1 2 1 3"},
        {"{curve-of: slope, u: 0.25, v: 0.75}", BATTEN_OK,
         "objects 2;named slope u=0.25;on 1 0 0 0.5;object 1;named slope v=0.75;on 0 1 0 0.75"},
        {"{curve-of: slope}", BATTEN_BAD_ARGUMENT, "'u' or 'v' must say where the curves are"},
        {"{curve-of: slope, u: 2}", BATTEN_OUT_OF_DOMAIN, "2"},
        {"{curve-of: one, u: 0}", BATTEN_BAD_ARGUMENT, "one"},
    };
    EXPECT(shapes, rows);
}

TEST(contours_have_equal_heights)
{
    static const expect_row rows[] = {
        {"{contours: slope, levels: [1, 2]}", BATTEN_OK,
         "objects 2;named slope at 1;on 0 0 1 1;length 2;object 1;named slope at 2;on 0 0 1 2;error 0.001"},
        /* A twelfth of 3 is 0.25: the next of 1, 2, 5, 10 ... is 0.5, which gives 0, 0.5 ... 3. */
        {"{contours: slope}", BATTEN_OK, "object 0;on 0 0 1 0.5;object 3;on 0 0 1 2"},
        {"{contours: slope, spacing: 1}", BATTEN_OK, "object 0;on 0 0 1 1;object 1;on 0 0 1 2"},
        {"{contours: slope, levels: [1.5], as: polylines}", BATTEN_OK, "degree 1;on 0 0 1 1.5"},
        {"{contours: ball, levels: [0]}", BATTEN_OK, "within 0.01;on 0 0 1 0;distance 2 0 0 0"},
        {"{contours: ball, levels: [1], within: 0.0001}", BATTEN_OK,
         "within 0.001;on 0 0 1 1;distance 2 0 0 0;closed 1;error 0.0001"},
        {"{contours: ball, levels: [1], as: polylines}", BATTEN_OK,
         "degree 1;within 0.01;on 0 0 1 1;closed 1;error 0.001;silent"},
        /* Smooth, unless memory is short: a polyline is no answer then. */
        {"{contours: ball, levels: [1]}", BATTEN_OK, "degree 3;rational 0;closed 1;silent"},
        {"{contours: [ball, slope], levels: [1]}", BATTEN_OK,
         "objects 2;named ball at 1;object 1;named slope at 1;silent"},
        {"{contours: slope, levels: [1, 2, 7]}", BATTEN_OK, "objects 2;silent"},
        /* A twelfth of 12 is 1, of 24 is 2, of 60 is 5 and of 120 is 10. */
        {"{contours: steep}", BATTEN_OK, "on 0 0 1 1;object 10;on 0 0 1 11"},
        {"{contours: steeper}", BATTEN_OK, "on 0 0 1 2;object 10;on 0 0 1 22"},
        {"{contours: tall}", BATTEN_OK, "on 0 0 1 5;object 10;on 0 0 1 55"},
        {"{contours: taller}", BATTEN_OK, "on 0 0 1 10;object 10;on 0 0 1 110"},
        {"{contours: tallest}", BATTEN_OK, "on 0 0 1 20;object 5;on 0 0 1 120"},
        {"{contours: slope, spacing: 0.00301}", BATTEN_OK, "on 0 0 1 0.00301"},
        {"{contours: slope, spacing: 0.003}", BATTEN_TOO_LARGE, "apart from 0 to 3: more than"},
        {"{contours: ball, levels: [1], within: 1e-7}", BATTEN_OK,
         "degree 3;within 1e-6;on 0 0 1 1;distance 2 0 0 0;closed 1"},
        {"{contours: three, levels: [0.5]}", BATTEN_OK, "on 0 0 1 0.5;length 0.5"},
        {"{contours: three, levels: [0.5], within: 1e-8}", BATTEN_OK, "on 0 0 1 0.5"},
        {"{contours: raised, spacing: 7}", BATTEN_NOT_FOUND,
         "the field runs from 1 to 4: no level 7 apart lies between"},
        {"{contours: raised, spacing: 4}", BATTEN_OK, "objects 1;on 0 0 1 4;named a"},
        {"{contours: slope, levels: [1, 9]}", BATTEN_OK, "objects 1;named a;on 0 0 1 1"},
        {"{contours: [slope, level], levels: [1]}", BATTEN_OK,
         "objects 1;notes 'level' meets none of the levels"},
        {"{contours: slope, levels: [7, 8]}", BATTEN_NOT_FOUND,
         "no level from 7 to 8 is met by the field, which runs from 0 to 3"},
        {"{contours: level, levels: [5]}", BATTEN_NOT_FOUND,
         "the field is 5 everywhere: no lines lie at its levels"},
        {"{contours: level}", BATTEN_NOT_FOUND, "the field is 5 everywhere: it has no levels"},
        {"{contours: slope, levels: [7]}", BATTEN_NOT_FOUND,
         "no level from 7 to 7 is met by the field"},
        {"{contours: slope, spacing: 1e-9}", BATTEN_TOO_LARGE, "apart from 0 to 3: more than"},
        {"{contours: one}", BATTEN_BAD_ARGUMENT, "one"},
    };
    EXPECT(shapes, rows);
}

TEST(curves_are_divided_into_equal_parts)
{
    static const expect_row rows[] = {
        {"{divide: one, count: 4}", BATTEN_OK,
         "objects 1;kind points;named a;count 5;data 0 0 0 0;data 1 1 0 0;data 3 3 0 0;data 4 4 0 0"},
        {"{divide: one, count: 1}", BATTEN_OK, "count 2;data 1 4 0 0"},
        {"{divide: corner, count: 7}", BATTEN_OK,
         "count 8;within 1e-6;data 3 3 0 0;data 5 4 1 0"},
        {"{divide: lines, count: 1}", BATTEN_OK,
         "objects 2;named one;object 1;named corner;data 1 4 3 0"},
        {"{divide: bend, count: 2}", BATTEN_OK, "within 1e-6;data 1 0 2 0"},
        {"{divide: bend, chords: 3}", BATTEN_OK,
         "count 4;within 1e-6;data 1 1 1.7320508075688772 0"},
        /* An affine map of the arc is an ellipse: points at equal angles stay so. */
        {"{divide: bend, count: 3, by: affine}", BATTEN_OK,
         "count 4;within 1e-6;data 1 1 1.7320508075688772 0;data 2 -1 1.7320508075688772 0"},
        {"{divide: bow, count: 2, by: length}", BATTEN_OK, "within 1e-6;data 1 0 0 0"},
        {"{divide: corner, chords: 2}", BATTEN_OK,
         "count 3;within 1e-6;data 0 0 0 0;data 1 3.125 0 0;data 2 4 3 0"},
        {"{divide: one, within: 0.01}", BATTEN_OK, "count 2;data 1 4 0 0"},
        {"{divide: one, within: 0.01, angle: 1 deg}", BATTEN_OK, "count 2;data 1 4 0 0"},
        {"{divide: bend, within: 3, angle: 45 deg}", BATTEN_OK,
         "count 5;within 1e-6;data 1 1.4142135623730951 1.4142135623730951 0;data 4 -2 0 0"},
        {"{divide: one, count: 1000001}", BATTEN_BAD_ARGUMENT,
         "a curve is not cut into 1000001 parts"},
        {"{divide: one, count: 2, angle: 2 deg}", BATTEN_BAD_ARGUMENT, "one of 'count'"},
        {"{divide: one, pieces: spans, angle: 2 deg}", BATTEN_BAD_ARGUMENT, "one of 'count'"},
        {"{divide: tilted, count: 2}", BATTEN_OK, "data 1 0.5 1 1;data 2 1 2 2"},
        {"{divide: bend, count: 2, by: affine}", BATTEN_OK, "count 3;within 1e-6;data 1 0 2 0"},
        {"{divide: bend, angle: 45 deg}", BATTEN_OK,
         "count 5;within 1e-6;data 1 1.4142135623730951 1.4142135623730951 0"},
        {"{divide: bend, within: 0.5}", BATTEN_OK, "data 0 2 0 0"},
        {"{divide: corner, pieces: spans}", BATTEN_OK, "count 3;data 1 4 0 0"},
        {"{divide: corner, pieces: convex, along: x}", BATTEN_BAD_ARGUMENT,
         "'along' is for monotone pieces"},
        {"{divide: one, count: 0}", BATTEN_BAD_ARGUMENT, "a curve is not cut into 0 parts"},
        {"{divide: one, chords: 1000001}", BATTEN_BAD_ARGUMENT,
         "a curve is not cut into 1000001 parts"},
        {"{divide: one}", BATTEN_BAD_ARGUMENT,
         "one of 'count', 'chords', 'within' (or 'angle')"},
        {"{divide: one, count: 2, chords: 2}", BATTEN_BAD_ARGUMENT, "one of 'count'"},
        {"{divide: one, count: 2, within: 2}", BATTEN_BAD_ARGUMENT, "one of 'count'"},
        {"{divide: ball, count: 2}", BATTEN_BAD_ARGUMENT, "ball"},
    };
    EXPECT(shapes, rows);
}

TEST(edges_and_faces_of_bodies_are_curves_and_surfaces)
{
    static const expect_row rows[] = {
        {"{edges: slope}", BATTEN_OK, "objects 4;named slope.1;within 1e-6;box 0 0 0 2 1 3"},
        {"{edges: slope, which: free}", BATTEN_OK, "objects 4"},
        {"{edges: slope, which: shared}", BATTEN_NOT_FOUND, "there are no such edges"},
        /* Of a cylinder both rims are free; the seam is used twice. */
        {"{edges: tube, which: free}", BATTEN_OK,
         "objects 2;within 1e-6;length 6.283185307179586;object 1;length 6.283185307179586"},
        {"{edges: tube, which: shared}", BATTEN_OK, "objects 1;within 1e-6;length 4"},
        {"{edges: tube}", BATTEN_OK, "objects 3"},
        {"{edges: [slope, tube], which: shared}", BATTEN_OK,
         "objects 1;named a;within 1e-6;length 4;notes 'slope' has no such edges"},
        {"{edges: [tube, slope]}", BATTEN_OK, "objects 7;silent"},
        /* Its four meridians are one and its poles have no length. */
        {"{edges: ball, which: free}", BATTEN_NOT_FOUND, "there are no such edges"},
        {"{edges: hole}", BATTEN_OK, "objects 6;within 1e-3;length 2"},
        {"{edges: one}", BATTEN_BAD_ARGUMENT, "one"},
        {"{faces: slope}", BATTEN_OK, "objects 1;area 6.324555320336759;silent"},
        {"{faces: [slope, level]}", BATTEN_OK, "objects 2;named slope;object 1;named level"},
        {"{faces: hole}", BATTEN_OK,
         "objects 1;kind surface;named a;notes 1 of 1 faces of 'hole' end elsewhere than their "
         "surfaces, which are whole here"},
        {"{faces: one}", BATTEN_BAD_ARGUMENT, "one"},
    };
    EXPECT(shapes, rows);
}

TEST(frames_stand_across_their_curve)
{
    static const expect_row rows[] = {
        /* Out and back along x, and half as far along y, at each of three places of a line along x. */
        {"{frames: one, count: 3, size: 2}", BATTEN_OK,
         "objects 1;named a;degree 1;count 15;control 0 0 0 0;control 2 0 0 0;control 5 2 0 0;control "
         "10 4 0 0;control 12 4 0 0;control 14 4 0 0;length 22"},
        {"{frames: one, count: 2}", BATTEN_OK, "count 10;length 5.2"},
        {"{frames: one}", BATTEN_OK, "count 120"},
        {"{frames: lines, count: 2}", BATTEN_OK,
         "objects 2;named frames of one;object 1;named frames of corner"},
        {"{frames: one, as: ribbon, size: 3}", BATTEN_OK, "kind surface;within 1e-8;area 12"},
        {"{frames: one, as: ribbon}", BATTEN_OK, "kind surface;within 1e-8;area 0.8"},
        {"{frames: one, count: 0}", BATTEN_BAD_ARGUMENT,
         "0 frames are asked for; at least 2 are needed"},
        {"{frames: bend, as: ribbon, size: 1, kind: fixed}", BATTEN_OK, "kind surface"},
        {"{frames: ring, kind: frenet, count: 4, size: 1}", BATTEN_OK,
         "within 1e-6;control 1 1 0 0;control 0 2 0 0;control 3 2 0 0.5"},
        {"{frames: one, kind: frenet}", BATTEN_SINGULAR_HERE, "one: "},
        {"{frames: one, count: 1}", BATTEN_BAD_ARGUMENT,
         "1 frame is asked for; at least 2 are needed"},
        {"{frames: one, size: 0}", BATTEN_BAD_ARGUMENT, "the size of frames is 0, not above 0"},
        {"{frames: one, size: -1}", BATTEN_BAD_ARGUMENT,
         "the size of frames is -1, not above 0"},
        {"{frames: ball}", BATTEN_BAD_ARGUMENT, "ball"},
    };
    EXPECT(shapes, rows);
}

TEST(meshes_have_the_area_of_their_shape)
{
    static const expect_row rows[] = {
        {"{mesh: slope}", BATTEN_OK,
         "objects 1;kind mesh;named a;area 6.324555320336759;notes triangles, at most;lacks not in the "
         "mesh;lacks more than 'chord'"},
        {"{mesh: three}", BATTEN_OK, "kind mesh;area 0.7071067811865476"},
        {"{mesh: [slope, level]}", BATTEN_OK,
         "objects 2;named slope;object 1;named level;area 2"},
        {"{mesh: ball, chord: 0.01, angle: 90 deg}", BATTEN_OK,
         "within 0.02;area 50.26548245743669;error 0.01"},
        {"{mesh: ball, chord: 1, angle: 20 deg}", BATTEN_OK,
         "within 0.03;area 50.26548245743669;finer 400;error 0.05"},
        {"{mesh: level, longest: 0.1}", BATTEN_OK, "area 2;finer 400"},
        {"{mesh: level}", BATTEN_OK, "notes 'level': 2 triangles, at most 0 from the shape"},
        {"{mesh: three}", BATTEN_OK, "notes 'three': 1 triangle, at most 0 from the shape"},
        {"{mesh: hole}", BATTEN_OK, "objects 1;kind mesh;within 1e-3;area 3"},
        {"{mesh: ball, most: 10}", BATTEN_TOO_LARGE, "'ball': "},
        {"{mesh: ball, chord: -1}", BATTEN_BAD_ARGUMENT, "'ball': "},
        {"{mesh: one}", BATTEN_BAD_ARGUMENT, "one"},
    };
    EXPECT(shapes, rows);
}

TEST(parts_lie_between_their_parameters_and_selections_keep_their_order)
{
    static const char more[] = "  ducks: {points: [[0, 0], [1, 2], [3, 0]]}\n"
                               "  bow: {bezier: ducks}\n"
                               "  net: {points: [[0, 0], [1, 0], [0, 1], [1, 1]], columns: 2}\n"
                               "  sheet: {bezier-surface: net}\n"
                               "  arcs: {arc-spline: ducks, ends: circular}\n"
                               "  all: {collect: [bow, sheet, ducks]}\n";
    static const expect_row rows[] = {
        {"{part: bow, from: 0.5, to: 1}", BATTEN_OK, "domain 0.5 1;at 0 1.25 1 0;at 1 3 0 0"},
        {"{part: sheet, from: 0.5, to: 0.75}", BATTEN_OK, "area 0.25;at 0 0 0.5 0 0"},
        {"{part: sheet, from: 0.5, to: 0.75, direction: v}", BATTEN_OK,
         "area 0.25;at 0 0 0 0.5 0"},
        {"{part: arcs, from: 0, to: 1}", BATTEN_OK, "spans 1;at 0 0 0 0"},
        {"{part: bow, from: 0.5, to: 7}", BATTEN_OUT_OF_DOMAIN, "7"},
        {"{select: all, names: [sheet, bow]}", BATTEN_OK,
         "objects 2;named sheet;kind surface;object 1;named bow;kind curve"},
        {"{select: all, names: [ducks]}", BATTEN_OK, "objects 1;kind points"},
        {"{select: all, names: [bow, duks]}", BATTEN_NOT_FOUND,
         "'all' has no object 'duks'; its 3 objects begin with 'bow'"},
    };
    EXPECT(more, rows);
}

TEST(collected_objects_of_one_name_get_numbers)
{
    static const expect_row rows[] = {
        {"{collect: one}", BATTEN_OK, "objects 1;named a"},
        {"{collect: [one, one, one]}", BATTEN_OK,
         "objects 3;named one;object 1;named one (2);object 2;named one (3)"},
        {"{collect: [lines, one, twos]}", BATTEN_OK,
         "objects 5;object 2;named one (2);object 3;named one (3);object 4;named one (2) (2)"},
        {"{collect: [lines, one, ball]}", BATTEN_OK,
         "objects 4;object 2;named one (2);object 3;named ball"},
    };
    EXPECT(shapes, rows);
}
