#include "design/expect.h"
#include "design/outputs/made_check.h"
#include "support/json.h"

#include <batten/design.h>
#include <batten/text.h>

/* Reports as JSON: every figure that a feature reports, under its name; what is found of the objects. */

static const char shapes[] =
    "  ducks: {points: [[0, 0], [1, 0.1], [2, 0.4], [3, 0.8], [4, 1.7], [5, 2.4]]}\n"
    "  lifted: {move: ducks, by: [0, 0, 1]}\n"
    "  higher: {move: ducks, by: [0, 1, 3]}\n"
    "  c1: {interpolate: ducks}\n"
    "  c2: {interpolate: lifted}\n"
    "  c3: {reverse: up}\n"
    "  up: {interpolate: higher}\n"
    "  f1: {fair: c1, within: 0.02}\n"
    "  near: {least-squares: ducks, points: 2, degree: 1}\n"
    "  skin: {skin: [c1, c2]}\n"
    "  three: {skin: [c1, c2, c3], within: 0.01}\n"
    "  away: {move: skin, by: [0, 0, 0.5]}\n"
    "  corner: {polyline: [[0, 0], [4, 0], [4, 3]]}\n"
    "  \"odd\\\"name\": {line: [[4, 3], [4, 5]]}\n"
    "  parts: {split: bow, parameter: 0.5}\n"
    "  vee: {points: [[-1, 1], [0, -1], [1, 1]]}\n"
    "  bow: {bezier: vee}\n"
    "  flat: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}\n"
    "  wall: {bilinear: [[1, 0, 0], [1, 0, 1], [1, 1, 1], [1, 1, 0]]}\n"
    "  net: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}\n"
    "  sail: {bezier-triangle: net}\n"
    "  ball: {sphere: 1}\n"
    "  crowd: {mesh: flat}\n";

static const expect_row of_objects[] = {
    /* Of y = x^2 from -1 to 1 all is known: see compare.c. */
    {"k.json: {check: bow}", BATTEN_OK,
     "{\n  \"ok\": true, \"fair\": true, \"unit\": \"m\", \"within\": null,\n  \"features\": "
     "[\n    {\"name\": \"vee\", \"operation\": \"points\"},\n    {\"name\": \"bow\", "
     "\"operation\": \"bezier\"}\n  ],\n  \"objects\": [\n    {\"name\": \"bow\", \"type\": "
     "\"curve\", \"fairness\": {\"fair\": true, \"inflections\": 0, \"excess_inflections\": 0, "
     "\"curvature_extrema\": 1, \"jumps\": 0, \"energy\": 2.6236530|, \"variation\": "
     "7.2878949|, \"max_curvature\": 2, \"corners\": 0, \"curvature_jumps\": 0, \"halts\": 0, "
     "\"cusps\": 0, \"unbounded\": 0, \"energy_error\": |, \"variation_error\": |, "
     "\"largest_turn\": 0, \"largest_jump\": 0}|\n  ],\n  \"corners_where_curves_meet\": 0, \"jumps_where_curves_meet\": 0, \"creases\": 0, \"edge_jumps\": 0, "
     "\"folds\": 0,\n  \"joins\": [],\n  \"worst_joins\": [],\n  \"messages\": []\n}\n"},
    {"k.json: {check: [corner, 'odd\"name']}", BATTEN_OK,
     "\"fair\": false, |\"name\": \"corner\", \"type\": \"curve\", \"fairness\": {\"fair\": "
     "false, |\"energy\": null, \"variation\": null, \"max_curvature\": 0, \"corners\": 1, "
     "|\"largest_turn\": 1.5707963|\"continuity\": {\"knots\": 1, \"c\": 0, \"g\": "
     "0}|},\n    {\"name\": \"odd\\\"name\", |\"joins\": [\n    {\"a\": \"corner\", \"side_a\": "
     "\"end\", \"b\": \"odd\\\"name\", \"side_b\": \"start\", \"g0\": 0, \"g1\": 0, \"g2\": "
     "0, \"g3\": 0, \"c\": |, \"g\": 3, \"at\": |]}]"},
    /* Two halves of one parabola join in all derivatives. */
    {"k.json: {check: parts}", BATTEN_OK,
     "\"side_a\": \"end\", |\"side_b\": \"start\", |\"g\": 3, \"at\": |]}]"},
    /* An edge of a unit square under a right angle, all along both. */
    {"k.json: {check: [flat, wall]}", BATTEN_OK,
     "\"fair\": false, |\"distances\": [],\n     \"edges\": [],\n     \"sections\": "
     "[]}|\"creases\": 1, \"edge_jumps\": 0, \"folds\": 0,\n  \"joins\": [\n    {\"a\": "
     "\"flat\", \"side_a\": \"u high\", \"b\": \"wall\", \"side_b\": \"u low\", \"g0\": 0, \"g1\": "
     "1.5707963|!\"part\"|!\"knuckle\"|!\"c\":"},
    {"k.json: {check: sail}", BATTEN_OK,
     "\"type\": \"triangles\", \"count\": 1, \"degree\": 1, \"inner_edges\": 0, \"gap\": 0, "
     "\"angle\": 0}|\"fair\": null"},
    {"k.json: {check: crowd}", BATTEN_OK, "\"type\": \"mesh\""},
};

