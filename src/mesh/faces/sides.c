/* Triangles between sides: the triangulation of a border in the plane. */
#include "mesh/faces/sides.h"
#include "mesh/faces/sides_triangles.h"

static int corner_index(const bat_side_triangle *t, int vertex)
{
    return t->corner[0] == vertex ? 0 : t->corner[1] == vertex ? 1 : 2;
}

/* ---- flips ---- */

/* Edge `k` of `to` becomes what edge `j` of `from` was. */
static void hand_over_side(bat_sides *s, const bat_side_triangle *from, int from_index, int j,
                           int to, int k)
{
    bat_side_triangle *t = &s->triangles[to];
    t->beside[k] = from->beside[j];
    set_bit(&t->fixed, k, bit(from->fixed, j));
    set_bit(&t->odd, k, bit(from->odd, j));
    if (from->beside[j] < 0)
        return;
    bat_side_triangle *n = &s->triangles[from->beside[j]];
    const int end = t->corner[before(k)];
    for (int i = 0; i < 3; i++)
        if (n->beside[i] == from_index && n->corner[after(i)] == end)
            n->beside[i] = to;
}

/* The edge opposite corner k of t = (p, a, b), n = (q, b, a) beyond it: (p, a, q), (q, b, p).
 */
static void flip(bat_sides *s, int t, int k)
{
    const bat_side_triangle one = s->triangles[t];
    const int n = one.beside[k];
    const bat_side_triangle two = s->triangles[n];
    const int p = one.corner[k], a = one.corner[after(k)], b = one.corner[before(k)];
    const int j = after(corner_index(&two, a)), q = two.corner[j];
    bat_side_triangle first = {.corner = {p, a, q}, .beside = {-1, n, -1}};
    bat_side_triangle second = {.corner = {q, b, p}, .beside = {-1, t, -1}};
    first.inside = one.inside;
    second.inside = two.inside;
    first.stamp = one.stamp;
    second.stamp = two.stamp;
    s->triangles[t] = first;
    s->triangles[n] = second;
    hand_over_side(s, &two, n, after(j), t, 0);  /* a - q: opposite b in n */
    hand_over_side(s, &one, t, before(k), t, 2); /* p - a: opposite b in t */
    hand_over_side(s, &one, t, after(k), n, 0);  /* b - p: opposite a in t */
    hand_over_side(s, &two, n, before(j), n, 2); /* q - b: opposite a in n */
    s->of[p] = s->of[a] = t;
    s->of[q] = s->of[b] = n;
}

static int apex_beyond(const bat_sides *s, int t, int k)
{
    const bat_side_triangle *one = &s->triangles[t], *two = &s->triangles[one->beside[k]];
    return two->corner[after(corner_index(two, one->corner[after(k)]))];
}

/* ---- keeping sides ---- */

/* Triangles around a vertex: counter-clockwise until the rim, then from the first clockwise.
 * *turn is 1 while counter-clockwise. -1: no more. */
static int next_around(const bat_sides *s, int vertex, int t, int *turn)
{
    const int first = s->of[vertex];
    const bat_side_triangle *here = &s->triangles[t];
    const int i = corner_index(here, vertex);
    int next = here->beside[*turn > 0 ? after(i) : before(i)];
    if (*turn > 0 && next < 0) {
        *turn = -1;
        here = &s->triangles[first];
        next = here->beside[before(corner_index(here, vertex))];
    }
    return next == first ? -1 : next;
}

static bool find_edge(bat_sides *s, int a, int b, int *triangle, int *k)
{
    int turn = 1;
    for (int t = s->of[a]; t >= 0; t = next_around(s, a, t, &turn)) {
        s->steps_of_sides++;
        const bat_side_triangle *here = &s->triangles[t];
        const int i = corner_index(here, a);
        if (here->corner[after(i)] != b && here->corner[before(i)] != b)
            continue;
        *triangle = t;
        *k = here->corner[after(i)] == b ? before(i) : after(i);
        return true;
    }
    return false;
}

