/* Triangles of the bodies in files of many programs: without gaps where bodies have none. */
#include <batten/exchange.h>
#include <math.h>

#include "support/json.h"

typedef struct {
    int bodies, watertight, failed;
    double area, volume; /* as they are measured, when they are */
    double meshed_area, meshed_volume;
} sums;

static void add(const batten_object *object, bool measured, double mm, sums *sum)
{
    batten_body *body = NULL;
    batten_body_measures m = {0};
    batten_mesh *mesh = NULL;
    batten_mesh_report report = {0};
    batten_mesh_facts facts;
    if (object->kind == BATTEN_OBJECT_SURFACE)
        CHECK_OK(batten_body_from_surface("", object->surface, 1e-6, &body));
    else if (object->kind == BATTEN_OBJECT_BODY)
        body = batten_body_ref(object->body);
    else
        return;
    if (measured)
        CHECK_OK(batten_body_measure(body, 1e-3, NULL, &m));
    CHECK_OK(batten_mesh_from_body(body, NULL, NULL, NULL, &report, &mesh));
    CHECK_OK(batten_mesh_check(mesh, &facts));
    CHECK_INT(facts.wrong_edges, 0);
    CHECK_INT(facts.crowded_edges, 0);
    if (facts.is_watertight)
        CHECK_INT(facts.euler % 2, 0);
    sum->bodies++;
    sum->watertight += facts.is_watertight;
    sum->failed += report.failed;
    sum->area += report.failed ? 0 : m.area * mm * mm;
    sum->meshed_area += report.failed ? 0 : facts.area * mm * mm;
    sum->volume += facts.is_watertight ? m.volume * mm * mm * mm : 0;
    sum->meshed_volume += facts.volume * mm * mm * mm;
    CHECK(!m.is_closed || facts.is_watertight || report.failed > 0);
    batten_mesh_unref(mesh);
    batten_body_unref(body);
}

/* Areas and volumes are those of Open CASCADE, in mm; measured where it has none, or where
 * tests/body/real_files.c shows that they are wrong. */
static sums mesh_file(const char *name, const char *published)
{
    batten_model *model = NULL, *flat = NULL;
    const bool measured = !published || !strcmp(name, "step/openvsp.stp");
    sums sum = {0};
    CHECK_OK(batten_read_file(test_data(name), NULL, NULL, NULL, &model));
    CHECK_OK(batten_model_flat(model, &flat));
    const double unit = batten_model_unit_metres(flat), mm = unit > 0 ? 1000 * unit : 1;
    for (int i = 0; i < batten_model_count(flat); i++)
        add(batten_model_object(flat, i), measured, mm, &sum);
    batten_model_unref(flat);
    batten_model_unref(model);
    CHECK(sum.bodies > 0);
    if (!measured) {
        const char *volume = json_try(published, "volume_mm3");
        sum.area = json_number(json_key(published, "area_mm2"));
        sum.volume = volume && sum.watertight > 0 ? json_number(volume) : 0;
    }
    return sum;
}

