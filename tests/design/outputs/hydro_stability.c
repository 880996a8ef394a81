/* Stability in the report of hydrostatics, of boxes whose arms are known in closed form. */
#include "support/test.h"

#include <batten/design.h>
#include <stdlib.h>
#include <string.h>

static const double DEGREE = 3.14159265358979323846 / 180;

/* 4 long, 2 wide, 2 deep. */
static batten_status report(const char *output, char **data)
{
    char text[1000];
    batten_design *design = NULL;
    size_t size;
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nfeatures:\n"
             "  low: {polyline: [[0, 0, 0], [0, 1, 0], [0, 1, 2]]}\n"
             "  high: {move: low, by: [4, 0, 0]}\n"
             "  half: {ruled: [low, high]}\noutputs:\n  %s\n",
             output);
    batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, NULL, data, &size);
    batten_design_free(design);
    return status;
}

static double number(const char *text, const char *key)
{
    const char *at = strstr(text, key);
    CHECK(at != NULL);
    return strtod(at + strlen(key), NULL);
}

/* The integral of sin (gm + bm / 2 tan^2). */
static double area_of(double gm, double bm, double heel)
{
    return gm * (1 - cos(heel)) + bm / 2 * (1 / cos(heel) + cos(heel) - 2);
}

TEST(areas_below_the_arms_of_a_box_are_those_of_its_wall_sides)
{
    const double t = 0.9, bm = 4 / (12 * t), gm = t / 2 + bm - 0.8;
    char *data = NULL;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 1, mass: 7.38, gravity: [2, 0, "
                    "0.8], heels: 10 deg}",
                    &data));
    const char *m = strstr(data, "\"measures\"");
    const double to30 = area_of(gm, bm, 30 * DEGREE), to40 = area_of(gm, bm, 40 * DEGREE);
    CHECK_NEAR(number(m, "\"GM\": "), gm, 1e-9);
    CHECK_NEAR(number(m, "\"area30\": "), to30, number(m, "\"area30_error\": "));
    CHECK_NEAR(number(m, "\"area40\": "), to40, number(m, "\"area40_error\": "));
    CHECK_NEAR(number(m, "\"area30to40\": "), to40 - to30, 1e-8);
    CHECK(number(m, "\"area40_error\": ") < 1e-8);
    CHECK_NEAR(number(m, "\"area_to\": "), 40, 0);
    batten_release(data);
}

/* Without the area above the flooded opening; the box draws 0.9 up to a tangent of 0.9. */
TEST(an_opening_and_the_edge_of_the_deck_are_immersed_where_the_plane_meets_them)
{
    char *data = NULL;
    const double heel = atan(0.55 / 0.8) / DEGREE, bm = 4 / 10.8, gm = 0.45 + bm - 0.8;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 1, mass: 7.38, gravity: [2, 0, "
                    "0.8], heels: 10 deg, openings: [[2, 0.8, 1.45], [1, 0, 2]]}",
                    &data));
    const char *m = strstr(data, "\"measures\"");
    CHECK_NEAR(number(m, "\"opening_heel\": "), heel, 1e-6);
    CHECK_NEAR(number(m, "\"area_to\": "), heel, 1e-6);
    CHECK_NEAR(number(m, "\"area40\": "), area_of(gm, bm, heel * DEGREE), 1e-8);
    batten_release(data);
    /* Deeper: the deck meets the water at a tangent of 0.5, before the bottom leaves it. */
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 1, mass: 12.3, gravity: [2, 0, "
                    "0.8], heels: 10 deg}",
                    &data));
    m = strstr(data, "\"measures\"");
    CHECK_NEAR(number(m, "\"deck_heel\": "), atan(0.5) / DEGREE, 1e-6);
    CHECK_CONTAINS(m, "\"opening_heel\": null");
    const char *arm = strstr(data, "\"heel\": 10,");
    CHECK_NEAR(number(arm, "\"freeboard\": "), 0.5 * cos(10 * DEGREE) - sin(10 * DEGREE), 1e-8);
    batten_release(data);
}

/* Flooded before 30 degrees: the area ends there, and there is none from 30 degrees on. */
TEST(an_opening_below_thirty_degrees_ends_the_area)
{
    char *data = NULL;
    const double heel = atan(0.2 / 0.8) / DEGREE, bm = 4 / 10.8, gm = 0.45 + bm - 0.8;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 1, mass: 7.38, gravity: [2, 0, "
                    "0.8], heels: 10 deg, openings: [[2, 0.8, 1.1]]}",
                    &data));
    const char *m = strstr(data, "\"measures\"");
    CHECK_NEAR(number(m, "\"opening_heel\": "), heel, 1e-6);
    CHECK_NEAR(number(m, "\"area_to\": "), heel, 1e-6);
    CHECK_NEAR(number(m, "\"area40\": "), area_of(gm, bm, heel * DEGREE), 1e-8);
    CHECK_CONTAINS(m, "\"area30to40\": null");
    batten_release(data);
}

