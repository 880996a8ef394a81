#include "design/block.h"

#include <batten/measure.h>

/* Edges, faces and meshes of bodies. */

static const double pi = 3.14159265358979323846;

static batten_design *evaluate(const char *feature, batten_notes *notes)
{
    char features[300];
    batten_design *design = NULL;
    snprintf(features, sizeof features, "  a: %s\n", feature);
    CHECK_OK(open_with_block(features, notes, &design));
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
    CHECK_OK(open_with_block("  a: {mesh: ball, chord: 1 um, most: 1000}\n", NULL, &design));
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
    CHECK_OK(open_with_block("  a: {edges: block, which: free}\n", NULL, &design));
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
    for (int i = 0; i < 8; i++) {
        CHECK_INT(batten_model_object(result(design), i)->kind, BATTEN_OBJECT_SURFACE);
        CHECK_INT(batten_model_object(result(design), i)->has_colour, i == 5);
    }
    CHECK(batten_model_find(result(design), "block.6 top") == 5);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(batten_model_object(result(design), 5)->colour[k], 1 - 0.5 * k, 1e-12);
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
