/* Gathers vertices and polygons, with colours, normals and values, into a mesh. */
#include "exchange/meshes/indexed.h"
#include "base/plural.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/scan.h"

#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

bat_indexed bat_indexed_begin(bat_input *input)
{
    return (bat_indexed){.input = input,
                         .attributes = {.size = sizeof(batten_mesh_attribute)},
                         .polygon = {.size = sizeof(int64_t)},
                         .triangles = {.size = 3 * sizeof(int)},
                         .triangle_colours = {.size = 3 * sizeof(double)},
                         .places = {.size = 3 * sizeof(double)},
                         .cut = {.size = 3 * sizeof(int)}};
}

static void release(const void *memory)
{
    bat_release((void *)(uintptr_t)memory);
}

void bat_indexed_end(bat_indexed *mesh)
{
    const batten_mesh_attribute *attributes = mesh->attributes.items;
    for (size_t k = 0; k < mesh->attributes.count; k++) {
        release(attributes[k].name);
        release(attributes[k].values);
    }
    bat_release(mesh->attributes.items);
    bat_release(mesh->points);
    bat_release(mesh->colours);
    bat_release(mesh->normals);
    bat_release(mesh->polygon.items);
    bat_release(mesh->triangles.items);
    bat_release(mesh->triangle_colours.items);
    bat_release(mesh->places.items);
    bat_release(mesh->cut.items);
}

batten_status bat_indexed_attribute(bat_indexed *mesh, bat_span name, double **values)
{
    char *copy = NULL;
    batten_status status = bat_input_array(mesh->input, name.length + 1, 1, &copy);
    if (status != BATTEN_OK)
        return status;
    bat_word_copy(name, name.length + 1, copy);
    const batten_mesh_attribute attribute = {copy, *values};
    status = bat_list_add(mesh->input, &mesh->attributes, &attribute);
    if (status == BATTEN_OK)
        *values = NULL;
    else
        bat_release(copy);
    return status;
}

/* ---- polygons ---- */

static bool is_read(const bat_indexed *mesh, int64_t vertex)
{
    return bat_first_not_finite(mesh->points + 3 * vertex, 3) == 3;
}

/* Are all corners vertices? Else a note. */
static bool check_polygon(bat_indexed *mesh, int line)
{
    const int64_t *corners = mesh->polygon.items;
    const size_t n = mesh->polygon.count;
    bat_input *input = mesh->input;
    size_t k = 0;
    while (k < n && corners[k] >= 0 && (uint64_t)corners[k] < mesh->count &&
           is_read(mesh, corners[k]))
        k++;
    if (n >= 3 && k == n)
        return true;
    if (n < 3)
        batten_notes_add(input->notes, input->file, line, "",
                         "face %zu is left out: it has %zu corner%s", mesh->polygons, n,
                         bat_plural(n));
    else
        batten_notes_add(input->notes, input->file, line, "",
                         "face %zu is left out: its corner %zu is vertex %lld, %s",
                         mesh->polygons, k + 1, (long long)corners[k] + 1,
                         corners[k] >= 0 && (uint64_t)corners[k] < mesh->count
                             ? "which could not be read"
                             : "which does not exist");
    input->left_out++;
    return false;
}

static batten_status add_triangle(bat_indexed *mesh, int line, int64_t a, int64_t b, int64_t c)
{
    const int triangle[3] = {(int)a, (int)b, (int)c};
    const size_t limit = mesh->input->limits.entities;
    batten_status status =
        bat_input_limit(mesh->input, line, mesh->triangles.count + 1,
                        limit < INT_MAX / 3 ? limit : (size_t)INT_MAX / 3, "triangles");
    return status == BATTEN_OK ? bat_list_add(mesh->input, &mesh->triangles, triangle) : status;
}

static batten_status cut_polygon(bat_indexed *mesh, int line)
{
    const int64_t *corners = mesh->polygon.items;
    const size_t n = mesh->polygon.count;
    static const int none[3] = {0, 0, 0};
    bool is_odd = false;
    batten_status status =
        bat_input_limit(mesh->input, line, n, INT_MAX / 4, "corners of a polygon");
    mesh->places.count = mesh->cut.count = 0;
    for (size_t k = 0; status == BATTEN_OK && k < n; k++) {
        status = bat_list_add(mesh->input, &mesh->places, mesh->points + 3 * corners[k]);
        if (status == BATTEN_OK)
            status = bat_list_add(mesh->input, &mesh->cut, none);
    }
    if (status != BATTEN_OK)
        return status;
    int(*cut)[3] = mesh->cut.items;
    bat_polygon_triangles((int)n, mesh->places.items, cut[0], &is_odd);
    mesh->odd += is_odd;
    mesh->cut_up++;
    for (size_t k = 0; status == BATTEN_OK && k + 2 < n; k++)
        status = add_triangle(mesh, line, corners[cut[k][0]], corners[cut[k][1]],
                              corners[cut[k][2]]);
    return status;
}

