/* Points and parameters beyond the ends of a row, for methods that look at neighbours. */
#ifndef BAT_PHANTOM_H
#define BAT_PHANTOM_H
#include "base/base.h"
#include <batten/local.h>

/* A row of points with parameters, which goes on beyond its ends. */
typedef struct {
    int d, count;
    bool closed;
    batten_phantoms kind;
    int degree; /* of the polynomial that extrapolates, below BATTEN_MAX_DEGREE + 1 */
    const double *points;
    double *t; /* [count], closed [count + 1]; owned */
} bat_row_beyond;

/* Checks, and parameters by a power of the chords or as given. Release row->t, after a failure
 * too. */
batten_status bat_row_beyond_make(int dimension, int count, const double *points, double alpha,
                                  const double *given, bool closed, batten_phantoms kind,
                                  int degree, bat_row_beyond *row);
/* The parameter of point i, and the point, for any i; degrees do not matter to a closed row. */
double bat_parameter_beyond(const bat_row_beyond *row, int i);
void bat_point_beyond(const bat_row_beyond *row, int i, double *out);

#endif
