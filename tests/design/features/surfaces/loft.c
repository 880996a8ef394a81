#include "support/test.h"

#include <batten/design.h>
#include <stdlib.h>

/* The design of the example's hull with `within`, and one output. */
static void open_loft(const char *within, batten_design **out)
{
    char text[1000];
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nfeatures:\n  table: {read: '%s'}\n"
             "  hull: {loft: table, within: %s}\noutputs:\n  report.json: {check: hull}\n",
             test_source("examples/hull/offsets.csv"), within);
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, out));
}

TEST(the_example_hull_is_lofted_fair_within_its_bound)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size;
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    open_loft("2 mm", &design);
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    const batten_feature_result *hull = batten_design_result(design, "hull");
    CHECK(hull->loft && hull->loft->cuts_in_excess == 0 && hull->loft->cut_count > 50);
    CHECK(hull->loft->max_move <= 0.002 && hull->loft->max_move > 0);
    CHECK(hull->error_max == hull->loft->max_move);
    CHECK(!hull->has_moves && !hull->fairing);
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    CHECK_CONTAINS(data, "\"loft\": {\"max\": 0.00");
    CHECK_CONTAINS(data, "\"in_excess\": 0, \"excess_inflections\": 0");
    CHECK_CONTAINS(data, "\"fair\": true");
    batten_release(data);
    batten_design_free(design);
}

TEST(a_loft_of_what_is_no_table_is_refused_by_name)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n  p: {points: [[0, 0], [1, 1]]}\n"
        "  hull: {loft: p, within: 1 mm}\n";
    batten_design *design = NULL;
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_STATUS(batten_design_evaluate(design, "hull", NULL, NULL), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("hull");
    CHECK_MESSAGE("'p'");
    batten_design_free(design);
}

/* The design of the example's sharpie with these arguments of `read` and `loft`, and one output. */
static void open_sharpie(const char *read, const char *loft, batten_design **out)
{
    char text[1000];
    snprintf(text, sizeof text,
             "batten: 1\nunits: in\ntolerance: 0.005 in\nfeatures:\n  table: {read: '%s'%s}\n"
             "  hull: {loft: table, within: 0.125 in%s}\noutputs:\n"
             "  report.json: {check: hull, within: 0.125 in}\n",
             test_source("examples/sharpie/offsets.csv"), read, loft);
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, out));
}

TEST(a_declared_chine_makes_two_panels_that_the_check_finds_fair)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size;
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    open_sharpie("", ", knuckles: chine", &design);
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    const batten_feature_result *hull = batten_design_result(design, "hull");
    CHECK_INT(hull->loft->panel_count, 2);
    CHECK_INT(hull->loft->ruled_count, 2);
    CHECK_INT(hull->loft->cuts_in_excess, 0);
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    CHECK_CONTAINS(data, "\"name\": \"hull 1\"");
    CHECK_CONTAINS(data, "\"name\": \"hull 2\"");
    CHECK_CONTAINS(data, "\"knuckle\": true");
    CHECK_CONTAINS(data, "\"fair\": true");
    batten_release(data);
    batten_design_free(design);
}

TEST(a_chine_that_is_not_declared_or_not_read_is_refused_by_name)
{
    static const struct {
        const char *read, *loft;
        batten_status status;
        const char *message;
    } cases[] = {
        {"", "", BATTEN_UNSUPPORTED, "on the line 'chine'"},
        {"", ", knuckles: [chine, wale]", BATTEN_NOT_FOUND, "the table has no line 'wale'"},
        {", lines: [bottom, sheer]", ", knuckles: chine", BATTEN_NOT_FOUND,
         "the table has no line 'chine'; its lines are 'bottom', 'sheer'"},
        {", lines: keel", ", knuckles: chine", BATTEN_NOT_FOUND,
         "the table has no line 'keel'"},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        batten_design *design = NULL;
        open_sharpie(cases[k].read, cases[k].loft, &design);
        CHECK_STATUS(batten_design_evaluate(design, "hull", NULL, NULL), cases[k].status);
        CHECK_MESSAGE(cases[k].message);
        batten_design_free(design);
    }
}

/* A flat-bottomed boat in `folder`, its sheer pulled out at station 5, its chine beyond the centre plane at the
 * last: tables of 9 stations, the number written after each. */
static void write_boat(const char *path, double pull, double beyond)
{
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    fputs("station,height,half_breadth,line\n", file);
    for (int i = 0; i < 9; i++) {
        const double s = i / 8.0, q = (2 * s - 1) * (2 * s - 1);
        const double chine = i == 8 && beyond > 0 ? -beyond : sin(3.14159 * (0.15 + 0.84 * s));
        fprintf(file, "%.3f,%.3f,0,keel\n%.3f,%.3f,%.3f,chine\n%.3f,%.3f,%.3f,sheer\n", 10 * s,
                0.5 * q, 10 * s, 0.5 + 0.4 * q, chine, 10 * s, 1.6 + 0.3 * q,
                (i == 4 ? pull : 1) * 1.3 * sin(3.14159 * (0.2 + 0.79 * s)));
    }
    fclose(file);
}

static batten_design *loft_boat(double pull, double beyond, batten_notes *notes, char **report)
{
    char text[1000];
    batten_design *design = NULL;
    size_t size;
    const char *path = test_scratch("boat.csv");
    write_boat(path, pull, beyond);
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nfeatures:\n  table: {read: '%s'}\n"
             "  hull: {loft: table, within: 3 mm, knuckles: chine}\noutputs:\n"
             "  report.txt: {check: hull}\n",
             path);
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, notes));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, report, &size));
    return design;
}

TEST(edges_with_inflections_in_excess_and_points_beyond_the_centre_plane_are_said)
{
    batten_notes *notes = NULL;
    char *report = NULL;
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    batten_design *design = loft_boat(1, 0, NULL, &report);
    CHECK_CONTAINS(report, "Verdict: fair as a hull");
    batten_release(report);
    batten_design_free(design);
    CHECK_OK(batten_notes_create(100, &notes));
    design = loft_boat(10, 0, notes, &report);
    CHECK(batten_design_result(design, "hull")->loft->cuts_in_excess > 0);
    CHECK_CONTAINS(report, "Verdict: not fair as a hull");
    batten_release(report);
    batten_design_free(design);
    design = loft_boat(1, 0.2, notes, &report);
    bool said = false;
    for (int i = 0; i < batten_notes_count(notes); i++)
        said |= strstr(batten_notes_at(notes, i)->text,
                       "point 2 of station 9 (x = 10) is 0.2 beyond the centre plane") != NULL;
    CHECK(said);
    batten_release(report);
    batten_design_free(design);
    batten_notes_free(notes);
}
