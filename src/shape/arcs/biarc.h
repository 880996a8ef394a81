/*
 * Biarcs by the angles between their chord and their directions: what batten_biarc_between, the
 * arc spline and the approximation by arcs share.
 */
#ifndef BAT_BIARC_H
#define BAT_BIARC_H
#include "base/base.h"
#include <batten/arcs.h>
#include <float.h>

/* One arc with its first point, by its chord: `half` is half of its turn, |half| < pi. */
void bat_arc_span(const double start[2], double chord, double direction, double half,
                  batten_span *out);

/* The angle from one direction of the plane to another, (-pi, pi]. */
double bat_turn(const double from[2], const double to[2]);

/* What a biarc spans: from where, which way and how far. */
typedef struct {
    double start[2];
    double angle, length;
} bat_arc_chord;

/* The biarc over a chord. SINGULAR_HERE, OVERFLOW. */
batten_status bat_biarc_make(const bat_arc_chord *chord, double alpha, double beta,
                             double place, batten_biarc *out);

/* Two points that are apart and two directions that are not zero. */
batten_status bat_biarc_check_ends(int dimension, const double *start,
                                   const double *start_direction, const double *end,
                                   const double *end_direction);
/* Points, directions and joints as batten_chain_biarcs_options has them. */
batten_status bat_biarcs_check(int dimension, int count, const double *points,
                               const batten_chain_biarcs_options *options);

/* A direction of length 1. */
void bat_direction(int dimension, const double *from, double *to);

/* Directions of the circles through three neighbours, [count][d] of length 1. SINGULAR_HERE
 * naming the point where the polygon turns back on itself. */
batten_status bat_circle_directions(int dimension, int count, const double *points, bool closed,
                                    double *directions);

#endif
