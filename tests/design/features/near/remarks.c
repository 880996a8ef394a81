#include "design/expect.h"

/* The figures that features near points report, each known beforehand. */

static const char data[] =
    "  row: {points: [[0, 0], [1, 0], [3, 0]]}\n"
    "  pair: {points: [[0, 0], [1, 0]]}\n"
    "  ring: {points: [[6, 2, 3], [4, 2, 7], [1, 2, 8], [-2, 2, 7]]}\n"
    "  square: {polyline: [[0, 0], [1, 0], [1, 1]]}\n"
    "  bent: {polyline: [[0, 0], [1, 0], [2, 1]]}\n"
    "  degree: {polyline: [[0, 0], [1, 0], [1.9998476951563913, 0.01745240643728351]]}\n"
    "  quarter: {arc: 2, angle: 90 deg}\n"
    /* Of curvature 0.5 + s, s from 0 to 2. */
    "  spiral: {points: [[0, 0], [0.4901704417553, 0.082435272261], [0.8767747088654, "
    "0.3865463465889], [0.9512358084283, 0.864967309909], [0.5965461533162, 1.1794458901472]]}\n"
    "  oval: {points: [[1, 5, 5], [1, 3.2, 4.6], [1, 2, 3], [1, 3.2, 1.4], [1, 5, 1]]}\n"
    "  turned: {points: [[1, 5, 1], [1, 3.2, 1.4], [1, 2, 3], [1, 3.2, 4.6], [1, 5, 5]]}\n"
    "  line: {line: [[0, 0], [3, 4]]}\n"
    "  fold: {points: [[0, 0], [1, 0], [0.2, 0.4], [1, 0.5]]}\n"
    "  few: {points: [[0, 0], [1, 2]]}\n"
    "  loops: {points: [[0, 0], [1, 0], [0.5, 0.001], [1.5, 0], [1, 0.001], [2, 0]]}\n"
    "  big: {points: [[3, 4], [-3, 4], [-4, -3]]}\n";

/* Curvatures 2 sin(phi - theta) / l of the chords, and their derivatives 2 cos(phi - theta) / l. */
static const expect_row of_arcs[] = {
    {"{sequential-arcs: row, start-angle: 45 deg}", BATTEN_OK,
     "notes 'row' begins at 45 degrees; notes each degree more changes the curvature of arc 1 by "
     "0.0246827, and swings on to the end; notes curvature jumps by 2.12132 at most;"
     "heads 0 0.7071067811865476 0.7071067811865476 0"},
    {"{sequential-arcs: row, start-angle: 1 deg}", BATTEN_OK, "notes begins at 1 degree;"},
    {"{sequential-arcs: row, start-angle: 120 deg}", BATTEN_OK,
     "notes 'row' has 2 arcs turning by more than 180 degrees"},
    {"{sequential-arcs: pair, start-angle: 120 deg}", BATTEN_OK,
     "notes 'pair' has 1 arc turning by more than 180 degrees"},
    {"{sequential-arcs: row, start-angle: 45 deg}", BATTEN_OK, "lacks more than 180 degrees"},
    {"{biarcs: loops}", BATTEN_OK, "notes 'loops' has 4 arcs turning by more than 180 degrees"},
    {"{biarcs: row}", BATTEN_OK, "silent"},
    {"{biarcs: ring}", BATTEN_OK, "silent"},
    {"{arcs: square, within: 0.001}", BATTEN_OK,
     "notes 'square': 0 arcs and 2 lines, 0 beside it to the left and ; notes least "
     "radius inf, largest corner 90 degrees"},
    {"{arcs: bent, within: 0.001, joined: plain}", BATTEN_OK,
     "notes largest corner 45 degrees"},
    {"{arcs: degree, within: 1e-9, joined: plain}", BATTEN_OK,
     "notes largest corner 1 degree;"},
    {"{arcs: quarter, within: 0.001}", BATTEN_OK,
     "notes 1 arc and 0 lines; notes least radius 2, largest corner 0 degrees"},
    {"{arcs: line, within: 0.001}", BATTEN_OK, "notes 0 arcs and 1 line,; length 5"},
};

