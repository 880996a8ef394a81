/* A body as it grows, part after part. */
#include "body/builder.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>

/* The arrays are the builder's own; the parts show them as const. */
static void *own(const void *memory)
{
    return (void *)(uintptr_t)memory;
}

void bat_builder_begin(bat_builder *builder, double tolerance)
{
    *builder = (bat_builder){.parts = {.tolerance = tolerance}};
}

/* Room for one more of `count` items of `size` bytes in *array. */
static batten_status grow_list(int count, int *room, size_t size, const void *array, void **out)
{
    *out = own(array);
    if (count < *room)
        return BATTEN_OK;
    if (count > INT_MAX / 2)
        return bat_fail(BATTEN_TOO_LARGE, "a body has room for %d parts of a kind",
                        INT_MAX / 2);
    const int wanted = bat_max_int(16, 2 * count);
    void *larger = bat_resize(own(array), (size_t)wanted, size);
    if (!larger)
        return BATTEN_OUT_OF_MEMORY;
    *room = wanted;
    *out = larger;
    return BATTEN_OK;
}

batten_status bat_builder_vertex(bat_builder *builder, const double point[3], int *index)
{
    batten_body_parts *p = &builder->parts;
    void *room = NULL;
    batten_status status = grow_list(p->vertex_count, &builder->vertex_room, 3 * sizeof(double),
                                     p->vertices, &room);
    p->vertices = room;
    if (status != BATTEN_OK)
        return status;
    memcpy((double *)room + 3 * (size_t)p->vertex_count, point, 3 * sizeof(double));
    *index = p->vertex_count++;
    return BATTEN_OK;
}

batten_status bat_builder_edge(bat_builder *builder, const batten_curve *curve, int start,
                               int end, int *index)
{
    batten_body_parts *p = &builder->parts;
    void *room = NULL;
    batten_status status = grow_list(p->edge_count, &builder->edge_room,
                                     sizeof(batten_body_edge), p->edges, &room);
    p->edges = room;
    if (status != BATTEN_OK)
        return status;
    ((batten_body_edge *)room)[p->edge_count] = (batten_body_edge){
        .curve = curve ? batten_curve_ref(curve) : NULL, .vertices = {start, end}};
    *index = p->edge_count++;
    return BATTEN_OK;
}

batten_status bat_builder_shell(bat_builder *builder, bool closed)
{
    batten_body_parts *p = &builder->parts;
    void *room = NULL;
    batten_status status = grow_list(p->shell_count, &builder->shell_room,
                                     sizeof(batten_body_shell), p->shells, &room);
    p->shells = room;
    if (status != BATTEN_OK)
        return status;
    ((batten_body_shell *)room)[p->shell_count++] =
        (batten_body_shell){.first = p->face_count, .closed = closed};
    return BATTEN_OK;
}

batten_status bat_builder_face(bat_builder *builder, const batten_body_face *face)
{
    batten_body_parts *p = &builder->parts;
    const char *name = face->name ? face->name : "";
    void *room = NULL;
    assert(p->shell_count > 0);
    batten_status status = grow_list(p->face_count, &builder->face_room,
                                     sizeof(batten_body_face), p->faces, &room);
    p->faces = room;
    if (status != BATTEN_OK)
        return status;
    char *copied = bat_array(strlen(name) + 1, 1);
    if (!copied)
        return BATTEN_OUT_OF_MEMORY;
    strcpy(copied, name);
    batten_body_face *made = &((batten_body_face *)room)[p->face_count++];
    *made = *face;
    made->name = copied;
    made->surface = batten_surface_ref(face->surface);
    made->first = p->loop_count;
    made->count = 0;
    ((batten_body_shell *)own(p->shells))[p->shell_count - 1].count++;
    return BATTEN_OK;
}

batten_status bat_builder_loop(bat_builder *builder)
{
    batten_body_parts *p = &builder->parts;
    void *room = NULL;
    assert(p->face_count > 0);
    batten_status status = grow_list(p->loop_count, &builder->loop_room,
                                     sizeof(batten_body_loop), p->loops, &room);
    p->loops = room;
    if (status != BATTEN_OK)
        return status;
    ((batten_body_loop *)room)[p->loop_count++] = (batten_body_loop){.first = p->use_count};
    ((batten_body_face *)own(p->faces))[p->face_count - 1].count++;
    return BATTEN_OK;
}

batten_status bat_builder_use(bat_builder *builder, int edge, bool reversed,
                              const batten_curve *parameters)
{
    batten_body_parts *p = &builder->parts;
    void *room = NULL;
    assert(p->loop_count > 0);
    batten_status status =
        grow_list(p->use_count, &builder->use_room, sizeof(batten_body_use), p->uses, &room);
    p->uses = room;
    if (status != BATTEN_OK)
        return status;
    ((batten_body_use *)room)[p->use_count++] =
        (batten_body_use){.edge = edge,
                          .reversed = reversed,
                          .parameters = parameters ? batten_curve_ref(parameters) : NULL};
    ((batten_body_loop *)own(p->loops))[p->loop_count - 1].count++;
    return BATTEN_OK;
}

