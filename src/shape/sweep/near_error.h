/* How far interpolated sections are from a sweep. */
#ifndef BAT_SWEEP_NEAR_ERROR_H
#define BAT_SWEEP_NEAR_ERROR_H
#include "shape/sweep/true_sweep.h"

enum {
    BAT_SWEEP_PLACES = 5,      /* at which a span is measured */
    BAT_SWEEP_LAST_PLACES = 11 /* the last time */
};

typedef struct {
    const bat_sweep *sweep;
    int degree;
    double tolerance;
    int points;       /* of the section */
    size_t width;     /* of one of them */
    size_t row;       /* points * width */
    int mesh_count;   /* breaks of v */
    double *mesh;     /* [MOST_SECTIONS + 2] */
    int *times;       /* [MOST_SECTIONS + 2] multiplicities */
    double *error;    /* [MOST_SECTIONS + 1] of each span */
    int count;        /* sections, and control rows */
    double *knots;    /* [count + degree + 1] */
    double *rows;     /* [count][row] */
    double *band;     /* [count][2 degree + 1] */
    double *true_row; /* [row] */
    double *made_row; /* [row] */
    double size;      /* of the coordinates */
    double worst;
} bat_sweep_fitting;

batten_status bat_sweep_measure_spans(bat_sweep_fitting *f, int places);
/* The last time: spans that may be the worst at more places, and what more places found is
 * added once more for those that lie between. */
batten_status bat_sweep_measure_last(bat_sweep_fitting *f);
/* Of the coordinates. */
double bat_sweep_rounding(const bat_sweep_fitting *f);

#endif
