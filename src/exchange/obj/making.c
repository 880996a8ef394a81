/* Corners checked, names and looks of the objects of a part. */
#include "exchange/obj/objects.h"
#include <stdlib.h>
#include <string.h>

const bat_obj_vertex *bat_obj_vertex_at(const bat_obj *obj, int64_t index)
{
    return (const bat_obj_vertex *)obj->vertices.items + index;
}

bool bat_obj_is_vertex(const bat_obj *obj, int64_t index)
{
    return (uint64_t)index < obj->vertices.count &&
           bat_first_not_finite(bat_obj_vertex_at(obj, index)->point, 3) == 3;
}

static bool is_normal(const bat_obj *obj, int64_t index)
{
    return index == INT64_MIN ||
           ((uint64_t)index < obj->normals.count &&
            bat_first_not_finite((const double *)obj->normals.items + 3 * index, 3) == 3);
}

bool bat_obj_check_corners(const bat_obj_making *m, const bat_obj_element *element)
{
    const bat_obj *obj = m->obj;
    const bat_obj_corner *corners = (const bat_obj_corner *)obj->corners.items + element->first;
    size_t k = 0;
    while (k < element->count && bat_obj_is_vertex(obj, corners[k].vertex) &&
           is_normal(obj, corners[k].normal))
        k++;
    if (k == element->count)
        return true;
    const bool no_vertex = !bat_obj_is_vertex(obj, corners[k].vertex);
    batten_notes_add(obj->input->notes, obj->input->file, element->line, "",
                     "the element is left out: its corner %zu has %s %lld, which does not "
                     "exist",
                     k + 1, no_vertex ? "vertex" : "normal",
                     (long long)(no_vertex ? corners[k].vertex : corners[k].normal) + 1);
    obj->input->left_out++;
    return false;
}

/* ---- names ---- */

static batten_status copy_span(bat_input *input, bat_span span, const char *otherwise,
                               char **out)
{
    if (span.length == 0)
        span = (bat_span){otherwise, strlen(otherwise)};
    bat_release(*out);
    *out = NULL;
    batten_status status = bat_input_array(input, span.length + 1, 1, out);
    if (status == BATTEN_OK)
        bat_word_copy(span, span.length + 1, *out);
    return status;
}

batten_status bat_obj_name_part(bat_obj_making *m, const bat_obj_part *part,
                                const char *otherwise)
{
    bat_input *input = m->obj->input;
    const bool both = part->object.length && part->group.length;
    batten_status status =
        copy_span(input, part->group.length ? part->group : part->object, otherwise, &m->name);
    if (status == BATTEN_OK)
        status = copy_span(input, both ? part->object : (bat_span){"", 0}, "", &m->group);
    return status;
}

batten_status bat_obj_add_object(bat_obj_making *m, const bat_obj_part *part,
                                 batten_object object, const char *otherwise)
{
    batten_status status = bat_obj_name_part(m, part, otherwise);
    object.name = m->name;
    object.group = m->group;
    return status == BATTEN_OK ? batten_model_add(m->model, &object) : status;
}
