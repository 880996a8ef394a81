/* Parameters that a family of lines of points has in common: the rows or the columns of a grid.
 */
#ifndef BAT_GRID_PARAMETERS_H
#define BAT_GRID_PARAMETERS_H
#include "base/base.h"
#include <batten/interpolate.h>

/* A family of lines of points that have their parameters in common: the rows of a grid. */
typedef struct {
    const char *name;             /* of what crosses them, for messages: "u grid lines" */
    int dimension, count, lines;  /* `lines` of `count` points */
    size_t point_step, line_step; /* in numbers */
    bool periodic;
    const double *points, *given;
} bat_family;

/* Parameters 0 .. 1, the average of those of all lines that are not a single point; or those
 * given.
 * @param u  [count], periodic [count + 1], zeros; @param spread  how far a line's own are from
 * them, in steps */
batten_status bat_family_parametrize(const bat_family *family, batten_parametrization kind,
                                     double *u, double *spread);

#endif
