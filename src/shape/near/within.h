/*
 * The one mechanism under curves within a tolerance, of points or of another curve: knots are
 * inserted, or are there, until the curve is near enough, and then taken away.
 */
#ifndef BAT_WITHIN_H
#define BAT_WITHIN_H
#include "base/work.h"
#include "shape/near/approximate.h"
#include <batten/approximate.h>

/* One piece without corners. */
typedef struct bat_within {
    int dimension, degree;
    bool periodic;
    int corrections;
    double tolerance;
    batten_interval domain; /* of the knots: holds all parameters; of a ring one period */
    int count;              /* data */
    const double *points, *weights;
    const double *start; /* [count], periodic [count + 1]: where parameters begin; with `sample`
                            those that it took */
    double *parameters;  /* [count + 1] those from which the next fit begins */
    /* Take new data for these knots, when the data can be had anywhere; else NULL. */
    batten_status (*sample)(struct bat_within *work, int inner_count, const double *inner);
    /* How far the curve is at each datum, or about it, and the largest of them. */
    batten_status (*measure)(struct bat_within *work, const batten_curve *curve,
                             const double *parameters, double *distances, double *max);
    void *context;
    const double *
        bows; /* of points: how far the curve may be from each side of their polygon; NULL: the polygon
                           is not looked at */
    int break_count; /* places where a new knot rather stands than beside them */
    const double *breaks;
    double
        swing; /* by how much more than it should the curve may leave the polygon of the data:
                  0, until only a curve through all of them is near enough and does so */
    /* The best so far, and the parameters on it [count + 1], not with `sample`; its distance is
     * infinite when there is none. */
    batten_curve *curve;
    double *best;
    double error;
    int fits;
    bat_work *work; /* asked after each fit; NULL: nobody is */
    double done[2]; /* of all data, before this piece and with it */
} bat_within;

/* Knots inserted, then taken away; where data are too few for that, or by the second, all there
 * and then taken away. The best stays in work->curve even when it is not near enough. */
batten_status bat_within_insert(bat_within *work);
batten_status bat_within_remove(bat_within *work);
void bat_within_end(bat_within *work); /* the curve; arrays are the caller's */

/* Pieces of one degree, clamped, each beginning where and when the one before ends, as one
 * curve: knots between pieces stand degree times. */
batten_status bat_curve_chained(int count, batten_curve *const *pieces, batten_curve **out);

/* A row of data without corners; a closed one ends where it begins. */
typedef struct {
    int dimension, count;
    bool closed;
    const double *points;
    double tolerance;
    bat_work *work; /* asked now and then */
    double done[2]; /* of all data, before this row and with it */
} bat_within_row;
/* Schneider's cubics through a row. parameters [count] in, never decreasing, and out. */
batten_status bat_within_bezier(const bat_within_row *row, double *parameters,
                                batten_curve **out);

#endif
