#include "exchange/meshes/indexed.h"
#include "exchange/ply/ply.h"

#include <limits.h>

/* What a property of a vertex says. */
typedef enum { POINT, NORMAL = 3, COLOUR = 6, FURTHER = 9, IGNORED } role;

typedef struct {
    bat_input *input;
    bat_ply_header header;
    bat_ply_items items;
    bat_indexed mesh;
    bat_list values;        /* of double: those of one item */
    bat_list columns;       /* of column: those of a vertex */
    bat_list waiting;       /* of place: faces that stand before the vertices */
    size_t face_colours[3]; /* the properties of a face that are its colour; SIZE_MAX: none */
    size_t reached; /* how far the file was gone through; faces that wait are gone back to */
    bool has_vertices, is_lost;
} reading;

/* Where the items of an element begin. */
typedef struct {
    const bat_ply_element *element;
    size_t at;
    int line;
} place;

/* Where the numbers of a property go: rows[i * width + offset], scaled. */
typedef struct {
    double *rows;
    double scale;
    size_t width, offset;
} column;

static const bat_ply_property *properties_of(const reading *r, const bat_ply_element *element)
{
    const bat_ply_property *all = r->header.properties.items;
    return all ? all + element->first : NULL;
}

static batten_status step(reading *r)
{
    if (r->items.at > r->reached)
        r->reached = r->items.at;
    return bat_input_step(r->input, r->reached);
}

static int role_of(const bat_ply_property *property)
{
    static const char *const names[] = {"x",  "y",   "z",     "nx",  "ny",
                                        "nz", "red", "green", "blue"};
    static const char *const others[] = {"diffuse_red", "diffuse_green", "diffuse_blue"};
    if (property->is_list)
        return IGNORED;
    for (int k = 0; k < FURTHER; k++)
        if (bat_word_is(property->name, names[k]) ||
            (k >= COLOUR && bat_word_is(property->name, others[k - COLOUR])))
            return k;
    return FURTHER;
}

/* One number for each property of the element. */
static batten_status make_room(reading *r, const bat_ply_element *element)
{
    const double zero = 0;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && r->values.count < element->properties)
        status = bat_list_add(r->input, &r->values, &zero);
    return status;
}

/* ---- vertices ---- */

static double scale_of(bat_ply_type type)
{
    return type.is_real ? 1 : 1 / (ldexp(1, 8 * bat_min_int(type.bytes, 2)) - 1);
}

/* Three properties of one kind, or none. */
static batten_status three_columns(reading *r, const size_t found[FURTHER], int kind,
                                   size_t count, double **rows)
{
    if (found[kind] == SIZE_MAX || found[kind + 1] == SIZE_MAX || found[kind + 2] == SIZE_MAX)
        return BATTEN_OK;
    column *columns = r->columns.items;
    batten_status status = bat_input_array(r->input, 3 * count, sizeof **rows, rows);
    for (int k = 0; status == BATTEN_OK && k < 3; k++) {
        columns[found[kind + k]].rows = *rows;
        columns[found[kind + k]].width = 3;
        columns[found[kind + k]].offset = (size_t)k;
    }
    return status;
}

static batten_status attribute_column(reading *r, const bat_ply_property *property, size_t k,
                                      size_t count)
{
    double *values = NULL;
    batten_status status = bat_input_array(r->input, count, sizeof *values, &values);
    column *columns = r->columns.items;
    if (status == BATTEN_OK)
        columns[k] = (column){values, 1, 1, 0};
    if (status == BATTEN_OK)
        status = bat_indexed_attribute(&r->mesh, property->name, &values);
    bat_release(values);
    return status;
}

/* Lists, colours of two parts and the like. */
static void note_others(const reading *r, const bat_ply_element *element)
{
    const bat_ply_property *properties = properties_of(r, element);
    const column *columns = r->columns.items;
    for (size_t k = 0; k < element->properties; k++)
        if (!columns[k].rows)
            batten_notes_add(r->input->notes, r->input->file, 0, "",
                             "property '%.*s' of the vertices is left out",
                             bat_min_int((int)properties[k].name.length, 40),
                             properties[k].name.bytes);
}

