#include "design/outputs/fairness.h"

#include "design/outputs/checked.h"

#include <stdlib.h>

/* A design with one output; its bytes, and what its JSON or text says. */
static batten_status report(const char *design_text, char **out)
{
    batten_design *design = NULL;
    size_t size;
    batten_status status =
        batten_design_parse(design_text, strlen(design_text), NULL, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, NULL, out, &size);
    batten_design_free(design);
    return status;
}

/* The first number after a key. */
static double value_of(const char *json, const char *key)
{
    const char *at = strstr(json, key);
    CHECK(at != NULL);
    return atof(at + strlen(key));
}

/* The curve of a chain winds around it where that is all but straight. */
TEST(inflections_of_a_curve_in_tension_are_those_of_its_chain)
{
    static const char *const amounts[] = {"3", "40", "400"};
    for (int i = 0; i < COUNT(amounts); i++) {
        char text[300], *json = NULL;
        snprintf(
            text, sizeof text,
            "batten: 1\nfeatures:\n  a: {points: [[0, 0], [1, 1], [2, 0], [3, 2], [4, 0], "
            "[5, 3], [6, 1]]}\n  t: {tension: a, amount: %s}\noutputs:\n  r.json: {check: t}\n",
            amounts[i]);
        const batten_status status = report(text, &json);
        if (test_memory_failed(status, BATTEN_OK))
            continue;
        CHECK_OK(status);
        CHECK(value_of(json, "\"inflections\": ") <= 4);
        batten_release(json);
    }
}

TEST(a_surface_that_folds_over_is_not_fair_and_the_place_is_named)
{
    /* two opposed lines: the ruled surface between them crosses itself in a plane */
    static const char *const names[] = {"r.txt", "r.json"};
    static const char *const said[2][2] = {
        {"it folds over near ", "not fair as a free surface: 1 surface that folds over"},
        {"\"folds\": 1", "\"fair\": false"}};
    for (int i = 0; i < 2; i++) {
        char text[300], *out = NULL;
        snprintf(
            text, sizeof text,
            "batten: 1\nfeatures:\n  s: {bilinear: [[0, 0, 0], [4, 0, 0], [0, 3, 0], [4, 3, "
            "0]]}\noutputs:\n  %s: {check: s}\n",
            names[i]);
        const batten_status status = report(text, &out);
        if (test_memory_failed(status, BATTEN_OK))
            continue;
        CHECK_OK(status);
        CHECK(out && strstr(out, said[i][0]) && strstr(out, said[i][1]));
        batten_release(out);
    }
}

#define CYLINDER                                                           \
    "batten: 1\nfeatures:\n"                                               \
    "  a: {arc: 1 m, angle: 180 deg, axis: x, from: y}\n"                  \
    "  b: {arc: 1 m, angle: 180 deg, axis: x, from: y, at: [3 m, 0, 0]}\n" \
    "  hull: {skin: [a, b]}\n"

TEST(a_surface_that_is_not_made_of_a_table_of_offsets_has_no_centre_plane)
{
    char *json = NULL;
    CHECK_OK(report(CYLINDER "outputs:\n  r.json: {check: hull}\n", &json));
    CHECK_CONTAINS(json, "\"ok\": true");
    CHECK_CONTAINS(json, "\"edges\": []"); /* not a hull: there is no centre plane */
    CHECK_CONTAINS(json, "\"joins\": []");
    batten_release(json);
}

/* A plane through the corners of a grid whose two points between them stand 1 mm above it. */
#define RAISED                                                                        \
    "batten: 1\nfeatures:\n"                                                          \
    "  grid: {points: [[0, 0, 0], [1, 0, 1 mm], [2, 0, 0], [0, 1, 0], [1, 1, 1 mm], " \
    "[2, 1, 0]], columns: 3}\n"                                                       \
    "  flat: {fit-grid: grid, points-u: 2, points-v: 2, degree-u: 1, degree-v: 1}\n"  \
    "outputs:\n"

TEST(distance_from_the_points_given_is_measured)
{
    static const char text[] = RAISED "  r.json: {check: flat, within: 0.5 mm}\n";
    char *json = NULL;
    CHECK_OK(report(text, &json));
    CHECK_CONTAINS(json, "\"ok\": false");
    CHECK_CONTAINS(json, "\"from\": \"grid\", \"faired\": false, \"points\": 6");
    CHECK_NEAR(value_of(strstr(json, "distances"), "\"max\": "), 0.001, 1e-12);
    batten_release(json);
}

