/* Triangulations that follow the values: edges are swapped while planes bend less across them.
 */
#include "base/work.h"
#include "numeric/vector.h"

#include <batten/scattered.h>

#include <float.h>
#include <string.h>

enum { SWAPS_FOR_EDGE = 20 };

typedef struct {
    batten_plane_triangles *triangles;
    const double *values;
    int *queue; /* a ring of sides waiting to be looked at: 3 t + e */
    bool *waiting;
    int *corners, *beside; /* room for the copies */
    int size, first, count;
} swapper;

/* The plane through three vertices: its normal, not of unit length. */
static void normal_of(const swapper *s, const int corners[3], double n[3])
{
    double d[2][3];
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 2; c++)
            d[k][c] = s->triangles->vertices[2 * (size_t)corners[k + 1] + (size_t)c] -
                      s->triangles->vertices[2 * (size_t)corners[0] + (size_t)c];
        d[k][2] = s->values[corners[k + 1]] - s->values[corners[0]];
    }
    bat_cross(d[0], d[1], n);
}

/* Twice the area by the square of the longest side: is the triangle there, and not thin? */
static bool is_stout(const swapper *s, int a, int b, int c)
{
    const double *p = s->triangles->vertices + 2 * (size_t)a;
    const double *q = s->triangles->vertices + 2 * (size_t)b;
    const double *r = s->triangles->vertices + 2 * (size_t)c;
    const double x = q[0] - p[0], y = q[1] - p[1], u = r[0] - p[0], v = r[1] - p[1];
    const double longest =
        bat_max(bat_max(bat_hypot(x, y), bat_hypot(u, v)), bat_hypot(u - x, v - y));
    /* A height of a millionth of the longest side: thinner, gradients lose all digits. */
    return (x * v - y * u) / longest > 1e-6 * longest;
}

/* The two triangles at a side: a and b its ends, c on this side, d on the other. */
typedef struct {
    int t, e, other, f;
    int a, b, c, d;
} triangle_pair;

static bool take_pair(const swapper *s, int side, triangle_pair *p)
{
    const int *corners = s->triangles->corners;
    p->t = side / 3;
    p->e = side % 3;
    p->other = s->triangles->beside[side];
    if (p->other < 0)
        return false;
    p->f = 0;
    while (p->f < 2 && s->triangles->beside[3 * p->other + p->f] != p->t)
        p->f++;
    p->a = corners[3 * p->t + (p->e + 1) % 3];
    p->b = corners[3 * p->t + (p->e + 2) % 3];
    p->c = corners[3 * p->t + p->e];
    p->d = corners[3 * p->other + p->f];
    return true;
}

/* The angle across the side of a triangle between `normal` and its neighbour, 0 on the rim. */
static double angle_across(const swapper *s, int t, int e, const double normal[3])
{
    const int other = s->triangles->beside[3 * t + e];
    double n[3];
    if (other < 0)
        return 0;
    normal_of(s, s->triangles->corners + 3 * other, n);
    return bat_angle(normal, n);
}

/* How much less the planes bend with the other diagonal. */
static double gain_of_swap(const swapper *s, const triangle_pair *p)
{
    const int now[2][3] = {{p->c, p->a, p->b}, {p->d, p->b, p->a}};
    const int then[2][3] = {{p->c, p->a, p->d}, {p->d, p->b, p->c}};
    double n[2][3], m[2][3];
    for (int k = 0; k < 2; k++) {
        normal_of(s, now[k], n[k]);
        normal_of(s, then[k], m[k]);
    }
    /* sides a-c and c-b of t, b-d and d-a of the other */
    const int ca = (p->e + 2) % 3, bc = (p->e + 1) % 3, db = (p->f + 2) % 3,
              ad = (p->f + 1) % 3;
    const double before = bat_angle(n[0], n[1]) + angle_across(s, p->t, ca, n[0]) +
                          angle_across(s, p->t, bc, n[0]) +
                          angle_across(s, p->other, db, n[1]) +
                          angle_across(s, p->other, ad, n[1]);
    const double after = bat_angle(m[0], m[1]) + angle_across(s, p->t, ca, m[0]) +
                         angle_across(s, p->other, ad, m[0]) + angle_across(s, p->t, bc, m[1]) +
                         angle_across(s, p->other, db, m[1]);
    return before - after;
}

static void queue_side(swapper *s, int side)
{
    const int other = s->triangles->beside[side];
    if (other < 0 || s->waiting[side])
        return;
    s->waiting[side] = true;
    s->queue[(s->first + s->count++) % s->size] = side;
}

static void set_beside(swapper *s, int t, int was, int now)
{
    if (t < 0)
        return;
    for (int e = 0; e < 3; e++)
        if (s->triangles->beside[3 * t + e] == was) {
            s->triangles->beside[3 * t + e] = now;
            return;
        }
}

