/*
 * The integrals of Fresnel, generalised: what a direction that turns as a polynomial adds up
 * to.
 */
#ifndef BAT_FRESNEL_H
#define BAT_FRESNEL_H
#include "base/base.h"

enum { BAT_FRESNEL_DEGREE = 4, BAT_FRESNEL_MOMENTS = 5 };

/* The most that an angle may change in all, radians; the cost grows with it. */
#define BAT_FRESNEL_TURN 1e7

/*
 * x[j] and y[j], j = 0 .. moments - 1, are the integrals over t in [0, 1] of t^j cos(theta) and
 * t^j sin(theta), with theta = c[0] + c[1] t + ... + c[4] t^4. The error is a few units of the
 * last place of 1; where all coefficients are small, y keeps its relative precision.
 *
 * |c[1]| + ... + |c[4]| <= BAT_FRESNEL_TURN. Cost: 8 sines and cosines as long as the angle
 * changes by a radian or two, else 16 for every 10 radians or so.
 */
void bat_fresnel(const double c[BAT_FRESNEL_DEGREE + 1], int moments, double *x, double *y);

#endif
