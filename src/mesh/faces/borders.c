/* Borders of faces in (u, v): finer samples of edges until none crosses itself. */
#include "mesh/faces/face.h"

#include <stdio.h>
#include <stdlib.h>

/* When finer samples alone have not helped for some rounds, corners are spread. */
enum { SPREAD_ROUND = 4, MOST_ROUNDS = 12 };

/* Edges of different curves between the same two vertices must not be one edge of the mesh. Samples inside an edge
 * are vertices of its own, so that only edges without any can be twins. */
static batten_status find_twins(const bat_meshing *m, bat_pairs *splits)
{
    bat_pairs seen;
    batten_status status = bat_pairs_begin(&seen, (size_t)m->point_count + 16);
    if (status != BATTEN_OK)
        return status;
    int *owner = bat_array((size_t)m->parts->edge_count, sizeof *owner);
    if (!owner)
        status = BATTEN_OUT_OF_MEMORY;
    for (int e = 0; status == BATTEN_OK && e < m->parts->edge_count; e++) {
        const int *ends = m->edges[e].vertex, known = seen.count;
        int index = 0, split;
        if (m->edges[e].count != 2)
            continue;
        status = bat_pairs_add(&seen, bat_min_int(ends[0], ends[1]),
                               bat_max_int(ends[0], ends[1]), &index);
        if (status == BATTEN_OK && index == known) {
            owner[index] = e;
            continue;
        }
        if (status == BATTEN_OK)
            status = bat_pairs_add(splits, owner[index], 0, &split);
        if (status == BATTEN_OK)
            status = bat_pairs_add(splits, e, 0, &split);
    }
    bat_release(owner);
    bat_pairs_end(&seen);
    return status;
}

static int compare_splits(const void *a, const void *b)
{
    const int *x = a, *y = b;
    return x[0] != y[0] ? (x[0] > y[0]) - (x[0] < y[0]) : (x[1] < y[1]) - (x[1] > y[1]);
}

/* Those of the first pair's edge, which stand side by side. */
static int count_of_edge(int count, const int (*pairs)[2])
{
    int same = 1;
    while (same < count && pairs[same][0] == pairs[0][0])
        same++;
    return same;
}

/* All splits are of one edge; its faces are asked again where one was made. */
static batten_status split_edge(bat_meshing *m, int count, const int (*splits)[2], bool *ask,
                                bool *any)
{
    const int edge = splits[0][0];
    int made = 0;
    const batten_status status = bat_meshing_split(m, count, splits, &made);
    *any = *any || made > 0;
    for (int k = m->edge_first[edge]; made && k < m->edge_first[edge + 1]; k++)
        ask[m->use_face[m->edge_uses[k]]] = true;
    return status;
}

/* Last segments first, so that the numbers of the others stay. */
batten_status bat_meshing_apply_splits(bat_meshing *m, bat_pairs *splits, bool *ask, bool *any)
{
    batten_status status = BATTEN_OK;
    qsort(splits->pairs, (size_t)splits->count, sizeof *splits->pairs, compare_splits);
    for (int i = 0, count; status == BATTEN_OK && i < splits->count; i += count) {
        const int(*first)[2] = (const int(*)[2])splits->pairs + i;
        count = count_of_edge(splits->count - i, first);
        status = split_edge(m, count, first, ask, any);
    }
    bat_pairs_clear(splits);
    return status;
}

bool bat_meshing_is_final(batten_status status)
{
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ||
           status == BATTEN_INCOMPLETE || status == BATTEN_TOO_LARGE;
}

void bat_meshing_give_up(bat_meshing *m, int face, const char *why)
{
    char entity[64];
    snprintf(entity, sizeof entity, "face %d", bat_meshing_number(m, face) + 1);
    const char *name = m->parts->faces[face].name;
    batten_notes_add(m->notes, "", 0, name && name[0] ? name : entity,
                     "face %d is left out of the mesh: %s", bat_meshing_number(m, face) + 1,
                     why);
    m->failed[face] = true;
    m->report.failed++;
}

/* The only samples of an arc that leaves a seam and comes back to it may be its ends: a border
 * of few samples on one line is asked for more at first. */
enum { LINE_ROUNDS = 3, MOST_ON_LINE = 64 };

