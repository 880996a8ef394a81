#include "fair/fairness.h"
#include "support/test.h"
#include <batten/interpolate.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

TEST(a_circle_is_fair_and_its_numbers_are_those_of_its_radius)
{
    batten_curve *circle = NULL;
    batten_fairness found;
    CHECK_OK(batten_curve_arc(2, 2 * PI, &circle));
    CHECK_OK(batten_curve_fairness(
        circle, (batten_points){batten_curve_dimension(circle), 0, NULL}, NULL, &found));
    CHECK_INT(found.inflections, 0);
    CHECK_INT(found.curvature_extrema, 0);
    CHECK_NEAR(found.max_curvature, 0.5, 1e-11);
    CHECK_NEAR(found.energy, 2 * PI / 2, 1e-10);
    CHECK_NEAR(found.variation, 0, 1e-18);
    CHECK_NEAR(found.jumps, 0, 1e-15);
    CHECK(found.fair);
    batten_curve_unref(circle);
}

TEST(a_natural_spline_has_the_energy_and_the_jumps_of_its_ducks)
{
    enum { N = 12 };
    double t[N], z[N], moments[N], forces[N], jumps = 0;
    bat_batten batten;
    batten_curve *curve = NULL;
    batten_fairness found;
    for (int i = 0; i < N; i++) {
        t[i] = i + 0.3 * sin(3.0 * i);
        z[i] = cos(1.7 * i);
    }
    CHECK_OK(bat_batten_begin(N, t, &batten));
    const double energy = bat_batten_bend(&batten, 1, z, moments, forces);
    for (int i = 1; i < N - 1; i++)
        jumps += forces[i] * forces[i];
    CHECK_OK(bat_batten_curve(&batten, 1, z, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){batten_curve_dimension(curve), N, z},
                                   NULL, &found));
    CHECK_NEAR(found.energy, energy, 1e-12 * energy);
    CHECK_NEAR(found.jumps, jumps, 1e-11 * jumps);
    int changes = 0;
    double variation = 0, most = 0;
    for (int i = 0; i + 1 < N; i++) {
        const double h = t[i + 1] - t[i], rate = (moments[i + 1] - moments[i]) / h;
        changes += moments[i] * moments[i + 1] < 0;
        variation += rate * rate * h;
        most = fmax(most, fabs(moments[i]));
    }
    CHECK_INT(found.inflections, changes);
    CHECK_NEAR(found.variation, variation, 1e-11 * variation);
    CHECK_NEAR(found.max_curvature, most, 1e-12 * most);
    CHECK(found.excess_inflections <= found.inflections);
    batten_curve_unref(curve);
    bat_batten_end(&batten);
}

TEST(jumps_of_curves_are_those_of_their_curvature_rate)
{
    /* the same function as a graph in the plane and, rotated, in space: dk/ds jumps by s'''
     * where s' = s'' = 0 */
    const double breaks[3] = {-1, 0, 1}; /* 0 | u^3: s''' jumps by 6 */
    const double plane[2][4][2] = {{{-1, 0}, {1, 0}}, {{0, 0}, {1, 0}, {0, 0}, {0, 1}}};
    const double space[2][4][3] = {{{-1, 0, 0}, {1, 0, 0}},
                                   {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0.6, 0.8}}};
    for (int d = 2; d <= 3; d++) {
        batten_curve *curve = NULL;
        batten_fairness found;
        CHECK_OK(batten_curve_from_power(d, (batten_pieces){3, 2, breaks},
                                         d == 2 ? &plane[0][0][0] : &space[0][0][0], 1e-12,
                                         &curve));
        CHECK_OK(batten_curve_fairness(
            curve, (batten_points){batten_curve_dimension(curve), 0, NULL}, NULL, &found));
        CHECK_NEAR(found.jumps, 36, 1e-9);
        CHECK_INT(found.inflections, 0);
        batten_curve_unref(curve);
    }
}

