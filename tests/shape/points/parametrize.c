#include <batten/interpolate.h>

#include "support/test.h"

static const double corner[] = {0, 0, 3, 4, 3, 20}; /* chords 5 and 16 */

TEST(steps_are_powers_of_the_chord)
{
    double t[4];
    CHECK_OK(batten_parametrize((batten_points){2, 3, corner}, BATTEN_UNIFORM, true, t));
    CHECK(t[0] == 0 && t[1] == 1 && t[2] == 2 && t[3] == 3);
    CHECK_OK(batten_parametrize((batten_points){2, 3, corner}, BATTEN_CHORD, true, t));
    CHECK(t[1] == 5 && t[2] == 21);
    CHECK_NEAR(t[3], 21 + sqrt(409), 1e-14);
    CHECK_OK(batten_parametrize((batten_points){2, 3, corner}, BATTEN_CENTRIPETAL, false, t));
    CHECK_NEAR(t[1] / t[2], sqrt(5) / (sqrt(5) + 4), 1e-15);
}

TEST(foleys_steps_grow_at_corners)
{
    /* A right angle between chords 1 and 2: each step grows by 3/2 pi/2 of the neighbour's
     * share. */
    const double points[] = {0, 0, 0, 1, 0, 0, 1, 2, 0};
    double t[3];
    CHECK_OK(batten_parametrize((batten_points){3, 3, points}, BATTEN_FOLEY_CHORD, false, t));
    CHECK_NEAR(t[1], 1 + 1.5 * acos(0) * 2 / 3, 1e-14);
    CHECK_NEAR(t[2] - t[1], 2 * (1 + 1.5 * acos(0) * 1 / 3), 1e-14);
    /* Turning back altogether counts no more than a right angle. */
    const double back[] = {0, 2, -1};
    CHECK_OK(batten_parametrize((batten_points){1, 3, back}, BATTEN_FOLEY_CHORD, false, t));
    CHECK_NEAR(t[1], 2 * (1 + 1.5 * acos(0) * 3 / 5), 1e-14);
    const double straight[] = {0, 1, 3};
    CHECK_OK(batten_parametrize((batten_points){1, 3, straight}, BATTEN_FOLEY_CHORD, false, t));
    CHECK_NEAR(t[2], 3, 1e-14);
    CHECK_OK(batten_parametrize((batten_points){1, 3, straight}, BATTEN_FOLEY, false, t));
    CHECK_NEAR(t[2] / t[1], 3, 1e-14);
}

/* Random points in d dimensions that span only `rank` of them, and an affine image. */
static void make_points(test_random *random, int d, int rank, int count, double *points,
                        double *image)
{
    double base[3][3], map[3][3];
    for (int i = 0; i < 9; i++) {
        base[i / 3][i % 3] = test_random_in(random, -1, 1);
        map[i / 3][i % 3] = test_random_in(random, -1, 1) + (i % 4 == 0 ? 2 : 0);
    }
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < d; k++)
            points[i * d + k] = 0;
        for (int r = 0; r < rank; r++) {
            const double c = test_random_in(random, -1, 1);
            for (int k = 0; k < d; k++)
                points[i * d + k] += c * base[r][k];
        }
        for (int k = 0; k < d; k++) {
            image[i * d + k] = 5;
            for (int j = 0; j < d; j++)
                image[i * d + k] += 1000 * map[k][j] * points[i * d + j];
        }
    }
}

TEST(foley_with_nielsons_metric_is_affine_invariant_and_chords_are_not)
{
    test_random random = test_random_begin("affine");
    for (int c = 0; c < test_cases(60); c++) {
        const int d = 1 + c % 3, rank = 1 + (c / 3) % d, count = 7;
        double points[21], image[21], a[8], b[8];
        make_points(&random, d, rank, count, points, image);
        CHECK_OK(batten_parametrize((batten_points){d, count, points}, BATTEN_FOLEY, c % 2, a));
        CHECK_OK(batten_parametrize((batten_points){d, count, image}, BATTEN_FOLEY, c % 2, b));
        for (int i = 0; i < count + c % 2; i++)
            CHECK_NEAR(b[i] / b[count - 1], a[i] / a[count - 1], 1e-9);
        CHECK_OK(batten_parametrize((batten_points){d, count, points}, BATTEN_CHORD, c % 2, a));
        CHECK_OK(batten_parametrize((batten_points){d, count, image}, BATTEN_CHORD, c % 2, b));
        double off = 0;
        for (int i = 0; i < count; i++)
            off = fmax(off, fabs(b[i] / b[count - 1] - a[i] / a[count - 1]));
        CHECK(rank == 1 || off > 1e-6);
    }
}

