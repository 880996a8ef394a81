/* The lines along which a hull is cut into panels: the profile, the knuckles and the sheer. */
#ifndef BAT_LOFT_RAILS_H
#define BAT_LOFT_RAILS_H
#include "loft/hull.h"
#include "loft/lines/line_program.h"
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
    bat_loft_line *lines; /* [count][2]: what y and z of a rail were made of */
    bool is_explained;    /* the message says which straight run the bound forbids; */
    double enough;        /* and this is the least bound with which it can be, 0: none was found */
} bat_hull_rails;

/* All of them faired. Release with bat_hull_rails_free, also after a failure. */
batten_status bat_hull_rails_make(const batten_offset_table *table,
                                  const batten_loft_options *options, bat_hull_rails *out);
void bat_hull_rails_free(bat_hull_rails *rails);

/* The point of a rail at a station, as the table gives it. */
static inline const batten_table_point *bat_hull_rail_point(const bat_hull_rails *rails,
                                                            int rail, int station)
{
    return rails->of.stations[station].points +
           rails->at[rail * rails->of.station_count + station];
}

/* Where it is on the rail. */
static inline double bat_hull_rail_u(const bat_hull_rails *rails, int rail, int station)
{
    const double aft = bat_hull_rail_point(rails, rail, 0)->x,
                 fore = bat_hull_rail_point(rails, rail, rails->of.station_count - 1)->x;
    return (bat_hull_rail_point(rails, rail, station)->x - aft) / (fore - aft);
}

/* ---- straight.c ---- */

/* BAD_ARGUMENT, NOT_FOUND when a straight run is on none of the rails. */
batten_status bat_hull_check_runs(const bat_hull_rails *rails,
                                  const batten_loft_options *options);
/* The runs on which a coordinate, 0 for y and 1 for z, of a rail is straight, from its knots, in the
 * arena. BAD_ARGUMENT when two of them make one. */
batten_status bat_hull_find_runs(bat_hull_rails *rails, const batten_loft_options *options,
                                 int rail, int axis, bat_loft_line *line);
/* Is this one of them? Its coefficients. */
bool bat_hull_run_of(const bat_hull_rails *rails, const batten_loft_straight *run, int rail,
                     int axis, const bat_loft_line *line, bat_straight_run *out);
/* What messages call a rail. */
const char *bat_hull_rail_name(const bat_hull_rails *rails, int rail);

/* ---- conflicts.c ---- */

/* For a line that does not keep the bound with all of its straight runs. NOT_COMPATIBLE, with the words and
 * `is_explained` when one of them alone does not, while the line without any does. */
batten_status bat_hull_explain_runs(bat_hull_rails *rails, const batten_loft_options *options,
                                    int rail, int axis, const bat_loft_line *line);

#endif
