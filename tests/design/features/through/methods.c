#include "design/expect.h"

/* Curves through points as features: what their rules and options mean, by the curves that they reproduce. */

static const char points[] =
    "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0, 2]]}\n"
    "  upright: {points: [[7, 0, 0], [7, 1, 0.5], [7, 2, 0.6], [7, 3, 0.3], [7, 4, 0]]}\n"
    "  pair: {points: [[0, 0, 1], [4, 0, 1]]}\n"
    "  lone: {points: [[0, 0]]}\n"
    "  some: {collect: [p, lone, pair]}\n"
    "  back: {points: [[0, 0], [2, 1], [1, 2]]}\n"
    "  twisted: {points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]]}\n"
    "  ring: {points: [[5, 0], [4, 3], [0, 5], [-4, 3], [-4, -3], [0, -5], [4, -3]]}\n"
    "  round: {points: [[5, 0], [4, 3], [3, 4], [0, 5]]}\n"
    /* y = x^2, y = x^3 and y = 1 + 2 x */
    "  square: {points: [[-1, 1], [0, 0], [1, 1], [3, 9], [4, 16]]}\n"
    "  cube: {points: [[-1, -1], [0, 0], [1, 1], [2, 8], [3, 27]]}\n"
    "  even: {points: [[0, 0], [1, 1], [2, 4], [3, 9], [4, 16]]}\n"
    "  straight: {points: [[0, 1], [1, 3], [3, 7], [4, 9]]}\n"
    "  steps: {points: [[0, 0], [1, 0], [2, 1], [3, 1], [4, 3]]}\n";

static const char *const in_space[] = {
    "akima",       "bessel",           "cardinal", "catmull-rom",     "circle-tangents",
    "renner",      "mcconalogue",      "hermite",  "cornered-spline", "directed-spline",
    "nu-spline",   "quadratic-spline", "tension",  "weighted-spline", "kochanek-bartels",
    "constrained", "interpolate"};
static const char *const in_plane[] = {"conic-spline", "tangents-and-curvatures",
                                       "local-tension"};
static const char *const functions[] = {"fritsch-carlson", "fritsch-butland", "steffen",
                                        "rational-monotone", "schumaker"};
static const char *const as_functions[] = {"akima",       "bessel",          "cardinal",
                                           "catmull-rom", "nu-spline",       "quadratic-spline",
                                           "tension",     "weighted-spline", "kochanek-bartels",
                                           "constrained", "interpolate"};
static const char *const closing[] = {"akima",           "bessel",
                                      "cardinal",        "catmull-rom",
                                      "circle-tangents", "renner",
                                      "mcconalogue",     "hermite",
                                      "nu-spline",       "tension",
                                      "weighted-spline", "kochanek-bartels",
                                      "conic-spline",    "tangents-and-curvatures",
                                      "local-tension"};

static const expect_row of_all[] = {
    {"{@: p}", BATTEN_OK,
     "objects 1;named a;passes;on 0 0 1 2;at 0 0 0 2;at 1 4 0 2;data 1 1 0.5 2"},
    {"{@: upright}", BATTEN_OK, "passes;on 1 0 0 7;at 1 7 4 0"},
    {"{@: pair}", BATTEN_OK, "passes;on 0 1 0 0;within 1e-7;length 4"},
    {"{@: straight}", BATTEN_OK, "passes;within 1e-6;on -2 1 0 1;length 8.94427190999916"},
    {"{@: some}", BATTEN_OK,
     "objects 2;named p;passes;object 1;named pair;passes;notes left out"},
};

TEST(curves_pass_their_points_and_keep_to_their_plane_and_line)
{
    static const expect_row lone[] = {
        {"{@: lone}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"}};
    expect_each(points, in_space, COUNT(in_space), of_all, COUNT(of_all));
    expect_each(points, in_plane, COUNT(in_plane), of_all, COUNT(of_all));
    expect_each(points, functions, COUNT(functions), of_all, COUNT(of_all));
    expect_each(points, in_space, COUNT(in_space) - 1, lone, 1);
    expect_each(points, in_plane, COUNT(in_plane), lone, 1);
    expect_each(points, functions, COUNT(functions), lone, 1);
}

TEST(curves_in_space_leave_the_plane_and_others_say_that_they_need_one)
{
    static const expect_row taken[] = {{"{@: twisted}", BATTEN_OK, "passes"}};
    static const expect_row refused[] = {
        {"{@: twisted}", BATTEN_NOT_COMPATIBLE,
         "the points must lie in a plane x, y or z = constant for '"}};
    expect_each(points, in_space, COUNT(in_space), taken, 1);
    expect_each(points, in_plane, COUNT(in_plane), refused, 1);
    expect_each(points, functions, COUNT(functions), refused, 1);
}