TEST(inflections_that_the_data_have_are_no_excess)
{
    /* a full wave of the sine has one inflection inside */
    enum { N = 21 };
    double t[N], z[N];
    bat_batten batten;
    batten_curve *curve = NULL;
    batten_fairness found;
    for (int i = 0; i < N; i++) {
        t[i] = 2 * PI * i / (N - 1);
        z[i] = sin(t[i]);
    }
    CHECK_OK(bat_batten_begin(N, t, &batten));
    CHECK_OK(bat_batten_curve(&batten, 1, z, &curve));
    CHECK_OK(batten_curve_fairness(curve, (batten_points){batten_curve_dimension(curve), N, z},
                                   NULL, &found));
    CHECK_INT(found.inflections, 1);
    CHECK_INT(found.excess_inflections, 0);
    CHECK(found.fair);
    CHECK_OK(batten_curve_fairness(
        curve, (batten_points){batten_curve_dimension(curve), 0, NULL}, NULL, &found));
    CHECK_INT(found.excess_inflections, 1);
    CHECK(!found.fair);
    CHECK_STATUS(batten_curve_fairness(curve,
                                       (batten_points){batten_curve_dimension(curve), N - 1, z},
                                       NULL, &found),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curve_fairness(curve,
                                       (batten_points){batten_curve_dimension(curve), -1, z},
                                       NULL, &found),
                 BATTEN_BAD_ARGUMENT);
    z[3] = NAN;
    CHECK_STATUS(batten_curve_fairness(
                     curve, (batten_points){batten_curve_dimension(curve), N, z}, NULL, &found),
                 BATTEN_NOT_FINITE);
    batten_curve_unref(curve);
    bat_batten_end(&batten);
}

TEST(G4_a_curve_with_a_cusp_is_judged_and_its_energy_infinite)
{
    const double powers[2][4][2] = {{{1, -1}, {-2, 3}, {1, -3}, {0, 1}},
                                    {{0, 0}, {0, 0}, {1, 0}, {0, 1}}};
    const double breaks[3] = {-1, 0, 1};
    batten_curve *curve = NULL;
    batten_fairness found;
    CHECK_OK(batten_curve_from_power(2, (batten_pieces){3, 2, breaks}, &powers[0][0][0], 1e-12,
                                     &curve));
    CHECK_OK(batten_curve_fairness(
        curve, (batten_points){batten_curve_dimension(curve), 0, NULL}, NULL, &found));
    CHECK(isinf(found.energy) && isinf(found.variation) && isfinite(found.jumps));
    batten_curve_unref(curve);
}

TEST(a_family_has_sums_and_maxima_and_is_fair_when_all_are)
{
    batten_fairness sum = {.fair = true};
    const batten_fairness a = {.inflections = 1,
                               .curvature_extrema = 2,
                               .jumps = 3,
                               .energy = 4,
                               .energy_error = 0.5,
                               .variation = 5,
                               .variation_error = 0.25,
                               .max_curvature = 6,
                               .fair = true,
                               .corners = 1,
                               .cusps = 1,
                               .halts = 2,
                               .curvature_jumps = 2,
                               .largest_turn = 0.5,
                               .largest_jump = 3};
    const batten_fairness b = {.inflections = 1,
                               .excess_inflections = 1,
                               .curvature_extrema = 1,
                               .jumps = 1,
                               .energy = 1,
                               .energy_error = 0.5,
                               .variation = 1,
                               .variation_error = 0.5,
                               .max_curvature = 1,
                               .corners = 2,
                               .cusps = 0,
                               .halts = 1,
                               .curvature_jumps = 3,
                               .largest_turn = 0.75,
                               .largest_jump = 1};
    batten_fairness_add(&sum, &a);
    CHECK(sum.fair);
    batten_fairness_add(&sum, &b);
    CHECK(!sum.fair);
    CHECK_INT(sum.inflections, 2);
    CHECK_INT(sum.excess_inflections, 1);
    CHECK_INT(sum.curvature_extrema, 3);
    CHECK_NEAR(sum.jumps, 4, 0);
    CHECK_NEAR(sum.energy, 5, 0);
    CHECK_NEAR(sum.variation, 6, 0);
    CHECK_NEAR(sum.max_curvature, 6, 0);
    CHECK_INT(sum.corners, 3);
    CHECK_INT(sum.curvature_jumps, 5);
    CHECK_NEAR(sum.energy_error, 1, 0);
    CHECK_NEAR(sum.variation_error, 0.75, 0);
    CHECK_INT(sum.cusps, 1);
    CHECK_INT(sum.halts, 3);
    CHECK_NEAR(sum.largest_turn, 0.75, 0);
    CHECK_NEAR(sum.largest_jump, 3, 0);
}

/* Pieces of degree 2 that meet at the origin: along x, as parabolas of curvatures k and 2; or
 * with a turn. Both halves alone have a finite energy. */
static void judge_joint(double k, double turn, int corners, int jumps)
{
    static const double knots[] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double points[] = {-2, 2 * k, -1, 0, 0, 0, 1, turn, 2, 4 + 2 * turn};
    batten_curve *curve = NULL;
    batten_fairness found;
    CHECK_OK(batten_curve_create((batten_points){2, 5, points}, 2, NULL, knots, &curve));
    CHECK_OK(batten_curve_fairness(
        curve, (batten_points){batten_curve_dimension(curve), 0, NULL}, NULL, &found));
    CHECK_INT(found.corners, corners);
    CHECK_INT(found.curvature_jumps, jumps);
    CHECK_INT(isfinite(found.energy), corners == 0);
    CHECK_INT(isfinite(found.variation), corners + jumps == 0);
    batten_curve_unref(curve);
}

