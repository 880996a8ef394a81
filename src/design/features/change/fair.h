/* What the files of the feature 'fair' share. */
#ifndef BAT_FEATURE_FAIR_H
#define BAT_FEATURE_FAIR_H
#include "design/shared/rows.h"
#include <batten/fair.h>

/* The methods of points come first among the words, those of control points follow. */
enum { BAT_METHODS_OF_POINTS = BATTEN_FAIR_LEAST_CHANGE + 1 };

/* Put the report of curve `set`, of so many points, to those before; `rms_move` holds the sum of squares until the end. */
batten_status bat_fair_add_report(batten_fair_report *sum, const batten_fair_report *one,
                                  int set, int point_count);
/* Moves of a curve in a plane, in space. */
void bat_fair_lift_moves(int axis, double height, batten_fair_move *moves, int count);

/* A curve whose control points are moved, put into the result of the feature. */
batten_status bat_fair_control_points(bat_run *run, const batten_object *object, int set);

#endif
