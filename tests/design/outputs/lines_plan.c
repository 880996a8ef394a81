#include "design/expect.h"

/* The output 'lines-plan': stations, diagonals, chines. */

static const char hull[] =
    "  topsides: {bilinear: [[0, 1, 0.5], [4, 1, 0.5], [4, 1.4, 1], [0, 1.4, 1]]}\n"
    "  bottom: {bilinear: [[0, 0, 0], [4, 0, 0], [4, 1, 0.5], [0, 1, 0.5]]}\n"
    "  boat: {collect: [bottom, topsides]}\n";

TEST(parameters_that_contradict_each_other_are_refused_by_name)
{
    static const expect_row rows[] = {
        {"l.svg: {lines-plan: boat, stations: 1, waterlines: 0.5, buttocks: 1}", BATTEN_OK,
         "<svg"},
        {"l.svg: {lines-plan: boat, stations: 1, station-at: [1, 2]}", BATTEN_BAD_ARGUMENT,
         "'stations' spaces them, 'station-at' says where they are"},
        {"l.svg: {lines-plan: boat, stations: 1, waterlines: 0.5, diagonal-at: [1, 0.8]}",
         BATTEN_OK, "<svg"},
        {"l.svg: {lines-plan: boat, diagonals: 2, diagonal-at: 1}", BATTEN_BAD_ARGUMENT,
         "'diagonals' chooses them, 'diagonal-at' says where they are"},
        {"l.svg: {lines-plan: boat, diagonal-angle: 30 deg}", BATTEN_BAD_ARGUMENT,
         "'diagonal-angle' belongs to the heights of 'diagonal-at'"},
        {"l.svg: {lines-plan: boat, diagonal-at: 1, diagonal-angle: [30 deg, 40 deg]}",
         BATTEN_BAD_ARGUMENT, "2 angles for 1 diagonal: give one for all"},
        {"l.svg: {lines-plan: boat, diagonal-at: [1, 0.5], diagonal-angle: [30 deg, 95 deg]}",
         BATTEN_BAD_ARGUMENT, "diagonal 2 falls by 95 degrees"},
    };
    EXPECT_OUTPUTS(hull, rows);
}

/* Digits after these are those of rounding. */
TEST(stations_stand_where_they_are_asked_for)
{
    static const expect_row rows[] = {
        {"l.dxf: {lines-plan: boat, station-at: [0.5, 2.25], waterlines: 0.5, buttocks: 1}",
         BATTEN_OK, "\ngrid\n 10\n0.5|\ngrid\n 10\n2.25|!\ngrid\n 10\n0.4|!\ngrid\n 10\n3.6"},
        {"l.dxf: {lines-plan: boat, waterlines: 0.5, buttocks: 1}", BATTEN_OK,
         "\ngrid\n 10\n0.4|\ngrid\n 10\n3.6|!\ngrid\n 10\n0.5|!\ngrid\n 10\n2.25"},
    };
    EXPECT_OUTPUTS(hull, rows);
}

TEST(a_plan_takes_title_size_and_diagonals_from_its_parameters)
{
    static const expect_row rows[] = {
        {"l.svg: {lines-plan: boat, stations: 1, waterlines: 0.5, buttocks: 1}", BATTEN_OK,
         "width=\"1684pt\" height=\"1191pt\""},
        {"l.svg: {lines-plan: boat, stations: 1, width: 700, height: 500}", BATTEN_OK,
         "width=\"700pt\" height=\"500pt\""},
        {"l.dxf: {lines-plan: boat, stations: 1, title: Ketch}", BATTEN_OK, "\nKetch"},
        {"l.dxf: {lines-plan: boat, stations: 1}", BATTEN_OK, "!\nKetch"},
        {"l.dxf: {lines-plan: boat, waterlines: 0.5, buttocks: 1, diagonals: 0}", BATTEN_OK,
         "!\ndiagonals\n 10"},
        {"l.dxf: {lines-plan: boat, waterlines: 0.5, buttocks: 1, diagonal-at: [0.8, 1.2], "
         "diagonal-angle: [30 deg, 60 deg]}",
         BATTEN_OK, "\ndiagonals\n 10"},
        {"l.eps: {lines-plan: boat}", BATTEN_UNSUPPORTED,
         "'l.eps' must end in .pdf, .svg, .png or .dxf"},
        {"l.svg: {lines-plan: boat, diagonal-at: [1, 1.1, 1.2], diagonal-angle: [30 deg, 40 "
         "deg]}",
         BATTEN_BAD_ARGUMENT, "2 angles for 3 diagonals: give one for all, or one for each"},
    };
    EXPECT_OUTPUTS(hull, rows);
}
