#include "base/plural.h"
#include "exchange/ftm/ftm.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/census.h"
#include "exchange/reading/scan.h"

#include <batten/text.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

enum {
    LINES_OF_POINT = 4, /* x y z; kind; two marks */
    LINES_OF_EDGE = 4,  /* two points; crease; a mark */
    LINES_OF_LAYER = 12,
    MOST_CORNERS = 100,
    NAME = 128
};

typedef struct {
    bat_input *input;
    bat_list lines; /* of uint32_t: where each begins in the file */
    size_t points;  /* the line with the number of points */
    int point_count, layer_count, curve_count, crease_count;
    size_t cut_up;       /* faces of more than three corners */
    size_t layers;       /* the first line of the first layer; meaningless without layers */
    size_t at;           /* the next line */
    double *coordinates; /* [point_count][3] */
    bat_list corners;    /* of int: triangles, [3] each, */
    bat_list owners;     /* of int: and the layer of each */
    int *order;          /* the triangles by layers, */
    int *ends;           /* and where each layer ends there */
    bat_census census;
    batten_model *model;
} reading;

batten_status bat_ftm_recognise(const bat_input *input, bool *is_ftm)
{
    *is_ftm = bat_begins(input, 0, "FREE!ship\n") || bat_begins(input, 0, "FREE!ship\r\n");
    return BATTEN_OK;
}

/* Lines are short: a span for each would take several times the file. */
static batten_status split_lines(reading *r)
{
    bat_span line;
    size_t next = 0;
    batten_status status =
        bat_input_limit(r->input, 0, r->input->size, UINT32_MAX, "bytes in an FTM file");
    while (status == BATTEN_OK) {
        const uint32_t at = (uint32_t)next;
        if (!bat_next_line(r->input, &next, &line))
            break;
        status = bat_list_add(r->input, &r->lines, &at);
    }
    return status;
}

static bat_span line_of(const reading *r, size_t index)
{
    bat_span line = {"", 0};
    if (index < r->lines.count) {
        size_t at = ((const uint32_t *)r->lines.items)[index];
        bat_next_line(r->input, &at, &line);
    }
    return line;
}

/* The numbers of a line, at most `most`; -1 when something else stands there. */
static int numbers_of(bat_span line, int most, double *values)
{
    int count = 0;
    for (size_t i = 0; i < line.length;) {
        while (i < line.length && bat_is_blank(line.bytes[i]))
            i++;
        const size_t begin = i;
        while (i < line.length && !bat_is_blank(line.bytes[i]))
            i++;
        if (i == begin)
            break;
        if (count == most || batten_number_read(line.bytes + begin, i - begin, &values[count],
                                                NULL) != BATTEN_OK)
            return -1;
        count++;
    }
    return count;
}

static bool is_whole(const reading *r, size_t index, int *value)
{
    const bat_span line = line_of(r, index);
    bat_scan words = bat_scan_begin(line.bytes, line.length);
    bat_span word, more;
    int64_t number = 0;
    if (!bat_next_in_line(&words, &word) || bat_next_in_line(&words, &more) ||
        !bat_word_integer(word, INT_MIN, INT_MAX, &number))
        return false;
    *value = (int)number;
    return true;
}

/* A whole number from `low` to `high` in the next line. */
static batten_status next_whole(reading *r, const char *what, int low, int high, int *value)
{
    if (!is_whole(r, r->at, value) || *value < low || *value > high)
        return bat_input_fail(r->input, BATTEN_BAD_FORMAT, (int)r->at + 1,
                              "%s is not a whole number from %d to %d", what, low, high);
    r->at++;
    return BATTEN_OK;
}

/* A count of things of `least` lines each: they must fit into the lines that are left. */
static batten_status next_count(reading *r, const char *what, size_t least, int *count)
{
    const size_t left = r->at < r->lines.count ? r->lines.count - r->at : 0;
    const size_t most = left / least;
    return next_whole(r, what, 0, most < 1000000000 ? (int)most : 1000000000, count);
}

/* Settings of many kinds stand before the net; it begins where a number of points is followed
 * by as many of them: three coordinates and three marks each. */
static batten_status find_points(reading *r)
{
    double xyz[3];
    int count = 0, mark = 0;
    for (size_t i = 0; i + LINES_OF_POINT < r->lines.count; i++) {
        if (numbers_of(line_of(r, i + 1), 3, xyz) != 3 || !is_whole(r, i, &count) ||
            count < 3 || (size_t)count > (r->lines.count - i) / LINES_OF_POINT)
            continue;
        bool fits = true;
        for (size_t k = 2; k <= 4; k++)
            fits &= is_whole(r, i + k, &mark);
        const size_t last = i + 1 + LINES_OF_POINT * (size_t)(count - 1);
        if (fits && numbers_of(line_of(r, last), 3, xyz) == 3) {
            r->points = i;
            r->point_count = count;
            return BATTEN_OK;
        }
    }
    return bat_input_fail(r->input, BATTEN_BAD_FORMAT, 0,
                          "no control points are found in the model");
}

