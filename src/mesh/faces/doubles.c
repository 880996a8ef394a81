/* Edges across a face that other triangles have already. */
#include "base/list.h"
#include "mesh/faces/face.h"

#include <limits.h>

/* The middle of an edge, and a triangle with it. */
typedef struct {
    double at[2];
    int triangle;
} middle;

typedef struct {
    int count, room;
    middle *list;
} middles;

static batten_status add_middle(middles *m, int triangle, const double *a, const double *b)
{
    if (BAT_LIST_GROW(m->list, m->count, m->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    m->list[m->count++] =
        (middle){.at = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}, .triangle = triangle};
    return BATTEN_OK;
}

/* Of an edge across the face from border to border: is it, with its direction, an edge of
 * another face or of this one, or the same vertex twice? Then it must be divided. */
static batten_status is_double(const bat_face_mesh *f, bat_pairs *own,
                               const bat_side_triangle *t, int k, bool *found)
{
    const int a = f->vertices[t->corner[(k + 1) % 3]].vertex;
    const int b = f->vertices[t->corner[(k + 2) % 3]].vertex;
    *found = false;
    if ((t->fixed >> k & 1) || a < 0 || b < 0)
        return BATTEN_OK;
    const int known = own->count;
    int index = -1;
    batten_status status = BATTEN_OK;
    if (a != b && bat_pairs_find(&f->m->taken, a, b) < 0)
        status = bat_pairs_add(own, a, b, &index);
    *found = index != known;
    return status;
}

/* The middles of such edges; `own` gets the edges that are none. */
static batten_status find_doubles(const bat_face_mesh *f, bat_pairs *own, middles *m)
{
    batten_status status = BATTEN_OK;
    m->count = 0;
    bat_pairs_clear(own);
    for (int i = 0; status == BATTEN_OK && i < f->sides.count; i++) {
        const bat_side_triangle *t = &f->sides.triangles[i];
        if (!t->inside || bat_face_vanishes(f, t))
            continue;
        for (int k = 0; status == BATTEN_OK && k < 3; k++) {
            bool found = false;
            status = is_double(f, own, t, k, &found);
            if (status == BATTEN_OK && found)
                status = add_middle(m, i, f->sides.at[t->corner[(k + 1) % 3]],
                                    f->sides.at[t->corner[(k + 2) % 3]]);
        }
    }
    return status;
}

/* All of them in each round: those that are left are new ones, and soon there are none. */
batten_status bat_face_divide_doubles(bat_face_mesh *f, bat_pairs *own)
{
    middles m = {0};
    batten_status status = BATTEN_OK;
    bool going_on = true;
    while (status == BATTEN_OK && going_on) {
        const int first = f->count;
        going_on = false;
        status = find_doubles(f, own, &m);
        for (int i = 0; status == BATTEN_OK && i < m.count; i++) {
            bool added = false;
            f->sides.last = m.list[i].triangle; /* the walk begins near to it */
            status = bat_face_insert(f, m.list[i].at, -1, 0, &added);
            going_on = going_on || added;
        }
        if (status == BATTEN_OK)
            status = bat_face_evaluate(f, first);
    }
    bat_release(m.list);
    return status;
}