static const expect_row of_primitives[] = {
    {"{fit-circle: ring}", BATTEN_OK, "notes 'ring': a circle of radius 5 about [1, 2, 3]"},
    {"{fit-clothoid: spiral}", BATTEN_OK,
     "notes 'spiral': a clothoid of length 2, curvature 0.5 to 2.5; domain 0 2; bends 0 0.5; bends "
     "1 2.5; error 1e-6"},
    {"{fit-ellipse: oval, whole: no}", BATTEN_OK,
     "notes 'oval': an ellipse with the semi-axes ; at 0 1 5 5; at 1 1 5 1; domain 0 1; on 1 0 0 1; "
     "error 1e-9"},
    {"{fit-ellipse: turned, whole: no}", BATTEN_OK, "at 0 1 5 1; at 1 1 5 5; domain 0 1"},
};

static const expect_row of_simpler[] = {
    {"{approximate: line, within: 0.001}", BATTEN_OK,
     "notes 'line': 4 control points instead of 2; error 1e-12; on 4 -3 0 0; length 5"},
    {"{approximate: line, within: 0.001, degree: 1}", BATTEN_OK,
     "notes 'line': 2 control points instead of 2"},
    {"{fit-within: few, within: 0.001, degree: 1}", BATTEN_OK,
     "notes 'few': 2 control points for 2 points, 0 corners; notes between points the curve is up "
     "to 0 from their polygon"},
    {"{fit-within: row, within: 0.001, degree: 1, corners: [2]}", BATTEN_OK,
     "notes 'row': 3 control points for 3 points, 1 corner"},
    {"{thin-points: row, within: 0.001}", BATTEN_OK, "notes 'row': 2 of 3 points stay"},
    {"{thin-points: [row, pair], within: 0.001, each: line}", BATTEN_OK,
     "objects 2; object 1; named pair"},
};

static const char marks[] =
    "  far: {points: [[0, 0], [1, 0], [2, 0], [3, 5], [4, 0], [5, 0], [6, "
    "-4], [7, 0], [8, 0]]}\n"
    "  line: {points: [[0, 0], [1, 0], [2, 0], [3, 0]]}\n"
    "  twice: {elevate: bow, by: 2}\n  bow: {bezier: line}\n"
    "  steps: {points: [[0, 0], [1, 3], [2, 2], [3, 5]]}\n";

static const expect_row of_marks[] = {
    /* The row is that of y = 0 but for points 4 and 7, which Tukey leaves out altogether. */
    {"{least-squares: far, points: 2, degree: 1, robust: tukey, as: function}", BATTEN_OK,
     "notes 'far': 2 of 9 points are outliers, farther than ; notes five times the median distance: "
     "4, 7;within 1e-6;on 0 1 0 0"},
    {"{least-squares: far, points: 2, degree: 1, as: function}", BATTEN_OK, "silent"},
    {"{smooth: steps, as: function, rms: 1}", BATTEN_OK, "silent"},
    {"{smooth: far, as: function}", BATTEN_OK, "notes 'far': cross validation chose lambda "},
    {"{fit-ellipse: steps}", BATTEN_TOO_FEW_POINTS, "no row has 5 points"},
};

TEST(outliers_are_listed_from_1_and_only_when_they_are_left_out)
{
    EXPECT(marks, of_marks);
}

TEST(arcs_remark_their_number_radius_and_corners)
{
    EXPECT(data, of_arcs);
}

TEST(primitives_remark_their_measures)
{
    EXPECT(data, of_primitives);
}

TEST(simpler_curves_remark_how_many_control_points_they_have)
{
    EXPECT(data, of_simpler);
}
