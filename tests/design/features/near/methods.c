#include "design/expect.h"

/* Curves near points, and simpler curves near curves: what they reproduce, and the distance that they report. */

static const char data[] =
    "  straight: {points: [[0, 1], [1, 3], [2, 5], [3, 7], [4, 9], [5, 11]]}\n"
    "  upright: {points: [[7, 0, 1], [7, 1, 3], [7, 2, 5], [7, 3, 7], [7, 4, 9], [7, 5, 11]]}\n"
    "  zigzag: {points: [[0, 0], [1, 1], [2, 0], [3, 1], [4, 0], [5, 1], [6, 0], [7, 1], [8, 0]]}\n"
    "  square: {points: [[-2, 4], [-1, 1], [0, 0], [1, 1], [2, 4], [3, 9]]}\n"
    "  cube: {points: [[-2, -8], [-1, -1], [0, 0], [1, 1], [2, 8], [3, 27]]}\n"
    "  round: {points: [[5, 0], [4, 3], [3, 4], [0, 5], [-3, 4], [-4, 3]]}\n"
    "  ring: {points: [[5, 0], [4, 3], [0, 5], [-4, 3], [-5, 0], [-4, -3], [0, -5], [4, -3]]}\n"
    "  oval: {points: [[6, 0], [4.8, 1.8], [3.6, 2.4], [0, 3], [-3.6, 2.4], [-4.8, 1.8]]}\n"
    "  tilted: {points: [[0, 5, 0], [0, 4, 3], [0, 3, 4], [0, 0, 5]]}\n"
    "  twisted: {points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1], [2, 3, 1], [5, 5, 5]]}\n"
    "  pair: {points: [[0, 0], [3, 4]]}\n"
    "  lone: {points: [[0, 0]]}\n"
    "  bow: {bezier: square}\n"
    "  arc: {arc: 2, angle: 90 deg}\n"
    "  chain: {arc-spline: round, ends: circular}\n"
    "  corner: {polyline: [[0, 0], [1, 0], [2, 0.001], [3, 0], [4, 0], [4, 3]]}\n"
    "  net: {points: [[0, 0], [1, 0], [0, 1], [1, 1]], columns: 2}\n"
    "  sheet: {bezier-surface: net}\n"
    "  thick: {elevate: sheet, by: 2}\n"
    "  thickv: {elevate: sheet, by: 2, direction: v}\n"
    "  lines: {collect: [arc, bow]}\n"
    "  mixed: {collect: [arc, square]}\n";

TEST(every_method_keeps_points_of_a_line_on_it_in_space_and_as_functions)
{
    static const struct {
        const char *name, *more;
    } methods[] = {{"least-squares", ""},     {"p-spline", ", lambda: 1"},
                   {"smooth", ", lambda: 1"}, {"schoenberg", ""},
                   {"quasi-interpolant", ""}, {"fit-within", ", within: 0.01"}};
    for (int i = 0; i < COUNT(methods); i++) {
        static const struct {
            const char *input, *facts;
            batten_status status;
        } cases[] = {
            {"straight",
             "objects 1;named a;kind curve;within 1e-8;on -2 1 0 1;on 0 0 1 0;error 1e-8;data 1 1 3 0",
             BATTEN_OK},
            {"upright", "within 1e-8;on 1 0 0 7;on 0 -2 1 1;error 1e-8", BATTEN_OK},
            {"straight, as: function", "within 1e-8;on -2 1 0 1;domain 0 5;error 1e-8",
             BATTEN_OK},
            {"twisted", "objects 1", BATTEN_OK},
            {"ring, closed: yes", "closed 1", BATTEN_OK},
            {"ring", "closed 0", BATTEN_OK},
            {"ring, as: function", "a function needs rising abscissae", BATTEN_NOT_INCREASING},
            {"lone", "no row has 2 points", BATTEN_TOO_FEW_POINTS},
        };
        for (int k = 0; k < COUNT(cases); k++) {
            char feature[200];
            snprintf(feature, sizeof feature, "{%s: %s%s}", methods[i].name, cases[k].input,
                     methods[i].more);
            expect_rows(data, &(expect_row){feature, cases[k].status, cases[k].facts}, 1);
        }
    }
}

