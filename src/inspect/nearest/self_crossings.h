/* Where plane curves of one chain cross each other and themselves. */
#ifndef BAT_SELF_CROSSINGS_H
#define BAT_SELF_CROSSINGS_H
#include "base/base.h"
#include <batten/curvature.h>

/* Two passes through one point: curve and parameter of each, the earlier one first. */
typedef struct {
    int curve[2];
    double u[2];
} bat_crossing;

typedef struct {
    int count, room;
    bat_crossing *at;
} bat_crossings;

/*
 * All crossings among plane curves that follow each other: where the end of one is the start of
 * the next (or, `closed`, the last one's of the first), that is none. Curves are cut into
 * pieces that run one way along their chord and so cannot cross themselves; pairs whose boxes
 * meet are halved until they cross once or not at all. Places where pieces run along each other
 * or touch without crossing may be left out.
 *
 * Release `at` with bat_release. Cost: n log n for n pieces that do not lie over each other.
 */
batten_status bat_crossings_find(int count, const batten_curve *const *curves, bool closed,
                                 bat_crossings *out);

#endif
