#include "design/evaluate.h"
#include "design/expect.h"
#include "design/features/change/fair_row.h"

#include <batten/fair.h>

/* Points moved within a bound: the same as the call, lifted into the plane of the points. */

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
    static const char *const methods[] = {"circle-rate", "kjellander", "least-change"};
    for (int k = 0; k < COUNT(methods); k++) {
        char feature[80];
        options = batten_fair_defaults(0.005);
        options.method = (batten_fair_method)(k + 1);
        snprintf(feature, sizeof feature, "{fair: p, within: 0.005, method: %s}", methods[k]);
        check_against_call(feature, &options);
    }
}

/* Natural ends are those of the batten; others may turn where it does not. */
TEST(inflections_that_only_the_ends_of_a_curve_make_are_noted)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  p: {points: [[0, 0], [1, 0.62], [2, 1.05], [3, 1.55], [4, 1.72], [5, 2.01], [6, 2.06], [7, "
        "2.2], [8, 2.1], [9, 2.05], [10, 1.7], [11, 1.45], [12, 0.9], [13, 0.5], [14, -0.3]]}\n"
        "  natural: {interpolate: p, ends: natural}\n"
        "  other: {interpolate: p}\n"
        "  a: {fair: natural, within: 0.06}\n"
        "  b: {fair: other, within: 0.06}\n";
    for (int k = 0; k < 2; k++) {
        batten_design *design = NULL;
        batten_notes *notes;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(evaluate_design(text, k == 0 ? "a" : "b", notes, &design));
        bool noted = batten_notes_dropped(notes) > 0 && k == 1;
        for (int i = 0; i < batten_notes_count(notes); i++)
            noted |=
                strstr(batten_notes_at(notes, i)->text,
                       "'other': the batten through the moved points is fair, but the curve, "
                       "with the ends it had, has 1 inflection in excess") != NULL;
        CHECK_INT(noted, k == 1);
        const batten_feature_result *result = batten_design_result(design, k == 0 ? "a" : "b");
        CHECK_INT(result->fairing->after.excess_inflections, 0);
        batten_notes_free(notes);
        batten_design_free(design);
    }
}

/* Options, and what is said of each that has no effect beside the others; NULL: nothing. */
static const struct {
    const char *options, *remark;
} idle[] = {
    {"order: worst-first, stop-when-fair: yes", NULL},
    {"method: kjellander, stop-when-fair: yes, hold-ends: no", NULL},
    {"stop-when-fair: yes", "'stop-when-fair' has no effect: only methods that move"},
    {"method: least-change, stop-when-fair: yes", "'stop-when-fair' has no effect"},
    {"method: kjellander, order: sweeps", "'order' has no effect: only springback of curves"},
    {"method: circle-rate, hold-ends: no", "'hold-ends' has no effect: by circle rates"},
    {"families: lines", "'families' has no effect: it is of a table"},
    {"corner-angle: 20 deg", "'corner-angle' has no effect: it is of a table"},
};

/* Also true where one was dropped for want of memory. */
static bool has_remark(const batten_notes *notes, const char *text)
{
    bool found = batten_notes_dropped(notes) > 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        found |= strstr(batten_notes_at(notes, i)->text, text) != NULL;
    return found;
}

TEST(options_that_have_no_effect_are_remarked_upon)
{
    for (size_t k = 0; k < sizeof idle / sizeof *idle; k++) {
        char text[900];
        batten_design *design = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        snprintf(text, sizeof text, "%s  f: {fair: p, within: 0.05, %s}\n", design_of_row,
                 idle[k].options);
        CHECK_OK(evaluate_design(text, "f", notes, &design));
        CHECK(idle[k].remark || batten_notes_dropped(notes) > 0 ||
              !has_remark(notes, "has no effect"));
        CHECK(!idle[k].remark || has_remark(notes, idle[k].remark));
        batten_notes_free(notes);
        batten_design_free(design);
    }
}
