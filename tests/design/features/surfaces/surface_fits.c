#include "support/test.h"

#include <batten/design.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 7, COLUMNS = 9 };

/* What the tests below fit: heights over a grid that is uneven in x, its rows from right to
 * left, with a spike in one row; points over a disc, and on an ellipsoid. */
static void write_points(void)
{
    FILE *grid = fopen(test_scratch("grid.xyz"), "w"),
         *disc = fopen(test_scratch("disc.xyz"), "w"),
         *body = fopen(test_scratch("body.xyz"), "w");
    CHECK(grid && disc && body);
    for (int j = 0; j < ROWS; j++, fputs("\n", grid))
        for (int i = COLUMNS - 1; i >= 0; i--)
            fprintf(grid, "%g %d %g\n", i + 0.05 * i * i, j,
                    i == 2 && j == 3 ? 20.0 : 0.5 * j + 0.1 * i);
    test_random random = test_random_begin("points of fits");
    for (int i = 0; i < 400; i++) {
        const double h = test_random_in(&random, -1, 1), a = test_random_in(&random, -4, 4);
        const double r = sqrt(1 - h * h);
        fprintf(body, "%.9g %.9g %.9g\n", 3 * r * cos(a), 2 * r * sin(a), h);
        fprintf(disc, "%.9g %.9g %.9g\n", r * cos(a), r * sin(a), 0.5 * r * r);
    }
    fclose(body);
    fclose(disc);
    fclose(grid);
}

/* Make feature 'a'; its notes and remarks, one a line, into `said`. Memory that failed may have
 * cost some: then `said` is empty. */
static batten_status make(const char *feature, char *said, size_t size, batten_design **out)
{
    char text[500];
    batten_notes *notes = NULL;
    write_points();
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nfeatures:\n  grid: {read: grid.xyz}\n  disc: {read: "
             "disc.xyz}\n  body: {read: body.xyz}\n  a: %s\n",
             feature);
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("fits.yaml");
    CHECK_OK(batten_notes_create(50, &notes));
    batten_design *design = NULL;
    batten_status status = batten_design_parse(text, strlen(text), &options, notes, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, "a", NULL, notes);
    if (status == BATTEN_OK)
        *out = design;
    else
        batten_design_free(design);
    said[0] = '\0';
    for (int i = 0; batten_notes_dropped(notes) == 0 && i < batten_notes_count(notes); i++) {
        const size_t used = strlen(said);
        snprintf(said + used, size - used, "%s\n", batten_notes_at(notes, i)->text);
    }
    batten_notes_free(notes);
    return status;
}

TEST(fits_say_what_is_odd_about_their_points)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{fit-grid: grid}", "'parameters: uniform'"},
        {"{interpolate-grid: grid}", "'parameters: uniform'"},
        {"{fit-scattered: body}", "the cloud does not lie over its base once"},
        {"{fit-scattered: disc, as: function}", "leaves the box of the points by"},
        {"{fit-scattered: grid, as: function, rms: 1 um, spans-u: 1, spans-v: 1}",
         "not the 1e-06 asked for: 4 x 4 control points"},
        {"{fit-scattered: disc, as: function, method: multilevel}",
         "the next would have more than eight control points for each point"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        char said[2000];
        CHECK_OK(make(rows[i].feature, said, sizeof said, &design));
        if (*said)
            CHECK_CONTAINS(said, rows[i].says);
        batten_design_free(design);
    }
}

TEST(heights_over_a_grid_are_fitted_as_a_function)
{
    batten_design *design = NULL;
    char said[2000];
    CHECK_OK(make("{fit-grid: grid, as: function, points-u: 9, points-v: 7}", said, sizeof said,
                  &design));
    CHECK(strstr(said, "single rows") == NULL);
    const batten_model *model = batten_design_result(design, "a")->value;
    const batten_surface *surface = batten_model_object(model, 0)->surface;
    for (int i = 0; i < COLUMNS; i++)
        for (int j = 0; j < ROWS; j++) {
            const double x = i + 0.05 * i * i;
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, x, j, 0, p));
            CHECK_NEAR(p[0], x, 1e-12);
            CHECK_NEAR(p[1], j, 1e-12);
            CHECK_NEAR(p[2], i == 2 && j == 3 ? 20.0 : 0.5 * j + 0.1 * i, 1e-9);
        }
    batten_design_free(design);
}

TEST(what_is_no_function_over_a_grid_is_refused)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{fit-grid: grid, as: function, periodic-u: yes}", "does not close"},
        {"{fit-grid: [disc, disc], as: function}", "this is not a grid over x and y"},
        {"{fit-grid: [grid, grid], as: function}", "y goes from 6 to 0 at line 8"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        char said[2000];
        batten_status status = make(rows[i].feature, said, sizeof said, &design);
        if (test_memory_failed(status, BATTEN_OK))
            status = make(rows[i].feature, said, sizeof said, &design);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i].says);
    }
}

TEST(help_says_how_a_grid_is_written)
{
    CHECK_CONTAINS(batten_feature_find("fit-grid")->manual, "separated by");
    CHECK_CONTAINS(batten_feature_find("interpolate-grid")->manual, "separated by");
}
