/* The report of hydrostatics. */
#include "support/test.h"

#include <batten/design.h>
#include <stdlib.h>
#include <string.h>

/* A prism 20 long whose section is a triangle, 10 wide at 4 above its edge. */
static const char prism[] = "  low: {line: [[0, 0, 0], [20, 0, 0]]}\n"
                            "  high: {line: [[0, 5, 4], [20, 5, 4]]}\n"
                            "  half: {ruled: [low, high]}\n"
                            "  deep: {move: half, by: [0, 0, -1]}\n"
                            "  both: {mirror: half, plane: centre}\n"
                            "  sheer: {line: [[0, 5, 4], [20, 6.25, 5]]}\n"
                            "  rising: {ruled: [low, sheer]}\n"
                            "  sunk: {move: half, by: [0, 0, -9]}\n"
                            "  fore: {line: [[0, 5, 4], [20, 0, 4]]}\n"
                            "  narrowing: {ruled: [low, fore]}\n"
                            "  aft: {line: [[0, 0, 4], [20, 5, 4]]}\n"
                            "  widening: {ruled: [low, aft]}\n";

static batten_status report(const char *output, batten_notes *notes, char **data)
{
    char text[2000];
    batten_design *design = NULL;
    size_t size;
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%soutputs:\n  %s\n", prism, output);
    batten_status status = batten_design_parse(text, strlen(text), NULL, notes, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, notes, data, &size);
    batten_design_free(design);
    return status;
}

static double number(const char *text, const char *key)
{
    const char *at = strstr(text, key);
    CHECK(at != NULL);
    return strtod(at + strlen(key), NULL);
}

TEST(a_prism_has_the_values_of_its_closed_form)
{
    static const char *const inputs[] = {"half", "both"};
    const double t = 3.322, b = 2.5 * t;
    const struct {
        const char *key;
        double value;
    } rows[] = {
        {"\"VOL\": ", 20 * b * t / 2},
        {"\"DISP\": ", 1.025 * 20 * b * t / 2},
        {"\"LWL\": ", 20},
        {"\"BWL\": ", b},
        {"\"AW\": ", 20 * b},
        {"\"XCB\": ", 10},
        {"\"KB\": ", t * 2 / 3},
        {"\"XCF\": ", 10},
        {"\"BMT\": ", b * b / (6 * t)},
        {"\"KMT\": ", t * 2 / 3 + b * b / (6 * t)},
        {"\"CB\": ", 0.5},
        {"\"CWP\": ", 1},
        {"\"CVP\": ", 0.5},
        {"\"AX\": ", b * t / 2},
        {"\"CX\": ", 0.5},
        {"\"CP\": ", 1},
        {"\"TPC\": ", 1.025 * b * 0.2},
        {"\"T\": ", t},
        {"\"IT\": ", 20 * b * b * b / 12},
        {"\"IL\": ", b * 8000 / 12},
        {"\"BML\": ", 8000 / (12 * 10 * t)},
        {"\"KML\": ", t * 2 / 3 + 8000 / (12 * 10 * t)},
        {"\"S\": ", 40 * hypot(t, b / 2)},
        {"\"MCT\": ", 1.025 * b * 8000 / 12 / 100 / 20},
    };
    for (int i = 0; i < COUNT(inputs); i++) {
        char output[200], *data = NULL;
        snprintf(output, sizeof output, "a.json: {hydrostatics: %s, draughts: 3.322}",
                 inputs[i]);
        CHECK_OK(report(output, NULL, &data));
        for (int k = 0; k < COUNT(rows); k++)
            CHECK_NEAR(number(data, rows[k].key), rows[k].value, 1e-8 * rows[k].value);
        CHECK_NEAR(number(data, "\"YCB\": "), 0, 0);
        batten_release(data);
    }
}

