/* Points of the plane as vertices, and the triangles between them. */
#include "spline/triangles/triangulate.h"
#include "base/plural.h"
#include "numeric/plane_signs.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"
#include "spline/triangles/delaunay.h"

#include <stdint.h>
#include <string.h>

batten_triangulate_options batten_triangulate_defaults(void)
{
    return (batten_triangulate_options){.size = sizeof(batten_triangulate_options),
                                        .sliver = 1e-9};
}

void batten_plane_triangles_release(batten_plane_triangles *triangles)
{
    bat_release(triangles->vertices);
    bat_release(triangles->first);
    bat_release(triangles->vertex_of);
    bat_release(triangles->corners);
    bat_release(triangles->beside);
    *triangles = (batten_plane_triangles){0};
}

/* ---- points into [-2, 2] ---- */

static batten_status check_points(int count, const double *points,
                                  const batten_triangulate_options *options)
{
    if (count < 3)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there %s %d point%s; triangles need 3",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    if (count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there are %d points; the limit is %d", count,
                        (int)BAT_MAX_POINTS);
    const size_t at = bat_first_not_finite(points, 2 * (size_t)count);
    if (at < 2 * (size_t)count)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of point %zu is %g", at % 2 + 1,
                        at / 2 + 1, points[at]);
    if (!(options->tolerance >= 0) || !isfinite(options->tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must not be below 0",
                        options->tolerance);
    if (!(options->sliver >= 0) || !(options->sliver < 0.5))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the part for slivers is %g; it must be in [0, 0.5)", options->sliver);
    return BATTEN_OK;
}

/* Multiples of 2^-200 below 2, for which all signs are exact. Returns the scale, a power of two
 * as its exponent. */
static int scale_points(int count, const double *points, double *scaled)
{
    double largest = 0;
    for (size_t i = 0; i < 2 * (size_t)count; i++)
        largest = bat_max(largest, fabs(points[i]));
    const int exponent = largest > 0 ? -ilogb(largest) : 0;
    for (size_t i = 0; i < 2 * (size_t)count; i++)
        scaled[i] = rint(ldexp(points[i], exponent) * 0x1p200) * 0x1p-200 + 0.0;
    return exponent;
}

/* ---- points that are one vertex ---- */

typedef struct {
    double tolerance;
    const double *scaled; /* [count][2] */
    double *vertices;     /* scaled, [vertex_count][2] */
    int *first;           /* [vertex_count] */
    int vertex_count;
    size_t mask;
    int *table; /* vertices + 1 by their cells, open addresses; 0: empty */
} merging;

static double cell_of(const merging *m, double x)
{
    return m->tolerance > 0 ? floor(x / m->tolerance) : x;
}

static size_t place_of(const merging *m, double x, double y)
{
    const double cell[2] = {x + 0.0, y + 0.0};
    uint64_t bits[2];
    memcpy(bits, cell, sizeof bits);
    uint64_t mixed = bits[0] * 0x9e3779b97f4a7c15u ^ (bits[1] + 0x632be59bd9b4e019u);
    mixed = (mixed ^ mixed >> 32) * 0xd6e8feb86659fd93u;
    mixed = (mixed ^ mixed >> 29) * 0xd6e8feb86659fd93u;
    return (size_t)(mixed ^ mixed >> 32) & m->mask;
}

/* The earliest vertex within the tolerance of p among those of one cell, or `best`. */
static int look_up(const merging *m, const double *p, double x, double y, int best)
{
    for (size_t at = place_of(m, x, y); m->table[at]; at = (at + 1) & m->mask) {
        const int v = m->table[at] - 1;
        const double *q = m->vertices + 2 * (size_t)v;
        const double dx = p[0] - q[0], dy = p[1] - q[1];
        if ((best < 0 || v < best) && bat_hypot(dx, dy) <= m->tolerance)
            best = v;
    }
    return best;
}

static int same_vertex(const merging *m, const double *p)
{
    const double x = cell_of(m, p[0]), y = cell_of(m, p[1]);
    if (!(m->tolerance > 0))
        return look_up(m, p, x, y, -1);
    int best = -1;
    for (int k = 0; k < 9; k++)
        best = look_up(m, p, x + k % 3 - 1, y + k / 3 - 1, best);
    return best;
}

static void add_vertex(merging *m, int point)
{
    const double *p = m->scaled + 2 * (size_t)point;
    size_t at = place_of(m, cell_of(m, p[0]), cell_of(m, p[1]));
    while (m->table[at])
        at = (at + 1) & m->mask;
    memcpy(m->vertices + 2 * (size_t)m->vertex_count, p, 2 * sizeof *p);
    m->first[m->vertex_count++] = point;
    m->table[at] = m->vertex_count;
}

