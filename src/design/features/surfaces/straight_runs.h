/* Straight runs of the lines of a hull, as a design states them: "chine from stem to 2 in profile". */
#ifndef BAT_STRAIGHT_RUNS_H
#define BAT_STRAIGHT_RUNS_H
#include "base/arena.h"
#include "design/feature.h"

#include <batten/fair.h>

/* The runs of the argument 'straight', with its stations found in the table by their names, in
 * either order; in the arena. */
batten_status bat_take_straight_runs(const bat_run *run, const batten_offset_table *table,
                                     bat_arena *arena, batten_loft_options *options);

#endif
