#include "design/block.h"

#include <stdlib.h>

/* Reports of bodies and meshes. */

static const double pi = 3.14159265358979323846;

static batten_design *report(const char *outputs, char **data)
{
    batten_design *design = NULL;
    size_t size = 0;
    CHECK_OK(open_with_block(outputs, NULL, &design));
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

/* A bound makes what is open a fault, which a note names. */
TEST(faults_beyond_a_bound_are_noted_by_the_name_of_what_has_them)
{
    static const struct {
        const char *outputs, *note;
    } rows[] = {
        {"outputs:\n  c.txt: {check: block, within: 1e-17}\n",
         "'block' has faults beyond 1e-17"},
        {"  a: {mesh: tank}\noutputs:\n  c.txt: {check: a, within: 1 mm}\n",
         "'a' is a mesh that is not closed"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        char *data = NULL;
        size_t size = 0;
        bool found = false;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(open_with_block(rows[i].outputs, NULL, &design));
        CHECK_OK(batten_design_output(design, 0, NULL, notes, &data, &size));
        for (int k = 0; k < batten_notes_count(notes); k++)
            found |= strstr(batten_notes_at(notes, k)->text, rows[i].note) != NULL;
        CHECK(found || batten_notes_dropped(notes));
        CHECK(!batten_design_output_holds(design, 0));
        batten_release(data);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}
