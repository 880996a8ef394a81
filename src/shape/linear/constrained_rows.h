/* The rows of a constrained spline: points, directions, means, and inequalities over intervals. */
#ifndef BAT_LINEAR_CONSTRAINED_ROWS_H
#define BAT_LINEAR_CONSTRAINED_ROWS_H
#include <batten/interpolate.h>

typedef struct {
    const batten_curve_constrained_options *options;
    int d, count, degree;
    const double *points;
    double *u;     /* [count] */
    double *knots; /* [control_count + degree + 1] */
    int control_count, unknowns;
    double *hessian, *linear, *x;
    /* Rows [unknowns] of equations and inequalities, their values, and whose they are: a
     * constraint, or -1 - i of point i. */
    double *equal, *equal_values, *least, *least_values;
    int *equal_of, *least_of;
    int equal_count, least_count;
} bat_constrained_fit;

/* Gauss is exact for the squares of the derivatives. */
void bat_constrained_energy(bat_constrained_fit *t);
/* Basis functions of the derivative of an order at u; their first index. */
int bat_constrained_basis(const bat_constrained_fit *t, double u, int order, double *out);
void bat_constrained_points(bat_constrained_fit *t);
batten_status bat_constrained_add(bat_constrained_fit *t);

#endif
