/* The elements of a PLY file: its vertices, its faces, and others, which are passed over. */
#include "exchange/ply/reading.h"
#include <limits.h>

/* Where the items of an element begin. */
typedef struct {
    const bat_ply_element *element;
    size_t at;
    int line;
} place;

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
static void find_face_colours(bat_ply_reading *r, const bat_ply_element *element,
                              size_t corners)
{
    const bat_ply_property *properties = bat_ply_properties_of(r, element);
    for (int k = 0; k < 3; k++) {
        r->face_colours[k] = SIZE_MAX;
        for (size_t i = element->properties; i-- > 0;)
            if (bat_ply_role_of(&properties[i]) == BAT_PLY_COLOUR + k)
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

static batten_status keep_face(bat_ply_reading *r, const bat_ply_property *properties, int line)
{
    const double *values = r->values.items;
    double colour[3];
    const batten_status status = bat_indexed_polygon(&r->mesh, line);
    if (status != BATTEN_OK || r->face_colours[0] == SIZE_MAX)
        return status;
    for (int k = 0; k < 3; k++) {
        const size_t at = r->face_colours[k];
        colour[k] = bat_ply_scale_of(properties[at].type) * values[at];
    }
    return bat_indexed_colour(&r->mesh, colour);
}

static batten_status take_face(bat_ply_reading *r, const bat_ply_property *properties,
                               size_t index, bat_ply_result result)
{
    const int line = r->items.form == BAT_PLY_TEXT ? r->items.line : 0;
    if (result == BAT_PLY_READ)
        return keep_face(r, properties, line);
    bat_indexed_leave_out(&r->mesh, line, index,
                          "a number is missing, or its count is invalid");
    return BATTEN_OK;
}

/* Faces when `corners` is a property, else what is only passed over. */
static batten_status read_items(bat_ply_reading *r, const bat_ply_element *element,
                                size_t corners)
{
    const bat_ply_property *properties = bat_ply_properties_of(r, element);
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
            status = bat_ply_step(r);
    }
    return status;
}

static batten_status leave_out(bat_ply_reading *r, const bat_ply_element *element)
{
    batten_notes_add(r->input->notes, r->input->file, 0, "",
                     "the %zu items '%.*s' are left out", element->count,
                     bat_min_int((int)element->name.length, 40), element->name.bytes);
    r->input->left_out++;
    return BATTEN_OK;
}

static batten_status read_faces(bat_ply_reading *r, const bat_ply_element *element,
                                size_t corners)
{
    find_face_colours(r, element, corners);
    return read_items(r, element, corners);
}

static batten_status let_wait(bat_ply_reading *r, const bat_ply_element *element)
{
    const place here = {element, r->items.at, r->items.line};
    return bat_list_add(r->input, &r->waiting, &here);
}

static batten_status read_element(bat_ply_reading *r, const bat_ply_element *element)
{
    if (element->count == 0)
        return BATTEN_OK;
    if (element->properties == 0)
        return bat_word_is(element->name, "vertex") ? leave_out(r, element) : BATTEN_OK;
    const size_t corners =
        list_of_corners(bat_ply_properties_of(r, element), element->properties);
    batten_status status = bat_ply_make_room(r, element);
    if (status != BATTEN_OK)
        return status;
    if (bat_word_is(element->name, "vertex") && !r->has_vertices)
        return bat_ply_read_vertices(r, element);
    if (!bat_word_is(element->name, "face") || corners == SIZE_MAX)
        leave_out(r, element);
    else if (r->has_vertices)
        return read_faces(r, element, corners);
    else
        status = let_wait(r, element);
    return status == BATTEN_OK ? read_items(r, element, SIZE_MAX) : status;
}

static batten_status read_place(bat_ply_reading *r, const place *waiting)
{
    const bat_ply_element *element = waiting->element;
    r->items.at = waiting->at;
    r->items.line = waiting->line;
    if (r->has_vertices)
        return read_faces(
            r, element,
            list_of_corners(bat_ply_properties_of(r, element), element->properties));
    return leave_out(r, element);
}

/* The faces that stand before the vertices, now that these are read. */
static batten_status read_waiting(bat_ply_reading *r)
{
    const place *places = r->waiting.items;
    const bat_ply_items end = r->items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < r->waiting.count; k++)
        status = read_place(r, &places[k]);
    r->items = end;
    return status;
}

static batten_status read_body(bat_ply_reading *r, batten_model *model)
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
    bat_ply_reading r = {.input = input,
                         .mesh = bat_indexed_begin(input),
                         .values = {.size = sizeof(double)},
                         .columns = {.size = sizeof(bat_ply_column)},
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
    bat_ply_header_end(&r.header);
    bat_indexed_end(&r.mesh);
    bat_release(r.values.items);
    bat_release(r.columns.items);
    bat_release(r.waiting.items);
    return bat_input_hand_over(status, model, out);
}
