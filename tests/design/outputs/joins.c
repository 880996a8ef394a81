#include "design/outputs/fairness.h"

#include "support/test.h"

#include <stdlib.h>

static batten_status make(const char *text, char **json)
{
    size_t size;
    batten_design *design = NULL;
    batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, NULL, json, &size);
    batten_design_free(design);
    return status;
}

/* The JSON of the check of `what`; bytes to release. */
static char *check(const char *features, const char *what)
{
    char text[2000];
    char *json = NULL;
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%soutputs:\n  r.json: {check: %s}\n",
             features, what);
    CHECK_OK(make(text, &json));
    return json;
}

/* The number behind a key of the join of these sides; NaN for null. */
static double value(const char *json, const char *a, const char *b, const char *key)
{
    const char *at = json ? strstr(json, "\"joins\"") : NULL;
    for (; at && (at = strstr(at, "{\"a\": ")); at++) {
        char side_a[40], side_b[40];
        snprintf(side_a, sizeof side_a, "\"side_a\": \"%s\"", a);
        snprintf(side_b, sizeof side_b, "\"side_b\": \"%s\"", b);
        const char *end = strchr(at, '}'), *found = strstr(at, side_a),
                   *other = strstr(at, side_b);
        if (!found || found > end || !other || other > end)
            continue;
        const char *digits = strstr(at, key) + strlen(key);
        return strncmp(digits, "null", 4) == 0 ? NAN : atof(digits);
    }
    CHECK(!"the join is listed");
    return NAN;
}

static int join_count(const char *json)
{
    int count = 0;
    for (const char *at = json ? strstr(json, "\"joins\"") : NULL;
         at && (at = strstr(at, "{\"a\": ")); at++)
        count++;
    return count;
}

/* ---- the verdict on lines of several curves ---- */

static const char met[] = "  a: {line: [[0, 0], [1, 0]]}\n"
                          "  up: {line: [[1, 0], [1, 1]]}\n"
                          "  on: {line: [[1, 0], [2, 0]]}\n"
                          "  bend: {arc: 1, start: -90 deg, angle: 90 deg, at: [1, 1]}\n";

TEST(corners_and_jumps_where_two_curves_meet_and_no_third_count_in_the_verdict)
{
    static const struct {
        const char *what, *verdict, *counts;
    } cases[] = {
        {"[a, up]", "\"fair\": false", "\"corners_where_curves_meet\": 1, \"jumps"},
        {"[a, on]", "\"fair\": true",
         "\"corners_where_curves_meet\": 0, \"jumps_where_curves_meet\": 0, "},
        /* A third end: no line passes through. */
        {"[a, up, on]", "\"fair\": true", "\"branch\": true"},
        {"[a, bend]", "\"fair\": false",
         "\"corners_where_curves_meet\": 0, \"jumps_where_curves_meet\": 1, "},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char *json = check(met, cases[i].what);
        CHECK_CONTAINS(json, cases[i].verdict);
        CHECK_CONTAINS(json, cases[i].counts);
        batten_release(json);
    }
}

TEST(a_line_that_leaves_an_arc_along_its_tangent_lacks_its_curvature)
{
    /* The quarter circle from (1, 0) to (0, 1) and a line on from there. */
    char *json =
        check("  a: {arc: 1 m, angle: 90 deg}\n  l: {line: [[0, 1], [-2, 1]]}\n", "[a, l]");
    CHECK_INT(join_count(json), 1);
    CHECK(value(json, "end", "start", "\"g0\": ") <= 1e-15);
    CHECK_NEAR(value(json, "end", "start", "\"g1\": "), 0, 1e-14);
    CHECK_NEAR(value(json, "end", "start", "\"g2\": "), 1, 1e-14);
    CHECK_NEAR(value(json, "end", "start", "\"g3\": "), 0, 1e-13);
    batten_release(json);
}

TEST(lines_meet_at_the_angle_between_them_whichever_way_they_run)
{
    static const char *const lines[] = {"[[0, 0], [1, 0]]", "[[1, 0], [0, 0]]"};
    static const char *const sides[] = {"end", "start"};
    for (int i = 0; i < COUNT(lines); i++) {
        char features[200];
        snprintf(features, sizeof features, "  a: {line: %s}\n  b: {line: [[1, 0], [2, 1]]}\n",
                 lines[i]);
        char *json = check(features, "[a, b]");
        CHECK_INT(join_count(json), 1);
        CHECK_NEAR(value(json, sides[i], "start", "\"g1\": "), atan(1), 1e-15);
        CHECK_NEAR(value(json, sides[i], "start", "\"g2\": "), 0, 1e-15);
        batten_release(json);
    }
}

