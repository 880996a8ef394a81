#include "design/expect.h"

/* The figures that features through points report, each known beforehand. */

/* Three parabolas across: y = t (3 - t) / 2 of four levels, twice that, and a straight one. */
static const char table[] = "x_m,z_m,half_breadth_m\n"
                            "0,0,0\n0,1,1\n0,2,1\n0,3,0\n"
                            "1,0,0\n1,1,2\n1,2,2\n1,3,0\n"
                            "2,0,0\n2,1,1\n2,2,2\n2,3,3\n"
                            "3,0,5\n";

/* A file for the designs of this test. */
static const char *with_table(const char *name, int rows)
{
    char *lines = test_array(600, 1);
    const char *path = test_scratch(name);
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    fprintf(file, "%.*s", rows, table);
    fclose(file);
    snprintf(lines, 600, "  t: {read: '%s'}\n", path);
    return lines;
}

TEST(curves_of_a_table_that_go_far_beyond_their_points_are_counted_and_measured)
{
    static const expect_row rows[] = {
        {"{interpolate: t, parameters: uniform}", BATTEN_OK,
         "objects 4;notes 2 of the curves go more than 3 % of their size beyond their points, ;"
         "notes by 0.25, 8 %;object 1;at 0.5 1 2.25 1.5;object 3;length 0"},
        /* A straight line through each, from point to point. */
        {"{interpolate: t, degree: 1}", BATTEN_OK, "objects 4;silent"},
    };
    static const expect_row alone[] = {
        {"{interpolate: t, parameters: uniform}", BATTEN_OK,
         "objects 1;notes 1 of the curves goes more than 3 % of their size beyond their points, ;"
         "notes by 0.125, 4 %"},
    };
    EXPECT(with_table("all.csv", (int)strlen(table)), rows);
    /* The header and the first of the sections. */
    EXPECT(with_table("one.csv", 23 + 4 * 6), alone);
}

static const char points[] =
    "  late: {points: [[0, 0], [1, 0], [2, 0.1], [3, 5], [4, 10]]}\n"
    "  down: {points: [[0, 0], [1, 0], [2, -0.1], [3, -5], [4, -10]]}\n"
    "  wave: {points: [[0, 1], [1, 3], [2, 0], [3, 2]]}\n"
    "  back: {points: [[0, 0], [2, 0], [1, 0], [3, 1]]}\n"
    "  twice: {points: [[0, 0], [2, 0], [1, 0], [3, 0]]}\n"
    "  even: {points: [[0, 0], [1, 1], [2, 4], [3, 9], [4, 16]]}\n"
    "  row: {points: [[0, 0], [1, 0], [2, 0]]}\n"
    "  pair: {points: [[0, 0], [4, 0]]}\n"
    "  lone: {points: [[0, 0]]}\n"
    "  some: {collect: [lone, pair]}\n"
    /* A cubic with a loop, then one without. */
    "  loop: {points: [[0, 0], [4, 3], [-3, 3], [1, 0]]}\n"
    "  looped: {bezier: loop}\n"
    "  far: {points: [[0, 0], [0, 1], [1, 1], [1, 0]]}\n"
    "  plain: {bezier: far}\n"
    "  lifted: {points: [[0, 0, 0], [0, 1, 0], [1, 1, 1], [1, 0, 0]]}\n"
    "  space: {bezier: lifted}\n";

static const expect_row of_splines[] = {
    /* Natural: 4 m1 + m2 = 0.6 and 2 m1 + 4 m2 = 28.8, so that m1 < 0: at point 2, between m0 and m2. */
    {"{interpolate: late, as: function, ends: natural}", BATTEN_OK,
     "notes 'late': its points are convex, but the curve bends back at point 2 because point 2 "
     "stands out"},
    {"{interpolate: down, as: function, ends: natural}", BATTEN_OK,
     "notes 'down': its points are concave, but the curve bends back at point 2 because point 2 "
     "stands out"},
    /* Not a knot: m1 = 0.1, m2 = 7.15 and m0 = 2 m1 - m2 < 0. */
    {"{interpolate: late, as: function}", BATTEN_OK, "notes the curve bends back at point 1"},
    {"{interpolate: wave, as: function, periodic: yes}", BATTEN_NOT_COMPATIBLE,
     "wave: a periodic function ends with the value it begins with; these are 2 and 1"},
    {"{interpolate: some}", BATTEN_OK,
     "objects 1;named a;length 4;notes 'lone' has 1 point and is left out; notes a curve needs 2"},
    /* Uniform cubic polynomials of one point, blended: one is (1, 0, 0), (4, 1, 0) / 6 and so on. */
    {"{catmull-rom: even, alpha: 0, local: 0, blend: 3}", BATTEN_OK,
     "notes 'even': the curve passes near the points, up to 0.333333 away"},
    {"{catmull-rom: even, alpha: 0}", BATTEN_OK, "silent"},
    {"{directed-spline: row, at: [2], directions: [[-1, 0.1]]}", BATTEN_OK,
     "notes 1 of the directions of 'row' lead against the points, the first at point 2"},
    {"{directed-spline: row, at: [2], directions: [[1, 0]], tension: 2}", BATTEN_OK,
     "silent; length 2"},
    {"{directed-spline: row, at: [2], directions: [[1, 0], [0, 1]]}", BATTEN_NOT_COMPATIBLE,
     "'at' names 1 point and 'directions' has 2"},
    {"{directed-spline: row, at: [1, 2], directions: [[1, 0]]}", BATTEN_NOT_COMPATIBLE,
     "'at' names 2 points and 'directions' has 1"},
    {"{directed-spline: row, at: 0, directions: [[1, 0]]}", BATTEN_BAD_ARGUMENT,
     "'at' names point 0; points are counted from 1"},
    {"{directed-spline: row, at: 1, directions: [[1, 0]], tension: [1, 2]}",
     BATTEN_NOT_COMPATIBLE, "'tension' has 2 numbers for 3 points; it takes 1 or one for each"},
    {"{cornered-spline: row, lines: 0}", BATTEN_BAD_ARGUMENT,
     "'lines' names point 0; points are counted from 1"},
};

