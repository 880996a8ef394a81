#include "design/evaluate.h"
#include "design/expect.h"

/* What the skins below are made from: rings that begin anywhere, frames, rows of points. */
static const char common[] =
    "batten: 1\nunits: m\ntolerance: 0.1 mm\nfeatures:\n"
    "  p0: {points: [[2, 0, 0], [1, 1, 0], [0, 1.2, 0], [-2, 0, 0], [0, -1, 0]]}\n"
    "  p1: {points: [[0, 1.2, 1], [1, 1, 1], [2, 0, 1], [0, -1, 1], [-2, 0, 1]]}\n"
    "  ring: {interpolate: p0, periodic: yes}\n  ring2: {interpolate: p1, periodic: yes}\n"
    "  wall: {line: [[0, 0, 0], [0, 1, 0]]}\n  wall2: {line: [[1, 0, 0], [1, 1, 1]]}\n"
    "  wall3: {line: [[0.5, 0, 0], [0.5, 1, 1]]}\n"
    "  arc: {arc: 1, angle: 100 deg}\n  arc2: {arc: 1.2, angle: 150 deg, at: [0, 0, 1]}\n"
    "  e: {points: [[0, 0, 0], [0, 1, 0.2], [0, 1.1, 0.3], [0, 2, 0.2], [0, 3, 0]]}\n"
    "  f: {points: [[1, 0, 0.1], [1, 1.6, 0.3], [1, 3, 0]]}\n"
    "  g: {points: [[2, 0, 0.1], [2, 0.6, 0.3], [2, 2, 0.5], [2, 3, 0]]}\n"
    "  frame: {interpolate: e}\n  frame2: {interpolate: g}\n  one: {points: [[0, 0]]}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  a: %s\n", common, feature);
    return evaluate_design(text, "a", notes, out);
}

TEST(features_of_skins_make_surfaces)
{
    static const char *const rows[] = {
        "{skin: [ring, ring2], turn: yes, align: yes}",
        "{skin: [ring, ring2], starts: [0, 0.4]}",
        "{skin: [frame, frame2], match: arc-length, within: 1 mm}",
        "{skin: [frame, frame2], match: marks, marks: [0.3, 0.6, 0.4, 0.7], within: 1 mm}",
        "{skin: [arc, arc2], creases: cure}",
        "{skin: [arc, arc2], procedural: yes}",
        "{skin-rows: [e, f, g]}",
        "{skin-rows: [e, f, g], degree-u: 2, degree-v: 1, parameters: chord, margin: 0.1}",
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(rows[i], NULL, &design));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_model_count(model), 1);
        CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_SURFACE);
        batten_design_free(design);
    }
}

TEST(features_of_skins_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{skin: [ring, wall]}", "section 1 is closed, and section 2 is open"},
        {"{skin: [ring, ring2], starts: [0.1]}", "'starts' has 1 value for 2 sections"},
        {"{skin: [wall, wall2], starts: [0.1, 0.1]}", "section 1 is open"},
        {"{skin: [frame, frame2], match: marks, marks: [0.3], within: 1 mm}",
         "'marks' has 1 value, not as many for each of 2 sections"},
        {"{skin: [frame, frame2], match: marks, within: 1 mm}", "there are no marks"},
        {"{skin: [frame, frame2], match: arc-length}", "a tolerance is needed"},
        {"{skin: [wall, wall, wall2]}", "sections 1 and 2 coincide"},
        {"{skin-rows: [e, one, g]}", "row 2 has 1 point, and needs 2"},
        {"{skin-rows: [e, g], margin: 0.6}", "the margin of knots is 0.6"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, NULL, &design);
        if (test_memory_failed(status, BATTEN_OK))
            status = evaluate(rows[i].feature, NULL, &design);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i].says);
    }
}

TEST(G7_sections_out_of_order_are_noted)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{skin: [wall, wall2, wall3]}", NULL, &design));
    const batten_feature_result *found = batten_design_result(design, "a");
    CHECK(found->skin && found->skin->disorder == 1 && found->skin->crossing == -1);
    batten_design_free(design);
}

static const char tips[] = "  ring: {circle: 1}\n"
                           "  ring2: {circle: 1, at: [0, 0, 1]}\n"
                           "  back: {reverse: ring2}\n"
                           "  turned: {circle: 1, at: [0, 0, 1], from: [-0.6, 0.8, 0]}\n"
                           "  sail: {bilinear: [[0, 0], [1, 0], [0, 1], [1, 1]]}\n"
                           "  low: {circle: 2, at: [0, 0, 1]}\n"
                           "  two: {points: [[0, 0, 2], [1, 0, 2]]}\n"
                           "  tip: {points: [[0, 0, 3]]}\n";

