/*
 * Where a face needs points: cells in (u, v) over which two triangles are near enough, in a
 * plane in which they are about square. Lines along which the surface has a crease are lines
 * between cells.
 */
#ifndef BAT_MESH_LATTICE_H
#define BAT_MESH_LATTICE_H
#include "mesh/faces/meshing.h"

/* One direction: parameters and places in the plane of ends and creases. */
typedef struct {
    int count;     /* of breaks, 2 or more */
    double *u, *x; /* [count], rising; x from 0 on */
    int *cells; /* [count - 1] between breaks; x of their lines are multiples of powers of 2 */
} bat_lattice_axis;

typedef struct {
    double x, y;
    int level;
} bat_seed;

typedef struct {
    const bat_sheet *sheet;
    bat_lattice_axis axis[2];
    double predicted; /* triangles over the whole of the box */
    int seed_count, seed_room;
    bat_seed *seeds; /* coarse ones first */
} bat_lattice;

/* Over the box in (u, v); the seeds are for later. */
batten_status bat_lattice_begin(bat_lattice *lattice, const bat_meshing *m,
                                const bat_sheet *sheet, const batten_interval box[2]);
void bat_lattice_end(bat_lattice *lattice);
batten_status bat_lattice_seeds(bat_lattice *lattice, bat_meshing *m);

/* The first break at x or behind; `count` when there is none. */
int bat_lattice_break(const bat_lattice_axis *axis, double x);
double bat_lattice_to_plane(const bat_lattice_axis *axis, double u);
double bat_lattice_from_plane(const bat_lattice_axis *axis, double x);

/* What a step in u or v may be at a point, of the table of derivatives to order 2. */
typedef struct {
    double length[2]; /* |Su|, |Sv| */
    double bend[3];   /* of Suu, Suv, Svv what leaves the tangent plane; all, at a pole */
    double turn[2];   /* |n_u|, |n_v| */
} bat_lattice_bounds;
void bat_lattice_bound(const double *derivatives, bat_lattice_bounds *bounds);

/* Across a cell the surface may rise by so much of the cell's width the other way. */
static inline double bat_lattice_tilt(const bat_meshing *m)
{
    return bat_min(m->angle, 0.35);
}

/* Faces seldom need more than some tens of what was foreseen: where a surface turns about in a
 * span of no length, as with one number of its file damaged, halving its cells has no end. */
static inline double bat_lattice_enough(double foreseen)
{
    return 20000 + 64 * bat_min(foreseen, 20000) + 8 * foreseen;
}

/* ---- sheet.c ---- */

batten_status bat_sheet_is_crease(const bat_sheet *sheet, int d, double at, bool *found);

#endif
