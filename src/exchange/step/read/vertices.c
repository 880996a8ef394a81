/* Vertices, shared as the file shares them. */
#include "base/sets.h"
#include "exchange/step/read/topology.h"

#include <stdio.h>

uint32_t bat_step_index(const bat_step_file *file, const bat_step_instance *instance)
{
    return (uint32_t)(instance - (const bat_step_instance *)file->instances.items);
}

bat_step_made *bat_step_made_of(const bat_step_topology *t, const bat_step_instance *instance)
{
    return &t->made[bat_step_index(t->file, instance)];
}

uint32_t bat_step_stamp(const bat_step_topology *t, bat_step_sort sort)
{
    return sort == BAT_STEP_FACE ? (uint32_t)sort : t->body << 3 | (uint32_t)sort;
}

batten_status bat_step_spend(bat_step_topology *t, const bat_step_instance *instance,
                             size_t count)
{
    if (count > t->work)
        return bat_step_fail(t->file, instance, BATTEN_TOO_LARGE,
                             "the file refers to the same long lists over and over");
    t->work -= count;
    return BATTEN_OK;
}

void bat_step_warn(const bat_step_file *file, const bat_step_instance *instance,
                   const char *format, ...)
{
    char entity[BAT_STEP_KEYWORD_SIZE + 24], keyword[BAT_STEP_KEYWORD_SIZE], text[512];
    va_list arguments;
    va_start(arguments, format);
    bat_format(text, sizeof text, format, arguments);
    va_end(arguments);
    snprintf(entity, sizeof entity, "#%llu %s", (unsigned long long)instance->id,
             bat_step_keyword(file, instance, keyword));
    batten_notes_add(file->input->notes, file->input->file, bat_step_line(file, instance->at),
                     entity, "%s", text);
}

/* ---- vertices ---- */

const double *bat_step_vertex_point(const bat_step_topology *t, int vertex)
{
    return &t->builder.parts.vertices[3 * (size_t)vertex];
}

int bat_step_root(const bat_step_topology *t, int vertex)
{
    return (size_t)vertex < t->roots.count ? bat_sets_root(t->roots.items, vertex) : vertex;
}

batten_status bat_step_unite(bat_step_topology *t, int a, int b)
{
    const int high = bat_max_int(a, b);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && t->roots.count <= (size_t)high) {
        const int next = (int)t->roots.count;
        status = bat_list_add(t->file->input, &t->roots, &next);
    }
    if (status == BATTEN_OK)
        bat_sets_join(t->roots.items, a, b);
    return status;
}

int bat_step_end_of(const bat_step_topology *t, const bat_step_use *use, int k)
{
    const batten_body_edge *edge = &t->builder.parts.edges[use->edge];
    return bat_step_root(t, edge->vertices[use->reversed ? 1 - k : k]);
}

batten_status bat_step_vertex_at(bat_step_topology *t, const bat_step_instance *point,
                                 int *index)
{
    bat_step_made *made = bat_step_made_of(t, point);
    if (made->stamp == bat_step_stamp(t, BAT_STEP_POINT_VERTEX)) {
        *index = made->index;
        return BATTEN_OK;
    }
    double at[3];
    batten_status status = bat_step_read_point(t->file, point, &t->scale, at);
    if (status == BATTEN_OK)
        status = bat_builder_vertex(&t->builder, at, index);
    if (status == BATTEN_OK)
        *made = (bat_step_made){bat_step_stamp(t, BAT_STEP_POINT_VERTEX), *index};
    return status;
}

batten_status bat_step_read_vertex(bat_step_topology *t, const bat_step_instance *instance,
                                   int *index)
{
    const bat_step_record *record = bat_step_as(t->file, instance, "VERTEX_POINT");
    const bat_step_instance *point = NULL;
    bat_step_made *made = bat_step_made_of(t, instance);
    if (record && made->stamp == bat_step_stamp(t, BAT_STEP_VERTEX)) {
        *index = made->index;
        return BATTEN_OK;
    }
    if (!record)
        return bat_step_fail(t->file, instance, BATTEN_BAD_FORMAT,
                             "it is given where a VERTEX_POINT is expected");
    batten_status status = bat_step_get_reference(t->file, record, 1, &point);
    if (status == BATTEN_OK)
        status = bat_step_vertex_at(t, point, index);
    if (status == BATTEN_OK)
        *made = (bat_step_made){bat_step_stamp(t, BAT_STEP_VERTEX), *index};
    return status;
}
