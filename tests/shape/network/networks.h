/* Networks of curves on known surfaces, for the tests of Gordon's surfaces. */
#ifndef TESTS_SHAPE_NETWORKS_H
#define TESTS_SHAPE_NETWORKS_H
#include <batten/gordon.h>
#include <batten/interpolate.h>

#include "support/test.h"


typedef void (*surface_at)(double u, double v, double *point);

/* The curve of the surface at a fixed v (family 0) or u, drawn from `from` to `to` at a speed
 * of its own: s + bend s (1 - s). */
typedef struct {
    int family;
    double fixed, from, to, bend;
    int points;
} drawn;

static inline batten_curve *draw(surface_at at, drawn d)
{
    double points[3 * 200], s[200];
    for (int i = 0; i < d.points; i++) {
        s[i] = i / (d.points - 1.0);
        const double t = s[i] + d.bend * s[i] * (1 - s[i]);
        const double run = (1 - t) * d.from + t * d.to;
        at(d.family == 0 ? run : d.fixed, d.family == 0 ? d.fixed : run, points + 3 * i);
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_interpolate((batten_points){3, d.points, points}, &options, NULL, &curve));
    return curve;
}

typedef struct {
    int count[2];
    batten_curve *curves[2][64];
} network;

static inline void network_end(network *n)
{
    for (int f = 0; f < 2; f++)
        for (int k = 0; k < n->count[f]; k++)
            batten_curve_unref(n->curves[f][k]);
}

/* Profiles at v = k / (profiles - 1), guides alike, over the unit square. */
static inline network network_on(surface_at at, int profiles, int guides, int points,
                                 double bend)
{
    network n = {{profiles, guides}, {{NULL}}};
    for (int f = 0; f < 2; f++)
        for (int k = 0; k < n.count[f]; k++)
            n.curves[f][k] = draw(at, (drawn){.family = f,
                                              .fixed = k / (n.count[f] - 1.0),
                                              .to = 1,
                                              .bend = k % 2 ? bend : -bend / 2,
                                              .points = points});
    return n;
}

static inline batten_surface_gordon_options within(double tolerance)
{
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    options.tolerance = tolerance;
    return options;
}

static inline batten_status gordon(const network *n,
                                   const batten_surface_gordon_options *options,
                                   batten_surface_gordon_report *report, batten_surface **out)
{
    return batten_surface_gordon(
        (batten_curve_row){n->count[0], (const batten_curve *const *)n->curves[0]},
        (batten_curve_row){n->count[1], (const batten_curve *const *)n->curves[1]}, options,
        NULL, report, out);
}

/* A shell that bends both ways. */
static inline void shell(double u, double v, double *p)
{
    p[0] = 4 * u + 0.3 * v * v;
    p[1] = 3 * v - 0.4 * u * v;
    p[2] = 0.8 * sin(2 * u + v) + 0.5 * cos(3 * v);
}

/* A polynomial of degree 3 in either variable. */
static inline void bicubic(double u, double v, double *p)
{
    p[0] = 2 * u + 0.5 * u * u * v;
    p[1] = v + 0.25 * v * v * v * u;
    p[2] = u * u * u - 2 * u * v + v * v * v * u * u * u;
}

/* Over the unit square once round. */
static inline void tube(double u, double v, double *p)
{
    const double turn = 4 * acos(0) * u, radius = 1 + 0.3 * sin(2 * v);
    p[0] = radius * cos(turn);
    p[1] = 0.7 * radius * sin(turn);
    p[2] = 4 * v + 0.2 * cos(turn);
}

static inline void torus(double u, double v, double *p)
{
    const double a = 4 * acos(0) * u, b = 4 * acos(0) * v, radius = 3 + cos(b);
    p[0] = radius * cos(a);
    p[1] = radius * sin(a);
    p[2] = sin(b);
}

/* u round the axis, v from pole to pole. */
static inline void globe(double u, double v, double *p)
{
    const double a = 4 * acos(0) * u, b = 2 * acos(0) * v;
    p[0] = sin(b) * cos(a);
    p[1] = sin(b) * sin(a);
    p[2] = -cos(b);
}

#endif
