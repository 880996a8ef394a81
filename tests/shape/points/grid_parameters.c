/* Parameters that all lines of a family share. */
#include "shape/points/grid_parameters.h"
#include "support/test.h"

static const double lines[3][4] = {{0, 1, 3, 4}, {0, 5, 10, 20}, {7, 7, 7, 7}};

static bat_family rows(void)
{
    return (bat_family){"columns", 1, 4, 3, 1, 4, false, &lines[0][0], NULL};
}

TEST(shared_parameters_are_the_mean_of_the_lines_that_have_a_length)
{
    /* Shares of the chords: 1/4, 1/2, 1/4 and 1/4, 1/4, 1/2; the third line is a point. */
    const bat_family family = rows();
    double u[4] = {9, 9, 9, 9}, spread = -1;
    CHECK_OK(bat_family_parametrize(&family, BATTEN_CHORD, u, &spread));
    const double expected[] = {0, 0.25, 0.625, 1};
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(u[i], expected[i], 1e-15);
    /* Their third points are at 3/4 and 1/2, 1/8 from the mean, beside a step of 3/8. */
    CHECK_NEAR(spread, 1.0 / 3, 1e-14);
}

TEST(one_line_alone_keeps_its_own_parameters)
{
    bat_family family = rows();
    family.lines = 1;
    double u[4], spread = -1;
    CHECK_OK(bat_family_parametrize(&family, BATTEN_CHORD, u, &spread));
    CHECK_NEAR(spread, 0, 1e-15);
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(u[i], lines[0][i] / 4, 1e-15);
    CHECK_OK(bat_family_parametrize(&family, BATTEN_UNIFORM, u, &spread));
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(u[i], i / 3.0, 1e-15);
}

TEST(the_columns_of_a_grid_are_a_family_as_its_rows_are)
{
    double turned[4 * 3], u[2][4], spread[2];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3; j++)
            turned[i * 3 + j] = lines[j][i];
    const bat_family family[2] = {rows(), {"rows", 1, 4, 3, 3, 1, false, turned, NULL}};
    for (int k = 0; k < 2; k++)
        CHECK_OK(bat_family_parametrize(&family[k], BATTEN_CENTRIPETAL, u[k], &spread[k]));
    for (int i = 0; i < 4; i++)
        CHECK_BITS(u[1][i], u[0][i]);
    CHECK_BITS(spread[1], spread[0]);
}

TEST(a_closed_line_has_the_step_back_to_its_start)
{
    /* Around the triangle of sides 3, 4, 5. */
    const double points[] = {0, 0, 3, 0, 3, 4};
    const bat_family family = {"columns", 2, 3, 1, 2, 6, true, points, NULL};
    const double expected[] = {0, 3 / 12.0, 7 / 12.0, 1};
    double u[4], spread;
    CHECK_OK(bat_family_parametrize(&family, BATTEN_CHORD, u, &spread));
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(u[i], expected[i], 1e-15);
}

TEST(the_spread_of_closed_lines_counts_their_last_point_too)
{
    /* Steps of 1, 1, 1, 1 and of 1, 1, 3, 3: only the second and the last point are off. */
    const double points[] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, -2, 1};
    const bat_family family = {"columns", 2, 4, 2, 2, 8, true, points, NULL};
    double u[5], spread, at[2][5] = {{0, 0.25, 0.5, 0.75, 1}};
    const double sides[] = {1, 1, 3, sqrt(5)}, total = 5 + sqrt(5);
    double expected = 0;
    for (int i = 0; i < 4; i++)
        at[1][i + 1] = at[1][i] + sides[i] / total;
    CHECK_OK(bat_family_parametrize(&family, BATTEN_CHORD, u, &spread));
    for (int i = 1; i < 4; i++) {
        CHECK_NEAR(u[i], (at[0][i] + at[1][i]) / 2, 1e-15);
        expected =
            fmax(expected, fabs(at[1][i] - u[i]) / fmin(u[i] - u[i - 1], u[i + 1] - u[i]));
    }
    CHECK_NEAR(spread, expected, 1e-14);
}

TEST(given_parameters_are_taken_when_they_increase)
{
    bat_family family = rows();
    const double good[] = {2, 3, 7, 8, 9}, flat[] = {0, 1, 1, 2, 3}, bad[] = {0, 1, 2, 3, 3};
    double u[5] = {0}, spread = 5;
    CHECK_STATUS(bat_family_parametrize(&family, BATTEN_GIVEN, u, &spread),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("columns");
    family.given = good;
    CHECK_OK(bat_family_parametrize(&family, BATTEN_GIVEN, u, &spread));
    CHECK(!memcmp(u, good, 4 * sizeof *u) && u[4] == 0);
    family.given = flat;
    CHECK_STATUS(bat_family_parametrize(&family, BATTEN_GIVEN, u, &spread),
                 BATTEN_NOT_INCREASING);
    /* The last one ends the period of a closed family, and is not looked at in an open one. */
    family.given = bad;
    CHECK_OK(bat_family_parametrize(&family, BATTEN_GIVEN, u, &spread));
    family.periodic = true;
    CHECK_STATUS(bat_family_parametrize(&family, BATTEN_GIVEN, u, &spread),
                 BATTEN_NOT_INCREASING);
    family.given = good;
    CHECK_OK(bat_family_parametrize(&family, BATTEN_GIVEN, u, &spread));
    CHECK(!memcmp(u, good, sizeof u));
}

TEST(lines_that_coincide_or_are_too_far_apart_are_named)
{
    double u[4], spread;
    const double far[] = {-1.7e308, 1.7e308, 0}, near[] = {0, 1, 1 + 0.9e-6, 2};
    const bat_family unknown = rows();
    CHECK_STATUS(bat_family_parametrize(&unknown, (batten_parametrization)-1, u, &spread),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_family_parametrize(&unknown, (batten_parametrization)(BATTEN_GIVEN + 1), u,
                                        &spread),
                 BATTEN_BAD_ARGUMENT);
    const bat_family point = {"columns", 1, 4, 1, 1, 4, false, lines[2], NULL};
    CHECK_STATUS(bat_family_parametrize(&point, BATTEN_CHORD, u, &spread), BATTEN_COINCIDENT);
    CHECK_MESSAGE("all columns coincide");
    const bat_family apart = {"columns", 1, 3, 1, 1, 3, true, far, NULL};
    CHECK_STATUS(bat_family_parametrize(&apart, BATTEN_CHORD, u, &spread), BATTEN_OVERFLOW);
    CHECK_MESSAGE("columns 1 and 2");
    /* 0.45e-6 of the length, times three steps, is a step of more than a millionth of the mean;
     * a third of it is not. */
    bat_family together = {"columns", 1, 4, 1, 1, 4, false, near, NULL};
    CHECK_OK(bat_family_parametrize(&together, BATTEN_CHORD, u, &spread));
    const double nearer[] = {0, 1, 1 + 0.3e-6, 2};
    together.points = nearer;
    CHECK_STATUS(bat_family_parametrize(&together, BATTEN_CHORD, u, &spread),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("columns 2 and 3 coincide");
    /* The last step of a closed line leads to the first point. */
    const double back[] = {0, 0, 1, 0, 0, 1e-9};
    const bat_family round = {"columns", 2, 3, 1, 2, 6, true, back, NULL};
    CHECK_STATUS(bat_family_parametrize(&round, BATTEN_CHORD, u, &spread), BATTEN_COINCIDENT);
    CHECK_MESSAGE("columns 3 and 1 coincide");
}
