/* Corners of a row of points: where it turns sharply, within a given distance. */
#ifndef BAT_NEAR_CORNERS_H
#define BAT_NEAR_CORNERS_H
#include "shape/near/within.h"

typedef struct {
    const batten_curve_within_options *options;
    int dimension, count;
    const double *points;
    bool *corner; /* [count] */
    int corner_count;
    /* The row as pieces see it: a closed one with corners begins at one and ends there. */
    int row_count, first;
    double *row, *parameters; /* [row_count + 1] */
    double *bows;             /* [row_count] how far a curve may leave the chord to the next */
    int piece_count;
    batten_curve **pieces; /* [row_count] */
    batten_curve *curve;
    int fits;
    bat_work work; /* with the job of the options */
} bat_within_fit;

batten_status bat_find_corners(bat_within_fit *t);

#endif
