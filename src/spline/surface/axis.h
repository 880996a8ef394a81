/*
 * One direction of a tensor-product surface: its knots, and what is derived from them once so
 * that a point costs no search and no division.
 */
#ifndef BAT_SURFACE_AXIS_H
#define BAT_SURFACE_AXIS_H
#include "spline/spline.h"

typedef struct {
    int degree, count; /* of control points, wrapped ones too */
    bool periodic;
    int span_count; /* non-empty spans of the domain */
    double *knots;  /* [count + degree + 1] */
    double *breaks; /* [span_count + 1] distinct knots of the domain */
    int *first;     /* [span_count] index of the knot that begins the span */
    /* [span_count][p (p + 1) / 2]: for levels e = 1 .. p of the triangular recurrence, j = 0 ..
     * e - 1: 1 / (U[k + 1 + j] - U[k + 1 + j - e]) */
    double *inverses;
    int slice_count;   /* of equal slices of the domain, several to a span */
    double slice_rate; /* slices per unit of the parameter */
    int *guide; /* [slice_count + 1]: the span that holds a parameter of slice j is guide[j] ..
                   guide[j + 1] */
} bat_axis;

/* An axis whose knots wait to be filled in; bat_axis_finish derives the rest. bat_axis_free is
 * due in any case. */
batten_status bat_axis_make(int degree, int count, bool periodic, bat_axis *out);
batten_status bat_axis_finish(bat_axis *axis);
void bat_axis_free(bat_axis *axis);

/* Bring a parameter into the domain: a periodic one by whole periods, any other by 4 ulps at
 * most. At the seam of a periodic axis `side` says which end of the domain is meant. */
batten_status bat_axis_place(const bat_axis *axis, batten_side side, double *u);
/* The basis functions that live on a span and their derivatives, out [order + 1][p + 1]. */
void bat_axis_basis(const bat_axis *axis, int span, double u, int order, double *out);

/* Rises with u, whatever the rounding: the guide rests on that alone. */
static inline int bat_axis_slice(const bat_axis *axis, double u)
{
    const int j = (int)((u - axis->breaks[0]) * axis->slice_rate);
    return j < axis->slice_count ? j : axis->slice_count - 1;
}

/* The span that holds u, counted among the non-empty ones; u in the domain. */
static inline int bat_axis_span(const bat_axis *axis, double u, batten_side side)
{
    const int j = bat_axis_slice(axis, u);
    int low = axis->guide[j], high = axis->guide[j + 1];
    while (low < high) {
        const int middle = low + (high - low + 1) / 2;
        if (axis->breaks[middle] <= u)
            low = middle;
        else
            high = middle - 1;
    }
    return side == BATTEN_FROM_LEFT && u == axis->breaks[low] && low > 0 ? low - 1 : low;
}

/* The first control point that bears on a span. */
static inline int bat_axis_first_point(const bat_axis *axis, int span)
{
    return axis->first[span] - axis->degree;
}

/* Control points of one period; all of them when the axis is not periodic. */
static inline int bat_axis_own_count(const bat_axis *axis)
{
    return axis->periodic ? axis->count - axis->degree : axis->count;
}

#endif
