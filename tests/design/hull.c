#include "support/test.h"

#include <batten/design.h>
#include <locale.h>
#include <stdlib.h>

/* The design of a hull from a table of the shared data; two outputs. */
static batten_status open_hull(const char *table, const char *range, batten_design **out)
{
    char text[2000];
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\nparameters: {bound: 3 mm}\nfeatures:\n"
             "  offsets: {read: '%s', %s}\n"
             "  faired: {fair: offsets, within: =bound}\n"
             "  stations: {interpolate: faired, each: station, ends: natural}\n"
             "  hull: {skin: stations, within: 1 mm}\n"
             "outputs:\n  hull.step: hull\n  report.json: {check: hull, within: 6 mm}\n",
             table, range);
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    return batten_design_parse(text, strlen(text), &options, NULL, out);
}

TEST(a_hull_from_a_table_stays_within_its_bounds)
{
    static const struct {
        const char *table, *range;
    } rows[] = {{"hull_offsets/s60_offsets.csv", "x: [-12.2 m, 12.2 m], z: [0, 2.2 m]"},
                {"hull_offsets/px121_offsets.csv", "x: [5 m, 75 m], y: [0.1 m, 20 m]"}};
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        char *data = NULL;
        size_t size;
        CHECK_OK(open_hull(test_data(rows[i].table), rows[i].range, &design));
        CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
        const batten_feature_result *faired = batten_design_result(design, "faired");
        CHECK(faired->has_moves && faired->moved_count > 0);
        CHECK(faired->move_max <= 0.003 * (1 + 1e-12));
        CHECK(faired->fairing->after.energy <= faired->fairing->before.energy);
        const batten_feature_result *hull = batten_design_result(design, "hull");
        CHECK(hull->skin && hull->skin->error <= 0.001 && hull->has_error);
        CHECK(hull->skin->knot_count <= hull->skin->exact_knot_count);
        CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
        CHECK(strncmp(data, "ISO-10303-21;", 13) == 0);
        batten_release(data);
        CHECK_OK(batten_design_output(design, 1, NULL, NULL, &data, &size));
        CHECK_CONTAINS(data, "\"ok\": true");
        batten_release(data);
        batten_design_free(design);
    }
}

TEST(a_tighter_bound_keeps_what_is_above_it)
{
    if (test_cases(10) < 10)
        return;
    batten_design *design = NULL;
    CHECK_OK(open_hull(test_data("hull_offsets/px121_offsets.csv"),
                       "x: [5 m, 75 m], y: [0.1 m, 20 m]", &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    const batten_model *offsets = batten_design_result(design, "offsets")->value;
    CHECK_OK(batten_design_set(design, "parameters.bound", "1 mm", NULL));
    CHECK(batten_design_result(design, "offsets")->value == offsets);
    CHECK(batten_design_result(design, "faired") == NULL);
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    CHECK(batten_design_result(design, "faired")->move_max <= 0.001 * (1 + 1e-12));
    batten_design_free(design);
}

TEST(F5_a_locale_changes_no_byte)
{
    static const char text[] = "batten: 1\nfeatures:\n  a: {points: [[0.5, 0.25], [1.5 m, "
                               "0.75], [2, 0.1], [3, 0.2]]}\n"
                               "  c: {interpolate: a}\noutputs:\n  r.json: c\n";
    char *bytes[2] = {NULL, NULL};
    const char *const locales[] = {"C", "de_DE.UTF-8"};
    for (int i = 0; i < 2; i++) {
        batten_design *design = NULL;
        size_t size;
        if (!setlocale(LC_ALL, locales[i])) {
            batten_release(bytes[0]);
            SKIP("the locale %s is absent", locales[i]);
        }
        batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &design);
        if (status == BATTEN_OK)
            status = batten_design_output(design, 0, NULL, NULL, &bytes[i], &size);
        batten_design_free(design);
        setlocale(LC_ALL, "C");
        CHECK(status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY);
    }
    if (bytes[0] && bytes[1])
        CHECK_TEXT(bytes[0], bytes[1]);
    batten_release(bytes[0]);
    batten_release(bytes[1]);
}

TEST(F8_names_of_files_may_hold_any_character)
{
    static const char *const names[] = {"a b.csv", "it's.csv", "-x.csv", "\xC3\xA9\xC3\xA9.csv",
                                        "a#b.csv"};
    for (int i = 0; i < COUNT(names); i++) {
        char text[400];
        FILE *file = fopen(test_scratch(names[i]), "w");
        CHECK(file != NULL);
        fputs("x_m,z_m,half_breadth_m\n0,0,1\n0,1,2\n1,0,1\n1,1,2\n", file);
        fclose(file);
        snprintf(text, sizeof text,
                 "batten: 1\nfeatures:\n  a: {read: \"%s\"}\noutputs: {\"%s\": a}\n", names[i],
                 names[i]);
        batten_design_options options = batten_design_defaults();
        options.file_name = test_scratch("names.yaml");
        batten_design *design = NULL;
        CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, &design));
        CHECK_TEXT(batten_design_output_name(design, 0), names[i]);
        CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
        batten_design_free(design);
    }
}