/* `scaled` becomes the vertices. */
static batten_status merge_points(int count, double tolerance, double *scaled,
                                  batten_plane_triangles *out)
{
    size_t size = 4;
    while (size < 2 * (size_t)count)
        size *= 2;
    merging m = {tolerance, scaled, scaled, out->first, 0, size - 1, NULL};
    m.table = bat_array(size, sizeof *m.table);
    if (!m.table)
        return BATTEN_OUT_OF_MEMORY;
    memset(m.table, 0, size * sizeof *m.table);
    for (int i = 0; i < count; i++) {
        const int v = same_vertex(&m, scaled + 2 * (size_t)i);
        out->vertex_of[i] = v < 0 ? m.vertex_count : v;
        if (v < 0)
            add_vertex(&m, i); /* never behind point i: the arrays may be one */
        else
            out->merged++;
    }
    bat_release(m.table);
    out->vertex_count = m.vertex_count;
    return m.vertex_count >= 3
               ? BATTEN_OK
               : bat_fail(BATTEN_COINCIDENT,
                          "only %d of %d points differ; triangles need 3 different ones",
                          m.vertex_count, count);
}

/* ---- triangles from edges ---- */

static bool is_face(const bat_delaunay *edges, int a, int b, int c)
{
    if (edges->origin[a] < 0 || bat_delaunay_left(edges, c) != a || a > b || a > c)
        return false;
    const double *p = edges->points;
    return bat_orientation(p + 2 * (size_t)edges->origin[a], p + 2 * (size_t)edges->origin[b],
                           p + 2 * (size_t)edges->origin[c]) > 0;
}

/* The face on the left of each half edge, -1 outside; returns the number of faces. */
static int number_faces(const bat_delaunay *edges, int *face)
{
    int count = 0;
    for (int e = 0; e < edges->used; e++)
        face[e] = -1;
    for (int a = 0; a < edges->used; a++) {
        if (edges->origin[a] < 0)
            continue;
        const int b = bat_delaunay_left(edges, a), c = bat_delaunay_left(edges, b);
        if (is_face(edges, a, b, c))
            face[a] = face[b] = face[c] = count++;
    }
    return count;
}

static batten_status take_faces(const bat_delaunay *edges, const int *face, int count,
                                batten_plane_triangles *out)
{
    out->corners = bat_array3((size_t)count, 3, sizeof *out->corners);
    out->beside = bat_array3((size_t)count, 3, sizeof *out->beside);
    if (!out->corners || !out->beside)
        return BATTEN_OUT_OF_MEMORY;
    for (int a = 0; a < edges->used; a++) {
        if (face[a] < 0 || (out->count > face[a]))
            continue;
        int e = a;
        for (int k = 0; k < 3; k++) {
            out->corners[3 * face[a] + k] = edges->origin[e];
            e = bat_delaunay_left(edges, e);
            out->beside[3 * face[a] + k] = face[e ^ 1]; /* from corner k + 1 to k + 2 */
        }
        out->count++;
    }
    return BATTEN_OK;
}

static batten_status no_area(int vertex_count, const int *first)
{
    return bat_fail(BATTEN_COINCIDENT,
                    "all %d points lie on one line, with points %d and %d: there are no "
                    "triangles between them",
                    vertex_count, first[0] + 1, first[1] + 1);
}

static batten_status find_triangles(const double *scaled, const batten_job *job,
                                    batten_plane_triangles *out)
{
    bat_delaunay edges = {.points = NULL};
    batten_status status = bat_delaunay_make(out->vertex_count, scaled, job, &edges);
    if (status != BATTEN_OK)
        return status;
    int *face = bat_array((size_t)edges.used, sizeof *face);
    if (face) {
        const int count = number_faces(&edges, face);
        status = count ? take_faces(&edges, face, count, out)
                       : no_area(out->vertex_count, out->first);
    } else {
        status = BATTEN_OUT_OF_MEMORY;
    }
    bat_release(face);
    bat_delaunay_free(&edges);
    return status;
}

/* ---- slivers ---- */

static int rim_side(const int *beside)
{
    int rim = -1, count = 0;
    for (int e = 0; e < 3; e++)
        if (beside[e] < 0) {
            rim = e;
            count++;
        }
    return count == 1 ? rim : -1;
}