TEST(figures_of_objects_and_joins_stand_under_their_names)
{
    EXPECT_OUTPUTS(shapes, of_objects);
}

static const expect_row of_distances[] = {
    {"k.json: {check: c1, within: 0.5}", BATTEN_OK,
     "\"within\": 0.5,|\"distances\": [{\"from\": \"c1\", \"faired\": false, \"points\": 6, "
     "\"max\": |, \"rms\": |, \"at\": ["},
    {"k.json: {check: away}", BATTEN_OK, "\"distances\": []|\"fair\": null"},
    {"k.json: {check: skin}", BATTEN_OK,
     "\"distances\": [{\"from\": \"ducks\", \"faired\": false, \"points\": 6, \"max\": |\"rms\": |"
     "\"from\": \"lifted\", \"faired\": false, \"points\": "},
    {"k.json: {check: f1}", BATTEN_OK,
     "\"distances\": [{\"from\": \"f1\", \"faired\": true, \"points\": 6, "},
};

TEST(distances_from_the_points_stand_under_their_names)
{
    EXPECT_OUTPUTS(shapes, of_distances);
}

/* ---- figures of features, from their results ---- */

static char *check_as_json(const char *feature, batten_design **out)
{
    char text[3000], *data = NULL;
    size_t size;
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nfeatures:\n%soutputs:\n  k.json: {check: %s}\n", shapes,
             feature);
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, out));
    CHECK_OK(batten_design_output(*out, 0, NULL, NULL, &data, &size));
    return data;
}

/* "name": value, as it stands in the report of this feature. */
static void check_figure(const char *json, const char *name, double value)
{
    char number[BATTEN_NUMBER_SIZE], wanted[100];
    batten_number_write(value, number);
    snprintf(wanted, sizeof wanted, "\"%s\": %s", name, number);
    CHECK_CONTAINS(json, wanted);
}

TEST(all_figures_of_a_faired_curve_are_in_its_report)
{
    batten_design *design = NULL;
    char *json = check_as_json("f1", &design);
    const batten_feature_result *r = batten_design_result(design, "f1");
    const char *at = strstr(json, "\"operation\": \"fair\"");
    CHECK(at && r->fairing);
    check_figure(at, "moved\": {\"max", r->move_max);
    check_figure(at, "count", r->moved_count);
    CHECK_CONTAINS(at, "\"set\": 1, \"index\": ");
    check_figure(at, "excess_inflections\": {\"before", r->fairing->before.excess_inflections);
    check_figure(at, "energy\": {\"before", r->fairing->before.energy);
    check_figure(at, "after", r->fairing->after.excess_inflections);
    check_figure(at, "after", r->fairing->after.energy);
    check_figure(at, "suspects", r->fairing->suspect_count);
    batten_release(json);
    batten_design_free(design);
}