TEST(text_table_and_json_say_the_same)
{
    char *text = NULL, *csv = NULL, *json = NULL;
    CHECK_OK(report("a.txt: {hydrostatics: half, draughts: [2, 3]}", NULL, &text));
    CHECK_OK(report("a.csv: {hydrostatics: half, draughts: [2, 3]}", NULL, &csv));
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: [2, 3]}", NULL, &json));
    CHECK_CONTAINS(text, "VOL  m3              100         225\n");
    CHECK_CONTAINS(text, "closed across from the edge at x 0 to 20, z 4 to 4: 200 m2");
    CHECK_CONTAINS(csv, "T,VOL,DISP,LWL,");
    CHECK_CONTAINS(csv, "\nm,m3,t,m,");
    CHECK_NEAR(number(strstr(csv, "\n3,"), "\n3,"), 225, 1e-9);
    CHECK_NEAR(number(strstr(json, "\"T\": 3"), "\"VOL\": "), 225, 1e-9);
    batten_release(text);
    batten_release(csv);
    batten_release(json);
}

/* Half the length between perpendiculars halves no more than what it divides. */
TEST(a_length_between_perpendiculars_takes_the_place_of_the_waterline_s)
{
    static const struct {
        const char *key;
        double value;
    } rows[] = {{"\"L\": ", 10},         {"\"LWL\": ", 20},
                {"\"CB\": ", 1},         {"\"CWP\": ", 2},
                {"\"CVP\": ", 0.5},      {"\"MCT\": ", 1.025 * 5 * 8000 / 12 / 1000},
                {"\"density\": ", 1.025}};
    char *json = NULL, *text = NULL;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 2, length: 10}", NULL, &json));
    for (int k = 0; k < COUNT(rows); k++)
        CHECK_NEAR(number(json, rows[k].key), rows[k].value, 1e-8 * rows[k].value);
    CHECK_OK(report("a.txt: {hydrostatics: half, draughts: 2, length: 10}", NULL, &text));
    CHECK_CONTAINS(text, "L in the coefficients and in MCT is 10 m\n");
    batten_release(json);
    batten_release(text);
}

TEST(seven_draughts_stand_in_two_blocks_with_their_conventions)
{
    char *text = NULL;
    CHECK_OK(report("a.txt: {hydrostatics: half, draughts: [0.5, 1, 1.5, 2, 2.5, 3, 3.5]}",
                    NULL, &text));
    CHECK_CONTAINS(text,
                   "water of 1.025 t/m3\ntrim 0 deg (by the stern, towards lower x, above "
                   "0), heel 0 deg (to starboard above 0)\n"
                   "L in the coefficients and in MCT is LWL\n");
    char first[200], last[100];
    snprintf(first, sizeof first, "%-12s %11g %11g %11g %11g %11g %11g\n", "T    m", 0.5, 1.0,
             1.5, 2.0, 2.5, 3.0);
    snprintf(last, sizeof last, "\n\n%-11s  %11g\n%-11s  %11g\n", "T    m", 3.5, "VOL  m3",
             306.25);
    CHECK_CONTAINS(text, first);
    CHECK_CONTAINS(text, last);
    CHECK_CONTAINS(text, "\nKML  longitudinal metacentre above the baseline, KB + BML\n");
    CHECK(!strstr(text, "Afloat"));
    batten_release(text);
}

/* The keel of the prism is at 0: at a draught below it nothing is wet. */
TEST(what_a_dry_hull_has_not_is_a_dash_nothing_or_null)
{
    char *text = NULL, *csv = NULL, *json = NULL;
    CHECK_OK(report("a.txt: {hydrostatics: half, draughts: -1}", NULL, &text));
    CHECK_OK(report("a.csv: {hydrostatics: half, draughts: -1}", NULL, &csv));
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: -1}", NULL, &json));
    CHECK_CONTAINS(text, "VOL  m3                0\n");
    CHECK_CONTAINS(text, "KB   m                 -\n");
    CHECK_CONTAINS(text, "CVP  1                 -\n");
    CHECK_CONTAINS(csv, "\n-1,0,0,0,0,0,0,,,,,0,0,,,,,0,,,,,0,,\n");
    CHECK_CONTAINS(
        json,
        "\"XCB\": null, \"YCB\": null, \"KB\": null, \"XCF\": null, \"IT\": 0, "
        "\"IL\": 0, \"BMT\": null, \"BML\": null, \"KMT\": null, \"KML\": null, "
        "\"TPC\": 0, \"MCT\": null, \"CB\": null, \"CWP\": null, \"CVP\": null, \"AX\": 0, "
        "\"CX\": null, \"CP\": null}");
    batten_release(text);
    batten_release(csv);
    batten_release(json);
}

