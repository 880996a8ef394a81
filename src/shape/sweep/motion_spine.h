/*
 * The parts of motions along a spine: how they are kept, bare frames, laws.
 */
#ifndef BAT_MOTION_SPINE_H
#define BAT_MOTION_SPINE_H
#include "numeric/jet3.h"
#include "shape/sweep/motion.h"

enum { BAT_SPINE_STEPS = 64 }; /* nodes of a span */

/* A smooth part of the spine. */
typedef struct {
    int first, last;    /* its nodes */
    double shear[2][2]; /* at start and end: how far X and Y lean along the tangent */
} bat_spine_run;

typedef struct {
    bat_motion base;
    batten_curve *spine, *guide, *laws[3]; /* scale of x, of y, twist; may be NULL */
    batten_frame_kind kind;
    bool has_up;
    batten_vec3 up;
    batten_vec3 fixed[2]; /* X and Z of fixed frames */
    int node_count, run_count;
    double *u, *length; /* of the nodes; lengths from the start */
    batten_vec3 *x;     /* the axis that turns least, at the nodes */
    bat_spine_run *runs;
    double total, turn; /* the length; what closing frames are turned by in all */
} bat_spine_motion;

/* The frame without laws; of fixed frames z is that of the start. */
typedef struct {
    bat_jet3 point, x, y, z, tangent;
    bat_jet speed;
} bat_bare_frame;

/* SINGULAR_HERE without a tangent. */
batten_status bat_spine_tangent(const bat_spine_motion *m, double u, batten_side side,
                                batten_vec3 *point, batten_vec3 *tangent);
batten_status bat_spine_length(const bat_spine_motion *m, double a, double b, double *length);
/* @param node  at or before u, in its run */
batten_status bat_spine_frame(const bat_spine_motion *m, int node, double u, batten_side side,
                              bat_bare_frame *f);
batten_status bat_spine_pose(const bat_motion *motion, double v, batten_side side,
                             bat_pose *out);
/* How a share of the way grows: `length` of `whole`. */
bat_jet bat_share(double length, const bat_jet *speed, double whole);
/* Turn and scale the frame after the laws (motion_spine_laws.c). */
batten_status bat_spine_turn(const bat_spine_motion *m, const bat_jet *share, batten_side side,
                             bat_bare_frame *f);
batten_status bat_spine_scale(const bat_spine_motion *m, const bat_jet *share, batten_side side,
                              bat_bare_frame *f);
/* BAD_ARGUMENT with the place where a law is least, unless it is above 0 all along. */
batten_status bat_spine_check_scale(const batten_curve *law, const char *name);
/* At corners sections lean so that they lie in the plane halfway; between, less and less. */
void bat_spine_lean(const bat_spine_motion *m, const bat_spine_run *r, double length,
                    bat_bare_frame *f);

/* ---- motion_spine_nodes.c ---- */

/* Lay the nodes of all spans. A new run, with a node of its own, begins at every corner;
 * NOT_COMPATIBLE where corners are refused, SINGULAR_HERE where the spine turns back. */
batten_status bat_spine_lay_nodes(bat_spine_motion *m, int knot_count, const double *knots,
                                  batten_corner_kind corners);
/* Their lengths. */
batten_status bat_spine_measure(bat_spine_motion *m);
/* The axes at the nodes; the first looks along `wanted`, as far as it can, unless that is 0. */
batten_status bat_spine_frame_runs(bat_spine_motion *m, batten_vec3 wanted);

/* ---- motion_spine_corners.c ---- */

/* What is left of v across the unit vector t, of length one; 0 when nothing is. */
batten_vec3 bat_unit_across(batten_vec3 v, batten_vec3 t);
/* The axis x turned with the least turn that brings the tangent a to b. */
batten_vec3 bat_turn_least(batten_vec3 x, batten_vec3 a, batten_vec3 b);
/* The angle about t from x to y. */
double bat_angle_about(batten_vec3 t, batten_vec3 x, batten_vec3 y);
/* Find `turn` of closing frames; NOT_COMPATIBLE for an open spine. */
batten_status bat_spine_close(bat_spine_motion *m);
/* Find how sections lean at corners, and at a seam that is one. */
batten_status bat_spine_mitre(bat_spine_motion *m);

#endif
