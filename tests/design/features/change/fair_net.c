#include "design/evaluate.h"

#include <batten/fair.h>
#include <math.h>
#include <stdio.h>

/* Rows of points that bend one way, one of them wrong and all a little off. */

enum { NU = 8, NV = 6, NODES = NU * NV };

static void net_points(double *points)
{
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            double *p = points + 3 * (i * NV + j);
            p[0] = i;
            p[1] = j;
            p[2] = 3 - 0.05 * (i - 3) * (i - 3) - 0.03 * j * j + 0.01 * ((7 * i + 5 * j) % 4);
        }
    points[3 * (5 * NV + 2) + 2] += 0.5;
}

static void design_text(const char *feature, size_t size, char *out)
{
    double points[3 * NODES];
    size_t used =
        (size_t)snprintf(out, size, "batten: 1\nunits: m\nfeatures:\n  net:\n    points: [");
    net_points(points);
    for (int k = 0; k < NODES; k++) { /* row after row: u runs along the rows */
        const double *p = points + 3 * (k % NU * NV + k / NU);
        used += (size_t)snprintf(out + used, size - used, "%s[%.17g, %.17g, %.17g]",
                                 k > 0 ? ", " : "", p[0], p[1], p[2]);
    }
    snprintf(out + used, size - used, "]\n    columns: %d\n  a: %s\n", NU, feature);
}

static void check_against_call(const char *feature, const batten_net_fair_options *options)
{
    static char text[8000];
    double points[3 * NODES], faired[3 * NODES];
    batten_net_fair_report report = {0};
    batten_design *design = NULL;
    net_points(points);
    CHECK_OK(batten_fair_net((batten_grid){3, NU, NV, points}, options, NULL, &report, faired,
                             NULL));
    design_text(feature, sizeof text, text);
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    const batten_feature_result *result = batten_design_result(design, "a");
    CHECK(result->has_moves && result->fairing && result->fairing->net);
    CHECK_NEAR(result->move_max, report.points.max_move, 1e-15);
    CHECK_INT(result->moved_count, report.points.moved_count);
    CHECK_INT(result->fairing->after.excess_inflections,
              report.points.after.excess_inflections);
    CHECK_INT(result->fairing->suspect_count, report.points.suspect_count);
    CHECK_INT(batten_model_count(result->value), NV);
    for (int j = 0; j < NV; j++) {
        const batten_object *row = batten_model_object(result->value, j);
        CHECK_INT(row->point_count, NU);
        for (int i = 0; i < NU; i++)
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(row->points[3 * i + c], faired[3 * (i * NV + j) + c], 1e-15);
    }
    batten_net_fair_report_release(&report);
    batten_design_free(design);
}

TEST(a_net_is_moved_as_by_its_call_whatever_its_options)
{
    batten_net_fair_options options = batten_net_fair_defaults(0.05);
    check_against_call("{fair-net: net, within: 0.05, form: points}", &options);
    options.parameters = BATTEN_UNIFORM;
    options.hold = 1;
    check_against_call(
        "{fair-net: net, within: 0.05, form: points, parameters: uniform, hold: edges}",
        &options);
    options.parameters = BATTEN_CENTRIPETAL;
    options.hold = 0;
    options.closed_u = true;
    check_against_call("{fair-net: net, within: 0.05, form: points, parameters: centripetal, "
                       "periodic-u: yes}",
                       &options);
    options.closed_u = false;
    options.closed_v = true;
    check_against_call("{fair-net: net, within: 0.05, form: points, parameters: centripetal, "
                       "periodic-v: yes}",
                       &options);
    options = batten_net_fair_defaults(0.05);
    options.method = BATTEN_NET_FAIR_LEAST_CHANGE;
    options.mend_blunders = true;
    options.hold = 2;
    check_against_call("{fair-net: net, within: 0.05, form: points, method: least-change, "
                       "blunders: mend, hold: tangents}",
                       &options);
}

TEST(points_of_a_net_are_held_by_their_number_row_after_row)
{
    static char text[8000];
    double points[3 * NODES];
    batten_design *design = NULL;
    net_points(points);
    design_text("{fair-net: net, within: 0.05, form: points, held-points: [3, 17]}",
                sizeof text, text);
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    const batten_model *rows = batten_design_result(design, "a")->value;
    for (int k = 0; k < NODES; k++) {
        const double *p = points + 3 * (k % NU * NV + k / NU);
        const double *q = batten_model_object(rows, k / NU)->points + 3 * (k % NU);
        const bool stays = p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
        CHECK(stays == (k == 2 || k == 16));
    }
    batten_design_free(design);
    design_text("{fair-net: net, within: 0.05, held-points: [3, 49]}", sizeof text, text);
    CHECK_STATUS(evaluate_design(text, "a", NULL, &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("point 49 is to be held: the points are counted 1 to 48");
}

static void check_notes(const char *feature, const char *const words[2])
{
    static char text[8000];
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    bool found[2] = {false, false};
    design_text(feature, sizeof text, text);
    CHECK_OK(batten_notes_create(40, &notes));
    CHECK_OK(evaluate_design(text, "a", notes, &design));
    for (int k = 0; k < batten_notes_count(notes); k++)
        for (int w = 0; w < 2; w++)
            found[w] = found[w] || strstr(batten_notes_at(notes, k)->text, words[w]);
    CHECK(found[0] || batten_notes_dropped(notes) > 0);
    CHECK(found[1] || batten_notes_dropped(notes) > 0);
    const batten_object *made =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK_INT(made->kind, BATTEN_OBJECT_SURFACE);
    batten_notes_free(notes);
    batten_design_free(design);
}

TEST(wrong_points_are_named_by_their_row_and_sections_are_counted)
{
    check_notes("{fair-net: net, within: 0.05}",
                (const char *const[]){"point 6 of row 3, (5, 2, 3.19)", "would fit"});
    check_notes("{fair-net: net, within: 0.05, method: least-change, blunders: mend}",
                (const char *const[]){"point 6 of row 3, (5, 2, 3.19)", "stands for it"});
    check_notes("{fair-net: net, within: 0.05}",
                (const char *const[]){"least energy does not count them, 'method: "
                                      "least-change' may remove them",
                                      "had inflections in excess"});
    check_notes("{fair-net: net, within: 0.05, method: least-change, hold: edges}",
                (const char *const[]){
                    "in excess: no surface with fewer was found within the bound and with "
                    "the points that are held",
                    "had inflections in excess"});
}
