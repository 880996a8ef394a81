/* The feature 'mesh': triangles of surfaces and bodies. */
#include "base/plural.h"
#include "design/feature.h"
#include <batten/mesh.h>

static const batten_parameter parameters[] = {
    {"mesh", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "surfaces, triangles, bodies"},
    {"chord", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far triangles may be from the shape; 1/1000 of its size by default"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "20 deg", NULL,
     "between the normals at the ends of an edge"},
    {"longest", BATTEN_VALUE_LENGTH, false, false, "0", NULL, "edge; 0: any"},
    {"most", BATTEN_VALUE_COUNT, false, false, "10000000", NULL,
     "triangles; more are refused before the work"},
};

static batten_status mesh_shape(const bat_run *run, const batten_object *object,
                                const batten_mesh_options *options, batten_mesh_report *report,
                                batten_mesh **out)
{
    if (object->kind == BATTEN_OBJECT_SURFACE)
        return batten_mesh_from_surface(object->surface, options, run->job, report, out);
    if (object->kind == BATTEN_OBJECT_TRIANGLES)
        return batten_mesh_from_triangles(object->triangles, options, run->job, report, out);
    return batten_mesh_from_body(object->body, options, run->job, run->notes, report, out);
}

static void report_mesh(bat_run *run, const batten_object *object, const batten_mesh *mesh,
                        const batten_mesh_report *report)
{
    const int count = batten_mesh_view(mesh)->triangle_count;
    bat_remark(run, "'%.60s': %d triangle%s, at most %g from the shape", object->name, count,
               bat_plural(count), report->chord);
    bat_report_error(run, report->chord, report->chord);
    if (report->failed > 0)
        bat_note(run, "'%.60s': %d face%s not in the mesh", object->name, report->failed,
                 bat_one_or_many(report->failed, " is", "s are"));
    if (report->beyond > 0)
        bat_note(
            run,
            "'%.60s': %d triangle%s %s up to %g from the shape, more than 'chord', %g; edges "
            "there are up to %g off their faces",
            object->name, report->beyond, bat_plural(report->beyond),
            bat_one_or_many(report->beyond, "is", "are"), report->chord, report->asked,
            report->error);
}

static batten_status add_mesh(bat_run *run, const batten_object *object,
                              const batten_mesh_options *options)
{
    batten_object made = *object;
    batten_mesh_report report = {.failed = 0};
    batten_mesh *mesh = NULL;
    batten_status status = mesh_shape(run, object, options, &report, &mesh);
    if (status != BATTEN_OK)
        return bat_fail(status, "'%.60s': %s", object->name, batten_message());
    made.kind = BATTEN_OBJECT_MESH;
    made.surface = NULL;
    made.triangles = NULL;
    made.body = NULL;
    made.mesh = mesh;
    status = bat_add(run, &made);
    if (status == BATTEN_OK)
        report_mesh(run, object, mesh, &report);
    batten_mesh_unref(mesh);
    return status;
}

static batten_status run_mesh(bat_run *run)
{
    batten_mesh_options options = batten_mesh_defaults();
    bat_objects shapes;
    if (bat_has(run, "chord"))
        options.chord = bat_number(run, "chord");
    options.angle = bat_number(run, "angle");
    options.longest = bat_number(run, "longest");
    options.most = bat_count(run, "most");
    batten_status status =
        bat_gather(run, "mesh", BAT_SURFACES | BAT_TRIANGLES | BAT_BODIES, &shapes);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < shapes.count && status == BATTEN_OK; i++)
        status = add_mesh(run, shapes.at[i], &options);
    bat_objects_release(&shapes);
    return status;
}

const bat_feature bat_feature_mesh = {
    .shown =
        {"mesh", "Triangles of surfaces and bodies",
         "One mesh for each shape. Triangles are no farther from the shape than 'chord', measured\n"
         "at samples of each; the largest distance is reported. Faces of a body that share an edge\n"
         "share its vertices, so that the mesh of a solid is closed. Normals are those of the\n"
         "shape.",
         "features:\n"
         "  ball: {sphere: 1 m}\n"
         "  facets: {mesh: ball, chord: 1 cm}\n",
         "[FMM86]", "batten_mesh_from_body", BAT_PARAMETERS(parameters), false,
         .also = "tessellate, triangulate, STL, facets"},
    .run = run_mesh};
