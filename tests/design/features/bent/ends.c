#include "design/expect.h"

/* Bent strips as features: what their conditions at the ends and their options mean. */

static const char points[] =
    "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0, 2]]}\n"
    "  pair: {points: [[0, 0, 1], [4, 0, 1]]}\n"
    "  lone: {points: [[0, 0]]}\n"
    "  both: {collect: [p, pair]}\n"
    "  twisted: {points: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]]}\n"
    /* Of a circle of radius 5 about the origin. */
    "  round: {points: [[5, 0], [4, 3], [3, 4], [0, 5]]}\n"
    "  ring: {points: [[5, 0], [4, 3], [0, 5], [-4, 3], [-4, -3], [0, -5], [4, -3]]}\n";

static const char *const nonlinear[] = {
    "elastica",       "euler-spiral",     "geometric-spline", "hobby",
    "arc-spline",     "local-cubic",      "mehlum",           "spiro",
    "minimum-energy", "minimum-variation"};

TEST(bent_strips_take_two_points_and_one_is_too_few)
{
    static const expect_row rows[] = {
        {"{@: pair}", BATTEN_OK, "objects 1;passes;on 0 1 0 0;on 0 0 1 1;within 1e-7;length 4"},
        {"{@: both}", BATTEN_OK, "objects 2;passes;object 1;passes;length 4"},
        {"{@: lone}", BATTEN_TOO_FEW_POINTS, "no row has 2 points"},
    };
    expect_each(points, nonlinear, COUNT(nonlinear), rows, COUNT(rows));
}

TEST(a_bent_strip_in_the_plane_refuses_points_in_space)
{
    static const expect_row rows[] = {{"{@: twisted}", BATTEN_NOT_COMPATIBLE, "plane"}};
    expect_each(points, nonlinear, 8, rows, COUNT(rows));
}

TEST(strips_of_least_energy_pass_points_in_space)
{
    static const expect_row rows[] = {
        {"{@: twisted}", BATTEN_OK, "passes;degree 5;within 5e-3;bends 0 0"}};
    expect_each(points, nonlinear + 8, 1, rows, COUNT(rows));
}

TEST(ends_of_nonlinear_splines_have_the_curvature_or_the_tangent_that_is_given)
{
    static const expect_row rows[] = {
        {"{@: p, ends: natural}", BATTEN_OK, "passes;within 1e-8;bends 0 0;bends 1 0"},
        {"{@: p}", BATTEN_OK, "passes;within 1e-8;bends 0 0;bends 1 0"},
        {"{@: p, start: curvature, start-curvature: -0.25}", BATTEN_OK,
         "within 1e-8;bends 0 0.25;bends 1 0"},
        {"{@: p, end: curvature, end-curvature: -0.25}", BATTEN_OK,
         "within 1e-8;bends 0 0;bends 1 0.25"},
        {"{@: p, ends: curvature, start-curvature: -0.25, end-curvature: -0.125}", BATTEN_OK,
         "within 1e-8;bends 0 0.25;bends 1 0.125"},
        {"{@: p, ends: tangent, start-angle: 30 deg, end-angle: -45 deg}", BATTEN_OK,
         "within 1e-9;heads 0 0.8660254037844386 0.5 0;heads 1 0.7071067811865476 "
         "-0.7071067811865476 0"},
        {"{@: p, start: tangent, start-angle: 0}", BATTEN_OK,
         "within 1e-8;heads 0 1 0 0;bends 1 0"},
    };
    static const char *const names[] = {"elastica", "euler-spiral", "geometric-spline",
                                        "local-cubic"};
    expect_each(points, names, COUNT(names), rows, COUNT(rows));
}

TEST(the_families_that_are_round_keep_a_circle)
{
    static const expect_row rows[] = {
        {"{@: round, ends: circular}", BATTEN_OK,
         "within 1e-8;distance 5 0 0 0;bends 0 0.2;bends 1 0.2"},
        {"{@: ring, closed: yes}", BATTEN_OK,
         "within 1e-8;distance 5 0 0 0;closed 1;bends 0.3 0.2"},
    };
    static const char *const names[] = {"euler-spiral", "geometric-spline", "arc-spline"};
    expect_each(points, names, COUNT(names), rows, COUNT(rows));
    static const expect_row free_ends[] = {
        {"{spiro: round, ends: free}", BATTEN_OK, "within 1e-8;distance 5 0 0 0"},
        {"{spiro: ring, closed: yes}", BATTEN_OK, "within 1e-8;distance 5 0 0 0"},
    };
    EXPECT(points, free_ends);
}

TEST(the_elastica_is_not_round_and_a_curl_of_one_is_nearly)
{
    static const expect_row rows[] = {
        {"{hobby: ring, closed: yes}", BATTEN_OK, "within 0.002;distance 5 0 0 0;closed 1"},
        {"{elastica: ring, closed: yes}", BATTEN_OK, "within 0.05;distance 5 0 0 0;closed 1"},
    };
    EXPECT(points, rows);
}