TEST(all_figures_of_a_skin_are_in_its_report)
{
    batten_design *design = NULL;
    char *json = check_as_json("three", &design);
    const batten_feature_result *r = batten_design_result(design, "three");
    const char *at = strstr(json, "\"operation\": \"skin\"");
    CHECK(at && r->skin);
    const batten_surface_skin_report *s = r->skin;
    CHECK(s->reversed_count == 1);
    check_figure(at, "skin\": {\"deviation", s->error);
    check_figure(at, "worst_section", s->worst_section + 1);
    check_figure(at, "exact_knots", s->exact_knot_count);
    check_figure(at, "knots", s->knot_count);
    check_figure(at, "span_ratio", s->span_ratio);
    check_figure(at, "normal_jump", s->normal_jump);
    check_figure(at, "speed_jump", s->speed_jump);
    check_figure(at, "crease", s->crease);
    CHECK_CONTAINS(at, "\"cure\": \"none\"");
    check_figure(at, "reversed", s->reversed_count);
    check_figure(at, "turned", s->turned_count);
    check_figure(at, "crossings", s->crossing_count);
    check_figure(at, "disorders", s->disorder_count);
    batten_release(json);
    batten_design_free(design);
}

TEST(the_error_of_a_feature_is_in_its_report)
{
    batten_design *design = NULL;
    char *json = check_as_json("near", &design);
    const batten_feature_result *r = batten_design_result(design, "near");
    const char *at = strstr(json, "\"operation\": \"least-squares\"");
    CHECK(at && r->has_error && r->error_rms < r->error_max);
    check_figure(at, "error\": {\"max", r->error_max);
    check_figure(at, "rms", r->error_rms);
    batten_release(json);
    batten_design_free(design);
}

/* The example's boat has a chine: panels of one lofting that meet in a declared knuckle. */
static char *check_sharpie(batten_design **out)
{
    char text[500], *json = NULL;
    size_t size;
    snprintf(text, sizeof text,
             "batten: 1\nunits: in\ntolerance: 0.005 in\nfeatures:\n  table: {read: '%s'}\n"
             "  hull: {loft: table, within: 0.125 in, knuckles: chine}\n"
             "outputs:\n  k.json: {check: hull}\n",
             test_source("examples/sharpie/offsets.csv"));
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, out));
    CHECK_OK(batten_design_output(*out, 0, NULL, NULL, &json, &size));
    return json;
}

static int count_words(const char *text, const char *words)
{
    int count = 0;
    for (const char *at = text; (at = strstr(at, words)); at++)
        count++;
    return count;
}

TEST(all_figures_of_a_lofting_and_its_knuckles_are_in_its_report)
{
    batten_design *design = NULL;
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    char *json = check_sharpie(&design);
    const batten_loft_report *l = batten_design_result(design, "hull")->loft;
    const char *at = strstr(json, "\"operation\": \"loft\"");
    CHECK(at && l && l->correction_count > 1);
    CHECK_TEXT(json_blank(json_behind(json)), "");
    check_figure(at, "loft\": {\"max", l->max_move);
    check_figure(at, "rms", l->rms_move);
    check_figure(at, "station", l->worst_station + 1);
    check_figure(at, "point", l->worst_index + 1);
    check_figure(at, "height", l->height);
    check_figure(at, "sections", l->cut_count);
    check_figure(at, "in_excess", l->cuts_in_excess);
    check_figure(at, "excess_inflections", l->excess_inflections);
    check_figure(at, "rounds", l->rounds);
    check_figure(at, "faired_error", l->faired_error);
    CHECK_INT(count_words(json, "\"from\": ["), l->correction_count);
    /* The chine is an edge of two panels on each side; surfaces have no C nor G. */
    CHECK_INT(count_words(json, ", \"knuckle\": true, "), 1);
    CHECK_INT(count_words(json, "\"c\": "), 0);
    batten_release(json);
    batten_design_free(design);
}

