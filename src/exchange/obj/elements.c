/* The words of OBJ statements, and the elements that they make of corners. */
#include "exchange/obj/obj.h"

#include <limits.h>

static bool at_end_of_line(const bat_scan *scan)
{
    return scan->at >= scan->end || *scan->at == '\n' || *scan->at == '\r';
}

bool bat_obj_next(bat_obj *obj, bat_span *word)
{
    for (;;) {
        if (obj->continues)
            bat_next_scan_line(&obj->scan);
        obj->continues = false;
        if (!bat_next_in_line(&obj->scan, word))
            return false;
        if (word->bytes[0] == '#') {
            bat_rest_of_line(&obj->scan);
            return false;
        }
        if (word->bytes[word->length - 1] != '\\' || !at_end_of_line(&obj->scan))
            return true;
        obj->continues = true;
        if (--word->length > 0)
            return true;
    }
}

bool bat_obj_number(bat_obj *obj, double *value)
{
    bat_span word;
    return bat_obj_next(obj, &word) && bat_word_real(obj->input, obj->scan.line, word, value);
}

/* An index counts from 1, or back from the last one so far. */
static bool read_index(bat_span word, size_t count, int64_t *index)
{
    int64_t number = 0;
    if (!bat_word_integer(word, -INT_MAX, INT_MAX, &number) || number == 0)
        return false;
    *index = number > 0 ? number - 1 : (int64_t)count + number;
    return *index >= 0;
}

static bool split_corner(bat_span word, bat_span parts[3])
{
    int part = 0;
    for (size_t i = 0; i < word.length; i++)
        if (word.bytes[i] != '/')
            parts[part].length++;
        else if (++part < 3)
            parts[part].bytes = word.bytes + i + 1;
        else
            return false;
    return true;
}

/* "7", "7/2", "7//3", "7/2/3". */
static bool read_corner(const bat_obj *obj, bat_span word, bat_obj_corner *corner)
{
    bat_span parts[3] = {{word.bytes, 0}, {NULL, 0}, {NULL, 0}};
    if (!split_corner(word, parts))
        return false;
    *corner = (bat_obj_corner){INT64_MIN, INT64_MIN};
    return read_index(parts[0], obj->vertices.count, &corner->vertex) &&
           (parts[2].length == 0 || read_index(parts[2], obj->normals.count, &corner->normal));
}

batten_status bat_obj_corners(bat_obj *obj, bat_list *corners, int *bad)
{
    bat_span word;
    batten_status status = BATTEN_OK;
    *bad = 0;
    while (status == BATTEN_OK && bat_obj_next(obj, &word)) {
        bat_obj_corner corner;
        *bad += !read_corner(obj, word, &corner);
        status = bat_list_add(obj->input, corners, &corner);
    }
    return status;
}

batten_status bat_obj_add(bat_obj *obj, const bat_obj_element *element)
{
    bat_input *input = obj->input;
    batten_status status = bat_input_limit(input, element->line, obj->elements.count + 1,
                                           input->limits.entities, "elements");
    if (status == BATTEN_OK && obj->is_new_part) {
        const bat_obj_part part = {obj->object, obj->group, obj->elements.count};
        obj->is_new_part = false;
        status = bat_list_add(input, &obj->parts, &part);
    }
    return status == BATTEN_OK ? bat_list_add(input, &obj->elements, element) : status;
}

batten_status bat_obj_limit(bat_input *input, int line, size_t count, size_t limit,
                            const char *what)
{
    const size_t most = INT_MAX / 3;
    return bat_input_limit(input, line, count, limit < most ? limit : most, what);
}
