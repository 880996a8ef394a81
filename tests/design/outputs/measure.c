#include "design/expect.h"

#include <batten/design.h>
#include <stdlib.h>
#include <string.h>

static batten_status build(const char *features, const char *outputs, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s%s", features, outputs);
    return batten_design_parse(text, strlen(text), NULL, NULL, out);
}

static const char shapes[] =
    "  oval: {ellipse: 2, b: 1, at: [5, 6, 7]}\n"
    "  bar: {line: [[0, 0], [1, 2]]}\n"
    "  ducks: {points: [[0, 0], [1, 1], [2, -1], [3, 0]]}\n"
    "  wave: {interpolate: ducks, ends: natural}\n"
    "  helix: {points: [[0, 0, 0], [1, 1, 1], [2, 0, 3], [1, -1, 4]]}\n"
    "  screw: {interpolate: helix}\n";

static batten_status report(const char *outputs, char **data)
{
    batten_design *design = NULL;
    size_t size;
    batten_status status = build(shapes, outputs, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, NULL, data, &size);
    batten_design_free(design);
    return status;
}

/* The number behind a key. */
static double number(const char *text, const char *key)
{
    const char *at = strstr(text, key);
    CHECK(at != NULL);
    return strtod(at + strlen(key), NULL);
}

TEST(a_report_measures_what_a_curve_encloses)
{
    char *data = NULL;
    CHECK_OK(report("outputs:\n  m.json: {measure: oval}\n", &data));
    CHECK_NEAR(number(data, "\"area\": "), 2 * 3.14159265358979323846, 1e-12);
    CHECK_NEAR(number(data, "\"centroid\": ["), 5, 1e-12);
    CHECK_NEAR(number(data, "\"turning\": "), 1, 1e-12);
    CHECK_NEAR(number(data, "\"half\": ["), 2, 1e-3);
    CHECK_CONTAINS(data, "\"plane\": \"xy\"");
    CHECK_CONTAINS(data, "\"box\": [[3, 5, 7], [7, 7, 7]]");
    CHECK_CONTAINS(data, "\"inflections\": []");
    batten_release(data);
    CHECK_OK(report("outputs:\n  m.txt: {measure: [oval, wave, screw]}\n", &data));
    CHECK_CONTAINS(data, "oval: closed, length 9.68844822");
    CHECK_CONTAINS(data, "area 6.28318531 in the xy-plane, centroid 5 6 7");
    CHECK_CONTAINS(data, "wave: length");
    CHECK_CONTAINS(data, "  inflections at 1.93688151"); /* the middle, by symmetry */
    batten_release(data);
}

TEST(boxes_are_drawn_by_their_edges)
{
    static const struct {
        const char *feature;
        int count;
    } rows[] = {{"{box: wave}", 1},
                {"{box: wave, axes: turned}", 1},
                {"{box: screw}", 6},
                {"{box: screw, axes: turned, within: 1 mm}", 6},
                {"{box: [wave, oval]}", 2},
                {"{split: oval, pieces: spiral}", 4},
                {"{split: wave, pieces: convex}", 2},
                {"{split: wave, pieces: monotone}", 3},
                {"{split: wave, pieces: monotone, along: x}", 1},
                {"{split: wave, pieces: spans}", 3},
                {"{divide: wave, pieces: convex}", 1}};
    for (int i = 0; i < COUNT(rows); i++) {
        char feature[200];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature, "  a: %s\n", rows[i].feature);
        CHECK_OK(build(shapes, feature, &design));
        CHECK_OK(batten_design_evaluate(design, "a", NULL, NULL));
        CHECK_INT(batten_model_count(batten_design_result(design, "a")->value), rows[i].count);
        batten_design_free(design);
    }
}

TEST(boxes_and_pieces_that_cannot_be_are_refused)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{box: bar, axes: turned}", "is straight: its box is a line"},
        {"{split: screw, pieces: convex}", "only curves in the plane"},
        {"{split: wave}", "either 'parameter' or 'pieces'"},
        {"{split: wave, pieces: spans, parameter: 1}", "either 'parameter' or 'pieces'"},
        {"{split: wave, pieces: spans, along: x}", "'along' is for monotone"},
        {"{split: wave, pieces: monotone, along: origin}", "the direction is"},
        {"{divide: wave, pieces: spans, count: 3}", "one of 'count', 'chords'"},
        {"{box: ducks}", "curves are needed"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char feature[200];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature, "  a: %s\n", rows[i].feature);
        batten_status status = build(shapes, feature, &design);
        if (status == BATTEN_OK)
            status = batten_design_evaluate(design, "a", NULL, NULL);
        CHECK(status != BATTEN_OK);
        if (status != BATTEN_OUT_OF_MEMORY)
            CHECK_MESSAGE(rows[i].says);
        batten_design_free(design);
    }
}

