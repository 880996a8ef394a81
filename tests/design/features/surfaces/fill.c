#include "design/evaluate.h"

/* Three rounded edges around a hole, and a wall that has nothing to do with it. */
static const char common[] = "batten: 1\nunits: m\nfeatures:\n"
                             "  a: {arc: 1, angle: 90 deg}\n"
                             "  b: {arc: 1, angle: 90 deg, axis: x, from: y}\n"
                             "  c: {arc: 1, angle: 90 deg, axis: y, from: z}\n"
                             "  down: {extrude: a, along: [0, 0, -1.2]}\n"
                             "  back: {extrude: b, along: [-1.2, 0, 0]}\n"
                             "  left: {extrude: c, along: [0, -1.2, 0]}\n"
                             "  far: {line: [[5, 0, 0], [6, 0, 0]]}\n"
                             "  wall: {extrude: far, along: [0, 0, 1]}\n"
                             "  upright: {extrude: a, along: [0, 0, 1]}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  x: %s\n", common, feature);
    return evaluate_design(text, "x", notes, out);
}

/* The text of the note that contains these words, or "". */
static const char *note_with(const batten_notes *notes, const char *words, bool remark)
{
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const batten_note *note = batten_notes_at(notes, i);
        if (note->is_remark == remark && strstr(note->text, words))
            return note->text;
    }
    return "";
}

TEST(a_fill_goes_on_from_the_surfaces_around_and_says_how_well)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(evaluate("{fill: [c, a, b], along: [down, back, left, wall]}", notes, &design));
    const batten_model *model = batten_design_result(design, "x")->value;
    CHECK_INT(batten_model_count(model), 3);
    CHECK_TEXT(batten_model_object(model, 0)->name, "x.1");
    CHECK_TEXT(batten_model_object(model, 2)->name, "x.3");
    if (batten_notes_dropped(notes) == 0) { /* for lack of memory */
        const char *line = note_with(notes, "gaps of up to", true);
        CHECK_CONTAINS(line, " m (along '");
        CHECK_CONTAINS(line, "tangent planes differ by up to");
        CHECK_CONTAINS(line, " degrees (");
        CHECK_CONTAINS(line, "curvatures across by up to");
        CHECK_CONTAINS(line, " per m (");
        /* no edge has a line of its own: nothing exceeds its bound */
        CHECK(!*note_with(notes, "': ", true) &&
              !*note_with(notes, "between surfaces 1 and 2:", true));
        CHECK_CONTAINS(note_with(notes, "none of the sides", false), "surface 'wall'");
    }
    for (int i = 0; i < 3; i++) /* the fill of an octant is nearly a sphere */
        for (int k = 0; k <= 10; k++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(batten_model_object(model, i)->surface, k / 10.0,
                                             k / 10.0, 0, p));
            CHECK_NEAR(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), 1, 0.015);
        }
    batten_design_free(design);
    batten_notes_free(notes);
}

TEST(a_fill_takes_over_curvature)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(evaluate("{fill: [c, a, b], along: [down, back, left], continuity: G2}", notes,
                      &design));
    CHECK_INT(batten_model_count(batten_design_result(design, "x")->value), 3);
    if (batten_notes_dropped(notes) == 0)
        CHECK_CONTAINS(note_with(notes, "gaps of up to", true), "curvatures across by up to");
    batten_design_free(design);
    batten_notes_free(notes);
}

TEST(a_bound_on_jumps_of_curvature_is_met_or_refused)
{
    batten_design *design = NULL;
    CHECK_STATUS(evaluate("{fill: [c, a, b], along: [down, back, left], continuity: G2, "
                          "curvature: 1e-6}",
                          NULL, &design),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("curvatures across differ by");
    CHECK_MESSAGE("and 1e-06 is allowed");
    CHECK_OK(evaluate("{fill: [c, a, b], along: [down, back, left], continuity: G2, "
                      "curvature: 2}",
                      NULL, &design));
    batten_design_free(design);
}

TEST(fills_that_are_formulas_become_splines)
{
    static const char *features[] = {
        "{fill: [c, a, b], along: [down, back, left], form: kato, within: 1 mm, angle: 0.5 deg}",
        "{fill: [c, a, b], along: [down, back, left], form: charrot-gregory, within: 1 mm, "
        "angle: 0.5 deg}"};
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], NULL, &design));
        const batten_model *model = batten_design_result(design, "x")->value;
        CHECK_INT(batten_model_count(model), 3);
        CHECK_TEXT(batten_surface_kind(batten_model_object(model, 1)->surface), "nurbs");
        CHECK(batten_design_result(design, "x")->has_error);
        batten_design_free(design);
    }
}

