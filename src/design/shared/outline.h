/* Curves that become one, piece by piece. */
#ifndef BAT_OUTLINE_H
#define BAT_OUTLINE_H
#include "base/base.h"
#include <batten/curve.h>

/* Join a piece to the end of *outline, which is NULL before the first one. The piece is given
 * back in any case; with a status other than BATTEN_OK nothing else happens. */
batten_status bat_outline_add(batten_status status, double tolerance, batten_curve *piece,
                              batten_curve **outline);

#endif
