/* Where integrals over rows of a patch, as functions of the row, are not smooth. */
#ifndef BAT_HYDROSTATICS_KINKS_H
#define BAT_HYDROSTATICS_KINKS_H
#include "hydrostatics/hull.h"

/* At most this many turns of the waterline are kept for one patch. */
enum { BAT_MOST_TURNS = 40, BAT_MOST_KINKS = 2 * BATTEN_MAX_DEGREE + BAT_MOST_TURNS + 2 };

/* Parameters of rows, rising, with 0 and 1: where the waterline meets an end of the rows, and
 * where rows begin or cease to cross it inside the patch. */
batten_status bat_find_kinks(const bat_patch *patch, batten_direction constant,
                             const bat_water *water, double kinks[BAT_MOST_KINKS], int *count);

/* Kinks to the last digit where the number of crossings changes, which turns are found to 1e-9 without; those
 * that are nearer to each other become one. */
batten_status bat_sharpen_kinks(const bat_patch *patch, batten_direction constant,
                                const bat_water *water, double kinks[BAT_MOST_KINKS],
                                int *count);

#endif
