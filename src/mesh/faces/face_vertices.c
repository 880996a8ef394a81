/* The vertices of the triangles of one face: put in, evaluated, with their normals as each
 * triangle sees them. */
#include "mesh/faces/face.h"
#include "numeric/vector.h"

#include <string.h>

static batten_status grow_vertices(bat_face_mesh *f)
{
    if (f->sides.vertex_count <= f->room)
        return BATTEN_OK;
    const int room = f->sides.vertex_room;
    bat_face_vertex *vertices = bat_resize(f->vertices, (size_t)room, sizeof *vertices);
    if (!vertices)
        return BATTEN_OUT_OF_MEMORY;
    f->vertices = vertices;
    f->room = room;
    return BATTEN_OK;
}

/* Is a place on a line between cells across which the surface may have a crease? */
static bool is_on_break(const bat_lattice_axis *axis, double x)
{
    const int i = bat_max_int(1, bat_lattice_break(axis, x - 1e-9));
    return i + 1 < axis->count && axis->x[i] <= x + 1e-9;
}

static bat_face_vertex vertex_at(const bat_face_mesh *f, const double at[2])
{
    bat_face_vertex made = {.vertex = -1};
    for (int k = 0; k < 2; k++) {
        const bat_lattice_axis *axis = &f->lattice->axis[k];
        made.uv[k] = bat_lattice_from_plane(axis, at[k]);
        made.on_crease = made.on_crease || is_on_break(axis, at[k]);
    }
    return made;
}

batten_status bat_face_insert(bat_face_mesh *f, const double at[2], double widest,
                              double nearest, bool *added)
{
    int vertex = -1;
    batten_status status = bat_sides_insert(&f->sides, at, widest, nearest, &vertex);
    if (status == BATTEN_OK && vertex >= 0) {
        status = grow_vertices(f);
        if (status == BATTEN_OK) {
            f->vertices[vertex] = vertex_at(f, at);
            f->count = vertex + 1;
        }
    }
    if (added)
        *added = vertex >= 0;
    const double most = 2.0 * f->m->most + 2.0 * f->count + 1000;
    if (status == BATTEN_OK && f->sides.count > most)
        return bat_fail(BATTEN_TOO_LARGE, "face %d needs more than %d triangles", f->face + 1,
                        f->m->most);
    return status;
}

batten_status bat_face_step(bat_face_mesh *f, uint64_t steps, double part)
{
    const uint64_t more = f->sides.steps - f->told;
    f->told = f->sides.steps;
    return bat_work_step(&f->m->work, steps + more, (f->face + part) / f->m->parts->face_count,
                         "triangles of faces");
}

batten_status bat_face_evaluate(bat_face_mesh *f, int first)
{
    enum { EACH = 128 };
    double uv[EACH][2];
    double *d = bat_array3(EACH, 9, sizeof *d);
    if (!d)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = first; status == BATTEN_OK && i < f->count; i += EACH) {
        const int count = bat_min_int(EACH, f->count - i);
        for (int k = 0; k < count; k++) {
            memcpy(uv[k], f->vertices[i + k].uv, sizeof uv[k]);
            bat_sheet_wrap(f->sheet, uv[k]);
        }
        status =
            batten_surface_evaluate_many(f->sheet->surface, (size_t)count, uv[0], 1, NULL, d);
        for (int k = 0; status == BATTEN_OK && k < count; k++) {
            static const batten_side side[2] = {BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT};
            bat_face_vertex *v = &f->vertices[i + k];
            status = bat_sheet_steady(f->sheet, uv[k], side, d + 9 * k);
            v->regular = bat_sheet_normal(d + 9 * k, v->normal);
            if (v->vertex < 0)
                memcpy(v->point, d + 9 * k, sizeof v->point);
            v->off = bat_distance(3, v->point, d + 9 * k);
        }
    }
    bat_release(d);
    return status;
}

bool bat_face_vanishes(const bat_face_mesh *f, const bat_side_triangle *t)
{
    for (int k = 0; k < 3; k++) {
        const bat_face_vertex *a = &f->vertices[t->corner[(k + 1) % 3]];
        const bat_face_vertex *b = &f->vertices[t->corner[(k + 2) % 3]];
        if ((t->fixed >> k & 1) && a->pole && b->pole && a->vertex == b->vertex)
            return true;
    }
    return false;
}

