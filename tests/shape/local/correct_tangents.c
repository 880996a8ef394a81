#include "support/test.h"
#include <batten/curvature.h>
#include <batten/invariants.h>
#include <batten/local.h>
#include <string.h>

static batten_curve *spline(int count, const double *points, batten_parametrization kind)
{
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    batten_curve *curve = NULL;
    o.parameters = kind;
    o.start.kind = o.end.kind = BATTEN_END_NATURAL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, count, points}, &o, NULL, &curve));
    return curve;
}

static int count_bad(const batten_curve *curve)
{
    batten_cubics spans = {0, NULL};
    int bad = 0;
    CHECK_OK(batten_curve_classify(curve, 1e-9, &spans));
    for (int i = 0; i < spans.count; i++)
        bad += spans.at[i].segment == BATTEN_CUBIC_TWO_INFLECTIONS ||
               spans.at[i].segment == BATTEN_CUBIC_LOOP ||
               spans.at[i].segment == BATTEN_CUBIC_CUSP ||
               (spans.at[i].segment == BATTEN_CUBIC_ONE_INFLECTION && spans.at[i].lambda > 0 &&
                spans.at[i].mu > 0);
    batten_cubics_release(&spans);
    return bad;
}

/* Uneven points with uniform parameters: the spline loops. */
static const double uneven[14] = {0, 0, 3, 0.4, 3.3, 1, 3.4, 2, 2.2, 3, 2, 3.02, 0.3, 2};

TEST(limits_are_those_of_the_classes)
{
    test_random random = test_random_begin("limits");
    for (int n = test_cases(20000); n > 0; n--) {
        const double alpha = test_random_in(&random, 0.01, 2),
                     beta = test_random_in(&random, 0.01, 2);
        const double chord = test_random_in(&random, 0.5, 3), side = n % 2 ? 1 : -1;
        const double a = test_random_in(&random, 0.1, 12), b = test_random_in(&random, 0.1, 12);
        double start, end;
        if (alpha + beta >= 3.14159)
            continue;
        CHECK_OK(batten_tangent_limits(chord, side * alpha, side * beta, &start, &end));
        const double points[8] = {0,
                                  0,
                                  a / 3 * cos(alpha),
                                  -side * a / 3 * sin(alpha),
                                  chord - b / 3 * cos(beta),
                                  -side * b / 3 * sin(beta),
                                  chord,
                                  0};
        batten_cubic cubic;
        CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
        if (cubic.margin > 1e-9)
            CHECK_INT(cubic.segment == BATTEN_CUBIC_PLAIN, a <= start && b <= end);
    }
    double start, end;
    CHECK_STATUS(batten_tangent_limits(1, 0.2, -0.3, &start, &end), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_tangent_limits(1, 2, 2, &start, &end), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_tangent_limits(0, 1, 1, &start, &end), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_tangent_limits(NAN, 1, 1, &start, &end), BATTEN_NOT_FINITE);
}

TEST(corrected_splines_have_no_excess)
{
    batten_curve *curve = spline(7, uneven, BATTEN_UNIFORM), *made = NULL;
    batten_curve_correct_tangents_report report;
    int changed[6];
    CHECK(count_bad(curve) > 0);
    CHECK_OK(batten_curve_correct_tangents(curve, NULL, changed, &report, &made));
    CHECK_INT(count_bad(made), 0);
    CHECK_INT(report.incurable, 0);
    CHECK_INT(report.first_incurable, -1);
    CHECK_INT(report.span_count, 6);
    CHECK_INT(report.corrected,
              changed[0] + changed[1] + changed[2] + changed[3] + changed[4] + changed[5]);
    for (int i = 0; i < 7; i++) { /* points stay, and directions */
        double p[4], q[4];
        CHECK_OK(batten_curve_evaluate(made, i, 1, p));
        CHECK_OK(batten_curve_evaluate(curve, i, 1, q));
        CHECK_NEAR(p[0], uneven[2 * i], 1e-14);
        CHECK_NEAR(p[1], uneven[2 * i + 1], 1e-14);
        CHECK_NEAR((p[2] * q[3] - p[3] * q[2]) / (hypot(p[2], p[3]) * hypot(q[2], q[3])), 0,
                   1e-14);
        CHECK(p[2] * q[2] + p[3] * q[3] > 0);
    }
    batten_curve_unref(curve);
    batten_curve_unref(made);
}

TEST(random_splines_are_corrected_but_where_they_turn_too_far)
{
    test_random random = test_random_begin("correct");
    for (int n = test_cases(200); n > 0; n--) {
        double points[20];
        batten_curve_correct_tangents_report report;
        batten_curve_correct_tangents_options o = batten_curve_correct_tangents_defaults();
        o.joins = n % 2 ? BATTEN_CORRECT_CURVATURE : BATTEN_CORRECT_TANGENT;
        for (int i = 0; i < 10; i++) {
            points[2 * i] = i + test_random_in(&random, -0.45, 0.45);
            points[2 * i + 1] = test_random_in(&random, -0.5, 0.5);
        }
        batten_curve *curve = spline(10, points, BATTEN_UNIFORM), *made = NULL;
        CHECK_OK(batten_curve_correct_tangents(curve, &o, NULL, &report, &made));
        CHECK(count_bad(made) <= report.incurable);
        if (report.corrected == 0)
            CHECK(made == curve);
        batten_curve_unref(curve);
        batten_curve_unref(made);
    }
}

