/* Reads an OBJ file statement by statement: vertices, normals, elements and groups. */
#include "exchange/obj/obj.h"

#include <limits.h>

/* ---- recognition ---- */

static bool is_one_of(bat_span word, const char *const *words)
{
    for (; *words; words++)
        if (bat_word_is(word, *words))
            return true;
    return false;
}

/* Some write the materials into the file itself. */
static bool is_of_material(bat_span word)
{
    static const char *const words[] = {"newmtl", "Ka", "Kd", "Ks",    "Ke", "Ns",
                                        "Ni",     "d",  "Tr", "illum", "Tf", NULL};
    return is_one_of(word, words);
}

batten_status bat_obj_recognise(const bat_input *input, bool *is_such)
{
    static const char *const before[] = {"mtllib", "o", "g", "usemtl", "s", "cstype", NULL};
    static const char *const proof[] = {"v", "vn", "vt", "vp", NULL};
    bat_span word;
    const size_t at = bat_past_white(input);
    bat_scan scan = bat_scan_begin(input->data + at, input->size - at);
    *is_such = false;
    while (bat_next_word(&scan, &word)) {
        double number;
        if (is_one_of(word, proof)) {
            *is_such = bat_next_in_line(&scan, &word) && bat_word_number(word, &number) &&
                       bat_next_in_line(&scan, &word) && bat_word_number(word, &number);
            return BATTEN_OK;
        }
        if (word.bytes[0] != '#' && !is_one_of(word, before) && !is_of_material(word))
            return BATTEN_OK;
        bat_rest_of_line(&scan);
    }
    return BATTEN_OK;
}

/* ---- vertices ---- */

static bool read_numbers(bat_obj *obj, double numbers[7], int *count)
{
    bat_span word;
    bool good = true;
    while (bat_obj_next(obj, &word)) {
        good = good && *count < 7 &&
               bat_word_real(obj->input, obj->scan.line, word, &numbers[*count]);
        ++*count;
    }
    return good && (*count == 3 || *count == 4 || *count == 6 || *count == 7);
}

static bat_obj_vertex vertex_of(int count, const double numbers[7])
{
    bat_obj_vertex vertex = {.weight = count == 4 ? numbers[3] : 1, .has_colour = count >= 6};
    memcpy(vertex.point, numbers, sizeof vertex.point);
    for (int k = 0; vertex.has_colour && k < 3; k++) {
        vertex.colour[k] = numbers[3 + k];
        vertex.has_colour = numbers[3 + k] >= 0 && numbers[3 + k] <= 1;
    }
    return vertex;
}

static void note_bad_vertex(bat_obj *obj)
{
    obj->input->left_out++;
    obj->bad_vertices++;
    batten_notes_add(obj->input->notes, obj->input->file, obj->scan.line, "",
                     "vertex %zu is left out: it is not of 3, 4 or 6 numbers",
                     obj->vertices.count + 1);
}

/* A bad vertex keeps its number. */
static batten_status read_vertex(bat_obj *obj)
{
    bat_obj_vertex vertex = {.weight = 1, .point = {NAN, NAN, NAN}};
    double numbers[7];
    int count = 0;
    if (read_numbers(obj, numbers, &count))
        vertex = vertex_of(count, numbers);
    else
        note_bad_vertex(obj);
    const batten_status status =
        bat_obj_limit(obj->input, obj->scan.line, obj->vertices.count + 1,
                      obj->input->limits.points, "vertices");
    return status == BATTEN_OK ? bat_list_add(obj->input, &obj->vertices, &vertex) : status;
}

static batten_status read_normal(bat_obj *obj)
{
    double normal[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++)
        if (!bat_obj_number(obj, &normal[k]))
            normal[0] = (double)NAN;
    return bat_list_add(obj->input, &obj->normals, normal);
}

/* ---- elements ---- */

static batten_status read_element(bat_obj *obj, bat_obj_kind kind, size_t least)
{
    static const char *const names[] = {"face", "line", "row of points"};
    bat_obj_element element = {
        .kind = kind, .first = obj->corners.count, .line = obj->scan.line};
    int bad = 0;
    batten_status status = bat_obj_corners(obj, &obj->corners, &bad);
    element.count = obj->corners.count - element.first;
    if (status != BATTEN_OK)
        return status;
    if (!bad && element.count >= least)
        return bat_obj_add(obj, &element);
    batten_notes_add(obj->input->notes, obj->input->file, element.line, "",
                     "the %s is left out: %d of its %zu corners are not indices", names[kind],
                     bad, element.count);
    obj->input->left_out++;
    obj->corners.count = element.first;
    return BATTEN_OK;
}

/* Up to a word that begins a comment. */
static bat_span read_name(bat_obj *obj)
{
    bat_span name = bat_rest_of_line(&obj->scan);
    for (size_t i = 0; i < name.length; i++)
        if (name.bytes[i] == '#' && (i == 0 || bat_is_blank(name.bytes[i - 1])))
            name.length = i;
    while (name.length && bat_is_blank(name.bytes[name.length - 1]))
        name.length--;
    return name;
}

