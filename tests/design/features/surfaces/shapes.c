#include "design/expect.h"

/* Surfaces as features: planes, cylinders and cones that their parameters must give. */

static const char shapes[] =
    "  twice: {points: [[0, 0, 0], [3, 0, 3], [3, 4, 7], [0, 4, 4], [1, 1, 2], [1, 1, 2.5], [2, 3, 5], [1, 3, 4]]}\n"
    "  steps: {points: [[0, 0, 0], [1, 0, 1], [2, 0, 0.5], [0, 1, 0.5], [1, 1, 1.5], [2, 1, 1], [0, 2, 0], [1, 2, 0.7], [2, 2, 0.1]], columns: 3}\n"
    "  one: {line: [[0, 0, 0], [4, 0, 0]]}\n"
    "  two: {line: [[0, 3, 0], [4, 3, 0]]}\n"
    "  high: {line: [[0, 3, 4], [4, 3, 4]]}\n"
    "  side: {line: [[0, 0, 0], [0, 3, 0]]}\n"
    "  side2: {line: [[4, 0, 0], [4, 3, 0]]}\n"
    "  post: {line: [[2, 0, 0], [2, 0, 3]]}\n"
    "  slant: {line: [[3, 0, 0], [0, 0, 4]]}\n"
    "  tilt: {line: [[2, 0, 0], [2, 3, 3]]}\n"
    "  ring: {circle: 2}\n"
    "  lines: {collect: [one, two]}\n"
    "  bent: {polyline: [[0, 0, 0], [1, 0, 0], [4, 0, 0]]}\n"
    "  net: {points: [[0, 0, 1], [1, 0, 1], [2, 0, 1], [0, 1, 1], [1, 1, 1], [2, 1, 1], [0, 2, 1], [1, 2, 1], [2, 2, 1]], columns: 3}\n"
    "  back: {points: [[2, 2, 5], [1, 2, 4], [0, 2, 3], [2, 1, 4], [1, 1, 3], [0, 1, 2], [2, 0, 3], [1, 0, 2], [0, 0, 1]], columns: 3}\n"
    "  big: {points: [[0, 0, 0], [1, 0, 1], [2, 0, 2], [3, 0, 3], [0, 1, 1], [1, 1, 2], [2, 1, 3], [3, 1, 4], [0, 2, 2], [1, 2, 3], [2, 2, 4], [3, 2, 5], [0, 4, 4], [1, 4, 5], [2, 4, 6], [3, 4, 7]], columns: 4}\n"
    "  flat: {bilinear: [[0, 0], [4, 0], [4, 3], [0, 3]]}\n"
    "  flats: {collect: [flat, flat]}\n"
    "  drops: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}\n"
    "  three: {bezier-triangle: drops}\n";