/* t becomes (c, a, d), the other (d, b, c). */
static void swap_edge(swapper *s, const triangle_pair *p)
{
    int *corners = s->triangles->corners, *beside = s->triangles->beside;
    const int across_ca = beside[3 * p->t + (p->e + 2) % 3];
    const int across_bc = beside[3 * p->t + (p->e + 1) % 3];
    const int across_db = beside[3 * p->other + (p->f + 2) % 3];
    const int across_ad = beside[3 * p->other + (p->f + 1) % 3];
    const int one[3] = {p->c, p->a, p->d}, two[3] = {p->d, p->b, p->c};
    const int beside_one[3] = {across_ad, p->other, across_ca};
    const int beside_two[3] = {across_bc, p->t, across_db};
    memcpy(corners + 3 * p->t, one, sizeof one);
    memcpy(corners + 3 * p->other, two, sizeof two);
    memcpy(beside + 3 * p->t, beside_one, sizeof beside_one);
    memcpy(beside + 3 * p->other, beside_two, sizeof beside_two);
    set_beside(s, across_ad, p->other, p->t);
    set_beside(s, across_bc, p->t, p->other);
    const int around[6] = {p->t, p->other, across_ca, across_bc, across_db, across_ad};
    for (int k = 0; k < 18; k++)
        if (around[k / 3] >= 0)
            queue_side(s, 3 * around[k / 3] + k % 3);
}

enum { SIDES_A_STEP = 256 };

static batten_status swap_all(swapper *s, const batten_job *job, int *swaps)
{
    bat_work work = {job, 0};
    batten_status status = BATTEN_OK;
    const long long most = (long long)SWAPS_FOR_EDGE * s->size;
    for (int side = 0; side < s->size; side++)
        if (s->triangles->beside[side] > side / 3)
            queue_side(s, side);
    *swaps = 0;
    for (int looks = 0; s->count; looks = (looks + 1) % SIDES_A_STEP) {
        if (looks == 0)
            status = bat_work_step(&work, SIDES_A_STEP, 1 - (double)s->count / s->size,
                                   "edges are swapped");
        if (status != BATTEN_OK)
            return status;
        triangle_pair p;
        const int side = s->queue[s->first];
        s->first = (s->first + 1) % s->size;
        s->count--;
        s->waiting[side] = false;
        /* A gain in radians; less is the rounding of an angle, and might be swapped back forever. */
        if (!take_pair(s, side, &p) || !is_stout(s, p.c, p.a, p.d) ||
            !is_stout(s, p.d, p.b, p.c) || !(gain_of_swap(s, &p) > 1e-12))
            continue;
        if (++*swaps > most)
            return bat_fail(BATTEN_INCOMPLETE, "%d edges were swapped and more would be",
                            *swaps);
        swap_edge(s, &p);
    }
    return BATTEN_OK;
}

/* Swapped in copies of the corners and neighbours, which are written only when all is done. */
static batten_status swap_copies(swapper *s, const batten_job *job, int *swaps)
{
    const size_t bytes = (size_t)s->size * sizeof(int);
    batten_plane_triangles copy = *s->triangles, *given = s->triangles;
    memset(s->waiting, 0, (size_t)s->size * sizeof *s->waiting);
    memcpy(s->corners, given->corners, bytes);
    memcpy(s->beside, given->beside, bytes);
    copy.corners = s->corners;
    copy.beside = s->beside;
    s->triangles = &copy;
    const batten_status status = swap_all(s, job, swaps);
    if (status == BATTEN_OK) {
        memcpy(given->corners, copy.corners, bytes);
        memcpy(given->beside, copy.beside, bytes);
    }
    return status;
}

batten_status batten_triangles_swap(batten_plane_triangles *triangles, const double *values,
                                    const batten_job *job, int *swaps)
{
    assert(triangles && values);
    const size_t size = 3 * (size_t)triangles->count;
    int done = 0;
    swapper s = {.triangles = triangles, .values = values, .size = 3 * triangles->count};
    s.queue = bat_array(size, sizeof *s.queue);
    s.waiting = bat_array(size, sizeof *s.waiting);
    s.corners = bat_array(size, sizeof *s.corners);
    s.beside = bat_array(size, sizeof *s.beside);
    const batten_status status = s.queue && s.waiting && s.corners && s.beside
                                     ? swap_copies(&s, job, &done)
                                     : BATTEN_OUT_OF_MEMORY;
    bat_release(s.beside);
    bat_release(s.corners);
    bat_release(s.waiting);
    bat_release(s.queue);
    if (status == BATTEN_OK && swaps)
        *swaps = done;
    return status;
}
