#include "design/outputs/hydrostatics.h"

#include "support/test.h"

#include <math.h>

/* Forms of a report that is made by hand: each figure stands in its place, with its unit. */

/* Column c of draught i has the value 100 i + c, but for one that has none. */
static void fill_rows(int count, bat_hydro_row *rows)
{
    for (int i = 0; i < count; i++)
        for (int c = 0; c < BAT_HYDRO_COLUMNS; c++)
            rows[i].values[c] = c == BAT_HYDRO_CVP ? (double)NAN : 100 * i + c;
}

/* At angles whose degrees are round: 2 by the stern, 4 to starboard. */
static const batten_balance rest = {
    .flotation = {.draught = 1.25, .trim = 2 * BAT_PI / 180, .heel = 4 * BAT_PI / 180},
    .metacentric = {0.5, 40},
    .stable = true};

static const batten_hull_lid lids[] = {
    {.edge = {{1, 0, 7}, {2, 0, 8}}, .area = 3},
    {.edge = {{4, 0, 9}, {5, 0, 10}}, .area = 6},
};

static bat_hydro_arm arms[] = {{10, 0.5, 0.75, 1.5, 3, -0.25}, {20, NAN, NAN, NAN, NAN, NAN}};

/* Areas of two sections at each of up to eight draughts. */
static double places[] = {3, 4.5};
static double areas[] = {0.5,  1.5,  10.5, 11.5, 20.5, 21.5, 30.5, 31.5,
                         40.5, 41.5, 50.5, 51.5, 60.5, 61.5, 70.5, 71.5};

static bat_hydro_report report_of(int count, bat_hydro_row *rows)
{
    fill_rows(count, rows);
    return (bat_hydro_report){.unit = "ft",
                              .density = 1.025,
                              .trim = 0.5,
                              .heel = 6,
                              .count = count,
                              .rows = rows,
                              .place_count = COUNT(places),
                              .places = places,
                              .areas = areas,
                              .lid_count = COUNT(lids),
                              .lids = lids};
}

static void load(bat_hydro_report *report)
{
    report->length = 12.5;
    report->mass = 80;
    report->gravity = (batten_vec3){4, 0.25, 1.5};
    report->rest = rest;
    report->arm_count = COUNT(arms);
    report->arms = arms;
}

static batten_status try_form(const bat_hydro_report *report,
                              void (*write)(const bat_hydro_report *report, batten_text *out),
                              char **data)
{
    batten_text text = BATTEN_TEXT;
    size_t size;
    write(report, &text);
    const batten_status status = batten_text_take(&text, data, &size);
    batten_text_free(&text);
    return status;
}

static char *write_report(const bat_hydro_report *report,
                          void (*write)(const bat_hydro_report *report, batten_text *out))
{
    char *data = NULL;
    CHECK_OK(try_form(report, write, &data));
    return data;
}

static const char conventions[] =
    "x along the ship, y to port, z up from the baseline; moulded, water of 1.025 t/m3\n"
    "trim 0.5 deg (by the stern, towards lower x, above 0), heel 6 deg (to starboard above 0)\n"
    "L in the coefficients and in MCT is LWL\n"
    "closed across from the edge at x 1 to 2, z 7 to 8: 3 ft2, which S does not count\n"
    "closed across from the edge at x 4 to 5, z 9 to 10: 6 ft2, which S does not count\n\n"
    "T    ft                0         100         200         300         400         500\n"
    "VOL  ft3               1         101         201         301         401         501\n"
    "DISP t                 2 ";

static const char end_of_text[] =
    "\nCVP  vertical prismatic coefficient, VOL / (AW T)\n"
    "AX   area of the largest section across x\n"
    "CX   coefficient of this section, AX / (BWL T)\n"
    "CP   prismatic coefficient, VOL / (L AX)\n\n"
    "areas of sections, ft2, at x by draughts\n"
    "x                      0         100         200         300         400         500\n"
    "3                    0.5        10.5        20.5        30.5        40.5        50.5\n"
    "4.5                  1.5        11.5        21.5        31.5        41.5        51.5\n\n"
    "areas of sections, ft2, at x by draughts\n"
    "x                    600         700\n"
    "3                   60.5        70.5\n"
    "4.5                 61.5        71.5\n\n";

TEST(a_text_has_its_conventions_then_blocks_of_six_draughts_then_what_the_symbols_mean)
{
    bat_hydro_row rows[8];
    bat_hydro_report report = report_of(8, rows);
    char *text = write_report(&report, bat_hydro_as_text);
    CHECK(strncmp(text, conventions, strlen(conventions)) == 0);
    CHECK_CONTAINS(text, "\nMCT  t m/cm           18         118         218 ");
    CHECK_CONTAINS(text, "\nCVP  1                 -           -           -           -"
                         "           -           -\nAX   ft2 ");
    CHECK_CONTAINS(text, "\nCP   1                24         124         224         324"
                         "         424         524\n\n"
                         "T    ft              600         700\nVOL  ft3             601 ");
    CHECK_CONTAINS(text, "\nCVP  1                 -           -\n"
                         "AX   ft2             622         722\n"
                         "CX   1               623         723\n"
                         "CP   1               624         724\n\n"
                         "T    draught at x = 0 above the baseline z = 0\n");
    CHECK_TEXT(strstr(text, "\nCVP  vertical"), end_of_text);
    batten_release(text);
}

