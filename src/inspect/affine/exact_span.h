/* A polynomial span with its coordinates as whole numbers, and how flat it is. */
#ifndef BAT_EXACT_SPAN_H
#define BAT_EXACT_SPAN_H
#include "numeric/whole_polynomial.h"

/* Coordinates of one size with fewer binary places between their first and last bit than that
 * are read. */
enum { BAT_SPAN_BITS = 300 + 53 };

typedef struct {
    int dimension, degree; /* the degree without leading terms that are 0 */
    bat_whole_poly at[3];  /* powers of t, times 2^shift */
    int shift[3];
} bat_exact_span;

/* points [degree + 1][dimension], finite; INCOMPLETE when they have too many bits, else as the
 * effort says. */
batten_status bat_exact_span_read(bat_wholes *pool, int dimension, int degree,
                                  const double *points, bat_exact_span *out);

/* Powers of u = 2 t - 1 but for the constants, rounded once, in a unit near the largest of
 * them: [dimension][stride], the first degree + 1 of each. */
void bat_exact_span_centred(bat_wholes *pool, const bat_exact_span *span, int stride,
                            double *powers);

typedef struct {
    int dimension;   /* 0 a point, 1 on a line, 2 in a plane, 3 */
    double flatness; /* what is missing to the dimension below, by the size */
    int axes[2];     /* coordinates that tell its points apart, as many as its dimension */
} bat_flatness;

/* Within `tolerance` of the size; exactly where that is 0. */
bat_flatness bat_exact_span_flatness(bat_wholes *pool, const bat_exact_span *span,
                                     const double *points, int degree, double tolerance);

/* The same of points [count][d] alone, by a tolerance above 0; of exact numbers nothing is
 * asked. */
bat_flatness bat_flatness_of_points(int d, int count, const double *points, double tolerance);

#endif
