#include "design/expect.h"

/* Folding and fairing as features. */

static const char creases[] = "  bow: {arc: 2, angle: 90 deg}\n"
                              "  line: {line: [[0, 0], [4, 0]]}\n"
                              "  two: {collect: [bow, line]}\n";

/* A crease of curvature k, folded by an angle t, has the curvature k cos t in the flat sheet: for 60 degrees a
 * circle of radius 4. The angle is constant and the crease plane: rulings are at right angles to it. */
TEST(a_folded_sheet_has_the_area_of_the_flat_one)
{
    static const expect_row rows[] = {
        {"{fold: bow, angle: 60 deg, left: 0.5, right: 1}", BATTEN_OK,
         "objects 3;kind surface;named a left;within 1e-3;area 1.4726215563702155;object 1;named a "
         "right;area 3.5342917352885173;object 2;kind curve;distance 2 0 0 0;error 0.001;notes samples along 3.14159"},
        {"{fold: bow, angle: 60 deg, left: 0.5}", BATTEN_OK,
         "within 1e-3;object 1;area 1.6689710972195777;notes (left)"},
        {"{fold: bow, flat-curvature: 0.25, left: 0.5, within: 1e-5}", BATTEN_OK,
         "within 1e-4;area 1.4726215563702155;error 1e-5"},
        /* The flat crease of radius 2 becomes one of radius 1, of the same length. */
        {"{fold: bow, angle: 60 deg, crease: flat, left: 0.5, right: 1}", BATTEN_OK,
         "within 1e-3;area 1.3744467859455345;object 1;area 3.9269908169872414;object 2;bends 0.5 1;length "
         "3.141592653589793"},
        {"{fold: bow, left: 0.5}", BATTEN_BAD_ARGUMENT,
         "either 'angle' or 'flat-curvature' must be given"},
        {"{fold: bow, angle: 60 deg, flat-curvature: 0.25, left: 0.5}", BATTEN_BAD_ARGUMENT,
         "either 'angle' or 'flat-curvature' must be given"},
        {"{fold: bow, flat-curvature: 0.25, crease: flat, left: 0.5}", BATTEN_BAD_ARGUMENT,
         "a flat crease needs 'angle'"},
        {"{fold: two, angle: 60 deg, left: 0.5}", BATTEN_BAD_ARGUMENT,
         "a sheet is folded along one curve, not 2"},
    };
    EXPECT(creases, rows);
}

TEST(a_crease_pattern_is_cut_and_folded_by_its_layers)
{
    static const expect_row rows[] = {
        {"{crease-pattern: bow, angle: 60 deg, left: 0.5, right: 1, rulings: 3}", BATTEN_OK,
         "objects 8;named outline;layer cut;closed 1;on 0 0 1 0;within 1e-3;length "
         "9.675884388738817;object 1;named crease;layer mountain;bends 0.5 0.25;length 3.141592653589793;object "
         "2;layer rulings;length 0.5;object 4;length 0.5;object 5;length 1;object 7;length 1"},
        {"{crease-pattern: bow, angle: -60 deg, left: 0.5}", BATTEN_OK,
         "objects 50;object 1;layer valley"},
        {"{crease-pattern: bow, angle: 60 deg, left: 0.5, rulings: 0}", BATTEN_OK, "objects 2"},
        {"{crease-pattern: bow, angle: 60 deg, left: 0.5, rulings: 1001}", BATTEN_BAD_ARGUMENT,
         "1001 rulings; there may be 0 to 1000"},
        {"{crease-pattern: two, angle: 60 deg, left: 0.5}", BATTEN_BAD_ARGUMENT,
         "along one curve, not 2"},
    };
    EXPECT(creases, rows);
}

static const char ducks[] =
    "  straight: {points: [[0, 0, 1], [1, 0, 1], [2, 0, 1], [3, 0, 1], [4, 0, 1], [5, 0, 1], [6, 0, 1]]}\n"
    "  bumped: {points: [[0, 0, 1], [1, 0, 1], [2, 0, 1], [3, 0.01, 1], [4, 0, 1], [5, 0, 1], [6, 0, 1]]}\n"
    /* A half wave with one point 0.3 too high. */
    "  blunder: {points: [[0, 0.0], [1, 0.625738], [2, 1.236068], [3, 1.815962], [4, 2.351141], [5, 2.828427], [6, 3.236068], [7, 3.564026], [8, 3.804226], [9, 4.250753]"
    ", [10, 4.0], [11, 3.950753], [12, 3.804226], [13, 3.564026], [14, 3.236068], [15, 2.828427], [16, 2.351141], [17, 1.815962], [18, 1.236068], [19, 0.625738], [20, 0.0]]}\n"
    "  upright: {points: [[2, 0, 0], [2, 1, 0], [2, 2, 0], [2, 3, 0.01], [2, 4, 0], [2, 5, 0], [2, 6, 0]]}\n"
    "  short: {points: [[0, 0], [1, 1]]}\n"
    "  lone: {points: [[0, 0]]}\n"
    "  made: {interpolate: bumped, degree: 2}\n"
    "  few: {interpolate: short}\n"
    "  both: {collect: [straight, made]}\n"
    "  drawn: {line: [[0, 0], [1, 1]]}\n"
    "  ball: {sphere: 1}\n";

TEST(fairing_moves_points_no_farther_than_allowed)
{
    static const expect_row rows[] = {
        {"{fair: straight, within: 0.1}", BATTEN_OK,
         "kind curve;moves 0 0;passes;length 6;on 0 0 1 1"},
        {"{fair: made, within: 0.02}", BATTEN_OK,
         "degree 2;passes;on 0 0 1 1;within 1e-3;data 3 3 0 1;at 0 0 0 1"},
        {"{fair: both, within: 0.02}", BATTEN_OK,
         "objects 2;named straight;object 1;named made;passes"},
        {"{fair: few, within: 0.1}", BATTEN_OK, "count 2;moves 0 0"},
        {"{fair: lone, within: 0.1}", BATTEN_OK, "kind points;moves 0 0"},
        {"{fair: blunder, within: 0.001}", BATTEN_OK,
         "notes point 10 of curve 1, (9, 4.25075, 0), looks like a blunder"},
        {"{fair: drawn, within: 0.1}", BATTEN_BAD_ARGUMENT,
         "'drawn' is a curve without the points it was made from"},
        {"{fair: ball, within: 0.1}", BATTEN_BAD_ARGUMENT,
         "'ball' is a shape without the points it was made from"},
        {"{fair: made, within: 0}", BATTEN_BAD_ARGUMENT, ""},
        {"{fair: upright, within: 0.02}", BATTEN_OK,
         "on 1 0 0 2;passes;within 1e-3;data 3 2 3 0"},
    };
    EXPECT(ducks, rows);
}