TEST(functions_need_rising_abscissae_and_keep_straight_lines)
{
    static const expect_row rows[] = {
        {"{@: back}", BATTEN_NOT_INCREASING, "point 3 is at 1, point 2 before it at 2"}};
    static const expect_row asked[] = {
        {"{@: back, as: function}", BATTEN_NOT_INCREASING,
         "point 3 is at 1, point 2 before it at 2"},
        {"{@: straight, as: function}", BATTEN_OK, "passes;within 1e-9;on -2 1 0 1;domain 0 4"},
        {"{@: upright, as: function}", BATTEN_OK, "passes;domain 0 4;on 1 0 0 7"}};
    static const expect_row monotone[] = {
        {"{@: steps}", BATTEN_OK, "passes;domain 0 4;at 0.125 0.5 0 0"}};
    expect_each(points, functions, COUNT(functions), rows, 1);
    expect_each(points, functions, COUNT(functions), monotone, 1);
    expect_each(points, as_functions, COUNT(as_functions), asked, COUNT(asked));
}

TEST(closed_curves_return_to_their_start)
{
    static const expect_row rows[] = {
        {"{@: ring, closed: yes}", BATTEN_OK, "objects 1;passes;closed 1"},
        {"{@: ring}", BATTEN_OK, "closed 0;at 1 4 -3 0"}};
    expect_each(points, closing, COUNT(closing), rows, 2);
}

TEST(interpolation_reproduces_what_its_degree_allows)
{
    static const expect_row rows[] = {
        {"{interpolate: cube, as: function}", BATTEN_OK,
         "degree 3;at 0.125 -0.5 -0.125 0;at 0.875 2.5 15.625 0"},
        {"{interpolate: square, as: function, degree: 2}", BATTEN_OK,
         "degree 2;at 0.5 1.5 2.25 0"},
        {"{interpolate: even, parameters: uniform}", BATTEN_OK,
         "at 0.125 0.5 0.25 0;at 0.875 3.5 12.25 0"},
        {"{interpolate: p, degree: 1}", BATTEN_OK, "degree 1;count 5;length 4.211082852644094"},
        {"{interpolate: p, ends: natural}", BATTEN_OK, "passes;bends 0 0;bends 1 0"},
        {"{interpolate: p, start: natural}", BATTEN_OK, "bends 0 0"},
        {"{interpolate: p, end: natural}", BATTEN_OK, "bends 1 0"},
        {"{interpolate: p, start: direction, start-vector: [1, 1], end: direction, end-vector: [0, -1]}",
         BATTEN_OK, "heads 0 0.7071067811865476 0.7071067811865476 0;heads 1 0 -1 0"},
        {"{interpolate: p, knots: data, ends: natural}", BATTEN_OK, "count 7"},
        {"{interpolate: p, knots: averaged, ends: natural}", BATTEN_OK, "count 5"},
        {"{interpolate: p, degree: 4}", BATTEN_OK, "degree 4;count 5"},
        {"{interpolate: ring, periodic: yes}", BATTEN_OK, "passes;closed 1"},
        {"{interpolate: p, as: function, periodic: yes}", BATTEN_OK, "passes"},
        {"{interpolate: square, as: function, periodic: yes}", BATTEN_NOT_COMPATIBLE,
         "a periodic function ends with the value it begins with; these are 16 and 1"},
        {"{interpolate: lone}", BATTEN_NOT_FOUND, "nothing is left"},
        {"{interpolate: some}", BATTEN_OK,
         "objects 2;notes 'lone' has 1 point and is left out"},
        {"{interpolate: back, as: function}", BATTEN_NOT_INCREASING, "back: "},
        {"{interpolate: p, degree: 0}", BATTEN_BAD_DEGREE, "p: "},
    };
    EXPECT(points, rows);
}

TEST(a_function_that_bends_where_its_points_do_not_is_noted)
{
    static const char more[] =
        "  late: {points: [[0, 0], [1, 0], [2, 0.1], [3, 5], [4, 10]]}\n"
        "  down: {points: [[0, 0], [1, 0], [2, -0.1], [3, -5], [4, -10]]}\n"
        "  square: {points: [[-1, 1], [0, 0], [1, 1], [3, 9], [4, 16]]}\n";
    static const expect_row rows[] = {
        {"{interpolate: late, as: function}", BATTEN_OK,
         "notes 'late': its points are convex, but the curve bends back at point"},
        {"{interpolate: down, as: function}", BATTEN_OK,
         "notes 'down': its points are concave, but the curve bends back at point"},
        {"{interpolate: late, as: function, knots: averaged}", BATTEN_OK, "silent"},
        {"{interpolate: square, as: function}", BATTEN_OK, "silent"},
    };
    EXPECT(more, rows);
}