TEST(both_parts_of_a_split_curve_join_in_all_derivatives)
{
    char *json = check(
        "  p: {points: [[0, 0, 0], [1, 2, 1], [3, 1, 2], [4, 3, 0], [6, 2, 1]]}\n"
        "  c: {interpolate: p}\n  d: {elevate: c, by: 1}\n  s: {split: d, parameter: 0.4}\n",
        "s");
    CHECK_INT(join_count(json), 1);
    CHECK_NEAR(value(json, "end", "start", "\"g1\": "), 0, 1e-12);
    CHECK_NEAR(value(json, "end", "start", "\"g2\": "), 0, 1e-10);
    CHECK_NEAR(value(json, "end", "start", "\"g3\": "), 0, 1e-8);
    batten_release(json);
}

TEST(the_rate_of_curvature_is_that_of_a_parabola)
{
    /* y = x^2 and its mirror image in y: at the origin both have curvature 2 and rate 0; from
     * x = 1 on, a parabola meets itself reversed: the rates 24 x / (1 + 4 x^2)^3 differ by
     * twice. */
    char *json = check(
        "  a: {conic: [[0, 0], [0.5, 0], [1, 1]], weight: 1}\n  b: {reverse: a}\n", "[a, b]");
    CHECK_NEAR(value(json, "end", "start", "\"g0\": "), 0, 0);
    CHECK_NEAR(value(json, "end", "start", "\"g1\": "), acos(-1), 1e-14);
    CHECK_NEAR(value(json, "end", "start", "\"g3\": "), 2 * 24 / 125.0 * sqrt(1), 1e-12);
    batten_release(json);
}

TEST(ends_farther_apart_than_the_tolerance_do_not_join)
{
    char *json =
        check("  a: {line: [[0, 0], [1, 0]]}\n  b: {line: [[1.01, 0], [2, 1]]}\n", "[a, b]");
    CHECK_INT(join_count(json), 0);
    batten_release(json);
}

#define HALVES                                           \
    "  a: {arc: 1 m, angle: 90 deg, axis: x, from: y}\n" \
    "  u: {extrude: a, along: [3 m, 0, 0]}\n"            \
    "  b: {line: [[0, 0, 1], [0, -2, 1]]}\n"             \
    "  v: {extrude: b, along: [3 m, 0, 0]}\n"            \
    "  c: {line: [[3, -2, 2], [3, 0, 1]]}\n  w: {extrude: c, along: [-3 m, 0, 0]}\n"

TEST(a_plane_that_touches_a_cylinder_lacks_its_curvature)
{
    char *json = check(HALVES, "[u, v]");
    CHECK_INT(join_count(json), 1);
    CHECK(value(json, "u high", "u low", "\"g0\": ") <= 1e-14);
    CHECK_NEAR(value(json, "u high", "u low", "\"g1\": "), 0, 1e-13);
    CHECK_NEAR(value(json, "u high", "u low", "\"g2\": "), 1, 1e-13);
    CHECK_NEAR(value(json, "u high", "u low", "\"g3\": "), 0, 1e-11);
    batten_release(json);
}

TEST(surfaces_meet_at_the_angle_between_them_with_edges_run_in_opposite_directions)
{
    char *json = check(HALVES, "[u, w]");
    CHECK_INT(join_count(json), 1);
    CHECK_NEAR(value(json, "u high", "u high", "\"g1\": "), atan(0.5), 1e-13);
    batten_release(json);
}

TEST(a_sphere_joins_at_its_seam_and_not_at_its_poles)
{
    char *json = check("  s: {sphere: 1 m}\n", "s");
    CHECK_INT(join_count(json), 1);
    CHECK_NEAR(value(json, "u low", "u high", "\"g1\": "), 0, 1e-12);
    CHECK_NEAR(value(json, "u low", "u high", "\"g2\": "), 0, 1e-10);
    batten_release(json);
}

TEST(an_edge_that_runs_along_a_part_of_another_joins_it)
{
    /* A quarter cylinder on x = 0 .. 3, and under it a wall on x = 1 .. 2 of another height:
     * the wall goes on from the cylinder, straight. */
    char *json = check("  a: {arc: 1 m, angle: 90 deg, axis: x, from: y}\n"
                       "  u: {extrude: a, along: [3 m, 0, 0]}\n"
                       "  b: {line: [[1, 1, 0], [2, 1, 0]]}\n"
                       "  v: {extrude: b, along: [0, 0, -2 m]}\n",
                       "[u, v]");
    CHECK_INT(join_count(json), 1);
    CHECK_CONTAINS(json, "\"part\": \"b\"");
    CHECK(value(json, "u low", "v low", "\"g0\": ") <= 1e-14);
    CHECK_NEAR(value(json, "u low", "v low", "\"g1\": "), 0, 1e-13);
    CHECK_NEAR(value(json, "u low", "v low", "\"g2\": "), 1, 1e-13);
    batten_release(json);
}

