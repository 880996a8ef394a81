/* Double points of a plane polynomial curve, all of them, by elimination in whole numbers. */
#ifndef BAT_DOUBLE_POINTS_H
#define BAT_DOUBLE_POINTS_H
#include "numeric/whole_polynomial.h"

/* A real double point: parameters with sum and product S and Q. */
typedef struct {
    int sign;    /* of S^2 - 4 Q: 1 both real, 0 equal (a cusp), -1 conjugate */
    bool inside; /* both in the open interval (0, 1) */
    int multiplicity;
    double sum, discriminant; /* S, S^2 - 4 Q */
} bat_double_point;

typedef enum {
    BAT_DOUBLE_POINTS_ALL,      /* these are all */
    BAT_DOUBLE_POINTS_REPEATED, /* X(t) = X(s) along a curve of (t, s) */
    BAT_DOUBLE_POINTS_UNKNOWN   /* no elimination told them apart */
} bat_double_points_known;

typedef struct {
    bat_double_points_known known;
    int finite; /* complex ones and cusps included, by multiplicity */
    int count;
    bat_double_point *at; /* [count] in the pool, real ones */
} bat_double_points;

/* x of degree n >= 1, y of a lower degree, both >= 1, primitive. The effort of the pool may
 * come to its end. Source: [SL] VIII.2, with S and Q. */
bat_double_points bat_double_points_find(bat_wholes *pool, bat_whole_poly x, bat_whole_poly y);

#endif
