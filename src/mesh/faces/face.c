/* The triangles of one face: its border, points inside, then out into the mesh. */
#include "mesh/faces/face.h"
#include "numeric/vector.h"

#include <string.h>

/* The order of the seeds, level after level and in each along their cells, is one in which each
 * is near to the one before. */
static batten_status insert_seeds(bat_face_mesh *f, const bat_rim *rim, bat_lattice *lattice)
{
    const int first = f->count;
    batten_status status = bat_rim_choose_seeds(rim, lattice);
    for (int i = 0; status == BATTEN_OK && i < lattice->seed_count; i++) {
        const double at[2] = {lattice->seeds[i].x, lattice->seeds[i].y};
        status = bat_face_insert(f, at, -0.5, 0.25, NULL);
        if (status == BATTEN_OK && f->sides.steps - f->told >= 8192)
            status = bat_face_step(f, 0, 0.5 * i / lattice->seed_count);
    }
    return status == BATTEN_OK ? bat_face_evaluate(f, first) : status;
}

/* Where a corner has no normal, the mean of the others'; without any, that of the triangle. */
static void complete_normals(const bat_face_mesh *f, const bat_side_triangle *t,
                             double normals[3][3], const bool found[3])
{
    double mean[3] = {0, 0, 0}, a[3], b[3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            mean[k] += found[i] ? normals[i][k] : 0;
    /* Unit vectors whose sum is below a millionth cancel. */
    if (!(bat_dot(3, mean, mean) > 1e-12)) {
        for (int k = 0; k < 3; k++) {
            a[k] = f->vertices[t->corner[1]].point[k] - f->vertices[t->corner[0]].point[k];
            b[k] = f->vertices[t->corner[2]].point[k] - f->vertices[t->corner[0]].point[k];
        }
        const double size = bat_max(sqrt(bat_dot(3, a, a)), sqrt(bat_dot(3, b, b)));
        for (int k = 0; k < 3; k++)
            mean[k] = size > 0 ? a[(k + 1) % 3] / size * (b[(k + 2) % 3] / size) -
                                     a[(k + 2) % 3] / size * (b[(k + 1) % 3] / size)
                               : 0;
    }
    const double length = sqrt(bat_dot(3, mean, mean));
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3 && !found[i]; k++)
            normals[i][k] = length > 0 ? mean[k] / length : k == 2;
}

static batten_status emit_triangle(bat_face_mesh *f, const bat_side_triangle *t)
{
    const bool reversed = f->m->parts->faces[f->face].reversed;
    double normals[3][3], turned[9];
    bool found[3];
    int corners[3];
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 3; k++) {
        bat_face_vertex *v = &f->vertices[t->corner[k]];
        if (v->vertex < 0)
            status = bat_meshing_point(f->m, v->point, &v->vertex);
        if (status == BATTEN_OK)
            status = bat_face_normal(f, t, k, normals[k], &found[k]);
    }
    if (status != BATTEN_OK)
        return status;
    complete_normals(f, t, normals, found);
    for (int k = 0; k < 3; k++) {
        const int from = reversed ? (3 - k) % 3 : k;
        corners[k] = f->vertices[t->corner[from]].vertex;
        for (int i = 0; i < 3; i++)
            turned[3 * k + i] = reversed ? -normals[from][i] : normals[from][i];
    }
    bat_reached *done = &f->m->done[f->face];
    done->chord = bat_max(done->chord, t->miss);
    done->angle = bat_max(done->angle, t->turn);
    if (t->miss > f->m->chord) {
        done->beyond++;
        done->off = bat_max(done->off, bat_face_off(f, t));
    }
    return bat_meshing_triangle(f->m, corners, turned, f->face);
}

static batten_status emit_triangles(bat_face_mesh *f, const bat_pairs *own)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < own->count; i++)
        status = bat_meshing_take(f->m, f->face, own->pairs[i][0], own->pairs[i][1]);
    for (int i = 0; status == BATTEN_OK && i < f->sides.count; i++) {
        const bat_side_triangle *t = &f->sides.triangles[i];
        if (t->inside && !bat_face_vanishes(f, t))
            status = emit_triangle(f, t);
    }
    return status;
}

/* The triangles of the border are there: points inside, then out into the mesh. */
static batten_status fill_face(bat_face_mesh *f, const bat_rim *rim, bat_lattice *lattice)
{
    bat_pairs own;
    batten_status status = bat_pairs_begin(&own, 64);
    if (status != BATTEN_OK)
        return status;
    status = bat_face_take_rim(f, rim);
    f->enough = bat_min(bat_lattice_enough(f->sides.count + lattice->predicted),
                        2.0 * f->m->most + 20000);
    if (status == BATTEN_OK)
        status = insert_seeds(f, rim, lattice);
    if (status == BATTEN_OK)
        status = bat_face_refine(f);
    if (status == BATTEN_OK)
        status = bat_face_divide_doubles(f, &own);
    if (status == BATTEN_OK)
        status = bat_face_refine(f);
    if (status == BATTEN_OK)
        status = emit_triangles(f, &own);
    bat_pairs_end(&own);
    return status;
}

batten_status bat_mesh_face(bat_meshing *m, int face, bat_pairs *splits, bool *simple)
{
    bat_rim rim;
    bat_lattice lattice = {0};
    batten_interval box[2];
    bat_face_mesh f = {.m = m, .face = face, .sheet = &m->sheets[face], .lattice = &lattice};
    batten_status status = bat_rim_begin(&rim, m, face, NULL);
    if (status != BATTEN_OK)
        return status;
    bat_rim_box(&rim, box);
    status = bat_lattice_begin(&lattice, m, f.sheet, box);
    if (status == BATTEN_OK)
        status = bat_lattice_seeds(&lattice, m);
    if (status == BATTEN_OK && rim.has_poles) {
        bat_rim_end(&rim);
        status = bat_rim_begin(&rim, m, face, &lattice);
    }
    if (status == BATTEN_OK)
        status = bat_rim_triangles(&rim, &lattice, &f.sides, splits, simple);
    if (status == BATTEN_OK && *simple)
        status = bat_pairs_begin(&f.tight, 16);
    if (status == BATTEN_OK && *simple)
        status = fill_face(&f, &rim, &lattice);
    if (status == BATTEN_OK && *simple)
        status = bat_rim_refine(&rim, &f.tight, splits);
    bat_pairs_end(&f.tight);
    bat_sides_end(&f.sides);
    bat_release(f.vertices);
    bat_lattice_end(&lattice);
    bat_rim_end(&rim);
    return status;
}