/* The height of a triangle over a side, by the length of that. */
static double relative_height(const double *vertices, const int *corners, int side)
{
    const double *a = vertices + 2 * (size_t)corners[side];
    const double *b = vertices + 2 * (size_t)corners[(side + 1) % 3];
    const double *c = vertices + 2 * (size_t)corners[(side + 2) % 3];
    const double x = c[0] - b[0], y = c[1] - b[1];
    return (x * (a[1] - b[1]) - y * (a[0] - b[0])) / (x * x + y * y);
}

static void open_to(int *beside, int gone)
{
    for (int e = 0; e < 3; e++)
        if (beside[e] == gone)
            beside[e] = -1;
}

static void drop(batten_plane_triangles *out, int t, int *waiting, int *waiting_count)
{
    for (int e = 0; e < 3; e++) {
        const int other = out->beside[3 * t + e];
        if (other < 0)
            continue;
        open_to(out->beside + 3 * other, t);
        waiting[(*waiting_count)++] = other;
    }
    out->corners[3 * t] = -1;
    out->slivers++;
}

/* Close the gaps that left out triangles have left. */
static void close_up(batten_plane_triangles *out, int *number)
{
    int count = 0;
    for (int t = 0; t < out->count; t++)
        number[t] = out->corners[3 * t] < 0 ? -1 : count++;
    for (int t = 0; t < out->count; t++)
        for (int k = 0; number[t] >= 0 && k < 3; k++) {
            const int other = out->beside[3 * t + k];
            out->corners[3 * number[t] + k] = out->corners[3 * t + k];
            out->beside[3 * number[t] + k] = other < 0 ? -1 : number[other];
        }
    out->count = count;
}

static batten_status drop_slivers(const double *vertices, double most,
                                  batten_plane_triangles *out)
{
    const size_t n = (size_t)out->count;
    int *waiting = bat_array3(n, 3, sizeof *waiting); /* each triangle, and two for each gone */
    bool *on_rim = bat_array((size_t)out->vertex_count, sizeof *on_rim);
    if (!waiting || !on_rim) {
        bat_release(waiting);
        bat_release(on_rim);
        return BATTEN_OUT_OF_MEMORY;
    }
    memset(on_rim, 0, (size_t)out->vertex_count * sizeof *on_rim);
    int count = 0;
    for (int t = out->count - 1; t >= 0; t--)
        for (int e = 0, listed = 0; e < 3; e++)
            if (out->beside[3 * t + e] < 0) {
                on_rim[out->corners[3 * t + (e + 1) % 3]] = true;
                on_rim[out->corners[3 * t + (e + 2) % 3]] = true;
                if (!listed++)
                    waiting[count++] = t;
            }
    while (count) {
        const int t = waiting[--count], *corners = out->corners + 3 * t;
        const int side = corners[0] < 0 ? -1 : rim_side(out->beside + 3 * t);
        if (side < 0 || on_rim[corners[side]] ||
            !(relative_height(vertices, corners, side) < most))
            continue;
        on_rim[corners[side]] = true;
        drop(out, t, waiting, &count);
    }
    if (out->slivers)
        close_up(out, waiting);
    bat_release(waiting);
    bat_release(on_rim);
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status take_vertices(const double *points, batten_plane_triangles *out)
{
    out->vertices = bat_array((size_t)out->vertex_count, 2 * sizeof *out->vertices);
    if (!out->vertices)
        return BATTEN_OUT_OF_MEMORY;
    for (int v = 0; v < out->vertex_count; v++)
        memcpy(out->vertices + 2 * (size_t)v, points + 2 * (size_t)out->first[v],
               2 * sizeof *points);
    return BATTEN_OK;
}

batten_status batten_triangulate(batten_points points,
                                 const batten_triangulate_options *options,
                                 batten_plane_triangles *out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && out);
    batten_triangulate_options chosen = batten_triangulate_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_triangulate_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    status = check_points(points.count, points.at, &chosen);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)points.count;
    batten_plane_triangles made = {0};
    double *scaled = bat_array(n, 2 * sizeof *scaled);
    made.first = bat_array(n, sizeof *made.first);
    made.vertex_of = bat_array(n, sizeof *made.vertex_of);
    status = scaled && made.first && made.vertex_of ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const int exponent = scale_points(points.count, points.at, scaled);
        const double tolerance = ldexp(chosen.tolerance, exponent);
        status = merge_points(points.count, tolerance < 0x1p-50 ? 0 : tolerance, scaled, &made);
    }
    if (status == BATTEN_OK)
        status = find_triangles(scaled, chosen.job, &made);
    if (status == BATTEN_OK)
        status = drop_slivers(scaled, chosen.sliver, &made);
    if (status == BATTEN_OK)
        status = take_vertices(points.at, &made);
    bat_release(scaled);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_plane_triangles_release(&made);
    return status;
}
