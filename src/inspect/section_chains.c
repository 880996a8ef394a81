/* Crossings of a section in chains, and the chains in polylines. */
#include "inspect/section_chains.h"
#include "numeric/vector.h"

#include <batten/nearest.h>
#include <string.h>

/* ---- chains ---- */

/* The crossing after `at` when one came from `from`; -1 at an end. */
static int following(const bat_section_march *m, int at, int from)
{
    const int *link = m->crossings[at].link;
    return link[0] == from ? link[1] : link[0];
}

/* Do two crossings stand at one point, as those do that share a node on the plane? */
static bool is_same(const bat_section_march *m, int a, int b)
{
    const batten_vec3 d = bat_vec3_subtract(m->crossings[a].point, m->crossings[b].point);
    return bat_vec3_norm(d) <= m->roundoff;
}

/* The chain from `first`, without repeated points, into line (NULL counts only). Returns the
 * number of points; `closed` says whether it came back. */
static int walk(const bat_section_march *m, int first, batten_polyline *line, bool *taken,
                bool *closed)
{
    int count = 0, last = -1, from = -1, at = first;
    do {
        const bat_section_crossing *c = &m->crossings[at];
        const int next =
            from < 0 ? (c->link[1] >= 0 ? c->link[1] : c->link[0]) : following(m, at, from);
        taken[at] = line != NULL;
        if (last < 0 || !is_same(m, last, at)) {
            if (line) {
                memcpy(line->points + 3 * count, &c->point, 3 * sizeof(double));
                line->parameters[2 * count] = c->u;
                line->parameters[2 * count + 1] = c->v;
            }
            count++;
            last = at;
        }
        from = at;
        at = next;
    } while (at >= 0 && at != first);
    *closed = at == first && count > 2;
    if (*closed && is_same(m, last, first))
        count--;
    return count;
}

static batten_status take_chain(bat_section_march *m, int first, bool *taken,
                                batten_polylines *out)
{
    bool closed;
    const int count = walk(m, first, NULL, taken, &closed);
    batten_polyline line = {.count = count, .closed = closed};
    line.points = bat_array3((size_t)count + 1, 3, sizeof *line.points);
    line.parameters = bat_array3((size_t)count + 1, 2, sizeof *line.parameters);
    if (!line.points || !line.parameters) {
        bat_release(line.points);
        bat_release(line.parameters);
        return BATTEN_OUT_OF_MEMORY;
    }
    walk(m, first, &line, taken, &closed);
    if (count >= 2) {
        out->lines[out->count++] = line;
    } else { /* the plane touches one point */
        bat_release(line.points);
        bat_release(line.parameters);
    }
    return BATTEN_OK;
}

batten_status bat_section_chains(bat_section_march *m, batten_polylines *out)
{
    bool *taken = bat_array((size_t)m->count, sizeof *taken);
    out->lines = bat_array((size_t)m->count, sizeof *out->lines);
    batten_status status = taken && out->lines ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int loops = 0; loops < 2; loops++)
        for (int k = 0; status == BATTEN_OK && k < m->count; k++)
            if (!taken[k] && m->crossings[k].link[0] >= 0 &&
                (loops || m->crossings[k].link[1] < 0))
                status = take_chain(m, k, taken, out);
    bat_release(taken);
    return status;
}