TEST(frames_are_crosses_ribbons_and_rows_of_a_table)
{
    static const struct {
        const char *feature;
        batten_object_kind kind;
    } rows[] = {
        {"{frames: screw}", BATTEN_OBJECT_CURVE},
        {"{frames: wave, kind: fixed, count: 2, size: 3 mm}", BATTEN_OBJECT_CURVE},
        {"{frames: screw, as: ribbon, kind: frenet}", BATTEN_OBJECT_SURFACE},
        {"{frames: oval, as: ribbon, kind: closing, count: 50}", BATTEN_OBJECT_SURFACE}};
    for (int i = 0; i < COUNT(rows); i++) {
        char feature[200];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature, "  a: %s\n", rows[i].feature);
        CHECK_OK(build(shapes, feature, &design));
        CHECK_OK(batten_design_evaluate(design, "a", NULL, NULL));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_model_count(model), 1);
        CHECK_INT(batten_model_object(model, 0)->kind, rows[i].kind);
        batten_design_free(design);
    }
    char *data = NULL;
    CHECK_OK(
        report("outputs:\n  f.csv: {frame-table: oval, count: 5, kind: closing}\n", &data));
    int lines = 0;
    for (const char *c = data; *c; c++)
        lines += *c == '\n';
    CHECK_INT(lines, 6);
    CHECK_CONTAINS(data, "curve,parameter,length,x,y,z,xx");
    CHECK_CONTAINS(data, "\n1,0,0,7,6,7,");
    batten_release(data);
}

TEST(frames_that_cannot_be_are_refused)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {{"{frames: screw, count: 1}", "at least 2 are needed"},
                {"{frames: screw, size: 0}", "the size of frames is 0"},
                {"{frames: screw, kind: closing}", "does not close smoothly"},
                {"{frames: bar, kind: frenet}", "bar: the spine is straight at 0"},
                {"{frames: ducks}", "curves are needed"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char feature[200];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature, "  a: %s\n", rows[i].feature);
        batten_status status = build(shapes, feature, &design);
        if (status == BATTEN_OK)
            status = batten_design_evaluate(design, "a", NULL, NULL);
        CHECK(status != BATTEN_OK);
        if (status != BATTEN_OUT_OF_MEMORY)
            CHECK_MESSAGE(rows[i].says);
        batten_design_free(design);
    }
}

TEST(equations_of_curves_are_traced_in_their_plane)
{
    static const char curves[] =
        "  legs: {points: [[0, 0, 5], [3, 2, 5], [-1, 2, 5], [2, 0, 5]]}\n"
        "  loop: {bezier: legs}\n"
        "  pair: {points: [[0, 0], [1, 1], [2, 0], [3, 2], [4, 1]]}\n"
        "  spans: {interpolate: pair, ends: natural}\n";
    static const struct {
        const char *feature, *name; /* of the last object */
    } rows[] = {{"{implicit: loop}", "singular points of loop"},
                {"{implicit: spans, beyond: 0.1, cells: 40}", NULL}};
    for (int i = 0; i < COUNT(rows); i++) {
        char feature[200];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature, "  a: %s\n", rows[i].feature);
        CHECK_OK(build(curves, feature, &design));
        CHECK_OK(batten_design_evaluate(design, "a", NULL, NULL));
        const batten_model *model = batten_design_result(design, "a")->value;
        const batten_object *last = batten_model_object(model, batten_model_count(model) - 1);
        CHECK(batten_model_count(model) >= 2);
        if (rows[i].name) {
            CHECK_TEXT(last->name, rows[i].name);
            CHECK_NEAR(last->points[0], 1, 1e-6); /* the loop is symmetric about x = 1 */
            CHECK_NEAR(last->points[2], 5, 0);
        }
        batten_design_free(design);
    }
    batten_design *design = NULL;
    batten_status status = build(shapes, "  a: {implicit: screw}\n", &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, "a", NULL, NULL);
    CHECK(status != BATTEN_OK);
    if (status != BATTEN_OUT_OF_MEMORY)
        CHECK_MESSAGE("lies in no plane");
    batten_design_free(design);
}

