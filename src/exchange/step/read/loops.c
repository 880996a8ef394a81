/* The loops of faces: uses of edges, head to tail. */
#include "base/plural.h"
#include "exchange/step/read/topology.h"
#include "numeric/vector.h"

/* Gaps of up to so many tolerances are closed. */
enum { FAR = 100 };

/* ---- loops ---- */

static batten_status end_loop(bat_step_topology *t, size_t first)
{
    const int count = (int)(t->uses.count - first);
    return count ? bat_list_add(t->file->input, &t->loops, &count) : BATTEN_OK;
}

static void reverse_uses(bat_step_topology *t, size_t first)
{
    bat_step_use *uses = (bat_step_use *)t->uses.items + first;
    const size_t count = t->uses.count - first;
    for (size_t k = 0; k < count / 2; k++) {
        const bat_step_use kept = uses[k];
        uses[k] = uses[count - 1 - k];
        uses[count - 1 - k] = kept;
    }
    for (size_t k = 0; k < count; k++)
        uses[k].reversed = !uses[k].reversed;
}

/* Where one use ends the next must begin; vertices that nearly coincide become one. */
static batten_status close_loop(bat_step_topology *t, const bat_step_instance *loop,
                                size_t first)
{
    const bat_step_use *uses = (const bat_step_use *)t->uses.items + first;
    const size_t count = t->uses.count - first;
    const double *points = t->builder.parts.vertices;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < count; k++) {
        const size_t next = (k + 1) % count;
        const int a = bat_step_end_of(t, &uses[k], 1), b = bat_step_end_of(t, &uses[next], 0);
        if (a == b)
            continue;
        const double gap = bat_distance(3, &points[3 * (size_t)a], &points[3 * (size_t)b]);
        if (gap > FAR * t->scale.tolerance)
            return bat_step_fail(t->file, loop, BATTEN_BAD_FORMAT,
                                 "between its edges %zu and %zu is a gap of %g", k + 1,
                                 next + 1, gap);
        bat_step_warn(t->file, loop,
                      "between its edges %zu and %zu is a gap of %g; their vertices are "
                      "taken as one",
                      k + 1, next + 1, gap);
        status = bat_step_unite(t, a, b);
    }
    return status;
}

static batten_status read_use(bat_step_topology *t, const bat_step_instance *instance,
                              bat_step_use *use)
{
    const bat_step_record *record = bat_step_as(t->file, instance, "ORIENTED_EDGE");
    const bat_step_instance *edge = NULL;
    bool forward = true;
    if (!record)
        return bat_step_fail(t->file, instance, BATTEN_BAD_FORMAT,
                             "it is given where an ORIENTED_EDGE is expected");
    batten_status status = bat_step_get_reference(t->file, record, 3, &edge);
    if (status == BATTEN_OK)
        status = bat_step_get_logical(t->file, record, 4, &forward);
    if (status == BATTEN_OK)
        status = bat_step_read_edge(t, edge, &use->edge);
    use->reversed = !forward;
    return status;
}

static batten_status read_edge_loop(bat_step_topology *t, const bat_step_instance *loop,
                                    const bat_step_record *record)
{
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(t->file, record, 1, &count, &at);
    if (status == BATTEN_OK && count == 0)
        return bat_step_fail(t->file, loop, BATTEN_BAD_FORMAT, "the loop has no edges");
    if (status == BATTEN_OK)
        status = bat_step_spend(t, loop, (size_t)count);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *oriented = NULL;
        bat_step_use use;
        status = bat_step_item_reference(t->file, record, &at, &oriented);
        if (status == BATTEN_OK)
            status = read_use(t, oriented, &use);
        if (status == BATTEN_OK)
            status = bat_list_add(t->file->input, &t->uses, &use);
    }
    return status;
}

