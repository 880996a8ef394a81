/* Loops of a face that touch at vertices of their own: such vertices are one of the mesh. */
#include "mesh/faces/meshing.h"

#include <stdlib.h>

/* Where a loop of a face passes a vertex. */
typedef struct {
    double x; /* of the vertex: what they are sorted by */
    double uv[2];
    int vertex;
} passing;

static int compare_passings(const void *left, const void *right)
{
    const passing *a = left, *b = right;
    return a->x != b->x ? (a->x > b->x) - (a->x < b->x) : a->vertex - b->vertex;
}

static const double *place_of(const bat_meshing *m, int vertex)
{
    return &m->parts->vertices[3 * (size_t)vertex];
}

static double apart(const bat_meshing *m, int a, int b)
{
    const double *p = place_of(m, a), *q = place_of(m, b);
    return bat_hypot(bat_hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

/* Vertices at the ends of edges about as short as the tolerance stay what they are: else the
 * edge would have no length. */
static void keep_short(const bat_meshing *m, bool *keep)
{
    for (int i = 0; i < m->parts->edge_count; i++) {
        const int *ends = m->parts->edges[i].vertices;
        if (ends[0] != ends[1] && apart(m, ends[0], ends[1]) <= 8 * m->parts->tolerance)
            keep[ends[0]] = keep[ends[1]] = true;
    }
}

static batten_status list_passings(const bat_meshing *m, int face, passing *list, int *count)
{
    const batten_body_face *f = &m->parts->faces[face];
    batten_status status = BATTEN_OK;
    *count = 0;
    for (int i = f->first; i < f->first + f->count; i++)
        for (int k = 0; status == BATTEN_OK && k < m->parts->loops[i].count; k++) {
            const batten_body_use *use = &m->parts->uses[m->parts->loops[i].first + k];
            const batten_interval domain = batten_curve_domain(use->parameters);
            passing *next = &list[(*count)++];
            next->vertex = m->parts->edges[use->edge].vertices[use->reversed ? 1 : 0];
            next->x = place_of(m, next->vertex)[0];
            status = batten_curve_evaluate(use->parameters, use->reversed ? domain.b : domain.a,
                                           0, next->uv);
        }
    qsort(list, (size_t)*count, sizeof *list, compare_passings);
    return status;
}

static bool touch(const bat_meshing *m, int face, const passing *a, const passing *b)
{
    for (int k = 0; k < 2; k++) {
        /* Parameter curves of files often keep six digits; the distance in space decides. */
        const batten_interval domain = m->sheets[face].domain[k];
        if (!(fabs(a->uv[k] - b->uv[k]) <= 1e-6 * (domain.b - domain.a)))
            return false;
    }
    return apart(m, a->vertex, b->vertex) <= 2 * m->parts->tolerance;
}

/* Each is compared with a few after it: what has many at one place is no touch. */
static batten_status join_in_face(bat_meshing *m, int face, const bool *keep, passing *list)
{
    enum { MOST_BESIDE = 8 };
    int count = 0;
    const batten_status status = list_passings(m, face, list, &count);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        for (int k = i + 1; k < count && k <= i + MOST_BESIDE; k++) {
            const int a = list[i].vertex, b = list[k].vertex;
            if (list[k].x - list[i].x > 2 * m->parts->tolerance)
                break;
            if (a == b || keep[a] || keep[b] || m->same[a] != a || m->same[b] != b ||
                !touch(m, face, &list[i], &list[k]))
                continue;
            m->same[bat_max_int(a, b)] = bat_min_int(a, b);
            m->touched[bat_min_int(a, b)] = true;
        }
    return status;
}

batten_status bat_meshing_join(bat_meshing *m)
{
    const size_t vertices = (size_t)m->parts->vertex_count;
    bool *keep = bat_array(vertices, sizeof *keep);
    passing *list = bat_array((size_t)m->parts->use_count, sizeof *list);
    batten_status status = keep && list ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        keep_short(m, keep);
    for (int i = 0; status == BATTEN_OK && i < m->parts->face_count; i++)
        if (m->parts->faces[i].count > 1)
            status = join_in_face(m, i, keep, list);
    bat_release(list);
    bat_release(keep);
    return status;
}