/* The cells of a row of arms, as the text rounds them. */
static void arm_cells(const char *json, const char *heel, char row[100])
{
    static const char *const keys[] = {
        "\"GZ\": ", "\"KN\": ", "\"T\": ", "\"trim\": ", "\"freeboard\": "};
    char key[30];
    snprintf(key, sizeof key, "\"heel\": %s,", heel);
    const char *at = strstr(json, key);
    CHECK(at != NULL);
    int length = snprintf(row, 100, "\n%-12s", heel);
    for (int k = 0; k < COUNT(keys); k++)
        length +=
            snprintf(row + length, (size_t)(100 - length), " %11.6g", number(at, keys[k]));
    snprintf(row + length, (size_t)(100 - length), "\n");
}

/* Off its middle the mass trims the hull; all is in the text that is in JSON. */
TEST(how_a_mass_rests_is_in_the_text_as_in_json)
{
    static const char *const heels[] = {"5", "10"};
    char *text = NULL, *json = NULL, row[100], trim[40];
    CHECK_OK(report("a.txt: {hydrostatics: half, draughts: 2, mass: 205, gravity: [9.9, 0, "
                    "1.5], heels: [5 deg, 10 deg]}",
                    NULL, &text));
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 2, mass: 205, gravity: [9.9, 0, "
                    "1.5], heels: [5 deg, 10 deg]}",
                    NULL, &json));
    for (int k = 0; k < COUNT(heels); k++) {
        arm_cells(strstr(json, "\"arms\""), heels[k], row);
        CHECK_CONTAINS(text, row);
    }
    const char *afloat = strstr(json, "\"afloat\"");
    CHECK(number(afloat, "\"trim\": ") > 0.01); /* the stern, where x is lower, is down */
    snprintf(trim, sizeof trim, "at x = 0, trim %.6g deg, ", number(afloat, "\"trim\": "));
    CHECK_CONTAINS(text, trim);
    CHECK_CONTAINS(text, "Afloat with 205 t, their centre at (9.9, 0, 1.5) m\n");
    CHECK_CONTAINS(text, " m: stable\n");
    CHECK_CONTAINS(afloat, "\"stable\": true}");
    batten_release(text);
    batten_release(json);
}

TEST(draughts_are_round_ones_up_to_the_deck_where_none_are_given)
{
    char *data = NULL;
    CHECK_OK(report("a.csv: {hydrostatics: half}", NULL, &data));
    CHECK_CONTAINS(data, "\n0.5,");
    CHECK_CONTAINS(data, "\n4,");
    CHECK(!strstr(data, "\n4.5,"));
    batten_release(data);
}

TEST(a_mass_floats_and_rights_itself)
{
    char *data = NULL;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 2, mass: 205, "
                    "gravity: [10, 0, 1.5], heels: [0 deg, 10 deg]}",
                    NULL, &data));
    const char *afloat = strstr(data, "\"afloat\"");
    CHECK_NEAR(number(afloat, "\"draught\": "), sqrt(8), 1e-8);
    CHECK_NEAR(number(afloat, "\"trim\": "), 0, 1e-8);
    const double gm = sqrt(8) * 2 / 3 + 6.25 * 8 / (6 * sqrt(8)) - 1.5;
    CHECK_NEAR(number(afloat, "\"GMT\": "), gm, 1e-8);
    const char *arm = strstr(data, "\"heel\": 10,");
    const double gz = number(arm, "\"GZ\": ");
    CHECK(gz > gm * sin(10 * 3.14159265358979 / 180)); /* the sides flare */
    CHECK_NEAR(number(arm, "\"KN\": "), gz + 1.5 * sin(10 * 3.14159265358979 / 180), 1e-9);
    batten_release(data);
}