static batten_status read_polygon(bat_step_topology *t, const bat_step_instance *loop,
                                  const bat_step_record *record)
{
    const bat_step_instance *first = NULL, *from = NULL, *to = NULL;
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(t->file, record, 1, &count, &at);
    if (status == BATTEN_OK && count < 3)
        return bat_step_fail(t->file, loop, BATTEN_BAD_FORMAT, "the polygon has %d corner%s",
                             count, bat_plural(count));
    if (status == BATTEN_OK)
        status = bat_step_spend(t, loop, (size_t)count);
    if (status == BATTEN_OK)
        status = bat_step_item_reference(t->file, record, &at, &first);
    from = first;
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        bat_step_use use;
        to = first;
        if (k + 1 < count)
            status = bat_step_item_reference(t->file, record, &at, &to);
        if (status == BATTEN_OK)
            status = bat_step_straight_edge(t, from, to, &use);
        if (status == BATTEN_OK)
            status = bat_list_add(t->file->input, &t->uses, &use);
        from = to;
    }
    return status;
}

/* A loop without edges. Nothing hangs on it but what is said of an apex, so that a bad one is
 * no reason to do without its face. */
static batten_status read_vertex_loop(bat_step_topology *t, const bat_step_instance *loop)
{
    const bat_step_record *record = bat_step_as(t->file, loop, "VERTEX_LOOP");
    const bat_step_instance *vertex = NULL;
    batten_status status = bat_step_get_reference(t->file, record, 1, &vertex);
    if (status == BATTEN_OK)
        status = bat_step_read_vertex(t, vertex, &t->vertex_loop);
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED)
        return status;
    bat_step_warn(t->file, loop, "%.300s; the loop is ignored", batten_message());
    t->vertex_loop = -1;
    return BATTEN_OK;
}

static batten_status read_loop(bat_step_topology *t, const bat_step_instance *loop,
                               bool reversed)
{
    const bat_step_record *edges = bat_step_as(t->file, loop, "EDGE_LOOP");
    const bat_step_record *polygon = bat_step_as(t->file, loop, "POLY_LOOP");
    const size_t first = t->uses.count;
    if (bat_step_as(t->file, loop, "VERTEX_LOOP"))
        return read_vertex_loop(t, loop);
    if (!edges && !polygon)
        return bat_step_fail(t->file, loop, BATTEN_BAD_FORMAT,
                             "it is given where a loop is expected");
    batten_status status =
        edges ? read_edge_loop(t, loop, edges) : read_polygon(t, loop, polygon);
    if (status == BATTEN_OK && reversed)
        reverse_uses(t, first);
    if (status == BATTEN_OK)
        status = close_loop(t, loop, first);
    return status == BATTEN_OK ? end_loop(t, first) : status;
}

static batten_status read_bound(bat_step_topology *t, const bat_step_instance *bound,
                                bool flipped)
{
    const bat_step_record *record = bat_step_as(t->file, bound, "FACE_OUTER_BOUND");
    const bat_step_instance *loop = NULL;
    bool forward = true;
    if (!record)
        record = bat_step_as(t->file, bound, "FACE_BOUND");
    if (!record)
        return bat_step_fail(t->file, bound, BATTEN_BAD_FORMAT,
                             "it is given where a FACE_BOUND is expected");
    batten_status status = bat_step_get_reference(t->file, record, 1, &loop);
    if (status == BATTEN_OK)
        status = bat_step_get_logical(t->file, record, 2, &forward);
    return status == BATTEN_OK ? read_loop(t, loop, forward == flipped) : status;
}

batten_status bat_step_read_bounds(bat_step_topology *t, const bat_step_instance *face,
                                   const bat_step_record *record, bool flipped)
{
    int count = 0;
    size_t at = 0;
    t->uses.count = t->loops.count = 0;
    t->vertex_loop = -1;
    batten_status status = bat_step_get_list(t->file, record, 1, &count, &at);
    if (status == BATTEN_OK && count == 0)
        return bat_step_fail(t->file, face, BATTEN_BAD_FORMAT, "the face has no bounds");
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *bound = NULL;
        status = bat_step_item_reference(t->file, record, &at, &bound);
        if (status == BATTEN_OK)
            status = read_bound(t, bound, flipped);
    }
    return status;
}
