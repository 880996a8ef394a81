/* Sections of four digits by their formula, and the ways in which files spoil them. */
#ifndef TESTS_AEROFOIL_SECTIONS_H
#define TESTS_AEROFOIL_SECTIONS_H
#include "support/test.h"

#include <batten/approximate.h>
#include <math.h>

enum { HALF = 40, COUNT_OF_POINTS = 2 * HALF + 1 };

/* Half the thickness of a section of thickness 1, open at the tail by 0.021. */
static inline double naca_half(double x)
{
    return 5 * (0.2969 * sqrt(x) - x * (0.1260 + x * (0.3516 - x * (0.2843 - x * 0.1015))));
}

/* A parabola of this height at the middle. */
static inline double camber_line(double camber, double x)
{
    return 4 * camber * x * (1 - x);
}

/* From the upper end over the nose to the lower end; thickness across the chord. */
static inline void make_points(double thickness, double camber, double points[][2])
{
    for (int i = 0; i < COUNT_OF_POINTS; i++) {
        const double part = (double)(i - HALF) / HALF, x = part * part;
        const double half = (i < HALF ? 1 : -1) * thickness * naca_half(x);
        points[i][0] = x;
        points[i][1] = camber_line(camber, x) + half;
    }
}

static inline batten_points points_of(double points[][2], int count)
{
    return (batten_points){2, count, points[0]};
}

#endif