void bat_face_place(const bat_face_mesh *f, const bat_side_triangle *t, int k, double at[2])
{
    const int pole = f->vertices[t->corner[k]].pole;
    memcpy(at, f->sides.at[t->corner[k]], 2 * sizeof *at);
    if (pole) {
        const double *a = f->sides.at[t->corner[(k + 1) % 3]];
        const double *b = f->sides.at[t->corner[(k + 2) % 3]];
        at[pole - 1] = (a[pole - 1] + b[pole - 1]) / 2;
    }
}

/* The normal on the side of a crease where the triangle is. */
static batten_status one_sided(const bat_face_mesh *f, const bat_side_triangle *t, int k,
                               double normal[3], bool *found)
{
    double d[9], uv[2];
    batten_side side[2];
    memcpy(uv, f->vertices[t->corner[k]].uv, sizeof uv);
    bat_sheet_wrap(f->sheet, uv);
    for (int i = 0; i < 2; i++) {
        const batten_interval domain = f->sheet->domain[i];
        const double here = f->sides.at[t->corner[k]][i];
        const bool left =
            f->sides.at[t->corner[(k + 1) % 3]][i] + f->sides.at[t->corner[(k + 2) % 3]][i] <
            2 * here;
        side[i] = left ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
        if (f->sheet->closed[i] && uv[i] == (left ? domain.a : domain.b))
            uv[i] = left ? domain.b : domain.a;
    }
    const batten_status status = batten_surface_evaluate_side(
        f->sheet->surface, uv[0], uv[1], (batten_sides){side[0], side[1]}, 1, d);
    *found = status == BATTEN_OK && bat_sheet_normal(d, normal);
    return status;
}

/* The limit where Su x Sv vanishes. */
static batten_status limit_normal(const bat_face_mesh *f, const bat_side_triangle *t, int k,
                                  double normal[3], bool *found)
{
    double at[2], uv[2];
    batten_vec3 n;
    bat_face_place(f, t, k, at);
    for (int i = 0; i < 2; i++)
        uv[i] = bat_lattice_from_plane(&f->lattice->axis[i], at[i]);
    bat_sheet_wrap(f->sheet, uv);
    const batten_status status =
        batten_surface_normal(f->sheet->surface, uv[0], uv[1], NULL, &n);
    *found = status == BATTEN_OK;
    normal[0] = *found ? n.x : 0;
    normal[1] = *found ? n.y : 0;
    normal[2] = *found ? n.z : 0;
    return status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
}

/* A limit costs as much as some hundred points: each vertex is asked once, and where a surface
 * has no normal all over, as a damaged one, no more after so many. */
enum { MOST_LIMITS = 4096 };

batten_status bat_face_normal(bat_face_mesh *f, const bat_side_triangle *t, int k,
                              double normal[3], bool *found)
{
    bat_face_vertex *v = &f->vertices[t->corner[k]];
    batten_status status = BATTEN_OK;
    if (v->on_crease)
        return one_sided(f, t, k, normal, found);
    if (v->pole)
        return limit_normal(f, t, k, normal, found);
    if (!v->regular && !v->has_limit && f->limits < MOST_LIMITS) {
        status = limit_normal(f, t, k, v->normal, &v->found_limit);
        v->has_limit = true;
        f->limits++;
    }
    memcpy(normal, v->normal, 3 * sizeof *normal);
    *found = v->regular || v->found_limit;
    return status;
}

static void place_corner(bat_face_mesh *f, const bat_rim *rim, int i)
{
    const bat_rim_corner *c = &rim->corners[i];
    bat_face_vertex *v = &f->vertices[rim->vertex_of[i]];
    *v = vertex_at(f, rim->at[i]);
    memcpy(v->uv, c->uv, sizeof v->uv);
    memcpy(v->point, f->m->points[c->vertex], sizeof v->point);
    v->vertex = c->vertex;
    v->pole = c->pole;
}

batten_status bat_face_take_rim(bat_face_mesh *f, const bat_rim *rim)
{
    const batten_status status = grow_vertices(f);
    if (status != BATTEN_OK)
        return status;
    f->count = f->sides.vertex_count;
    for (int i = 0; i < rim->count; i++)
        place_corner(f, rim, i);
    return bat_face_evaluate(f, 0);
}
