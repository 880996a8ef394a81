/* Points and parameters beyond the ends of a row, for methods that look at neighbours. */
#ifndef BAT_PHANTOM_H
#define BAT_PHANTOM_H
#include "base/base.h"
#include <batten/local.h>

/* A row of points with parameters, which continues beyond its ends. */
typedef struct {
    int d, count;
    bool closed;
    batten_phantoms kind;
    int degree; /* of the polynomial that extrapolates, below BATTEN_MAX_DEGREE + 1 */
    const double *points;
    double *t; /* [count], closed [count + 1]; owned */
} bat_row_beyond;

/* How a row is parametrized and continued. */
typedef struct {
    double alpha;        /* 0 to 1: parameters by this power of the chords ... */
    const double *given; /* ... unless these are given: [count], closed [count + 1] */
    bool closed;
    batten_phantoms kind;
    int degree;
} bat_beyond_rule;

/* Checks, and parameters by a power of the chords or as given. Release row->t, after a failure
 * too. */
batten_status bat_row_beyond_make(batten_points points, const bat_beyond_rule *rule,
                                  bat_row_beyond *row);
/* The parameter of point i, and the point, for any i; degrees do not matter to a closed row. */
double bat_parameter_beyond(const bat_row_beyond *row, int i);
void bat_point_beyond(const bat_row_beyond *row, int i, double *out);

#endif
