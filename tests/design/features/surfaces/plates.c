#include "design/evaluate.h"

/* What the plates below are made from. */
static const char common[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  can: {cylinder: 1, height: 2}\n  cap: {cone: 1, height: 1}\n  ball: {sphere: 1}\n"
    "  low: {line: [[0, 0, 0], [1, 0, 0]]}\n  high: {line: [[0, 1, 0], [1, 1, 0.1]]}\n"
    "  k: {points: [[0, 0, 0], [2, 0, -0.1], [4, 0, 0.2]]}\n  keel: {interpolate: k}\n"
    "  c: {points: [[0, 0.5, 0.2], [2, 0.7, 0.1], [4, 0.1, 0.5]]}\n"
    "  chine: {interpolate: c}\n  back: {reverse: chine}\n"
    "  bottom: {developable: [keel, chine]}\n"
    "  seam: {line: [[-1, 0, 0], [-1, 0, 2]]}\n"
    "  plank: {ruled: [low, high]}\n  both: {collect: [can, cap]}\n";

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[4000];
    snprintf(text, sizeof text, "%s  a: %s\n", common, feature);
    return evaluate_design(text, "a", NULL, out);
}

TEST(features_of_plates_make_outlines_and_rulings)
{
    static const struct {
        const char *feature;
        int count;
    } rows[] = {
        {"{unroll: can, within: 1 mm}", 13},
        {"{unroll: cap, lines: 3, within: 1 mm}", 4},
        {"{unroll: plank, lines: 0}", 1},
        {"{unroll: bottom, lines: 4}", 5},
        {"{unroll: can, lines: 0, marks: seam, within: 1 mm}", 2},
        {"{unroll: plank, lines: 2, rulings: u, strain: 0.01}", 3},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(rows[i].feature, &design));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_model_count(model), rows[i].count);
        const batten_object *outline = batten_model_object(model, 0);
        CHECK_TEXT(outline->layer, "cut");
        CHECK(batten_curve_is_closed(outline->curve, 1e-9));
        batten_design_free(design);
    }
}

TEST(features_of_plates_make_surfaces)
{
    static const char *const rows[] = {
        "{developable: [keel, chine]}",
        "{developable: [keel, chine], match: parameter, warp: 2 deg, within: 1 mm}",
        "{developable: [low, high], regression: keep}",
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(rows[i], &design));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_model_count(model), 1);
        CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_SURFACE);
        batten_design_free(design);
    }
}

TEST(plates_that_cannot_be_say_why)
{
    static const struct {
        const char *feature, *message;
    } rows[] = {
        {"{unroll: ball}", "from its chord"},
        {"{unroll: both}", "one surface is unrolled at a time, not 2"},
        {"{unroll: plank, strain: 0.0001}", "more than 0.0001"},
        {"{unroll: can, lines: 2000}", "there may be 0 to 1000"},
        {"{unroll: can, marks: low}", "from the surface at its parameter"},
        {"{unroll: can, within: 0}", "not above 0"},
        {"{developable: [keel, chine, low]}", "between 2 edges, not 3"},
        {"{developable: [keel, back]}", "run against each other"},
        {"{developable: [keel, keel]}", "the edges touch at"},
        {"{developable: [keel, chine], warp: 0 deg}", "the warp is 0"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, &design);
        if (status == BATTEN_OUT_OF_MEMORY)
            status = evaluate(rows[i].feature, &design);
        CHECK(status != BATTEN_OK);
        if (status != BATTEN_OUT_OF_MEMORY)
            CHECK_MESSAGE(rows[i].message);
    }
}