TEST(points_are_measured_from_the_nearest_of_the_surfaces_checked_together)
{
    static const char text[] =
        "batten: 1\nfeatures:\n"
        "  grid: {points: [[0, 0, 0], [1, 0, 0], [3, 0, 2 mm], [4, 0, 0], [0, 1, 0], [1, 1, 0], "
        "[3, 1, 2 mm], [4, 1, 0]], columns: 4}\n"
        "  flat: {fit-grid: grid, points-u: 2, points-v: 2, degree-u: 1, degree-v: 1}\n"
        "  left: {part: flat, from: 0, to: 0.5}\n  right: {part: flat, from: 0.5, to: 1}\n"
        "outputs:\n  r.json: {check: [left, right], within: 3 mm}\n";
    char *json = NULL;
    CHECK_OK(report(text, &json));
    CHECK_CONTAINS(json, "\"ok\": true");
    CHECK_NEAR(value_of(strstr(json, "distances"), "\"max\": "), 0.002, 1e-12);
    CHECK_NEAR(value_of(strstr(json, "distances"), "\"rms\": "), 0.001, 1e-12);
    batten_release(json);
}

/* Two planes from two grids of points, one of them off by 0.5 at a point. */
TEST(each_surface_is_measured_from_its_own_points)
{
    char *text = NULL;
    CHECK_OK(
        report("batten: 1\nunits: m\nfeatures:\n"
               "  p: {points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0.5], "
               "[2, 1, 0], [0, 2, 0], [1, 2, 0], [2, 2, 0]], columns: 3}\n"
               "  q: {points: [[9, 0, 0], [10, 0, 0], [11, 0, 1], [9, 1, 0], [10, 1, 0], "
               "[11, 1, 0], [9, 2, 0], [10, 2, 0], [11, 2, 0]], columns: 3}\n"
               "  flat: {fit-grid: p, points-u: 2, points-v: 2, degree-u: 1, degree-v: 1}\n"
               "  exact: {interpolate-grid: q}\n"
               "outputs:\n  r.txt: {check: [flat, exact]}\n",
               &text));
    CHECK_CONTAINS(text, "from the 9 points given, 'p': at most 0.");
    const char *second = strstr(text, "from the 9 points given, 'q'");
    CHECK(second != NULL);
    CHECK(strtod(strstr(second, "at most ") + 8, NULL) < 1e-12);
    batten_release(text);
}

TEST(sections_of_a_fair_surface_are_fair)
{
    static const char text[] =
        "batten: 1\nfeatures:\n"
        "  grid:\n    points: [[0, 0, 0], [0, 1, 0.1], [0, 2, 0.4], [0, 3, 0.9],\n"
        "             [1, 0, 0], [1, 1, 0.1], [1, 2, 0.4], [1, 3, 0.9],\n"
        "             [2, 0, 0], [2, 1, 0.1], [2, 2, 0.4], [2, 3, 0.9]]\n    columns: 4\n"
        "  rows: {interpolate: grid, ends: parabolic}\n  hull: {skin: rows}\n"
        "outputs:\n  r.json: {check: hull}\n";
    char *json = NULL;
    CHECK_OK(report(text, &json));
    CHECK_CONTAINS(json, "\"fair\": true");
    CHECK_CONTAINS(
        json,
        "\"family\": \"x section\", \"name\": \"row 2\", \"at\": 1, \"visible_inflections\": 0");
    batten_release(json);
}

/* A design with one output: does it hold, and what notes are there? */
static bool holds(const char *design_text, batten_notes *notes)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size;
    CHECK_OK(batten_design_parse(design_text, strlen(design_text), NULL, notes, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, notes, &data, &size));
    const bool held = design && batten_design_output_holds(design, 0);
    batten_release(data);
    batten_design_free(design);
    return held;
}

TEST(an_output_whose_bound_is_not_met_says_so)
{
    CHECK(holds(RAISED "  r.json: {check: flat, within: 2 mm}\n", NULL));
    CHECK(!holds(RAISED "  r.json: {check: flat, within: 0.5 mm}\n", NULL));
    CHECK(!holds(RAISED "  r.txt: {check: flat, within: 0.5 mm}\n", NULL));
}

TEST(sections_placed_along_a_spine_are_not_compared_with_their_points)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size = 0;
    static const char text[] = "batten: 1\nunits: m\nfeatures:\n"
                               "  p: {points: [[1, 0], [0, 1], [-1, 0], [0, -1]]}\n"
                               "  c: {interpolate: p}\n"
                               "  q: {scale: c, by: 0.5}\n"
                               "  path: {line: [[5, 0, 0], [5, 0, 3]]}\n"
                               "  s: {skin: [c, q], spine: path}\n"
                               "outputs:\n  r.txt: {check: s}\n";
    CHECK_OK(batten_design_parse(text, sizeof text - 1, NULL, NULL, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    CHECK(strstr(data, "points given") == NULL);
    batten_release(data);
    batten_design_free(design);
}

TEST(surfaces_without_points_do_not_fail_for_want_of_points)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK(holds("batten: 1\nfeatures:\n  s: {sphere: 1 m}\noutputs:\n  r.txt: {check: s, "
                "within: 1 mm}\n",
                notes));
    /* A call that failed for want of memory says so, and speaks again when it is made again. */
    const int count = batten_notes_count(notes), dropped = batten_notes_dropped(notes);
    CHECK(count + dropped >= 1);
    if (dropped == 0)
        CHECK_CONTAINS(batten_notes_at(notes, count - 1)->text, "was not needed");
    batten_notes_free(notes);
}

