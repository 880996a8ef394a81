#include "design/evaluate.h"

/* What the sweeps below are made from. */
static const char common[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  ring: {circle: 1}\n  oval: {ellipse: 2, b: 1}\n"
    "  wall: {line: [[1, 0, 0], [2, 0, 3]]}\n  across: {line: [[-1, 0, 0], [2, 0, 3]]}\n"
    "  upright: {line: [[0, 0, 0], [0, 0, 3]]}\n"
    "  tilted: {line: [[1, 1, 0], [2, 0, 3]]}\n"
    "  q: {points: [[0, 0, 0], [1, 2, 0], [3, 2, 1]]}\n  bend: {interpolate: q}\n"
    "  both: {collect: [wall, tilted]}\n"
    "  r: {points: [[0, 0, 0], [4, 1, 0], [8, 0, 1]]}\n  far: {interpolate: r}\n"
    "  above: {move: far, by: [0, 0, 2]}\n"
    "  corner: {polyline: [[0, 0, 0], [4, 0, 0], [4, 4, 1]]}\n"
    "  bow: {arc: 1, angle: 90 deg}\n";

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[4000];
    snprintf(text, sizeof text, "%s  a: %s\n", common, feature);
    return evaluate_design(text, "a", NULL, out);
}

TEST(features_of_sweeps_make_surfaces)
{
    static const struct {
        const char *feature;
        int count;
    } rows[] = {
        {"{translational: wall, path: bend}", 1},
        {"{translational: both, path: bend}", 2},
        {"{swing: wall, path: oval}", 1},
        {"{swing: wall, path: ring, factor: 0.5}", 1},
        {"{tabulate: bend, to: 1}", 1},
        {"{tabulate: both, direction: [0, 1, 0], from: -1, to: 1}", 2},
        {"{cone-to: oval, apex: [0, 0, 2]}", 1},
        {"{ruled: [wall, bend], match: length}", 1},
        {"{ruled: [wall, bend]}", 1},
        {"{ellipsoid: [1, 2, 3]}", 1},
        {"{paraboloid: 1, height: 2}", 1},
        {"{hyperboloid: [1, 2, 3], heights: [-1, 2]}", 1},
        {"{bilinear: [[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1]]}", 1},
        {"{sweep: ring, path: far, scale: 0.2, within: 1 mm}", 1},
        {"{sweep: ring, path: far, scale: [0.2, 0.1], scale-y: [0.1, 0.2, 0.1], "
         "twist: [0, 1 rad], x-axis: y, within: 1 mm}",
         1},
        {"{sweep: ring, path: far, up: z, scale: 0.2, within: 1 mm, degree: 5}", 1},
        {"{sweep: ring, path: far, guide: above, scale: 0.2, within: 1 mm}", 1},
        {"{sweep: [ring, oval, ring], path: far, scale: 0.2, at: [0, 0.3, 1], within: 1 mm}",
         1},
        {"{sweep: ring, path: corner, corners: mitre, scale: 0.2, within: 1 mm}", 1},
        {"{sweep: ring, path: corner, corners: split, scale: 0.2, within: 1 mm}", 2},
        {"{sweep: oval, path: ring, folds: yes, within: 1 mm}", 1},
        {"{pipe: far, radius: 30 cm, within: 1 mm}", 1},
        {"{pipe: ring, radius: 30 cm, within: 1 mm}", 1},
        {"{pipe: corner, radius: 30 cm, corners: split, within: 1 mm}", 2},
        {"{helical: wall, pitch: -2, turns: 2, within: 1 mm}", 1},
        {"{two-rails: [far, above], section: bow, within: 1 mm}", 1},
        {"{two-rails: [far, above], section: bow, within: 1 mm, match: length, height: fixed}",
         1},
        {"{two-rails: [far, above], section: bow, within: 1 mm, match: planes, across: x}", 1},
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
        {"{swing: tilted, path: ring}", "of the profile has y = 1"},
        {"{swing: wall, path: ring, factor: 0}", "the factor is 0"},
        {"{tabulate: wall, to: -1}", "the lines begin at 0 and end at -1"},
        {"{tabulate: wall, to: 1, direction: origin}", "'direction' is 0"},
        {"{ruled: [wall, bend, ring], match: length}", "between 2 curves, not 3"},
        {"{skin: [ring, oval], spine: both}", "'spine' is one curve, not 2"},
        {"{bilinear: [[0, 0, 0], [1, 0, 1], [1, 1, 0]]}", "has 4 corners, not 3"},
        {"{ellipsoid: [1, 0, 3]}", "the half axis along y is 0"},
        {"{paraboloid: -1, height: 2}", "the half axis along x is -1"},
        {"{sweep: ring, path: far, scale: [1, -1]}", "it must stay above 0"},
        {"{sweep: [ring, oval], path: far, at: [0, 0.5, 1]}", "'at' has 3 values for 2"},
        {"{sweep: [ring, oval], path: far, at: [0, 0.5]}", "not from 0 to 1"},
        {"{sweep: ring, path: corner}", "the spine has a corner of"},
        {"{sweep: oval, path: ring}", "the sections run into each other from"},
        {"{sweep: ring, path: far, scale-y: 1}", "and none in x"},
        {"{sweep: ring, path: far, up: z, guide: above}", "both upward and at a guide"},
        {"{pipe: ring, radius: 2}", "the sections run into each other from"},
        {"{pipe: far, radius: 0}", "radius"},
        {"{helical: wall, pitch: 1, turns: 0}", "the angle is 0"},
        {"{helical: wall, pitch: 1, axis: origin}", "'axis' is 0"},
        {"{two-rails: [far, above, wall], section: bow}", "2 rails are needed, not 3"},
        {"{two-rails: [far, far], section: bow}", "the rails coincide"},
        {"{helical: wall, pitch: 1e300, within: 1 mm}", "the sweep cannot be within 0.001"},
        {"{tabulate: upright, to: 1}", "the curve lies along its lines"},
        {"{translational: wall, path: wall}", "the curve and the path lie along one line"},
        {"{cone-to: upright, apex: [0, 0, 2]}", "on a line through the apex"},
        {"{swing: upright, path: ring}", "the profile lies on the axis"},
        {"{sweep: ring, path: far, scale: [1, 0, 1]}", "the scale is 0 at 0.5 of the spine"},
        {"{two-rails: [far, above], section: ring}", "begins and ends in the same place"},
        {"{two-rails: [far, above], section: wall}",
         "begins at z = 0 and ends at z = 3: its chord is laid from rail to rail"},
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

TEST(sweeps_say_that_a_section_leaves_its_plane)
{
    static const struct {
        const char *feature;
        bool says;
    } rows[] = {{"{sweep: bend, path: far, scale: 0.1, within: 1 mm}", true},
                {"{sweep: ring, path: far, scale: 0.2, within: 1 mm}", false},
                {"{two-rails: [far, above], section: bow, within: 1 mm}", false}};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[4000];
        batten_design *design = NULL;
        batten_notes *notes = NULL;
        snprintf(text, sizeof text, "%s  a: %s\n", common, rows[i].feature);
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(evaluate_design(text, "a", notes, &design));
        bool said = rows[i].says && batten_notes_dropped(notes) > 0; /* where memory failed */
        for (int k = 0; k < batten_notes_count(notes); k++)
            said |= strstr(batten_notes_at(notes, k)->text,
                           "a space curve in the moving frame: its z, from") != NULL;
        CHECK(said == rows[i].says);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}
