/* Normals, triangulated polygons and the remarks that all formats of meshes share. */
#include "exchange/meshes/facets.h"
#include "numeric/vector.h"

#include <string.h>

void bat_facet_normal(const double a[3], const double b[3], const double c[3], double normal[3])
{
    double u[3], v[3], size = 0;
    for (int k = 0; k < 3; k++) {
        u[k] = b[k] / 2 - a[k] / 2;
        v[k] = c[k] / 2 - a[k] / 2;
        size = bat_max(size, bat_max(fabs(u[k]), fabs(v[k])));
    }
    normal[0] = normal[1] = normal[2] = 0;
    if (size == 0)
        return;
    for (int k = 0; k < 3; k++) {
        u[k] /= size;
        v[k] /= size;
    }
    double n[3];
    bat_cross(u, v, n);
    const double length = bat_hypot(bat_hypot(n[0], n[1]), n[2]);
    for (int k = 0; k < 3 && length > 0; k++)
        normal[k] = n[k] / length;
}

/* ---- polygons ---- */

/* The corners that are left while ears are cut, as a ring. */
typedef struct {
    double xy[BAT_POLYGON_MOST][2];
    int next[BAT_POLYGON_MOST], before[BAT_POLYGON_MOST];
} ring;

/* The part of the side from corner i to `next`. */
static void add_side(const double *points, int i, int next, double size, double area[3])
{
    double p[3], q[3];
    for (int k = 0; k < 3; k++) {
        p[k] = (points[3 * i + k] / 2 - points[k] / 2) / size;
        q[k] = (points[3 * next + k] / 2 - points[k] / 2) / size;
    }
    area[0] += p[1] * q[2] - p[2] * q[1];
    area[1] += p[2] * q[0] - p[0] * q[2];
    area[2] += p[0] * q[1] - p[1] * q[0];
}

/* Twice the vector area, after Newell; scaled so that nothing overflows. */
static void vector_area(int count, const double *points, double area[3])
{
    double size = 0;
    area[0] = area[1] = area[2] = 0;
    for (int i = 0; i < 3 * count; i++)
        size = bat_max(size, fabs(points[i] / 2 - points[i % 3] / 2));
    for (int i = 0; i < count && size > 0; i++)
        add_side(points, i, (i + 1) % count, size, area);
}

static void cut_fan(int count, int *triangles)
{
    for (int i = 0; i + 2 < count; i++) {
        triangles[3 * i] = 0;
        triangles[3 * i + 1] = i + 1;
        triangles[3 * i + 2] = i + 2;
    }
}

/* Are all triangles of the fan turned as the whole is? */
static bool fan_covers(int count, const double *points, const double area[3])
{
    for (int i = 1; i + 1 < count; i++) {
        double n[3];
        bat_facet_normal(points, points + 3 * i, points + 3 * (i + 1), n);
        if (n[0] * area[0] + n[1] * area[1] + n[2] * area[2] < 0)
            return false;
    }
    return true;
}

/* Twice the area of three corners in the plane. */
static double corner_area(const ring *r, int a, int b, int c)
{
    const double *p = r->xy[a], *q = r->xy[b], *s = r->xy[c];
    return (q[0] - p[0]) * (s[1] - p[1]) - (q[1] - p[1]) * (s[0] - p[0]);
}

/* Is corner i within the triangle, and not at one of its corners? */
static bool is_in_ear(const ring *r, int i, int a, int tip, int c)
{
    const bool same = memcmp(r->xy[i], r->xy[a], sizeof r->xy[i]) == 0 ||
                      memcmp(r->xy[i], r->xy[tip], sizeof r->xy[i]) == 0 ||
                      memcmp(r->xy[i], r->xy[c], sizeof r->xy[i]) == 0;
    return !same && corner_area(r, a, tip, i) >= 0 && corner_area(r, tip, c, i) >= 0 &&
           corner_area(r, c, a, i) >= 0;
}

static bool is_ear(const ring *r, int tip)
{
    const int a = r->before[tip], c = r->next[tip];
    if (corner_area(r, a, tip, c) <= 0)
        return false;
    for (int i = r->next[c]; i != a; i = r->next[i])
        if (is_in_ear(r, i, a, tip, c))
            return false;
    return true;
}

static int largest_axis(const double area[3])
{
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(area[k]) > fabs(area[axis]))
            axis = k;
    return axis;
}

/* The polygon seen along the axis in which its area is largest, counter-clockwise. */
static void begin_ring(int count, const double *points, const double area[3], ring *r)
{
    const int axis = largest_axis(area);
    const int x = (axis + (area[axis] < 0 ? 2 : 1)) % 3, y = 3 - axis - x;
    for (int i = 0; i < count; i++) {
        r->xy[i][0] = points[3 * i + x] / 2 - points[x] / 2;
        r->xy[i][1] = points[3 * i + y] / 2 - points[y] / 2;
        r->next[i] = (i + 1) % count;
        r->before[i] = (i + count - 1) % count;
    }
}

