/* Cubics along the pieces of an implicit curve, as few as are proved to be near enough. */
#ifndef BAT_EQUATION_FIT_H
#define BAT_EQUATION_FIT_H
#include "shape/equation/system.h"

#include <batten/curve.h>

/* From one point of the curve to the next, with unit tangents in the direction of travel. */
typedef struct {
    double from[BAT_SPACE], to[BAT_SPACE];
    double leave[BAT_SPACE], arrive[BAT_SPACE];
    bat_cell cell; /* in which it is the only piece over its part of axis `graph` */
    int graph;
    bool is_link;    /* through a singular cluster: drawn as it is, nothing to prove */
    bool is_line;    /* of a link: straight */
    bool has_corner; /* a line no longer than the tolerance, where there is no derivative */
} bat_segment;

typedef struct {
    bat_segment *items;
    int count, room;
} bat_segments;

/* Divide and join the segments of one branch until each is one cubic within the tolerance.
 * @param[in,out] error  the largest proved so far
 * TOLERANCE_NOT_MET, OUT_OF_MEMORY */
batten_status bat_segments_fit(bat_system *system, double tolerance, bat_segments *branch,
                               double *error);

/* How far the points of an open branch are apart; infinity for a closed one. */
double bat_segments_extent(const bat_system *system, const bat_segments *branch);

/* The cubics as one curve, C1 but for lines and where tangents differ. */
batten_status bat_segments_curve(int dimension, const bat_segments *branch, batten_curve **out);

/* The part of its cell in which the curve between its points lies. */
void bat_segment_tighten(bat_system *system, bat_segment *segment);

/* The tangent at a point in the direction in which coordinate `graph` grows, times `sense`. */
void bat_segment_tangent(bat_system *system, const double *point, int graph, double sense,
                         double *out);

#endif
