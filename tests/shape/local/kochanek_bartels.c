#include <batten/local.h>

#include "support/test.h"

enum { N = 6 };
static const double points[N][2] = {{0, 0}, {1, 2}, {3, 2.5}, {4, 0}, {6, 0.5}, {7, 3}};

static batten_curve *curve_of(const batten_tangents_kochanek_bartels_options *options)
{
    double t[N + 1], leaving[N][2], arriving[N][2];
    batten_curve *curve = NULL;
    CHECK_OK(batten_tangents_kochanek_bartels((batten_points){2, N, points[0]}, options, t,
                                              leaving[0], arriving[0]));
    CHECK_OK(batten_curve_from_tangents((batten_points){2, N, points[0]}, t, leaving[0],
                                        arriving[0], options->closed, &curve));
    return curve;
}

TEST(zeros_give_the_curve_of_catmull_and_rom)
{
    const double alphas[] = {0, 0.4, 0.5, 1};
    for (int a = 0; a < COUNT(alphas); a++)
        for (int closed = 0; closed < 2; closed++)
            for (int kind = 0; kind <= BATTEN_PHANTOM_REPEAT; kind++) {
                batten_tangents_kochanek_bartels_options options =
                    batten_tangents_kochanek_bartels_defaults();
                batten_curve_catmull_rom_options cr = batten_curve_catmull_rom_defaults();
                batten_curve *expected = NULL;
                options.alpha = cr.alpha = alphas[a];
                options.closed = cr.closed = closed;
                options.phantoms = cr.phantoms = (batten_phantoms)kind;
                batten_curve *curve = curve_of(&options);
                CHECK_OK(batten_curve_catmull_rom((batten_points){2, N, points[0]}, &cr, NULL,
                                                  NULL, &expected));
                for (int i = 0; i <= 60; i++) {
                    const double u = batten_curve_domain(curve).b * i / 60;
                    double x[2], y[2];
                    CHECK_OK(batten_curve_evaluate(curve, u, 0, x));
                    CHECK_OK(batten_curve_evaluate(expected, u, 0, y));
                    for (int c = 0; c < 2; c++)
                        CHECK_NEAR(x[c], y[c], 1e-13 * 8);
                }
                batten_curve_unref(curve);
                batten_curve_unref(expected);
            }
}

/* The formulas of the paper, for equal steps. */
TEST(equal_steps_give_the_tangents_of_the_paper)
{
    const double t = 0.3, c = -0.4, b = 0.6;
    double lists[3][N], u[N], leaving[N][2], arriving[N][2];
    for (int i = 0; i < N; i++)
        lists[0][i] = t, lists[1][i] = c, lists[2][i] = b;
    batten_tangents_kochanek_bartels_options options =
        batten_tangents_kochanek_bartels_defaults();
    options.tension = lists[0], options.continuity = lists[1], options.bias = lists[2];
    CHECK_OK(batten_tangents_kochanek_bartels((batten_points){2, N, points[0]}, &options, u,
                                              leaving[0], arriving[0]));
    for (int i = 1; i + 1 < N; i++)
        for (int k = 0; k < 2; k++) {
            const double before = points[i][k] - points[i - 1][k];
            const double after = points[i + 1][k] - points[i][k];
            CHECK_NEAR(arriving[i][k],
                       (1 - t) * (1 - c) * (1 + b) / 2 * before +
                           (1 - t) * (1 + c) * (1 - b) / 2 * after,
                       1e-14);
            CHECK_NEAR(leaving[i][k],
                       (1 - t) * (1 + c) * (1 + b) / 2 * before +
                           (1 - t) * (1 - c) * (1 - b) / 2 * after,
                       1e-14);
        }
}