/* ---- of a check that is made by hand: each figure under its name ---- */

static const char made_features[] =
    "{\n  \"ok\": true, \"fair\": null, \"unit\": \"in\", \"within\": null,\n  \"features\": [\n"
    "    {\"name\": \"ducks\", \"operation\": \"points\"},\n"
    "    {\"name\": \"faired\", \"operation\": \"fair\", \"moved\": {\"max\": 0.0123456, \"rms\": "
    "0.004, \"count\": 3, \"set\": 2, \"index\": 5, \"control_points\": false}, "
    "\"excess_inflections\": {\"before\": 7, \"after\": 2}, \"energy\": {\"before\": 12345.678, "
    "\"after\": 0.5}, \"suspects\": 1},\n"
    "    {\"name\": \"net\", \"operation\": \"fair\", \"moved\": {\"max\": 2, \"rms\": 0, "
    "\"count\": 1, \"set\": 1, \"index\": 1, \"control_points\": true}, \"excess_inflections\": "
    "{\"before\": 0, \"after\": 0}, \"energy\": {\"before\": 3, \"after\": 0}, \"suspects\": 0},\n"
    "    {\"name\": \"skin\", \"operation\": \"skin\", \"skin\": {\"deviation\": 0.25, "
    "\"worst_section\": 4, \"exact_knots\": 12, \"knots\": 1, \"span_ratio\": 0.125, "
    "\"normal_jump\": 0.375, \"speed_jump\": 0.0625, \"crease\": 0.75, \"cure\": \"rescaled\", "
    "\"reversed\": 2, \"turned\": 4, \"crossings\": 5, \"disorders\": 6}},\n"
    "    {\"name\": \"near\", \"operation\": \"arcs\", \"error\": {\"max\": 0.75, \"rms\": "
    "0.5}},\n"
    "    {\"name\": \"hull\", \"operation\": \"loft\", \"error\": {\"max\": 0.75, \"rms\": 0.5}, "
    "\"loft\": {\"max\": 0.5, \"rms\": 0.1, \"station\": 2, \"point\": 3, \"height\": 0.001, "
    "\"sections\": 30, \"in_excess\": 2, \"excess_inflections\": 4, \"rounds\": 8, "
    "\"faired_error\": 0.03125, \"corrections\": [{\"place\": \"station 1 (x = 1)\", \"point\": "
    "1, \"line\": \"\", \"from\": [1, 2, 3], \"to\": [1, 2.5, 3], \"distance\": 0.5, \"reason\": "
    "\"noise\"}, {\"place\": ";

static const char made_planks[] =
    "\"distance\": 0.05, \"reason\": \"noise\"}], \"planks\": [{\"panel\": 1, \"median\": 0.125, "
    "\"of_90\": 0.25, \"largest\": 0.5, \"x_below\": 1, \"x_above\": 2}, {\"panel\": 3, \"median\": "
    "0.0625, \"of_90\": 0.375, \"largest\": 0.75, \"x_below\": 3, \"x_above\": 4}]}}\n";

