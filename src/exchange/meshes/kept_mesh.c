/* Drops the colours and values of a mesh that a format cannot keep. */
#include "exchange/meshes/kept_mesh.h"

batten_status bat_mesh_kept(const bat_format_row *row, const batten_object *object,
                            batten_notes *notes, batten_mesh **out)
{
    batten_mesh_parts parts = *batten_mesh_view(object->mesh);
    const bool keeps_all = !row->holds;
    const bool colours = parts.colours && !keeps_all && !(row->keeps & BAT_KEEPS_COLOURS);
    const bool triangles =
        parts.triangle_colours && !keeps_all && !(row->keeps & BAT_KEEPS_TRIANGLE_COLOURS);
    const bool values = parts.attribute_count && !keeps_all && !(row->keeps & BAT_KEEPS_VALUES);
    if (!colours && !triangles && !values) {
        *out = batten_mesh_ref(object->mesh);
        return BATTEN_OK;
    }
    if (colours)
        batten_notes_add(notes, "", 0, object->name,
                         "the colours of its vertices are left out: %s files do not hold them",
                         row->title);
    if (triangles)
        batten_notes_add(notes, "", 0, object->name,
                         "the colours of its faces are left out: %s files do not hold them",
                         row->title);
    if (values)
        batten_notes_add(
            notes, "", 0, object->name,
            "further values of each vertex: %d; left out, as %s files do not hold them",
            parts.attribute_count, row->title);
    parts.colours = colours ? NULL : parts.colours;
    parts.triangle_colours = triangles ? NULL : parts.triangle_colours;
    parts.attribute_count = values ? 0 : parts.attribute_count;
    return batten_mesh_create(&parts, out);
}