TEST(edges_that_overlap_or_touch_in_a_corner_alone_do_not_join)
{
    static const char *const lines[] = {"[[2, 1, 0], [4, 1, 0]]",   /* half on, half beyond */
                                        "[[3, 1, 0], [5, 1, 0]]",   /* goes on from its end */
                                        "[[1, 1, 0], [2, 1, 0.1]]", /* leaves it */
                                        "[[1, 1, 0], [1.0004, 1, 0]]"};
    for (int i = 0; i < COUNT(lines); i++) {
        char features[400];
        snprintf(features, sizeof features,
                 "  a: {line: [[0, 1, 0], [3, 1, 0]]}\n  u: {extrude: a, along: [0, 1, 0]}\n"
                 "  b: {line: %s}\n  v: {extrude: b, along: [0, 0, -2]}\n",
                 lines[i]);
        char *json = check(features, "[u, v]");
        CHECK_INT(join_count(json), 0);
        batten_release(json);
    }
}

TEST(closed_edges_join_wherever_they_begin)
{
    char *json = check("  a: {circle: 1 m}\n  u: {extrude: a, along: [0, 0, 1]}\n"
                       "  b: {rotate: a, by: 90 deg, axis: z}\n"
                       "  v: {extrude: b, along: [0, 0, -1]}\n",
                       "[u, v]");
    CHECK_NEAR(value(json, "v low", "v low", "\"g1\": "), 0, 1e-12);
    CHECK_NEAR(value(json, "v low", "v low", "\"g2\": "), 0, 1e-10);
    batten_release(json);
}

TEST(a_fill_joins_the_surfaces_around_though_their_edges_are_longer)
{
    char *json = check("  a: {arc: 1, angle: 90 deg}\n"
                       "  b: {arc: 1, angle: 90 deg, axis: x, from: y}\n"
                       "  c: {arc: 1, angle: 90 deg, axis: y, from: z}\n"
                       "  down: {extrude: a, along: [0, 0, -1.2]}\n"
                       "  back: {extrude: b, along: [-1.2, 0, 0]}\n"
                       "  left: {extrude: c, along: [0, -1.2, 0]}\n"
                       "  x: {fill: [c, a, b], along: [down, back, left]}\n",
                       "[x, down, back, left]");
    int parts = 0;
    for (const char *at = json; (at = strstr(at, "\"part\": \"a\"")); at++)
        parts++;
    CHECK_INT(parts, 6); /* two halves of three sides */
    batten_release(json);
}

TEST(an_edge_is_compared_in_all_its_spans)
{
    /* The far side has a narrow peak, where the ruled surface is tilted by 0.1. */
    char *json = check("  a: {line: [[0, 0, 0], [1, 0, 0]]}\n"
                       "  u: {extrude: a, along: [0, -1, 0]}\n"
                       "  b: {polyline: [[0, 1, 0], [0.4, 1, 0], [0.41, 1, 0.1], [0.42, 1, 0], "
                       "[1, 1, 0]]}\n"
                       "  v: {ruled: [a, b]}\n",
                       "[v, u]");
    CHECK_NEAR(value(json, "v low", "v low", "\"g1\": "), atan(0.1), 0.01);
    batten_release(json);
}

TEST(closed_edges_with_corners_are_compared_on_the_same_side_of_each_corner)
{
    /* Up and down from one closed line with a sharp edge behind: both go on straight, wherever
     * the second begins and whichever way it runs. */
    static const char *const others[] = {
        "[[0, 0], [1, 0.2], [2, 0], [1, -0.2], [0, 0]]",
        "[[0, 0], [1, -0.2], [2, 0], [1, 0.2], [0, 0]]",
        "[[1, 0.2], [2, 0], [1, -0.2], [0, 0], [1, 0.2]]",
    };
    for (int i = 0; i < COUNT(others); i++) {
        char features[400];
        snprintf(features, sizeof features,
                 "  a: {polyline: [[0, 0], [1, 0.2], [2, 0], [1, -0.2], [0, 0]]}\n"
                 "  u: {extrude: a, along: [0, 0, 1]}\n"
                 "  b: {polyline: %s}\n  v: {extrude: b, along: [0, 0, -1]}\n",
                 others[i]);
        char *json = check(features, "[u, v]");
        CHECK_NEAR(value(json, "v low", "v low", "\"g1\": "), 0, 1e-7);
        CHECK_NEAR(value(json, "v low", "v low", "\"g2\": "), 0, 1e-7);
        batten_release(json);
    }
}

