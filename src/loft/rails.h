/* The lines along which a hull is cut into panels: the profile, the knuckles and the sheer. */
#ifndef BAT_LOFT_RAILS_H
#define BAT_LOFT_RAILS_H
#include "loft/hull.h"
#include <batten/fair.h>

typedef struct {
    bat_hull_table
        of;    /* its stations from the lower edge to the upper; girths are not measured */
    int count; /* rails, from below: one more than panels */
    int *line; /* [count]: of the table; -1 for an edge that is not named */
    int *at;   /* [count][stations]: which point of the station, from below */
    int inner_count;
    double *inner;        /* knots along u that all have */
    bat_hull_rail *rails; /* [count] */
} bat_hull_rails;

/* All of them faired. Release with bat_hull_rails_free, also after a failure. */
batten_status bat_hull_rails_make(const batten_offset_table *table,
                                  const batten_loft_options *options, bat_hull_rails *out);
void bat_hull_rails_free(bat_hull_rails *rails);

/* The point of a rail at a station, as the table gives it. */
const batten_table_point *bat_hull_rail_point(const bat_hull_rails *rails, int rail,
                                              int station);

#endif
