/*
 * The folded edge in three files: the crease and what is known along it (fold_crease.c), the
 * flat sheet (fold_flat.c), and the sheets in space with the whole (fold.c).
 *
 * The letters are those of the literature: T, N, B and k, tau along the crease, a the angle of
 * a sheet to the osculating plane, b that of a ruling to T, kg the curvature in the flat sheet.
 */
#ifndef BAT_FOLD_PARTS_H
#define BAT_FOLD_PARTS_H
#include "base/base.h"
#include <batten/plate.h>

/* What is known at one place of the crease. */
typedef struct {
    double s, u; /* length from the start, parameter of the curve */
    batten_vec3 X, T, N, B;
    double k, tau, a, a_rate;
} bat_fold_place;

/* One fold on its way. */
typedef struct {
    const batten_curve *crease; /* as given */
    const batten_fold_create_options *options;
    batten_curve *space;   /* the crease in space */
    batten_curve *law;     /* the given values over the length of the crease; degree >= 1 */
    batten_curve *torsion; /* with FLAT; NULL for 0 */
    int count;
    bat_fold_place *at; /* [count] */
    double *b[2];       /* [count] angles of the rulings to T, left and right */
    double *b_rate[2];  /* [count] */
    batten_fold made;
} bat_fold_task;

/* The function through `count` values at equal steps over [0, length]. */
batten_status bat_fold_function(int count, const double *values, double length,
                                batten_curve **out);

/* Value and derivative; a place a few ulps beyond the end counts as the end. */
batten_status bat_fold_value_at(const batten_curve *function, double s, double out[2]);

/* The length of the crease, the laws along it and the crease in space. */
batten_status bat_fold_prepare(bat_fold_task *t);

/* What is known at the length s, where the parameter is u. */
batten_status bat_fold_find_place(const bat_fold_task *t, double s, double u,
                                  bat_fold_place *p);

/* All `count` places, at equal steps of length. */
batten_status bat_fold_find_places(bat_fold_task *t);

/* Crease and rulings of both sheets in the plane; the crease starts at (0, 0) along x. */
batten_status bat_fold_flatten(bat_fold_task *t);

#endif
