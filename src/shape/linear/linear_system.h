/*
 * The one mechanism under interpolation: a linear operator that turns data at parameters into
 * the control values of a spline. Curves give it rows of d numbers; a grid gives it whole lines
 * of points, along u and then along v; a skin gives it the control points of its sections.
 */
#ifndef BAT_LINEAR_SYSTEM_H
#define BAT_LINEAR_SYSTEM_H
#include "numeric/banded.h"
#include <batten/interpolate.h>

/* What is asked of the spline: its value at each parameter, and more. */
typedef struct {
    int degree;
    int count;                /* data */
    const double *parameters; /* [count], increasing; periodic [count + 1] */
    bool knots_at_data, periodic;
    batten_end_kind start, end; /* with knots at the data; those that are linear: not CIRCLE,
                                   CURVATURE, DIRECTION */
    int condition_count;        /* derivatives at data points */
    const batten_derivative *conditions;
} bat_request;

/* Where the right side of an equation comes from; else it is the number of a condition. */
enum {
    BAT_FROM_DATA = -1,
    BAT_FROM_START = -2,
    BAT_FROM_END = -3,
    BAT_FROM_BESSEL_START = -4,
    BAT_FROM_BESSEL_END = -5,
    BAT_FROM_ZERO = -6
};

/* One row of the equations: a derivative of the spline at a data point. */
typedef struct {
    int index, order;
    int source;
} bat_row;

typedef struct {
    int degree, data_count;
    int count; /* control values; periodic: of one period */
    bool periodic;
    double *knots;  /* [count + degree + 1]; periodic [count + 1] */
    double step[4]; /* the first two steps of the parameters and the last two, for Bessel's
                       slopes */
    bat_row *rows;  /* [count] */
    int lower, upper;
    double *matrix, *factor; /* bands; when periodic `cyclic` instead of `factor` */
    bat_cyclic *cyclic;
    /* Ends that are FAIR: their rows, the control values for a unit slope there and zeros else,
     * the gradient of the sum of squared jumps of the third derivative along these, and their
     * Gram matrix. */
    int fair_count;
    int fair_row[2];
    double *response, *gradient; /* [fair_count][count] */
    double gram[2][2];
} bat_operator;

batten_status bat_operator_make(const bat_request *request, bat_operator *out);
void bat_operator_free(bat_operator *op);

#endif