batten_status bat_indexed_polygon(bat_indexed *mesh, int line)
{
    const int64_t *corners = mesh->polygon.items;
    batten_status status = BATTEN_OK;
    mesh->polygons++;
    if (check_polygon(mesh, line))
        status = mesh->polygon.count == 3
                     ? add_triangle(mesh, line, corners[0], corners[1], corners[2])
                     : cut_polygon(mesh, line);
    mesh->polygon.count = 0;
    return status;
}

void bat_indexed_leave_out(bat_indexed *mesh, int line, size_t index, const char *why)
{
    mesh->polygon.count = 0;
    mesh->polygons++;
    mesh->input->left_out++;
    batten_notes_add(mesh->input->notes, mesh->input->file, line, "",
                     "face %zu is left out: %s", index + 1, why);
}

batten_status bat_indexed_colour(bat_indexed *mesh, const double colour[3])
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && mesh->triangle_colours.count < mesh->triangles.count)
        status = bat_list_add(mesh->input, &mesh->triangle_colours, colour);
    return status;
}

/* ---- what vertices carry ---- */

/* Move the rows of the vertices that were read to the front; rows of `width`. */
static void pack(const bat_indexed *mesh, double *rows, size_t width)
{
    size_t to = 0;
    for (size_t i = 0; rows && i < mesh->count; i++)
        if (is_read(mesh, (int64_t)i))
            memmove(rows + width * to++, rows + width * i, width * sizeof *rows);
}

/* Forget the vertices that could not be read; no triangle has them. */
static batten_status pack_all(bat_indexed *mesh)
{
    size_t read = 0;
    for (size_t i = 0; i < mesh->count; i++)
        read += is_read(mesh, (int64_t)i);
    if (read == mesh->count)
        return BATTEN_OK;
    int *map = NULL;
    batten_status status = bat_input_array(mesh->input, mesh->count, sizeof *map, &map);
    if (status != BATTEN_OK)
        return status;
    int next = 0;
    for (size_t i = 0; i < mesh->count; i++)
        map[i] = is_read(mesh, (int64_t)i) ? next++ : -1;
    int *corners = mesh->triangles.items;
    for (size_t i = 0; i < 3 * mesh->triangles.count; i++)
        corners[i] = map[corners[i]];
    bat_release(map);
    pack(mesh, mesh->colours, 3);
    pack(mesh, mesh->normals, 3);
    const batten_mesh_attribute *attributes = mesh->attributes.items;
    for (size_t k = 0; k < mesh->attributes.count; k++)
        pack(mesh, (double *)(uintptr_t)attributes[k].values, 1);
    pack(mesh, mesh->points, 3); /* last: it says which were read */
    mesh->count = read;
    return BATTEN_OK;
}

/* The first of the numbers that is no part of a colour. */
static size_t first_not_colour(const double *parts, size_t count)
{
    size_t i = 0;
    while (i < count && parts[i] >= 0 && parts[i] <= 1)
        i++;
    return i;
}

static void drop_colours(const bat_indexed *mesh, const char *what, size_t at, double part)
{
    batten_notes_add(mesh->input->notes, mesh->input->file, 0, "",
                     "the colours are left out: part %zu of %s %zu is %g of 1", at % 3 + 1,
                     what, at / 3 + 1, part);
    mesh->input->left_out++;
}

static void check_vertex_colours(bat_indexed *mesh)
{
    const size_t count = 3 * mesh->count;
    const size_t i = mesh->colours ? first_not_colour(mesh->colours, count) : count;
    if (i < count) {
        drop_colours(mesh, "vertex", i, mesh->colours[i]);
        bat_release(mesh->colours);
        mesh->colours = NULL;
    }
}

static void check_triangle_colours(bat_indexed *mesh)
{
    const double *colours = mesh->triangle_colours.items;
    const size_t count = 3 * mesh->triangle_colours.count;
    const size_t i = first_not_colour(colours, count);
    if (i < count) {
        drop_colours(mesh, "triangle", i, colours[i]);
        mesh->triangle_colours.count = 0;
    }
}

/* Drop colours that are not valid, with a note. */
static void check_colours(bat_indexed *mesh)
{
    check_vertex_colours(mesh);
    check_triangle_colours(mesh);
}

