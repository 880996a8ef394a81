/* Reads OFF: vertices and faces, with colours where there are any. */
#include "exchange/meshes/indexed.h"
#include "exchange/off/off.h"
#include "exchange/reading/scan.h"

#include <limits.h>
#include <string.h>

typedef struct {
    bat_input *input;
    bat_scan scan;
    bat_indexed mesh;
    bool has_normals;
    size_t faces;
    size_t face_colours;
} reading;

/* The first word of the next line that is neither blank nor a comment. */
static bool next_line(bat_scan *scan, bat_span *word)
{
    while (bat_next_word(scan, word)) {
        if (word->bytes[0] != '#')
            return true;
        bat_rest_of_line(scan);
    }
    return false;
}

batten_status bat_off_recognise(const bat_input *input, bool *is_such)
{
    static const char *const others[] = {"STOFF",   "4OFF",   "nOFF",
                                         "STCNOFF", "STNOFF", "STCOFF"};
    bat_span word;
    const size_t at = bat_past_white(input);
    bat_scan scan = bat_scan_begin(input->data + at, input->size - at);
    *is_such = false;
    if (!next_line(&scan, &word))
        return BATTEN_OK;
    for (size_t k = 0; k < sizeof others / sizeof others[0]; k++)
        if (bat_word_is(word, others[k]))
            return bat_input_fail(input, BATTEN_UNSUPPORTED, 0,
                                  "OFF files of the form %s are not read", others[k]);
    *is_such = bat_word_is(word, "OFF") || bat_word_is(word, "COFF") ||
               bat_word_is(word, "NOFF") || bat_word_is(word, "CNOFF");
    if (*is_such && bat_next_in_line(&scan, &word) && bat_word_is(word, "BINARY"))
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "binary OFF files are not read");
    return BATTEN_OK;
}

static bool next_in_line(reading *r, bat_span *word)
{
    if (!bat_next_in_line(&r->scan, word))
        return false;
    if (word->bytes[0] != '#')
        return true;
    bat_rest_of_line(&r->scan);
    return false;
}

static batten_status read_header(reading *r, size_t *vertices)
{
    bat_span word;
    int64_t counts[2] = {0, 0};
    bat_input *input = r->input;
    if (!next_line(&r->scan, &word))
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "the file is empty");
    if (word.length < 3 || !bat_word_is((bat_span){word.bytes + word.length - 3, 3}, "OFF"))
        return bat_input_fail(input, BATTEN_BAD_FORMAT, r->scan.line,
                              "the first word is not OFF");
    r->has_normals = memchr(word.bytes, 'N', word.length) != NULL;
    bool good = next_line(&r->scan, &word) && bat_word_integer(word, 0, INT_MAX, &counts[0]);
    good = good && next_in_line(r, &word) && bat_word_integer(word, 0, INT_MAX, &counts[1]);
    bat_rest_of_line(&r->scan);
    if (!good)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, r->scan.line,
                              "the counts of vertices and faces are missing");
    *vertices = (size_t)counts[0];
    r->faces = (size_t)counts[1];
    return BATTEN_OK;
}

static void leave_out_vertex(reading *r, size_t index, int before)
{
    r->input->left_out++;
    batten_notes_add(r->input->notes, r->input->file, r->scan.line, "",
                     "vertex %zu is left out: it is not of %d numbers", index + 1, before);
}

static bool read_numbers(reading *r, bat_span word, double numbers[10], int *count)
{
    bool good = true;
    bool more = true;
    for (; more; more = next_in_line(r, &word))
        if (*count < 10) {
            good = bat_word_real(r->input, r->scan.line, word, &numbers[*count]) && good;
            ++*count;
        }
    return good;
}

/* A vertex is x y z, a normal when the header says so, and a colour when more follows: parts of
 * 1, or of 255 when they are whole numbers and one is above 1. */
static void read_vertex(reading *r, bat_span word, size_t index)
{
    double numbers[10];
    int count = 0;
    bool good = read_numbers(r, word, numbers, &count);
    const int before = r->has_normals ? 6 : 3;
    good = good && count >= before;
    for (int k = 0; k < 3; k++) {
        r->mesh.points[3 * index + (size_t)k] = good ? numbers[k] : (double)NAN;
        if (r->mesh.normals)
            r->mesh.normals[3 * index + (size_t)k] = good ? numbers[3 + k] : 0;
        r->mesh.colours[3 * index + (size_t)k] =
            good && count >= before + 3 ? numbers[before + k] : (double)NAN;
    }
    if (!good)
        leave_out_vertex(r, index, before);
}

static void note_cut(reading *r, size_t said)
{
    r->input->is_cut = true;
    batten_notes_add(r->input->notes, r->input->file, 0, "",
                     "%zu of %zu vertices are in the file", r->mesh.count, said);
}

