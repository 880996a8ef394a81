/* What the distances from curves and from surfaces share. */
#ifndef BAT_NEAREST_H
#define BAT_NEAREST_H
#include "base/base.h"
#include <batten/nearest.h>

typedef struct {
    double distance, at[2];
} bat_nearest;

batten_status bat_deviation_check(int dimension, int count, const double *points,
                                  const double *start, int start_width);
batten_status bat_deviation_finish(int count, const bat_nearest *nearest, double *distances,
                                   batten_deviation *out);

#endif
