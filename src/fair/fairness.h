/* The numbers behind the word "fair". */
#ifndef BAT_CRITERIA_H
#define BAT_CRITERIA_H
#include "fair/elastic_batten.h"

/*
 * The fewest inflections of any curve that passes every point within its bound: the least
 * number of changes between pieces that turn left only and pieces that turn right only. In the
 * plane; of a function (width 1) over t; in space 0. `within` NULL: the bounds are roundoff,
 * and what is counted are the sign changes of the circle rate. Cost: count log(count).
 */
batten_status bat_required_inflections(int width, int count, const double *t,
                                       const double *points, const double *within, int *out);

/* What joints are measured by: the bounds of the options, the largest curvature of the whole,
 * and what rounding alone may make of the direction and of the curvature on both sides. */
typedef struct {
    double angle, curvature, largest, direction_noise, curvature_noise;
} bat_joint_scale;

/* Add a joint: the square of the jump of the derivative of the curvature vector by arc length,
 * across the tangent (of a function of the third derivative), and whether it is a corner or a
 * jump of curvature. From the point and three derivatives [4][d] on both sides. */
void bat_add_joint(int d, const double *before, const double *after,
                   const bat_joint_scale *scale, batten_fairness *out);
/* After all else: energy and variation are infinite where joints make them so; the verdict. */
void bat_conclude_fairness(batten_fairness *out);

/* The same with one bound of all points; 0: roundoff. */
batten_status bat_required_within(int width, int count, const double *t, const double *points,
                                  double within, int *required);
/* A curve that is judged. */
typedef struct {
    const batten_curve *curve;
    const batten_fairness_options *options;
    double size;
    batten_parameters knots, halts, extrema;
    bool is_endless; /* a corner or cusp where it stands still has curvature without bound */
    batten_fairness found;
} bat_judged_curve;

/* Count the joints between the spans of a curve, and the places at which it stands still. */
batten_status bat_judge_joints(bat_judged_curve *j);

batten_status bat_fairness_take_options(const batten_fairness_options *options,
                                        batten_fairness_options *chosen);

/* Curvatures along a curve, walked through in order. Begins with {.from = the first}. */
typedef struct {
    int sign, direction; /* of the last curvature that was not 0, of the last change */
    double from;         /* the curvature from which changes are measured */
    int inflections, extrema;
} bat_scan;
/* Changes of up to `flat` and curvatures up to `zero` count as 0. */
void bat_scan_walk(int count, const double *curvature, double zero, double flat,
                   bat_scan *scan);

/* Points [count][width] with a bound each, and where a batten passes them. */
typedef struct {
    int width;
    const double *points, *within, *z;
} bat_batten_points;

/* Of a batten through z; required is what the points within their bounds require. */
batten_status bat_batten_fairness(const bat_batten *batten, const bat_batten_points *ducks,
                                  batten_fairness *out);
/* Its verdict alone, without integrals. */
batten_status bat_batten_is_fair(const bat_batten *batten, const bat_batten_points *ducks,
                                 bool *out);

#endif