static const expect_row of_lines[] = {
    {"{bilinear: [[0, 0], [4, 0], [4, 3], [0, 3]]}", BATTEN_OK,
     "objects 1;area 12;on 0 0 1 0;at 1 0 4 0 0;at 1 1 4 3 0"},
    {"{bilinear: [[0, 0], [4, 0], [4, 3]]}", BATTEN_BAD_ARGUMENT,
     "a bilinear patch has 4 corners, not 3"},
    {"{ruled: [one, high]}", BATTEN_OK, "area 20;on 0 4 -3 0;at 0 1 0 3 4;exact"},
    {"{ruled: [one, two], match: length}", BATTEN_OK, "area 12;error 0.001"},
    {"{ruled: [bent, two]}", BATTEN_OK, "at 0.5 0 2 0 0;at 0.5 1 2 3 0"},
    {"{ruled: [bent, two], match: length}", BATTEN_OK, "within 1e-6;at 0.5 0.5 2 1.5 0"},
    {"{ruled: [one, two, high]}", BATTEN_BAD_ARGUMENT,
     "a ruled surface lies between 2 curves, not 3"},
    {"{ruled: one}", BATTEN_BAD_ARGUMENT, "between 2 curves, not 1"},
    {"{extrude: one, along: [0, 3, 4]}", BATTEN_OK, "area 20;on 0 4 -3 0;named a"},
    {"{extrude: lines, along: [0, 0, 2]}", BATTEN_OK,
     "objects 2;named one;area 8;object 1;named two"},
    {"{extrude: ring, along: [0, 0, 2]}", BATTEN_OK,
     "along 2 0 0 0 0 0 1;area 25.132741228718345"},
    {"{extrude: one, along: [0, 0, 0]}", BATTEN_BAD_ARGUMENT,
     "'along' is 0 and has no direction"},
    {"{extrude: flat, along: [0, 0, 1]}", BATTEN_BAD_ARGUMENT, "flat"},
    {"{tabulate: one, direction: [0, 3, 4], from: 1, to: 6}", BATTEN_OK,
     "area 20;on 0 4 -3 0;at 0 0 0 0.6 0.8;at 0 1 0 3.6 4.8"},
    {"{tabulate: one, to: 2}", BATTEN_OK, "area 8;on 0 1 0 0;at 0 0 0 0 0"},
    {"{tabulate: one, direction: [0, 0, 0], to: 1}", BATTEN_BAD_ARGUMENT, "'direction' is 0"},
    {"{cone-to: one, apex: [0, 3, 0]}", BATTEN_OK, "area 6;on 0 0 1 0"},
    {"{cone-to: lines, apex: [0, 0, 3]}", BATTEN_OK, "objects 2;named one;object 1;named two"},
    {"{cone-to: ring, apex: [0, 0, 1.5]}", BATTEN_OK, "area 15.707963267948966"},
    {"{revolve: post}", BATTEN_OK, "along 2 0 0 0 0 0 1;area 37.69911184307752;named a"},
    {"{revolve: post, angle: 90 deg}", BATTEN_OK, "area 9.42477796076938;box 0 0 0 2 2 3"},
    {"{revolve: post, at: [1, 0, 0]}", BATTEN_OK, "along 1 1 0 0 0 0 1"},
    {"{revolve: one, axis: y}", BATTEN_OK, "on 0 1 0 0;area 50.26548245743669"},
    {"{revolve: slant}", BATTEN_OK, "area 47.12388980384690"},
    {"{revolve: post, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT, "'axis' is 0"},
    {"{translational: one, path: side}", BATTEN_OK, "area 12;on 0 0 1 0"},
    {"{translational: lines, path: post}", BATTEN_OK,
     "objects 2;named one;area 12;object 1;named two"},
    {"{translational: one, path: lines}", BATTEN_BAD_ARGUMENT, "'path' is one curve, not 2"},
    {"{swing: post, path: ring}", BATTEN_OK, "along 4 0 0 0 0 0 1;silent"},
    {"{swing: post, path: ring, factor: 0.5}", BATTEN_OK, "along 2 0 0 0 0 0 1"},
    {"{swing: slant, path: one}", BATTEN_OK,
     "notes the trajectory comes within 0 of the axis: the surface is pinched there"},
    {"{developable: [one, high]}", BATTEN_OK,
     "within 1e-6;area 20;on 0 4 -3 0;notes developable: warp at most"},
    {"{developable: [one, two, high]}", BATTEN_BAD_ARGUMENT,
     "a plate lies between 2 edges, not 3"},
    {"{developable: [side, tilt], match: parameter}", BATTEN_OK, "notes not developable"},
    {"{helical: one, pitch: 3, within: 0.01}", BATTEN_OK,
     "error 0.01;at 0 0 0 0 0;within 0.01;at 1 0.5 -4 0 1.5;at 1 1 4 0 3"},
    {"{helical: one, pitch: 3, turns: 0.25, within: 0.01}", BATTEN_OK,
     "within 0.01;at 1 1 0 4 0.75"},
    {"{helical: one, pitch: -3, turns: 0.25, within: 0.01}", BATTEN_OK,
     "within 0.01;at 1 1 0 4 -0.75"},
    {"{helical: one, pitch: 3, turns: 0.25, at: [4, 0, 0], within: 0.01}", BATTEN_OK,
     "within 0.01;at 0 1 4 -4 0.75"},
    {"{helical: one, pitch: 3, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT, "'axis' is 0"},
    {"{pipe: one, radius: 0.5}", BATTEN_OK,
     "within 1e-3;along 0.5 0 0 0 1 0 0;area 12.566370614359172"},
    {"{pipe: lines, radius: 0.5}", BATTEN_OK, "objects 2"},
    {"{pipe: ring, radius: 0.5, within: 0.001}", BATTEN_OK,
     "within 0.01;area 39.47841760435743;error 0.001"},
    {"{pipe: ring, radius: 3}", BATTEN_NOT_COMPATIBLE, "the sections run into each other"},
    {"{pipe: one, radius: 0}", BATTEN_BAD_ARGUMENT, "radius"},
};

TEST(surfaces_of_lines_lie_between_their_curves)
{
    EXPECT(shapes, of_lines);
}

TEST(surfaces_of_grids_keep_planes_and_close_where_they_are_asked_to)
{
    static const char *const planes[] = {"interpolate-grid", "fit-grid", "tension-surface",
                                         "catmull-rom-surface", "coons-network"};
    static const expect_row every[] = {
        {"{@: big}", BATTEN_OK,
         "objects 1;within 1e-8;on -1 -1 1 0;at 0 0 0 0 0;at 1 0 3 0 3;at 0 1 0 4 4"},
    };
    expect_each(shapes, planes, COUNT(planes), every, 1);
    static const expect_row rows[] = {
        {"{interpolate-grid: net, degree-u: 2, degree-v: 1}", BATTEN_OK,
         "degree 2 1;on 0 0 1 1;area 4"},
        {"{interpolate-grid: big, weights: 2}", BATTEN_OK,
         "rational 1;within 1e-8;on -1 -1 1 0"},
        {"{interpolate-grid: net, degree-u: 2, degree-v: 2, weights: [1, 2]}",
         BATTEN_BAD_ARGUMENT, "'weights' has 2 numbers for 9 points"},
        {"{interpolate-grid: big, gaps: [6]}", BATTEN_OK,
         "within 1e-7;on -1 -1 1 0;notes 1 gap is filled"},
        {"{interpolate-grid: big, gaps: [17]}", BATTEN_BAD_ARGUMENT,
         "gap 17: the points are counted 1 to 16"},
        {"{interpolate-grid: big, knots: data, ends: natural}", BATTEN_OK,
         "count 6 6;on -1 -1 1 0"},
        {"{interpolate-grid: big, degree-u: 0}", BATTEN_BAD_DEGREE, ""},
        {"{fit-grid: big, as: function}", BATTEN_OK, "within 1e-8;on -1 -1 1 0;error 1e-8"},
        {"{fit-grid: back, as: function, degree-u: 2, degree-v: 2}", BATTEN_OK,
         "within 1e-8;on -1 -1 1 1"},
        {"{fit-grid: big, points-u: 4, points-v: 4, degree-u: 1}", BATTEN_OK,
         "degree 1 3;count 4 4"},
        {"{fit-grid: big, method: smooth, lambda: 1}", BATTEN_OK, "within 1e-6;on -1 -1 1 0"},
        {"{fit-grid: big, within: 0.001}", BATTEN_OK, "error 0.001"},
        {"{fit-grid: big, within: 0}", BATTEN_BAD_ARGUMENT, "'within' must be above 0"},
        {"{fit-grid: big, within: 1, rms: 1}", BATTEN_BAD_ARGUMENT,
         "'within' is for least squares; smoothing bounds 'rms'"},
        {"{fit-grid: big, as: function, periodic-u: yes}", BATTEN_BAD_ARGUMENT,
         "a function of x and y does not close"},
        {"{fit-grid: big, as: function, periodic-v: yes}", BATTEN_BAD_ARGUMENT,
         "a function of x and y does not close"},
        {"{tension-surface: big, amount-u: [1, 2, 3], amount-v: 4}", BATTEN_OK,
         "within 1e-8;on -1 -1 1 0"},
        {"{tension-surface: big, amount-u: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'amount-u' has 2 numbers for 3 strips"},
        {"{tension-surface: big, amount-v: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'amount-v' has 2 numbers for 3 strips"},
        {"{tension-surface: big, amount-v: [1, 2, 3, 4], closed-v: yes}", BATTEN_OK,
         "at 0.5 0 1.5 0 1.5"},
        {"{catmull-rom-surface: big, blend: 3, local: 2}", BATTEN_OK,
         "within 1e-8;on -1 -1 1 0"},
        {"{coons-network: [one, two], across: [side, side2]}", BATTEN_OK, "area 12;on 0 0 1 0"},
        {"{coons-network: [one, two], across: [side, side2], at-u: [0, 7], at-v: [2, 5]}",
         BATTEN_OK, "area 12"},
        {"{coons-network: [one, two], across: [side, side2], at-u: [0, 7, 8]}",
         BATTEN_BAD_ARGUMENT, "'at-u' has 3 values for 2 curves"},
        {"{coons-network: [one, two], across: [side, side2], at-v: [1]}", BATTEN_BAD_ARGUMENT,
         "'at-v' has 1 value for 2 curves"},
        {"{coons-network: [one, two], across: [side]}", BATTEN_TOO_FEW_POINTS,
         "a network of 2 and 1 curves is too small"},
        {"{coons-network: [one, high], across: [side, side2]}", BATTEN_NOT_COMPATIBLE, ""},
    };
    EXPECT(shapes, rows);
}

TEST(scattered_points_of_a_plane_give_the_plane)
{
    static const expect_row rows[] = {
        {"{scattered-surface: big}", BATTEN_OK,
         "kind triangles;within 1e-8;on -1 -1 1 0;error 1e-9;notes triangles between 16 vertices"},
        {"{scattered-surface: big, method: powell-sabin}", BATTEN_OK,
         "degree 2;within 1e-8;on -1 -1 1 0"},
        {"{scattered-surface: big, method: linear}", BATTEN_OK, "degree 1;on -1 -1 1 0"},
        {"{scattered-surface: big, gradients: local}", BATTEN_OK,
         "degree 3;within 1e-6;on -1 -1 1 0"},
        {"{scattered-surface: twice}", BATTEN_OK,
         "notes 1 point lies where others do, with heights up to 0.5 apart (point 6): their means "
         "are taken;lacks equal to others;error 0.25"},
        {"{scattered-surface: twice}", BATTEN_OK,
         "notes 8 triangles between 7 vertices, in 24 pieces"},
        {"{scattered-surface: big}", BATTEN_OK, "lacks where others do;lacks equal to others"},
        {"{interpolate-grid: steps, gaps: [1]}", BATTEN_OK,
         "notes 1 gap is filled with the points of least energy"},
        {"{interpolate-grid: steps, gaps: [5, 9]}", BATTEN_OK,
         "notes 2 gaps are filled with the points of least energy"},
        {"{interpolate-grid: steps, gaps: [0]}", BATTEN_BAD_ARGUMENT,
         "gap 0: the points are counted 1 to 9"},
        {"{interpolate-grid: steps, gaps: [10]}", BATTEN_BAD_ARGUMENT,
         "gap 10: the points are counted 1 to 9"},
        {"{interpolate-grid: steps}", BATTEN_OK, "silent;error 1e-12"},
        {"{catmull-rom-surface: steps}", BATTEN_OK, "silent;error 1e-12"},
        {"{scattered-surface: [big, big]}", BATTEN_OK, "notes 16 points are equal to others"},
        {"{fit-scattered: big, as: function}", BATTEN_OK, "within 1e-5;on -1 -1 1 0"},
        {"{fit-scattered: big}", BATTEN_OK, "within 1e-5;on -1 -1 1 0"},
        {"{fit-scattered: big, corners: [[0, 0, 0], [3, 0, 3], [3, 4, 7], [0, 4, 4]]}",
         BATTEN_OK, "within 1e-5;on -1 -1 1 0"},
        {"{fit-scattered: big, corners: [[0, 0, 0], [3, 0, 3]]}", BATTEN_BAD_ARGUMENT,
         "'corners' has 2 points, not 4"},
        {"{fit-scattered: big, base: flats}", BATTEN_BAD_ARGUMENT,
         "'base' has 2 surfaces; one is needed"},
        {"{fit-scattered: big, base: flat, corners: [[0, 0]]}", BATTEN_BAD_ARGUMENT,
         "give either 'base' or 'corners', not both"},
        {"{fit-scattered: big, as: function, base: flat}", BATTEN_BAD_ARGUMENT,
         "a function of x and y has no base"},
        {"{fit-scattered: big, as: function, corners: [[0, 0]]}", BATTEN_BAD_ARGUMENT,
         "a function of x and y has no base"},
        {"{fit-scattered: big, within: 0}", BATTEN_BAD_ARGUMENT,
         "'within' is 0; it must be above 0"},
        {"{fit-scattered: big, within: 1, robust: yes}", BATTEN_BAD_ARGUMENT,
         "'within' bounds every distance"},
        {"{fit-scattered: big, within: 1, rms: 1}", BATTEN_BAD_ARGUMENT,
         "'within' bounds every distance"},
    };
    EXPECT(shapes, rows);
}

TEST(surfaces_and_triangles_become_each_other)
{
    static const expect_row rows[] = {
        {"{triangles-of: flat}", BATTEN_OK, "kind triangles;count 2;on 0 0 1 0"},
        {"{triangles-of: flats}", BATTEN_BAD_ARGUMENT,
         "one surface is cut into triangles, not 2"},
        {"{triangles-of: one}", BATTEN_BAD_ARGUMENT, "one"},
        {"{patches-of: three}", BATTEN_OK, "objects 3;kind surface;on 0 -1 1 0"},
        {"{patches-of: three, form: pole}", BATTEN_OK,
         "objects 1;on 0 -1 1 0;area 0.7071067811865476"},
    };
    EXPECT(shapes, rows);
}