/* Normals are unit vectors up to the digits of a file, or 0 where there is none. */
static void check_normals(bat_indexed *mesh)
{
    size_t i = 0;
    for (; mesh->normals && i < mesh->count; i++) {
        const double *n = mesh->normals + 3 * i;
        const double length = bat_hypot(bat_hypot(n[0], n[1]), n[2]);
        if (!(length == 0 || fabs(length - 1) < 1e-3))
            break;
    }
    if (!mesh->normals || i == mesh->count)
        return;
    const double *n = mesh->normals + 3 * i;
    batten_notes_add(mesh->input->notes, mesh->input->file, 0, "",
                     "the normals are left out: that of vertex %zu, (%g, %g, %g), has not the "
                     "length 1",
                     i + 1, n[0], n[1], n[2]);
    mesh->input->left_out++;
    bat_release(mesh->normals);
    mesh->normals = NULL;
}

static void check_attributes(bat_indexed *mesh)
{
    batten_mesh_attribute *attributes = mesh->attributes.items;
    size_t kept = 0;
    for (size_t k = 0; k < mesh->attributes.count; k++) {
        const size_t bad = bat_first_not_finite(attributes[k].values, mesh->count);
        if (bad == mesh->count) {
            attributes[kept++] = attributes[k];
            continue;
        }
        batten_notes_add(mesh->input->notes, mesh->input->file, 0, attributes[k].name,
                         "left out: its value at vertex %zu is not finite", bad + 1);
        mesh->input->left_out++;
        release(attributes[k].name);
        release(attributes[k].values);
    }
    mesh->attributes.count = kept;
}

/* ---- the object ---- */

static batten_status corner_normals(const bat_indexed *mesh, double **out)
{
    const int *corners = mesh->triangles.items;
    const size_t count = 3 * mesh->triangles.count;
    if (!mesh->normals)
        return BATTEN_OK;
    batten_status status = bat_input_array(mesh->input, 3 * count, sizeof **out, out);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        memcpy(*out + 3 * i, mesh->normals + 3 * (size_t)corners[i], 3 * sizeof **out);
    return status;
}

static batten_status add_mesh(bat_indexed *mesh, const char *name, batten_model *model)
{
    double *normals = NULL;
    batten_mesh *made = NULL;
    batten_status status = corner_normals(mesh, &normals);
    const batten_mesh_parts parts = {
        .vertex_count = (int)mesh->count,
        .points = mesh->points,
        .colours = mesh->colours,
        .triangle_count = (int)mesh->triangles.count,
        .corners = mesh->triangles.items,
        .normals = normals,
        .triangle_colours = mesh->triangle_colours.count ? mesh->triangle_colours.items : NULL,
        .attribute_count = (int)mesh->attributes.count,
        .attributes = mesh->attributes.items};
    if (status == BATTEN_OK)
        status = batten_mesh_create(&parts, &made);
    if (status == BATTEN_OK)
        status = batten_model_add(
            model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_MESH, .mesh = made});
    if (status == BATTEN_OK)
        bat_remark_flat(made, mesh->input->file, name, mesh->input->notes);
    batten_mesh_unref(made);
    bat_release(normals);
    return status;
}

/* "normals, colours, 2 further values" */
static void note_lost_of_points(const bat_indexed *mesh)
{
    const size_t further = mesh->attributes.count;
    char values[48] = "";
    if (further)
        snprintf(values, sizeof values, "%zu further value%s", further, bat_plural(further));
    const char *lost[] = {mesh->normals ? "normals" : "", mesh->colours ? "colours" : "",
                          values};
    char list[96] = "";
    size_t used = 0;
    for (int k = 0; k < 3; k++)
        if (*lost[k])
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", used ? ", " : "",
                                     lost[k]);
    if (used)
        batten_notes_add(mesh->input->notes, mesh->input->file, 0, "points",
                         "of points only coordinates are kept; left out of %zu point%s: %s",
                         mesh->count, bat_plural(mesh->count), list);
}

/* Objects of points hold coordinates alone. */
static batten_status add_points(const bat_indexed *mesh, batten_model *model)
{
    note_lost_of_points(mesh);
    return batten_model_add(model, &(batten_object){.name = "points",
                                                    .kind = BATTEN_OBJECT_POINTS,
                                                    .point_count = (int)mesh->count,
                                                    .points = mesh->points});
}

batten_status bat_indexed_add(bat_indexed *mesh, const char *name, batten_model *model)
{
    batten_status status = pack_all(mesh);
    if (status != BATTEN_OK || mesh->count == 0)
        return status;
    check_colours(mesh);
    check_normals(mesh);
    check_attributes(mesh);
    bat_remark_polygons(mesh->input, mesh->cut_up);
    if (mesh->odd)
        batten_notes_add(mesh->input->notes, mesh->input->file, 0, name,
                         "%d of %zu faces cross themselves, or have a bay and more than %d "
                         "corners: their triangles overlap",
                         mesh->odd, mesh->polygons, BAT_POLYGON_MOST);
    return mesh->triangles.count ? add_mesh(mesh, name, model) : add_points(mesh, model);
}
