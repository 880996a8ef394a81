/* Curves and surfaces with known answers. */
#ifndef TESTS_INSPECT_SHAPES_H
#define TESTS_INSPECT_SHAPES_H
#include "support/test.h"
#include <batten/curvature.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

/* An ellipse with half-axes a along x and b along y about (cx, cy): nine points, four arcs. */
static inline batten_status shape_ellipse(double a, double b, double cx, double cy,
                                          batten_curve **out)
{
    const double s = sqrt(0.5), weights[9] = {1, s, 1, s, 1, s, 1, s, 1};
    const double corners[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                  {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    const double knots[12] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    double points[18];
    for (int i = 0; i < 9; i++) {
        points[2 * i] = cx + a * corners[i][0];
        points[2 * i + 1] = cy + b * corners[i][1];
    }
    return batten_curve_create((batten_points){2, 9, points}, 2, weights, knots, out);
}

static inline batten_status shape_bezier(int dimension, int degree, const double *points,
                                         batten_curve **out)
{
    double knots[2 * BATTEN_MAX_DEGREE + 2] = {0};
    for (int i = 0; i <= degree; i++)
        knots[degree + 1 + i] = 1;
    return batten_curve_create((batten_points){dimension, degree + 1, points}, degree, NULL,
                               knots, out);
}

/* A circle of radius `tube` in the plane of the axis, centred at distance `ring` from it,
 * turned about z: a torus; with ring = 0 and half the circle a sphere. u goes around the axis,
 * v around the tube, and Su x Sv points outwards. */
static inline batten_status shape_torus(double ring, double tube, bool half,
                                        batten_surface **out)
{
    const double s = sqrt(0.5), w[9] = {1, s, 1, s, 1, s, 1, s, 1};
    const double c[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                            {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    const double round[12] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    const double halfway[8] = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
    const int count = half ? 5 : 9;
    double points[9 * 9 * 3], weights[81];
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < count; j++) {
            /* the half circle runs from the south pole over (1, 0) to the north pole */
            const int k = half ? (j + 6) % 8 : j;
            const double r = ring + tube * c[k][0], *corner = c[i];
            double *p = points + (i * count + j) * 3;
            p[0] = r * corner[0];
            p[1] = r * corner[1];
            p[2] = tube * c[k][1];
            weights[i * count + j] = w[i] * w[k];
        }
    const batten_axis u = {2, 9, round, false}, v = {2, count, half ? halfway : round, false};
    return batten_surface_create(3, &u, &v, points, weights, out);
}

static inline double vec3_size(batten_vec3 a)
{
    return sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

#endif