static const char made_figures[] =
    "\n  ],\n  \"objects\": [\n"
    "    {\"name\": \"sheer\", \"type\": \"curve\", \"fairness\": {\"fair\": true, "
    "\"inflections\": 1, \"excess_inflections\": 0, \"curvature_extrema\": 2, \"jumps\": 0.5, "
    "\"energy\": 1.2345678, \"variation\": 7.5, \"max_curvature\": 0.0123456, \"corners\": 0, "
    "\"curvature_jumps\": 0, \"halts\": 0, \"cusps\": 0, \"unbounded\": 0, \"energy_error\": "
    "1e-9, \"variation_error\": 2e-9, \"largest_turn\": 0, \"largest_jump\": 0}, "
    "\"continuity\": {\"knots\": 1, \"c\": 2, \"g\": 3},\n     \"distances\": [{\"from\": "
    "\"ducks\", \"faired\": false, \"points\": 1, \"max\": 0.00123456, \"rms\": 0.00123456, "
    "\"at\": [1, 0.123456, 0], \"left_out\": 0}]},\n"
    "    {\"name\": \"ch\\\"ine\", \"type\": \"curve\", \"fairness\": {\"fair\": false, "
    "\"inflections\": 3, \"excess_inflections\": 2, \"curvature_extrema\": 5, \"jumps\": 0, "
    "\"energy\": null, \"variation\": null, \"max_curvature\": null, \"corners\": 1, "
    "\"curvature_jumps\": 2, \"halts\": 3, \"cusps\": 4, \"unbounded\": 6, \"energy_error\": 0, "
    "\"variation_error\": 0, \"largest_turn\": 1.5, \"largest_jump\": 0.25}},\n"
    "    {\"name\": \"bottom\", \"type\": \"surface\",\n     \"distances\": [{\"from\": "
    "\"ducks\", \"faired\": false, \"points\": 9, \"max\": 0.5, \"rms\": 0.25, \"at\": [4, 5, "
    "6], \"left_out\": 3}, {\"from\": \"faired\", \"faired\": true, \"points\": 9, \"max\": 123456, \"rms\": 0, "
    "\"at\": [7, 8, 9], \"left_out\": 0}],\n     \"edges\": [{\"name\": \"v low\", \"gap\": 0.000123456, "
    "\"at_centre\": true}, {\"name\": \"v high\", \"gap\": 7, \"at_centre\": false}],\n     "
    "\"sections\": [\n      {\"family\": \"station\", \"name\": \"S1\", \"at\": 1, "
    "\"visible_inflections\": 0, \"visible_excess\": 0, \"fairness\": {\"fair\": false, ";

static const char made_ends[] =
    "      {\"family\": \"station\", \"name\": \"S3\", \"at\": 3},\n"
    "      {\"family\": \"waterline\", \"name\": \"W1\", \"at\": 0.5, \"visible_inflections\": 1, "
    "\"visible_excess\": 1, ";

static const char made_meetings[] =
    "      {\"family\": \"buttock\", \"name\": \"B1\", \"at\": 4}]},\n"
    "    {\"name\": \"side\", \"type\": \"surface\",\n     \"distances\": [],\n     \"edges\": "
    "[],\n     \"sections\": []}\n  ],\n  \"corners_where_curves_meet\": 5, "
    "\"jumps_where_curves_meet\": 6, \"creases\": 2, \"edge_jumps\": 3, \"folds\": 4,\n  "
    "\"joins\": [\n"
    "    {\"a\": \"sheer\", \"side_a\": \"end\", \"b\": \"ch\\\"ine\", \"side_b\": \"start\", "
    "\"g0\": 0.5, \"g1\": null, \"g2\": null, \"g3\": null, \"c\": 0, \"g\": 1, \"at\": [1, 2, "
    "3]},\n"
    "    {\"a\": \"sheer\", \"side_a\": \"start\", \"b\": \"ch\\\"ine\", \"side_b\": \"end\", "
    "\"g0\": 0, \"g1\": 0.5, \"g2\": null, \"g3\": 8, \"c\": 2, \"g\": 3, \"at\": [4, 5, 6]},\n"
    "    {\"a\": \"bottom\", \"side_a\": \"v high\", \"b\": \"side\", \"side_b\": \"v low\", "
    "\"g0\": 0, \"g1\": 0.25, \"g2\": 0.125, \"g3\": 32, \"g\": 0, \"knuckle\": true, "
    "\"curvature_jump\": 16, \"rate_part\": 0.75, \"g0_at\": [0, 0, 0], \"g1_at\": [1, 0, 0], "
    "\"g2_at\": [2, 0, 0], \"g3_at\": [3, 0, 0]},\n"
    "    {\"a\": \"bottom\", \"side_a\": \"u low\", \"b\": \"side\", \"side_b\": \"u high\", "
    "\"g0\": 0, \"g1\": 0.25, \"g2\": null, \"g3\": null, \"part\": \"a\", \"g\": 1, "
    "\"curvature_jump\": null, \"rate_part\": null, \"g0_at\": [7, 0, 0], \"g1_at\": [8, 0, "
    "0]},\n"
    "    {\"a\": \"bottom\", \"side_a\": \"u high\", \"b\": \"side\", \"side_b\": \"u low\", "
    "\"g0\": 0.0625, \"g1\": 0.75, \"g2\": 0.5, \"g3\": 128, \"part\": \"b\", \"g\": 2, "
    "\"curvature_jump\": 64, \"rate_part\": 0.875, \"g0_at\": [4, 0, 0], \"g1_at\": [5, 0, 0], "
    "\"g2_at\": [6, 7, 8], \"g3_at\": [9, 1, 2]}],\n  \"worst_joins\": [\n"
    "    {\"worst\": \"gap\", \"join\": 5, \"value\": 0.0625, \"at\": [4, 0, 0]},\n"
    "    {\"worst\": \"angle\", \"join\": 5, \"value\": 0.75, \"at\": [5, 0, 0]},\n"
    "    {\"worst\": \"curvature\", \"join\": 5, \"value\": 0.5, \"at\": [6, 7, 8]},\n"
    "    {\"worst\": \"rate\", \"join\": 5, \"value\": 0.875, \"at\": [9, 1, 2]}],\n  \"messages\": []\n}\n";