static void note_vanished(const reading *r, bat_span line, const double point[3])
{
    bat_scan words = bat_scan_begin(line.bytes, line.length);
    bat_span word;
    for (int k = 0; k < 3 && bat_next_in_line(&words, &word); k++)
        bat_input_vanished(r->input, (int)r->at + 1, "", word, point[k]);
}

static batten_status read_points(reading *r)
{
    batten_status status = bat_input_limit(r->input, (int)r->points + 1, (size_t)r->point_count,
                                           r->input->limits.points, "points");
    if (status == BATTEN_OK)
        status = bat_input_array(r->input, (size_t)r->point_count, 3 * sizeof(double),
                                 &r->coordinates);
    r->at = r->points + 1;
    for (int i = 0; status == BATTEN_OK && i < r->point_count; i++) {
        const bat_span line = line_of(r, r->at);
        double *point = &r->coordinates[3 * (size_t)i];
        if (numbers_of(line, 3, point) == 3)
            note_vanished(r, line, point);
        else
            status = bat_input_fail(r->input, BATTEN_BAD_FORMAT, (int)r->at + 1,
                                    "point %d has no three coordinates", i);
        r->at += LINES_OF_POINT;
    }
    return status;
}

/* Layers stand before the points: their number, 12 lines for each, one line more. */
static void find_layers(reading *r)
{
    for (int count = 1; count <= 1000; count++) {
        const size_t back = (size_t)count * LINES_OF_LAYER + 2;
        int stated = 0;
        if (back > r->points)
            return;
        if (is_whole(r, r->points - back, &stated) && stated == count) {
            r->layer_count = count;
            r->layers = r->points - back + 1;
            return;
        }
    }
}

static batten_status read_edges(reading *r)
{
    int count = 0;
    batten_status status = next_count(r, "the number of edges", LINES_OF_EDGE, &count);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        int ends[2], crease = 0, mark = 0;
        for (int k = 0; status == BATTEN_OK && k < 2; k++)
            status = next_whole(r, "an end of an edge", 0, r->point_count - 1, &ends[k]);
        if (status == BATTEN_OK)
            status = next_whole(r, "the mark of a crease", 0, 1, &crease);
        if (status == BATTEN_OK)
            status = next_whole(r, "a mark of an edge", INT_MIN, INT_MAX, &mark);
        if (status == BATTEN_OK)
            r->crease_count += crease;
    }
    return status;
}

/* Curves that run through points of the net. */
static batten_status read_curves(reading *r)
{
    batten_status status = next_count(r, "the number of curves", 3, &r->curve_count);
    for (int i = 0; status == BATTEN_OK && i < r->curve_count; i++) {
        int count = 0, index = 0;
        status = next_count(r, "the number of points of a curve", 1, &count);
        for (int k = 0; status == BATTEN_OK && k < count; k++)
            status = next_whole(r, "a point of a curve", 0, r->point_count - 1, &index);
        if (status == BATTEN_OK)
            status = next_whole(r, "a mark of a curve", INT_MIN, INT_MAX, &index);
    }
    return status;
}

/* A face of several corners as a fan of triangles. */
static batten_status read_face(reading *r)
{
    int count = 0, corners[MOST_CORNERS], layer = 0, mark = 0;
    batten_status status =
        next_whole(r, "the number of corners of a face", 3, MOST_CORNERS, &count);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = next_whole(r, "a corner of a face", 0, r->point_count - 1, &corners[k]);
    if (status == BATTEN_OK)
        status =
            next_whole(r, "the layer of a face", 0, bat_max_int(r->layer_count, 1) - 1, &layer);
    if (status == BATTEN_OK)
        status = next_whole(r, "a mark of a face", INT_MIN, INT_MAX, &mark);
    r->cut_up += status == BATTEN_OK && count > 3;
    for (int k = 1; status == BATTEN_OK && k + 1 < count; k++) {
        const int triangle[3] = {corners[0], corners[k], corners[k + 1]};
        status = bat_list_add(r->input, &r->corners, triangle);
        if (status == BATTEN_OK)
            status = bat_list_add(r->input, &r->owners, &layer);
    }
    return status;
}