TEST(without_tangent_planes_a_fill_has_the_position_alone)
{
    static const char *features[] = {"{fill: [a, b, c]}",
                                     "{fill: [a, b, c], along: [down, back], continuity: G0}"};
    for (int i = 0; i < COUNT(features); i++) {
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        CHECK_OK(batten_notes_create(100, &notes));
        CHECK_OK(evaluate(features[i], notes, &design));
        if (batten_notes_dropped(notes) == 0)
            CHECK(*note_with(notes, "gaps of up to", true));
        batten_design_free(design);
        batten_notes_free(notes);
    }
}

TEST(G7_fills_that_cannot_be_are_refused)
{
    static const struct {
        const char *feature, *words;
        batten_status status;
    } rows[] = {
        {"{fill: [a, b]}", "is open by 1.4", BATTEN_NOT_COMPATIBLE},
        {"{fill: [a, b, far]}", "is open by", BATTEN_NOT_COMPATIBLE},
        {"{fill: a}", "a hole of 1 sides", BATTEN_BAD_ARGUMENT},
        {"{fill: [a, b, c], along: upright}", "points out of the hole", BATTEN_NOT_COMPATIBLE},
        {"{fill: [a, b, c, a, b, c, a, b, c], form: split}", "a hole of 9 sides",
         BATTEN_BAD_ARGUMENT},
        {"{fill: [a, b, c], angle: 0 deg}", "the angle of a fill is above 0",
         BATTEN_BAD_ARGUMENT},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate(rows[i].feature, NULL, &design), rows[i].status);
        CHECK_MESSAGE(rows[i].words);
    }
}

TEST(the_error_of_a_fill_is_what_it_misses_of_the_given_curves)
{
    batten_design *design = NULL;
    double worst = 0;
    CHECK_OK(evaluate("{fill: [c, a, b], within: 1 mm}", NULL, &design));
    const batten_feature_result *result = batten_design_result(design, "x");
    for (int i = 0; i < 3; i++) { /* the first half of each side is v = 0 of a surface */
        const batten_surface *surface = batten_model_object(result->value, i)->surface;
        for (int k = 0; k <= 400; k++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, k / 400.0, 0, 0, p));
            worst = fmax(worst, fabs(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 1));
        }
    }
    CHECK(result->has_error && worst > 0);
    CHECK(result->error_max >= worst && result->error_max <= 1e-3);
    batten_design_free(design);
}

TEST(a_fill_with_curvatures_that_contradict_each_other_fails)
{
    static const double corners[5][3] = {{1.2, 0, 0.3},
                                         {0.309, 0.951, 0},
                                         {-0.89, 0.647, 0.4},
                                         {-0.971, -0.705, 0.1},
                                         {0.309, -0.951, -0.1}};
    static const char *const outside[5] = {"[1.7346, 0.5706, 0.54], [1.0284, 1.1334, -0.24]",
                                           "[-0.2256, 1.5216, -0.18], [-0.8414, 1.4582, 0.58]",
                                           "[-1.6094, 0.4646, 0.64], [-1.739, -0.5574, 0.22]",
                                           "[-1.02, -1.516, -0.08], [-0.2256, -1.5216, -0.34]",
                                           "[1.077, -1.0986, -0.22], [1.7346, -0.5706, 0.48]"};
    static const batten_status wanted[2] = {BATTEN_OK, BATTEN_TOLERANCE_NOT_MET};
    for (int g = 0; g < 2; g++) {
        char text[3000];
        int n = snprintf(text, sizeof text, "batten: 1\nunits: m\nfeatures:\n");
        for (int i = 0; i < 5; i++) {
            const double *a = corners[i], *b = corners[(i + 1) % 5];
            n += snprintf(text + n, sizeof text - (size_t)n,
                          "  s%d: {polyline: [[%g, %g, %g], [%g, %g, %g]]}\n  o%d: {polyline: "
                          "[%s]}\n  r%d: {ruled: [s%d, o%d]}\n",
                          i, a[0], a[1], a[2], b[0], b[1], b[2], i, outside[i], i, i, i);
        }
        snprintf(text + n, sizeof text - (size_t)n,
                 "  x: {fill: [s0, s1, s2, s3, s4], along: [r0, r1, r2, r3, r4], continuity: "
                 "G%d}\n",
                 g + 1);
        batten_design *design = NULL;
        CHECK_STATUS(evaluate_design(text, "x", NULL, &design), wanted[g]);
        if (g == 1)
            CHECK_MESSAGE("continuity G1 does better");
        batten_design_free(design);
    }
}

