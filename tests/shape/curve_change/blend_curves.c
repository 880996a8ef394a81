#include "support/faults.h"
#include "support/test.h"
#include <batten/blend.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

static const batten_curve_end at_start = BATTEN_CURVE_START, at_end = BATTEN_CURVE_END;

static void random_curve(test_random *random, int dimension, double shift, batten_curve **out)
{
    double points[15], weights[5];
    const double knots[9] = {0, 0, 0, 0, 0.4, 1, 1, 1, 1};
    for (int i = 0; i < 5; i++) {
        for (int k = 0; k < dimension; k++)
            points[i * dimension + k] =
                (k == 0 ? i + shift : 0) + test_random_in(random, -0.3, 0.3);
        weights[i] = test_random_in(random, 0.7, 1.4);
    }
    CHECK_OK(batten_curve_create((batten_points){dimension, 5, points}, 3,
                                 test_random_int(random, 0, 1) ? weights : NULL, knots, out));
}

TEST(blends_join_as_asked_at_either_end)
{
    test_random random = test_random_begin("blend");
    for (int n = test_cases(64); n > 0; n--) {
        const int dimension = test_random_int(&random, 2, 3);
        batten_curve *a = NULL, *b = NULL, *blend = NULL;
        random_curve(&random, dimension, 0, &a);
        random_curve(&random, dimension, 7, &b);
        const batten_blend_end ends[2] = {
            {n % 2 ? at_end : at_start, test_random_int(&random, 0, 3),
             test_random_in(&random, 0.5, 2)},
            {n % 3 ? at_end : at_start, test_random_int(&random, 0, 3),
             test_random_in(&random, 0.5, 2)}};
        batten_curves_blend_report report;
        CHECK_EACH_ALLOCATION(batten_curves_blend(a, &ends[0], b, &ends[1], &report, &blend));
        CHECK_INT(batten_curve_degree(blend), ends[0].continuity + ends[1].continuity + 1);
        batten_continuity join;
        CHECK_OK(batten_curves_continuity(a, ends[0].end, blend, at_start, NULL, &join));
        CHECK(join.geometric >= ends[0].continuity && join.gap == 0);
        CHECK(ends[0].continuity < 2 || join.curvature_part < 1e-9);
        CHECK(ends[0].continuity < 3 || join.rate_part < 1e-6);
        CHECK_OK(batten_curves_continuity(blend, at_end, b, ends[1].end, NULL, &join));
        CHECK(join.geometric >= ends[1].continuity && join.gap == 0);
        CHECK(report.joins[1].geometric == join.geometric);
        batten_curve_unref(blend);
        batten_curve_unref(b);
        batten_curve_unref(a);
    }
}

TEST(a_piece_cut_out_of_a_cubic_is_its_own_blend)
{
    const double points[] = {0, 0, 1, 2, 3, 3, 4, 0}, breaks[] = {0, 1};
    batten_curve *whole = NULL, *a = NULL, *b = NULL, *blend = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, points, NULL, &whole));
    CHECK_OK(batten_curve_subrange(whole, 0, 0.3, &a));
    CHECK_OK(batten_curve_subrange(whole, 0.8, 1, &b));
    batten_blend_end ends[2] = {{at_end, 1, 1}, {at_start, 1, 1}};
    batten_curves_blend_report report;
    CHECK_EACH_ALLOCATION(batten_curves_blend(a, &ends[0], b, &ends[1], &report, &blend));
    batten_curve_unref(blend);
    static const double at[2] = {0.3, 0.8};
    for (int k = 0; k < 2; k++) {
        double c[4];
        CHECK_OK(batten_curve_evaluate(whole, at[k], 1, c));
        ends[k].bulge = 0.5 * hypot(c[2], c[3]) / report.speed[k];
    }
    CHECK_OK(batten_curves_blend(a, &ends[0], b, &ends[1], &report, &blend));
    for (int i = 0; i <= 20; i++) {
        double p[2], q[2];
        CHECK_OK(batten_curve_evaluate(blend, i / 20.0, 0, p));
        CHECK_OK(batten_curve_evaluate(whole, 0.3 + 0.5 * i / 20, 0, q));
        CHECK(hypot(p[0] - q[0], p[1] - q[1]) <= 1e-14);
    }
    batten_curve_unref(blend);
    batten_curve_unref(b);
    batten_curve_unref(a);
    batten_curve_unref(whole);
}

