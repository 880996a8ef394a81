/*
 * Developable surfaces in four files: edges and the warp between them (developable_edges.c),
 * the path of least warp (developable_path.c), the surface along it (developable_surface.c),
 * and what is given and found (developable.c).
 */
#ifndef BAT_DEVELOPABLE_PARTS_H
#define BAT_DEVELOPABLE_PARTS_H
#include "base/base.h"
#include <batten/plate.h>

/* Steps of the lattice along each edge: a ruling is found where no two possible ones are nearer
 * than that. */
enum { BAT_EDGE_STEPS = 192 };

/* An edge in space, by shares of its length, 0 to 1. */
typedef struct {
    const batten_curve *curve;
    double length;
    double u[BAT_EDGE_STEPS + 1], rate[BAT_EDGE_STEPS + 1]; /* parameter, and by the share */
} bat_plate_edge;

/* A point of an edge with its unit tangent. */
typedef struct {
    batten_vec3 P, T;
    double u;
} bat_edge_place;

/* A ruling: shares of both lengths. */
typedef struct {
    double x, y;
} bat_pair;

typedef struct {
    bat_plate_edge edge[2];
    double size;
    bool rough; /* the path stays as it was found: beside it are roots here and none there */
    int count;
    bat_pair *pairs; /* [count] between the cones, if any: the ends of the path are at (0, 0) or
                        on a side of the unit square that meets it, and alike at (1, 1) */
} bat_plate;

/* Smooth edges, with `name` for messages. */
batten_status bat_plate_edge_make(const batten_curve *curve, const char *name,
                                  bat_plate_edge *out);
batten_status bat_plate_edge_at(const bat_plate_edge *edge, double x, bat_edge_place *out);

/* Sine, with a sign, and cosine of the warp of a ruling of at least `least` length; false where
 * there is no plane at one end. */
bool bat_warp_of(const bat_edge_place *a, const bat_edge_place *b, double least, double *sine,
                 double *cosine);
batten_status bat_plate_warp(const bat_plate *plate, bat_pair at, bool *has, double *sine,
                             double *cosine);

/* Fills `pairs`, some hundreds. */
batten_status bat_plate_find_path(bat_plate *plate);
/* Each pair towards the mean of its neighbours, so often; the ends stay. */
void bat_plate_smooth(bat_plate *plate, int passes);
/* From a pair along a direction of length 1. */
typedef struct {
    bat_pair from, along;
} bat_pair_line;

/* Where on a line the warp is 0 nearest to `from`, within `reach` (from -.. to ..) and inside
 * the unit square; *found says whether there is one. */
batten_status bat_plate_root(const bat_plate *plate, const bat_pair_line *on,
                             batten_interval reach, bool *found, bat_pair *out);

/* The surface between the cones, through so many of its rulings. */
typedef struct {
    int count;
    bat_pair *pairs;   /* [count] */
    double *tau;       /* [count] of the interpolation: the sum of both chords */
    double *points[2]; /* [count][3] on each edge */
    double *u[2];      /* [count] their parameters */
    batten_curve *edge[2];
    batten_surface *surface;
    double error;
} bat_middle;

/* Room for so many rulings; *m is all zeros before. */
batten_status bat_middle_reserve(int count, bat_middle *m);
/* Points and parameters of its pairs; refused where the edges touch. */
batten_status bat_middle_place(const bat_plate *plate, bat_middle *m);
/* With so many rulings that edges and warp are near enough. */
batten_status bat_middle_make(const bat_plate *plate,
                              const batten_surface_developable_options *options, bat_middle *m);
void bat_middle_release(bat_middle *m);

/* The surface along the path with its rulings. */
batten_status bat_plate_surface(bat_plate *plate,
                                const batten_surface_developable_options *options,
                                batten_developable *out);
/* Warp and edge of regression of `out->surface`. */
batten_status bat_plate_measure(const batten_surface_developable_options *options,
                                batten_developable *out);

#endif
