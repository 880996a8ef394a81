#include "design/outputs/made_check.h"

#include <batten/design.h>
#include <stdlib.h>

static const char features[] =
    "batten: 1\nunits: mm\ntitle: A sheer\nfeatures:\n"
    "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 32 cm], [3 m, 29 cm], [4 m, 28 cm], [5 m, "
    "10 cm]]}\n"
    "  sheer: {interpolate: ducks, ends: natural}\n  faired: {fair: sheer, within: 2 cm}\n";

static batten_status report(const char *output, char **out)
{
    char text[900];
    snprintf(text, sizeof text, "%soutputs:\n  %s\n", features, output);
    batten_design *design = NULL;
    size_t size;
    batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, NULL, out, &size);
    batten_design_free(design);
    return status;
}

TEST(a_text_says_what_was_done_in_design_units)
{
    char *text = NULL;
    CHECK_OK(report("r.txt: {check: faired}", &text));
    CHECK(strncmp(text, "A sheer\n", 8) == 0);
    CHECK_CONTAINS(text, "  ducks (points)\n  sheer (interpolate)\n  faired (fair)\n");
    CHECK_CONTAINS(text, " mm (curve 1, point ");
    CHECK_CONTAINS(text, "in excess: ");
    CHECK_CONTAINS(text, "Verdict: ");
    CHECK(strstr(text, "nan") == NULL && strstr(text, "inf ") == NULL);
    batten_release(text);
}

TEST(no_point_moves_farther_than_allowed_says_the_JSON)
{
    char *json = NULL;
    CHECK_OK(report("r.json: faired", &json));
    const char *moved = strstr(json, "\"moved\": {\"max\": ");
    CHECK(moved != NULL);
    const double max = atof(moved + 17);
    CHECK(max > 0 && max <= 20 * (1 + 1e-12));
    CHECK_CONTAINS(json, "\"unit\": \"mm\", \"within\": null");
    CHECK_CONTAINS(json, "\"operation\": \"fair\"");
    CHECK_CONTAINS(json, "\"fairness\": {\"fair\": ");
    batten_release(json);
}

TEST(braces_and_brackets_of_the_JSON_match)
{
    char *json = NULL;
    CHECK_OK(report("r.json: [faired, ducks]", &json));
    int depth = 0;
    bool quoted = false;
    for (const char *c = json; *c; c++) {
        quoted ^= *c == '"' && c[-1] != '\\';
        depth += !quoted && (*c == '{' || *c == '[');
        depth -= !quoted && (*c == '}' || *c == ']');
        CHECK(depth > 0 || c[1] == 0 || c[1] == '\n');
    }
    CHECK_INT(depth, 0);
    batten_release(json);
}

/* ---- of a check that is made by hand: each figure in its place ---- */

static const char done[] =
    "A hull\n\nWhat was done\n"
    "  ducks (points)\n"
    "  faired (fair)\n"
    "    3 points moved, at most 0.01235 in (curve 2, point 5)\n"
    "    inflections in excess: 7 before, 2 after; energy 12350 before, 0.5 after\n"
    "    1 point may be a blunder; see the messages\n"
    "  net (fair)\n"
    "    1 control point moved, the curve by at most 2 in (curve 1, control point 1)\n"
    "    inflections in excess: 0 before, 0 after; energy 3 before, 0 after\n"
    "  skin (skin)\n"
    "    sections moved by at most 0.25 in; 1 inner knot along them, the exact union has 12\n"
    "  near (arcs)\n"
    "    error at most 0.75 in\n"
    "  hull (loft)\n"
    "    6 points moved, at most 0.5 in, in the mean 0.1 in\n"
    "      station 1 (x = 1), point 1, y 2 -> 2.5: 0.5 in off, noise\n"
    "      station 1 (x = 1), point 2, z 6 -> 5.6: 0.4 in off, bound\n"
    "      station 'stem' (x = 9), point 1, x 9 -> 8.7: 0.3 in off, suspect\n"
    "      station 'stem' (x = 9), point 2, y 4 -> 4.2: 0.2 in off, noise\n"
    "      station 'stem' (x = 9), sheer, y 5 -> 5.1: 0.1 in off, noise\n"
    "    2 of 30 sections with inflections in excess, of bulges above 0.001 in\n";