TEST(a_curve_is_measured_against_the_points_it_was_made_from)
{
    static const char curve[] =
        "batten: 1\nfeatures:\n  p: {points: [[0, 0], [1, 1], [2, 0], [3, 2]]}\n"
        "  c: {interpolate: p}\noutputs:\n  r.json: {check: c, within: 1 um}\n";
    char *json = NULL;
    CHECK(holds(curve, NULL));
    CHECK_OK(report(curve, &json));
    CHECK_CONTAINS(json, "\"distances\": [{\"from\": ");
    CHECK_NEAR(value_of(strstr(json, "distances"), "\"max\": "), 0, 1e-14);
    batten_release(json);
}

TEST(the_messages_of_a_report_are_the_notes)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    char *json = NULL;
    size_t size;
    static const char text[] = RAISED "  r.json: {check: flat, within: 0.5 mm}\n";
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, notes, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, notes, &json, &size));
    /* A note that found no memory is counted only. */
    if (batten_notes_count(notes) == 2) {
        CHECK_CONTAINS(json, "\"messages\": [\n    {\"file\": ");
        CHECK_CONTAINS(json, "a point given lies farther than 0.0005 from the shape");
    }
    batten_release(json);
    batten_design_free(design);
    batten_notes_free(notes);
}

TEST(points_within_the_bound_are_not_remarked_upon)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK(holds(RAISED "  r.json: {check: flat, within: 2 mm}\n", notes));
    for (int i = 0; i < batten_notes_count(notes); i++)
        CHECK(!strstr(batten_notes_at(notes, i)->text, "lies farther"));
    batten_notes_free(notes);
}

/* ---- what keeps a result from being fair ---- */

/* In excess: 2 of the profile, 1 of the knuckle, 4 of the sheer; that of a station shows in its section. */
static batten_loft_cut cuts[] = {{.family = BATTEN_LOFT_STATION, .needed = 0, .found = 9},
                                 {.family = BATTEN_LOFT_PROFILE, .needed = 1, .found = 3},
                                 {.family = BATTEN_LOFT_DIAGONAL, .needed = 0, .found = 9},
                                 {.family = BATTEN_LOFT_SHEER, .needed = 5, .found = 3},
                                 {.family = BATTEN_LOFT_KNUCKLE, .needed = 0, .found = 1},
                                 {.family = BATTEN_LOFT_SHEER, .needed = 0, .found = 4}};

TEST(inflections_in_excess_of_the_edges_of_a_lofting_count)
{
    static batten_loft_report loft = {.cut_count = COUNT(cuts), .cuts = cuts, .panel_count = 1};
    static const char *const whats[] = {"moved", "aside"};
    for (int i = 0; i < COUNT(whats); i++) {
        checked_design d;
        checked_open("  table: {points: [[0, 0, 0]]}\n  hull: {loft: table, within: 1 mm}\n"
                     "  moved: {swap: hull}\n  aside: {skin: table}\n",
                     whats[i], &d);
        checked_result(&d, "hull")->shown.loft = &loft;
        checked_put_line(&d, whats[i], (batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0});
        checked_run(&d, HUGE_VAL);
        CHECK_INT(d.check.unfairness.inflections, i ? 0 : 7);
        CHECK(bat_check_is_fair(&d.check) == (i == 1));
        checked_close(&d);
    }
}

TEST(each_kind_of_flaw_alone_keeps_a_result_from_being_fair)
{
    static const bat_unfairness flaws[] = {
        {.corners = 1},   {.curvature_jumps = 1}, {.inflections = 1},
        {.unbounded = 1}, {.creases = 1},         {.edge_jumps = 1},
        {.folds = 1},     {.joint_corners = 1},   {.joint_jumps = 1}};
    bat_check check = {
        .unfairness = {.largest_turn = 1, .largest_crease = 1, .largest_joint = 1}};
    CHECK(bat_check_is_fair(&check));
    for (int i = 0; i < COUNT(flaws); i++) {
        check.unfairness = flaws[i];
        CHECK(!bat_check_is_fair(&check));
    }
}
