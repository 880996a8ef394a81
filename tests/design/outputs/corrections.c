#include "support/test.h"

#include <batten/design.h>
#include <math.h>
#include <stdlib.h>

/* The example's sharpie lofted, a row of points faired, and lists of what both changed. */
static void open_boat(batten_design **out)
{
    char text[1000];
    snprintf(text, sizeof text,
             "batten: 1\nunits: in\ntolerance: 0.005 in\nfeatures:\n  table: {read: '%s'}\n"
             "  hull: {loft: table, within: 0.125 in, knuckles: chine}\n"
             "  ducks: {points: [[0, 0], [1, 0.1], [2, 0], [3, 0.1], [4, 0], [5, 0.1]]}\n"
             "  fair: {fair: ducks, within: 0.1 in}\n"
             "  smooth: {fair: table, within: 0.125 in}\noutputs:\n"
             "  hull.txt: {corrections: hull}\n  hull.csv: {corrections: hull}\n"
             "  hull.json: {corrections: hull}\n  ducks.csv: {corrections: fair}\n"
             "  table.txt: {corrections: table}\n  smooth.csv: {corrections: smooth}\n",
             test_source("examples/sharpie/offsets.csv"));
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, out));
}

static char *take_output(batten_design *design, int output)
{
    char *data = NULL;
    size_t size;
    CHECK_OK(batten_design_output(design, output, NULL, NULL, &data, &size));
    return data;
}

static int count_rows(const char *text)
{
    int rows = 0;
    for (; *text; text++)
        rows += *text == '\n';
    return rows;
}

TEST(corrections_of_a_lofting_are_listed_as_text_csv_and_json)
{
    batten_design *design = NULL;
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    open_boat(&design);
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    const batten_loft_report *loft = batten_design_result(design, "hull")->loft;
    const batten_loft_correction *first = loft->corrections;
    char *text = take_output(design, 0), *csv = take_output(design, 1),
         *json = take_output(design, 2), begin[200];
    const batten_station_label label = batten_offset_table_label(loft->faired, first->station);
    CHECK(loft->correction_count > 0 && first->distance == loft->max_move);
    CHECK_INT(count_rows(text), loft->correction_count + 1); /* and what the words mean */
    CHECK_INT(count_rows(csv), loft->correction_count + 1);  /* and the names of the columns */
    CHECK_INT(count_rows(json), loft->correction_count + 2); /* and the brackets */
    snprintf(begin, sizeof begin, "%s, ", label.text);
    CHECK(strncmp(text, begin, strlen(begin)) == 0);
    CHECK_CONTAINS(text, " in off, noise");
    snprintf(begin, sizeof begin,
             "place,point,line,x,y,z,to_x,to_y,to_z,distance,reason\n%s,%d,", label.text,
             first->index + 1);
    CHECK(strncmp(csv, begin, strlen(begin)) == 0);
    CHECK_CONTAINS(json, "\"line\": \"sheer\", \"from\": [");
    batten_release(text);
    batten_release(csv);
    batten_release(json);
    batten_design_free(design);
}

TEST(corrections_of_fairing_are_its_moves_the_farthest_first)
{
    batten_design *design = NULL;
    open_boat(&design);
    CHECK_OK(batten_design_evaluate(design, "fair", NULL, NULL));
    const batten_fair_report *fair = batten_design_result(design, "fair")->fairing;
    char *csv = take_output(design, 3), begin[200];
    CHECK_INT(count_rows(csv), fair->move_count + fair->suspect_count + 1);
    snprintf(begin, sizeof begin, "reason\ncurve 1,%d,,", fair->worst_index + 1);
    CHECK_CONTAINS(csv, begin);
    batten_release(csv);
    batten_design_free(design);
}