TEST(curvatures_are_brought_together_where_they_can)
{
    batten_curve *curve = spline(7, uneven, BATTEN_UNIFORM), *made = NULL, *loose = NULL;
    batten_curve_correct_tangents_options o = batten_curve_correct_tangents_defaults();
    batten_curve_correct_tangents_report tangent, both;
    CHECK_OK(batten_curve_correct_tangents(curve, &o, NULL, &tangent, &loose));
    o.joins = BATTEN_CORRECT_CURVATURE;
    CHECK_OK(batten_curve_correct_tangents(curve, &o, NULL, &both, &made));
    CHECK_INT(tangent.rejoined, 0);
    CHECK(tangent.broken > 0);
    CHECK_INT(both.rejoined + both.broken, tangent.broken);
    CHECK_INT(count_bad(made), 0);
    batten_curve_unref(loose);
    batten_curve_unref(made);
    batten_curve_unref(curve);
}

TEST(curvatures_agree_wherever_both_sides_bend_to_one_side)
{
    /* Where directions bend the spans beside a join to opposite sides no lengths help. Of all
     * other joins at most a few may stay apart. */
    test_random random = test_random_begin("rejoin");
    int together = 0, apart = 0;
    for (int n = 60; n > 0; n--) {
        double points[20];
        batten_curve_correct_tangents_report report;
        batten_curve_correct_tangents_options o = batten_curve_correct_tangents_defaults();
        o.joins = BATTEN_CORRECT_CURVATURE;
        for (int i = 0; i < 10; i++) {
            points[2 * i] = i + test_random_in(&random, -0.45, 0.45);
            points[2 * i + 1] = test_random_in(&random, -0.5, 0.5);
        }
        batten_curve *curve = spline(10, points, BATTEN_UNIFORM), *made = NULL;
        CHECK_OK(batten_curve_correct_tangents(curve, &o, NULL, &report, &made));
        together += report.rejoined;
        for (int k = 1; k < 9; k++) {
            batten_curve_local left, right;
            CHECK_OK(batten_curve_local_at(made, k, BATTEN_FROM_LEFT, &left));
            CHECK_OK(batten_curve_local_at(made, k, BATTEN_FROM_RIGHT, &right));
            const double a = left.curvature, b = right.curvature;
            apart += a * b > 0 && fabs(a - b) > 1e-6 * fmax(fabs(a), fabs(b));
        }
        batten_curve_unref(curve);
        batten_curve_unref(made);
    }
    CHECK(together >= 60);
    CHECK(10 * apart <= together);
}

TEST(a_good_curve_comes_back_itself)
{
    const double points[8] = {0, 0, 1, 0.5, 2, 0.6, 3, 0};
    batten_curve *curve = spline(4, points, BATTEN_CHORD), *made = NULL;
    batten_curve_correct_tangents_report report;
    int changed[3] = {7, 7, 7};
    CHECK_OK(batten_curve_correct_tangents(curve, NULL, changed, &report, &made));
    CHECK(made == curve);
    CHECK_INT(report.corrected + changed[0] + changed[1] + changed[2], 0);
    batten_curve_unref(curve);
    batten_curve_unref(made);
}

TEST(g9_what_cannot_be_corrected_is_named)
{
    /* both tangents lead away from where they would meet */
    const double points[8] = {0, 0, 0, -1, 1, -1, 1, 0}, away[8] = {0, 0, -1, -2, 2, -2, 1, 0};
    const double breaks[2] = {0, 1};
    batten_curve *square = NULL, *far = NULL, *made = NULL;
    batten_curve_correct_tangents_report report;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, points, NULL, &square));
    CHECK_OK(batten_curve_correct_tangents(square, NULL, NULL, &report, &made));
    CHECK_INT(report.incurable, 0); /* parallel tangents: plain */
    batten_curve_unref(made);
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){3, 1, breaks}, away, NULL, &far));
    CHECK_OK(batten_curve_correct_tangents(far, NULL, NULL, &report, &made));
    CHECK_INT(report.corrected, 0);
    batten_curve_unref(made);
    batten_curve_unref(far);
    batten_curve_unref(square);
}

TEST(n6_corrections_to_nothing_are_refused)
{
    batten_curve *curve = spline(7, uneven, BATTEN_UNIFORM), *made = NULL, *space = NULL;
    batten_curve_correct_tangents_options o = batten_curve_correct_tangents_defaults();
    o.within = 0;
    CHECK_STATUS(batten_curve_correct_tangents(curve, &o, NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    o = batten_curve_correct_tangents_defaults();
    o.joins = BATTEN_CORRECT_CURVATURE;
    CHECK_OK(batten_curve_to_dimension(curve, 3, &space));
    CHECK_STATUS(batten_curve_correct_tangents(space, &o, NULL, NULL, &made),
                 BATTEN_UNSUPPORTED);
    CHECK_OK(batten_curve_correct_tangents(space, NULL, NULL, NULL, &made));
    batten_curve_unref(made);
    batten_curve_unref(space);
    batten_curve_unref(curve);
}

TEST(g10_a_reversed_curve_is_corrected_to_the_reversed_curve)
{
    batten_curve *curve = spline(7, uneven, BATTEN_UNIFORM), *back = NULL;
    batten_curve *made = NULL, *back_made = NULL;
    CHECK_OK(batten_curve_reverse(curve, &back));
    CHECK_OK(batten_curve_correct_tangents(curve, NULL, NULL, NULL, &made));
    CHECK_OK(batten_curve_correct_tangents(back, NULL, NULL, NULL, &back_made));
    for (int i = 0; i <= 60; i++) {
        double p[2], q[2];
        CHECK_OK(batten_curve_evaluate(made, i / 10.0, 0, p));
        CHECK_OK(batten_curve_evaluate(back_made, -i / 10.0, 0, q));
        CHECK_NEAR(hypot(p[0] - q[0], p[1] - q[1]), 0, 1e-13);
    }
    batten_curve_unref(curve);
    batten_curve_unref(back);
    batten_curve_unref(made);
    batten_curve_unref(back_made);
}
