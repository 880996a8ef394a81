/* The feature 'deform'. */
#include "design/expect.h"
#include "support/test.h"

/* A plate in the plane z = 0.5, a line, points, a tube and a ball, in the box [0, 1]^3 or outside. */
static const char shapes[] =
    "  net: {points: [[0, 0, 0.5], [1, 0, 0.5], [0, 1, 0.5], [1, 1, 0.5]], columns: 2}\n"
    "  plate: {interpolate-grid: net, degree-u: 1, degree-v: 1}\n"
    "  line: {polyline: [[0, 0.5, 0.5], [1, 0.5, 0.5]]}\n"
    "  dots: {points: [[0.5, 0.5, 0.5], [0.25, 0.5, 1]]}\n"
    "  tube: {cylinder: 0.4, height: 1, at: [0.5, 0.5, 0]}\n"
    "  ball: {sphere: 0.4, at: [0.5, 0.5, 0.5]}\n"
    "  long: {polyline: [[0, 0.5, 0.5], [3, 0.5, 0.5]]}\n"
    "  heights: {mesh: ball, chord: 0.01}\n"
    "  tri: {triangles-of: plate}\n";

/* Bezier polynomials of degree 2 in the middle: 1/2 each, so the middle point moves by an eighth. */
#define BOX "box: [[0, 0, 0], [1, 1, 1]], "
#define MIDDLE BOX "counts: 3, move: [[2, 2, 2, 0, 0, 0.4]]"

TEST(shapes_follow_the_lattice_of_their_box)
{
    static const expect_row rows[] = {
        {"{deform: dots, " MIDDLE "}", BATTEN_OK, "data 0 0.5 0.5 0.55; data 1 0.25 0.5 1"},
        {"{deform: line, " MIDDLE "}", BATTEN_OK,
         "at 0.5 0.5 0.5 0.55; at 0 0 0.5 0.5; degree 5; "
         "error 1e-3; notes the map folds nowhere"},
        {"{deform: plate, " MIDDLE ", within: 1e-6}", BATTEN_OK,
         "within 1e-6; at 0.5 0.5 0.5 0.5 0.55; at 0 0 0 0 0.5; error 1e-6"},
        /* A shear that leaves the volume: the top by 0.3. */
        {"{deform: tube, " BOX "counts: 2, move: [[1, 1, 2, 0.3, 0, 0], [1, 2, 2, 0.3, 0, 0], "
         "[2, 1, 2, 0.3, 0, 0], [2, 2, 2, 0.3, 0, 0]]}",
         BATTEN_OK, "within 1e-3; at 0 1 1.2 0.5 1; at 0 0 0.9 0.5 0"},
        {"{deform: heights, " MIDDLE "}", BATTEN_OK,
         "kind mesh; within 1e-9; box 0.1 0.1 0.118 0.9 0.9 0.918"},
        /* All lattice points, of a box twice as wide. */
        {"{deform: line, " BOX
         "counts: 2, lattice: [[0, 0, 0], [0, 0, 1], [0, 1, 0], [0, 1, 1], "
         "[2, 0, 0], [2, 0, 1], [2, 1, 0], [2, 1, 1]]}",
         BATTEN_OK, "within 1e-12; at 1 2 0.5 0.5; notes volumes by more than 2"},
        /* The box of a line is made as thick as it is long. */
        {"{deform: line, counts: 2, move: [[1, 1, 2, 0, 0, 0.2]]}", BATTEN_OK,
         "notes flat in y; at 0 0 0.5 0.55; within 1e-12"},
        {"{deform: long, " BOX "counts: 6, outside: tangent, move: [[3, 3, 3, 0, 0, 0.1]]}",
         BATTEN_OK, "within 1e-3; at 0 0 0.5 0.5; at 1 3 0.5 0.5"},
    };
    EXPECT(shapes, rows);
}

TEST(deformations_that_cannot_be_are_refused_by_name)
{
    static const expect_row rows[] = {
        {"{deform: line, " BOX "counts: 2}", BATTEN_BAD_ARGUMENT, "either 'move' or 'lattice'"},
        {"{deform: line, " BOX "move: [[0, 1, 1, 0, 0, 1]]}", BATTEN_BAD_ARGUMENT,
         "move 1 is of lattice point (0, 1, 1); in x they are counted 1 to 4"},
        {"{deform: line, " BOX "move: [[1, 1, 1, 0, 0, 1], [1, 1.5, 1, 0, 0, 1]]}",
         BATTEN_BAD_ARGUMENT, "move 2 is of lattice point (1, 1.5, 1); in y"},
        {"{deform: line, " BOX "move: [[1, 1, 5, 0, 0, 1]]}", BATTEN_BAD_ARGUMENT,
         "in z they are counted 1 to 4"},
        {"{deform: line, " BOX "move: [1, 1, 5, 0, 0]}", BATTEN_BAD_FORMAT,
         "needs a move [i, j, k, dx, dy, dz], not 5 values"},
        {"{deform: line, " BOX "lattice: [[0, 0, 0], [1, 1, 1]]}", BATTEN_BAD_ARGUMENT,
         "'lattice' has 2 points, not 4 x 4 x 4 = 64"},
        {"{deform: line, " BOX "counts: [2, 2], move: [[1, 1, 1, 0, 0, 1]]}",
         BATTEN_BAD_ARGUMENT, "'counts' has 1 or 3 numbers, not 2"},
        {"{deform: line, " BOX "counts: 4, degree: 4, move: [[1, 1, 1, 0, 0, 1]]}",
         BATTEN_BAD_DEGREE, "degree 4 for 4 lattice points in x; 1 to 3 is possible"},
        {"{deform: line, box: [[0, 0, 0]], move: [[1, 1, 1, 0, 0, 1]]}", BATTEN_BAD_ARGUMENT,
         "'box' has 1 corner, not 2"},
        {"{deform: line, box: [[0, 0, 0], [1, 1, 0]], move: [[1, 1, 1, 0, 0, 1]]}",
         BATTEN_BAD_ARGUMENT, "runs from 0 to 0 in z"},
        {"{deform: line, " BOX "counts: 100000, move: [[1, 1, 1, 0, 0, 1]]}", BATTEN_TOO_LARGE,
         "1e+15 lattice points"},
        {"{deform: long, " MIDDLE "}", BATTEN_OUT_OF_DOMAIN,
         "'long': the curve reaches 2 out of the box where x is largest"},
        {"{deform: long, " MIDDLE ", outside: tangent}", BATTEN_NOT_COMPATIBLE,
         "layer 2 of the lattice there is moved: 2 layers must stay"},
        {"{deform: plate, " BOX "counts: 3, move: [[2, 2, 2, 2.5, 0, 0]]}",
         BATTEN_SINGULAR_HERE, "'plate': the deformation folds: near"},
        {"{deform: tri, " MIDDLE "}", BATTEN_BAD_ARGUMENT, "'tri' has none"},
        {"{deform: [line, tri], " MIDDLE "}", BATTEN_BAD_ARGUMENT, "'tri' is triangles"},
        {"{deform: line, " MIDDLE ", within: -1}", BATTEN_BAD_ARGUMENT, "the tolerance is -1"},
    };
    EXPECT(shapes, rows);
}

TEST(what_a_deformation_does_not_keep_is_noted)
{
    static const expect_row rows[] = {
        {"{deform: heights, " MIDDLE ", within: 1e-6}", BATTEN_OK,
         "notes the middles of its sides are up to"},
    };
    EXPECT(shapes, rows);
}
