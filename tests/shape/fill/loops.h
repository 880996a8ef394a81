/* Holes that tests fill. */
#ifndef TESTS_SHAPE_FILL_LOOPS_H
#define TESTS_SHAPE_FILL_LOOPS_H
#include <batten/fill.h>

#include "support/test.h"

#define TESTS_DEGREES (180 / 3.14159265358979323846)

/* A loop with ribbons, and the surfaces made from it. */
typedef struct {
    int count;
    batten_curve *curves[9], *slopes[9];
    batten_ribbon ribbons[9];
    batten_surface *patches[BATTEN_FILL_SIDES];
    batten_surface_fill_report report;
} hole;

/* Bezier curves of degree p over [0, 1] as side and slope; slope NULL for none. */
static inline void hole_add(hole *h, int p, const double *points, int slope_degree,
                            const double *slope)
{
    const int i = h->count++;
    const double ends[2] = {0, 1};
    CHECK_OK(
        batten_curve_from_bezier(3, (batten_pieces){p, 1, ends}, points, NULL, &h->curves[i]));
    if (slope)
        CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){slope_degree, 1, ends}, slope,
                                          NULL, &h->slopes[i]));
    h->ribbons[i] = (batten_ribbon){h->curves[i], h->slopes[i], NULL};
}

static inline void hole_free_patches(hole *h)
{
    for (int i = 0; i < BATTEN_FILL_SIDES; i++) {
        batten_surface_unref(h->patches[i]);
        h->patches[i] = NULL;
    }
}

static inline void hole_free(hole *h)
{
    hole_free_patches(h);
    for (int i = 0; i < h->count; i++) {
        batten_curve_unref(h->curves[i]);
        batten_curve_unref(h->slopes[i]);
    }
}

/* A polygon of n corners on z = bend (x^2 + y^2) / 2, its sides parabolas above straight lines,
 * with the slopes of that surface; corners are at `radius` [n]. */
static inline void hole_on_paraboloid(int n, const double *radius, double bend, hole *h)
{
    memset(h, 0, sizeof *h);
    for (int i = 0; i < n; i++) {
        double c[2][2], mid[2], points[3][3], slope[2][3];
        for (int k = 0; k < 2; k++) {
            const int at = (i + k) % n;
            const double angle = 2 * 3.14159265358979323846 * at / n;
            c[k][0] = radius[at] * cos(angle);
            c[k][1] = radius[at] * sin(angle);
        }
        const double in[2] = {c[0][1] - c[1][1], c[1][0] - c[0][0]};
        mid[0] = (c[0][0] + c[1][0]) / 2;
        mid[1] = (c[0][1] + c[1][1]) / 2;
        for (int k = 0; k < 2; k++) {
            points[2 * k][0] = c[k][0];
            points[2 * k][1] = c[k][1];
            points[2 * k][2] = bend * (c[k][0] * c[k][0] + c[k][1] * c[k][1]) / 2;
            slope[k][0] = in[0];
            slope[k][1] = in[1];
            slope[k][2] = bend * (c[k][0] * in[0] + c[k][1] * in[1]);
        }
        points[1][0] = mid[0];
        points[1][1] = mid[1];
        points[1][2] = bend * (c[0][0] * c[1][0] + c[0][1] * c[1][1]) / 2;
        hole_add(h, 2, points[0], 1, slope[0]);
    }
}

/* The largest angle, in degrees, between the normals of a fill and a wanted normal along side
 * i, seen on the surfaces themselves; and the largest gap. */
typedef struct {
    double gap, angle;
} hole_misfit;

static inline void hole_see(const batten_surface *patch, double u, double v, double point[3],
                            double normal[3])
{
    double d[3][3];
    CHECK_OK(batten_surface_evaluate(patch, u, v, 1, d[0]));
    memcpy(point, d[0], sizeof d[0]);
    for (int c = 0; c < 3; c++)
        normal[c] =
            d[1][(c + 1) % 3] * d[2][(c + 2) % 3] - d[1][(c + 2) % 3] * d[2][(c + 1) % 3];
}

static inline double hole_angle(const double a[3], const double b[3])
{
    double cross[3], dot = 0;
    for (int c = 0; c < 3; c++) {
        cross[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
        dot += a[c] * b[c];
    }
    return atan2(sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]), dot) *
           TESTS_DEGREES;
}

static inline void hole_compare(const double p[3], const double n[3], const double q[3],
                                const double m[3], hole_misfit *out)
{
    const double gap = sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                            (p[2] - q[2]) * (p[2] - q[2]));
    out->gap = fmax(out->gap, gap);
    out->angle = fmax(out->angle, hole_angle(n, m));
}

/* Between all neighbouring surfaces of the fill. */
static inline hole_misfit hole_inner(const hole *h)
{
    enum { PLACES = 60 };
    hole_misfit out = {0, 0};
    for (int i = 0; i < h->report.count; i++)
        for (int k = 0; k <= PLACES; k++) {
            double p[3], n[3], q[3], m[3];
            hole_see(h->patches[i], 1, k / (double)PLACES, p, n);
            hole_see(h->patches[(i + 1) % h->report.count], k / (double)PLACES, 1, q, m);
            hole_compare(p, n, q, m, &out);
        }
    return out;
}
#endif
