/* Which signs a sequence of curvatures is to have. */
#ifndef BAT_SIGN_PATTERN_H
#define BAT_SIGN_PATTERN_H
#include "base/base.h"

/* signs [count] of +1 and -1 with at most `changes` changes, such that the sum of the
 * curvatures of the other sign is least. Cost: count changes. */
batten_status bat_sign_pattern(int count, const double *curvature, int changes, int *signs);

#endif
