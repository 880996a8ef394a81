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

enum { SERIES = 19 }; /* coefficients: the next one of cos 1 or cosh 1 is below a rounding */

/* The Bezier points of the power series [SERIES] over [0, 1]. */
static inline void shape_series(const double *power, double *out)
{
    for (int j = 0; j < SERIES; j++) {
        double share = 1; /* of binomial(j, i) / binomial(SERIES - 1, i) */
        out[j] = 0;
        for (int i = 0; i <= j; i++) {
            out[j] += share * power[i];
            share *= (double)(j - i) / (SERIES - 1 - i);
        }
    }
}

/* cos t, sin t and cosh t over [0, 1]. */
static inline void shape_circular(double out[3][SERIES])
{
    double power[3][SERIES] = {{0}}, factorial = 1;
    for (int i = 0; i < SERIES; i++) {
        power[i % 2][i] = (i / 2 % 2 ? -1 : 1) / factorial;
        power[2][i] = i % 2 ? 0 : 1 / factorial;
        factorial *= i + 1;
    }
    for (int k = 0; k < 3; k++)
        shape_series(power[k], out[k]);
}

/* The helicoid (v cos u, v sin u, c u) with v from `low` to `high`, or, with `low` = `high`, the catenoid
 * (c cosh v cos u, c cosh v sin u, c v); u and v over [0, 1]. */
static inline batten_status shape_minimal(double c, double low, double high,
                                          batten_surface **out)
{
    static double points[SERIES * SERIES * 3];
    double series[3][SERIES], knots[2 * SERIES] = {0};
    const double line[4] = {low, low, high, high};
    const bool is_catenoid = low == high;
    const int across = is_catenoid ? SERIES : 2;
    shape_circular(series);
    for (int i = 0; i < SERIES; i++)
        knots[SERIES + i] = 1;
    for (int i = 0; i < SERIES; i++)
        for (int j = 0; j < across; j++) {
            const double r = is_catenoid ? c * series[2][j] : j ? high : low;
            const double along = (double)i / (SERIES - 1), share = (double)j / (across - 1);
            double *p = points + 3 * (i * across + j);
            p[0] = r * series[0][i];
            p[1] = r * series[1][i];
            p[2] = c * (is_catenoid ? share : along);
        }
    return batten_surface_create(
        3, &(batten_axis){SERIES - 1, SERIES, knots, false},
        &(batten_axis){across - 1, across, is_catenoid ? knots : line, false}, points, NULL,
        out);
}

#endif