TEST(surfaces_and_triangles_have_areas)
{
    static const char features[] =
        "  ball: {sphere: 2}\n"
        "  corners: {points: [[0, 0, 0], [3, 0, 0], [0, 4, 0]]}\n"
        "  sail: {bezier-triangle: corners, degree: 1}\n"
        "  folds: {coons: [low, right, high, left]}\n"
        "  low: {line: [[0, 0], [1, 0]]}\n  high: {line: [[0, 1], [1, 1]]}\n"
        "  left: {line: [[0, 0], [0, 1]]}\n  right: {line: [[1, 0], [1, 1]]}\n";
    batten_design *design = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(build(features,
                   "outputs:\n  a.json: {measure: [ball, folds, sail]}\n"
                   "  a.txt: {measure: [ball, low]}\n",
                   &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    CHECK_CONTAINS(data, "{\"name\": \"ball\", \"type\": \"surface\", \"area\": ");
    CHECK_NEAR(number(data, "\"area\": "), 16 * 3.14159265358979, 1e-9);
    CHECK(number(data, "\"error\": ") < 1e-8);
    CHECK_NEAR(number(strstr(data, "folds"), "\"area\": "), 1, 1e-12);
    CHECK_NEAR(number(strstr(data, "\"triangles\""), "\"area\": "), 6, 1e-12);
    CHECK_CONTAINS(data, "\"box\": [[-2, -2, -2], [2, 2, 2]], \"box_error\": ");
    CHECK(number(data, "\"box_error\": ") < 1e-8);
    batten_release(data);
    CHECK_OK(batten_design_output(design, 1, NULL, NULL, &data, &size));
    CHECK_CONTAINS(data, "ball: area 50.2654825\n  box -2 -2 -2  to  2 2 2");
    CHECK_CONTAINS(data, "\nlow: length 1\n");
    batten_release(data);
    batten_design_free(design);
}

TEST(curves_smaller_than_the_tolerance_are_not_closed_for_that)
{
    static const char small[] = "  speck: {line: [[0, 0], [1e-9, 0]]}\n"
                                "  ring: {circle: 1e-9}\n";
    batten_design *design = NULL;
    char *data = NULL;
    size_t size;
    CHECK_OK(build(small, "outputs:\n  m.txt: {measure: [speck, ring]}\n", &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    CHECK_CONTAINS(data, "speck: length 1e-09");
    CHECK_CONTAINS(data, "ring: closed, length 6.28");
    batten_release(data);
    batten_design_free(design);
}

TEST(long_lists_are_counted_and_shown_in_part_unless_all_is_asked_for)
{
    static const char features[] =
        "batten: 1\nfeatures:\n"
        "  p: {points: [[0, 0], [1, 1], [2, 0], [3, 1], [4, 0], [5, 1], [6, 0], [7, 1], [8, 0], "
        "[9, 1], [10, 0], [11, 1], [12, 0], [13, 1]]}\n  c: {interpolate: p}\noutputs:\n";
    for (int all = 0; all < 2; all++) {
        char text[900];
        char *data = NULL;
        size_t size;
        batten_design *design = NULL;
        snprintf(text, sizeof text, "%s  r.txt: {measure: c%s}\n", features,
                 all ? ", all: yes" : "");
        CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
        CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
        CHECK((strstr(data, "inflections at 11 places, 1.53") != NULL) == !all);
        CHECK((strstr(data, "12 places, the sharpest ") != NULL) == !all);
        CHECK((strstr(data, " ... ") != NULL) == !all);
        batten_release(data);
        batten_design_free(design);
    }
}

static const char known[] =
    "  open: {polyline: [[1, 0], [4, 0], [4, 3]]}\n"
    "  across: {polyline: [[5, 1, 0], [5, 4, 0], [5, 4, 3]]}\n"
    "  beside: {polyline: [[1, 5, 0], [4, 5, 0], [4, 5, 3]]}\n"
    "  gap: {line: [[1, 2, 3], [3, 5, 9]]}\n"
    "  oblong: {polyline: [[0, 7, 0], [4, 7, 0], [4, 7, 2], [0, 7, 2], [0, 7, 0]]}\n"
    "  tall: {polyline: [[7, 0, 0], [7, 4, 0], [7, 4, 2], [7, 0, 2], [7, 0, 0]]}\n"
    "  nearly: {polyline: [[0, 0], [100, 0], [100, 100], [0, 100], [0, 1]]}\n"
    "  twisted: {polyline: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]]}\n"
    "  sheet: {bilinear: [[0, 0, 0], [3, 0, 0], [3, 0, 4], [0, 0, 4]]}\n"
    "  ball: {sphere: 2, at: [1, 2, 3]}\n"
    "  dots: {points: [[1, 2, 3], [0, 5, 1]]}\n"
    "  \"odd\\\"name\": {line: [[0, 0], [0, 2]]}\n";

/* b h^3 / 12, h b^3 / 12 and areas b h; the axes of the others by turns. */
static const expect_row measured[] = {
    {"m.txt: {measure: open}", BATTEN_OK,
     "open: length 6\n  box 1 0 0  to  4 3 0\n|\n  no area: open by 4.24264069\n  turning number "
     "0.25\n  curvature is 0 at 0 3 6\n|!within"},
    {"m.txt: {measure: across}", BATTEN_OK,
     "  box 5 1 0  to  5 4 3\n|open by 4.24264069\n  turning number 0.25\n"},
    {"m.txt: {measure: beside}", BATTEN_OK,
     "  box 1 5 0  to  4 5 3\n|open by 4.24264069\n  turning number 0.25\n"},
    {"m.txt: {measure: oblong}", BATTEN_OK,
     "closed, length 12\n|area 8 in the xz-plane, centroid 2 7 1\n  second moments about it 10.6666667 |, principal 10.6666667 2.66666667 at "},
    {"m.txt: {measure: tall}", BATTEN_OK,
     "area 8 in the yz-plane, centroid 7 2 1\n  second moments about it 10.6666667 |"},
    {"m.txt: {measure: nearly}", BATTEN_OK,
     "length 399\n|no area: open by 1; 'within' (--within), when it is more, closes it\n"},
    {"m.txt: {measure: nearly, within: 1.5}", BATTEN_OK, "nearly: closed, length 399\n"},
    {"m.txt: {measure: twisted}", BATTEN_OK,
     "twisted: length 3\n  box 0 0 0  to  1 1 1\n|!no area|!turning|!inflections"},
    {"m.txt: {measure: dots}", BATTEN_OK, "dots: 2 points\n  box 0 2 1  to  1 5 3\n"},
    {"m.txt: {measure: ball}", BATTEN_OK,
     "unit m\nball: area 50.2654825\n  box -1 0 1  to  3 4 5|!error at most 1|!, error"},
    {"m.txt: {measure: sheet}", BATTEN_OK, "sheet: area 12\n  box 0 0 0  to  3 0 4\n|!error"},
    {"m.json: {measure: gap}", BATTEN_OK,
     "\"type\": \"curve\", \"closed\": false, \"length\": 7|\"gap\": 7, \"box\": [[1, 2, 3], "
     "[3, 5, 9]], \"oriented_box\": {\"centre\": |, \"axes\": [[0.28571428|\"half\": [3.5"},
    {"m.json: {measure: across}", BATTEN_OK,
     "\"turning\": 0.25, \"inflections\": [], \"flat_points\": [0, 3, 6], "
     "\"curvature_extrema\": [], \"standstills\": [], \"self_crossings\": []}\n  ]\n}\n"},
    {"m.json: {measure: twisted}", BATTEN_OK,
     "\"flat_points\": [|!inflections|!self_crossings|!turning"},
    {"m.json: {measure: tall}", BATTEN_OK,
     "\"plane\": \"yz\", \"area\": 8|\"centroid\": [7, 2, 1], \"moments\": [10.666666|, "
     "\"principal\": [10.666666|, 2.66666666|\"turning\": 1"},
    {"m.json: {measure: [ball, \"odd\\\"name\"]}", BATTEN_OK,
     "{\n  \"unit\": \"m\",\n  \"objects\": [\n    {\"name\": \"ball\", \"type\": \"surface\", "
     "\"area\": 50.26548245|, \"error\": |, \"box\": [[-1, 0, 1], [3, 4, 5]], \"box_error\": "
     "|},\n    {\"name\": \"odd\\\"name\", \"type\": \"curve\", \"closed\": false"},
    {"m: {measure: gap}", BATTEN_OK, "unit m\ngap: length 7\n"},
    {"m.txt: {measure: gap, within: -1}", BATTEN_BAD_ARGUMENT, "'within'"},
};

TEST(measures_have_their_closed_forms_in_every_plane)
{
    EXPECT_OUTPUTS(known, measured);
}