TEST(G7_a_corner_in_which_surfaces_contradict_each_other_is_named)
{
    static const char text[] = "batten: 1\nunits: m\nfeatures:\n"
                               "  a: {line: [[0, 0, 0], [1, 0, 0]]}\n"
                               "  b: {line: [[1, 0, 0], [1, 1, 0]]}\n"
                               "  c: {line: [[1, 1, 0], [0, 1, 0]]}\n"
                               "  d: {line: [[0, 1, 0], [0, 0, 0]]}\n"
                               "  ramp: {extrude: a, along: [0, -1, -1]}\n"
                               "  floor: {extrude: b, along: [1, 0, 0]}\n"
                               "  x: {fill: [d, c, b, a], along: [ramp, floor], form: %s, "
                               "within: 1 mm, angle: 1 deg}\n";
    static const char *forms[] = {"split", "kato", "charrot-gregory"};
    for (int i = 0; i < COUNT(forms); i++) {
        char design_text[1000];
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        snprintf(design_text, sizeof design_text, text, forms[i]);
        CHECK_OK(batten_notes_create(100, &notes));
        CHECK_OK(evaluate_design(design_text, "x", notes, &design));
        if (batten_notes_dropped(notes) == 0) {
            const char *note = note_with(notes, "planes that differ by 45 degrees", false);
            CHECK_CONTAINS(note, "in the corner between '");
            CHECK_CONTAINS(note, "'a'");
        }
        batten_design_free(design);
        batten_notes_free(notes);
    }
}

/* A triangle of the cylinder z = x^2 by its sides, and its derivatives inward across them. */
#define CYLINDER                                                                 \
    "batten: 1\nunits: m\nfeatures:\n"                                           \
    "  p1: {points: [[0, 0, 0], [0.5, 0, 0], [1, 0, 1]]}\n  a: {bezier: p1}\n"   \
    "  p2: {points: [[0, 1, 0], [0.5, 0.5, 0], [1, 0, 1]]}\n  b: {bezier: p2}\n" \
    "  c: {line: [[0, 1, 0], [0, 0, 0]]}\n"                                      \
    "  q1: {points: [[0, 1, 0], [0, 1, 0]]}\n  da: {bezier: q1}\n"               \
    "  q2: {points: [[-1, -1, 0], [-1, -1, -2]]}\n  db: {bezier: q2}\n"          \
    "  q3: {points: [[1, 0, 0], [1, 0, 0]]}\n  dc: {bezier: q3}\n"

TEST(a_fill_takes_its_tangent_planes_from_slopes_that_are_given)
{
    static const char *const forms[] = {"split", "sheet"};
    for (int f = 0; f < 2; f++) {
        char text[2000];
        batten_design *design = NULL;
        snprintf(text, sizeof text,
                 CYLINDER
                 "  x: {fill: [a, b, c], slopes: [da, db, dc], form: %s, angle: 0.05 deg}\n",
                 forms[f]);
        CHECK_OK(evaluate_design(text, "x", NULL, &design));
        const batten_model *model = batten_design_result(design, "x")->value;
        CHECK_INT(batten_model_count(model), f == 0 ? 3 : 1);
        for (int i = 0; f == 0 && i < 3; i++)
            for (int k = 0; k <= 10; k++) {
                double p[3];
                CHECK_OK(batten_surface_evaluate(batten_model_object(model, i)->surface,
                                                 k / 10.0, k / 10.0, 0, p));
                CHECK_NEAR(p[2], p[0] * p[0], 1e-4);
            }
        batten_design_free(design);
    }
}

TEST(slopes_that_a_fill_cannot_use_are_refused)
{
    static const char *const rows[][2] = {
        {"{fill: [a, b, c], slopes: [da, db, dc, da]}", "there are 4 'slopes' for 3 sides"},
        {"{fill: [a, b, c], slopes: da, along: s}", "without 'along'"},
        {"{fill: [a, b, c], slopes: da, continuity: G2}", "with continuity G1"},
        {"{fill: [a, b, c], slopes: da, continuity: G0}", "with continuity G1"}};
    for (int i = 0; i < 4; i++) {
        char text[2000];
        batten_design *design = NULL;
        snprintf(text, sizeof text, CYLINDER "  s: {extrude: a, along: [0, -1, 0]}\n  x: %s\n",
                 rows[i][0]);
        CHECK_STATUS(evaluate_design(text, "x", NULL, &design), BATTEN_BAD_ARGUMENT);
        CHECK_CONTAINS(batten_message(), rows[i][1]);
        batten_design_free(design);
    }
}
