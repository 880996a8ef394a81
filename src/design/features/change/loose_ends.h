/* Curves in any order and direction, as they run end to end. */
#ifndef BAT_LOOSE_ENDS_H
#define BAT_LOOSE_ENDS_H
#include "design/feature.h"

typedef struct {
    int chains, closed; /* curves that they make, and how many of these end where they begin */
    int branches;       /* ends where more than one other curve goes on: the nearest is taken */
    double gap;         /* the largest that was closed */
} bat_loose_report;

/* Joined where ends lie within `within` of each other, the nearest first; the ends meet halfway. Release *out with
 * batten_curves_release. Cost: quadratic in the number of curves. */
batten_status bat_join_loose(const bat_objects *all, double within, batten_curves *out,
                             bat_loose_report *report);

#endif
