/* Points put into triangles whose sides are kept. */
#include "mesh/faces/sides_triangles.h"

static bool holds(const bat_sides *s, int t, const double *p)
{
    const int *c = s->triangles[t].corner;
    return bat_orientation(at(s, c[0]), at(s, c[1]), p) >= 0 &&
           bat_orientation(at(s, c[1]), at(s, c[2]), p) >= 0 &&
           bat_orientation(at(s, c[2]), at(s, c[0]), p) >= 0;
}

/* The edge beyond which the point is, or -1; not that to where the walk comes from. A side only
 * when it must be: behind those of a border that is nearly straight lie triangles as long as
 * the border, one behind the other. */
static int way_out(const bat_sides *s, const bat_side_triangle *here, int from, int first,
                   const double *p)
{
    int out = -1;
    for (int i = 0; i < 3; i++) {
        const int k = (first + i) % 3;
        if ((from >= 0 && here->beside[k] == from) || (out >= 0 && bit(here->fixed, k)) ||
            bat_orientation(at(s, here->corner[after(k)]), at(s, here->corner[before(k)]), p) >=
                0)
            continue;
        out = k;
        if (!bit(here->fixed, k))
            break;
    }
    return out;
}

/* The triangle that holds the point, or -1; the walk ends at `last`. Sides can lead a walk
 * round in circles, then all are asked. */
static int locate(bat_sides *s, const double *p)
{
    int t = s->last, from = -1;
    for (int steps = 0; steps < s->count; steps++) {
        const bat_side_triangle *here = &s->triangles[t];
        const int k = way_out(s, here, from, steps % 3, p);
        s->last = t;
        s->steps++;
        if (k < 0)
            return t;
        if (here->beside[k] < 0)
            return -1;
        from = t;
        t = here->beside[k];
    }
    s->steps += (uint64_t)s->count;
    for (t = 0; t < s->count; t++)
        if (holds(s, t, p))
            return s->last = t;
    return -1;
}

/* Is the point a corner, or on a side, of the triangle that holds it? */
static bool is_taken(const bat_sides *s, int t, const double *p)
{
    const bat_side_triangle *here = &s->triangles[t];
    for (int k = 0; k < 3; k++) {
        const double *c = at(s, here->corner[k]);
        if ((c[0] == p[0] && c[1] == p[1]) ||
            (bit(here->fixed, k) && bat_orientation(at(s, here->corner[after(k)]),
                                                    at(s, here->corner[before(k)]), p) == 0))
            return true;
    }
    return false;
}

/* The triangles with p in their circle, connected without crossing sides: first in the list.
 * Source: [Bowyer81]. */
static batten_status find_cavity(bat_sides *s, int t, const double *p, int *count)
{
    s->stamp++;
    s->triangles[t].stamp = s->stamp;
    s->list[0] = t;
    *count = 1;
    for (int i = 0; i < *count; i++) {
        const bat_side_triangle *here = &s->triangles[s->list[i]];
        for (int k = 0; k < 3; k++) {
            bat_side_triangle *n = here->beside[k] < 0 ? NULL : &s->triangles[here->beside[k]];
            if (!n || bit(here->fixed, k) || n->stamp == s->stamp ||
                bat_in_circle(at(s, n->corner[0]), at(s, n->corner[1]), at(s, n->corner[2]),
                              p) <= 0)
                continue;
            n->stamp = s->stamp;
            s->list[(*count)++] = here->beside[k];
            const batten_status status = bat_sides_grow_list(s, 4 * *count + 8);
            if (status != BATTEN_OK)
                return status;
        }
    }
    return BATTEN_OK;
}

static bool is_near(const double *p, const double *a, const double *b, double widest,
                    double nearest)
{
    const double ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by;
    const double x = b[0] - a[0], y = b[1] - a[1], least = nearest * nearest * (x * x + y * y);
    return aa < least || bb < least || ax * bx + ay * by < widest * sqrt(aa * bb);
}

/* The edges around the cavity, 3 t + k, behind it in the list. False when the point is too near
 * to one of them. */
