#include "design/outputs/fairness.h"

#include "design/outputs/checked.h"

#include <batten/scattered.h>
#include <batten/standard.h>
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

/* ---- edges of hulls ---- */

static batten_status make_table(batten_offset_table **out)
{
    static const batten_table_line lines[] = {{"sheer", false, 0}};
    static const batten_table_point points[] = {
        {0, 0, 0, -1}, {0, 1, 1, 0}, {4, 0, 0, -1}, {4, 1, 1, 0}};
    static const batten_table_station stations[] = {{"1", 0, 2, points},
                                                    {"2", 4, 2, points + 2}};
    return batten_offset_table_create(1, 1, lines, 2, stations, out);
}

/* Half-breadths at its corners; to starboard. Along an edge they change evenly: their mean is that of its ends. */
TEST(edges_of_a_hull_are_near_the_centre_plane_within_a_twentieth_of_its_breadth)
{
    static const struct {
        double y[4]; /* at (0, 0), (1, 0), (1, 1), (0, 1) */
        double gap[4];
        bool is_near[4]; /* u low, u high, v low, v high */
    } rows[] = {
        {{0, -4, -4, 0}, {0, 4, 4, 4}, {true, false, false, false}},
        {{0, -4, -4, -0.39}, {0.39, 4, 4, 4}, {true, false, false, false}},
        {{0, 4, 4, 0.41}, {0.41, 4, 4, 4}, {false, false, false, false}},
        {{0, 0, 4, 4}, {4, 4, 0, 4}, {false, false, true, false}},
        {{0.1, 0.2, 4, -0.2}, {0.2, 4, 0.2, 4}, {true, false, true, false}},
    };
    static const char *const names[] = {"u low", "u high", "v low", "v high"};
    for (int i = 0; i < COUNT(rows); i++) {
        const double *y = rows[i].y;
        checked_design d;
        batten_offset_table *table = NULL;
        batten_surface *surface = NULL;
        checked_open("  table: {points: [[0, 0, 0]]}\n  hull: {skin: table}\n", "hull", &d);
        CHECK_OK(make_table(&table));
        checked_put(&d, "table",
                    &(batten_object){.name = "table",
                                     .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                     .offset_table = table});
        batten_offset_table_unref(table);
        CHECK_OK(batten_surface_bilinear((batten_vec3){0, y[0], 0}, (batten_vec3){4, y[1], 0},
                                         (batten_vec3){0, y[3], 1}, (batten_vec3){4, y[2], 1},
                                         &surface));
        checked_put_surface(&d, "hull", surface);
        const bat_checked *c = checked_run(&d, HUGE_VAL);
        CHECK_INT(c->edge_count, 4);
        for (int k = 0; k < 4; k++) {
            CHECK_TEXT(c->edges[k].name, names[k]);
            CHECK_NEAR(c->edges[k].gap, rows[i].gap[k], 1e-12);
            CHECK(c->edges[k].is_near == rows[i].is_near[k]);
        }
        checked_close(&d);
    }
}

/* ---- sets of triangles ---- */

static batten_status take_text(const bat_check *check, char **data)
{
    batten_text text = BATTEN_TEXT;
    size_t size;
    bat_report_text(check, &text);
    const batten_status status = batten_text_take(&text, data, &size);
    batten_text_free(&text);
    return status;
}

/* Two halves of the unit square, bent along the diagonal: the normals are (0, 0, 1) and (1, 1, 1) / sqrt 3. */
TEST(the_inner_edges_of_triangles_and_their_angle_are_reported)
{
    static const double vertices[] = {0, 0, 1, 0, 1, 1, 0, 1};
    static const int corners[] = {0, 1, 2, 0, 2, 3};
    static const double heights[] = {0, 0, 0, 2};
    checked_design d;
    batten_triangles *flat = NULL, *bent = NULL;
    checked_open("  three: {bezier-triangle: net}\n  net: {points: [[0, 0, 0]]}\n", "three",
                 &d);
    CHECK_OK(batten_triangles_linear(&(batten_triangulation){4, vertices, corners}, 2, heights,
                                     &flat));
    CHECK_OK(batten_triangles_from_function(flat, &bent));
    batten_triangles_unref(flat);
    checked_put(
        &d, "three",
        &(batten_object){.name = "three", .kind = BATTEN_OBJECT_TRIANGLES, .triangles = bent});
    batten_triangles_unref(bent);
    const bat_checked *c = checked_run(&d, HUGE_VAL);
    CHECK_INT(c->triangle_joins, 1);
    CHECK_NEAR(c->triangle_gap, 0, 0);
    CHECK_NEAR(c->triangle_angle, acos(1. / 3), 1e-12);
    char *data = NULL;
    CHECK_OK(take_text(&d.check, &data));
    CHECK_CONTAINS(
        data,
        "2 triangles of degree 1; at 1 inner edge gaps of at most 0 m, normals turn by at most 1.231 rad\n");
    batten_release(data);
    checked_close(&d);
}