TEST(cross_curves_of_a_box_are_arms_about_its_keel)
{
    const double drafts[] = {0.5, 0.9};
    char *data = NULL, *csv = NULL, *text = NULL;
    static const char output[] =
        "%s: {hydrostatics: half, draughts: 1, displacements: [4.1, 7.38], heels: [0 deg, 10 "
        "deg, 20 deg]}";
    char line[200];
    snprintf(line, sizeof line, output, "a.json");
    CHECK_OK(report(line, &data));
    const char *at = strstr(data, "\"cross_curves\"");
    for (int i = 0; i < 2; i++) {
        const double t = drafts[i], bm = 4 / (12 * t);
        at = strstr(at, "\"KN\": [0, ");
        CHECK(at != NULL);
        char *end = NULL;
        const double ten = strtod(at + strlen("\"KN\": [0, "), &end),
                     twenty = strtod(end + 2, NULL);
        const double t10 = tan(10 * DEGREE), t20 = tan(20 * DEGREE);
        CHECK_NEAR(ten, sin(10 * DEGREE) * (t / 2 + bm + bm / 2 * t10 * t10), 1e-8);
        CHECK_NEAR(twenty, sin(20 * DEGREE) * (t / 2 + bm + bm / 2 * t20 * t20), 1e-8);
        at = end;
    }
    snprintf(line, sizeof line, output, "a.csv");
    CHECK_OK(report(line, &csv));
    CHECK_CONTAINS(csv, "\nheel,KN at 4.1 t,KN at 7.38 t\ndeg,m,m\n0,0,0\n");
    snprintf(line, sizeof line, output, "a.txt");
    CHECK_OK(report(line, &text));
    CHECK_CONTAINS(text, "cross curves: KN, m, by heel, deg, and displacement, t\n"
                         "                     4.1        7.38\n"
                         "0                      0           0\n");
    CHECK(!strstr(text, "Afloat"));
    batten_release(data);
    batten_release(csv);
    batten_release(text);
}

TEST(a_catamaran_of_boxes_has_its_coefficients_by_both_breadths)
{
    char *data = NULL, *text = NULL;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 0.9, spacing: 7}", &data));
    CHECK_NEAR(number(data, "\"spacing\": "), 7, 0);
    CHECK_NEAR(number(data, "\"BWL\": "), 9, 1e-8);
    CHECK_NEAR(number(data, "\"CB\": "), 1, 1e-8);
    CHECK_NEAR(number(data, "\"CWP\": "), 1, 1e-8);
    CHECK_NEAR(number(data, "\"CX\": "), 1, 1e-7);
    const double bm = 2 * (32 / 12. + 8 * 49 / 4.) / (16 * 0.9);
    CHECK_NEAR(number(data, "\"KMT\": "), 0.45 + bm, 1e-9 * bm);
    batten_release(data);
    CHECK_OK(
        report("a.txt: {hydrostatics: half, draughts: 0.9, spacing: 7, heel: 2 deg}", &text));
    CHECK_CONTAINS(text, "two hulls, their centre planes 7 m apart");
    CHECK_CONTAINS(text, "CB   1                 -");
    batten_release(text);
}

TEST(what_says_nothing_of_stability_is_refused)
{
    static const struct {
        const char *output, *message;
    } rows[] = {
        {"a.txt: {hydrostatics: half, mass: 7}", "'mass' and 'gravity' belong together"},
        {"a.txt: {hydrostatics: half, gravity: [2, 0, 1]}",
         "'mass' and 'gravity' belong together"},
        {"a.txt: {hydrostatics: half, heels: 10 deg}", "'heels' are those of righting arms"},
        {"a.txt: {hydrostatics: half, openings: [[1, 0, 2]]}", "'openings' are flooded"},
        {"a.txt: {hydrostatics: half, spacing: 0}", "the hulls of a catamaran are 0 apart"},
        {"a.txt: {hydrostatics: half, spacing: 1.5}", "overlap"},
        {"a.txt: {hydrostatics: half, displacements: [3, -1]}", "displacement 2 of the cross"},
        {"a.txt: {hydrostatics: half, displacements: 30}", "it sinks"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char *data = NULL;
        batten_status status = report(rows[i].output, &data);
        if (test_memory_failed(status, BATTEN_BAD_ARGUMENT))
            status = report(rows[i].output, &data);
        CHECK_INT(status, BATTEN_BAD_ARGUMENT);
        CHECK(!data);
        CHECK_MESSAGE(rows[i].message);
    }
}

/* No arm of the list is longer, and at its heel the arm is that long. */
TEST(the_largest_arm_is_the_largest_of_all_and_stands_at_its_heel)
{
    static const char output[] =
        "a.json: {hydrostatics: half, draughts: 1, mass: 7.38, gravity: [2, 0, 0.8], heels: [%s]}";
    char line[300], heel[40], *data = NULL;
    snprintf(line, sizeof line, output,
             "10 deg, 20 deg, 30 deg, 35 deg, 40 deg, 45 deg, 50 deg, 60 deg, 70 deg, 80 deg");
    CHECK_OK(report(line, &data));
    const double most = number(data, "\"GZmax\": "), at = number(data, "\"GZmax_heel\": ");
    int arms = 0;
    for (const char *arm = data; (arm = strstr(arm, "\"GZ\": ")); arms++) {
        CHECK(strtod(arm + 6, NULL) <= most + 1e-9);
        arm += 6;
    }
    CHECK_INT(arms, 10);
    batten_release(data);
    snprintf(heel, sizeof heel, "%.12f deg", at);
    snprintf(line, sizeof line, output, heel);
    CHECK_OK(report(line, &data));
    CHECK_NEAR(number(data, "\"GZ\": "), most, 1e-8);
    CHECK(at > 20 && at < 80);
    batten_release(data);
}