TEST(a_text_says_how_a_mass_rests_and_its_righting_arms)
{
    bat_hydro_row rows[1];
    bat_hydro_report report = report_of(1, rows);
    load(&report);
    char *text = write_report(&report, bat_hydro_as_text);
    CHECK_CONTAINS(text, "L in the coefficients and in MCT is 12.5 ft\n");
    char *end = strstr(text, "\nMeasures of GZ");
    CHECK(end != NULL);
    *end = 0; /* what follows has a test of its own */
    CHECK_TEXT(strstr(text, "\n\nAfloat"),
               "\n\nAfloat with 80 t, their centre at (4, 0.25, 1.5) ft\n"
               "  draught 1.25 ft at x = 0, trim 2 deg, heel 4 deg\n"
               "  GMT 0.5 ft, GML 40 ft: stable\n\n"
               "heel, deg             GZ          KN           T   trim, deg   freeboard\n"
               "10                   0.5        0.75         1.5           3       -0.25\n"
               "20                     -           -           -           -           -\n");
    batten_release(text);
    report.rest.stable = false;
    text = write_report(&report, bat_hydro_as_text);
    CHECK_CONTAINS(text, "GML 40 ft: not stable\n");
    batten_release(text);
}

TEST(a_table_has_symbols_units_draughts_and_below_them_the_rest_and_the_arms)
{
    static const char loaded[] =
        "T,VOL,DISP,LWL,BWL,AW,S,XCB,YCB,KB,XCF,IT,IL,BMT,BML,KMT,KML,TPC,MCT,CB,CWP,CVP,"
        "AX,CX,CP\n"
        "ft,ft3,t,ft,ft,ft2,ft2,ft,ft,ft,ft,ft4,ft4,ft,ft,ft,ft,t/cm,t m/cm,1,1,1,"
        "ft2,1,1\n"
        "0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,,22,23,24\n"
        "100,101,102,103,104,105,106,107,108,109,110,111,112,113,114,115,116,117,118,119,120,,"
        "122,123,124\n"
        "\nx,A at T = 0,A at T = 100\nft,ft2,ft2\n3,0.5,10.5\n4.5,1.5,11.5\n"
        "\nheel,GZ,KN,T,trim,freeboard\ndeg,ft,ft,ft,deg,ft\n4,0,,1.25,2,\n"
        "10,0.5,0.75,1.5,3,-0.25\n20,,,,,\n";
    bat_hydro_row rows[2];
    bat_hydro_report report = report_of(2, rows);
    char *csv = write_report(&report, bat_hydro_as_csv);
    CHECK(strlen(csv) == (size_t)(strstr(loaded, "\nheel") - loaded) &&
          strncmp(csv, loaded, strlen(csv)) == 0);
    batten_release(csv);
    load(&report);
    csv = write_report(&report, bat_hydro_as_csv);
    CHECK(strncmp(csv, loaded, strlen(loaded)) == 0);
    CHECK(strncmp(csv + strlen(loaded), "\nmeasure,value,unit\n", 20) == 0);
    batten_release(csv);
}

static const char json_of_lids[] =
    ", \"CVP\": null, \"AX\": 122, \"CX\": 123, \"CP\": 124}\n  ],\n"
    "  \"sections\": {\n    \"x\": [3, 4.5],\n    \"A\": [\n"
    "      [0.5, 1.5],\n      [10.5, 11.5]\n    ]\n  },\n"
    "  \"lids\": [\n"
    "    {\"x\": [1, 2], \"z\": [7, 8], \"area\": 3},\n"
    "    {\"x\": [4, 5], \"z\": [9, 10], \"area\": 6}\n  ]\n}\n";

static const char json_of_rest[] =
    ",\n  \"afloat\": {\"mass\": 80, \"x\": 4, \"y\": 0.25, \"z\": 1.5, \"draught\": 1.25, "
    "\"trim\": 2, \"heel\": 4, \"GMT\": 0.5, \"GML\": 40, \"stable\": true},\n  \"arms\": [\n"
    "    {\"heel\": 10, \"GZ\": 0.5, \"KN\": 0.75, \"T\": 1.5, \"trim\": 3, \"freeboard\": -0.25},\n"
    "    {\"heel\": 20, \"GZ\": null, \"KN\": null, \"T\": null, \"trim\": null, "
    "\"freeboard\": null}\n  ],\n  \"measures\": {\"GM\": ";

TEST(json_has_all_figures_under_their_symbols)
{
    bat_hydro_row rows[2];
    bat_hydro_report report = report_of(2, rows);
    char *json = write_report(&report, bat_hydro_as_json);
    CHECK_CONTAINS(json,
                   "{\n  \"unit\": \"ft\",\n  \"density\": 1.025, \"trim\": 0.5, \"heel\": 6, "
                   "\"L\": null,\n  \"rows\": [\n    {\"T\": 0, \"VOL\": 1, ");
    CHECK_CONTAINS(json, ", \"CVP\": null, \"AX\": 22, \"CX\": 23, \"CP\": 24},\n"
                         "    {\"T\": 100, \"VOL\": 101, ");
    CHECK_TEXT(strstr(strstr(json, "{\"T\": 100"), ", \"CVP\""), json_of_lids);
    batten_release(json);
    load(&report);
    report.rest.stable = true;
    json = write_report(&report, bat_hydro_as_json);
    CHECK_CONTAINS(json, "\"L\": 12.5,\n");
    CHECK_CONTAINS(json, json_of_rest);
    batten_release(json);
    report.rest.stable = false;
    report.arm_count = 0;
    json = write_report(&report, bat_hydro_as_json);
    CHECK_CONTAINS(json, "\"stable\": false},\n  \"arms\": [\n  ],\n");
    batten_release(json);
}