TEST(a_closed_polygon_has_no_first_corner)
{
    const double points[] = {0, 0, 4, 1, 5, 3, 1, 2}, turned[] = {4, 1, 5, 3, 1, 2, 0, 0};
    double a[5], b[5];
    CHECK_OK(batten_parametrize((batten_points){2, 4, points}, BATTEN_FOLEY_CHORD, true, a));
    CHECK_OK(batten_parametrize((batten_points){2, 4, turned}, BATTEN_FOLEY_CHORD, true, b));
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(b[(i + 3) % 4 + 1] - b[(i + 3) % 4], a[i + 1] - a[i], 1e-14);
}

TEST(G1_coincident_neighbours_are_named)
{
    const double points[] = {0, 0, 1, 1, 1, 1, 2, 0};
    for (int kind = BATTEN_CENTRIPETAL; kind < BATTEN_GIVEN; kind++) {
        double t[4] = {7, 7, 7, 7};
        if (kind == BATTEN_UNIFORM)
            continue;
        CHECK_STATUS(batten_parametrize((batten_points){2, 4, points},
                                        (batten_parametrization)kind, false, t),
                     BATTEN_COINCIDENT);
        CHECK_MESSAGE("points 2 and 3 coincide");
        CHECK(t[0] == 7 && t[3] == 7);
    }
    const double closed[] = {0, 0, 1, 1, 0, 0};
    double t[4];
    CHECK_STATUS(batten_parametrize((batten_points){2, 3, closed}, BATTEN_CHORD, true, t),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 3 and 1 coincide");
    const double zigzag[] = {0x1p60, 0, 1};
    CHECK_STATUS(batten_parametrize((batten_points){1, 3, zigzag}, BATTEN_CHORD, false, t),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("the step 1 is lost");
}

TEST(N1_points_that_are_not_finite_are_refused)
{
    const double points[] = {0, 0, 1, NAN};
    double t[2];
    CHECK_STATUS(batten_parametrize((batten_points){2, 2, points}, BATTEN_CHORD, false, t),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of point 2 is nan");
}

TEST(N2_tiny_and_huge_points_have_right_chords)
{
    const double unit[] = {0, 0, 3, 4, 3, 20};
    const double scales[] = {1e-300, 1e-9, 1e9, 1e300};
    for (int s = 0; s < COUNT(scales); s++) {
        double points[6], t[3];
        for (int i = 0; i < 6; i++)
            points[i] = unit[i] * scales[s];
        for (int kind = BATTEN_CENTRIPETAL; kind < BATTEN_GIVEN; kind++) {
            double expected[3];
            CHECK_OK(batten_parametrize((batten_points){2, 3, unit},
                                        (batten_parametrization)kind, false, expected));
            CHECK_OK(batten_parametrize((batten_points){2, 3, points},
                                        (batten_parametrization)kind, false, t));
            CHECK_NEAR(t[1] / t[2], expected[1] / expected[2], 1e-14);
        }
    }
    const double far[] = {-1e308, 1e308};
    double t[2];
    CHECK_STATUS(batten_parametrize((batten_points){1, 2, far}, BATTEN_CHORD, false, t),
                 BATTEN_OVERFLOW);
    CHECK_STATUS(batten_parametrize((batten_points){1, 2, far}, BATTEN_FOLEY, false, t),
                 BATTEN_OVERFLOW);
}

TEST(requests_for_parameters_that_make_no_sense_are_refused)
{
    double t[4];
    CHECK_STATUS(batten_parametrize((batten_points){4, 1, corner}, BATTEN_CHORD, false, t),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_parametrize((batten_points){2, 1, corner}, BATTEN_CHORD, false, t),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(
        batten_parametrize((batten_points){2, 20000000, corner}, BATTEN_CHORD, false, t),
        BATTEN_TOO_LARGE);
    CHECK_STATUS(batten_parametrize((batten_points){2, 3, corner}, BATTEN_GIVEN, false, t),
                 BATTEN_BAD_ARGUMENT);
}