TEST(splines_remark_where_they_leave_what_their_points_say)
{
    EXPECT(points, of_splines);
}

static const expect_row of_local[] = {
    {"{circle-tangents: back}", BATTEN_OK,
     "notes 'back' turns back on itself at 1 point, the first is point 2"},
    {"{circle-tangents: twice}", BATTEN_OK,
     "notes 'twice' turns back on itself at 2 points, the first is point 2"},
    {"{hermite: back, degree: quintic}", BATTEN_OK, "notes at 1 point, the first is point 2"},
    {"{tangents-and-curvatures: back}", BATTEN_OK, "notes at 1 point, the first is point 2"},
    {"{conic-pair: row, start-angle: 0 deg, end-angle: 0 deg}", BATTEN_BAD_ARGUMENT,
     "row: a conic pair has 2 points, not 3"},
    {"{conic-pair: pair, start-angle: 30 deg, end-angle: -30 deg, end-curvature: 1}",
     BATTEN_BAD_ARGUMENT, "one curvature is given; give both or none"},
    {"{conic-pair: pair, start-angle: 30 deg, end-angle: -30 deg, start-curvature: 1}",
     BATTEN_BAD_ARGUMENT, "one curvature is given; give both or none"},
    {"{conic-spline: pair, tangents: [[1, 0]]}", BATTEN_BAD_ARGUMENT,
     "'tangents' has 1 vector for 2 points"},
    {"{corrected: looped}", BATTEN_OK,
     "notes 1 of 1 span corrected;at 0 0 0 0;at 1 1 0 0;domain 0 1"},
    {"{corrected: plain}", BATTEN_OK, "silent;at 0.5 0.5 0.75 0"},
    {"{corrected: plain, joins: curvature}", BATTEN_OK, "silent"},
    {"{corrected: space, joins: curvature}", BATTEN_NOT_COMPATIBLE,
     "'joins: curvature' needs a curve in a plane x, y or z = constant"},
};

TEST(local_curves_remark_where_their_points_turn_back_and_what_was_corrected)
{
    EXPECT(points, of_local);
}

static const char steps[] =
    "  p: {points: [[0, 1, 0], [1, 1, 0], [2, 1, 0.05], [3, 1, 1], [4, 1, 1.05], [5, 1, 1.1]]}\n";

static const expect_row of_constraints[] = {
    {"{constrained: p, lines: [[0, 1, 0]], sides: [[0, 0, 1], [1, 0, 0]]}",
     BATTEN_NOT_COMPATIBLE, "'lines' has 1 and 'sides' 2"},
    {"{constrained: p, lines: [[0, 1, 0]], sides: [[0, 0, 1]], from: [1, 2]}",
     BATTEN_NOT_COMPATIBLE, "'lines' has 1 and 'from' 2"},
    {"{constrained: p, lines: [[0, 1, 0]], sides: [[0, 0, 1]], to: [3, 4]}",
     BATTEN_NOT_COMPATIBLE, "'lines' has 1 and 'to' 2"},
    {"{constrained: p, lines: [[0, 1, 0]], sides: [[0, 0, 1]], to: 1}", BATTEN_BAD_ARGUMENT,
     "'to' names point 1; it takes points after the first, or 0 for the last"},
    {"{constrained: p, lines: [[0, 1, 0]], sides: [[0, 0, 1]], from: 0}", BATTEN_BAD_ARGUMENT,
     "'from' names point 0; points are counted from 1"},
    {"{constrained: p, at: [2, 3], directions: [[1, 0, 0]]}", BATTEN_NOT_COMPATIBLE,
     "'at' has 2 and 'directions' 1"},
    {"{constrained: p, as: function, at: [2, 3], directions: [[1, 0, 0], [0, 0, 1]]}",
     BATTEN_BAD_ARGUMENT, "direction 2 is upright, which that of a function cannot be"},
    {"{constrained: p, lines: [[0, 1, 0.5]], sides: [[0, 0, 1]], from: 2, to: 3}",
     BATTEN_NOT_COMPATIBLE, "(value, from point 2 to 3) cannot hold"},
    {"{constrained: p, lines: [[0, 1, 0.5]], sides: [[0, 0, 1]], to: 0}", BATTEN_NOT_COMPATIBLE,
     "(value, from point 1 to 6) cannot hold"},
    {"{constrained: p, as: function, bent: [[0, 0, 1]]}", BATTEN_NOT_COMPATIBLE,
     "constraint 1 (bend, from point 1 to 6) cannot hold"},
    {"{constrained: p, lines: [[0, 1, -1]], sides: [[0, 0, 1]], bent: [[0, 0, 1]]}",
     BATTEN_NOT_COMPATIBLE, "constraint 2 (bend"},
};

TEST(constraints_are_named_with_their_points)
{
    EXPECT(steps, of_constraints);
}
