/* The faired table: what the surfaces of a lofting have in place of the points of its table. */
#ifndef BAT_LOFT_FAIRED_H
#define BAT_LOFT_FAIRED_H
#include "loft/panels.h"

/* The place of the patch to which a point of the table belongs, and how far it is off the planes
 * that should meet there: on an edge where it meets the plane of the station, of a point on a
 * waterline where that meets it; else, and where they do not meet, the nearest point. `waterline`
 * is NULL for a point on none. */
double bat_loft_read_off(const bat_loft_patch *patch, const bat_loft_datum *datum,
                         const batten_table_line *waterline, double out[3]);

/* The table of the panels, with the points that are not theirs as they were. `error`: the most that
 * a point is off the planes. Release with batten_offset_table_unref. */
batten_status bat_loft_faired_table(const bat_hull_panels *panels,
                                    const batten_offset_table *table, batten_offset_table **out,
                                    double *error);

#endif