static void begin_part(bat_obj *obj, bool is_object)
{
    const bat_span name = read_name(obj);
    if (is_object)
        obj->object = name;
    obj->group = is_object ? (bat_span){name.bytes, 0} : name;
    obj->is_new_part = true;
}

/* ---- statements ---- */

static void leave_unknown(const bat_obj *obj, bat_span word)
{
    char shown[BAT_SHOWN_SIZE];
    batten_notes_add(obj->input->notes, obj->input->file, obj->scan.line, "",
                     "unknown statement '%.40s'", bat_shown(word.bytes, word.length, shown));
    obj->input->left_out++;
}

static batten_status read_statement(bat_obj *obj, bat_span word)
{
    static const char *const passed[] = {
        "vp",  "mtllib", "usemtl", "s",          "mg",    "bevel", "c_interp",  "d_interp",
        "lod", "maplib", "usemap", "shadow_obj", "ctech", "stech", "trace_obj", NULL};
    bool is_such = false;
    if (bat_word_is(word, "v"))
        return read_vertex(obj);
    if (bat_word_is(word, "vn"))
        return read_normal(obj);
    if (bat_word_is(word, "f") || bat_word_is(word, "fo"))
        return read_element(obj, BAT_OBJ_FACE, 3);
    if (bat_word_is(word, "l"))
        return read_element(obj, BAT_OBJ_LINE, 2);
    if (bat_word_is(word, "p"))
        return read_element(obj, BAT_OBJ_POINT, 1);
    obj->textures += bat_word_is(word, "vt");
    obj->materials += bat_word_is(word, "usemtl");
    if (bat_word_is(word, "o") || bat_word_is(word, "g"))
        begin_part(obj, bat_word_is(word, "o"));
    else if (!bat_word_is(word, "vt") && !is_one_of(word, passed) && !is_of_material(word)) {
        batten_status status = bat_obj_free_statement(obj, word, &is_such);
        if (status != BATTEN_OK || is_such)
            return status;
        leave_unknown(obj, word);
    }
    return BATTEN_OK;
}

static batten_status read_line(bat_obj *obj)
{
    bat_span word;
    batten_status status = BATTEN_OK;
    if (bat_obj_next(obj, &word))
        status = read_statement(obj, word);
    while (status == BATTEN_OK && bat_obj_next(obj, &word))
        continue;
    obj->continues = false;
    return status;
}

static batten_status read_statements(bat_obj *obj)
{
    batten_status status = BATTEN_OK;
    size_t steps = 0;
    do {
        status = read_line(obj);
        if (status == BATTEN_OK && ++steps % 10000 == 0)
            status = bat_input_step(obj->input, (size_t)(obj->scan.at - obj->input->data));
    } while (status == BATTEN_OK && bat_next_scan_line(&obj->scan));
    bat_obj_free_close(obj);
    return status;
}

static void release(bat_obj *obj)
{
    const bat_obj_shape *shapes = obj->shapes.items;
    for (size_t i = 0; i < obj->shapes.count; i++)
        bat_obj_shape_end(&shapes[i]);
    bat_release(obj->vertices.items);
    bat_release(obj->normals.items);
    bat_release(obj->corners.items);
    bat_release(obj->elements.items);
    bat_release(obj->parts.items);
    bat_release(obj->shapes.items);
    bat_release(obj->free.corners.items);
    for (int k = 0; k < 2; k++) {
        bat_release(obj->free.matrix[k].items);
        bat_release(obj->free.knots[k].items);
    }
}

batten_status bat_read_obj(bat_input *input, batten_model **out)
{
    const bat_list numbers = {.size = sizeof(double)};
    bat_obj obj = {.input = input,
                   .scan = bat_scan_begin(input->data, input->size),
                   .vertices = {.size = sizeof(bat_obj_vertex)},
                   .normals = {.size = 3 * sizeof(double)},
                   .corners = {.size = sizeof(bat_obj_corner)},
                   .elements = {.size = sizeof(bat_obj_element)},
                   .parts = {.size = sizeof(bat_obj_part)},
                   .shapes = {.size = sizeof(bat_obj_shape)},
                   .is_new_part = true,
                   .free = {.matrix = {numbers, numbers},
                            .knots = {numbers, numbers},
                            .corners = {.size = sizeof(bat_obj_corner)}}};
    batten_model *model = NULL;
    batten_status status = read_statements(&obj);
    if (status == BATTEN_OK)
        status = batten_model_create(0, &model);
    if (status == BATTEN_OK)
        status = bat_obj_finish(&obj, model);
    if (status == BATTEN_OK && batten_model_count(model) == 0)
        status =
            bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "there is no vertex, face or curve");
    release(&obj);
    return bat_input_hand_over(status, model, out);
}