TEST(a_point_is_the_tip_of_a_skin)
{
    static const expect_row rows[] = {
        /* The cone of slant sqrt(10). */
        {"{skin: [ring, tip], degree: 1}", BATTEN_OK,
         "within 1e-9;at 0 1 0 0 3;at 0.3 1 0 0 3;box -1 -1 0 1 1 3;silent"},
        {"{skin: [tip, ring2, ring]}", BATTEN_OK, "within 1e-9;at 0.7 0 0 0 3;silent"},
        {"{skin: [ring, ring2, tip], poles: smooth}", BATTEN_OK,
         "within 1e-7;at 0.2 1 0 0 3;normal 0.1 0.99999999 0 0 1;silent"},
        {"{skin: [ring, tip, ring2]}", BATTEN_BAD_ARGUMENT, "'tip' is 1 point"},
        {"{skin: [ring, two]}", BATTEN_BAD_ARGUMENT, "'two' is 2 points"},
        {"{skin: [ring, sail, ring2]}", BATTEN_BAD_ARGUMENT, "'sail' is a surface"},
        {"{skin: [ring, ring2, tip], poles: smooth, degree: 2}", BATTEN_BAD_ARGUMENT,
         "a smooth pole needs an odd degree"},
    };
    EXPECT(tips, rows);
}

TEST(a_skin_does_not_twist_unless_it_is_told_to)
{
    static const expect_row rows[] = {
        {"{skin: [ring, back], degree: 1}", BATTEN_OK,
         "within 1e-9;along 1 0 0 0 0 0 1;notes 1 section was reversed, the first of them "
         "section 2"},
        {"{skin: [ring, turned], degree: 1}", BATTEN_OK,
         "within 1e-4;along 1 0 0 0 0 0 1;notes 1 section starts elsewhere, the first of them "
         "section 2"},
        {"{skin: [ring, ring2], degree: 1}", BATTEN_OK, "along 1 0 0 0 0 0 1;silent"},
        {"{skin: [ring, low], degree: 1}", BATTEN_OK, "silent"},
    };
    EXPECT(tips, rows);
}

static const char tipped[] = "  tip: {points: [[0, 0, 0]]}\n  off: {points: [[0, 0.3, 0]]}\n"
                             "  two: {points: [[0, 0, 0], [1, 0, 0]]}\n"
                             "  oval: {ellipse: 2, b: 1}\n  back: {reverse: oval}\n"
                             "  up: {line: [[0, 0, 0], [0, 0, 3]]}\n"
                             "  a1: {line: [[1, -0.5, 0], [1, 0.5, 0]]}\n"
                             "  a2: {line: [[2, -1, 0], [2, 1, 0]]}\n"
                             "  g1: {line: [[0, 0, 0], [2, -1, 0]]}\n"
                             "  g2: {line: [[0, 0, 0], [2, 1, 0]]}\n";

TEST(a_point_is_the_tip_of_a_sweep)
{
    static const expect_row rows[] = {
        {"{sweep: [oval, tip], path: up}", BATTEN_OK,
         "within 1e-6;at 0 1 0 0 3;at 0.3 1 0 0 3;box -2 -1 0 2 1 3"},
        {"{sweep: [tip, oval, oval], path: up, at: [0, 0.4, 1]}", BATTEN_OK,
         "within 1e-6;at 0 0 0 0 0;at 0 1 2 0 3"},
        {"{sweep: [oval, tip, oval], path: up}", BATTEN_BAD_ARGUMENT, "'tip' is 1 point"},
        {"{sweep: [oval, two], path: up}", BATTEN_BAD_ARGUMENT, "'two' is 2 points"},
        {"{sweep: tip, path: up}", BATTEN_COINCIDENT, "the section is a point"},
    };
    EXPECT(tipped, rows);
}

TEST(sections_do_not_twist_a_sweep_unless_they_are_told_to)
{
    static const expect_row rows[] = {
        {"{sweep: [oval, back], path: up}", BATTEN_OK,
         "within 1e-6;at 0.25 0.5 0 1 1.5;notes 1 section was reversed, the first of them "
         "section 2"},
        {"{sweep: [oval, back], path: up, align: no}", BATTEN_OK,
         "within 1e-6;at 0.25 0.5 0 0 1.5"},
    };
    EXPECT(tipped, rows);
}

