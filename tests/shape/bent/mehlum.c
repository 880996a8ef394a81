#include <batten/bent.h>

#include "support/faults.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

static const double ducks[] = {0, 0, 1, 0.6, 2, 0.1, 3.5, 0.4, 4, 1.2};

static double energy(const batten_chain *chain)
{
    double sum = 0;
    for (int i = 0; i < batten_chain_span_count(chain); i++) {
        const batten_span *arc = batten_chain_span(chain, i);
        sum += arc->curvature[0] * arc->curvature[0] * arc->length;
    }
    return sum;
}

TEST(mehlum_arcs_pass_the_points_with_the_directions_of_the_elastica)
{
    for (int closed = 0; closed < 2; closed++)
        for (int arcs = 2; arcs <= 9; arcs++) {
            static const double ring[] = {2, 0, 0.3, 1.4, -1.8, 0.6, -1, -1.2, 0.7, -1.5};
            const double *points = closed ? ring : ducks;
            batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
            batten_chain_nonlinear_options elastica = batten_chain_nonlinear_defaults();
            batten_chain_mehlum_report report;
            batten_chain *chain = NULL, *beam = NULL;
            double angles[5], beams[5], parameters[5];
            options.arcs = arcs;
            options.closed = elastica.closed = closed;
            elastica.family = BATTEN_FAMILY_ELASTICA;
            CHECK_OK(batten_chain_mehlum((batten_points){2, 5, points}, &options, angles,
                                         parameters, &report, &chain));
            CHECK_OK(batten_chain_nonlinear((batten_points){2, 5, points}, &elastica, beams,
                                            NULL, NULL, &beam));
            CHECK_INT(report.arcs, arcs * (closed ? 5 : 4));
            CHECK_INT(batten_chain_span_count(chain), report.arcs);
            CHECK(batten_chain_is_arcs(chain));
            for (int i = 0; i < 5; i++)
                for (int side = 0; side < 2; side++) {
                    double at[4];
                    CHECK_OK(batten_chain_evaluate_side(chain, parameters[i], (batten_side)side,
                                                        1, at));
                    CHECK_NEAR(at[0], points[2 * i], 1e-13);
                    CHECK_NEAR(at[1], points[2 * i + 1], 1e-13);
                    CHECK_NEAR(at[2], cos(beams[i]), 1e-12);
                    CHECK_NEAR(at[3], sin(beams[i]), 1e-12);
                    CHECK_BITS(angles[i], beams[i]);
                }
            /* Arcs are tangent to their neighbours. */
            for (int i = 1; i < report.arcs; i++) {
                const batten_span *a = batten_chain_span(chain, i - 1);
                const batten_span *b = batten_chain_span(chain, i);
                const double turn = a->angle + a->curvature[0] * a->length - b->angle;
                CHECK_NEAR(remainder(turn, 2 * pi), 0, 1e-12);
            }
            batten_chain_unref(chain);
            batten_chain_unref(beam);
        }
}

/* Twice as many arcs are eight times as near; their energy is four times as near, and about
 * that of the elastica: 1.28447309 for these points. */
TEST(mehlum_arcs_come_near_with_order_three_and_their_energy_with_order_two)
{
    double off[4], missed[4];
    for (int r = 0; r < 4; r++) {
        batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
        batten_chain_mehlum_report report;
        batten_chain *chain = NULL;
        double angles[3];
        options.arcs = 4 << r;
        CHECK_OK(batten_chain_mehlum((batten_points){2, 3, ducks}, &options, angles, NULL,
                                     &report, &chain));
        CHECK_NEAR(angles[0], 0.8000326, 1e-7);
        CHECK_NEAR(angles[1], 0.0262808, 1e-7);
        CHECK_NEAR(angles[2], -0.7108030, 1e-7);
        off[r] = report.error;
        missed[r] = fabs(energy(chain) - 1.28447309);
        batten_chain_unref(chain);
    }
    for (int r = 0; r < 3; r++) {
        CHECK_NEAR(log2(off[r] / off[r + 1]), 3, 0.2);
        CHECK_NEAR(log2(missed[r] / missed[r + 1]), 2, 0.2);
    }
}

/* The least arch between parallel tangents: 8 A^2 = 2.8710800442 of energy, less than the pi of
 * a half circle [Horn83]. */
TEST(mehlum_arcs_make_the_least_arch)
{
    static const double gap[] = {0, 0, 2, 0};
    batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
    batten_chain *chain = NULL;
    options.start = options.end = BATTEN_NONLINEAR_TANGENT;
    options.start_value = pi / 2;
    options.end_value = -pi / 2;
    options.arcs = 400;
    CHECK_OK(
        batten_chain_mehlum((batten_points){2, 2, gap}, &options, NULL, NULL, NULL, &chain));
    CHECK_NEAR(energy(chain), 2.8710800442, 1e-4);
    batten_chain_unref(chain);
}