TEST(each_figure_of_features_objects_and_joins_stands_under_its_name)
{
    made_check made;
    make_check(&made);
    made.check.judged_count = 0;
    made.check.unfairness = (bat_unfairness){
        .joint_corners = 5, .joint_jumps = 6, .creases = 2, .edge_jumps = 3, .folds = 4};
    char *json = write_check(&made.check, bat_report_json);
    CHECK(strncmp(json, made_features, strlen(made_features)) == 0);
    CHECK_CONTAINS(json, made_planks);
    CHECK_CONTAINS(json, made_figures);
    CHECK_CONTAINS(json, made_ends);
    CHECK_TEXT(strstr(json, "      {\"family\": \"buttock\""), made_meetings);
    CHECK_TEXT(json_blank(json_behind(json)), "");
    batten_release(json);
    batten_offset_table_unref(made.table);
}

TEST(what_was_judged_is_fair_or_not_and_messages_stand_at_the_end)
{
    made_check made;
    batten_notes *notes = NULL;
    make_check(&made);
    CHECK_OK(batten_notes_create(5, &notes));
    batten_notes_add(notes, "a\"b.yaml", 7, "hull", "%d places", 2);
    batten_notes_remark(notes, "", 0, "", "found");
    made.run.notes = notes;
    made.check.ok = false;
    made.check.within = 0.5;
    char *json = write_check(&made.check, bat_report_json);
    CHECK_CONTAINS(json, "\"ok\": false, \"fair\": true, \"unit\": \"in\", \"within\": 0.5,\n");
    if (batten_notes_dropped(notes) == 0)
        CHECK_TEXT(strstr(json, "],\n  \"messages\""),
                   "],\n  \"messages\": [\n    {\"file\": \"a\\\"b.yaml\", \"line\": 7, "
                   "\"entity\": \"hull\", \"text\": \"2 places\", \"remark\": false},\n    "
                   "{\"file\": \"\", \"line\": 0, \"entity\": \"\", \"text\": \"found\", "
                   "\"remark\": true}]\n}\n");
    batten_release(json);
    made.check.unfairness.folds = 1;
    json = write_check(&made.check, bat_report_json);
    CHECK_CONTAINS(json, "\"ok\": false, \"fair\": false, ");
    batten_release(json);
    batten_notes_free(notes);
    batten_offset_table_unref(made.table);
}
