#include "support/test.h"
#include <batten/curvature.h>
#include <batten/local.h>
#include <batten/measure.h>

/* A key: an arch, a straight run, an arch. */
static const double key[16] = {0, 0, 1, 1, 2, 1.2, 3, 1, 5, 0.5, 6, 0.6, 6.6, 1.2, 6.4, 2};
static const int line_at[1] = {3};

static batten_curve_cornered_options with_line(void)
{
    batten_curve_cornered_options o = batten_curve_cornered_defaults();
    o.line_count = 1;
    o.lines = line_at;
    return o;
}

static void turn_at(const batten_curve *curve, double u, double *turn, double *curvature)
{
    batten_curve_local a, b;
    CHECK_OK(batten_curve_local_at(curve, u, BATTEN_FROM_LEFT, &a));
    CHECK_OK(batten_curve_local_at(curve, u, BATTEN_FROM_RIGHT, &b));
    *turn = a.tangent.x * b.tangent.y - a.tangent.y * b.tangent.x;
    *curvature = b.curvature - a.curvature;
}

TEST(straight_runs_are_straight_and_touched)
{
    for (int kind = 0; kind < 2; kind++) {
        batten_curve_cornered_options o = with_line();
        double t[8], at[2], turn, jump;
        batten_curve *made = NULL;
        o.transition = (batten_transition)kind;
        CHECK_OK(batten_curve_cornered((batten_points){2, 8, key}, &o, t, &made));
        for (int i = 0; i < 8; i++) {
            CHECK_OK(batten_curve_evaluate(made, t[i], 0, at));
            CHECK_NEAR(hypot(at[0] - key[2 * i], at[1] - key[2 * i + 1]), 0, 1e-14);
        }
        for (int i = 0; i <= 10; i++) {
            CHECK_OK(batten_curve_evaluate(made, t[3] + (t[4] - t[3]) * i / 10, 0, at));
            CHECK_NEAR((at[0] - 3) * -0.5 - (at[1] - 1) * 2, 0, 1e-14);
        }
        for (int i = 3; i <= 4; i++) {
            turn_at(made, t[i], &turn, &jump);
            CHECK_NEAR(turn, 0, 1e-13);
            if (kind == BATTEN_TRANSITION_CURVATURE)
                CHECK_NEAR(jump, 0, 1e-12);
            else
                CHECK(fabs(jump) > 1e-3);
        }
        for (int i = 1; i <= 2; i++) { /* smooth elsewhere */
            turn_at(made, t[i], &turn, &jump);
            CHECK_NEAR(turn, 0, 1e-13);
            CHECK_NEAR(jump, 0, 1e-12);
        }
        batten_curve_unref(made);
    }
}

TEST(corners_turn_and_nothing_else)
{
    const int corners[2] = {2, 5};
    batten_curve_cornered_options o = batten_curve_cornered_defaults();
    double t[8], turn, jump;
    batten_curve *made = NULL;
    o.corner_count = 2;
    o.corners = corners;
    CHECK_OK(batten_curve_cornered((batten_points){2, 8, key}, &o, t, &made));
    for (int i = 1; i < 7; i++) {
        turn_at(made, t[i], &turn, &jump);
        if (i == 2 || i == 5)
            CHECK(fabs(turn) > 1e-3);
        else
            CHECK_NEAR(turn, 0, 1e-13);
    }
    batten_curve_unref(made);
}

TEST(lines_that_meet_make_a_polyline)
{
    const double square[10] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0};
    const int all[4] = {0, 1, 2, 3};
    batten_curve_cornered_options o = batten_curve_cornered_defaults();
    double length;
    batten_curve *made = NULL;
    o.line_count = 4;
    o.lines = all;
    CHECK_OK(batten_curve_cornered((batten_points){2, 5, square}, &o, NULL, &made));
    CHECK_OK(batten_curve_length(made, 1e-12, NULL, &length));
    CHECK_NEAR(length, 4, 1e-13);
    batten_curve_unref(made);
}

