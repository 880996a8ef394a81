/* The vertices of a PLY file: their points, normals, colours and further values. */
#include "exchange/ply/reading.h"
#include <limits.h>

/* ---- vertices ---- */

double bat_ply_scale_of(bat_ply_type type)
{
    return type.is_real ? 1 : 1 / (ldexp(1, 8 * bat_min_int(type.bytes, 2)) - 1);
}

/* Three properties of one kind, or none. */
static batten_status three_columns(bat_ply_reading *r, const size_t found[BAT_PLY_FURTHER],
                                   int kind, size_t count, double **rows)
{
    if (found[kind] == SIZE_MAX || found[kind + 1] == SIZE_MAX || found[kind + 2] == SIZE_MAX)
        return BATTEN_OK;
    bat_ply_column *columns = r->columns.items;
    batten_status status = bat_input_array(r->input, 3 * count, sizeof **rows, rows);
    for (int k = 0; status == BATTEN_OK && k < 3; k++) {
        columns[found[kind + k]].rows = *rows;
        columns[found[kind + k]].width = 3;
        columns[found[kind + k]].offset = (size_t)k;
    }
    return status;
}

static batten_status attribute_column(bat_ply_reading *r, const bat_ply_property *property,
                                      size_t k, size_t count)
{
    double *values = NULL;
    batten_status status = bat_input_array(r->input, count, sizeof *values, &values);
    bat_ply_column *columns = r->columns.items;
    if (status == BATTEN_OK)
        columns[k] = (bat_ply_column){values, 1, 1, 0};
    if (status == BATTEN_OK)
        status = bat_indexed_attribute(&r->mesh, property->name, &values);
    bat_release(values);
    return status;
}

/* Lists, colours of two parts and the like. */
static void note_others(const bat_ply_reading *r, const bat_ply_element *element)
{
    const bat_ply_property *properties = bat_ply_properties_of(r, element);
    const bat_ply_column *columns = r->columns.items;
    for (size_t k = 0; k < element->properties; k++)
        if (!columns[k].rows)
            batten_notes_add(r->input->notes, r->input->file, 0, "",
                             "property '%.*s' of the vertices is left out",
                             bat_min_int((int)properties[k].name.length, 40),
                             properties[k].name.bytes);
}

/* Memory for what each of `count` vertices says. */
static batten_status make_columns(bat_ply_reading *r, const bat_ply_element *element,
                                  size_t count)
{
    const bat_ply_property *properties = bat_ply_properties_of(r, element);
    size_t found[BAT_PLY_FURTHER];
    batten_status status = BATTEN_OK;
    for (int k = 0; k < BAT_PLY_FURTHER; k++)
        found[k] = SIZE_MAX;
    for (size_t k = 0; status == BATTEN_OK && k < element->properties; k++) {
        const int what = bat_ply_role_of(&properties[k]);
        const bat_ply_column none = {
            NULL, what >= BAT_PLY_COLOUR ? bat_ply_scale_of(properties[k].type) : 1, 1, 0};
        if (what < BAT_PLY_FURTHER && found[what] == SIZE_MAX)
            found[what] = k;
        status = bat_list_add(r->input, &r->columns, &none);
        if (status == BATTEN_OK && what == BAT_PLY_FURTHER)
            status = attribute_column(r, &properties[k], k, count);
    }
    if (status == BATTEN_OK)
        status = three_columns(r, found, BAT_PLY_POINT, count, &r->mesh.points);
    if (status == BATTEN_OK)
        status = three_columns(r, found, BAT_PLY_NORMAL, count, &r->mesh.normals);
    if (status == BATTEN_OK)
        status = three_columns(r, found, BAT_PLY_COLOUR, count, &r->mesh.colours);
    if (status == BATTEN_OK)
        note_others(r, element);
    if (status == BATTEN_OK && !r->mesh.points)
        status = bat_input_fail(r->input, BATTEN_BAD_FORMAT, 0,
                                "vertices have no x, y and z among their properties");
    return status;
}

/* One whose coordinates are no numbers is noted, and no face may have it. */
static void take_vertex(bat_ply_reading *r, const bat_ply_element *element, size_t index,
                        bool is_odd)
{
    const bat_ply_column *columns = r->columns.items;
    const double *values = r->values.items;
    for (size_t k = 0; k < element->properties; k++)
        if (columns[k].rows)
            columns[k].rows[index * columns[k].width + columns[k].offset] =
                is_odd ? (double)NAN : columns[k].scale * values[k];
    double *point = r->mesh.points + 3 * index;
    if (bat_first_not_finite(point, 3) == 3)
        return;
    point[0] = NAN;
    r->input->left_out++;
    batten_notes_add(r->input->notes, r->input->file,
                     r->items.form == BAT_PLY_TEXT ? r->items.line : 0, "",
                     "vertex %zu is left out: %s", index + 1,
                     is_odd ? "a number is missing" : "a coordinate is not finite");
}

batten_status bat_ply_read_vertices(bat_ply_reading *r, const bat_ply_element *element)
{
    const bat_ply_property *properties = bat_ply_properties_of(r, element);
    const size_t least = bat_ply_least(r->header.form, properties, element->properties);
    const size_t room = least ? (r->input->size - r->items.at + 1) / least : 0;
    const size_t count = element->count < room ? element->count : room;
    const size_t most = r->input->limits.points;
    batten_status status = bat_input_limit(
        r->input, 0, count, most < INT_MAX / 3 ? most : (size_t)INT_MAX / 3, "vertices");
    r->has_vertices = true;
    if (status == BATTEN_OK)
        status = make_columns(r, element, count);
    bat_ply_result result = BAT_PLY_READ;
    for (size_t i = 0; status == BATTEN_OK && !r->is_lost && i < count; i++) {
        status = bat_ply_item(&r->items, properties, element->properties, SIZE_MAX,
                              r->values.items, NULL, &result);
        r->is_lost = result == BAT_PLY_LOST;
        if (status == BATTEN_OK && !r->is_lost) {
            take_vertex(r, element, i, result == BAT_PLY_ODD);
            r->mesh.count = i + 1;
        }
        if (status == BATTEN_OK && i % 10000 == 9999)
            status = bat_ply_step(r);
    }
    r->is_lost = r->is_lost || r->mesh.count < element->count;
    if (status == BATTEN_OK && r->is_lost)
        batten_notes_add(r->input->notes, r->input->file, 0, "",
                         "%zu of %zu vertices are in the file", r->mesh.count, element->count);
    return status;
}