/* With its mass above the metacentre it capsizes; where it rests is upright all the same. */
TEST(a_hull_that_is_top_heavy_rests_upright_and_is_not_stable)
{
    char *data = NULL;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 2, mass: 205, "
                    "gravity: [10, 0, 5.5], heels: 5 deg}",
                    NULL, &data));
    const char *afloat = strstr(data, "\"afloat\"");
    CHECK_NEAR(number(afloat, "\"draught\": "), sqrt(8), 1e-8);
    CHECK_NEAR(number(afloat, "\"heel\": "), 0, 0);
    CHECK_NEAR(number(afloat, "\"GMT\": "), sqrt(8) * 2 / 3 + 6.25 * 8 / (6 * sqrt(8)) - 5.5,
               1e-8);
    CHECK_CONTAINS(afloat, "\"stable\": false}");
    CHECK(number(afloat, "\"GZ\": ") < 0);
    batten_release(data);
}

/* What is asked for is in every form. */
TEST(arms_and_lids_are_in_tables_and_json_too)
{
    char *csv = NULL, *json = NULL;
    CHECK_OK(report("a.csv: {hydrostatics: half, draughts: 2, mass: 205, "
                    "gravity: [10, 0, 1.5], heels: 10 deg}",
                    NULL, &csv));
    const char *arms = strstr(csv, "\nheel,GZ,KN,T,trim,freeboard\ndeg,m,m,m,deg,m\n0,0,,");
    CHECK(arms != NULL);
    CHECK(number(arms, "\n10,") > 0.5);
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: 2, mass: 205, "
                    "gravity: [10, 0, 1.5], heels: 10 deg}",
                    NULL, &json));
    CHECK_CONTAINS(json, "\"lids\": [\n    {\"x\": [0, 0], \"z\": [0, 4], \"area\": 20");
    CHECK_CONTAINS(json, "\"mass\": 205, \"x\": 10, \"y\": 0, \"z\": 1.5");
    batten_release(csv);
    batten_release(json);
}

TEST(what_closes_the_hull_and_a_deck_under_water_are_remarked_upon)
{
    batten_notes *notes = NULL;
    char *data = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(report("a.txt: {hydrostatics: half, draughts: 4.2}", notes, &data));
    int lids = 0, decks = 0;
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const char *text = batten_notes_at(notes, i)->text;
        lids += strstr(text, "the hull is closed across from the edge") != NULL;
        decks +=
            strstr(text, "the edge of the deck is under water: by up to 0.2, at (") != NULL;
    }
    if (!batten_notes_dropped(notes)) { /* else memory failed, and notes may also be doubled */
        CHECK(lids >= 3 && lids % 3 == 0);
        CHECK(decks >= 1);
    }
    batten_release(data);
    batten_notes_free(notes);
}

