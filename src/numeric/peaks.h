/* The largest values of quantities along a line, between samples too. */
#ifndef BAT_PEAKS_H
#define BAT_PEAKS_H
#include "base/base.h"

enum { BAT_PEAKS_MOST = 3 };

/* The quantities [count] at t in [0, 1]; infinite or NaN where one has no bound or no meaning. */
typedef batten_status (*bat_quantities)(void *context, double t, double *values);

/* The largest value of each of `count` quantities, at most BAT_PEAKS_MOST: of even samples, at least 3, and of a golden
 * section around each of them that stands above its neighbours, to a millionth of the step. What rises and falls
 * between two samples is not seen. NaN where one was.
 * @param[out] largest  [count] */
batten_status bat_find_peaks(bat_quantities look, void *context, int samples, int count,
                             double *largest);

#endif
