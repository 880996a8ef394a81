/* Double points of one span in a census, and how what is special is noted. */
#ifndef BAT_INSPECT_AFFINE_CENSUS_DOUBLE_H
#define BAT_INSPECT_AFFINE_CENSUS_DOUBLE_H
#include "inspect/affine/exact_span.h"
#include <batten/invariants.h>

typedef struct {
    int dimension, degree;
    const double *points;
    batten_census census;
    int room;
} bat_census_finding;

/* Products of limbs, about 0.2 seconds: for the inflections, and as many for the elimination.
 */
enum { BAT_CENSUS_EFFORT = 200000000 };

batten_status bat_census_add(bat_census_finding *f, batten_special special);
/* Elimination has an effort of its own: when that is used up the rest of the census stands.
 * `stops`: how many real parameters there are at which the curve stops. Each is a double point
 * with equal parameters, which checks the elimination. */
batten_status bat_census_find_double(bat_whole_poly x, bat_whole_poly y, int stops,
                                     const double *plane, bat_census_finding *f);

#endif
