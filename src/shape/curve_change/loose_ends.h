/* Which ends of curves meet which. */
#ifndef BAT_LOOSE_ENDS_H
#define BAT_LOOSE_ENDS_H
#include "base/base.h"

#include <batten/extend.h>

/* End 2 i is where curve i starts, 2 i + 1 where it ends. */
typedef struct {
    int count;       /* of curves */
    double (*at)[3]; /* [2 count], the places of ends */
    double *length;  /* [count], of control polygons */
    int *partner;    /* [2 count], the end that meets this one; -1 for none */
    int *several;    /* [2 count], how many others lie within the tolerance */
} bat_loose_ends;

/* Release it with bat_loose_ends_release, also after a failure. */
batten_status bat_loose_ends_link(const batten_curve_row *curves, double tolerance,
                                  bat_loose_ends *ends);
void bat_loose_ends_release(bat_loose_ends *ends);

#endif