static void mark_side(bat_sides *s, int t, int k)
{
    bat_side_triangle *here = &s->triangles[t];
    set_bit(&here->fixed, k, true);
    here->odd ^= (unsigned char)(1u << k);
    if (here->beside[k] < 0)
        return;
    bat_side_triangle *n = &s->triangles[here->beside[k]];
    const int j = after(corner_index(n, here->corner[after(k)]));
    set_bit(&n->fixed, j, true);
    n->odd ^= (unsigned char)(1u << j);
}

/* Where the way from a to b leaves the triangles around a. Returns the triangle, whose edge
 * opposite a it crosses; or -1 and the vertex that it runs through. */
static int leave(const bat_sides *s, int a, int b, int *through)
{
    int turn = 1;
    const double *p = at(s, a), *q = at(s, b);
    for (int t = s->of[a]; t >= 0; t = next_around(s, a, t, &turn)) {
        const bat_side_triangle *here = &s->triangles[t];
        const int i = corner_index(here, a);
        const double *c = at(s, here->corner[after(i)]), *d = at(s, here->corner[before(i)]);
        const int right = bat_orientation(p, c, q), left = bat_orientation(p, q, d);
        if (right > 0 && left > 0)
            return t;
        const bool past_c = right == 0 && (c[0] - p[0]) * (q[0] - p[0]) >= 0 &&
                            (c[1] - p[1]) * (q[1] - p[1]) >= 0;
        const bool past_d = left == 0 && (d[0] - p[0]) * (q[0] - p[0]) >= 0 &&
                            (d[1] - p[1]) * (q[1] - p[1]) >= 0;
        if (past_c || past_d) {
            *through = here->corner[past_c ? after(i) : before(i)];
            return -1;
        }
    }
    *through = a;
    return -1;
}

/* The edges between a and b as pairs in the list. */
static batten_status collect(bat_sides *s, int a, int b, int *count, bat_side_result *result,
                             int other[2])
{
    *count = 0;
    *result = BAT_SIDE_TOUCHES;
    int t = leave(s, a, b, &other[0]);
    if (t < 0)
        return BATTEN_OK;
    int k = corner_index(&s->triangles[t], a);
    for (;;) {
        const bat_side_triangle *here = &s->triangles[t];
        const int right = here->corner[after(k)], left = here->corner[before(k)];
        if (bit(here->fixed, k)) {
            *result = BAT_SIDE_CROSSES;
            other[0] = right;
            other[1] = left;
            return BATTEN_OK;
        }
        const batten_status status = bat_sides_grow_list(s, 2 * *count + 2);
        if (status != BATTEN_OK)
            return status;
        s->list[2 * *count] = right;
        s->list[2 * (*count)++ + 1] = left;
        const int apex = apex_beyond(s, t, k);
        if (apex == b)
            break;
        const int side = bat_orientation(at(s, a), at(s, b), at(s, apex));
        if (side == 0) {
            other[0] = apex;
            return BATTEN_OK;
        }
        t = here->beside[k];
        k = corner_index(&s->triangles[t], side > 0 ? left : right);
    }
    *result = BAT_SIDE_KEPT;
    return BATTEN_OK;
}

/* Does the edge p - q still lie across a - b? */
static bool is_across(const bat_sides *s, int p, int q, int a, int b)
{
    if (p == a || p == b || q == a || q == b)
        return false;
    return bat_orientation(at(s, a), at(s, b), at(s, p)) !=
           bat_orientation(at(s, a), at(s, b), at(s, q));
}

/* Sides of borders cross few edges of Delaunay triangles: in all steps a dozen for each vertex. Where they take
 * thousands, the border is not one that parts in and out, and flipping could go on for hours. */
static uint64_t most_steps(const bat_sides *s)
{
    return 1000000 + 1000 * (uint64_t)s->vertex_count;
}

/* Flip the edges of the list until none lies across a - b. Source: [Sloan93]. */
static bool clear_way(bat_sides *s, int a, int b, int count)
{
    const int most = 16 + 4 * count;
    int first = 0, left = count;
    for (int rounds = 0; left > 0 && rounds < most; rounds++)
        for (int n = left; n > 0 && s->steps_of_sides <= most_steps(s); n--) {
            int *edge = &s->list[2 * first], t, k;
            const int p = edge[0], q = edge[1];
            first = (first + 1) % count;
            left--;
            if (!find_edge(s, p, q, &t, &k))
                return false;
            const int c = s->triangles[t].corner[k], d = apex_beyond(s, t, k);
            const int from = s->triangles[t].corner[after(k)];
            const int to = s->triangles[t].corner[before(k)];
            const bool convex = bat_orientation(at(s, c), at(s, from), at(s, d)) > 0 &&
                                bat_orientation(at(s, d), at(s, to), at(s, c)) > 0;
            if (convex)
                flip(s, t, k);
            if (convex && !is_across(s, c, d, a, b))
                continue;
            int *back = &s->list[2 * ((first + left) % count)];
            back[0] = convex ? c : p;
            back[1] = convex ? d : q;
            left++;
        }
    return left == 0;
}

