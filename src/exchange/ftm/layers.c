/* The layers of a .ftm file as meshes. */
#include "exchange/ftm/reading.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/scan.h"
#include <batten/text.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

/* ---- meshes ---- */

/* Name and colour of a layer; its colour has blue in the third byte. */
static void read_look(const bat_ftm_reading *r, int layer, char name[BAT_FTM_NAME],
                      batten_object *object)
{
    int colour = -1;
    snprintf(name, BAT_FTM_NAME, "layer %d", layer + 1);
    object->name = object->layer = name;
    if (r->layer_count == 0)
        return;
    const size_t at = r->layers + BAT_FTM_LINES_OF_LAYER * (size_t)layer;
    const bat_span text = bat_ftm_line_of(r, at);
    const size_t length = text.length < BAT_FTM_NAME - 1 ? text.length : BAT_FTM_NAME - 1;
    if (length > 0) {
        memcpy(name, text.bytes, length);
        name[length] = '\0';
    }
    object->has_colour =
        bat_ftm_is_whole(r, at + 2, &colour) && colour >= 0 && colour <= 0xffffff;
    if (!object->has_colour)
        batten_notes_add(r->input->notes, r->input->file, 0, name,
                         "the colour of the layer is not a whole number from 0 to %d; it has "
                         "none",
                         0xffffff);
    for (int k = 0; object->has_colour && k < 3; k++)
        object->colour[k] = ((colour >> (8 * k)) & 255) / 255.0;
}

/* Put the triangles in the order of their layers. */
static batten_status sort_by_layers(bat_ftm_reading *r)
{
    const int *owners = r->owners.items;
    const size_t layers = (size_t)bat_max_int(r->layer_count, 1), count = r->owners.count;
    batten_status status = bat_input_array(r->input, layers + 1, sizeof *r->ends, &r->ends);
    if (status == BATTEN_OK)
        status = bat_input_array(r->input, count + 1, sizeof *r->order, &r->order);
    if (status != BATTEN_OK)
        return status;
    for (size_t t = 0; t < count; t++)
        r->ends[owners[t] + 1]++;
    for (size_t layer = 0; layer < layers; layer++)
        r->ends[layer + 1] += r->ends[layer];
    /* What is counted so far is where a layer begins; when all stand there, where it ends. */
    for (size_t t = 0; t < count; t++)
        r->order[r->ends[owners[t]]++] = (int)t;
    return BATTEN_OK;
}

/* A point that has none gets the next number. */
static int number_of_point(const bat_ftm_reading *r, int point, int *numbers, double *points,
                           int *used)
{
    if (numbers[point] < 0) {
        memcpy(&points[3 * (size_t)*used], &r->coordinates[3 * (size_t)point],
               3 * sizeof *points);
        numbers[point] = (*used)++;
    }
    return numbers[point];
}

static void forget_numbers(const int *corners, const int *triangles, int count, int *numbers)
{
    for (int i = 0; i < count; i++)
        for (size_t k = 0; k < 3; k++)
            numbers[corners[3 * (size_t)triangles[i] + k]] = -1;
}

/* Number the points that triangles [count] use, as they come; `numbers` are -1 before and
 * after. Returns how many they are. */
static int take_points(const bat_ftm_reading *r, const int *triangles, int count, int *numbers,
                       double *points, int *made)
{
    const int *corners = r->corners.items;
    int used = 0;
    for (size_t i = 0; i < 3 * (size_t)count; i++) {
        const int point = corners[3 * (size_t)triangles[i / 3] + i % 3];
        made[i] = number_of_point(r, point, numbers, points, &used);
    }
    forget_numbers(corners, triangles, count, numbers);
    return used;
}

/* The triangles of one layer with the points that they use. */
static batten_status add_layer(bat_ftm_reading *r, int layer, int *numbers)
{
    const int begin = layer > 0 ? r->ends[layer - 1] : 0, count = r->ends[layer] - begin;
    const size_t corners = 3 * (size_t)count, all = (size_t)r->point_count;
    char name[BAT_FTM_NAME];
    batten_mesh *mesh = NULL;
    batten_object object = {.kind = BATTEN_OBJECT_MESH};
    if (count == 0)
        return BATTEN_OK;
    double *points = bat_array3(corners < all ? corners : all, 3, sizeof *points);
    int *made = bat_array3((size_t)count, 3, sizeof *made);
    batten_status status = points && made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const int used = take_points(r, r->order + begin, count, numbers, points, made);
        status = batten_mesh_create(&(batten_mesh_parts){.vertex_count = used,
                                                         .points = points,
                                                         .triangle_count = count,
                                                         .corners = made},
                                    &mesh);
    }
    if (status == BATTEN_OK) {
        read_look(r, layer, name, &object);
        object.mesh = mesh;
        status = batten_model_add(r->model, &object);
    }
    batten_mesh_unref(mesh);
    bat_release(points);
    bat_release(made);
    return status;
}

void bat_ftm_drop_lines(bat_ftm_reading *r)
{
    const size_t count = BAT_FTM_LINES_OF_LAYER * (size_t)r->layer_count;
    uint32_t *lines = r->lines.items;
    if (count > 0)
        memmove(lines, lines + r->layers, count * sizeof *lines);
    r->lines.count = count;
    r->layers = 0;
    uint32_t *shorter = bat_resize(lines, count + 1, sizeof *lines);
    if (shorter) {
        r->lines.items = shorter;
        r->lines.capacity = count + 1;
    }
}

batten_status bat_ftm_add_layers(bat_ftm_reading *r)
{
    int *numbers = bat_array((size_t)r->point_count, sizeof *numbers);
    batten_status status = numbers ? batten_model_create(0, &r->model) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = sort_by_layers(r);
    for (int i = 0; numbers && i < r->point_count; i++)
        numbers[i] = -1;
    for (int layer = 0; status == BATTEN_OK && layer < bat_max_int(r->layer_count, 1); layer++)
        status = add_layer(r, layer, numbers);
    bat_release(numbers);
    return status;
}