TEST(what_cannot_float_is_refused_with_its_reason)
{
    static const struct {
        const char *output, *message;
    } rows[] = {
        {"a.txt: {hydrostatics: half, density: 0}", "density is 0"},
        {"a.txt: {hydrostatics: half, mass: 3}", "'mass' and 'gravity' belong together"},
        {"a.txt: {hydrostatics: half, gravity: [1, 0, 0]}",
         "'mass' and 'gravity' belong together"},
        {"a.txt: {hydrostatics: half, mass: -3, gravity: [1, 0, 0]}", "mass is -3"},
        {"a.txt: {hydrostatics: half, mass: 3000, gravity: [10, 0, 1]}", "it sinks"},
        {"a.txt: {hydrostatics: half, heels: 3 deg}", "'heel' is that of the table"},
        {"a.txt: {hydrostatics: half, length: -1}", "between perpendiculars is -1"},
        {"a.txt: {hydrostatics: half, draughts: 1, whole: yes}",
         "surface 1 of a whole hull is not closed"},
        {"a.txt: {hydrostatics: low}", "low"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char *data = NULL;
        batten_status status = report(rows[i].output, NULL, &data);
        if (test_memory_failed(status, BATTEN_BAD_ARGUMENT))
            status = report(rows[i].output, NULL, &data);
        CHECK(status != BATTEN_OK && !data);
        CHECK_MESSAGE(rows[i].message);
    }
}

/* Has a report a note with these words? True also where notes were dropped. */
static bool is_noted(const char *output, const char *words)
{
    batten_notes *notes = NULL;
    char *data = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(report(output, notes, &data));
    bool found = batten_notes_dropped(notes) > 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        found |= strstr(batten_notes_at(notes, i)->text, words) != NULL;
    batten_release(data);
    batten_notes_free(notes);
    return found;
}

TEST(a_hull_that_reaches_below_the_baseline_is_remarked_upon)
{
    static const char words[] = "the hull reaches to z = -1, below the baseline z = 0";
    CHECK(is_noted("a.txt: {hydrostatics: deep, draughts: 1}", words));
    if (test_cases(10) >= 10)
        CHECK(!is_noted("a.txt: {hydrostatics: half, draughts: 1}", "below the baseline"));
}

/* Triangles whose breadth falls from one end to the other: half of them is the mean, at a third of the length. */
TEST(the_largest_section_may_be_at_either_end)
{
    static const char *const hulls[] = {"narrowing", "widening"};
    static const char *const stations[] = {"", ", stations: [10]"};
    for (int i = 0; i < 4; i++) {
        char output[100], *data = NULL;
        snprintf(output, sizeof output, "a.json: {hydrostatics: %s, draughts: 2%s}",
                 hulls[i % 2], stations[i / 2]);
        CHECK_OK(report(output, NULL, &data));
        CHECK_NEAR(number(data, "\"AX\": "), 5, 1e-4 * 5);
        CHECK_NEAR(number(data, "\"CX\": "), 0.5, 1e-4);
        CHECK_NEAR(number(data, "\"CP\": "), 0.5, 1e-4);
        CHECK_NEAR(number(data, "\"XCB\": "), i % 2 ? 40 / 3. : 20 / 3., 1e-9);
        batten_release(data);
    }
}

/* Of the triangle 2.5 T wide: at its ends just inside, beyond them nothing. */
TEST(areas_of_sections_are_at_given_places_or_from_end_to_end)
{
    char *text = NULL, *json = NULL, *csv = NULL;
    CHECK_OK(report("a.json: {hydrostatics: half, draughts: [2, 4], stations: [-1, 0, 7, 20]}",
                    NULL, &json));
    CHECK_CONTAINS(json,
                   "\"sections\": {\n    \"x\": [-1, 0, 7, 20],\n    \"A\": [\n      [0, ");
    const char *at = strstr(json, "\"A\": [");
    CHECK_NEAR(number(at, "[\n      [0, "), 5, 1e-7);
    CHECK_NEAR(number(at, "],\n      [0, "), 20, 1e-7);
    CHECK_OK(report("a.csv: {hydrostatics: half, draughts: [2, 4]}", NULL, &csv));
    CHECK_CONTAINS(csv, "\nx,A at T = 2,A at T = 4\nm,m2,m2\n0,");
    CHECK_CONTAINS(csv, "\n1,");
    CHECK_CONTAINS(csv, "\n20,");
    CHECK_OK(report("a.txt: {hydrostatics: half, draughts: [2, 4], heel: 20 deg, trim: 1 deg}",
                    NULL, &text));
    CHECK_CONTAINS(text, "areas of sections, m2, at x by draughts\n");
    batten_release(text);
    batten_release(json);
    batten_release(csv);
}

/* The deck is under water from its lowest point on, whatever rises above it. */
TEST(a_deck_that_rises_is_under_water_where_it_is_lowest)
{
    static const char words[] = "the edge of the deck is under water: by up to 0.2, at (";
    CHECK(is_noted("a.txt: {hydrostatics: rising, draughts: 4.2}", words));
    if (test_cases(10) >= 10)
        CHECK(!is_noted("a.txt: {hydrostatics: rising, draughts: 3.9}", "is under water"));
}

TEST(a_hull_below_the_baseline_has_no_draughts_of_its_own)
{
    char *data = NULL;
    CHECK_STATUS(report("a.txt: {hydrostatics: sunk}", NULL, &data), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the hull reaches from z = -9 to -5: no draught above the baseline z = 0");
    CHECK(!data);
}