TEST(extremes_are_the_polygon_the_chords_and_halts)
{
    const double ones[N] = {1, 1, 1, 1, 1, 1}, minus[N] = {-1, -1, -1, -1, -1, -1};
    double u[N], leaving[N][2], arriving[N][2];
    for (int which = 0; which < 4; which++) {
        batten_tangents_kochanek_bartels_options options =
            batten_tangents_kochanek_bartels_defaults();
        options.tension = which == 0 ? ones : NULL;
        options.continuity = which == 1 ? minus : NULL;
        options.bias = which == 2 ? ones : which == 3 ? minus : NULL;
        CHECK_OK(batten_tangents_kochanek_bartels((batten_points){2, N, points[0]}, &options, u,
                                                  leaving[0], arriving[0]));
        for (int i = 1; i + 1 < N; i++)
            for (int k = 0; k < 2; k++) {
                const double before = points[i][k] - points[i - 1][k];
                const double after = points[i + 1][k] - points[i][k];
                const double in[] = {0, before, before, after};
                const double out[] = {0, after, before, after};
                CHECK_NEAR(arriving[i][k], in[which], 1e-15 * 8);
                CHECK_NEAR(leaving[i][k], out[which], 1e-15 * 8);
            }
    }
}

/* Cardinal splines: the tangent is 1 - c halves of the chord over both spans. */
TEST(tension_at_one_point_changes_its_two_spans_alone)
{
    double tension[N] = {0};
    batten_tangents_kochanek_bartels_options options =
        batten_tangents_kochanek_bartels_defaults();
    options.tension = tension;
    batten_curve *loose = curve_of(&options);
    tension[2] = 0.5;
    batten_curve *tight = curve_of(&options);
    for (int i = 0; i <= 100; i++) {
        const double u = 5 * i / 100.0;
        double x[4], y[4];
        CHECK_OK(batten_curve_evaluate(loose, u, 1, x));
        CHECK_OK(batten_curve_evaluate(tight, u, 1, y));
        const bool same = x[0] == y[0] && x[1] == y[1];
        CHECK(same == (u <= 1 || u >= 3 || u == 2));
        if (u == 2)
            for (int k = 0; k < 2; k++)
                CHECK_NEAR(y[2 + k], (points[3][k] - points[1][k]) / 4, 1e-14);
    }
    batten_curve_unref(loose);
    batten_curve_unref(tight);
}

TEST(g2_two_points_are_joined_by_their_chord)
{
    double u[2], leaving[2][2], arriving[2][2];
    CHECK_OK(batten_tangents_kochanek_bartels((batten_points){2, 2, points[0]}, NULL, u,
                                              leaving[0], arriving[0]));
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(leaving[i][k], points[1][k] - points[0][k], 0);
            CHECK_NEAR(arriving[i][k], points[1][k] - points[0][k], 0);
        }
}

TEST(n1_s1_bad_numbers_and_few_points_are_refused)
{
    const double bad[N] = {0, 0, INFINITY, 0, 0, 0};
    double u[N + 1] = {7}, leaving[N][2], arriving[N][2];
    for (int which = 0; which < 3; which++) {
        batten_tangents_kochanek_bartels_options options =
            batten_tangents_kochanek_bartels_defaults();
        *(which == 0   ? &options.tension
          : which == 1 ? &options.continuity
                       : &options.bias) = bad;
        CHECK_STATUS(batten_tangents_kochanek_bartels((batten_points){2, N, points[0]},
                                                      &options, u, leaving[0], arriving[0]),
                     BATTEN_NOT_FINITE);
        CHECK_MESSAGE("at point 3 is inf");
        CHECK_BITS(u[0], 7);
    }
    batten_tangents_kochanek_bartels_options closed =
        batten_tangents_kochanek_bartels_defaults();
    closed.closed = true;
    CHECK_STATUS(batten_tangents_kochanek_bartels((batten_points){2, 2, points[0]}, &closed, u,
                                                  leaving[0], arriving[0]),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_tangents_kochanek_bartels((batten_points){2, 1, points[0]}, NULL, u,
                                                  leaving[0], arriving[0]),
                 BATTEN_TOO_FEW_POINTS);
    const double far[] = {-1.7e308, 1.7e308, -1.7e308};
    CHECK_STATUS(batten_tangents_kochanek_bartels((batten_points){1, 3, far}, NULL, u,
                                                  leaving[0], arriving[0]),
                 BATTEN_OVERFLOW);
}
