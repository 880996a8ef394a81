/* One direction of a smooth fit, in the basis in which data and penalty are diagonal. */
#ifndef BAT_GRID_MODES_H
#define BAT_GRID_MODES_H
#include "shape/near/approximate.h"

/* basis T [n][n]: row i the control values of mode i; T G T^t = 1, T R T^t = diag(penalty). */
typedef struct {
    int n;
    double *penalty, *basis;
} bat_modes;

/* Of a fit with its penalty; `unseen` functions have none. SINGULAR_SYSTEM when the data do not
 * determine all. */
batten_status bat_modes_make(const bat_fit *fit, int unseen, bat_modes *out);
void bat_modes_free(bat_modes *modes);

#endif