TEST(slopes_of_local_methods_come_from_their_rule)
{
    static const expect_row rows[] = {
        /* Parabolas through three points reproduce a parabola. */
        {"{bessel: square, as: function}", BATTEN_OK, "at 0.5 1.5 2.25 0;at 0.1 -0.5 0.25 0"},
        {"{bessel: even}", BATTEN_OK, "passes;degree 3"},
        /* Akima keeps a straight run straight, and so does the modified rule. */
        {"{akima: steps, as: function}", BATTEN_OK, "passes"},
        {"{akima: steps, as: function, modified: yes}", BATTEN_OK, "passes"},
        {"{akima: steps, modified: yes}", BATTEN_BAD_ARGUMENT,
         "'modified' is for functions alone"},
        {"{hermite: pair, tangents: [[1, 1], [1, -1]], lengths: rule}", BATTEN_OK,
         "heads 0 0.7071067811865476 0.7071067811865476 0;heads 1 0.7071067811865476 -0.7071067811865476 0"},
        {"{hermite: pair, tangents: [[1, 1], [1, -1]], degree: quintic, second: [[0, 0], [0, 0]]}",
         BATTEN_OK,
         "degree 5;bends 0 0;bends 1 0;heads 1 0.7071067811865476 -0.7071067811865476 0"},
        {"{hermite: p, degree: quintic}", BATTEN_OK, "passes;degree 5"},
        {"{hermite: ring, degree: quintic, closed: yes}", BATTEN_UNSUPPORTED,
         "a closed curve is cubic here, not quintic"},
        {"{hermite: pair, tangents: [[1, 1]]}", BATTEN_BAD_ARGUMENT, "tangents"},
        {"{hermite: pair, tangents: [[1, 1], [1, -1]], degree: quintic, second: [[0, 0]]}",
         BATTEN_BAD_ARGUMENT, "second"},
        {"{circle-tangents: round}", BATTEN_OK, "within 0.003;distance 5 0 0 0"},
        {"{circle-tangents: round, lengths: middle}", BATTEN_OK,
         "within 0.003;distance 5 0 0 0"},
        {"{mcconalogue: round}", BATTEN_OK, "within 0.003;distance 5 0 0 0"},
        {"{catmull-rom: even, alpha: 0}", BATTEN_OK, "passes;at 0.375 1.5 2.25 0"},
        {"{catmull-rom: even, alpha: 0, local: 0}", BATTEN_OK,
         "notes the curve passes near the points"},
        {"{catmull-rom: even, blend: 0}", BATTEN_BAD_DEGREE, ""},
        {"{cardinal: even}", BATTEN_OK, "at 0.375 1.5 2.25 0"},
        {"{cardinal: p, tension: 1}", BATTEN_OK, "passes;within 1e-6;length 4.211082852644094"},
        {"{cardinal: p, tension: [1, 1]}", BATTEN_BAD_ARGUMENT,
         "'tension' has 2 numbers for 5 points"},
        {"{kochanek-bartels: even}", BATTEN_OK, "at 0.375 1.5 2.25 0"},
        {"{kochanek-bartels: p, tension: 1}", BATTEN_OK,
         "within 1e-6;length 4.211082852644094"},
        {"{kochanek-bartels: p, continuity: -1}", BATTEN_OK,
         "within 1e-6;length 4.211082852644094"},
        {"{kochanek-bartels: even, bias: [0, 1, 1, 0, 0]}", BATTEN_OK, "passes"},
        {"{kochanek-bartels: even, bias: [0, 1]}", BATTEN_BAD_ARGUMENT,
         "'bias' has 2 numbers for 5 points"},
        {"{kochanek-bartels: even, continuity: [0, 1]}", BATTEN_BAD_ARGUMENT,
         "'continuity' has 2"},
        {"{local-conics: round}", BATTEN_OK, "passes;within 1e-6;distance 5 0 0 0"},
        {"{local-conics: pair, tangents: [[1, 1], [1, -1]], weight: 1}", BATTEN_OK,
         "at 0.5 2 1 1"},
        {"{local-conics: pair, tangents: [[1, 1], [1, -1]], weight: 3}", BATTEN_OK,
         "at 0.5 2 1.5 1"},
        {"{local-conics: ring, closed: yes}", BATTEN_OK,
         "closed 1;within 1e-6;distance 5 0 0 0"},
        {"{local-conics: pair, tangents: [[1, 1]]}", BATTEN_BAD_ARGUMENT, "tangents"},
        {"{local-conics: twisted}", BATTEN_NOT_COMPATIBLE, "must lie in a plane"},
        {"{nu-spline: straight, nu: [1, 2, 3, 4]}", BATTEN_OK, "passes"},
        {"{fritsch-carlson: steps}", BATTEN_OK, "at 0.625 2.5 1 0"},
    };
    EXPECT(points, rows);
}

