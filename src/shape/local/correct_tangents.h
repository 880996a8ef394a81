/* Spans of a cubic whose tangents are corrected, at work. */
#ifndef BAT_CORRECT_H
#define BAT_CORRECT_H
#include "base/base.h"
#include <batten/invariants.h>
#include <batten/local.h>

typedef struct {
    batten_curve_correct_tangents_options options;
    int dimension, count;
    bool closed;    /* the last span joins the first */
    double *points; /* [3 count + 1][d] */
    double *breaks; /* [count + 1] */
    int *changed;   /* [count] */
    double *legs;   /* [count][2] lengths of the tangents as they were given */
    double *bends;  /* [count][2] in the plane, curvature at both ends as it was given */
    batten_cubic *spans;
    batten_curve_correct_tangents_report report;
} bat_correction;

static inline double *bat_correction_point(const bat_correction *w, int index)
{
    return w->points + (size_t)index * (size_t)w->dimension;
}

/* Signed curvature of span i at its start (0) or end (1); NaN where a leg is 0. */
double bat_correction_bend(const bat_correction *w, int i, int end);
/* Has a span inflections in excess, a cusp or a loop? */
bool bat_correction_is_bad(batten_cubic_region region);
/* The span before join j; the seam is join 0. */
int bat_correction_before(const bat_correction *w, int j);

/* Curvatures that agree to this part of the larger one are the same: what the header promises.
 */
static const double bat_correction_agree = 1e-6;

/* Choose legs anew, such that curvatures agree again at as many joins as possible and legs
 * change little (correct_joins.c). */
batten_status bat_correction_join(bat_correction *w);

#endif
