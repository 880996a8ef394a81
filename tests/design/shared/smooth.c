#include "design/expect.h"

/* What is said about tangent planes and curvatures beside a patch. */

/* A unit square, the planes beside it, and one that falls from the first side at 45 degrees. A lifted corner: the side
 * of 1 rises by 0.00035, which is 0.0201 degrees. */
static const char squares[] =
    "  s: {line: [[0, 0], [1, 0]]}\n  e: {line: [[1, 0], [1, 1]]}\n"
    "  n: {line: [[0, 1], [1, 1]]}\n  w: {line: [[0, 0], [0, 1]]}\n"
    "  before: {bilinear: [[0, -1, 0], [1, -1, 0], [1, 0, 0], [0, 0, 0]]}\n"
    "  right: {bilinear: [[1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0]]}\n"
    "  fallen: {bilinear: [[0, -1, -1], [1, -1, -1], [1, 0, 0], [0, 0, 0]]}\n"
    "  rise: {line: [[1, 0, 0], [1, 1, 0.00035]]}\n"
    "  risen: {line: [[0, 1, 0], [1, 1, 0.00035]]}\n"
    /* A strip of the slope 2 x (1 - x) across, beside a plane: at their corner they ask for two twists. */
    "  bulge: {conic: [[0, -1, 0], [0.5, -1, 1], [1, -1, 0]], weight: 1}\n"
    "  strip: {ruled: [s, bulge]}\n"
    /* A tube of radius 1, which flat sides leave along its tangent plane. */
    "  arc: {arc: 1 m, angle: 90 deg, axis: y, from: x}\n"
    "  tube: {extrude: arc, along: [0, 1, 0]}\n"
    "  ts: {line: [[1, 0, 0], [1, 1, 0]]}\n  tw: {line: [[1, 0, 0], [1, 0, 1]]}\n"
    "  te: {move: tw, by: [0, 1, 0]}\n  tn: {move: ts, by: [0, 0, 1]}\n";

static const expect_row rows[] = {
    {"{coons: [s, e, n, w]}", BATTEN_OK, "area 1;lacks degree;lacks curvatures"},
    {"{coons: [s, e, n, w], along: [before, right]}", BATTEN_OK,
     "area 1;lacks off the tangent;lacks are kept;lacks curvatures"},
    {"{coons: [s, e, n, w], along: fallen, repair: yes}", BATTEN_OK,
     "notes the surface is up to 45 degrees off the tangent planes along the first side, near (; "
     "lacks are kept"},
    {"{coons: [s, rise, risen, w], along: before, within: 1 cm}", BATTEN_OK,
     "notes the surface is up to 0.0201 degrees off the tangent planes along the first side, near "
     "(1, 0, 0);lacks are kept"},
    {"{coons: [s, rise, risen, w], along: before, within: 1 cm, angle: 0.03 deg}", BATTEN_OK,
     "notes tangent planes of the surfaces beside it are kept to 0.02 degrees (the first side "
     "0.02);lacks off the tangent"},
    {"{coons: [s, rise, risen, w], along: before, within: 1 cm, angle: 0.01 deg}",
     BATTEN_TOLERANCE_NOT_MET,
     "the surface is up to 0.0201 degrees off the tangent planes along the first side, near (1, 0, "
     "0), and 0.01 are allowed: let its curves leave within these planes"},
    {"{coons: [s, e, n, w], along: [strip, right]}", BATTEN_OK,
     "error 1e-3;notes tangent planes of the surfaces beside it are kept to 0.00; notes degrees (the "
     "first side 0.00; notes , the second side 0.00;lacks the spline keeps"},
    {"{coons: [ts, te, tn, tw], along: tube, kind: third, repair: yes}", BATTEN_OK,
     "notes curvatures across the edges differ by up to 1 per unit of length from those of the "
     "surfaces beside it (the first side 1)"},
    {"{coons: [ts, te, tn, tw], along: tube, kind: second, repair: yes}", BATTEN_OK,
     "lacks curvatures across"},
};

TEST(angles_and_curvatures_beside_a_patch_are_told_side_by_side)
{
    EXPECT(squares, rows);
}

/* Slopes that ask for two twists at corner 1: the spline turns its twist there, within the angle. */
static const char slopes[] =
    "  s: {line: [[0, 0], [1, 0]]}\n  e: {line: [[1, 0], [1, 1]]}\n"
    "  n: {line: [[1, 1], [0, 1]]}\n  w: {line: [[0, 1], [0, 0]]}\n"
    "  p1: {points: [[0, 1, 0], [0, 1, -1], [0, 1, 0]]}\n  p2: {points: [[-1, 0], [-1, 0]]}\n"
    "  p3: {points: [[0, -1], [0, -1]]}\n  p4: {points: [[1, 0], [1, 0]]}\n"
    "  d1: {bezier: p1}\n  d2: {bezier: p2}\n  d3: {bezier: p3}\n  d4: {bezier: p4}\n";

static const expect_row without[] = {
    {"{coons: [s, e, n, w], slopes: [d1, d2, d3, d4]}", BATTEN_OK,
     "notes the spline keeps the tangent planes of the patch along its edges to 0.00; notes degrees "
     "(the first side 0.00; notes , the fourth side 0.00;lacks surfaces beside"},
};

TEST(without_surfaces_beside_it_the_angle_is_that_to_the_formula)
{
    EXPECT(slopes, without);
}
