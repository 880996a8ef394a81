/*
 * The true sweep: a section, or a row of them, carried by a motion. What the NURBS surfaces
 * near it are measured against.
 */
#ifndef BAT_SWEEP_TRUTH_H
#define BAT_SWEEP_TRUTH_H
#include "base/work.h"
#include "shape/sweep/motion.h"
#include "spline/surface/surface.h"

typedef struct {
    bat_motion *motion;    /* owned */
    batten_curve *section; /* in space; owned; of a row of sections NULL */
    batten_surface *row;   /* those in space, blended: v is the share of the way; or NULL */
    batten_interval part;  /* of the motion's domain */
} bat_sweep;

void bat_sweep_release(bat_sweep *sweep);

/* The section at a share of the path: a new curve or one more reference. */
batten_status bat_sweep_section_at(const bat_sweep *sweep, double share, batten_curve **out);

/* Control points of the section at v, where it stands: [count][width]; width 3, or 4 and
 * homogeneous where weights change with v. */
int bat_sweep_count(const bat_sweep *sweep);
size_t bat_sweep_width(const bat_sweep *sweep);
batten_status bat_sweep_rows(const bat_sweep *sweep, double v, batten_side side, double *rows);

/* As batten_surface_evaluate_side, order <= 3. */
batten_status bat_sweep_evaluate(const bat_sweep *sweep, const bat_surface_place *at, int order,
                                 double *out);

/* The surface of kind "sweep"; on success `sweep` belongs to it. */
batten_status bat_sweep_surface(bat_sweep *sweep, batten_surface **out);

/*
 * The NURBS surface near it: sections are added until none between them is farther from the
 * truth than `tolerance`, measured as the distance of control points, a bound for the section.
 * @param report  error and section_count are filled in
 */
batten_status bat_sweep_fit(const bat_sweep *sweep, int degree, double tolerance,
                            bat_work *work, batten_surface_sweep_report *report,
                            batten_surface **out);

#endif
