/* The search for common knots: what its parts share. */
#ifndef BAT_COMMON_KNOTS_PARTS_H
#define BAT_COMMON_KNOTS_PARTS_H
#include "numeric/vector.h"
#include "shape/skin/common_knots.h"
#include "spline/curve/curve.h"

/* Knots that all sections are to have, `inner` of them inside (0, 1). */
typedef struct {
    int inner, capacity;
    double *knots; /* [capacity] rising, p times where a corner is */
    bool *held;    /* [capacity] that of a corner: it stays */
} bat_comb;

typedef struct {
    int count, degree, dimension;
    size_t width;
    bool rational;
    bool periodic;  /* each curve: so are the fitted ones */
    bool symmetric; /* each curve about its middle: so are its knots then */
    double tolerance;
    const bat_common_request *request;
    bat_spline *given;  /* [count] homogeneous rows over [0, 1] */
    bat_spline *fitted; /* [count] upon the comb */
    double *deviation;  /* [count] */
    double *error;      /* [capacity + 1] largest of all sections in each span of the comb */
    int limit;          /* inner knots of all sections together: more are not worth it */
    bat_work *work;
} bat_fitting;

/* ---- the sections over [0, 1] (common_knots_sections.c) ---- */

/* Fills in dimension, width, degree, kind and `given`. */
batten_status bat_common_take(bat_fitting *f, const batten_curve *const *sections);
/* BAD_ARGUMENT when the tolerance is lost in the rounding of the coordinates. */
batten_status bat_common_check_tolerance(const bat_fitting *f);

/* ---- combs (common_knots_comb.c) ---- */

batten_status bat_comb_make(int capacity, bat_comb *c);
void bat_comb_free(bat_comb *c);
void bat_comb_insert(bat_comb *c, double u, bool held);
void bat_comb_remove(bat_comb *c, int at);
void bat_comb_copy(const bat_comb *from, bat_comb *to);
/* The whole knot vector [inner + 2 p + 2]. */
void bat_comb_write(const bat_comb *c, int p, double *U);
/* What was asked for, and what a seam needs; false when it is too much. */
bool bat_comb_hold(const bat_fitting *f, bat_comb *c);
/* The corners of all curves; false when they are too many. */
bool bat_comb_corners(const bat_fitting *f, bat_comb *c);
/* `wanted` knots, each the average of those at its place. */
void bat_comb_average(const bat_fitting *f, int wanted, bat_comb *c);

bool bat_common_symmetry(const bat_fitting *f);
/* Make knots that are nearly symmetric about 1/2 exactly so; those of corners stay. */
void bat_comb_mirror(bat_comb *c);

/* ---- one curve upon a comb (common_knots_fit.c) ---- */

/* Least squares with the ends held; of a periodic curve without. */
batten_status bat_common_fit(const bat_fitting *f, int k, const bat_comb *c, bat_spline *out);
/* The same of a periodic curve, cut at its seam, so that both kinds are compared in one way;
 * and as the periodic curve that it is (common_knots_ring.c). */
batten_status bat_common_ring_fit(const bat_fitting *f, int k, const bat_comb *c,
                                  bat_spline *out);
batten_status bat_common_ring_curve(const bat_fitting *f, int k, const bat_comb *c,
                                    batten_curve **out);
/* Bounds on the distance at equal parameters: in each span of the comb (`error` grows, may be
 * NULL), and of the whole. */
batten_status bat_common_deviation(const bat_fitting *f, const bat_spline *given,
                                   const bat_spline *fit, double *error, double *deviation);

#endif
