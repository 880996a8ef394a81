/* STEP files of many systems against what Open CASCADE found in them. */
#include <batten/exchange.h>

#include "support/json.h"
#include "support/test.h"

typedef struct {
    int solids, faces, edges;
} facts;

/* A surface that is no body is a face with four edges, as others count. */
static facts count(const batten_model *flat)
{
    facts sum = {0, 0, 0};
    for (int i = 0; i < batten_model_count(flat); i++) {
        const batten_object *object = batten_model_object(flat, i);
        sum.faces += object->kind == BATTEN_OBJECT_SURFACE;
        if (object->kind != BATTEN_OBJECT_BODY)
            continue;
        const batten_body_parts *parts = batten_body_view(object->body);
        sum.solids += parts->is_solid;
        sum.faces += parts->face_count;
        sum.edges += parts->edge_count;
    }
    return sum;
}

/* Edges: the EDGE_CURVEs of the file, in an assembly as often as they are placed; Open CASCADE
 * divides some at seams. */
static const struct {
    const char *name;
    int edges;
    double unit;
} files[] = {{"step/acis_crankshaft.stp", 355, 0.0254},
             {"step/acis_u_joint.stp", 312, 0.0254},
             {"step/autodesk_conical.step", 8, 0.0254},
             {"step/autodesk_periodic.step", 4, 0.001},
             {"step/catia_block.stp", 1580, 0.001},
             {"step/catia_mainbody_front.stp", 44, 0.0254},
             {"step/catia_sg1.stp", 32, 0.001},
             {"step/cocreate_io1.stp", 70, 0.001},
             {"step/component8.step", 48, 0.001},
             {"step/cube_in.step", 12, 0.0254},
             {"step/cube_m.step", 12, 1},
             {"step/cube_mm.step", 12, 0.001},
             {"step/datakit_as1.stp", 354, 0.001},
             {"step/euclid_linkrods.step", 108, 0.001},
             {"step/euclid_screw.step", 22, 0.001},
             {"step/femap_multisolids.stp", 208, 1},
             {"step/femap_nozzle.stp", 26, 0.001},
             {"step/freecad_surface.stp", 0, 0.001},
             {"step/ideas_dm1.stp", 93, 0.0254},
             {"step/nist_pmi_1.stp", 310, 0.001},
             {"step/nist_pmi_11.stp", 26, 0.001},
             {"step/nist_pmi_4.stp", 1156, 0.001},
             {"step/nist_pmi_5.stp", 416, 0.0254},
             {"step/nist_pmi_6.stp", 456, 0.0254},
             {"step/nx_cube.stp", 12, 0.001},
             {"step/onshape_cube_cylinder.step", 14, 1},
             {"step/openvsp.stp", 0, 0.3048},
             {"step/pipe.step", 18, 0.001},
             {"step/proe_main_body_front.stp", 56, 0.01},
             {"step/rhino_plate_mode.stp", 16, 1},
             {"step/smd_2225.stp", 117, 0.001},
             {"step/solid_56.step", 102, 0.001},
             {"step/solidworks_AP203.STEP", 84, 0.0254},
             {"step/solidworks_AP214.STEP", 84, 0.0254},
             {"step/solidworks_featuretype.STEP", 243, 0.0254},
             {"step/ug16_io1.stp", 23, 0.001},
             {"step/ug_io1_nurbs.stp", 70, 0.001},
             {"wings_blades/T106_turbine.step", 34, 1}};

TEST(published_step_files_are_read_with_all_solids_faces_and_edges)
{
    const char *all = json_file("peer_tests/occt_facts.json");
    for (int k = 0; k < COUNT(files); k++) {
        batten_model *model = NULL, *flat = NULL;
        CHECK_OK(batten_read_file(test_data(files[k].name), NULL, NULL, NULL, &model));
        CHECK_BITS(batten_model_unit_metres(model), files[k].unit);
        CHECK_OK(batten_model_flat(model, &flat));
        const facts found = count(flat);
        const char *published = json_key(all, files[k].name);
        CHECK(published != NULL);
        CHECK_INT(found.solids, (int)json_number(json_key(published, "solids")));
        CHECK_INT(found.faces, (int)json_number(json_key(published, "faces")));
        CHECK_INT(found.edges, files[k].edges);
        batten_model_unref(flat);
        batten_model_unref(model);
    }
}
