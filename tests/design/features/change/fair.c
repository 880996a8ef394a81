#include "design/evaluate.h"
#include "design/expect.h"

#include <batten/fair.h>
#include <batten/interpolate.h>

/* Points moved within a bound: the same as the call, lifted into the plane of the points. */

/* Nearly straight in the plane x = 2, with a bump at point 4 and one of half its height at point 8. */
static const double heights[] = {0, 0, 0, 0.02, 0, 0, 0, 0.01, 0, 0};
enum { COUNT_OF_ROW = 10 };

static const char design_of_row[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  p: {points: [[2, 0, 0], [2, 1, 0], [2, 2, 0], [2, 3, 0.02], [2, 4, 0], [2, 5, 0], [2, 6, 0], "
    "[2, 7, 0.01], [2, 8, 0], [2, 9, 0]]}\n";

static void fair_row(const batten_fair_options *options, double *faired,
                     batten_fair_report *report)
{
    double points[2 * COUNT_OF_ROW], parameters[COUNT_OF_ROW];
    batten_curve_interpolate_options fit = batten_curve_interpolate_defaults();
    batten_curve *curve = NULL;
    for (int i = 0; i < COUNT_OF_ROW; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = heights[i];
    }
    const batten_points row = {2, COUNT_OF_ROW, points};
    CHECK_OK(batten_curve_interpolate(row, &fit, parameters, &curve));
    batten_curve_unref(curve);
    CHECK_OK(batten_fair_points(row, parameters, options, NULL, report, faired));
}

static void check_moves(const batten_fair_move *found, const batten_fair_move *expected,
                        int count)
{
    for (int i = 0; i < count; i++) {
        CHECK_INT(found[i].index, expected[i].index);
        CHECK_NEAR(found[i].from[0], 2, 0);
        CHECK_NEAR(found[i].to[0], 2, 0);
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(found[i].from[k + 1], expected[i].from[k], 1e-14);
            CHECK_NEAR(found[i].to[k + 1], expected[i].to[k], 1e-14);
        }
    }
}

static void check_against_call(const char *feature, const batten_fair_options *options)
{
    char text[900];
    double faired[2 * COUNT_OF_ROW];
    batten_fair_report report = {0};
    batten_design *design = NULL;
    fair_row(options, faired, &report);
    snprintf(text, sizeof text, "%s  a: %s\n", design_of_row, feature);
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    const batten_feature_result *result = batten_design_result(design, "a");
    const batten_object *made = batten_model_object(result->value, 0);
    CHECK(result->has_moves && result->fairing);
    for (int i = 0; i < COUNT_OF_ROW; i++) {
        CHECK_NEAR(made->points[3 * i], 2, 0);
        CHECK_NEAR(made->points[3 * i + 1], faired[2 * i], 1e-14);
        CHECK_NEAR(made->points[3 * i + 2], faired[2 * i + 1], 1e-14);
    }
    CHECK_NEAR(result->move_max, report.max_move, 1e-15);
    CHECK_INT(result->moved_count, report.moved_count);
    CHECK_NEAR(result->fairing->rms_move, report.rms_move, 1e-15);
    CHECK_INT(result->fairing->worst_index, report.worst_index);
    CHECK_NEAR(result->fairing->before.energy, report.before.energy, 1e-12);
    CHECK_NEAR(result->fairing->after.variation, report.after.variation, 1e-12);
    CHECK_INT(result->fairing->after.inflections, report.after.inflections);
    CHECK_INT(result->fairing->move_count, report.move_count);
    check_moves(result->fairing->moves, report.moves, report.move_count);
    CHECK_INT(result->fairing->suspect_count, report.suspect_count);
    check_moves(result->fairing->suspects, report.suspects, report.suspect_count);
    batten_fair_report_release(&report);
    batten_design_free(design);
}

TEST(a_row_is_moved_as_by_its_call_whatever_its_options)
{
    batten_fair_options options = batten_fair_defaults(0.005);
    check_against_call("{fair: p, within: 0.005}", &options);
    options.order = BATTEN_FAIR_WORST_FIRST;
    options.stop_when_fair = true;
    check_against_call("{fair: p, within: 0.005, order: worst-first, stop-when-fair: yes}",
                       &options);
    options = batten_fair_defaults(0.1);
    options.hold_ends = false;
    options.order = BATTEN_FAIR_ALTERNATE;
    check_against_call("{fair: p, within: 0.1, hold-ends: no, order: alternate}", &options);
}

TEST(the_report_of_several_curves_is_the_sum_of_theirs)
{
    char text[900];
    double faired[2 * COUNT_OF_ROW];
    batten_fair_report one = {0};
    batten_design *design = NULL;
    const batten_fair_options options = batten_fair_defaults(0.005);
    fair_row(&options, faired, &one);
    snprintf(text, sizeof text,
             "%s  q: {move: p, by: [1, 0, 0]}\n  both: {collect: [p, q]}\n"
             "  a: {fair: both, within: 0.005}\n",
             design_of_row);
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    const batten_fair_report *sum = batten_design_result(design, "a")->fairing;
    CHECK_INT(sum->moved_count, 2 * one.moved_count);
    CHECK_INT(sum->move_count, 2 * one.move_count);
    for (int i = 0; i < sum->move_count; i++)
        CHECK_INT(sum->moves[i].set, i >= one.move_count);
    CHECK_INT(sum->worst_set, 0);
    CHECK_NEAR(sum->rms_move, one.rms_move, 1e-15);
    CHECK_NEAR(sum->max_move, one.max_move, 1e-15);
    CHECK_NEAR(sum->before.energy, 2 * one.before.energy, 1e-12);
    CHECK_NEAR(sum->after.max_curvature, one.after.max_curvature, 1e-12);
    CHECK_INT(sum->before.inflections, 2 * one.before.inflections);
    CHECK_INT(sum->before.curvature_extrema, 2 * one.before.curvature_extrema);
    CHECK_INT(sum->after.fair, one.after.fair);
    CHECK_INT(sum->before.fair, one.before.fair);
    batten_fair_report_release(&one);
    batten_design_free(design);
}
