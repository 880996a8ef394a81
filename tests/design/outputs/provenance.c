#include "design/expect.h"

/* Which points a shape is measured against: those given, those moved by fairing, none where an operation displaces. */

static const char curves[] =
    "  ducks: {points: [[0, 0], [1, 0.1], [2, 0.4], [3, 0.8], [4, 1.7], [5, 2.4]]}\n"
    "  c1: {interpolate: ducks}\n"
    "  f1: {fair: c1, within: 0.02}\n"
    "  lifted: {move: f1, by: [0, 0, 1]}\n"
    "  skin: {skin: [f1, lifted]}\n"
    "  bent: {deform: skin, counts: 2, move: [2, 2, 2, 0, 0, 0.5]}\n"
    "  sheet: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}\n"
    "  unused: {points: [[7, 7], [8, 8]]}\n"
    "  edge: {line: [[0, 0], [1, 0]]}\n";

static const expect_row rows[] = {
    {"k.json: {check: c1}", BATTEN_OK,
     "\"distances\": [{\"from\": \"c1\", \"faired\": false, \"points\": 6, "
     "|!\"faired\": true|!unused"},
    /* Those given may be as far as fairing may move them; those moved lie on the surface. */
    {"k.json: {check: skin, within: 0.02}", BATTEN_OK,
     "\"ok\": true|\"distances\": [{\"from\": \"ducks\", \"faired\": false, \"points\": 6, \"max\": "
     "0.01|}, {\"from\": \"f1\", \"faired\": true, \"points\": 6, |!unused"},
    {"k.json: {check: skin, within: 0.005}", BATTEN_OK, "\"ok\": false"},
    {"k.txt: {check: skin, within: 0.005}", BATTEN_OK,
     "distance from the 6 points given, 'ducks'|distance from the 6 points after fairing, "
     "'f1'|the points given lie farther than 0.005 m"},
    {"k.json: {check: bent}", BATTEN_OK, "\"distances\": []"},
    {"k.json: {check: sheet}", BATTEN_OK, "\"distances\": []|\"fair\": null"},
    {"k.json: {check: edge}", BATTEN_OK, "\"type\": \"curve\"|!\"distances\""},
};

TEST(shapes_are_measured_against_the_points_that_they_come_from)
{
    EXPECT_OUTPUTS(curves, rows);
}
