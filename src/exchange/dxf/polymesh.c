/* Reads polyface meshes: a POLYLINE of vertices and faces. */
#include "base/plural.h"
#include "exchange/dxf/entities.h"
#include "exchange/meshes/indexed.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

/* ---- as its entities say it ---- */

/* Points of a grid; of a grid that is smoothed those of the smooth one count. */
static batten_status read_grid(const bat_dxf_pairs *pairs, int flags,
                               bat_dxf_polyline *polyline)
{
    int smooth = 0;
    batten_status status = bat_dxf_get_integer(pairs, 75, 0, &smooth);
    if (status == BATTEN_OK)
        status = bat_dxf_get_integer(pairs, smooth ? 73 : 71, 0, &polyline->rows);
    if (status == BATTEN_OK)
        status = bat_dxf_get_integer(pairs, smooth ? 74 : 72, 0, &polyline->columns);
    polyline->closed_along = flags & 32;
    return status;
}

batten_status bat_dxf_polymesh_begin(const bat_dxf_pairs *pairs, int flags,
                                     bat_dxf_polyline *polyline)
{
    polyline->is_mesh = flags & (16 | 64);
    polyline->is_polyface = flags & 64;
    polyline->faces.size = sizeof(bat_dxf_face);
    polyline->faces.count = 0;
    return (flags & 16) && !(flags & 64) ? read_grid(pairs, flags, polyline) : BATTEN_OK;
}

/* Corners count from 1; they are negative where the side behind them is not drawn, and 0 where
 * there is none. */
batten_status bat_dxf_polymesh_face(const bat_dxf_pairs *pairs, bat_dxf_polyline *polyline)
{
    bat_dxf_face face = {.line = bat_dxf_find(pairs, 0)->line};
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 4; k++)
        status = bat_dxf_get_integer(pairs, 71 + k, 0, &face.corners[k]);
    return status == BATTEN_OK ? bat_list_add(pairs->input, &polyline->faces, &face) : status;
}

/* ---- as a mesh ---- */

/* A corner that is that before it once more is none. */
static batten_status add_corner(bat_indexed *mesh, int64_t corner)
{
    const int64_t *corners = mesh->polygon.items;
    const size_t count = mesh->polygon.count;
    if (count > 0 && (corners[count - 1] == corner || corners[0] == corner))
        return BATTEN_OK;
    return bat_list_add(mesh->input, &mesh->polygon, &corner);
}

static batten_status add_polygon(bat_indexed *mesh, const int64_t corners[4], int line)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 4; k++)
        if (corners[k] >= 0)
            status = add_corner(mesh, corners[k]);
    return status == BATTEN_OK ? bat_indexed_polygon(mesh, line) : status;
}

static batten_status add_faces(const bat_dxf_polyline *polyline, bat_indexed *mesh)
{
    const bat_dxf_face *faces = polyline->faces.items;
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < polyline->faces.count; i++) {
        int64_t corners[4];
        for (int k = 0; k < 4; k++)
            corners[k] = llabs((long long)faces[i].corners[k]) - 1;
        status = add_polygon(mesh, corners, faces[i].line);
    }
    return status;
}

static batten_status add_grid(const bat_dxf_polyline *polyline, bat_indexed *mesh)
{
    const int64_t rows = polyline->rows, columns = polyline->columns;
    if (rows < 2 || columns < 2 || rows * columns != (int64_t)mesh->count)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "it has %zu points where its grid of %d x %d needs "
                        "another count",
                        mesh->count, polyline->rows, polyline->columns);
    batten_status status = BATTEN_OK;
    for (int64_t i = 0; i < rows - !polyline->closed; i++)
        for (int64_t j = 0; status == BATTEN_OK && j < columns - !polyline->closed_along; j++) {
            const int64_t here = i * columns, next = (i + 1) % rows * columns;
            const int64_t beside = (j + 1) % columns;
            const int64_t corners[4] = {here + j, next + j, next + beside, here + beside};
            status = add_polygon(mesh, corners, polyline->line);
        }
    return status;
}

static batten_status fill(const bat_dxf_polyline *polyline, const char *name, bat_indexed *mesh,
                          batten_model *model)
{
    const double *vertices = polyline->vertices.items;
    const size_t count = polyline->vertices.count;
    batten_status status =
        bat_input_array(mesh->input, count, 3 * sizeof(double), &mesh->points);
    for (size_t i = 0; status == BATTEN_OK && i < 3 * count; i++)
        mesh->points[i] = vertices[i / 3 * 4 + i % 3];
    mesh->count = count;
    if (status == BATTEN_OK)
        status = polyline->is_polyface ? add_faces(polyline, mesh) : add_grid(polyline, mesh);
    if (status == BATTEN_OK && mesh->triangles.count == 0)
        status = bat_fail(BATTEN_BAD_FORMAT, "it is a mesh, and its %zu face%s not valid",
                          mesh->polygons, bat_one_or_many(mesh->polygons, " is", "s are"));
    return status == BATTEN_OK ? bat_indexed_add(mesh, name, model) : status;
}

batten_status bat_dxf_polymesh(bat_input *input, const bat_dxf_polyline *polyline,
                               const char *name, batten_mesh **out)
{
    bat_indexed mesh = bat_indexed_begin(input);
    batten_model *model = NULL;
    batten_status status = batten_model_create(0, &model);
    if (status == BATTEN_OK)
        status = fill(polyline, name, &mesh, model);
    if (status == BATTEN_OK)
        *out = batten_mesh_ref(batten_model_object(model, 0)->mesh);
    bat_indexed_end(&mesh);
    batten_model_unref(model);
    return status;
}