TEST(blends_of_a_circle_with_itself_stay_near_it)
{
    /* A gap of 60 degrees in the unit circle; the largest | |P| - 1 |. For G1 the cubic of
     * legs 4/3 tan(15 degrees), which is right to 2.4e-5. */
    static const double most[4] = {0.134, 3e-5, 1e-4, 5e-5};
    batten_curve *arc = NULL, *blend = NULL;
    CHECK_OK(batten_curve_arc(1, 5 * PI / 3, &arc));
    for (int g = 0; g < 4; g++) {
        const batten_blend_end ends[2] = {{at_end, g, 1}, {at_start, g, 1}};
        double worst = 0;
        CHECK_OK(batten_curves_blend(arc, &ends[0], arc, &ends[1], NULL, &blend));
        for (int i = 0; i <= 200; i++) {
            double p[2];
            CHECK_OK(batten_curve_evaluate(blend, i / 200.0, 0, p));
            worst = fmax(worst, fabs(hypot(p[0], p[1]) - 1));
        }
        CHECK(worst <= most[g]);

        batten_curve_unref(blend);
    }
    batten_curve_unref(arc);
}

TEST(a_blend_run_backwards_is_the_blend_of_the_reversed_curves)
{
    test_random random = test_random_begin("blend-back");
    batten_curve *a = NULL, *b = NULL, *there = NULL, *back = NULL;
    random_curve(&random, 3, 0, &a);
    random_curve(&random, 3, 6, &b);
    const batten_blend_end first = {at_end, 2, 1.3}, second = {at_start, 3, 0.8};
    CHECK_OK(batten_curves_blend(a, &first, b, &second, NULL, &there));
    CHECK_OK(batten_curves_blend(b, &second, a, &first, NULL, &back));
    for (int i = 0; i <= 20; i++) {
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate(there, i / 20.0, 0, p));
        CHECK_OK(batten_curve_evaluate(back, 1 - i / 20.0, 0, q));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(p[k], q[k], 1e-13);
    }
    batten_curve_unref(back);
    batten_curve_unref(there);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(the_nearest_ends_are_found)
{
    const double p[] = {0, 0, 1, 0, 5, 0, 2, 0};
    batten_curve *a = NULL, *b = NULL;
    batten_curve_end ends[2];
    CHECK_OK(batten_curve_line(2, p, p + 2, &a));
    CHECK_OK(batten_curve_line(2, p + 4, p + 6, &b));
    CHECK_EACH_ALLOCATION(batten_curves_nearest_ends(a, b, ends));
    CHECK(ends[0] == at_end && ends[1] == at_end);
    CHECK_EACH_ALLOCATION(batten_curves_nearest_ends(b, a, ends));
    CHECK(ends[0] == at_end && ends[1] == at_end);
    CHECK_OK(batten_curves_nearest_ends(a, a, ends));
    CHECK(ends[0] == at_end && ends[1] == at_end);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(N1_G4_blends_that_cannot_be_are_refused)
{
    const double p[] = {0, 0, 1, 0, 1, 0, 1, 0, 3, 1}, one[] = {0, 1}, breaks[] = {0, 1};
    batten_curve *still = NULL, *line = NULL, *space = NULL, *function = NULL, *out = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, p, NULL, &still));
    CHECK_OK(batten_curve_line(2, p + 6, p + 8, &line));
    CHECK_OK(batten_curve_line(3, p + 2, p + 7, &space));
    CHECK_OK(batten_curve_line(1, one, one + 1, &function));
    const batten_blend_end g1 = {at_end, 1, 1}, g4 = {at_end, 4, 1}, flat = {at_end, 1, 0},
                           nan = {at_end, 1, NAN}, below = {at_end, -1, 1}, g0 = {at_end, 0, 1},
                           start = {at_start, 0, 1};
    CHECK_STATUS(batten_curves_blend(still, &g1, line, &g1, NULL, &out), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the first curve stands still at its end, where G1 is asked");
    CHECK_STATUS(batten_curves_blend(line, &g1, still, &g1, NULL, &out), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the second curve stands still at its end, where G1 is asked");
    CHECK_STATUS(batten_curves_blend(still, &g0, line, &start, NULL, &out), BATTEN_COINCIDENT);
    const struct {
        const batten_blend_end *first, *second;
        const char *words;
    } bad[] = {
        {&g4, &g1, "continuity G4 at end 1, not G0 to G3"},
        {&g1, &below, "continuity G-1 at end 2, not G0 to G3"},
        {&g1, &flat, "the bulge at end 2 is 0, not above 0"},
        {&nan, &g1, "the bulge at end 1 is nan, not above 0"},
    };
    for (int i = 0; i < COUNT(bad); i++) {
        CHECK_STATUS(batten_curves_blend(line, bad[i].first, line, bad[i].second, NULL, &out),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(bad[i].words);
    }
    CHECK_STATUS(batten_curves_blend(line, &g1, space, &g1, NULL, &out), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the curves have 2 and 3 dimensions");
    CHECK_STATUS(batten_curves_blend(function, &g1, function, &g1, NULL, &out),
                 BATTEN_UNSUPPORTED);
    CHECK(out == NULL);
    batten_curve_unref(function);
    batten_curve_unref(space);
    batten_curve_unref(line);
    batten_curve_unref(still);
}