/* Memory for what each of `count` vertices says. */
static batten_status make_columns(reading *r, const bat_ply_element *element, size_t count)
{
    const bat_ply_property *properties = properties_of(r, element);
    size_t found[FURTHER];
    batten_status status = BATTEN_OK;
    for (int k = 0; k < FURTHER; k++)
        found[k] = SIZE_MAX;
    for (size_t k = 0; status == BATTEN_OK && k < element->properties; k++) {
        const int what = role_of(&properties[k]);
        const column none = {NULL, what >= COLOUR ? scale_of(properties[k].type) : 1, 1, 0};
        if (what < FURTHER && found[what] == SIZE_MAX)
            found[what] = k;
        status = bat_list_add(r->input, &r->columns, &none);
        if (status == BATTEN_OK && what == FURTHER)
            status = attribute_column(r, &properties[k], k, count);
    }
    if (status == BATTEN_OK)
        status = three_columns(r, found, POINT, count, &r->mesh.points);
    if (status == BATTEN_OK)
        status = three_columns(r, found, NORMAL, count, &r->mesh.normals);
    if (status == BATTEN_OK)
        status = three_columns(r, found, COLOUR, count, &r->mesh.colours);
    if (status == BATTEN_OK)
        note_others(r, element);
    if (status == BATTEN_OK && !r->mesh.points)
        status = bat_input_fail(r->input, BATTEN_BAD_FORMAT, 0,
                                "vertices have no x, y and z among their properties");
    return status;
}

/* One whose coordinates are no numbers is noted, and no face may have it. */
static void take_vertex(reading *r, const bat_ply_element *element, size_t index, bool is_odd)
{
    const column *columns = r->columns.items;
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

static batten_status read_vertices(reading *r, const bat_ply_element *element)
{
    const bat_ply_property *properties = properties_of(r, element);
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
            status = step(r);
    }
    r->is_lost = r->is_lost || r->mesh.count < element->count;
    if (status == BATTEN_OK && r->is_lost)
        batten_notes_add(r->input->notes, r->input->file, 0, "",
                         "%zu of %zu vertices are in the file", r->mesh.count, element->count);
    return status;
}

/* ---- faces and the rest ---- */

static size_t list_of_corners(const bat_ply_property *properties, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (properties[k].is_list && (bat_word_is(properties[k].name, "vertex_indices") ||
                                      bat_word_is(properties[k].name, "vertex_index")))
            return k;
    return SIZE_MAX;
}

/* What of a face is its colour; the rest but the corners is left out with a note. */
static void find_face_colours(reading *r, const bat_ply_element *element, size_t corners)
{
    const bat_ply_property *properties = properties_of(r, element);
    for (int k = 0; k < 3; k++) {
        r->face_colours[k] = SIZE_MAX;
        for (size_t i = element->properties; i-- > 0;)
            if (role_of(&properties[i]) == COLOUR + k)
                r->face_colours[k] = i;
    }
    const size_t *found = r->face_colours;
    const bool all = found[0] != SIZE_MAX && found[1] != SIZE_MAX && found[2] != SIZE_MAX;
    for (size_t i = 0; i < element->properties; i++) {
        const bool is_colour = all && (i == found[0] || i == found[1] || i == found[2]);
        if (i != corners && !is_colour)
            batten_notes_add(r->input->notes, r->input->file, 0, "",
                             "property '%.*s' of the faces is left out",
                             bat_min_int((int)properties[i].name.length, 40),
                             properties[i].name.bytes);
    }
    if (!all)
        r->face_colours[0] = SIZE_MAX;
}

static batten_status take_face(reading *r, const bat_ply_property *properties, size_t index,
                               bat_ply_result result)
{
    const int line = r->items.form == BAT_PLY_TEXT ? r->items.line : 0;
    if (result == BAT_PLY_READ) {
        const double *values = r->values.items;
        double colour[3];
        const batten_status status = bat_indexed_polygon(&r->mesh, line);
        if (status != BATTEN_OK || r->face_colours[0] == SIZE_MAX)
            return status;
        for (int k = 0; k < 3; k++) {
            const size_t at = r->face_colours[k];
            colour[k] = scale_of(properties[at].type) * values[at];
        }
        return bat_indexed_colour(&r->mesh, colour);
    }
    r->mesh.polygon.count = 0;
    r->mesh.polygons++;
    r->input->left_out++;
    batten_notes_add(r->input->notes, r->input->file, line, "",
                     "face %zu is left out: a number is missing, or its count is no count",
                     index + 1);
    return BATTEN_OK;
}

/* Faces when `corners` is a property, else what is only passed over. */
static batten_status read_items(reading *r, const bat_ply_element *element, size_t corners)
{
    const bat_ply_property *properties = properties_of(r, element);
    batten_status status = BATTEN_OK;
    bat_ply_result result = BAT_PLY_READ;
    for (size_t i = 0; status == BATTEN_OK && i < element->count; i++) {
        status = bat_ply_item(&r->items, properties, element->properties, corners,
                              r->values.items, &r->mesh.polygon, &result);
        if (status == BATTEN_OK && result == BAT_PLY_LOST) {
            r->is_lost = true;
            batten_notes_add(r->input->notes, r->input->file, 0, "",
                             "%zu of %zu items '%.*s' are in the file", i, element->count,
                             bat_min_int((int)element->name.length, 40), element->name.bytes);
            return BATTEN_OK;
        }
        if (status == BATTEN_OK && corners != SIZE_MAX)
            status = take_face(r, properties, i, result);
        if (status == BATTEN_OK && i % 10000 == 9999)
            status = step(r);
    }
    return status;
}

