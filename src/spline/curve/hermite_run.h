/* A smooth run of quintics in the making: what they share at their ends. */
#ifndef BAT_HERMITE_RUN_H
#define BAT_HERMITE_RUN_H
#include "base/base.h"
#include <batten/curve.h>

/* A point with its first and second derivative by u. */
typedef struct {
    double u, q[3][3]; /* coordinates beyond the dimension are unused */
} bat_hermite_place;

/* Begin with .dimension alone; the first place opens the run. */
typedef struct {
    int dimension, count, room;
    bat_hermite_place *places;
} bat_hermite_run;

/* Do both sides of a place, each [3][3], agree in the derivatives from `first` to the second?
 * Rows
 * [3][3] may differ by `same` of the longer one. */
bool bat_hermite_agrees(int dimension, int first, const double *left, const double *right,
                        double same);

/* The curve of quintics between these places, whose parameters rise. */
batten_status bat_hermite_curve(int dimension, int count, const bat_hermite_place *places,
                                batten_curve **out);

/* @param q  [3][3] */
batten_status bat_hermite_run_add(bat_hermite_run *run, double u, const double *q);

/* The curve of a run, which is empty then; NULL from a run of fewer than two places. */
batten_status bat_hermite_run_finish(bat_hermite_run *run, batten_curve **out);

void bat_hermite_run_release(bat_hermite_run *run);

#endif
