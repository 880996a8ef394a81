#include "design/evaluate.h"
#include "support/drilled_box.h"

#include <batten/exchange.h>
#include <batten/measure.h>
#include <stdio.h>

static const double pi = 3.14159265358979323846;

static void write_block(void)
{
    batten_body *body = NULL;
    batten_model *model = NULL;
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "block",
                                                      .layer = "parts",
                                                      .group = "all",
                                                      .kind = BATTEN_OBJECT_BODY,
                                                      .body = body}));
    CHECK_OK(batten_write_file(model, test_scratch("block.step"), NULL, NULL));
    batten_model_unref(model);
    batten_body_unref(body);
}

static batten_status open_features(const char *features, batten_notes *notes,
                                   batten_design **out)
{
    char text[1000];
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("solids.yaml");
    write_block();
    snprintf(text, sizeof text,
             "batten: 1\nfeatures:\n  block: {read: block.step}\n  ball: {sphere: 2}\n"
             "  tank: {cylinder: 1, height: 3}\n%s",
             features);
    return batten_design_parse(text, strlen(text), &options, notes, out);
}

static batten_design *evaluate(const char *feature, batten_notes *notes)
{
    char features[300];
    batten_design *design = NULL;
    snprintf(features, sizeof features, "  a: %s\n", feature);
    CHECK_OK(open_features(features, notes, &design));
    CHECK_OK(batten_design_evaluate(design, "a", NULL, notes));
    return design;
}

static const batten_model *result(const batten_design *design)
{
    return batten_design_result(design, "a")->value;
}

TEST(meshes_come_within_their_chord)
{
    batten_design *design = evaluate("{mesh: [ball, block], chord: 1 mm, longest: 0.5}", NULL);
    batten_mesh_facts facts;
    CHECK_INT(batten_model_count(result(design)), 2);
    CHECK(batten_design_result(design, "a")->error_max <= 1e-3);
    CHECK_OK(batten_mesh_check(batten_model_object(result(design), 0)->mesh, &facts));
    CHECK(facts.is_watertight);
    CHECK_NEAR(facts.volume, 32 * pi / 3, 16 * pi * 1e-3);
    CHECK_OK(batten_mesh_check(batten_model_object(result(design), 1)->mesh, &facts));
    CHECK(facts.is_watertight);
    CHECK_NEAR(facts.volume, 48 - 2 * pi, 4 * pi * 1e-3);
    CHECK_TEXT(batten_model_object(result(design), 1)->layer, "parts");
    CHECK_TEXT(batten_model_object(result(design), 1)->group, "all");
    batten_design_free(design);
}

TEST(meshes_of_too_many_triangles_are_refused)
{
    batten_design *design = NULL;
    CHECK_OK(open_features("  a: {mesh: ball, chord: 1 um, most: 1000}\n", NULL, &design));
    CHECK_STATUS(batten_design_evaluate(design, "a", NULL, NULL), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("'ball'");
    batten_design_free(design);
}

TEST(edges_are_told_by_their_faces)
{
    static const struct {
        const char *feature;
        int count;
        double length;
    } rows[] = {{"{edges: block}", 18, 4 * (6 + 4 + 2) + 4 + 4 * pi},
                {"{edges: block, which: shared}", 18, 4 * (6 + 4 + 2) + 4 + 4 * pi},
                {"{edges: tank}", 3, 3 + 4 * pi},
                {"{edges: tank, which: free}", 2, 4 * pi},
                {"{edges: tank, which: shared}", 1, 3},
                {"{edges: ball}", 1, 2 * pi}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = evaluate(rows[i].feature, NULL);
        double sum = 0;
        CHECK_INT(batten_model_count(result(design)), rows[i].count);
        for (int k = 0; k < rows[i].count; k++) {
            double length, error;
            CHECK_OK(batten_curve_length(batten_model_object(result(design), k)->curve, 1e-9,
                                         &error, &length));
            sum += length;
        }
        CHECK_NEAR(sum, rows[i].length, 1e-6);
        batten_design_free(design);
    }
    batten_design *design = NULL;
    CHECK_OK(open_features("  a: {edges: block, which: free}\n", NULL, &design));
    CHECK_STATUS(batten_design_evaluate(design, "a", NULL, NULL), BATTEN_NOT_FOUND);
    batten_design_free(design);
}

TEST(faces_are_whole_surfaces_and_say_so)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(50, &notes));
    batten_design *design = evaluate("{faces: block}", notes);
    bool told = false;
    CHECK_INT(batten_model_count(result(design)), 8);
    for (int i = 0; i < 8; i++)
        CHECK_INT(batten_model_object(result(design), i)->kind, BATTEN_OBJECT_SURFACE);
    CHECK(batten_model_find(result(design), "block.6 top") == 5);
    CHECK(batten_model_object(result(design), 5)->has_colour);
    for (int i = 0; i < batten_notes_count(notes); i++)
        told |= strstr(batten_notes_at(notes, i)->text, "2 of 8 faces of 'block' end") != NULL;
    CHECK(told || batten_notes_dropped(notes) > 0);
    /* The wall of the hole is reversed in the file: its normals now point into the hole. */
    double d[9];
    const batten_surface *wall = batten_model_object(result(design), 6)->surface;
    const batten_interval u = batten_surface_domain(wall, BATTEN_U);
    const batten_interval v = batten_surface_domain(wall, BATTEN_V);
    CHECK_OK(batten_surface_evaluate(wall, (u.a + u.b) / 2, (v.a + v.b) / 2, 1, d));
    const double nx = d[4] * d[8] - d[5] * d[7], ny = d[5] * d[6] - d[3] * d[8];
    CHECK(nx * (d[0] - 3) + ny * (d[1] - 2) < 0);
    batten_design_free(design);
    batten_notes_free(notes);
}

