/* Families of section curves for the tests of skinning. */
#ifndef TESTS_SHAPE_SECTIONS_H
#define TESTS_SHAPE_SECTIONS_H
#include <batten/skin.h>

#include "support/test.h"

/* A cubic through `count` points at(s, x, point) of a curve over [0, 1], at jittered places:
 * its knots are its own. */
static inline batten_curve *jittered(test_random *random, int count, double x,
                                     void (*at)(double s, double x, double *point))
{
    double points[3 * 64], s[64];
    for (int i = 0; i < count; i++) {
        const double jitter = i > 0 && i < count - 1 ? test_random_in(random, -0.3, 0.3) : 0;
        s[i] = (i + jitter) / (count - 1);
        at(s[i], x, points + 3 * i);
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_interpolate((batten_points){3, count, points}, &options, NULL, &curve));
    return curve;
}

/* A closed profile at jittered places: periodic, with knots of its own. */
static inline batten_curve *jittered_ring(test_random *random, int count, double x)
{
    double points[3 * 64], s[65];
    for (int i = 0; i < count; i++) {
        s[i] = (i + (i > 0 ? test_random_in(random, -0.3, 0.3) : 0)) / count;
        const double a = 4 * acos(0) * s[i], r = 1 + 0.1 * x + 0.2 * cos(2 * a + 0.3 * x);
        points[3 * i] = r * cos(a), points[3 * i + 1] = r * sin(a), points[3 * i + 2] = x;
    }
    s[count] = 1;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    options.closed = true;
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_interpolate((batten_points){3, count, points}, &options, NULL, &curve));
    return curve;
}

/* A profile of chord 1, from the trailing edge over the nose and back; x is along the span. */
static inline void airfoil(double s, double x, double *point)
{
    const double turn = 4 * acos(0) * s;
    point[0] = x;
    point[1] = (1 + cos(turn)) / 2;
    point[2] = (0.08 + 0.02 * x) * sin(turn) * (1 - 0.6 * cos(turn)) + 0.02 * x * sin(turn / 2);
}

/* Half a ship of 25 m at x in [0, 1] of its length: from the keel round the bilge to the deck.
 */
static inline void hull(double s, double x, double *point)
{
    const double beam = 3 * pow(sin(2 * acos(0) * (0.1 + 0.8 * x)), 0.7), depth = 2.5 + x * x;
    const double bilge = 1.2 + 2 * (1 - fabs(2 * x - 1)), turn = acos(0) * s;
    point[0] = 25 * x;
    point[1] = beam * pow(sin(turn), 2 / bilge) * (0.6 + 0.4 * sin(turn));
    point[2] = depth * (1 - cos(turn)) + 0.1 * s;
}

static inline void unref_all(int count, batten_curve **curves)
{
    for (int k = 0; k < count; k++)
        batten_curve_unref(curves[k]);
}

#endif