static bool find_rim(bat_sides *s, const double *p, int cavity, double widest, double nearest,
                     int *count)
{
    *count = 0;
    for (int i = 0; i < cavity; i++) {
        const bat_side_triangle *here = &s->triangles[s->list[i]];
        for (int k = 0; k < 3; k++) {
            const bool fixed = bit(here->fixed, k);
            if (!fixed && here->beside[k] >= 0 &&
                s->triangles[here->beside[k]].stamp == s->stamp)
                continue;
            const double *a = at(s, here->corner[after(k)]),
                         *b = at(s, here->corner[before(k)]);
            const bool too_near = fixed && is_near(p, a, b, widest, nearest);
            if (bat_orientation(p, a, b) <= 0 || too_near) {
                s->near[0] = too_near ? here->corner[after(k)] : -1;
                s->near[1] = too_near ? here->corner[before(k)] : -1;
                return false;
            }
            s->list[cavity + (*count)++] = 3 * s->list[i] + k;
        }
    }
    return *count == cavity + 2;
}

/* A triangle from the point to each edge of the rim, in the places of the cavity and behind. */
static void fill_cavity(bat_sides *s, int vertex, int cavity, int rim, bat_side_triangle *made)
{
    int *places = s->list, *edges = s->list + cavity;
    for (int i = 0; i < rim; i++) {
        const bat_side_triangle *old = &s->triangles[edges[i] / 3];
        const int k = edges[i] % 3;
        made[i] = (bat_side_triangle){
            .corner = {vertex, old->corner[after(k)], old->corner[before(k)]},
            .beside = {old->beside[k], -1, -1},
            .fixed = bit(old->fixed, k),
            .odd = bit(old->odd, k),
            .inside = true,
            .born = old->born + 1};
    }
    for (int i = 0; i < rim; i++) {
        const int place = i < cavity ? places[i] : s->count++, *c = made[i].corner;
        made[i].stamp = s->stamp;
        made[i].born = bat_max_int(made[i].born, i < cavity ? s->triangles[place].born + 1 : 0);
        edges[i] = place; /* its edge is taken over above */
        s->start[c[1]] = i;
        s->of[c[0]] = s->of[c[1]] = s->of[c[2]] = place;
    }
    for (int i = 0; i < rim; i++) {
        const int next = s->start[made[i].corner[2]];
        made[i].beside[1] = edges[next];
        made[next].beside[2] = edges[i];
    }
    for (int i = 0; i < rim; i++) {
        s->triangles[edges[i]] = made[i];
        bat_side_triangle *n = made[i].beside[0] < 0 ? NULL : &s->triangles[made[i].beside[0]];
        for (int k = 0; n && k < 3; k++)
            if (n->corner[after(k)] == made[i].corner[2] &&
                n->corner[before(k)] == made[i].corner[1])
                n->beside[k] = edges[i];
    }
    s->last = edges[0];
}

batten_status bat_sides_insert(bat_sides *s, const double point[2], double widest,
                               double nearest, int *vertex)
{
    int cavity = 0, rim = 0;
    *vertex = s->near[0] = s->near[1] = -1;
    const int t = locate(s, point);
    if (t < 0 || !s->triangles[t].inside || is_taken(s, t, point))
        return BATTEN_OK;
    batten_status status = find_cavity(s, t, point, &cavity);
    s->steps += (uint64_t)cavity;
    if (status != BATTEN_OK || !find_rim(s, point, cavity, widest, nearest, &rim))
        return status;
    if (s->vertex_count == s->vertex_room) {
        status = s->vertex_count < INT_MAX / 8 ? bat_sides_grow_vertices(s, 2 * s->vertex_room)
                                               : BATTEN_TOO_LARGE;
        if (status != BATTEN_OK)
            return status;
    }
    if (s->count + 2 > s->room) {
        status = bat_sides_grow_triangles(s, 2 * s->room);
        if (status != BATTEN_OK)
            return status;
    }
    bat_side_triangle few[32], *made = few;
    if (rim > 32) {
        made = bat_array((size_t)rim, sizeof *made);
        if (!made)
            return BATTEN_OUT_OF_MEMORY;
    }
    s->at[s->vertex_count][0] = point[0];
    s->at[s->vertex_count][1] = point[1];
    fill_cavity(s, s->vertex_count, cavity, rim, made);
    if (made != few)
        bat_release(made);
    *vertex = s->vertex_count++;
    return BATTEN_OK;
}
