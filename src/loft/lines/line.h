/* A line of a hull made fair: a function of one parameter in the knots of the patches beside it. */
#ifndef BAT_LOFT_LINE_H
#define BAT_LOFT_LINE_H
#include "loft/lines/line_program.h"

/*
 * f [count]: the function of least change within the bounds, that is with the least sum of the
 * squares of its moves over their bounds and of f''', so weighted that it moves by a quarter of the bound in
 * the mean. A quadratic comes back as it is, and equal values to the last digit. `found`: the inflections
 * that are seen. NOT_COMPATIBLE when the bounds cannot be met.
 */
batten_status bat_loft_line_fair(const bat_loft_line *line, double *f, int *found);

/* A least bound in four digits, rounded up: the bound that is said does, too. */
void bat_loft_say_bound(double bound, size_t room, char *text);

#endif