static batten_status leave_out(reading *r, const bat_ply_element *element)
{
    batten_notes_add(r->input->notes, r->input->file, 0, "",
                     "the %zu items '%.*s' are left out", element->count,
                     bat_min_int((int)element->name.length, 40), element->name.bytes);
    r->input->left_out++;
    return BATTEN_OK;
}

static batten_status read_faces(reading *r, const bat_ply_element *element, size_t corners)
{
    find_face_colours(r, element, corners);
    return read_items(r, element, corners);
}

static batten_status let_wait(reading *r, const bat_ply_element *element)
{
    const place here = {element, r->items.at, r->items.line};
    return bat_list_add(r->input, &r->waiting, &here);
}

static batten_status read_element(reading *r, const bat_ply_element *element)
{
    if (element->count == 0)
        return BATTEN_OK;
    if (element->properties == 0)
        return bat_word_is(element->name, "vertex") ? leave_out(r, element) : BATTEN_OK;
    const size_t corners = list_of_corners(properties_of(r, element), element->properties);
    batten_status status = make_room(r, element);
    if (status != BATTEN_OK)
        return status;
    if (bat_word_is(element->name, "vertex") && !r->has_vertices)
        return read_vertices(r, element);
    if (!bat_word_is(element->name, "face") || corners == SIZE_MAX)
        leave_out(r, element);
    else if (r->has_vertices)
        return read_faces(r, element, corners);
    else
        status = let_wait(r, element);
    return status == BATTEN_OK ? read_items(r, element, SIZE_MAX) : status;
}

/* The faces that stand before the vertices, now that these are read. */
static batten_status read_waiting(reading *r)
{
    const place *places = r->waiting.items;
    const bat_ply_items end = r->items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < r->waiting.count; k++) {
        const bat_ply_element *element = places[k].element;
        r->items.at = places[k].at;
        r->items.line = places[k].line;
        if (r->has_vertices)
            status = read_faces(
                r, element, list_of_corners(properties_of(r, element), element->properties));
        else
            status = leave_out(r, element);
    }
    r->items = end;
    return status;
}

static batten_status read_body(reading *r, batten_model *model)
{
    const bat_ply_element *elements = r->header.elements.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && !r->is_lost && k < r->header.elements.count; k++)
        status = read_element(r, &elements[k]);
    if (status == BATTEN_OK)
        status = read_waiting(r);
    r->input->is_cut = r->is_lost;
    if (status == BATTEN_OK && !r->is_lost)
        bat_input_behind(r->input, r->items.at);
    if (status == BATTEN_OK)
        status = bat_indexed_add(&r->mesh, "mesh", model);
    if (status == BATTEN_OK && batten_model_count(model) == 0 &&
        (r->is_lost || r->input->left_out))
        status = bat_input_fail(r->input, BATTEN_BAD_FORMAT, 0, "no vertex could be read");
    return status;
}

/* The header is text; so is the rest, if the header says so. */
static batten_status check_text(bat_input *input, const bat_ply_header *header)
{
    bat_input body = *input;
    if (header->form != BAT_PLY_TEXT)
        return BATTEN_OK;
    const batten_status status = bat_input_as_text(&body);
    if (status == BATTEN_OK)
        input->size = body.size; /* without a control-Z */
    return status;
}

batten_status bat_read_ply(bat_input *input, batten_model **out)
{
    reading r = {.input = input,
                 .mesh = bat_indexed_begin(input),
                 .values = {.size = sizeof(double)},
                 .columns = {.size = sizeof(column)},
                 .waiting = {.size = sizeof(place)}};
    batten_model *model = NULL;
    batten_status status = bat_input_past_mark(input);
    if (status == BATTEN_OK)
        status = bat_ply_header_read(input, &r.header);
    r.items = (bat_ply_items){
        .input = input, .form = r.header.form, .at = r.header.body, .line = r.header.line - 1};
    if (status == BATTEN_OK)
        status = check_text(input, &r.header);
    if (status == BATTEN_OK)
        status = batten_model_create(0, &model);
    if (status == BATTEN_OK)
        status = read_body(&r, model);
    if (status == BATTEN_OK)
        *out = model;
    else
        batten_model_unref(model);
    bat_ply_header_end(&r.header);
    bat_indexed_end(&r.mesh);
    bat_release(r.values.items);
    bat_release(r.columns.items);
    bat_release(r.waiting.items);
    return status;
}
