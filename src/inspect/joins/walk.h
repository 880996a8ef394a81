/* Along a common edge: how far two shapes are apart, in place and derivatives, and where they are farthest. */
#ifndef BAT_WALK_H
#define BAT_WALK_H
#include "inspect/joins/across.h"
#include <batten/continuity.h>

/* Both shapes at one place of their edge; NaN for what is not known. */
typedef struct {
    double gap, angle, curvature, rate; /* the last two as parts of the larger one */
    double curvature_difference, rate_difference;
    batten_vec3 point;
} bat_meeting;

/* What bulges by less than the gap allowed over the size of the shapes counts as straight. */
typedef struct {
    double curvature, rate;
} bat_straight;

bat_straight bat_straight_within(double gap, double size);

/* Angle, curvatures and rates of two surfaces at one place. */
void bat_meeting_compare(const bat_across *one, const bat_across *other,
                         const bat_straight *straight, bat_meeting *out);

/* An edge in spans, and both shapes at any place of one. */
typedef struct {
    batten_status (*meet)(const void *context, int span, double t, bat_meeting *out);
    const void *context;
    int spans;
    const double *breaks; /* [spans + 1] */
} bat_edge_walk;

/* The largest of everything, of 9 places of every span and of 33 at least; what is more than a thousandth of its bound
 * is followed to its greatest between the places. Ends at the first gap beyond the bound. `out` gets worsts and
 * the highest G^k, or -1 for a gap. */
batten_status bat_follow_edge(const bat_edge_walk *walk,
                              const batten_curve_continuity_options *bounds, batten_join *out);

#endif