static const expect_row of_polynomials[] = {
    {"{least-squares: cube, as: function, points: 4}", BATTEN_OK,
     "degree 3;count 4;at 0.5 0.5 0.125 0;error 1e-9"},
    {"{least-squares: square, as: function, points: 3, degree: 2}", BATTEN_OK,
     "degree 2;count 3;at 0.5 0.5 0.25 0"},
    {"{least-squares: straight, points: 2, degree: 1}", BATTEN_OK,
     "degree 1;count 2;at 0 0 1 0;at 1 5 11 0"},
    {"{least-squares: zigzag, degree: 1, points: 2, as: function, hold-ends: no}", BATTEN_OK,
     "at 0 0 0.4444444444444444 0;at 1 8 0.4444444444444444 0"},
    {"{least-squares: zigzag, degree: 1, points: 2, as: function}", BATTEN_OK,
     "at 0 0 0 0;at 1 8 0 0"},
    {"{least-squares: zigzag, degree: 1, points: 2, as: function, hold-ends: no, weights: [0, 1, 0, 1, 0, 1, 0, 1, 0]}",
     BATTEN_OK, "on 0 1 0 1"},
    {"{least-squares: zigzag, weights: [1, 2]}", BATTEN_BAD_ARGUMENT,
     "'weights' has 2 numbers for 9 points"},
    {"{least-squares: zigzag, degree: 0}", BATTEN_BAD_DEGREE, "zigzag: "},
    {"{least-squares: zigzag, as: function, closed: yes}", BATTEN_BAD_ARGUMENT,
     "a function cannot be closed"},
    {"{least-squares: ring, closed: yes}", BATTEN_OK, "closed 1"},
    {"{minimax: square, degree: 2}", BATTEN_OK, "at 0.5 0.5 0.25 0;error 1e-9;passes"},
    /* Of 0 and 1 in turn the best line lies in the middle, half away from all. */
    {"{minimax: zigzag, degree: 1}", BATTEN_OK, "at 0 0 0.5 0;at 1 8 0.5 0;error 0.5"},
    {"{minimax: zigzag, degree: 0}", BATTEN_OK, "on 0 1 0 0.5;error 0.5"},
    {"{minimax: pair, degree: 3}", BATTEN_TOO_FEW_POINTS, "pair: "},
    {"{minimax: round}", BATTEN_NOT_INCREASING, "rising abscissae"},
    {"{schoenberg: straight, as: function, degree: 1}", BATTEN_OK, "degree 1;on -2 1 0 1"},
    /* Bernstein's polynomial of degree n raises x^2 by x (1 - x) / n of the interval: 25 / 5 / 4. */
    {"{schoenberg: square, as: function, knots: none, degree: 5}", BATTEN_OK,
     "at 0.5 0.5 1.5 0;degree 5"},
    {"{schoenberg: zigzag, degree: 1}", BATTEN_OK,
     "degree 1;error 1e-9;length 11.313708498984761"},
    {"{quasi-interpolant: cube, as: function}", BATTEN_OK,
     "degree 3;within 1e-7;at 0.5 0.5 0.125 0"},
    {"{quasi-interpolant: straight, degree: 2}", BATTEN_OK, "degree 2;on -2 1 0 1"},
    {"{quasi-interpolant: zigzag, as: function, closed: yes}", BATTEN_BAD_ARGUMENT,
     "a function cannot be closed"},
    {"{p-spline: square, lambda: 1e-9, spans: 5, degree: 2}", BATTEN_OK, "degree 2;count 7"},
    {"{p-spline: zigzag, lambda: 1e9, order: 1, as: function}", BATTEN_OK,
     "within 1e-3;on 0 1 0 0.4444444444444444"},
    {"{p-spline: zigzag, rms: 0.25, as: function}", BATTEN_OK, "error 1"},
    {"{p-spline: zigzag, rms: 0.1, lambda: 1}", BATTEN_BAD_ARGUMENT, "'lambda'"},
    {"{smooth: zigzag, lambda: 1e9, as: function}", BATTEN_OK,
     "within 1e-3;at 0 0 0.4444444444444444 0;at 1 8 0.4444444444444444 0"},
    {"{smooth: zigzag, lambda: 1e9, order: 1, as: function}", BATTEN_OK,
     "within 1e-3;on 0 1 0 0.4444444444444444"},
    {"{smooth: zigzag, rms: 0.1, lambda: 1}", BATTEN_BAD_ARGUMENT, "'lambda'"},
    {"{fit-within: zigzag, within: 0.001}", BATTEN_OK,
     "error 0.001;notes control points for 9 points, 0 corners"},
    {"{fit-within: zigzag, within: 1}", BATTEN_OK, "error 1"},
    {"{fit-within: zigzag, within: 0.001, degree: 1}", BATTEN_OK,
     "degree 1;within 1e-3;length 11.313708498984761"},
    {"{fit-within: zigzag, within: 0.001, corner: 30 deg}", BATTEN_OK,
     "within 1e-6;length 11.313708498984761;notes 7 corners"},
    {"{fit-within: zigzag, within: 0.001, corners: [2, 3, 4, 5, 6, 7, 8]}", BATTEN_OK,
     "within 1e-6;length 11.313708498984761"},
    {"{fit-within: zigzag, within: 0.001, by: bezier}", BATTEN_OK, "degree 3;error 0.001"},
    {"{fit-within: zigzag, within: 0.001, by: insert}", BATTEN_OK, "error 0.001"},
    {"{fit-within: zigzag, within: 0.001, by: remove}", BATTEN_OK, "error 0.001"},
    {"{fit-within: zigzag, within: 0}", BATTEN_BAD_ARGUMENT, "zigzag: "},
};