TEST(corners_make_the_energy_infinite_and_jumps_of_curvature_the_variation)
{
    judge_joint(2, 0, 0, 0);
    judge_joint(2 * (1 + 1e-8), 0, 0, 0);
    judge_joint(2 * (1 + 1e-5), 0, 0, 1);
    judge_joint(0.5, 0, 0, 1);
    judge_joint(-2, 0, 0, 1);
    judge_joint(2, 1e-8, 0, 0);
    judge_joint(2, 1e-3, 1, 0);
}

/* A function with the second derivatives 6, 6 + wave, 6, 6 + wave ... at its knots, and linear
 * between them: each knot inside is an extremum. */
static int waves_of(double wave)
{
    enum { SPANS = 6 };
    double powers[SPANS][4] = {{0}}, breaks[SPANS + 1] = {0};
    for (int i = 0; i < SPANS; i++) {
        const double *last = powers[i > 0 ? i - 1 : 0];
        const double k = i % 2 ? 6 + wave : 6, rate = i % 2 ? -wave : wave;
        breaks[i + 1] = i + 1;
        powers[i][0] = i ? last[0] + last[1] + last[2] + last[3] : 0;
        powers[i][1] = i ? last[1] + 2 * last[2] + 3 * last[3] : 0;
        powers[i][2] = k / 2;
        powers[i][3] = rate / 6;
    }
    batten_curve *curve = NULL;
    batten_fairness found;
    CHECK_OK(batten_curve_from_power(1, (batten_pieces){3, SPANS, breaks}, &powers[0][0], 1e-12,
                                     &curve));
    CHECK_OK(batten_curve_fairness(
        curve, (batten_points){batten_curve_dimension(curve), 0, NULL}, NULL, &found));
    CHECK_INT(found.corners + found.curvature_jumps, 0);
    batten_curve_unref(curve);
    return found.curvature_extrema;
}

TEST(waves_of_a_millionth_of_the_curvature_are_no_extrema)
{
    CHECK_INT(waves_of(1), 5);
    CHECK_INT(waves_of(1e-4), 5);
    CHECK_INT(waves_of(1e-7), 0);
}

/* y = |x|, then with a step of the second derivative alone. */
TEST(functions_are_judged_by_their_first_and_second_derivative)
{
    static const double knots[] = {-1, -1, -1, 0, 0, 1, 1, 1};
    static const double values[2][5] = {{1, 0.5, 0, 0.5, 1}, {1, 0.5, 0, -0.5, 0}};
    for (int k = 0; k < 2; k++) {
        batten_curve *curve = NULL;
        batten_fairness found;
        CHECK_OK(batten_curve_create((batten_points){1, 5, values[k]}, 2, NULL, knots, &curve));
        CHECK_OK(batten_curve_fairness(
            curve, (batten_points){batten_curve_dimension(curve), 0, NULL}, NULL, &found));
        CHECK_INT(found.corners, k == 0);
        CHECK_INT(found.curvature_jumps, k == 1);
        CHECK_INT(isfinite(found.energy), k == 1);
        CHECK(!isfinite(found.variation));
        batten_curve_unref(curve);
    }
}

TEST(waves_within_the_error_of_a_curve_are_not_counted)
{
    /* a cubic spline through points of a line, moved by 1e-7 in turn */
    enum { N = 41 };
    double points[2 * N];
    batten_fairness_options options = batten_fairness_defaults();
    batten_fairness found[2];
    batten_curve *curve = NULL;
    for (int i = 0; i < N; i++) {
        points[2 * i] = i / 4.0;
        points[2 * i + 1] = 1e-7 * (i % 2);
    }
    CHECK_OK(batten_curve_interpolate((batten_points){2, N, points}, NULL, NULL, &curve));
    for (int k = 0; k < 2; k++) {
        options.error = k ? 1e-6 : 0;
        CHECK_OK(
            batten_curve_fairness(curve, (batten_points){2, 0, NULL}, &options, &found[k]));
    }
    CHECK(found[0].inflections > 10);
    CHECK_INT(found[1].inflections, 0);
    CHECK_NEAR(found[1].energy, found[0].energy, 0);
    options.error = -1;
    CHECK_STATUS(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, &options, &found[0]),
                 BATTEN_BAD_ARGUMENT);
    batten_curve_unref(curve);
}
