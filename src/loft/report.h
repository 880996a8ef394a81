/* What a lofting says of what it made, and of a bound that would do. */
#ifndef BAT_LOFT_REPORT_H
#define BAT_LOFT_REPORT_H
#include "loft/panels.h"

/* Of panels that are made fair. */
batten_status bat_loft_fill_report(const bat_hull_panels *panels,
                                   const batten_offset_table *table, batten_loft_report *out);

/* The corrections of the table, with report->faired, the farthest first. */
batten_status bat_loft_correct(const bat_hull_panels *panels, const batten_offset_table *table,
                               batten_loft_report *report);
/* Is the point at its bound? */
bool bat_loft_holds(const bat_hull_panels *panels, const bat_loft *panel,
                    const bat_loft_datum *datum);

/* Fails with NOT_COMPATIBLE, or with what came between: the message has the least bound that was
 * found to do, and the points which hold the surface there. `enough`: that bound; 0 when none is. */
batten_status bat_loft_find_enough(const batten_offset_table *table,
                                   const batten_loft_options *options, const batten_job *job,
                                   double *enough);

#endif
