/* What is true of a mesh: its edges, whether it is closed, area and volume. */
#include "base/pairs.h"
#include "base/sets.h"
#include <batten/mesh.h>
#include <float.h>
#include <string.h>

/* How often an edge is run along, from its lower vertex and towards it. */
typedef struct {
    int up, down, triangle; /* the first triangle */
} edge_uses;

typedef struct {
    const batten_mesh_parts *parts;
    bat_pairs edges;
    edge_uses *uses; /* [room] */
    int room;
    int *parent; /* [triangle_count] towards the root of its piece */
    batten_mesh_facts facts;
} checking;

static const int *corners_of(const checking *c, int triangle)
{
    return &c->parts->corners[3 * (size_t)triangle];
}

/* Fewer than three vertices: it has no edges. */
static bool is_collapsed(const int *t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/* ---- edges and pieces ---- */

static batten_status add_edge(checking *c, int triangle, int from, int to)
{
    const int known = c->edges.count;
    int index = 0;
    batten_status status =
        bat_pairs_add(&c->edges, bat_min_int(from, to), bat_max_int(from, to), &index);
    if (status != BATTEN_OK)
        return status;
    if (index == known) {
        if (index >= c->room) {
            edge_uses *uses = bat_resize(c->uses, (size_t)c->edges.room, sizeof *uses);
            if (!uses)
                return BATTEN_OUT_OF_MEMORY;
            c->uses = uses;
            c->room = c->edges.room;
        }
        c->uses[index] = (edge_uses){0, 0, triangle};
    }
    edge_uses *use = &c->uses[index];
    if (from < to)
        use->up++;
    else
        use->down++;
    bat_sets_join(c->parent, use->triangle, triangle);
    return BATTEN_OK;
}

static batten_status add_edges(checking *c)
{
    batten_status status = BATTEN_OK;
    bat_sets_begin(c->parts->triangle_count, c->parent);
    for (int t = 0; status == BATTEN_OK && t < c->parts->triangle_count; t++) {
        const int *corners = corners_of(c, t);
        for (int k = 0; status == BATTEN_OK && k < 3 && !is_collapsed(corners); k++)
            status = add_edge(c, t, corners[k], corners[(k + 1) % 3]);
    }
    return status;
}

static void count_edges(checking *c)
{
    batten_mesh_facts *f = &c->facts;
    f->edges = c->edges.count;
    for (int i = 0; i < c->edges.count; i++) {
        const edge_uses *use = &c->uses[i];
        f->rim_edges += use->up + use->down == 1;
        f->wrong_edges += use->up + use->down == 2 && use->up != 1;
        f->crowded_edges += use->up + use->down > 2;
    }
    f->is_watertight = f->edges > 0 && !f->rim_edges && !f->wrong_edges && !f->crowded_edges;
}

/* What a vertex is of. */
enum { OF_NONE, OF_COLLAPSED, OF_TRIANGLE };

static batten_status count_vertices(checking *c)
{
    batten_mesh_facts *f = &c->facts;
    unsigned char *use = bat_array((size_t)c->parts->vertex_count, 1);
    if (!use)
        return BATTEN_OUT_OF_MEMORY;
    int triangles = 0, used = 0;
    for (int t = 0; t < c->parts->triangle_count; t++) {
        const int *corners = corners_of(c, t);
        const unsigned char kind = is_collapsed(corners) ? OF_COLLAPSED : OF_TRIANGLE;
        for (int k = 0; k < 3; k++)
            if (use[corners[k]] < kind)
                use[corners[k]] = kind;
        triangles += kind == OF_TRIANGLE;
        f->pieces += kind == OF_TRIANGLE && c->parent[t] == t;
    }
    for (int v = 0; v < c->parts->vertex_count; v++) {
        f->loose_vertices += use[v] == OF_NONE;
        used += use[v] == OF_TRIANGLE;
    }
    f->euler = used - f->edges + triangles;
    bat_release(use);
    return BATTEN_OK;
}

/* ---- measures ---- */

/* Area and volume times 2 and 6, and their first moments, of points moved and scaled into a box
 * of size 2: so that no square overflows or vanishes. */
typedef struct {
    double centre[3], scale; /* a power of two */
    double area, area_moment[3], volume, volume_moment[3];
} sums;

static void choose_scale(const batten_mesh *mesh, sums *s)
{
    const batten_box box = batten_mesh_box(mesh);
    const double low[3] = {box.low.x, box.low.y, box.low.z};
    const double high[3] = {box.high.x, box.high.y, box.high.z};
    double half = 0;
    for (int k = 0; k < 3; k++) {
        s->centre[k] = low[k] / 2 + high[k] / 2;
        half = bat_max(half, high[k] / 2 - low[k] / 2);
    }
    s->scale = half > 0 ? ldexp(1, ilogb(half)) : 1;
}

/* Returns whether the triangle is flat: its area is within the roundoff of its corners. */
static bool add_triangle(const batten_mesh_parts *parts, const int *corners, sums *s)
{
    double p[3][3], d[2][3], n[3], longest = 0;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const double x = parts->points[3 * (size_t)corners[i] + (size_t)k];
            p[i][k] = (x - s->centre[k]) / s->scale;
        }
    for (int k = 0; k < 3; k++) {
        d[0][k] = p[1][k] - p[0][k];
        d[1][k] = p[2][k] - p[0][k];
        longest = bat_max(longest, bat_max(fabs(d[0][k]), fabs(d[1][k])));
    }
    for (int k = 0; k < 3; k++)
        n[k] = d[0][(k + 1) % 3] * d[1][(k + 2) % 3] - d[0][(k + 2) % 3] * d[1][(k + 1) % 3];
    const double area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double volume = n[0] * p[0][0] + n[1] * p[0][1] + n[2] * p[0][2];
    s->area += area;
    s->volume += volume;
    for (int k = 0; k < 3; k++) {
        const double sum = p[0][k] + p[1][k] + p[2][k];
        s->area_moment[k] += area * sum / 3;
        s->volume_moment[k] += volume * sum / 4;
    }
    return area <= 8 * DBL_EPSILON * longest * longest;
}