TEST(a_single_span_between_lines_meets_both)
{
    const double bend[8] = {0, 0, 2, 0, 3, 1, 3, 3};
    const int lines[2] = {0, 2};
    for (int kind = 0; kind < 2; kind++) {
        batten_curve_cornered_options o = batten_curve_cornered_defaults();
        double t[4], turn, jump;
        batten_curve *made = NULL;
        o.line_count = 2;
        o.lines = lines;
        o.transition = (batten_transition)kind;
        CHECK_OK(batten_curve_cornered((batten_points){2, 4, bend}, &o, t, &made));
        for (int i = 1; i <= 2; i++) {
            turn_at(made, t[i], &turn, &jump);
            CHECK_NEAR(turn, 0, 1e-13);
            if (kind == BATTEN_TRANSITION_CURVATURE)
                CHECK_NEAR(jump, 0, 1e-12);
        }
        batten_curve_unref(made);
    }
}

TEST(g10_reversed_points_give_the_reversed_cornered_curve)
{
    for (int kind = 0; kind < 2; kind++) {
        batten_curve_cornered_options o = with_line();
        double back[16], t[8], p[2], q[2];
        batten_curve *a = NULL, *b = NULL;
        const int corner = 5, corner_back = 2;
        o.transition = (batten_transition)kind;
        o.corner_count = 1;
        o.corners = &corner;
        for (int i = 0; i < 8; i++)
            for (int k = 0; k < 2; k++)
                back[2 * i + k] = key[2 * (7 - i) + k];
        CHECK_OK(batten_curve_cornered((batten_points){2, 8, key}, &o, t, &a));
        o.corners = &corner_back;
        CHECK_OK(batten_curve_cornered((batten_points){2, 8, back}, &o, NULL, &b));
        for (int i = 0; i <= 40; i++) {
            CHECK_OK(batten_curve_evaluate(a, t[7] * i / 40, 0, p));
            CHECK_OK(batten_curve_evaluate(b, t[7] * (40 - i) / 40, 0, q));
            CHECK_NEAR(hypot(p[0] - q[0], p[1] - q[1]), 0, 1e-12);
        }
        batten_curve_unref(a);
        batten_curve_unref(b);
    }
}

TEST(n4_corners_outside_the_points_are_refused)
{
    const int corners[2] = {3, 3}, far = 7;
    batten_curve_cornered_options o = batten_curve_cornered_defaults();
    batten_curve *made = NULL;
    o.corner_count = 2;
    o.corners = corners;
    CHECK_STATUS(batten_curve_cornered((batten_points){2, 8, key}, &o, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("corner 2");
    o = batten_curve_cornered_defaults();
    o.line_count = 1;
    o.lines = &far;
    CHECK_STATUS(batten_curve_cornered((batten_points){2, 8, key}, &o, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("line 1");
    o = batten_curve_cornered_defaults();
    o.ends = BATTEN_END_CLAMPED;
    CHECK_STATUS(batten_curve_cornered((batten_points){2, 8, key}, &o, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_cornered((batten_points){2, 1, key}, NULL, NULL, &made),
                 BATTEN_TOO_FEW_POINTS);
}

TEST(g1_coincident_points_are_named_by_cornered_splines)
{
    const double points[6] = {0, 0, 1, 1, 1, 1};
    batten_curve *made = NULL;
    CHECK_STATUS(batten_curve_cornered((batten_points){2, 3, points}, NULL, NULL, &made),
                 BATTEN_COINCIDENT);
}

TEST(a_free_end_behind_a_flat_transition_is_natural_when_asked)
{
    const double points[] = {0, 0, 1, 0, 2, 0.3, 3, 1.2, 3.5, 2.5};
    const int lines[] = {0};
    for (int natural = 0; natural < 2; natural++) {
        batten_curve_cornered_options o = batten_curve_cornered_defaults();
        batten_curve *curve = NULL;
        double c[6], start[6], t[5];
        o.lines = lines;
        o.line_count = 1;
        o.transition = BATTEN_TRANSITION_CURVATURE;
        o.ends = natural ? BATTEN_END_NATURAL : BATTEN_END_NOT_A_KNOT;
        CHECK_OK(batten_curve_cornered((batten_points){2, 5, points}, &o, t, &curve));
        CHECK_OK(batten_curve_evaluate(curve, t[4], 2, c));
        CHECK_OK(batten_curve_evaluate_side(curve, t[1], BATTEN_FROM_RIGHT, 2, start));
        CHECK_NEAR(hypot(start[4], start[5]), 0, 1e-12);
        if (natural)
            CHECK_NEAR(hypot(c[4], c[5]), 0, 1e-12);
        else
            CHECK(hypot(c[4], c[5]) > 1e-3);
        batten_curve_unref(curve);
    }
}
