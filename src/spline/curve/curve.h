/* What a curve is inside: Cartesian points, weights apart, all knots, and what is derived from
 * them once. */
#ifndef BAT_CURVE_H
#define BAT_CURVE_H
#include "spline/spline.h"
#include <batten/geometry.h>

/* Limits of one object, and of one that is made by refining or joining others. */
enum {
    BAT_MAX_POINTS = 10000000,
    BAT_MAX_MADE_POINTS = 1000000,
    BAT_MAX_WIDTH = 4,
    BAT_MAX_ROWS = (BATTEN_MAX_DEGREE + 1) * BAT_MAX_WIDTH
};

/* A span ready for evaluation. */
typedef struct {
    int knot;      /* index of the knot at its begin */
    double a, b;   /* its ends */
    bool tight;    /* bat_span_is_tight */
    size_t stride; /* from row to row; numbers beyond the width are 0 */
    const double
        *rows; /* [p + 1][stride], Bezier, homogeneous and scaled as bat_curve_rows says */
} bat_piece;

/* All non-empty spans. */
typedef struct {
    int count;
    size_t stride;  /* 2 or 4, for vectors */
    double *breaks; /* [count + 1] distinct knots of the domain */
    double *rows;   /* [count][p + 1][stride] */
    int *spans;     /* [count] index of the knot that begins the span */
    bool *tight;    /* [count] */
    int step;       /* the first of a search, a power of two */
    double slices;  /* `count` by the length of the domain */
    int *guide; /* [count + 1] how many inner breaks lie before each of `count` equal slices of
                   the domain */
    bool bounded; /* all numbers below 1e300: points, means of them, cannot overflow */
} bat_pieces;

struct batten_curve {
    bat_references references;
    int dimension, degree, count;
    bool periodic;
    double weight_scale; /* the power of two that brings the largest weight into [1, 2) */
    double *points, *weights, *knots;
    _Atomic(bat_pieces *) pieces; /* NULL until a batch asks for them */
};

/* A curve whose arrays wait to be filled, by nobody else seen yet. bat_curve_finish looks at
 * what was filled in (finite points, positive weights) and hands it over, or gives it back. */
batten_status bat_curve_make(int dimension, int degree, int count, bool rational,
                             batten_curve **out);
batten_status bat_curve_finish(batten_curve *curve, batten_curve **out);

static inline size_t bat_curve_width(const batten_curve *curve)
{
    return (size_t)curve->dimension + (curve->weights != NULL);
}

/* Control points first .. first + count - 1 as rows of a spline: (x ..), or (w x .., w) with w
 * scaled by a power of two common to the curve, so that tiny or huge weights cost no accuracy;
 * then 0 up to the stride. */
void bat_curve_rows(const batten_curve *curve, int first, int count, size_t stride,
                    double *rows);

/* Bring u into the domain: by whole periods, or over the last few ulps. */
batten_status bat_curve_place(const batten_curve *curve, batten_side side, double *u);

/* The curve as a spline of such rows, with all its knots. */
batten_status bat_curve_to_spline(const batten_curve *curve, bat_spline *out);
/* Back again. `like` gives dimension, rationality and the scale of the weights. Where rows of
 * `made` are those of `from`, made of `like`, the Cartesian point is taken from there and keeps
 * its bits; the search begins at row `first`. OVERFLOW when a row is not finite. */
batten_status bat_curve_from_spline(const batten_curve *like, const bat_spline *from, int first,
                                    const bat_spline *made, batten_curve **out);
/* The same when a change has made `made` from all of `from`; releases both, and after a failed
 * change, which made nothing, the latter. */
batten_status bat_curve_of_changed(batten_status change, const batten_curve *like,
                                   bat_spline *from, bat_spline *made, batten_curve **out);

/* A periodic curve as a spline with `more` further periods on each side of the one of its
 * domain; 0 for the wrapped form. It has `more` m + p knots before the domain. */
batten_status bat_curve_unwrap(const batten_curve *curve, int more, bat_spline *out);
/* The periodic curve whose period, of m points, begins at a in an unwrapped spline. */
batten_status bat_curve_wrap(const batten_curve *like, const bat_spline *spline, double a,
                             int m, batten_curve **out);

/* The part of a curve in Bezier form between two places of one of its pieces: cost that of the
 * piece, not of the curve. */
batten_status bat_bezier_part(const batten_curve *curve, double a, double b,
                              batten_curve **out);

/* A new curve with room for `count` points and the dimension, rationality and so on of `like`.
 */
batten_status bat_curve_make_like(const batten_curve *like, int degree, int count,
                                  batten_curve **out);
/* Points, weights and knots taken over unchanged, to alter some of them before
 * bat_curve_finish. */
batten_status bat_curve_copy(const batten_curve *curve, batten_curve **out);

/* The span that begins at knot `span`; rows [BAT_MAX_ROWS] are the caller's. */
bat_piece bat_curve_piece(const batten_curve *curve, int span, double *rows);
/* Evaluate at u in a piece: out [order + 1][d]. The definition of what a batch computes. */
void bat_curve_on_piece(const batten_curve *curve, const bat_piece *on, double u, int order,
                        double *out);
/* From derivatives a [..][stride] of the homogeneous curve of this degree to those of the
 * curve, out [order + 1][d]. Leibniz for w P = A: P(k) = (A(k) - sum over i of C(k, i) w(i) P(k
 * - i)) / w. */
void bat_divide(int degree, size_t d, int order, size_t stride, const double *a, double *out);

/* The Bezier pieces, made at the first batch of `count` parameters that is worth it; NULL when
 * it is not, or when memory is short: callers then work span by span. */
const bat_pieces *bat_curve_pieces(const batten_curve *curve, size_t count);
/* The piece that holds u, the last one closed on the right; u in the domain. */
bat_piece bat_pieces_find(const bat_pieces *pieces, int degree, double u);
bat_piece bat_pieces_get(const bat_pieces *pieces, int degree, int index);
/* Indices of the pieces that hold u[count]; -1 for the end of the domain and what lies outside.
 */
void bat_pieces_locate(const bat_pieces *pieces, size_t count, const double *u, int *index);
void bat_pieces_free(bat_pieces *pieces);

/* The frame with axes square and of length one, z kept; and its y-axis. */
batten_status bat_frame_square(const batten_frame *frame, batten_frame *square, batten_vec3 *y);

/* Curves end to end as one, in rounds of neighbours: cost n log n. */
batten_status bat_curves_chain(int count, batten_curve *const *curves, double tolerance,
                               batten_curve **out);

/* Put another curve in the place of one that is given back. */
static inline void bat_curve_take(batten_curve **curve, batten_curve *by)
{
    batten_curve_unref(*curve);
    *curve = by;
}

/* The same with the result of a change, when it succeeded; see bat_surface_replace. */
static inline batten_status bat_curve_replace(batten_status status, batten_curve **curve,
                                              batten_curve *const *made)
{
    if (status == BATTEN_OK)
        bat_curve_take(curve, *made);
    return status;
}

#endif
