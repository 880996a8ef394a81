/* What local methods share: Hermite data that may be closed and may have corners. */
#ifndef BAT_HERMITE_DATA_H
#define BAT_HERMITE_DATA_H
#include "base/base.h"
#include <batten/local.h>

/* Index i of a row of `count` that closes, for -count <= i < 2 count. */
static inline int bat_around(int count, int i)
{
    return i < 0 ? i + count : i >= count ? i - count : i;
}

/* A third of the derivative at both ends of a span, by its chord, when its speed is the same at
 * both ends and in the middle. u: direction of the chord, t0, t1: tangents; unit vectors. */
double bat_middle_leg(int d, const double *u, const double *t0, const double *t1);

/* `what` i is not finite: refused. */
batten_status bat_local_check_rows(int dimension, int count, const double *rows,
                                   const char *what);

/* ---- functions ---- */

/* The chords of a function: their widths and slopes, [count - 1] each; release both. On failure
 * nothing is kept. */
typedef struct {
    int count; /* points */
    const double *x, *y;
    double *h, *d;
} bat_chords;
batten_status bat_chords_make(int count, const double *x, const double *y, bat_chords *out);
void bat_chords_free(bat_chords *chords);
/* What rounding of the data makes of the slope of chord i. */
double bat_chord_rounding(const bat_chords *chords, int i);
/* Slopes [count] by a rule. */
void bat_slopes(const bat_chords *chords, batten_slope_rule rule, double *slopes);

#endif