TEST(a_point_is_the_tip_of_a_network)
{
    static const expect_row rows[] = {
        {"{gordon: [tip, a1, a2], guides: [g1, g2]}", BATTEN_OK,
         "within 1e-6;at 0 0 0 0 0;at 0.7 0 0 0 0;at 0.5 1 2 0 0"},
        {"{gordon: [g1, g2], guides: [a2, a1, tip]}", BATTEN_OK,
         "within 1e-6;box 0 -1 0 2 1 0"},
        {"{gordon: [tip, a1, a2, g1, g2]}", BATTEN_OK, "within 1e-6;box 0 -1 0 2 1 0"},
        {"{gordon: [off, a1, a2], guides: [g1, g2]}", BATTEN_NOT_COMPATIBLE,
         "profile 'off' (1 of 3) misses guide 'g1' (1 of 2) by 0.3"},
        {"{gordon: [a1, tip, a2], guides: [g1, g2]}", BATTEN_BAD_ARGUMENT, "'tip' is 1 point"},
    };
    EXPECT(tipped, rows);
}

/* Two sections whose inner knots all differ by 1e-7, and two whose knots differ as knots do. */
static const char near_knots[] =
    "  p: {points: [[0, 0, 0], [0, 1, 1], [0, 2, 0], [0, 3, 1], [0, 4, 0]]}\n"
    "  q: {points: [[1, 0, 0], [1, 1.0000004, 1], [1, 2.0000004, 0], [1, 3.0000004, 1], [1, 4, 0]]}\n"
    "  r: {points: [[1, 0, 0], [1, 1.1, 1.2], [1, 2, 0.1], [1, 2.8, 1], [1, 4, 0]]}\n"
    "  pc: {interpolate: p}\n  qc: {interpolate: q}\n  rc: {interpolate: r}\n";

TEST(G10_knots_that_nearly_coincide_are_noted_also_when_all_do)
{
    static const expect_row rows[] = {
        {"{skin: [pc, qc]}", BATTEN_OK, "notes along the sections the shortest span is"},
        {"{skin: [pc, qc], within: 0.1 mm}", BATTEN_OK, "silent"},
        {"{skin: [pc, rc]}", BATTEN_OK, "silent"},
    };
    EXPECT(near_knots, rows);
}

TEST(a_seam_that_a_tolerance_bends_is_noted)
{
    /* An ellipse and a free ring, both smooth at their seams; what is within 1 mm of them has a corner there. */
    static const char rings[] =
        "  s0: {ellipse: 0.5878, b: 0.7411, axis: x, at: [1, -0.0982, -0.0169]}\n"
        "  p: {points: [[2, 0.605, 0], [2, 0.336, 0.808], [2, -0.32, 0.842], [2, -0.707, 0],\n"
        "      [2, -0.403, -0.632], [2, 0.493, -0.66]]}\n"
        "  s1: {interpolate: p, periodic: yes}\n"
        "  q0: {points: [[0.488, -0.173, 0.132]]}\n  q1: {points: [[2.987, -0.156, 0.099]]}\n";
    static const expect_row rows[] = {
        {"{skin: [q0, s0, s1, q1], poles: smooth, within: 1 mm}", BATTEN_OK,
         "notes degrees that no section has"},
    };
    EXPECT(rings, rows);
}

TEST(creases_that_a_tolerance_brings_into_circles_are_noted_whole)
{
    /* Circles and rings that take turns: within 1 mm the circles have small corners, and between sections these grow. */
    static const char mixed[] =
        "  s0: {circle: 0.4946, axis: x, at: [1, -0.0729, 0.0186]}\n"
        "  p1: {points: [[2, 0.841, 0], [2, 0.36, 0.767], [2, -0.345, 0.744], [2, -0.701, 0],\n"
        "      [2, -0.464, -0.696], [2, 0.342, -0.757]]}\n"
        "  s1: {interpolate: p1, periodic: yes}\n"
        "  s2: {circle: 0.8555, axis: x, at: [3, -0.0522, -0.0755]}\n"
        "  p3: {points: [[4, 0.917, 0], [4, 0.475, 0.535], [4, -0.333, 0.647], [4, -0.668, 0],\n"
        "      [4, -0.302, -0.652], [4, 0.357, -0.555]]}\n"
        "  s3: {interpolate: p3, periodic: yes}\n  q0: {points: [[0.687, -0.173, -0.183]]}\n";
    static const expect_row rows[] = {
        {"{skin: [q0, s0, s1, s2, s3], poles: smooth, within: 1 mm}", BATTEN_OK,
         "notes has a crease of 16."},
    };
    EXPECT(mixed, rows);
}