static batten_status measure_mesh(const batten_mesh *mesh, checking *c)
{
    sums s = {.scale = 1};
    batten_mesh_facts *f = &c->facts;
    choose_scale(mesh, &s);
    for (int t = 0; t < c->parts->triangle_count; t++) {
        const int *corners = corners_of(c, t);
        f->flat_triangles += add_triangle(c->parts, corners, &s) || is_collapsed(corners);
    }
    const bool has_volume = f->is_watertight && s.volume != 0;
    f->area = s.area / 2 * s.scale * s.scale;
    f->volume = has_volume ? s.volume / 6 * s.scale * s.scale * s.scale : 0;
    for (int k = 0; k < 3; k++) {
        const double moment = has_volume   ? s.volume_moment[k] / s.volume
                              : s.area > 0 ? s.area_moment[k] / s.area
                                           : 0;
        f->centroid[k] = s.centre[k] + moment * s.scale;
    }
    return isfinite(f->area) && isfinite(f->volume)
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW, "the area or volume of a mesh of size %g overflows",
                          s.scale);
}

batten_status batten_mesh_check(const batten_mesh *mesh, batten_mesh_facts *out)
{
    checking c = {.parts = batten_mesh_view(mesh)};
    const size_t triangles = (size_t)c.parts->triangle_count;
    batten_status status = bat_pairs_begin(&c.edges, 3 * triangles / 2);
    if (status != BATTEN_OK)
        return status;
    c.parent = bat_array(triangles, sizeof *c.parent);
    status = c.parent ? add_edges(&c) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        count_edges(&c);
        status = count_vertices(&c);
    }
    if (status == BATTEN_OK)
        status = measure_mesh(mesh, &c);
    if (status == BATTEN_OK)
        *out = c.facts;
    bat_release(c.parent);
    bat_release(c.uses);
    bat_pairs_end(&c.edges);
    return status;
}