static batten_status read_faces(reading *r)
{
    int count = 0;
    batten_status status = next_count(r, "the number of faces", 6, &count);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = read_face(r);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_census_read(r->input, &r->census, "face of the control net");
    return status;
}

/* ---- meshes ---- */

/* Name and colour of a layer; its colour has blue in the third byte. */
static void read_look(const reading *r, int layer, char name[NAME], batten_object *object)
{
    int colour = -1;
    snprintf(name, NAME, "layer %d", layer + 1);
    object->name = object->layer = name;
    if (r->layer_count == 0)
        return;
    const size_t at = r->layers + LINES_OF_LAYER * (size_t)layer;
    const bat_span text = line_of(r, at);
    const size_t length = text.length < NAME - 1 ? text.length : NAME - 1;
    if (length > 0) {
        memcpy(name, text.bytes, length);
        name[length] = '\0';
    }
    object->has_colour = is_whole(r, at + 2, &colour) && colour >= 0 && colour <= 0xffffff;
    if (!object->has_colour)
        batten_notes_add(r->input->notes, r->input->file, 0, name,
                         "the colour of the layer is not a whole number from 0 to %d; it has "
                         "none",
                         0xffffff);
    for (int k = 0; object->has_colour && k < 3; k++)
        object->colour[k] = ((colour >> (8 * k)) & 255) / 255.0;
}

/* Put the triangles in the order of their layers. */
static batten_status sort_by_layers(reading *r)
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

/* Number the points that triangles [count] use, as they come; `numbers` are -1 before and
 * after. Returns how many they are. */
static int take_points(const reading *r, const int *triangles, int count, int *numbers,
                       double *points, int *made)
{
    const int *corners = r->corners.items;
    int used = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            const int point = corners[3 * (size_t)triangles[i] + (size_t)k];
            if (numbers[point] < 0) {
                memcpy(&points[3 * (size_t)used], &r->coordinates[3 * (size_t)point],
                       3 * sizeof *points);
                numbers[point] = used++;
            }
            made[3 * (size_t)i + (size_t)k] = numbers[point];
        }
    for (int i = 0; i < count; i++)
        for (size_t k = 0; k < 3; k++)
            numbers[corners[3 * (size_t)triangles[i] + k]] = -1;
    return used;
}

/* The triangles of one layer with the points that they use. */
static batten_status add_layer(reading *r, int layer, int *numbers)
{
    const int begin = layer > 0 ? r->ends[layer - 1] : 0, count = r->ends[layer] - begin;
    const size_t corners = 3 * (size_t)count, all = (size_t)r->point_count;
    char name[NAME];
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

/* Of all the lines only those of the layers are looked at again. */
static void drop_lines(reading *r)
{
    const size_t count = LINES_OF_LAYER * (size_t)r->layer_count;
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

static batten_status add_layers(reading *r)
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

static void note_rest(const reading *r)
{
    const bat_input *input = r->input;
    bat_remark_polygons(input, r->cut_up);
    batten_notes_add(
        input->notes, input->file, 0, "",
        "the control net is read; the subdivision surface that it stands for, with "
        "%d crease%s and %d curve%s, is not made",
        r->crease_count, bat_plural(r->crease_count), r->curve_count,
        bat_plural(r->curve_count));
}

static batten_status read_all(reading *r)
{
    batten_status status = split_lines(r);
    if (status == BATTEN_OK)
        status = find_points(r);
    if (status == BATTEN_OK)
        status = read_points(r);
    if (status == BATTEN_OK) {
        find_layers(r);
        status = read_edges(r);
    }
    if (status == BATTEN_OK)
        status = read_curves(r);
    if (status == BATTEN_OK)
        status = read_faces(r);
    if (status != BATTEN_OK)
        return status;
    drop_lines(r);
    return add_layers(r);
}

batten_status bat_read_ftm(bat_input *input, batten_model **out)
{
    reading r = {.input = input,
                 .lines = {.size = sizeof(uint32_t)},
                 .corners = {.size = 3 * sizeof(int)},
                 .owners = {.size = sizeof(int)}};
    bat_census_begin(&r.census);
    batten_status status = read_all(&r);
    if (status == BATTEN_OK) {
        note_rest(&r);
        bat_census_note(input, &r.census);
        *out = batten_model_ref(r.model);
    }
    batten_model_unref(r.model);
    bat_census_end(&r.census);
    bat_release(r.lines.items);
    bat_release(r.coordinates);
    bat_release(r.corners.items);
    bat_release(r.owners.items);
    bat_release(r.order);
    bat_release(r.ends);
    return status;
}
