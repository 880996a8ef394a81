/* Curves of which the first and the last may be a point: a tip. */
#ifndef BAT_DESIGN_TIPS_H
#define BAT_DESIGN_TIPS_H
#include "design/feature.h"

typedef struct {
    const batten_curve **curves; /* as many as there are objects */
    batten_curve *tips[2];       /* those made for points at the start and the end; owned */
} bat_tipped;

/* The curves of gathered curves and points; a point stands still over [0, 1]. Several points, and a point between
 * curves, are refused by name. Release it after a failure too. */
batten_status bat_take_tipped(const bat_objects *all, bat_tipped *out);
void bat_tipped_release(bat_tipped *tipped);

#endif