TEST(F7_outputs_whose_ending_says_nothing_are_refused)
{
    static const struct {
        const char *output, *says;
    } rows[] = {{"a.xyzw: p", "names no format"},
                {"a: p", "names no format"},
                {"a.txt: {picture: p}", "must end in .png, .svg or .pdf"},
                {"a.txt: {lines-plan: p}", "must end in .pdf, .svg, .png or .dxf"},
                {"a.svg: {picture: p, shading: zebra}", "shaded pictures are written as .png"},
                {"a.png: {picture: p, shading: zebra}", "'shading' needs a surface"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[300];
        snprintf(text, sizeof text,
                 "batten: 1\nfeatures:\n  p: {points: [[0, 0], [1, 1]]}\noutputs:\n  %s\n",
                 rows[i].output);
        batten_design *design = NULL;
        char *data = NULL;
        size_t size;
        CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
        batten_status status = batten_design_output(design, 0, NULL, NULL, &data, &size);
        if (test_memory_failed(status, BATTEN_OK))
            status = batten_design_output(design, 0, NULL, NULL, &data, &size);
        CHECK(status == BATTEN_UNSUPPORTED || status == BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(rows[i].says);
        CHECK(data == NULL);
        batten_design_free(design);
    }
}

/* A design that reads a table, both in the scratch folder under that name. */
static batten_design *open_beside(const char *name, const char *table, const char *text)
{
    char path[64];
    batten_design_options options = batten_design_defaults();
    batten_design *design = NULL;
    snprintf(path, sizeof path, "%s.csv", name);
    FILE *file = fopen(test_scratch(path), "w");
    CHECK(file != NULL);
    fputs(table, file);
    fclose(file);
    snprintf(path, sizeof path, "%s.yaml", name);
    options.file_name = test_scratch(path);
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, &design));
    return design;
}

/* A box: no smooth curve through its three corners stays in it. */
TEST(curves_of_a_table_that_go_far_beyond_their_points_are_noted)
{
    static const char text[] = "batten: 1\nfeatures:\n  table: {read: box.csv}\n"
                               "  stations: {interpolate: table}\n"
                               "  ducks: {points: [[0, 0], [5 m, 0], [5 m, 2.5 m]]}\n"
                               "  free: {interpolate: ducks}\n";
    static const char *const words[] = {"2 of the curves go more than 3 %",
                                        "'cornered-spline'"};
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    batten_design *design =
        open_beside("box",
                    "x_m,z_m,half_breadth_m\n0,0,0\n0,0,5\n0,2.5,5\n1,0,0\n1,0,5\n1,2.5,5\n"
                    "2,0,1\n2,1,1.1\n2,2,1.3\n",
                    text);
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, notes));
    for (int k = 0; k < COUNT(words); k++) {
        bool found = batten_notes_dropped(notes) > 0;
        for (int i = 0; i < batten_notes_count(notes); i++)
            found |= strstr(batten_notes_at(notes, i)->text, words[k]) != NULL;
        CHECK(found);
    }
    int count = 0; /* points that are no table may have what they like between them */
    for (int i = 0; i < batten_notes_count(notes); i++)
        count += strstr(batten_notes_at(notes, i)->text, "beyond their points") != NULL;
    CHECK(count == 1 || batten_notes_dropped(notes) > 0);
    batten_notes_free(notes);
    batten_design_free(design);
}

TEST(a_skin_ends_in_a_station_of_one_point)
{
    static const char text[] = "batten: 1\nfeatures:\n  table: {read: stem.csv}\n"
                               "  stations: {interpolate: table}\n"
                               "  faired: {fair: stations, within: 1 mm}\n"
                               "  hull: {skin: faired}\noutputs:\n"
                               "  r.txt: {check: [hull, stations], within: 1 um}\n";
    batten_design *design =
        open_beside("stem",
                    "x_m,z_m,half_breadth_m\n0,0,0\n0,1,1\n0,2,1.2\n2,0.5,0\n2,1,0.5\n2,2,0.8\n"
                    "3,1,0\n3,2,0.3\n3.5,2,0\n",
                    text);
    char *report = NULL;
    size_t size;
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &report, &size));
    const batten_surface *hull =
        batten_model_object(batten_design_result(design, "hull")->value, 0)->surface;
    const batten_interval u = batten_surface_domain(hull, BATTEN_U);
    const double end = batten_surface_domain(hull, BATTEN_V).b;
    for (int i = 0; i <= 10; i++) {
        double point[3];
        CHECK_OK(batten_surface_evaluate(hull, u.a + (u.b - u.a) * i / 10, end, 0, point));
        CHECK_NEAR(point[0], 3.5, 1e-12);
        CHECK_NEAR(point[1], 0, 1e-12);
        CHECK_NEAR(point[2], 2, 1e-12);
    }
    batten_release(report);
    batten_design_free(design);
}