static const char objects_and_joins[] =
    "\nThe result\n"
    "  sheer (curve)\n"
    "    1 inflection, 0 in excess; curvature extrema 2, largest curvature 0.01235, energy 1.235\n"
    "    joins at 1 knot, all at least C2 and G3\n"
    "    distance from the 1 point given, 'ducks': at most 0.001235 in (rms 0.001235), at 1, "
    "0.1235, 0\n"
    "  ch\"ine (curve)\n"
    "    3 inflections, 2 in excess; curvature extrema 5, largest curvature without bound, energy "
    "infinite: 1 corner, 2 jumps of curvature\n"
    "  bottom (surface)\n"
    "    distance from the 9 points given, 'ducks': at most 0.5 in (rms 0.25), at 4, 5, 6; 3 "
    "beyond the shape left out\n"
    "    distance from the 9 points after fairing, 'faired': at most 123500 in (rms 0), at 7, 8, "
    "9\n"
    "    it folds over near 1, 2, 3.142\n"
    "    the edge 'v low' is at the centre plane within 0.0001235 in\n"
    "    stations: 1 of 2 without visible inflections in excess; 1 could not be judged\n"
    "      S\"2 at 2.5: 3 visible inflections, 2 in excess; largest curvature 4\n"
    "    waterlines: 0 of 1 without visible inflections in excess\n"
    "      W1 at 0.5: 1 visible inflection, 1 in excess; largest curvature 0.25\n"
    "    buttocks: 0 of 0 without visible inflections in excess; 1 could not be judged\n"
    "  side (surface)\n"
    "\nWhat meets\n"
    "  sheer, end and ch\"ine, start: gap 0.5 in: C0, G1\n"
    "  sheer, start and ch\"ine, end: gap 0 in, turning by 0.5 rad, curvatures not known at a "
    "cusp: C2, G3\n"
    "  bottom, v high and side, v low: gap 0 in, turning by 0.25 rad, curvatures differ by 0.125 "
    "of the larger: G0, turning most at (1, 0, 0): a declared knuckle\n"
    "  bottom, u low and a part of side, u high: gap 0 in, turning by 0.25 rad, curvatures not "
    "known at a pole: G1\n"
    "  a part of bottom, u high and side, u low: gap 0.0625 in, turning by 0.75 rad, curvatures "
    "differ by 0.5 of the larger: G2, rates differing most at (9, 1, 2)\n"
    "  3 common edges: 1 G0, 1 G1, 1 G2\n"
    "    widest gap 0.0625 in at (4, 0, 0): a part of bottom, u high and side, u low\n"
    "    largest turn 0.75 rad at (5, 0, 0): a part of bottom, u high and side, u low\n"
    "    where they turn less than the bound, curvatures differ by up to 0.5 of the larger at (6, "
    "7, 8): a part of bottom, u high and side, u low\n"
    "    where curvatures agree, too, their rates differ by up to 0.875 of the larger at (9, 1, "
    "2): a part of bottom, u high and side, u low\n"
    "\nVerdict: fair as a hull.\n";

TEST(a_text_has_each_figure_of_features_objects_and_joins_in_its_place)
{
    made_check made;
    make_check(&made);
    char *text = write_check(&made.check, bat_report_text);
    CHECK(strncmp(text, done, strlen(done)) == 0);
    CHECK_TEXT(strstr(text, "\nThe result\n"), objects_and_joins);
    batten_release(text);
    batten_offset_table_unref(made.table);
}

/* An energy is stated when four digits of it are known. */
static const struct {
    batten_fairness fairness;
    const char *words;
} energies[] = {
    {{.energy = 2, .energy_error = 0.00009}, ", energy 2\n"},
    {{.energy = 2, .energy_error = 0.00011}, ", energy not known (infinite, or nearly so)\n"},
    {{.energy = HUGE_VAL, .energy_error = HUGE_VAL}, ", energy infinite\n"},
    {{.energy = 2, .corners = 3}, ", energy infinite: 3 corners\n"},
    {{.energy = 0, .curvature_jumps = 1}, ", energy 0, 1 jump of curvature\n"},
    {{.inflections = 2, .curvature_extrema = 3, .max_curvature = 99.996},
     "\n    2 inflections, 0 in excess; curvature extrema 3, largest curvature 100, energy 0\n"},
};

TEST(an_energy_is_stated_or_why_it_is_not)
{
    made_check made;
    make_check(&made);
    for (int i = 0; i < COUNT(energies); i++) {
        made.objects[0].fairness = energies[i].fairness;
        char *text = write_check(&made.check, bat_report_text);
        CHECK_CONTAINS(text, energies[i].words);
        batten_release(text);
    }
    batten_offset_table_unref(made.table);
}

/* ---- verdicts ---- */

