/* The fewest arcs that are tangent to one another, within a band along a curve. */
#ifndef BAT_ARCS_SMOOTH_H
#define BAT_ARCS_SMOOTH_H
#include "base/work.h"
#include "shape/arcs/path.h"

/* A piece of the curve from corner to corner, or a closed curve without corners. */
typedef struct {
    const bat_arcs_path *path;
    double from, to;
    bat_band band;
    double slack; /* what rounding does to a distance */
    double least_radius;
    const bat_arcs_list *guide; /* plain arcs within the band: how long arcs are where */
    int enough; /* of a closed curve: a number of arcs that is no longer to be lowered; or 0 */
    bat_samples *samples; /* room for them */
    bat_work *work;
} bat_arcs_smooth;

/* Adds the arcs to the list; none when the search found none, or there would be
 * more than 10,000. The last part of a closed curve
 * is a biarc, and the first may begin anywhere: then one part continues beyond its end. */
batten_status bat_arcs_smooth_run(const bat_arcs_smooth *task, bat_arcs_list *list);

#endif