static const struct {
    const char *file;
    int watertight, failed; /* bodies, faces */
} cases[] = {
    {"step/acis_crankshaft.stp", 1,
     0}, /* an edge runs back along another, beyond its surface */
    {"step/acis_u_joint.stp", 1, 0},
    {"step/autodesk_conical.step", 1, 0},
    {"step/autodesk_periodic.step", 1, 0},
    {"step/catia_block.stp", 1, 0},
    {"step/catia_mainbody_front.stp", 1, 0},
    {"step/catia_sg1.stp", 1, 0},
    {"step/cocreate_io1.stp", 1, 0},
    {"step/component8.step", 1, 0},
    {"step/cube_in.step", 1, 0},
    {"step/cube_m.step", 1, 0},
    {"step/cube_mm.step", 1, 0},
    {"step/datakit_as1.stp", 18, 0},
    {"step/euclid_linkrods.step", 1, 0},
    {"step/euclid_screw.step", 1, 0},
    {"step/femap_multisolids.stp", 5, 0},
    {"step/femap_nozzle.stp", 1, 0},
    {"step/freecad_surface.stp", 0, 0},
    {"step/ideas_dm1.stp", 7, 0},
    {"step/nist_pmi_1.stp", 1, 0},
    {"step/nist_pmi_11.stp", 1, 0},
    {"step/nist_pmi_4.stp", 1, 0},
    {"step/nist_pmi_5.stp", 1, 0},
    {"step/nist_pmi_6.stp", 1, 0},
    {"step/nx_cube.stp", 1, 0},
    {"step/onshape_cube_cylinder.step", 2, 0},
    {"step/openvsp.stp", 0, 0},
    {"step/pipe.step", 0, 0},
    {"step/proe_main_body_front.stp", 1, 0},
    {"step/rhino_plate_mode.stp", 0, 0},
    {"step/smd_2225.stp", 1, 0},
    {"step/solid_56.step", 1, 0},
    {"step/solidworks_AP203.STEP", 1, 0},
    {"step/solidworks_AP214.STEP", 1, 0},
    {"step/solidworks_featuretype.STEP", 1, 0},
    {"step/ug16_io1.stp", 1, 0},
    {"step/ug_io1_nurbs.stp", 1, 0},
    {"wings_blades/D150_wing.igs", 1, 0},
    {"wings_blades/bladex_lower.iges", 0, 0},
    {"wings_blades/bladex_root.iges", 0, 0},
    {"wings_blades/bladex_tip.iges", 0, 0},
    {"wings_blades/bladex_upper.iges", 0, 0},
    {"hull_surfaces/cargo_hull_surface.igs", 0, 0},
    {"iges/euclid_bearing.iges", 0, 0},
    {"iges/euclid_hammer.iges", 0, 0},
    {"iges/femap_multisolids.igs", 5, 0},
    {"iges/femap_nozzle.igs", 1, 0},
    {"iges/gd_wing128.igs", 0, 0},
    {"iges/geomagic_lens.igs", 0, 0},
    {"iges/ideas_cube_bounded_surfaces.igs", 0, 0},
    {"iges/igesio_rounded_cube.igs", 0, 0},
    {"iges/inventor_cube_msbo.igs", 1, 0},
    {"iges/occt_45_faces.iges", 0, 0},
    {"iges/pipe.iges", 0, 0},
    {"iges/pipe_deformed.iges", 0, 0},
    {"iges/pipe_hollow.iges", 0, 0},
    {"iges/pipe_hollow_deformed.iges", 0, 0},
    {"iges/rhino_sphere.igs", 1, 0},
    {"hull_surfaces/ropax_maxsurf.igs", 0, 0},
    {"iges/sot404_package.igs", 0, 0},
    {"g2/BoundedSurface.g2", 0, 0},
    {"g2/bilinear.g2", 0, 0},
    {"g2/cone_sf.g2", 0, 0},
    {"g2/degenerate_sf.g2", 0, 0},
    {"g2/degenerate_triangle.g2", 0, 0},
    {"g2/octant.g2", 0, 0},
    {"g2/sf_with_holes.g2", 0, 0},
    {"g2/sphere.g2", 1, 0},
    {"g2/spline_sfs1.g2", 0, 0},
    {"g2/spline_surface_1.g2", 0, 0},
    {"g2/squarecubic.g2", 0, 0},
    {"g2/surf_rev.g2", 0, 0},
    {"g2/surface.g2", 0, 0},
    {"g2/test_bezier.g2", 0, 0},
    {"g2/test_bounded_sf_1.g2", 0, 0},
    {"g2/trimmed_parts.g2", 0, 2}, /* loops whose masters cross themselves */
    {"g2/trimmed_sfs.g2", 0, 0},
};

/* A chord of 1e-3 of the size is a large part of thin or small rounds: the screw and the
 * nozzle's wall lose 0.8 % of their volume. */
TEST(bodies_of_many_programs_have_meshes_of_their_area_and_volume)
{
    const char *all = json_file("peer_tests/occt_facts.json");
    for (int i = 0; i < test_cases(COUNT(cases)) && i < COUNT(cases); i++) {
        const sums s = mesh_file(cases[i].file, json_try(all, cases[i].file));
        CHECK_INT(s.watertight, cases[i].watertight);
        CHECK_INT(s.failed, cases[i].failed);
        if (s.area > 0)
            CHECK_NEAR(s.meshed_area / s.area, 1, 8e-3);
        if (s.volume > 0)
            CHECK_NEAR(s.meshed_volume / s.volume, 1, 1e-2);
    }
}

/* What became of the bodies of a file, made larger. */
typedef struct {
    int bodies, watertight, failed, triangles;
} outcome;

static outcome mesh_larger(const batten_model *flat, double factor)
{
    const batten_affine map = {.m = {{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}}};
    outcome sum = {0};
    for (int i = 0; i < batten_model_count(flat); i++) {
        batten_body *body = NULL;
        batten_mesh *mesh = NULL;
        batten_mesh_report report = {0};
        batten_mesh_facts facts;
        CHECK_OK(batten_body_transform(batten_model_object(flat, i)->body, &map, &body));
        CHECK_OK(batten_mesh_from_body(body, NULL, NULL, NULL, &report, &mesh));
        CHECK_OK(batten_mesh_check(mesh, &facts));
        sum.bodies++;
        sum.watertight += facts.is_watertight;
        sum.failed += report.failed;
        sum.triangles += batten_mesh_view(mesh)->triangle_count;
        batten_mesh_unref(mesh);
        batten_body_unref(body);
    }
    return sum;
}

/* All tolerances go with the size: by a power of two nothing changes at all; by another factor
 * rounding does, and with it how many triangles there are, but no face is lost. */
TEST(the_unit_does_not_change_which_faces_are_meshed)
{
    static const double factors[] = {1024, 1000, 1 / 0.0254, 1 / 0.3048};
    batten_model *model = NULL, *flat = NULL;
    CHECK_OK(
        batten_read_file(test_data("step/femap_multisolids.stp"), NULL, NULL, NULL, &model));
    CHECK_OK(batten_model_flat(model, &flat));
    const outcome as_is = mesh_larger(flat, 1);
    CHECK_INT(as_is.bodies, 5);
    for (size_t i = 0; i < COUNT(factors); i++) {
        const outcome larger = mesh_larger(flat, factors[i]);
        CHECK_INT(larger.watertight, 5);
        CHECK_INT(larger.failed, 0);
        if (factors[i] == 1024)
            CHECK_INT(larger.triangles, as_is.triangles);
    }
    batten_model_unref(flat);
    batten_model_unref(model);
}