/* What the report says is measured again, densely, by the curve of the elastica. */
TEST(mehlum_arcs_keep_a_tolerance)
{
    int before = 0;
    for (int e = 2; e <= 6; e++) {
        batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
        batten_chain_nonlinear_options elastica = batten_chain_nonlinear_defaults();
        batten_chain_mehlum_report report;
        batten_chain *chain = NULL, *beam = NULL;
        options.arcs = 2;
        options.tolerance = pow(10, -e);
        elastica.family = BATTEN_FAMILY_ELASTICA;
        CHECK_OK(batten_chain_mehlum((batten_points){2, 5, ducks}, &options, NULL, NULL,
                                     &report, &chain));
        CHECK_OK(batten_chain_nonlinear((batten_points){2, 5, ducks}, &elastica, NULL, NULL,
                                        NULL, &beam));
        CHECK(report.error <= options.tolerance);
        CHECK(report.arcs > before);
        before = report.arcs;
        const double end = batten_chain_domain(chain).b, far = batten_chain_domain(beam).b;
        for (int i = 0; i <= 200; i++) {
            double at[2], near = 1;
            CHECK_OK(batten_chain_evaluate(chain, end * i / 200, 0, at));
            /* The place on the elastica: first about the same share, then along its tangent. */
            double s = far * i / 200;
            for (int k = 0; k < 20; k++) {
                double on[4];
                CHECK_OK(batten_chain_evaluate(beam, s, 1, on));
                near = hypot(at[0] - on[0], at[1] - on[1]);
                s += (at[0] - on[0]) * on[2] + (at[1] - on[1]) * on[3];
                s = fmin(fmax(s, 0), far);
            }
            CHECK(near <= report.error * 1.05 + 1e-12);
        }
        batten_chain_unref(chain);
        batten_chain_unref(beam);
    }
}

/* Near rounding the deviation falls unevenly: single arcs more would take thousands of rounds.
 */
TEST(n6_mehlum_reaches_a_tolerance_near_rounding)
{
    batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
    batten_chain_mehlum_report report;
    batten_chain *chain = NULL;
    options.tolerance = 1e-12;
    CHECK_OK(batten_chain_mehlum((batten_points){2, 5, ducks}, &options, NULL, NULL, &report,
                                 &chain));
    CHECK(report.error <= 1e-12);
    batten_chain_unref(chain);
}

TEST(g2_mehlum_of_a_line_is_the_line_and_of_a_circle_no_circle)
{
    static const double line[] = {0, 0, 1, 0.5, 4, 2, 5, 2.5};
    double ring[12];
    for (int i = 0; i < 6; i++) {
        ring[2 * i] = cos(i * 0.2 + 0.1 * i * i);
        ring[2 * i + 1] = sin(i * 0.2 + 0.1 * i * i);
    }
    batten_chain_mehlum_report report;
    batten_chain *chain = NULL;
    CHECK_OK(
        batten_chain_mehlum((batten_points){2, 4, line}, NULL, NULL, NULL, &report, &chain));
    CHECK_NEAR(report.error, 0, 1e-14);
    CHECK_NEAR(batten_chain_domain(chain).b, hypot(5, 2.5), 1e-13);
    batten_chain_unref(chain);
    CHECK_OK(
        batten_chain_mehlum((batten_points){2, 2, line}, NULL, NULL, NULL, &report, &chain));
    CHECK_NEAR(report.jump, 0, 1e-13);
    batten_chain_unref(chain);
    batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
    options.start = options.end = BATTEN_NONLINEAR_CIRCULAR;
    CHECK_OK(batten_chain_mehlum((batten_points){2, 6, ring}, &options, NULL, NULL, &report,
                                 &chain));
    CHECK(report.jump > 1e-4);
    batten_chain_unref(chain);
}

TEST(n1_g1_n6_bad_data_of_mehlum_are_refused)
{
    double points[] = {0, 0, 1, 1, 2, 0};
    batten_chain *chain = NULL;
    batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
    CHECK_STATUS(
        batten_chain_mehlum((batten_points){2, 1, points}, NULL, NULL, NULL, NULL, &chain),
        BATTEN_TOO_FEW_POINTS);
    options.arcs = 1;
    CHECK_STATUS(
        batten_chain_mehlum((batten_points){2, 3, points}, &options, NULL, NULL, NULL, &chain),
        BATTEN_BAD_ARGUMENT);
    options.arcs = 2;
    options.tolerance = -1;
    CHECK_STATUS(
        batten_chain_mehlum((batten_points){2, 3, points}, &options, NULL, NULL, NULL, &chain),
        BATTEN_BAD_ARGUMENT);
    options.tolerance = NAN;
    CHECK_STATUS(
        batten_chain_mehlum((batten_points){2, 3, points}, &options, NULL, NULL, NULL, &chain),
        BATTEN_BAD_ARGUMENT);
    options.tolerance = 1e-30;
    CHECK_STATUS(
        batten_chain_mehlum((batten_points){2, 3, points}, &options, NULL, NULL, NULL, &chain),
        BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("more than 10000");
    points[2] = points[3] = 0;
    CHECK_STATUS(
        batten_chain_mehlum((batten_points){2, 3, points}, NULL, NULL, NULL, NULL, &chain),
        BATTEN_COINCIDENT);
    points[3] = NAN;
    CHECK_STATUS(
        batten_chain_mehlum((batten_points){2, 3, points}, NULL, NULL, NULL, NULL, &chain),
        BATTEN_NOT_FINITE);
    CHECK(!chain);
}

TEST(mehlum_reports_every_lack_of_memory)
{
    static const double points[] = {0, 0, 2, -0.5, 3, 1, 1.5, 2.2, -0.5, 1.3};
    for (int k = 0; k < 4; k++) {
        batten_chain_mehlum_options options = batten_chain_mehlum_defaults();
        options.closed = k & 1;
        options.tolerance = k & 2 ? 1e-3 : 0;
        double angles[5], parameters[5];
        batten_chain *chain = NULL;
        CHECK_EACH_ALLOCATION(
            batten_chain_mehlum((batten_points){2, options.closed ? 5 : 3, points}, &options,
                                angles, parameters, NULL, &chain));
        batten_chain_unref(chain);
    }
}
