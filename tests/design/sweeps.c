#include "support/test.h"

#include <batten/design.h>
#include <string.h>

/* What the sweeps below are made from. */
static const char common[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  ring: {circle: 1}\n  oval: {ellipse: 2, b: 1}\n"
    "  wall: {line: [[1, 0, 0], [2, 0, 3]]}\n  across: {line: [[-1, 0, 0], [2, 0, 3]]}\n"
    "  tilted: {line: [[1, 1, 0], [2, 0, 3]]}\n"
    "  q: {points: [[0, 0, 0], [1, 2, 0], [3, 2, 1]]}\n  bend: {interpolate: q}\n"
    "  both: {collect: [wall, tilted]}\n";

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  a: %s\n", common, feature);
    batten_design *design = NULL;
    batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, "a", NULL, NULL);
    if (status == BATTEN_OK)
        *out = design;
    else
        batten_design_free(design);
    return status;
}

TEST(features_of_sweeps_make_surfaces)
{
    static const struct {
        const char *feature;
        int count;
    } rows[] = {
        {"{translational: wall, path: bend}", 1},
        {"{translational: both, path: bend}", 2},
        {"{swing: wall, along: oval}", 1},
        {"{swing: wall, along: ring, factor: 0.5}", 1},
        {"{tabulate: bend, to: 1}", 1},
        {"{tabulate: both, direction: [0, 1, 0], from: -1, to: 1}", 2},
        {"{cone-to: oval, apex: [0, 0, 2]}", 1},
        {"{ruled: [wall, bend], match: length}", 1},
        {"{ruled: [wall, bend]}", 1},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(rows[i].feature, &design));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_model_count(model), rows[i].count);
        CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_SURFACE);
        batten_design_free(design);
    }
}

TEST(features_of_sweeps_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{translational: wall, path: both}", "'path' is one curve, not 2"},
        {"{swing: tilted, along: ring}", "of the profile has y = 1"},
        {"{swing: wall, along: ring, factor: 0}", "the factor is 0"},
        {"{tabulate: wall, to: -1}", "the lines begin at 0 and end at -1"},
        {"{tabulate: wall, to: 1, direction: origin}", "'direction' is 0"},
        {"{ruled: [wall, bend, ring], match: length}", "between 2 curves, not 3"},
        {"{skin: [ring, oval], spine: both}", "'spine' is one curve, not 2"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, &design);
        if (status == BATTEN_OUT_OF_MEMORY)
            status = evaluate(rows[i].feature, &design);
        CHECK(status != BATTEN_OK);
        if (status != BATTEN_OUT_OF_MEMORY)
            CHECK_MESSAGE(rows[i].says);
    }
}
