/* The parts of offsetting a curve: runs follow the curve, corners go around its outside, and
 * what comes too near is taken away. */
#ifndef BAT_CURVE_OFFSET_H
#define BAT_CURVE_OFFSET_H
#include "base/base.h"
#include "inspect/nearest/self_crossings.h"
#include <batten/offset.h>

/* A smooth part of the offset: a whole curve, that begins where the one before it ends unless
 * there is the inside of a corner between them. */
typedef struct {
    batten_curve *curve; /* of the dimension of `full` */
    batten_curve *plan;  /* its projection */
} bat_offset_run;

typedef struct {
    const batten_curve *full; /* in Bezier form; in space the offset goes across z */
    const batten_curve *plan; /* its projection into the plane */
    double distance;
    batten_curve_offset_options options;
    double size; /* of the largest coordinate of the plan */
    bool closed;
    batten_curve_offset_report report;
    int count, room;
    bat_offset_run *runs;
} bat_offset;

/* Runs of the whole curve, and the corners between them (offset_runs.c). */
batten_status bat_offset_runs(bat_offset *o);
void bat_offset_runs_release(bat_offset *o);
/* Is a curve of the plane straight, and run one way? */
bool bat_plan_is_line(const batten_curve *part);
/* Take a run over, also after a failure. */
batten_status bat_offset_add(bat_offset *o, batten_status status, batten_curve *curve);
/* A corner of the plan, and what the offset leaves and takes up there. */
typedef struct {
    const double *p;     /* the corner */
    const double *t;     /* the tangent before it; at the end of a curve NULL */
    double turn;         /* the angle to the tangent behind */
    const double *q, *r; /* where the offset stops and goes on; r is NULL at an end */
} bat_offset_gap;

/* From q to r around the outside of the corner (offset_corners.c). */
batten_status bat_offset_corner(bat_offset *o, const bat_offset_gap *at);
/* Where runs cross the rest of the rim of all that is nearer than the distance: the offset on
 * the other side and the round caps of the ends. Each is added with the passage of the run in
 * both places (offset_entries.c). */
batten_status bat_offset_entries(const bat_offset *o, bat_crossings *out);
/* What is far enough from the curve, in one curve for each unbroken part
 * (offset_trim.c). */
batten_status bat_offset_trim(bat_offset *o, batten_curves *out);
#endif