TEST(a_join_with_an_angle_along_a_closed_edge_with_a_corner_keeps_its_angle)
{
    /* Down in a slant: the walls turn by what their normals say, nowhere less. */
    char *json = check("  a: {polyline: [[0, 0], [1, 0.2], [2, 0], [1, -0.2], [0, 0]]}\n"
                       "  u: {extrude: a, along: [0, 0, 1]}\n"
                       "  v: {extrude: a, along: [0.3, 0, -1]}\n",
                       "[u, v]");
    /* A wall along (1, 0.2, 0): the way into v, square to the edge, against (0, 0, -1). */
    const double across = 0.3 * 0.2 / hypot(1, 0.2);
    CHECK_NEAR(value(json, "v low", "v low", "\"g1\": "), atan(across), 1e-9);
    batten_release(json);
}

TEST(a_crease_where_surfaces_meet_is_not_fair_unless_the_bound_allows_it)
{
    /* u and w meet at atan(1/2) = 26.57 degrees; u and v smoothly, but u bends and v does not. */
    static const struct {
        const char *of, *verdict;
    } rows[] = {
        {"[u, w]",
         "Verdict: not fair as a free surface: 1 edge with a crease of 26.57 degrees."},
        {"[u, w], angle: 26 deg", "Verdict: not fair as a free surface: 1 edge with a crease"},
        {"[u, w], angle: 27 deg", "Verdict: fair as a free surface."},
        {"[u, v]", "not fair as a free surface: 1 edge with a jump of curvature."},
        {"[u, v], curvature: 1.1", "Verdict: fair as a free surface."},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char design[600];
        char *text = NULL;
        snprintf(design, sizeof design,
                 "batten: 1\nfeatures:\n" HALVES "outputs:\n  r.txt: {check: %s}\n",
                 rows[i].of);
        CHECK_OK(make(design, &text));
        CHECK_CONTAINS(text, rows[i].verdict);
        batten_release(text);
    }
}

TEST(bounds_that_judge_nothing_are_refused)
{
    static const char *const rows[] = {"within: 0 m", "within: -1 mm", "angle: 0 deg",
                                       "angle: 200 deg", "curvature: 0"};
    for (int i = 0; i < COUNT(rows); i++) {
        char design[600];
        char *text = NULL;
        snprintf(design, sizeof design,
                 "batten: 1\nfeatures:\n" HALVES "outputs:\n  r.txt: {check: [u, w], %s}\n",
                 rows[i]);
        CHECK_STATUS(make(design, &text), BATTEN_BAD_ARGUMENT);
    }
}

TEST(corners_of_curves_without_points_are_not_fair)
{
    char *text = NULL;
    CHECK_OK(make("batten: 1\nfeatures:\n  a: {line: [[0, 0, 0], [1, 0, 0]]}\n"
                  "  b: {line: [[1, 0, 0], [1, 1, 1]]}\n  c: {join: [a, b]}\n"
                  "outputs:\n  r.txt: {check: c}\n",
                  &text));
    CHECK_CONTAINS(text, "Verdict: not fair as a curve: 1 corner of 90 degrees.");
    batten_release(text);
}

TEST(a_report_says_where_curvature_is_not_known_and_prints_no_nan)
{
    /* A parabola of the third degree that begins with a cusp: its curvature there is infinite. */
    char *text = NULL;
    CHECK_OK(make("batten: 1\nfeatures:\n  a: {line: [[-1, 0], [0, 0]]}\n"
                  "  p: {points: [[0, 0], [0, 0], [1, 0], [1, 1]]}\n  b: {bezier: p}\n"
                  "outputs:\n  r.txt: {check: [a, b]}\n",
                  &text));
    CHECK_CONTAINS(text, "turning by 0 rad, curvatures not known at a cusp");
    CHECK(text && !strstr(text, "nan"));
    batten_release(text);
}

TEST(the_seam_of_a_surface_is_smooth_up_to_its_sharp_tips)
{
    /* Heights at which the rows of weights at the tips are rounded differently. */
    for (int height = 2; height <= 8; height++) {
        char features[300];
        snprintf(features, sizeof features,
                 "  b: {points: [[0, 0, -1]]}\n  c: {circle: 1}\n  t: {points: [[0, 0, %d]]}\n"
                 "  s: {skin: [b, c, t]}\n",
                 height);
        char *json = check(features, "s");
        CHECK_INT(join_count(json), 1);
        CHECK_NEAR(value(json, "u low", "u high", "\"g1\": "), 0, 1e-9);
        batten_release(json);
    }
}