batten_status bat_sides_keep(bat_sides *s, int a, int b, bat_side_result *result, int other[2])
{
    int t, k, count = 0;
    *result = BAT_SIDE_KEPT;
    if (!find_edge(s, a, b, &t, &k)) {
        const batten_status status = collect(s, a, b, &count, result, other);
        if (status != BATTEN_OK || *result != BAT_SIDE_KEPT)
            return status;
        if (!clear_way(s, a, b, count) || !find_edge(s, a, b, &t, &k))
            return bat_fail(
                BATTEN_NOT_COMPATIBLE,
                "a side of its border crosses %d edges between other points of it, and cannot be made "
                "one of triangles: these points are too close together for its length in (u, v)",
                count);
    }
    mark_side(s, t, k);
    return BATTEN_OK;
}

/* ---- settling ---- */

static bool is_wrong(const bat_sides *s, int t, int k)
{
    const bat_side_triangle *here = &s->triangles[t];
    return !bit(here->fixed, k) && here->beside[k] >= 0 &&
           bat_in_circle(at(s, here->corner[0]), at(s, here->corner[1]), at(s, here->corner[2]),
                         at(s, apex_beyond(s, t, k))) > 0;
}

/* Flips until each edge that is no side is one of Delaunay. Each flip brings the
 * edges nearer to those of Delaunay, so it ends. */
static void legalise(bat_sides *s)
{
    int count = 0;
    for (int t = s->count - 1; t >= 0; t--) {
        s->list[count++] = t;
        s->waiting[t] = true;
    }
    while (count) {
        const int t = s->list[--count];
        s->waiting[t] = false;
        for (int k = 0; k < 3; k++) {
            if (!is_wrong(s, t, k))
                continue;
            const int both[2] = {s->triangles[t].beside[k], t};
            flip(s, t, k);
            for (int i = 0; i < 2; i++)
                if (!s->waiting[both[i]]) {
                    s->list[count++] = both[i];
                    s->waiting[both[i]] = true;
                }
            break;
        }
    }
}

/* From the rim inwards; every side of an odd number parts in and out. */
static void find_inside(bat_sides *s)
{
    int count = 0;
    s->stamp++;
    for (int seed = 0; seed < s->count; seed++) {
        bat_side_triangle *rim = &s->triangles[seed];
        for (int k = 0; k < 3 && rim->stamp != s->stamp; k++)
            if (rim->beside[k] < 0) {
                rim->inside = bit(rim->odd, k);
                rim->stamp = s->stamp;
                s->list[count++] = seed;
            }
        while (count) {
            const bat_side_triangle *t = &s->triangles[s->list[--count]];
            for (int k = 0; k < 3; k++) {
                bat_side_triangle *n = t->beside[k] < 0 ? NULL : &s->triangles[t->beside[k]];
                if (!n || n->stamp == s->stamp)
                    continue;
                n->inside = t->inside != bit(t->odd, k);
                n->stamp = s->stamp;
                s->list[count++] = t->beside[k];
            }
        }
    }
}

batten_status bat_sides_settle(bat_sides *s)
{
    batten_status status = bat_sides_grow_list(s, s->count);
    if (status != BATTEN_OK)
        return status;
    s->waiting = bat_array((size_t)s->count, sizeof *s->waiting);
    if (!s->waiting)
        return BATTEN_OUT_OF_MEMORY;
    legalise(s);
    find_inside(s);
    bat_release(s->waiting);
    s->waiting = NULL;
    for (int t = 0; t < s->count; t++)
        if (s->triangles[t].inside)
            s->last = t;
    return BATTEN_OK;
}