/* Curves that bound a face lie on its surface, whole turns aside where it closes. What is this many widths of the
 * domain away is damaged, and beside it all else of the border is one point. */
enum { FAR_WIDTHS = 1000 };

static batten_status check_reach(const bat_meshing *m, int face, const batten_interval box[2])
{
    for (int k = 0; k < 2; k++) {
        const batten_interval domain = m->sheets[face].domain[k];
        const double far = FAR_WIDTHS * (domain.b - domain.a);
        if (!(box[k].a >= domain.a - far && box[k].b <= domain.b + far))
            return bat_fail(
                BATTEN_OUT_OF_DOMAIN,
                "its border runs to %c = %g, far outside its surface, which ends at %g; correct "
                "the curve that bounds it there",
                k ? 'v' : 'u', box[k].a >= domain.a - far ? box[k].b : box[k].a,
                box[k].a >= domain.a - far ? domain.b : domain.a);
    }
    return BATTEN_OK;
}

static batten_status try_border(bat_meshing *m, int face, int round, bat_pairs *splits,
                                bool *simple)
{
    bool is_line = false;
    bat_rim rim;
    bat_sides sides = {0};
    bat_lattice lattice = {0};
    batten_interval box[2];
    *simple = false;
    batten_status status = bat_rim_begin(&rim, m, face, NULL);
    if (status != BATTEN_OK)
        return status;
    if (rim.count >
        (double)m->most + 1000) /* each side is one of a triangle; edges were fewer */
        status = bat_fail(BATTEN_COINCIDENT, "its border crosses or touches itself in (u, v)");
    else
        status = bat_work_step(&m->work, (uint64_t)rim.count, 0.1, "borders of faces");
    bat_rim_box(&rim, box);
    if (status == BATTEN_OK)
        status = check_reach(m, face, box);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        if (!(box[k].b > box[k].a)) {
            if (round < LINE_ROUNDS && rim.count <= MOST_ON_LINE)
                status = bat_rim_refine_all(&rim, splits);
            else
                status =
                    bat_fail(BATTEN_COINCIDENT, "its border is a line in (u, v), at %c = %g",
                             k ? 'v' : 'u', box[k].a);
            is_line = true;
        }
    if (status == BATTEN_OK && !is_line)
        status = bat_lattice_begin(&lattice, m, &m->sheets[face], box);
    if (status == BATTEN_OK && !is_line)
        status = bat_rim_triangles(&rim, &lattice, &sides, splits, simple);
    bat_sides_end(&sides);
    bat_lattice_end(&lattice);
    bat_rim_end(&rim);
    return status;
}

/* *any: some face is to be tried again. */
static batten_status try_borders(bat_meshing *m, bat_pairs *splits, int round, bool *ask,
                                 bool *any)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < m->parts->face_count; i++) {
        bool simple = false;
        if (!ask[i] || m->failed[i])
            continue;
        status = try_border(m, i, round, splits, &simple);
        if (status != BATTEN_OK && !bat_meshing_is_final(status)) {
            bat_meshing_give_up(m, i, batten_message());
            status = BATTEN_OK;
            simple = true;
        }
        ask[i] = !simple;
        if (!simple && round == MOST_ROUNDS && status == BATTEN_OK)
            bat_meshing_give_up(m, i, "its border crosses or touches itself in (u, v)");
        if (!simple && round == SPREAD_ROUND)
            *any = m->spread[i] = true;
    }
    return status;
}

batten_status bat_meshing_settle(bat_meshing *m)
{
    bat_pairs splits;
    batten_status status = bat_pairs_begin(&splits, 64);
    if (status != BATTEN_OK)
        return status;
    bool *ask = bat_array((size_t)m->parts->face_count, sizeof *ask), any = true;
    if (!ask)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; ask && i < m->parts->face_count; i++)
        ask[i] = m->parts->faces[i].count > 0;
    for (int round = 0; status == BATTEN_OK && any; round++) {
        const bool last = round == MOST_ROUNDS;
        any = false;
        status = find_twins(m, &splits);
        if (status == BATTEN_OK)
            status = try_borders(m, &splits, round, ask, &any);
        if (status == BATTEN_OK && !last)
            status = bat_meshing_apply_splits(m, &splits, ask, &any);
    }
    bat_release(ask);
    bat_pairs_end(&splits);
    return status;
}
