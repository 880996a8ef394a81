/* Triangles of one face. */
#ifndef BAT_MESH_FACE_H
#define BAT_MESH_FACE_H
#include "mesh/faces/rim.h"

typedef struct {
    double uv[2];
    double point[3];
    double normal[3];
    double off;                  /* of a border: how far its edge is from the surface there */
    bool regular;                /* there is a normal */
    bool has_limit, found_limit; /* the limit was asked for; it is the normal */
    int vertex;                  /* of the mesh; -1: none yet */
    int pole;                    /* as of bat_rim_corner */
    bool on_crease;              /* the normal depends on the triangle */
} bat_face_vertex;

typedef struct {
    bat_meshing *m;
    int face;
    const bat_sheet *sheet;
    const bat_lattice *lattice;
    bat_sides sides;
    int count, room; /* of vertices: those of the triangles in the plane */
    bat_face_vertex *vertices;
    int limits;    /* of normals asked for so far */
    double enough; /* triangles, after which they are not divided any more */
    bool has_enough;
    uint64_t told;   /* of the steps of `sides`, those that the job knows of */
    bat_pairs tight; /* sides that keep points away from where they are needed */
} bat_face_mesh;

/* How far the edges at its corners are from the surface: nearer to it the triangle cannot be.
 */
static inline double bat_face_off(const bat_face_mesh *f, const bat_side_triangle *t)
{
    double off = 0;
    for (int k = 0; k < 3; k++)
        off = bat_max(off, f->vertices[t->corner[k]].off);
    return off;
}

/* The corners of the border, as its triangles have them, become the first vertices. */
batten_status bat_face_take_rim(bat_face_mesh *f, const bat_rim *rim);
/* Put a point in, when it is not too near to others; *added may be NULL. */
batten_status bat_face_insert(bat_face_mesh *f, const double at[2], double widest,
                              double nearest, bool *added);
/* Tell the job of so many steps more, and of those that the triangles took; `part` of the face
 * is done. */
batten_status bat_face_step(bat_face_mesh *f, uint64_t steps, double part);
/* Points, normals of vertices from `first` on. */
batten_status bat_face_evaluate(bat_face_mesh *f, int first);
/* Does the triangle vanish at a pole? */
bool bat_face_vanishes(const bat_face_mesh *f, const bat_side_triangle *t);
/* The place of corner k in the plane; of one on a pole, opposite the middle of the others. */
void bat_face_place(const bat_face_mesh *f, const bat_side_triangle *t, int k, double at[2]);
/* The unit normal, Su x Sv, at corner k as the triangle sees it; false where there is none. */
batten_status bat_face_normal(bat_face_mesh *f, const bat_side_triangle *t, int k,
                              double normal[3], bool *found);

/* Put points into edges from border to border that are edges of other triangles already. `own`:
 * those edges that are none, as they are in the end (doubles.c). */
batten_status bat_face_divide_doubles(bat_face_mesh *f, bat_pairs *own);
/* Points where triangles are too far from the surface, or turn too much (refine.c). */
batten_status bat_face_refine(bat_face_mesh *f);

/* The whole: false in *simple when the border crosses itself. */
batten_status bat_mesh_face(bat_meshing *m, int face, bat_pairs *splits, bool *simple);

#endif
