/* What counts as equal where shapes meet. */
#ifndef BAT_CONTINUITY_H
#define BAT_CONTINUITY_H
#include <batten/continuity.h>

/* The options of a caller laid over the defaults; BAD_ARGUMENT for one that is negative or not finite. */
batten_status bat_continuity_bounds(const batten_curve_continuity_options *given,
                                    batten_curve_continuity_options *out);

#endif
