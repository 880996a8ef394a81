#include "support/test.h"

#include <batten/design.h>

/* The example's sharpie with these straight runs. */
static batten_status loft_sharpie(const char *runs, batten_design **out)
{
    char text[1000];
    snprintf(text, sizeof text,
             "batten: 1\nunits: in\nfeatures:\n  table: {read: '%s', reverse: yes}\n"
             "  hull: {loft: table, within: 0.125 in, knuckles: chine, straight: %s}\n",
             test_source("examples/sharpie/offsets.csv"), runs);
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, out));
    const batten_status status = batten_design_evaluate(*out, "hull", NULL, NULL);
    if (status != BATTEN_OK) { /* failing allocations try again */
        batten_design_free(*out);
        *out = NULL;
    }
    return status;
}

/* What y and z of an edge of a panel bend by: second differences over two feet from x - 12 on. */
static void measure_bend(const batten_design *design, int panel, double v, double x,
                         double bend[2])
{
    const batten_feature_result *hull = batten_design_result(design, "hull");
    const batten_surface *s = batten_model_object(hull->value, panel)->surface;
    double p[3][3];
    for (int k = 0; k < 3; k++)
        CHECK_OK(batten_surface_evaluate(s, (x + 12 * (k - 1) + 168) / 168, v, 0, p[k]));
    for (int c = 0; c < 2; c++)
        bend[c] = p[0][c + 1] - 2 * p[1][c + 1] + p[2][c + 1];
}

/* Stations 5 to transom are at x from -168 to -120, 3 to 4 from -96 to -72. */
TEST(stations_are_named_in_either_order_and_views_at_the_end)
{
    static const struct {
        const char *runs;
        int panel;
        double v, x;
        bool straight[2];
    } cases[] = {
        {"'chine from 3 to 4'", 0, 1, -84, {true, true}},
        {"'chine from 4 to 3 in profile'", 1, 0, -84, {false, true}},
        {"['chine from 3 to 4 in plan']", 1, 0, -84, {true, false}},
        {"[sheer from transom to 5 in plan, 'chine from 3 to 4']", 1, 1, -150, {true, false}},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        batten_design *design = NULL;
        double bend[2];
        CHECK_OK(loft_sharpie(cases[k].runs, &design));
        measure_bend(design, cases[k].panel, cases[k].v, cases[k].x, bend);
        for (int c = 0; c < 2; c++)
            CHECK((fabs(bend[c]) < 1e-13) == cases[k].straight[c]);
        batten_design_free(design);
    }
}

TEST(what_is_no_straight_run_is_refused_with_what_would_be_one)
{
    static const struct {
        const char *runs, *message;
        batten_status status;
    } cases[] = {
        {"chine", "'chine' is not a straight run: it must read LINE from STATION to STATION",
         BATTEN_BAD_ARGUMENT},
        {"'chine to 4'", "'chine to 4' is not a straight run", BATTEN_BAD_ARGUMENT},
        {"'chine from 4'", "'chine from 4' is not a straight run", BATTEN_BAD_ARGUMENT},
        {"' from 3 to 4'", "is not a straight run", BATTEN_BAD_ARGUMENT},
        {"'chine from 3 to 4 in space'",
         "the table has no station '4 in space'; its stations are "
         "'transom', '6', '5', '4', '3', '2', '1', 'stem'",
         BATTEN_NOT_FOUND},
        {"'chine from 9 to 4'", "the table has no station '9'", BATTEN_NOT_FOUND},
        {"'chine from 4 to 4'",
         "the straight run 'chine from 4 to 4' begins and ends at one station",
         BATTEN_BAD_ARGUMENT},
        {"'wale from 3 to 4'",
         "the line 'wale' bounds no panel from station '4' (x = -96) to station '3' (x = -72)",
         BATTEN_NOT_FOUND},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        batten_design *design = NULL;
        CHECK_STATUS(loft_sharpie(cases[k].runs, &design), cases[k].status);
        CHECK_MESSAGE(cases[k].message);
        batten_design_free(design);
    }
}