/* ---- bounds of joins ---- */

/* A plane before x = 0, and behind it a sheet that rises by s x + c x^2. */
static void put_sheets(checked_design *d, double s, double c)
{
    const double u[] = {0, 0, 0, 1, 1, 1}, v[] = {0, 0, 1, 1};
    const batten_axis axes[] = {{2, 3, u, false}, {1, 2, v, false}};
    const double points[] = {0,   0, 0,     0,   1, 0, /* of s x + c x^2 */
                             0.5, 0, s / 2, 0.5, 1, s / 2, 1, 0, s + c, 1, 1, s + c};
    batten_surface *plane = NULL, *sheet = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){-1, 0, 0}, (batten_vec3){0, 0, 0},
                                     (batten_vec3){-1, 1, 0}, (batten_vec3){0, 1, 0}, &plane));
    checked_put_surface(d, "a", plane);
    CHECK_OK(batten_surface_create(3, &axes[0], &axes[1], points, NULL, &sheet));
    checked_put_surface(d, "b", sheet);
}

/* Two lines with an angle between them, or a line and an arc. */
static void put_curves(checked_design *d, double s, double c)
{
    const double knots[] = {0, 0, 0, 1, 1, 1};
    const double points[] = {0, 0, 0, 0.5, s / 2, 0, 1, s + c, 0};
    batten_curve *bow = NULL;
    checked_put_line(d, "a", (batten_vec3){-1, 0, 0}, (batten_vec3){0, 0, 0});
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &bow));
    checked_put(d, "b",
                &(batten_object){.name = "b", .kind = BATTEN_OBJECT_CURVE, .curve = bow});
    batten_curve_unref(bow);
}

static batten_status judge_within(checked_design *d, double angle, double curvature)
{
    const bat_fair_bounds bounds = {angle, curvature};
    bat_check_release(&d->check);
    return bat_check_all(&d->run, "check", HUGE_VAL, &bounds, &bounds, &d->check);
}

/* What is at its bound holds, and what is above it by a bit does not. */
TEST(joins_may_turn_and_jump_up_to_their_bounds_and_no_further)
{
    for (int i = 0; i < 4; i++) {
        const bool is_of_curves = i / 2, turns = i % 2;
        checked_design d;
        checked_open("  a: {points: [[0, 0]]}\n  b: {points: [[0, 0]]}\n", "[a, b]", &d);
        (is_of_curves ? put_curves : put_sheets)(&d, turns ? 0.5 : 0, turns ? 0 : 1);
        const bat_unfairness *u = &d.check.unfairness;
        CHECK_OK(judge_within(&d, 3, 3));
        CHECK_INT(d.check.join_count, 1);
        const batten_join join = d.check.joins[0].of;
        CHECK_NEAR(join.angle.value, turns ? atan(0.5) : 0, 1e-12);
        CHECK_NEAR(u->largest_crease, is_of_curves ? 0 : join.angle.value, 0);
        for (int above = 0; above < 2; above++) {
            const double angle = above ? nextafter(join.angle.value, 0) : join.angle.value,
                         jump =
                             above ? nextafter(join.curvature.value, 0) : join.curvature.value;
            CHECK_OK(turns ? judge_within(&d, angle, 3) : judge_within(&d, 1e-6, jump));
            CHECK_INT(u->creases, above && turns && !is_of_curves);
            CHECK_INT(u->edge_jumps, above && !turns && !is_of_curves);
            CHECK_INT(u->joint_corners, above && turns && is_of_curves);
            CHECK_INT(u->joint_jumps, above && !turns && is_of_curves);
            CHECK_NEAR(u->largest_joint, above && turns && is_of_curves ? join.angle.value : 0,
                       0);
        }
        checked_close(&d);
    }
}
