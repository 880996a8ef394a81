#include "design/evaluate.h"
#include "design/expect.h"
#include "design/features/change/fair_row.h"

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

TEST(lines_too_short_to_be_made_fair_do_not_spoil_the_verdict)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n  short: {points: [[0, 5], [1, 5]]}\n"
        "  arch: {points: [[0, 0], [1, 0.2], [2, 0.32], [3, 0.33], [4, 0.2], [5, 0]]}\n"
        "  all: {collect: [short, arch]}\n  f: {fair: all, within: 0.01}\n";
    batten_design *design = NULL;
    CHECK_OK(evaluate_design(text, "f", NULL, &design));
    const batten_fair_report *report = batten_design_result(design, "f")->fairing;
    CHECK(report->before.fair);
    CHECK(report->after.fair);
    CHECK_INT(report->moved_count, 4);
    batten_design_free(design);
}