/* As those of a lofting: each with its station, and with its line where the point is of one. */
TEST(corrections_of_a_faired_table_name_its_stations_and_lines)
{
    batten_design *design = NULL;
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    open_boat(&design);
    CHECK_OK(batten_design_evaluate(design, "smooth", NULL, NULL));
    const batten_fair_report *fair = batten_design_result(design, "smooth")->fairing;
    char *csv = take_output(design, 5);
    CHECK(fair->move_count > 0);
    CHECK_INT(count_rows(csv), fair->move_count + fair->suspect_count + 1);
    for (char *row = strchr(csv, '\n') + 1; *row; row = strchr(row, '\n') + 1) {
        CHECK(strncmp(row, "station '", 9) == 0);
        const char *line = strchr(strchr(row, ',') + 1, ',') + 1;
        CHECK(strncmp(line, "sheer,", 6) == 0 || strncmp(line, "chine,", 6) == 0 ||
              *line == ',');
    }
    CHECK_CONTAINS(csv, ",chine,");
    CHECK_CONTAINS(csv, ",sheer,");
    batten_release(csv);
    batten_design_free(design);
}

TEST(what_was_neither_lofted_nor_faired_has_no_corrections)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size;
    open_boat(&design);
    CHECK_OK(batten_design_evaluate(design, "table", NULL, NULL));
    CHECK_STATUS(batten_design_output(design, 4, NULL, NULL, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("'table' is neither lofted nor faired");
    batten_design_free(design);
}

TEST(points_that_fairing_leaves_at_their_bound_are_called_so)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  ducks: {points: [[0, 0], [1, 0.2], [2, 0.32], [3, 0.33], [4, 0.2], [5, 0]]}\n"
        "  fair: {fair: ducks, within: 0.01}\noutputs:\n  list.csv: {corrections: fair}\n";
    batten_design *design = NULL;
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    const batten_fair_report *fair = batten_design_result(design, "fair")->fairing;
    int at_bound = 0, rows = 0;
    for (int k = 0; k < fair->move_count; k++) {
        const batten_fair_move *m = fair->moves + k;
        at_bound += hypot(m->to[0] - m->from[0], m->to[1] - m->from[1]) > 0.0099999;
    }
    char *csv = take_output(design, 0);
    for (const char *p = csv; (p = strstr(p, ",bound\n")); p++)
        rows++;
    CHECK(at_bound > 0 && at_bound < fair->move_count);
    CHECK_INT(rows, at_bound);
    CHECK_CONTAINS(csv, ",noise\n");
    batten_release(csv);
    batten_design_free(design);
}

TEST(control_points_that_fairing_moved_are_listed_as_such)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  net: {points: [[0, 0], [1, 1], [2, 1.6], [3, 2.4], [4, 2.3], [5, 2.4], [6, 1.9], [7, 0]]}\n"
        "  curve: {b-spline: net}\n"
        "  fair: {fair: curve, within: 0.02, method: farin-sapidis}\noutputs:\n"
        "  list.csv: {corrections: fair}\n";
    batten_design *design = NULL;
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    char *csv = take_output(design, 0);
    CHECK_CONTAINS(csv, "reason\ncontrol points of curve 1,");
    CHECK(strstr(csv, ",bound\n") == NULL);
    batten_release(csv);
    batten_design_free(design);
}

/* The column 'distance' never rises, and equal distances come in the order of the points. */
TEST(corrections_are_sorted_by_their_distance)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  ducks: {points: [[0, 0], [1, 0.2], [2, 0.32], [3, 0.33], [4, 0.2], [5, 0], [6, -0.3]]}\n"
        "  fair: {fair: ducks, within: 0.01}\noutputs:\n  list.csv: {corrections: fair}\n";
    batten_design *design = NULL;
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    char *csv = take_output(design, 0);
    double before = INFINITY;
    int rows = 0, index_before = 0;
    for (char *line = strchr(csv, '\n') + 1; *line; line = strchr(line, '\n') + 1, rows++) {
        const int index = atoi(strchr(line, ',') + 1);
        char *at = line;
        for (int comma = 0; comma < 9; comma++)
            at = strchr(at, ',') + 1;
        const double distance = strtod(at, NULL);
        CHECK(distance < before || (distance == before && index > index_before));
        before = distance;
        index_before = index;
    }
    CHECK(rows >= 3);
    batten_release(csv);
    batten_design_free(design);
}