int bat_builder_mark(const bat_builder *builder)
{
    return builder->parts.face_count;
}

static void turn_loop(int count, batten_body_use *uses)
{
    for (int i = 0; i < count / 2; i++) {
        const batten_body_use kept = uses[i];
        uses[i] = uses[count - 1 - i];
        uses[count - 1 - i] = kept;
    }
    for (int i = 0; i < count; i++)
        uses[i].reversed = !uses[i].reversed;
}

void bat_builder_turn(bat_builder *builder, int face)
{
    const batten_body_face *f = &builder->parts.faces[face];
    batten_body_use *uses = own(builder->parts.uses);
    for (int l = f->first; l < f->first + f->count; l++) {
        const batten_body_loop loop = builder->parts.loops[l];
        turn_loop(loop.count, uses + loop.first);
    }
}

void bat_builder_open_shells(bat_builder *builder)
{
    for (int k = 0; k < builder->parts.shell_count; k++)
        ((batten_body_shell *)own(builder->parts.shells))[k].closed = false;
}

void bat_builder_back(bat_builder *builder, int mark)
{
    batten_body_parts *p = &builder->parts;
    while (p->face_count > mark) {
        const batten_body_face *face = &p->faces[--p->face_count];
        const int uses = face->count ? p->loops[face->first].first : p->use_count;
        while (p->use_count > uses)
            batten_curve_unref(own(p->uses[--p->use_count].parameters));
        p->loop_count = face->first;
        batten_surface_unref(own(face->surface));
        bat_release(own(face->name));
        batten_body_shell *shells = own(p->shells);
        shells[p->shell_count - 1].count--;
        while (p->shell_count > 1 && shells[p->shell_count - 1].count == 0 &&
               shells[p->shell_count - 1].first > mark)
            p->shell_count--;
    }
}

void bat_builder_end(bat_builder *builder)
{
    batten_body_parts *p = &builder->parts;
    for (int i = 0; i < p->edge_count; i++)
        batten_curve_unref(own(p->edges[i].curve));
    for (int i = 0; i < p->use_count; i++)
        batten_curve_unref(own(p->uses[i].parameters));
    for (int i = 0; i < p->face_count; i++) {
        batten_surface_unref(own(p->faces[i].surface));
        bat_release(own(p->faces[i].name));
    }
    bat_release(own(p->vertices));
    bat_release(own(p->edges));
    bat_release(own(p->uses));
    bat_release(own(p->loops));
    bat_release(own(p->faces));
    bat_release(own(p->shells));
    *builder = (bat_builder){.parts = {.tolerance = p->tolerance}};
}

/* ---- without what nobody uses ---- */

/* Edges in use keep their order. */
static void keep_edges(batten_body_parts *p, int *numbers)
{
    batten_body_edge *edges = own(p->edges);
    int kept = 0;
    for (int i = 0; i < p->edge_count; i++)
        if (numbers[i]) {
            numbers[i] = kept;
            edges[kept++] = edges[i];
        } else
            batten_curve_unref(own(edges[i].curve));
    p->edge_count = kept;
}

/* Edges in use keep their order, and get new numbers. */
static void drop_edges(batten_body_parts *p, int *numbers)
{
    batten_body_use *uses = own(p->uses);
    for (int i = 0; i < p->use_count; i++)
        numbers[uses[i].edge] = 1;
    keep_edges(p, numbers);
    for (int i = 0; i < p->use_count; i++)
        uses[i].edge = numbers[uses[i].edge];
}

static void drop_vertices(batten_body_parts *p, int *numbers)
{
    batten_body_edge *edges = own(p->edges);
    double *vertices = own(p->vertices);
    int kept = 0;
    for (int i = 0; i < p->edge_count; i++)
        numbers[edges[i].vertices[0]] = numbers[edges[i].vertices[1]] = 1;
    for (int i = 0; i < p->vertex_count; i++)
        if (numbers[i]) {
            numbers[i] = kept;
            memmove(&vertices[3 * (size_t)kept++], &vertices[3 * (size_t)i],
                    3 * sizeof *vertices);
        }
    p->vertex_count = kept;
    for (int i = 0; i < p->edge_count; i++)
        for (int k = 0; k < 2; k++)
            edges[i].vertices[k] = numbers[edges[i].vertices[k]];
}

static void drop_shells(batten_body_parts *p)
{
    batten_body_shell *shells = own(p->shells);
    int kept = 0;
    for (int i = 0; i < p->shell_count; i++)
        if (shells[i].count > 0)
            shells[kept++] = shells[i];
    p->shell_count = kept;
}

batten_status bat_builder_finish(bat_builder *builder, bool is_solid, batten_body **out)
{
    batten_body_parts *p = &builder->parts;
    int *edges = bat_array((size_t)p->edge_count, sizeof *edges);
    int *vertices = bat_array((size_t)p->vertex_count, sizeof *vertices);
    batten_status status = edges && vertices ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        drop_edges(p, edges);
        drop_vertices(p, vertices);
        drop_shells(p);
        p->is_solid = is_solid;
        status = batten_body_create(p, out);
    }
    bat_release(edges);
    bat_release(vertices);
    bat_builder_end(builder);
    return status;
}
