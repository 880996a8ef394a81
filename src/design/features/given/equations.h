/* What the features share that are given by equations. */
#ifndef BAT_DESIGN_EQUATIONS_H
#define BAT_DESIGN_EQUATIONS_H
#include "design/feature.h"

#include <batten/contours.h>

#define BAT_EQUATION_WITHIN                                                                   \
    {                                                                                         \
        "within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,                              \
            "how near to the equations it is, proved; the tolerance of the design by default" \
    }

/* What follows about numbers in the text of each. */
#define BAT_EQUATION_TEXT                                                                         \
    "Numbers count in the unit of the design and in radians; parameters of the design may be\n"   \
    "named. + - * / ^ ( ), pi, sin cos tan asin acos atan sinh cosh tanh exp ln log10 sqrt abs\n" \
    "min max; put a text with a comma in quotes.\n"

/* Read a text in these variables; the parameters of the design are constants. */
batten_status bat_equation(const bat_run *run, const char *text, int variable_count,
                           const char *const *variables, batten_equation **out);
double bat_equation_within(const bat_run *run);
/* The range of a parameter that the equations need. */
batten_status bat_equation_range(const bat_run *run, const char *parameter,
                                 batten_interval *out);

/* The curve of expressions of one variable, or the surface of three expressions of two, put into the model. */
batten_status bat_put_equation_curve(bat_run *run, int dimension, batten_equation *const *read,
                                     batten_interval range);
batten_status bat_put_equation_surface(bat_run *run, batten_equation *const read[3],
                                       const batten_interval range[2]);
/* Remarks about special points, a few by place and the rest by number. */
void bat_remark_points(const bat_run *run, const batten_equation_curves *curves);

#endif