TEST(polynomials_come_back_when_the_degree_allows)
{
    EXPECT(data, of_polynomials);
}

TEST(fitted_lines_circles_ellipses_and_clothoids_are_those_of_their_points)
{
    static const expect_row rows[] = {
        {"{fit-line: straight}", BATTEN_OK,
         "degree 1;at 0 0 1 0;at 1 5 11 0;passes;error 1e-9"},
        {"{fit-line: pair}", BATTEN_OK, "length 5;passes"},
        {"{fit-line: lone}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
        {"{fit-circle: round}", BATTEN_OK,
         "closed 1;within 1e-8;distance 5 0 0 0;notes a circle of radius 5 about [;error 1e-8"},
        {"{fit-circle: round, whole: no}", BATTEN_OK,
         "closed 0;within 1e-8;distance 5 0 0 0;length 12.490457723982544;at 0 5 0 0"},
        {"{fit-circle: round, by: taubin}", BATTEN_OK, "within 1e-8;distance 5 0 0 0"},
        {"{fit-circle: round, by: kasa}", BATTEN_OK, "within 1e-8;distance 5 0 0 0"},
        {"{fit-circle: tilted}", BATTEN_OK, "within 1e-8;distance 5 0 0 0;on 1 0 0 0"},
        {"{fit-circle: pair}", BATTEN_TOO_FEW_POINTS, "no row has 3 points"},
        {"{fit-ellipse: oval}", BATTEN_OK,
         "closed 1;within 1e-6;notes an ellipse with the semi-axes 6 and 3;box -6 -3 0 6 3 0"},
        {"{fit-ellipse: oval, whole: no}", BATTEN_OK,
         "closed 0;within 1e-6;at 0 6 0 0;at 1 -4.8 1.8 0"},
        {"{fit-ellipse: tilted}", BATTEN_TOO_FEW_POINTS, "no row has 5 points"},
        {"{fit-ellipse: twisted}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
        {"{fit-clothoid: round}", BATTEN_OK,
         "spans 1;within 1e-6;distance 5 0 0 0;notes a clothoid of length 12.49"},
        {"{fit-clothoid: straight}", BATTEN_OK, "spans 1;within 1e-6;on -2 1 0 1"},
        {"{fit-clothoid: tilted}", BATTEN_OK, "spans 1;on 1 0 0 0"},
        {"{fit-clothoid: pair}", BATTEN_TOO_FEW_POINTS, "no row has 4 points"},
    };
    EXPECT(data, rows);
}

TEST(arcs_keep_circles_and_their_bounds)
{
    static const expect_row rows[] = {
        {"{biarcs: round}", BATTEN_OK, "passes;within 1e-6;distance 5 0 0 0"},
        {"{biarcs: ring, closed: yes}", BATTEN_OK, "closed 1;within 1e-6;distance 5 0 0 0"},
        {"{biarcs: zigzag, joint: given, place: 0.25}", BATTEN_OK, "passes"},
        {"{biarcs: zigzag, joint: given, place: 2}", BATTEN_BAD_ARGUMENT, "zigzag: "},
        {"{biarcs: zigzag, joint: equal-chord}", BATTEN_OK, "passes"},
        {"{biarcs: twisted, in: space}", BATTEN_OK, "passes;spans 0"},
        {"{biarcs: twisted}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
        {"{biarcs: pair}", BATTEN_OK, "within 1e-6;length 5"},
        {"{biarcs: lone}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
        {"{sequential-arcs: round}", BATTEN_OK,
         "passes;within 1e-5;distance 5 0 0 0;notes curvature jumps by"},
        {"{sequential-arcs: round, start-angle: 90 deg}", BATTEN_OK,
         "within 1e-6;distance 5 0 0 0;notes begins at 90 degrees"},
        {"{sequential-arcs: straight, start-angle: 90 deg}", BATTEN_OK, "passes;heads 0 0 1 0"},
        {"{sequential-arcs: lone}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
        {"{arcs: arc, within: 0.001}", BATTEN_OK,
         "spans 1;within 1e-3;distance 2 0 0 0;notes 1 arc and 0 lines"},
        {"{arcs: bow, within: 0.01}", BATTEN_OK, "named a;error 0.01;notes least radius"},
        {"{arcs: bow, within: 0.01, joined: biarcs}", BATTEN_OK, "error 0.01"},
        {"{arcs: bow, within: 0.01, most: 1}", BATTEN_TOLERANCE_NOT_MET, "bow: "},
        {"{arcs: lines, within: 0.01}", BATTEN_OK, "objects 2;named arc;object 1;named bow"},
        {"{arcs: round, within: 0.01}", BATTEN_OK,
         "within 0.01;distance 5 0 0 0;error 0.01;notes 1 arc"},
        {"{arcs: ring, within: 0.01, closed: yes}", BATTEN_OK,
         "closed 1;within 0.01;distance 5 0 0 0"},
        {"{arcs: tilted, within: 0.01}", BATTEN_OK, "on 1 0 0 0;within 0.01;distance 5 0 0 0"},
        {"{arcs: mixed, within: 0.01}", BATTEN_NOT_COMPATIBLE,
         "'square' is not a curve, as the others are"},
        {"{arcs: lone, within: 0.01}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
    };
    EXPECT(data, rows);
}

TEST(curves_become_simpler_within_a_distance_that_is_reported)
{
    static const expect_row rows[] = {
        {"{approximate: arc, within: 0.001}", BATTEN_OK,
         "rational 0;degree 3;within 1e-3;distance 2 0 0 0;error 0.001;notes instead of 3"},
        {"{approximate: arc, within: 0.001, degree: 5}", BATTEN_OK, "degree 5;error 0.001"},
        {"{approximate: chain, within: 0.001}", BATTEN_OK,
         "spans 0;within 1e-3;distance 5 0 0 0;error 0.001"},
        {"{approximate: lines, within: 0.1}", BATTEN_OK,
         "objects 2;named arc;object 1;named bow"},
        {"{approximate: arc, within: 0}", BATTEN_BAD_ARGUMENT, "arc: "},
        {"{approximate: ring, within: 1}", BATTEN_BAD_ARGUMENT, "ring"},
        {"{reduce: thick, degree: 1, within: 0.001}", BATTEN_OK, "degree 1 1;error 1e-9"},
        {"{reduce: thickv, degree: 1, within: 0.001, direction: v}", BATTEN_OK,
         "degree 1 1;error 1e-9"},
        {"{reduce: bow, degree: 1, within: 0.001}", BATTEN_TOLERANCE_NOT_MET, ""},
        {"{remove-knots: corner, within: 0.01}", BATTEN_OK, "degree 1;at 1 4 3 0;error 0.01"},
        {"{remove-knots: bow, within: 0.01}", BATTEN_OK, "count 6;error 1e-9"},
        {"{thin-points: straight, within: 0.001}", BATTEN_OK,
         "kind points;count 2;data 0 0 1 0;data 1 5 11 0;error 1e-9;notes 2 of 6 points stay"},
        {"{thin-points: zigzag, within: 0.1}", BATTEN_OK, "count 9"},
        {"{thin-points: zigzag, within: 1.5}", BATTEN_OK, "count 2;data 1 8 0 0"},
        {"{thin-points: ring, within: 0.1, closed: yes}", BATTEN_OK, "count 8"},
        {"{thin-points: corner, within: 0.01}", BATTEN_OK,
         "kind curve;count 3;control 1 4 0 0;control 2 4 3 0;error 0.001"},
        {"{thin-points: arc, within: 0.01}", BATTEN_NOT_COMPATIBLE,
         "'arc' is not a polyline; simplify curves with 'remove-knots'"},
        {"{thin-points: zigzag, within: -1}", BATTEN_BAD_ARGUMENT, "zigzag: "},
        {"{thin-points: sheet, within: 1}", BATTEN_BAD_ARGUMENT, "sheet"},
    };
    EXPECT(data, rows);
}