static const struct {
    bat_unfairness unfairness;
    const char *verdict;
} verdicts[] = {
    {{.corners = 1, .largest_turn = BAT_PI / 4},
     "not fair as a hull: 1 corner of 45 degrees.\n"},
    {{.corners = 2, .largest_turn = BAT_PI / 2},
     "not fair as a hull: 2 corners, the sharpest of 90 degrees.\n"},
    {{.joint_corners = 1, .largest_joint = BAT_PI / 4},
     "not fair as a hull: 1 corner where two curves meet of 45 degrees.\n"},
    {{.corners = 1, .largest_turn = BAT_PI / 2, .joint_corners = 2, .largest_joint = BAT_PI / 3},
     "not fair as a hull: 1 corner of 90 degrees, 2 corners where two curves meet, the sharpest of "
     "60 degrees.\n"},
    {{.joint_jumps = 2}, "not fair as a hull: 2 jumps of curvature where two curves meet.\n"},
    {{.creases = 1, .largest_crease = BAT_PI / 6},
     "not fair as a hull: 1 edge with a crease of 30 degrees.\n"},
    {{.creases = 3, .largest_crease = BAT_PI / 18},
     "not fair as a hull: 3 edges with a crease, the sharpest of 10 degrees.\n"},
    {{.folds = 1}, "not fair as a hull: 1 surface that folds over.\n"},
    {{.folds = 2}, "not fair as a hull: 2 surfaces that fold over.\n"},
    {{.curvature_jumps = 1}, "not fair as a hull: 1 jump of curvature.\n"},
    {{.unbounded = 2}, "not fair as a hull: 2 places of unbounded curvature.\n"},
    {{.edge_jumps = 1}, "not fair as a hull: 1 edge with a jump of curvature.\n"},
    {{.inflections = 4}, "not fair as a hull: 4 inflections in excess.\n"},
    {{.corners = 1, .largest_turn = BAT_PI / 2, .curvature_jumps = 2, .inflections = 1},
     "not fair as a hull: 1 corner of 90 degrees, 2 jumps of curvature, 1 inflection in excess.\n"},
};

TEST(a_verdict_names_each_reason_with_its_count_and_the_sharpest_angle)
{
    made_check made;
    make_check(&made);
    for (int i = 0; i < COUNT(verdicts); i++) {
        made.check.unfairness = verdicts[i].unfairness;
        char *text = write_check(&made.check, bat_report_text);
        CHECK_TEXT(strstr(text, "Verdict: ") + strlen("Verdict: "), verdicts[i].verdict);
        batten_release(text);
    }
    batten_offset_table_unref(made.table);
}

/* Of the objects of the check that is made by hand `count` from `first`, and their kind. */
typedef struct {
    int first, count;
    batten_object_kind kind;
    int judged, distances, bounded;
    bool ok;
    const char *end;
} case_of_bound;

#define NO_POINTS "there are no points to measure against 2 in.\n"

static const case_of_bound cases_of_bound[] = {
    {0, 1, BATTEN_OBJECT_CURVE, 1, 1, 1, true,
     "Verdict: fair as a curve; the points given lie within 2 in of the shape.\n"},
    {0, 2, BATTEN_OBJECT_CURVE, 1, 1, 1, false,
     "Verdict: fair as a family of curves; the points given lie farther than 2 in from the "
     "shape.\n"},
    {3, 1, BATTEN_OBJECT_SURFACE, 1, 0, 0, true, "Verdict: fair as a free surface; " NO_POINTS},
    {2, 2, BATTEN_OBJECT_SURFACE, 1, 0, 0, true, "Verdict: fair as a hull; " NO_POINTS},
    {0, 1, BATTEN_OBJECT_POINTS, 1, 0, 0, true, "Verdict: fair as a curve; " NO_POINTS},
    {0, 1, BATTEN_OBJECT_BODY, 1, 0, 1, true, "; bodies hold together within 2 in.\n"},
    {0, 1, BATTEN_OBJECT_BODY, 1, 0, 1, false, "; bodies do not hold together within 2 in.\n"},
    {0, 1, BATTEN_OBJECT_MESH, 1, 0, 1, true, "; the mesh is closed.\n"},
    {0, 1, BATTEN_OBJECT_MESH, 1, 0, 1, false, "; the mesh is not closed.\n"},
    {0, 2, BATTEN_OBJECT_MESH, 1, 0, 2, true, "; the meshes are closed.\n"},
    {0, 2, BATTEN_OBJECT_MESH, 1, 0, 2, false, "; not all meshes are closed.\n"},
};

/* Meshes and bodies of this test have no faces, and nothing is said of them. */
static void check_bound(const case_of_bound *c)
{
    made_check made;
    batten_object objects[2];
    bat_data_distance distances[] = {{"a", false, 1, 0, 0, {0, 0, 0}, 0},
                                     {"b", false, 1, 0, 0, {0, 0, 0}, 0}};
    make_check(&made);
    made.check.join_count = 0;
    made.check.within = 2;
    made.check.objects = made.objects + c->first;
    made.check.object_count = c->count;
    for (int i = 0; i < c->count; i++) {
        objects[i] = *made.check.objects[i].object;
        objects[i].kind = c->kind;
        made.check.objects[i].object = &objects[i];
        made.check.objects[i].distance_count = c->distances;
        made.check.objects[i].distances = distances;
    }
    made.check.judged_count = c->judged;
    made.check.bounded_count = c->bounded;
    made.check.ok = c->ok;
    char *text = write_check(&made.check, bat_report_text);
    CHECK_CONTAINS(text, c->end);
    batten_release(text);
    batten_offset_table_unref(made.table);
}

TEST(a_text_ends_with_what_is_judged_and_whether_the_bound_holds)
{
    for (int i = 0; i < COUNT(cases_of_bound); i++)
        check_bound(&cases_of_bound[i]);
}
