/* Areas, volumes and lengths of files of many programs, against what another kernel finds. */
#include "support/test.h"

#include <batten/body.h>
#include <batten/exchange.h>
#include <batten/model.h>
#include <stdlib.h>

typedef struct {
    int bodies, closed;
    double area, volume, length; /* mm */
} sums;

static bool measure_file(const char *path, sums *out)
{
    batten_model *model = NULL, *flat = NULL;
    *out = (sums){0};
    CHECK_OK(batten_read_file(path, NULL, NULL, NULL, &model));
    CHECK_OK(batten_model_flat(model, &flat));
    const double mm = 1000 * batten_model_unit_metres(flat);
    for (int i = 0; i < batten_model_count(flat); i++) {
        const batten_object *object = batten_model_object(flat, i);
        batten_body_measures m;
        if (object->kind != BATTEN_OBJECT_BODY)
            continue;
        CHECK_OK(batten_body_measure(object->body, 1e-6, NULL, &m));
        out->bodies++;
        out->closed += m.is_closed;
        out->area += m.area * mm * mm;
        out->volume += m.volume * mm * mm * mm;
        out->length += m.edge_length * mm;
    }
    batten_model_unref(flat);
    batten_model_unref(model);
    return out->bodies > 0;
}

/* The first number of this key behind the name of the file. */
static double fact(const char *facts, const char *file, const char *key)
{
    char quoted[96];
    snprintf(quoted, sizeof quoted, "\"%s\": {", file);
    const char *entry = strstr(facts, quoted);
    CHECK(entry != NULL);
    snprintf(quoted, sizeof quoted, "\"%s\": ", key);
    const char *at = strstr(entry, quoted);
    CHECK(at != NULL);
    return strtod(at + strlen(quoted), NULL);
}

static const char *read_facts(void)
{
    FILE *file = fopen(test_data("peer_tests/occt_facts.json"), "rb");
    CHECK(file != NULL);
    char *text = test_array(1 << 20, 1);
    text[fread(text, 1, (1 << 20) - 1, file)] = 0;
    fclose(file);
    return text;
}

/* Planes, cylinders, cones and spheres: both kernels are exact but for what edges miss. Free
 * surfaces, and tori by integration there: as near as the other integrates, 0.3 % at most. */
static const struct {
    const char *file;
    double area, volume;
    bool has_length; /* the other counts each edge once too */
} cases[] = {
    {"step/cube_in.step", 1e-12, 1e-12, true},
    {"step/cube_m.step", 1e-12, 1e-12, true},
    {"step/cube_mm.step", 1e-12, 1e-12, true},
    {"step/nx_cube.stp", 1e-12, 1e-12, true},
    {"step/autodesk_conical.step", 1e-8, 1e-8, true},
    {"step/catia_sg1.stp", 1e-8, 1e-8, true},
    {"step/cocreate_io1.stp", 1e-8, 1e-8, true},
    {"step/onshape_cube_cylinder.step", 1e-8, 1e-8, false}, /* a seam less */
    {"step/solidworks_AP203.STEP", 1e-8, 1e-8, true},
    {"step/smd_2225.stp", 1e-6, 1e-6, true},
    {"step/component8.step", 1e-3, 1e-3, true},
    {"step/femap_nozzle.stp", 1e-4, 1e-4, true},
    {"step/ug_io1_nurbs.stp", 3e-4, 3e-4, false}, /* seams less */
    {"step/nist_pmi_1.stp", 3e-3, 3e-3, true},
    {"step/nist_pmi_11.stp", 3e-3, 3e-3, true},
    {"step/ideas_dm1.stp", 3e-3, 3e-3, true},
    {"step/solid_56.step", 1e-4, 1e-4, true}, /* its edges miss by ten times what it states */
};

TEST(solids_of_many_programs_have_the_measures_that_another_kernel_finds)
{
    const char *facts = read_facts();
    for (int i = 0; i < test_cases(COUNT(cases)) && i < COUNT(cases); i++) {
        sums s;
        CHECK(measure_file(test_data(cases[i].file), &s));
        CHECK_INT(s.closed, s.bodies);
        CHECK_NEAR(s.area / fact(facts, cases[i].file, "area_mm2"), 1, cases[i].area);
        CHECK_NEAR(s.volume / fact(facts, cases[i].file, "volume_mm3"), 1, cases[i].volume);
        if (cases[i].has_length)
            CHECK_NEAR(s.length / fact(facts, cases[i].file, "edge_length_mm"), 1, 1e-6);
    }
}
