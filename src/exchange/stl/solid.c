/* One solid of an STL file while its triangles are read, and the mesh that it becomes. */
#include "exchange/meshes/facets.h"
#include "exchange/stl/stl.h"

#include <limits.h>

batten_status bat_stl_add(bat_stl_solid *solid, int line, size_t index, const double corners[9],
                          const double normal[3])
{
    bat_input *input = solid->input;
    const size_t bad = bat_first_not_finite(corners, 9);
    if (bad < 9) {
        batten_notes_add(input->notes, input->file, line, "",
                         "triangle %zu is left out: %c of its corner %zu is not finite",
                         index + 1, "xyz"[bad % 3], bad / 3 + 1);
        input->left_out++;
        return BATTEN_OK;
    }
    double n[3];
    bat_facet_normal(corners, corners + 3, corners + 6, n);
    if (n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2] < 0)
        solid->against++;
    const size_t most =
        input->limits.entities < INT_MAX / 3 ? input->limits.entities : (size_t)INT_MAX / 3;
    batten_status status =
        bat_input_limit(input, line, solid->points.count + 1, most, "triangles");
    return status == BATTEN_OK ? bat_list_add(input, &solid->points, corners) : status;
}

static batten_status make_mesh(bat_stl_solid *solid, batten_mesh **out)
{
    const size_t count = solid->points.count;
    int *corners = NULL;
    batten_mesh *loose = NULL;
    batten_status status = bat_input_array(solid->input, 3 * count, sizeof *corners, &corners);
    if (status != BATTEN_OK)
        return status;
    for (size_t i = 0; i < 3 * count; i++)
        corners[i] = (int)i;
    const batten_mesh_parts parts = {.vertex_count = (int)(3 * count),
                                     .points = solid->points.items,
                                     .triangle_count = (int)count,
                                     .corners = corners};
    status = batten_mesh_create(&parts, &loose);
    bat_release(corners);
    if (status == BATTEN_OK)
        status = batten_mesh_weld(loose, out);
    batten_mesh_unref(loose);
    return status;
}

batten_status bat_stl_end(bat_stl_solid *solid, const char *name, batten_model *model)
{
    bat_input *input = solid->input;
    batten_mesh *mesh = NULL;
    if (solid->points.count == 0)
        return BATTEN_OK;
    batten_status status = bat_input_limit(input, 0, (size_t)batten_model_count(model) + 1,
                                           input->limits.entities, "solids");
    if (status == BATTEN_OK)
        status = make_mesh(solid, &mesh);
    if (status == BATTEN_OK)
        status = batten_model_add(
            model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_MESH, .mesh = mesh});
    if (status == BATTEN_OK)
        bat_remark_flat(mesh, input->file, name, input->notes);
    if (status == BATTEN_OK && solid->against)
        batten_notes_add(input->notes, input->file, 0, name,
                         "the normals of %d of %zu triangles contradict the order of their "
                         "corners; the order is kept",
                         solid->against, solid->points.count);
    batten_mesh_unref(mesh);
    solid->points.count = 0;
    solid->against = 0;
    return status;
}
