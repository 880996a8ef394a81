/* Grids of points with gaps. */
#ifndef BAT_GAPS_H
#define BAT_GAPS_H
#include "base/base.h"

typedef struct {
    int dimension, count[2];
    bool periodic[2];
    const double *parameters[2]; /* [count], periodic [count + 1]; NULL: even */
    const bool *missing;         /* [count u][count v] */
    double *points;              /* [count u][count v][d]; what is missing is filled */
} bat_gaps;

/* Fill what is missing so that second differences over the grid are least. TOO_LARGE,
 * SINGULAR_SYSTEM when what is there does not determine it. */
batten_status bat_gaps_fill(const bat_gaps *gaps);

#endif