static void cut_ears(int count, ring *r, int *triangles, bool *is_odd)
{
    int at = 0;
    for (int left = count; left > 3; left--) {
        int tries = 0;
        for (; tries < left && !is_ear(r, at); tries++)
            at = r->next[at];
        *is_odd = *is_odd || tries == left;
        const int a = r->before[at], c = r->next[at];
        const int ear[3] = {a, at, c};
        memcpy(triangles, ear, sizeof ear);
        triangles += 3;
        r->next[a] = c;
        r->before[c] = a;
        at = r->next[c]; /* away from the last cut: triangles stay wide */
    }
    const int last[3] = {r->before[at], at, r->next[at]};
    *is_odd = *is_odd || corner_area(r, last[0], last[1], last[2]) < 0;
    memcpy(triangles, last, sizeof last);
}

void bat_polygon_triangles(int count, const double *points, int *triangles, bool *is_odd)
{
    double area[3];
    *is_odd = false;
    cut_fan(count, triangles);
    if (count == 3)
        return;
    vector_area(count, points, area);
    if (fan_covers(count, points, area))
        return;
    if (count > BAT_POLYGON_MOST) {
        *is_odd = true;
        return;
    }
    ring r;
    begin_ring(count, points, area, &r);
    cut_ears(count, &r, triangles, is_odd);
}

/* ---- corners ---- */

static bool same_normal(const batten_mesh_parts *p, int a, int b)
{
    return !p->normals || memcmp(p->normals + 3 * (size_t)a, p->normals + 3 * (size_t)b,
                                 3 * sizeof *p->normals) == 0;
}

batten_status bat_number_corners(const batten_mesh_parts *p, bat_corners *out)
{
    const size_t count = 3 * (size_t)p->triangle_count;
    bat_corners c = {.count = 0};
    int *last = bat_array((size_t)p->vertex_count, sizeof *last); /* number + 1 */
    c.index = bat_array(count, sizeof *c.index);
    c.source = bat_array(count, sizeof *c.source);
    if (!last || !c.index || !c.source) {
        bat_release(last);
        bat_corners_end(&c);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        int *before = &last[p->corners[i]];
        if (!*before || !same_normal(p, (int)i, c.source[*before - 1])) {
            c.source[c.count] = (int)i;
            *before = ++c.count;
        }
        c.index[i] = *before - 1;
    }
    bat_release(last);
    *out = c;
    return BATTEN_OK;
}

void bat_corners_end(bat_corners *corners)
{
    bat_release(corners->index);
    bat_release(corners->source);
}

/* ---- names and remarks ---- */

bat_span bat_name_core(const char *name, const char *otherwise)
{
    bat_span core = {name, strlen(name)};
    while (core.length > 0 && (unsigned char)core.bytes[0] <= ' ') {
        core.bytes++;
        core.length--;
    }
    while (core.length > 0 && (unsigned char)core.bytes[core.length - 1] <= ' ')
        core.length--;
    return core.length > 0 ? core : (bat_span){otherwise, strlen(otherwise)};
}

void bat_remark_unit(const batten_model *model, const char *title, batten_notes *notes)
{
    const double unit = batten_model_unit_metres(model);
    if (unit > 0)
        batten_notes_remark(notes, "", 0, "",
                            "%s files name no unit; the numbers are in units of %g m", title,
                            unit);
}

void bat_remark_polygons(const bat_input *input, size_t polygons)
{
    if (polygons)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "faces of more than three corners: %zu; read as triangles",
                            polygons);
}

static bool is_flat(const batten_mesh_parts *p, int i)
{
    const int *t = p->corners + 3 * (size_t)i;
    double n[3];
    bat_facet_normal(p->points + 3 * (size_t)t[0], p->points + 3 * (size_t)t[1],
                     p->points + 3 * (size_t)t[2], n);
    return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

int bat_count_flat(const batten_mesh *mesh)
{
    const batten_mesh_parts *p = batten_mesh_view(mesh);
    int flat = 0;
    for (int i = 0; i < p->triangle_count; i++)
        flat += is_flat(p, i);
    return flat;
}

void bat_remark_flat(const batten_mesh *mesh, const char *file, const char *name,
                     batten_notes *notes)
{
    const int flat = bat_count_flat(mesh);
    if (flat)
        batten_notes_remark(notes, file, 0, name, "%d of %d triangles have no area; kept", flat,
                            batten_mesh_view(mesh)->triangle_count);
}