TEST(corners_and_directions_are_where_they_are_asked_for)
{
    static const expect_row rows[] = {
        {"{cornered-spline: p, lines: [2]}", BATTEN_OK, "passes"},
        {"{cornered-spline: p, lines: [1, 2, 3, 4]}", BATTEN_OK,
         "passes;within 1e-8;length 4.211082852644094"},
        {"{cornered-spline: p, corners: [2, 3, 4]}", BATTEN_OK,
         "within 1e-8;length 4.211082852644094"},
        {"{cornered-spline: p, corners: [3], ends: natural}", BATTEN_OK, "bends 0 0;bends 1 0"},
        {"{cornered-spline: p, ends: not-a-knot}", BATTEN_OK, "passes"},
        {"{cornered-spline: straight, ends: parabolic}", BATTEN_OK, "passes"},
        {"{cornered-spline: p, corners: [10]}", BATTEN_BAD_ARGUMENT, "p: "},
        {"{cornered-spline: p, lines: [5]}", BATTEN_BAD_ARGUMENT, "p: "},
        {"{directed-spline: p, at: [1, 5], directions: [[0, 2, 0], [1, 0, 0]]}", BATTEN_OK,
         "heads 0 0 1 0;heads 1 1 0 0;passes"},
        {"{directed-spline: p, at: 5, directions: [[-1, 0, 0]]}", BATTEN_OK,
         "notes against the points"},
        {"{directed-spline: p, at: [1], directions: [[0, 1], [1, 0]]}", BATTEN_NOT_COMPATIBLE,
         "'at' names 1 point and 'directions' has 2"},
        {"{directed-spline: p, at: [1, 2], directions: [[0, 1]]}", BATTEN_NOT_COMPATIBLE,
         "'at' names 2 points and 'directions' has 1"},
        {"{directed-spline: p, tension: [1, 2]}", BATTEN_NOT_COMPATIBLE,
         "'tension' has 2 numbers for 5 points; it takes 1 or one for each"},
        {"{directed-spline: p, tension: 3}", BATTEN_OK, "passes"},
        {"{directed-spline: p, tension: [1, 2, 3, 4, 5]}", BATTEN_OK, "passes"},
    };
    EXPECT(points, rows);
}

TEST(conics_have_their_tangents_and_curvatures)
{
    static const expect_row rows[] = {
        {"{conic-pair: pair, start-angle: 45 deg, end-angle: -45 deg}", BATTEN_OK,
         "passes;heads 0 0.7071067811865476 0.7071067811865476 0;heads 1 0.7071067811865476 "
         "-0.7071067811865476 0"},
        {"{conic-pair: pair, start-angle: 45 deg, end-angle: -45 deg, start-curvature: -0.3, "
         "end-curvature: -0.2}",
         BATTEN_OK, "passes;within 1e-8;bends 0 0.3;bends 1 0.2"},
        {"{conic-pair: pair, start-angle: 45 deg, end-angle: -45 deg, start-curvature: -0.3}",
         BATTEN_BAD_ARGUMENT, "one curvature is given; give both or none"},
        {"{conic-pair: p, start-angle: 45 deg, end-angle: -45 deg}", BATTEN_BAD_ARGUMENT,
         "a conic pair has 2 points, not 5"},
        {"{conic-spline: pair, tangents: [[1, 1], [1, -1]], curvatures: -0.3}", BATTEN_OK,
         "within 1e-8;bends 0 0.3;bends 1 0.3;heads 0 0.7071067811865476 0.7071067811865476 0"},
        {"{conic-spline: pair, tangents: [[1, 1], [1, -1]], curvatures: [-0.3, -0.2]}",
         BATTEN_OK, "within 1e-8;bends 0 0.3;bends 1 0.2"},
        {"{conic-spline: p, curvatures: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'curvatures' has 2 numbers for 5 points"},
        {"{conic-spline: round}", BATTEN_OK, "within 1e-6;distance 5 0 0 0"},
        {"{conic-spline: ring, closed: yes}", BATTEN_OK,
         "within 1e-6;distance 5 0 0 0;closed 1"},
        {"{tangents-and-curvatures: pair, tangents: [[1, 1], [1, -1]], curvatures: -0.2}",
         BATTEN_OK,
         "within 1e-8;bends 0 0.2;bends 1 0.2;heads 0 0.7071067811865476 0.7071067811865476 0"},
        {"{tangents-and-curvatures: round}", BATTEN_OK, "within 1e-3;distance 5 0 0 0;silent"},
        {"{tangents-and-curvatures: pair, tangents: [[1, 1], [1, 1]], curvatures: [9, 9]}",
         BATTEN_OK, "notes keeps the tangents alone"},
        {"{tangents-and-curvatures: p, curvatures: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'curvatures' has 2"},
    };
    EXPECT(points, rows);
}
