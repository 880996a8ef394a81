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
    static const char *const methods[] = {"circle-rate", "kjellander", "least-change"};
    for (int k = 0; k < COUNT(methods); k++) {
        char feature[80];
        options = batten_fair_defaults(0.005);
        options.method = (batten_fair_method)(k + 1);
        snprintf(feature, sizeof feature, "{fair: p, within: 0.005, method: %s}", methods[k]);
        check_against_call(feature, &options);
    }
}

/* ---- control points ---- */

static const char design_of_nets[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  flat: {points: [[0, 0, 2], [1, 1, 2], [2, 1.6, 2], [3, 2.4, 2], [4, 2.3, 2], [5, 2.4, 2], [6, "
    "1.9, 2], [7, 1.2, 2], [8, 0, 2]]}\n"
    "  lifted: {points: [[0, 0, 0], [1, 1, 1], [2, 1.6, 1], [3, 2.4, 2], [4, 2.3, 3], [5, 2.4, 2], [6, "
    "1.9, 2]]}\n"
    "  ring: {points: [[1, 0, 2], [0.7, 0.8, 2], [-0.6, 0.7, 2], [-1, 0.1, 2], [-0.7, -0.7, 2], [0.7, "
    "-0.7, 2]]}\n"
    "  a: {b-spline: flat}\n"
    "  s: {b-spline: lifted}\n"
    "  r: {b-spline: ring, ends: closed}\n"
    "  all: {collect: [a, s, r]}\n"
    "  f: {fair: all, within: 0.05, method: %s}\n";

static double farthest(const batten_curve *a, const batten_curve *b)
{
    const batten_interval domain = batten_curve_domain(a);
    double worst = 0, p[3], q[3];
    for (int k = 0; k <= 1000; k++) {
        const double u = fmin(domain.b, domain.a + (domain.b - domain.a) * k / 1000);
        CHECK_OK(batten_curve_evaluate(a, u, 0, p));
        CHECK_OK(batten_curve_evaluate(b, u, 0, q));
        worst = fmax(worst, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
    }
    return worst;
}

TEST(control_points_of_curves_in_planes_in_space_and_closed_move_within_the_bound)
{
    static const char *const methods[] = {"farin-sapidis", "eck-hadenfeld"};
    for (int k = 0; k < COUNT(methods); k++) {
        char text[1200];
        batten_design *design = NULL;
        double reached = 0;
        snprintf(text, sizeof text, design_of_nets, methods[k]);
        CHECK_OK(evaluate_design(text, "f", NULL, &design));
        const batten_feature_result *result = batten_design_result(design, "f");
        for (int i = 0; i < 3; i++) {
            static const char *const given[] = {"a", "s", "r"};
            const batten_curve *
                from =
                   batten_model_object(batten_design_result(design, given[i])->value, 0)->curve,
               *to = batten_model_object(result->value, i)->curve;
            const double moved = farthest(from, to);
            CHECK(moved > 0.02 && moved <= 0.05);
            CHECK_INT(batten_curve_is_periodic(to), i == 2);
            CHECK_INT(batten_curve_point_count(to), batten_curve_point_count(from));
            for (int j = 0; i != 1 && j < batten_curve_point_count(to); j++)
                CHECK(batten_curve_points(to)[3 * j + 2] == 2);
            reached = fmax(reached, moved);
        }
        CHECK(result->move_max >= reached && result->move_max <= 0.05);
        CHECK(result->fairing->after.jumps < result->fairing->before.jumps);
        for (int i = 0; i < result->fairing->move_count; i++)
            CHECK(result->fairing->moves[i].set == 1 || result->fairing->moves[i].to[2] == 2);
        batten_design_free(design);
    }
}

TEST(a_method_refuses_what_has_nothing_that_it_moves)
{
    batten_design *design = NULL;
    char text[1200];
    snprintf(text, sizeof text, "%s  f: {fair: p, within: 0.05, method: eck-hadenfeld}\n",
             design_of_row);
    CHECK_STATUS(evaluate_design(text, "f", NULL, &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("'p' is not a curve, and this method moves control points of curves");
    batten_design_free(design);
    snprintf(text, sizeof text,
             "batten: 1\nfeatures:\n  c: {circle: 1}\n"
             "  f: {fair: c, within: 0.05, method: least-change}\n");
    CHECK_STATUS(evaluate_design(text, "f", NULL, &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("take 'method: farin-sapidis' or 'eck-hadenfeld'");
    batten_design_free(design);
    snprintf(text, sizeof text,
             "%s  c: {polyline: p}\n"
             "  f: {fair: c, within: 0.05, method: eck-hadenfeld}\n",
             design_of_row);
    CHECK_STATUS(evaluate_design(text, "f", NULL, &design), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("'c': a polyline has corners");
    batten_design_free(design);
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
