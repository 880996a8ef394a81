#include "design/expect.h"

/* The exact shapes of a design: what they are, where 'at', 'axis' and 'from' put them, and what is refused. */

static const char no_features[] = "";

TEST(circles_arcs_and_ellipses_have_their_radii_and_their_place)
{
    static const expect_row rows[] = {
        {"{circle: 2}", BATTEN_OK,
         "objects 1;degree 2;count 9;rational 1;closed 1;distance 2 0 0 0;on 0 0 1 0;length "
         "12.566370614359172;at 0 2 0 0;at 0.25 0 2 0;exact;silent"},
        {"{circle: 2, at: [1, 2, 3], axis: x, from: y}", BATTEN_OK,
         "distance 2 1 2 3;on 1 0 0 1;at 0 1 4 3;at 0.25 1 2 5"},
        {"{circle: 2, axis: [0, 0, -3], from: y}", BATTEN_OK, "at 0 0 2 0;at 0.25 2 0 0"},
        {"{circle: 2, axis: [1, 1, 0]}", BATTEN_OK, "distance 2 0 0 0;on 1 1 0 0"},
        {"{circle: 1, form: triangle-7}", BATTEN_OK, "degree 2;count 7;distance 1 0 0 0"},
        {"{circle: 1, form: square-7}", BATTEN_OK, "degree 2;count 7;distance 1 0 0 0"},
        {"{circle: 1, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT,
         "'axis' is 0 and has no direction"},
        {"{circle: 1, from: [0, 0, 0]}", BATTEN_BAD_ARGUMENT,
         "'from' is 0 and has no direction"},
        {"{circle: 1, from: z}", BATTEN_BAD_ARGUMENT, "'from' is parallel to 'axis'"},
        {"{circle: 1, axis: [1, 1, 1], from: [-2, -2, -2]}", BATTEN_BAD_ARGUMENT,
         "'from' is parallel to 'axis'"},
        {"{arc: 2, start: 90 deg, angle: 90 deg}", BATTEN_OK,
         "distance 2 0 0 0;at 0 0 2 0;at 1 -2 0 0;length 3.141592653589793;closed 0"},
        {"{arc: 2}", BATTEN_OK, "closed 1;length 12.566370614359172;at 0 2 0 0"},
        {"{arc: 3, angle: 180 deg, at: [0, 0, 1], axis: y, from: z}", BATTEN_OK,
         "distance 3 0 0 1;on 0 1 0 0;at 0 0 0 4;at 0.5 3 0 1;at 1 0 0 -2"},
        {"{arc: 1, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT, "'axis' is 0 and has no direction"},
        {"{ellipse: 3, b: 2}", BATTEN_OK,
         "closed 1;at 0 3 0 0;at 0.25 0 2 0;at 0.5 -3 0 0;rational 1;on 0 0 1 0;exact"},
        {"{ellipse: 3, b: 2, start: 90 deg, angle: 90 deg, at: [1, 1, 1]}", BATTEN_OK,
         "at 0 1 3 1;at 1 -2 1 1;on 0 0 1 1"},
        {"{ellipse: 3, b: 2, axis: x, from: z}", BATTEN_OK, "at 0 0 0 3;at 0.25 0 -2 0"},
    };
    EXPECT(no_features, rows);
}

TEST(lines_join_two_points_and_conics_obey_weight_or_points)
{
    static const expect_row rows[] = {
        {"{line: [[1, 2, 3], [4, 6, 3]]}", BATTEN_OK,
         "objects 1;degree 1;count 2;at 0 1 2 3;at 1 4 6 3;length 5;rational 0"},
        {"{line: [[1, 2, 3]]}", BATTEN_BAD_ARGUMENT, "a line has 2 ends, not 1"},
        {"{line: [[0, 0], [1, 0], [2, 0]]}", BATTEN_BAD_ARGUMENT, "a line has 2 ends, not 3"},
        /* Weight cos 45 degrees between perpendicular legs of equal length: a quarter of a circle. */
        {"{conic: [[1, 0, 2], [1, 1, 2], [0, 1, 2]], weight: 0.7071067811865476}", BATTEN_OK,
         "distance 1 0 0 2;on 0 0 1 2;rational 1"},
        {"{conic: [[0, 0, 0], [1, 0, 0], [1, 1, 1]]}", BATTEN_OK,
         "degree 2;at 0 0 0 0;at 0.5 0.75 0.25 0.25;at 1 1 1 1"},
        {"{conic: [[0, 0, 0], [1, 0, 0], [1, 1, 1]], weight: 3}", BATTEN_OK,
         "at 0.5 0.875 0.125 0.125"},
        {"{conic: [[1, 0], [1, 1], [0, 1]], through: [0.6, 0.8]}", BATTEN_OK,
         "distance 1 0 0 0;on 0 0 1 0;at 0 1 0 0;at 1 0 1 0"},
        {"{conic: [[2, 0], [1.2, 1.6], [0, 2], [-1.2, 1.6], [-2, 0]]}", BATTEN_OK,
         "distance 2 0 0 0;at 0 2 0 0;at 1 -2 0 0"},
        {"{conic: [[1, 0, 1], [1, 1], [0, 1]], through: [0.6, 0.8]}", BATTEN_BAD_ARGUMENT,
         "a conic through points is drawn in the plane z = 0"},
        {"{conic: [[1, 0], [1, 1], [0, 1]], through: [0.6, 0.8, 1]}", BATTEN_BAD_ARGUMENT,
         "a conic through points is drawn in the plane z = 0"},
        {"{conic: [[2, 0], [1.2, 1.6], [0, 2], [-1.2, 1.6], [-2, 0, 1]]}", BATTEN_BAD_ARGUMENT,
         "a conic through points is drawn in the plane z = 0"},
        {"{conic: [[1, 0], [1, 1], [0, 1], [2, 2]]}", BATTEN_BAD_ARGUMENT,
         "a conic is given by 3 or 5 points, not 4"},
    };
    EXPECT(no_features, rows);
}

TEST(quadrics_have_their_axes_and_their_place)
{
    static const expect_row rows[] = {
        {"{sphere: 2, at: [1, 0, 0]}", BATTEN_OK,
         "objects 1;distance 2 1 0 0;area 50.26548245743669;exact"},
        {"{sphere: 2, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT, "'axis' is 0"},
        {"{ellipsoid: [3, 2, 1]}", BATTEN_OK, "box -3 -2 -1 3 2 1"},
        {"{ellipsoid: [3, 2, 1], at: [0, 0, 5], axis: x, from: z}", BATTEN_OK,
         "box -1 -2 2 1 2 8"},
        {"{ellipsoid: [3, 2, 1], from: z}", BATTEN_BAD_ARGUMENT, "'from' is parallel"},
        {"{cylinder: 2, height: 3}", BATTEN_OK,
         "along 2 0 0 0 0 0 1;box -2 -2 0 2 2 3;area 37.69911184307752"},
        {"{cylinder: 2, height: 3, at: [0, 1, 0], axis: y}", BATTEN_OK,
         "along 2 0 0 0 0 1 0;box -2 1 -2 2 4 2"},
        {"{cylinder: 2, height: 3, from: z}", BATTEN_BAD_ARGUMENT, "'from' is parallel"},
        /* The slanted side of a cone of radius 3 and height 4 is 5 long: pi 3 5. */
        {"{cone: 3, height: 4}", BATTEN_OK, "area 47.12388980384690;box -3 -3 0 3 3 4"},
        {"{cone: 4, top: 1, height: 4}", BATTEN_OK, "area 78.53981633974483;box -4 -4 0 4 4 4"},
        {"{cone: 3, height: 4, at: [1, 1, 1], axis: x}", BATTEN_OK, "box 1 -2 -2 5 4 4"},
        {"{cone: 3, height: 4, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT, "'axis' is 0"},
        {"{torus: 3, minor: 1, at: [0, 0, 2]}", BATTEN_OK,
         "area 118.43525281307229;box -4 -4 1 4 4 3"},
        {"{torus: 3, minor: 1, axis: y}", BATTEN_OK, "box -4 -1 -4 4 1 4"},
        {"{torus: 3, minor: 1, from: z}", BATTEN_BAD_ARGUMENT, "'from' is parallel"},
        {"{paraboloid: 2, height: 3}", BATTEN_OK, "box -2 -2 0 2 2 3"},
        {"{paraboloid: 2, b: 1, height: 3, at: [0, 0, 1]}", BATTEN_OK, "box -2 -1 1 2 1 4"},
        {"{paraboloid: 2, height: 3, axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT, "'axis' is 0"},
        /* The parameters follow the straight lines on it, each from one end to the other. */
        {"{hyperboloid: [2, 1, 3], heights: [0, 3]}", BATTEN_OK,
         "at 0 0 2 0 0;at 0.25 0 0 1 0;at 0 1 2 1 3;at 0.25 1 -2 1 3"},
        {"{hyperboloid: [2, 1, 3], heights: [-3, 3], axis: y, from: z}", BATTEN_OK,
         "at 0 0 -1 -3 2;at 0.25 1 1 3 -2"},
        {"{hyperboloid: [2, 1, 3], heights: [0, 3], axis: [0, 0, 0]}", BATTEN_BAD_ARGUMENT,
         "'axis' is 0"},
    };
    EXPECT(no_features, rows);
}

static const char rows_of_points[] =
    "  three: {points: [[0, 0, 1], [2, 0, 1], [2, 2, 1]]}\n"
    "  four: {points: [[0, 0], [3, 0], [3, 3], [6, 3]]}\n"
    "  net: {points: [[0, 0, 0], [1, 0, 1], [2, 0, 0], [0, 1, 0], [1, 1, 1], [2, 1, 0]], columns: 3}\n"
    "  square: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 4]], columns: 2}\n"
    "  uneven: {collect: [three, four]}\n"
    "  long: {points: [[0,0],[1,0],[2,0],[3,0],[4,0],[5,0],[6,0],[7,0],[8,0],[9,0],[10,0],[11,0],[12,0],[13,0],"
    "[14,0],[15,0],[16,0],[17,0],[18,0],[19,0],[20,0],[21,0],[22,0],[23,0],[24,0],[25,0],[26,0],[27,0],[28,0],"
    "[29,0],[30,0],[31,0],[32,0],[33,0]]}\n";

TEST(points_are_rows_and_polylines_pass_them)
{
    static const expect_row rows[] = {
        {"{points: [[1, 2], [3, 4, 5]]}", BATTEN_OK,
         "objects 1;named a;kind points;count 2;data 0 1 2 0;data 1 3 4 5"},
        {"{points: [[1, 0], [2, 0], [3, 0], [4, 0]], columns: 2}", BATTEN_OK,
         "objects 2;named row 1;count 2;data 0 1 0 0;data 1 2 0 0;object 1;named row 2;data 0 3 "
         "0 0;data 1 4 0 0"},
        {"{points: [[1, 0], [2, 0]], columns: 1}", BATTEN_OK, "objects 2;count 1"},
        {"{points: [[1, 0], [2, 0]], columns: 2}", BATTEN_OK, "objects 1;named a"},
        {"{points: [[1, 0], [2, 0]], columns: 0}", BATTEN_BAD_ARGUMENT,
         "2 points do not make whole rows of 0"},
        {"{points: [[1, 0], [2, 0], [3, 0]], columns: 2}", BATTEN_BAD_ARGUMENT,
         "3 points do not make whole rows of 2"},
        {"{polyline: [[0, 0, 1], [3, 4, 1], [3, 4, 8]]}", BATTEN_OK,
         "degree 1;count 3;length 12;control 0 0 0 1;control 1 3 4 1;control 2 3 4 8;exact"},
        {"{polyline: four}", BATTEN_OK, "degree 1;count 4;length 9;named a;at 1 6 3 0"},
        {"{polyline: [four, [1, 1]]}", BATTEN_BAD_ARGUMENT,
         "corner 2 is a point, and another is the feature 'four': give points alone or features alone"},
    };
    EXPECT(rows_of_points, rows);
}

TEST(bezier_and_b_spline_curves_follow_their_polygons)
{
    static const expect_row rows[] = {
        {"{bezier: four}", BATTEN_OK,
         "degree 3;count 4;rational 0;control 1 3 0 0;at 0.5 3 1.5 0;at 0 0 0 0;at 1 6 3 0"},
        {"{bezier: three}", BATTEN_OK, "degree 2;at 0.5 1.5 0.5 1"},
        {"{bezier: three, weights: [1, 3, 1]}", BATTEN_OK, "rational 1;at 0.5 1.75 0.25 1"},
        {"{bezier: three, weights: [1, 3]}", BATTEN_BAD_ARGUMENT, "2 weights for 3 corners"},
        {"{bezier: three, weights: [1]}", BATTEN_BAD_ARGUMENT, "1 weight for 3 corners"},
        {"{bezier: three, given: edges}", BATTEN_OK,
         "degree 2;count 3;control 0 0 0 1;control 1 2 0 2;control 2 4 2 3"},
        {"{bezier: long}", BATTEN_BAD_DEGREE,
         "a polygon of 34 corners gives degree 33; the highest is"},
        {"{b-spline: four}", BATTEN_OK,
         "degree 3;count 4;at 0 0 0 0;at 1 6 3 0;at 0.5 3 1.5 0"},
        {"{b-spline: four, degree: 1}", BATTEN_OK, "degree 1;length 9"},
        {"{b-spline: four, degree: 2, ends: closed}", BATTEN_OK, "degree 2;closed 1"},
        /* A free cubic begins at (P0 + 4 P1 + P2) / 6. */
        {"{b-spline: four, ends: free}", BATTEN_OK, "at 0 2.5 0.5 0;at 1 3.5 2.5 0"},
        {"{b-spline: four, ends: phantom}", BATTEN_OK, "at 0 0 0 0;at 1 6 3 0"},
        {"{b-spline: four, degree: 0}", BATTEN_BAD_DEGREE, "degree"},
    };
    EXPECT(rows_of_points, rows);
}

TEST(bezier_and_b_spline_surfaces_follow_their_nets)
{
    static const expect_row rows[] = {
        {"{bezier-surface: net}", BATTEN_OK,
         "degree 2 1;count 3 2;at 0.5 0.5 1 0.5 0.5;at 1 0 2 0 0;at 0 1 0 1 0;rational 0"},
        {"{bezier-surface: square}", BATTEN_OK, "degree 1 1;at 0.5 0.5 0.5 0.5 1"},
        /* A weight of 3 for the corner u = 1, v = 0: there x = 1 and y = 0 count threefold. */
        {"{bezier-surface: square, weights: [1, 3, 1, 1]}", BATTEN_OK,
         "rational 1;at 0.5 0 0.75 0 0;at 0 0.5 0 0.5 0;at 0.5 0.5 0.6666666666666666 "
         "0.3333333333333333 0.6666666666666666"},
        {"{bezier-surface: square, weights: [1, 1, 3, 1]}", BATTEN_OK,
         "at 0.5 0 0.5 0 0;at 0 0.5 0 0.75 0"},
        {"{bezier-surface: square, weights: [1, 1, 3]}", BATTEN_BAD_ARGUMENT,
         "3 weights for 4 points"},
        {"{bezier-surface: square, weights: [1]}", BATTEN_BAD_ARGUMENT,
         "1 weight for 4 points"},
        {"{bezier-surface: four}", BATTEN_BAD_DEGREE,
         "a net of 4 x 1 points gives the degrees 3 and 0; they must be in 1..25"},
        {"{bezier-surface: uneven}", BATTEN_NOT_COMPATIBLE, ""},
        {"{b-spline-surface: net, degree-u: 2, degree-v: 1}", BATTEN_OK,
         "degree 2 1;at 0.5 0.5 1 0.5 0.5"},
        {"{b-spline-surface: net, degree-u: 1, degree-v: 1}", BATTEN_OK,
         "degree 1 1;at 0.5 0.5 1 0.5 1"},
        {"{b-spline-surface: net, degree-u: 2, degree-v: 1, ends-u: free}", BATTEN_OK,
         "at 0 0 0.5 0 0.5;at 1 0 1.5 0 0.5"},
        {"{b-spline-surface: net, degree-u: 1, degree-v: 1, ends-v: closed}", BATTEN_OK,
         "at 0 0 0 0 0;at 0 1 0 0 0"},
    };
    EXPECT(rows_of_points, rows);
}

static const char triangular[] =
    "  flat: {points: [[0, 0, 1], [1, 0, 1], [0, 1, 1]]}\n"
    "  six: {points: [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1, 3], [0, 2]]}\n"
    "  two: {points: [[0, 0], [1, 0], [0, 1], [1, 0], [1, 1], [0, 1]]}\n"
    "  five: {points: [[0, 0], [1, 0], [0, 1], [1, 0], [1, 1]]}\n"
    "  lone: {points: [[0, 0]]}\n"
    "  both: {collect: [flat, flat]}\n";

TEST(bezier_triangles_follow_their_nets)
{
    static const expect_row rows[] = {
        {"{bezier-triangle: flat}", BATTEN_OK,
         "objects 1;degree 1;count 1;on 0 0 1 1;at 0 0 0 0 1;at 1 0 1 0 1;at 0 1 0 1 1"},
        /* The middle of the side from (2, 0) to (0, 2), bent up by 2/4 of 3. */
        {"{bezier-triangle: six}", BATTEN_OK,
         "degree 2;count 1;at 0.5 0.5 1 1 1.5;at 0.5 0 1 0 0"},
        {"{bezier-triangle: six, weights: [1, 1, 1, 1, 3, 1]}", BATTEN_OK,
         "at 0.5 0.5 1 1 2.25"},
        {"{bezier-triangle: six, weights: [1, 1, 1, 1, 3]}", BATTEN_BAD_ARGUMENT,
         "5 weights for 6 points"},
        {"{bezier-triangle: six, weights: [1]}", BATTEN_BAD_ARGUMENT, "1 weight for 6 points"},
        {"{bezier-triangle: two, degree: 1}", BATTEN_OK, "degree 1;count 2"},
        {"{bezier-triangle: both, degree: 1}", BATTEN_OK, "degree 1;count 2;on 0 0 1 1"},
        {"{bezier-triangle: flat, halve: 1}", BATTEN_OK, "count 4;on 0 0 1 1"},
        {"{bezier-triangle: six, halve: 1}", BATTEN_OK, "degree 2;count 4;box 0 0 0 2 2 1.5"},
        {"{bezier-triangle: flat, halve: 2}", BATTEN_OK, "count 16"},
        {"{bezier-triangle: five}", BATTEN_BAD_ARGUMENT,
         "5 points do not make a triangular net, which has 3, 6, 10, 15"},
        {"{bezier-triangle: lone}", BATTEN_BAD_ARGUMENT,
         "1 point does not make a triangular net"},
        {"{bezier-triangle: five, degree: 1}", BATTEN_BAD_ARGUMENT,
         "5 points do not make whole nets of degree 1, which have 3 each"},
        {"{bezier-triangle: five, degree: 2}", BATTEN_BAD_ARGUMENT,
         "5 points do not make whole nets of degree 2, which have 6 each"},
        {"{bezier-triangle: five, degree: 0}", BATTEN_BAD_DEGREE,
         "the degree is 0; it must be in 1.."},
        {"{bezier-triangle: five, degree: 1000}", BATTEN_BAD_DEGREE,
         "the degree is 1000; it must be in 1.."},
    };
    EXPECT(triangular, rows);
}

static const char curves[] =
    "  bow: {bezier: ducks}\n"
    "  tie: {points: [[0, 0], [3, 2], [-2, 2], [1, 0]]}\n  knot: {bezier: tie}\n"
    "  ducks: {points: [[0, 0, 3], [1, 2, 3], [2, 0, 3]]}\n"
    "  bows: {points: [[5, 0, 0], [5, 1, 2], [5, 2, 0]]}\n"
    "  upright: {bezier: bows}\n"
    "  skew: {polyline: [[0, 0, 0], [2, 0, 4], [2, 1, 4]]}\n"
    "  slanted: {polyline: [[1, 1, 0], [3, 3, 0], [2, 4, 0], [0, 2, 0]]}\n"
    "  straight: {line: [[0, 0, 0], [1, 1, 0]]}\n"
    "  thin: {polyline: [[0, 0, 0], [2, 1, 0], [2, 0, 4]]}\n"
    "  thick: {polyline: [[2, 0, 0], [3, 4, 0], [2, 0, 3]]}\n"
    "  slab: {polyline: [[0, 0, 0], [3, 4, 1]]}\n  cube: {line: [[0, 0, 0], [1, 1, 1]]}\n"
    "  lines: {collect: [bow, skew]}\n";

TEST(boxes_just_hold_their_curves)
{
    static const expect_row rows[] = {
        /* Flat curves have one rim; the parabola is half as high as its polygon. */
        {"{box: bow}", BATTEN_OK,
         "objects 1;named a;layer ;box 0 0 3 2 1 3;degree 1;count 5;closed 1;length 6"},
        {"{box: upright}", BATTEN_OK, "objects 1;box 5 0 0 5 2 1;length 6"},
        /* Two rims and four edges between them: each edge goes from the lower rim to the upper. */
        {"{box: skew}", BATTEN_OK,
         "objects 6;box 0 0 0 2 1 4;object 0;length 12;closed 1;object 1;length 12;closed 1;object "
         "2;count 2;length 1;object 3;length 1;object 4;length 1;object 5;length 1"},
        {"{box: skew, axes: turned, within: 0.0001}", BATTEN_OK, "objects 1;on -2 0 1 0"},
        {"{box: slanted, axes: turned}", BATTEN_OK,
         "objects 1;within 1e-7;length 8.485281374238570;closed 1"},
        /* Thinnest across, along y, and along z: the rims lie across the thin side. */
        {"{box: thin}", BATTEN_OK, "objects 6;length 12;on 0 1 0 0;object 1;on 0 1 0 1"},
        {"{box: thick}", BATTEN_OK, "objects 6;length 14;on 1 0 0 2;object 1;on 1 0 0 3"},
        {"{box: slab}", BATTEN_OK, "objects 6;length 14;on 0 0 1 0;object 1;on 0 0 1 1"},
        {"{box: cube}", BATTEN_OK, "objects 6;length 4;on 0 0 1 0;object 1;on 0 0 1 1"},
        {"{box: straight}", BATTEN_OK, "objects 1;on 0 0 1 0;length 4"},
        {"{box: lines}", BATTEN_OK, "objects 7;named box of bow;object 1;named box of skew"},
        {"{box: straight, axes: turned}", BATTEN_COINCIDENT, "is straight: its box is a line"},
        {"{box: bow, axes: turned, within: 0}", BATTEN_BAD_ARGUMENT, ""},
        {"{box: ducks}", BATTEN_BAD_ARGUMENT, "curves are needed, and 'ducks' has none"},
    };
    EXPECT(curves, rows);
}

TEST(equations_of_curves_are_traced_in_their_planes)
{
    static const expect_row rows[] = {
        /* y = x (2 - x): the whole parabola within half the size around the arc. */
        {"{implicit: bow, within: 1e-6}", BATTEN_OK,
         "objects 1;on 0 0 1 3;error 1e-9;degree 1"},
        {"{implicit: knot, beyond: 0}", BATTEN_OK,
         "objects 2;object 1;named singular points of knot;data 0 0.5 0.375 0"},
        {"{implicit: upright}", BATTEN_OK, "on 1 0 0 5"},
        {"{implicit: straight, beyond: 1, cells: 4}", BATTEN_OK,
         "on 1 -1 0 0;box -1 -1 0 2 2 0"},
        {"{implicit: skew}", BATTEN_NOT_COMPATIBLE, "plane"},
        {"{implicit: bow, cells: 0}", BATTEN_BAD_ARGUMENT, "cells"},
        {"{implicit: ducks}", BATTEN_BAD_ARGUMENT, "curves are needed, and 'ducks' has none"},
    };
    EXPECT(curves, rows);
}
