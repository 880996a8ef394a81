/*
 * On which side of a line, inside or outside a circle: signs of determinants, exact for any
 * coordinates that are multiples of 2^-200 and below 2 (and for others as far as bat_exact is).
 */
#ifndef BAT_PLANE_SIGNS_H
#define BAT_PLANE_SIGNS_H

/* 1 when a, b, c go round counterclockwise, -1 clockwise, 0 on one line. */
int bat_orientation(const double *a, const double *b, const double *c);
/* 1 when d is inside the circle through a, b, c, which go round counterclockwise, -1 outside, 0
 * on it. */
int bat_in_circle(const double *a, const double *b, const double *c, const double *d);

#endif