TEST(spiro_has_the_ends_that_are_given)
{
    static const expect_row rows[] = {
        {"{spiro: p, ends: natural}", BATTEN_OK, "passes;within 1e-8;bends 0 0;bends 1 0"},
        {"{spiro: p, ends: tangent, start-angle: 30 deg, end-angle: -45 deg}", BATTEN_OK,
         "within 1e-8;heads 0 0.8660254037844386 0.5 0;heads 1 0.7071067811865476 -0.7071067811865476 0"},
        {"{spiro: p, start: curvature, start-curvature: -0.25, end: natural}", BATTEN_OK,
         "within 1e-8;bends 0 0.25;bends 1 0"},
        {"{spiro: p, end: curvature, end-curvature: -0.25, start: natural}", BATTEN_OK,
         "within 1e-8;bends 1 0.25;bends 0 0"},
        {"{spiro: p, start: both, start-angle: 30 deg, start-curvature: -0.25, end: natural, "
         "end-curvature: 3}",
         BATTEN_OK, "within 1e-8;heads 0 0.8660254037844386 0.5 0;bends 0 0.25;bends 1 0"},
        {"{spiro: p, end: both, end-angle: -30 deg, end-curvature: -0.25, start: tangent, start-angle: 10 deg, "
         "start-curvature: 3}",
         BATTEN_OK,
         "within 1e-8;heads 1 0.8660254037844386 -0.5 0;bends 1 0.25;heads 0 0.984807753012208 "
         "0.17364817766693033 0"},
        {"{spiro: p, corners: [2, 3]}", BATTEN_OK, "passes;within 1e-9;spans 4"},
        {"{spiro: p, corners: [0]}", BATTEN_BAD_ARGUMENT,
         "'corners' names point 0; points are counted from 1"},
        {"{spiro: p, corners: [6]}", BATTEN_BAD_ARGUMENT, "'corners' names point 6 of 5"},
        {"{spiro: p, left: [5], right: [10]}", BATTEN_BAD_ARGUMENT,
         "'right' names point 10 of 5"},
        {"{spiro: p, corners: [3], left: [2, 3]}", BATTEN_BAD_ARGUMENT,
         "'left' names point 3, which another list names too"},
        {"{spiro: p, corners: [3, 3]}", BATTEN_OK, "passes"},
        {"{spiro: p, curvature: [3, 2]}", BATTEN_OK, "passes;spans 4"},
        {"{spiro: p, curvature: [8]}", BATTEN_BAD_ARGUMENT, "'curvature' names point 8 of 5"},
    };
    EXPECT(points, rows);
}

TEST(mehlum_bends_by_arcs_which_are_counted)
{
    static const expect_row rows[] = {
        {"{mehlum: p}", BATTEN_OK, "passes;spans 16;notes 16 arcs"},
        {"{mehlum: p, arcs: 3}", BATTEN_OK, "passes;spans 12;notes 12 arcs"},
        {"{mehlum: p, arcs: 2, within: 0.001}", BATTEN_OK,
         "passes;notes from the elastica at most"},
        {"{mehlum: p, arcs: 1}", BATTEN_BAD_ARGUMENT, "arcs"},
        {"{mehlum: p, within: -1}", BATTEN_BAD_ARGUMENT, "tolerance"},
        {"{mehlum: ring, closed: yes}", BATTEN_OK, "passes;spans 28;closed 1"},
        {"{mehlum: p, ends: tangent, start-angle: 30 deg, end-angle: -45 deg}", BATTEN_OK,
         "heads 0 0.8660254037844386 0.5 0;heads 1 0.7071067811865476 -0.7071067811865476 0"},
    };
    EXPECT(points, rows);
}

TEST(sharp_turns_and_added_inflections_are_noted)
{
    static const char sharp[] = "  z: {points: [[0, 0], [4, 0], [1, 0.8], [5, 1.5]]}\n"
                                "  soft: {points: [[0, 0], [1, 0.2], [2, 0.2], [3, 0]]}\n";
    static const expect_row rows[] = {
        {"{euler-spiral: z}", BATTEN_OK, "notes degrees at point 2: look at the curve there"},
        {"{euler-spiral: soft}", BATTEN_OK, "silent"},
    };
    EXPECT(sharp, rows);
}

TEST(energies_have_pieces_and_tension)
{
    static const expect_row rows[] = {
        {"{minimum-energy: p, pieces: 1}", BATTEN_OK, "passes;degree 5;on 0 0 1 2"},
        {"{minimum-energy: p, pieces: -1}", BATTEN_BAD_FORMAT, "pieces"},
        {"{minimum-energy: p, pieces: 17}", BATTEN_BAD_ARGUMENT, "pieces"},
        {"{minimum-energy: p, tension: -1}", BATTEN_BAD_ARGUMENT, "tension"},
        {"{minimum-energy: ring, closed: yes, scale-invariant: yes}", BATTEN_OK,
         "passes;closed 1;within 0.02;distance 5 0 0 0"},
        {"{minimum-variation: ring, closed: yes}", BATTEN_OK,
         "passes;closed 1;within 1e-3;distance 5 0 0 0"},
        {"{minimum-variation: round}", BATTEN_OK, "passes;within 1e-3;distance 5 0 0 0"},
        /* A strip that is pulled hard is nearly its polygon, which is 4.2111 long. */
        {"{minimum-energy: p, tension: 1e4}", BATTEN_OK,
         "passes;within 0.001;length 4.2110830"},
    };
    EXPECT(points, rows);
}
