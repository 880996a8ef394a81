/* The border of a face as polygons in its plane, and the triangles between their corners. */
#ifndef BAT_MESH_RIM_H
#define BAT_MESH_RIM_H
#include "mesh/faces/lattice.h"
#include "mesh/faces/sides.h"

/* A corner of a polygon, and the side that follows. */
typedef struct {
    double uv[2];
    int vertex;  /* of the mesh */
    int next;    /* corner */
    int edge;    /* of the body; at a pole -1 */
    int segment; /* of the edge's polyline */
    int pole;    /* 0: none; of a corner on a pole, 1 when u runs along it, 2 when v does */
} bat_rim_corner;

typedef struct {
    int count, room;
    bat_rim_corner *corners;
    double (*at)[2]; /* [count] in the plane */
    int *vertex_of;  /* [count] in the triangles */
    bool has_poles;
} bat_rim;

/* Edges that are off their surface, or beyond its end, may have curves in (u, v) that touch
 * where they themselves do not. When the face is `spread` each corner is where, by the tangent
 * plane, the edge is, also beyond the end.
 * @param lattice its seeds on the line of a pole become corners there; NULL: none */
batten_status bat_rim_begin(bat_rim *rim, const bat_meshing *m, int face,
                            const bat_lattice *lattice);
void bat_rim_end(bat_rim *rim);
void bat_rim_box(const bat_rim *rim, batten_interval box[2]);
/* The triangles, when the polygons neither cross nor touch; else `splits` gets the segments
 * (edge, segment) that should be finer, *is_simple is false, and there is nothing to release.
 */
batten_status bat_rim_triangles(bat_rim *rim, const bat_lattice *lattice, bat_sides *sides,
                                bat_pairs *splits, bool *is_simple);
/* Keep those seeds of the lattice that are inside, each place once (seeds_within.c). */
batten_status bat_rim_choose_seeds(const bat_rim *rim, bat_lattice *lattice);
/* `splits` gets all segments. */
batten_status bat_rim_refine_all(const bat_rim *rim, bat_pairs *splits);
/* `splits` gets the segments between these pairs of vertices (the lesser first) of the
 * triangles. */
batten_status bat_rim_refine(const bat_rim *rim, const bat_pairs *between, bat_pairs *splits);

#endif
