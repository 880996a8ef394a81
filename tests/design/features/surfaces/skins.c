#include "design/evaluate.h"

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
        {"{skin: [wall, wall, wall2]}", "sections 0 and 1 coincide"},
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
