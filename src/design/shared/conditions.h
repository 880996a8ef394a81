/* What a design asks of a curve near points beyond nearness, and which points it left aside. */
#ifndef BAT_DESIGN_CONDITIONS_H
#define BAT_DESIGN_CONDITIONS_H
#include "design/shared/near.h"

/* 'pass', 'start-direction', 'end-direction', 'over', 'under', 'shape', 'side' and 'within' as
 * options; release *conditions. */
batten_status bat_conditions_of(const bat_run *run, const bat_data *data,
                                batten_curve_least_squares_options *options,
                                batten_condition **conditions);

/* Say which points are farther than five times the median distance from the curve made. */
batten_status bat_note_outliers(bat_run *run, const bat_data *data, const double *weights,
                                const bat_made *made);

#endif