/* The last of them are normals when the header says so. */
static batten_status make_arrays(reading *r, size_t count)
{
    bat_input *input = r->input;
    batten_status status = bat_input_limit(input, 0, count, input->limits.points, "vertices");
    if (status == BATTEN_OK)
        status = bat_input_array(input, count, 3 * sizeof(double), &r->mesh.points);
    if (status == BATTEN_OK)
        status = bat_input_array(input, count, 3 * sizeof(double), &r->mesh.colours);
    if (status == BATTEN_OK && r->has_normals)
        status = bat_input_array(input, count, 3 * sizeof(double), &r->mesh.normals);
    return status;
}

static batten_status read_vertices(reading *r, size_t said)
{
    bat_span word;
    bat_input *input = r->input;
    /* "0 0 0" and the end of its line are 6 bytes. */
    const size_t room = ((size_t)(r->scan.end - r->scan.at) + 1) / 6;
    const size_t count = said < room ? said : room;
    batten_status status = make_arrays(r, count);
    for (size_t i = 0; status == BATTEN_OK && i < count && next_line(&r->scan, &word); i++) {
        read_vertex(r, word, i);
        r->mesh.count = i + 1;
        if (i % 10000 == 9999)
            status = bat_input_step(input, (size_t)(r->scan.at - input->data));
    }
    if (status == BATTEN_OK && r->mesh.count < said)
        note_cut(r, said);
    return status;
}

/* Colours are there when each vertex that was read has one. */
static void scale_colours(bat_indexed *mesh)
{
    double largest = 0;
    bool whole = true, all = true;
    for (size_t i = 0; i < 3 * mesh->count; i++) {
        const double c = mesh->colours[i];
        const bool is_read = bat_first_not_finite(mesh->points + 3 * (i / 3), 3) == 3;
        all = all && (!is_read || isfinite(c));
        whole = whole && c == floor(c);
        largest = bat_max(largest, c);
    }
    if (!all) {
        bat_release(mesh->colours);
        mesh->colours = NULL;
    }
    for (size_t i = 0; all && whole && largest > 1 && i < 3 * mesh->count; i++)
        mesh->colours[i] /= 255;
}

static batten_status read_face(reading *r, bat_span word, size_t index)
{
    int64_t count = 0, corner = 0;
    bool good = bat_word_integer(word, 0, INT_MAX, &count);
    batten_status status = BATTEN_OK;
    for (int64_t k = 0; status == BATTEN_OK && good && k < count; k++) {
        good = next_in_line(r, &word);
        if (!good)
            break;
        if (!bat_word_integer(word, 0, INT_MAX, &corner))
            corner = -1;
        status = bat_list_add(r->input, &r->mesh.polygon, &corner);
    }
    if (status != BATTEN_OK)
        return status;
    if (good) {
        status = bat_indexed_polygon(&r->mesh, r->scan.line);
        r->face_colours += next_in_line(r, &word);
    } else
        bat_indexed_leave_out(&r->mesh, r->scan.line, index,
                              "its count or a corner is missing");
    bat_rest_of_line(&r->scan);
    return status;
}

static batten_status read_faces(reading *r)
{
    bat_span word;
    batten_status status = BATTEN_OK;
    size_t i = 0;
    for (; status == BATTEN_OK && i < r->faces && next_line(&r->scan, &word); i++) {
        status = read_face(r, word, i);
        if (status == BATTEN_OK && i % 10000 == 9999)
            status = bat_input_step(r->input, (size_t)(r->scan.at - r->input->data));
    }
    if (status == BATTEN_OK && i < r->faces) {
        r->input->is_cut = true;
        batten_notes_add(r->input->notes, r->input->file, 0, "",
                         "%zu of %zu faces are in the file", i, r->faces);
    }
    if (status == BATTEN_OK && !r->input->is_cut)
        bat_input_behind(r->input, (size_t)(r->scan.at - r->input->data));
    if (r->face_colours)
        batten_notes_add(r->input->notes, r->input->file, 0, "",
                         "the colours of %zu faces are left out", r->face_colours);
    return status;
}

batten_status bat_read_off(bat_input *input, batten_model **out)
{
    reading r = {.input = input,
                 .scan = bat_scan_begin(input->data, input->size),
                 .mesh = bat_indexed_begin(input)};
    batten_model *model = NULL;
    bool is_such;
    size_t vertices = 0;
    batten_status status = bat_off_recognise(input, &is_such);
    if (status == BATTEN_OK)
        status = read_header(&r, &vertices);
    if (status == BATTEN_OK)
        status = read_vertices(&r, vertices);
    if (status == BATTEN_OK && r.mesh.colours)
        scale_colours(&r.mesh);
    if (status == BATTEN_OK)
        status = read_faces(&r);
    if (status == BATTEN_OK)
        status = batten_model_create(0, &model);
    if (status == BATTEN_OK)
        status = bat_indexed_add(&r.mesh, "mesh", model);
    if (status == BATTEN_OK && batten_model_count(model) == 0 &&
        (input->is_cut || input->left_out))
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "no vertex could be read");
    bat_indexed_end(&r.mesh);
    return bat_input_hand_over(status, model, out);
}