static batten_design *report(const char *outputs, char **data)
{
    batten_design *design = NULL;
    size_t size = 0;
    CHECK_OK(open_features(outputs, NULL, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, data, &size));
    return design;
}

static double number(const char *text, const char *key)
{
    const char *at = strstr(text, key);
    CHECK(at != NULL);
    return strtod(at + strlen(key), NULL);
}

TEST(bodies_and_meshes_are_measured)
{
    char *data = NULL;
    const double area = 88 - 2 * pi + 4 * pi;
    batten_design *design = report("outputs:\n  m.json: {measure: block}\n", &data);
    CHECK_CONTAINS(data, "\"type\": \"body\", \"closed\": true");
    CHECK_NEAR(number(data, "\"area\": "), area, 1e-6);
    CHECK_NEAR(number(data, "\"volume\": "), 48 - 2 * pi, 1e-6);
    CHECK_NEAR(number(data, "\"centroid\": ["), 3, 1e-6);
    CHECK_NEAR(number(data, "\"edge_length\": "), 4 * (6 + 4 + 2) + 4 + 4 * pi, 1e-6);
    CHECK_NEAR(number(data, "\"faces\": "), 8, 0);
    batten_release(data);
    batten_design_free(design);
    design = report(
        "  a: {mesh: block, chord: 1 mm}\noutputs:\n  m.txt: {measure: [block, a]}\n", &data);
    CHECK_CONTAINS(data, "block: body, closed, area 94.28318");
    CHECK_CONTAINS(data, "a: mesh, closed, area 94.");
    CHECK_CONTAINS(data, "\n  box 0 0 0  to  6 4 2\n");
    batten_release(data);
    batten_design_free(design);
}

TEST(bodies_and_meshes_are_checked)
{
    char *data = NULL;
    batten_design *design =
        report("  a: {mesh: tank}\noutputs:\n  c.txt: {check: [block, a]}\n", &data);
    CHECK_CONTAINS(data, "18 shared edges");
    CHECK_CONTAINS(data, "not closed; ");
    CHECK_CONTAINS(data, " edges at the rim");
    CHECK(batten_design_output_holds(design, 0));
    batten_release(data);
    batten_design_free(design);
    design = report("outputs:\n  c.json: {check: block, within: 1 mm}\n", &data);
    CHECK_CONTAINS(data, "\"holds\": true");
    CHECK(batten_design_output_holds(design, 0));
    batten_release(data);
    batten_design_free(design);
    design = report("outputs:\n  c.json: {check: block, within: 1e-17}\n", &data);
    CHECK_CONTAINS(data, "\"ok\": false");
    CHECK_CONTAINS(data, "\"holds\": false");
    CHECK(!batten_design_output_holds(design, 0));
    batten_release(data);
    batten_design_free(design);
}
