/* Boundaries of Coons patches for tests. */
#ifndef TESTS_SHAPE_COONS_H
#define TESTS_SHAPE_COONS_H
#include <batten/coons.h>

#include "support/faults.h"
#include "support/test.h"

/* A surface, and what its edges give to a patch. */
typedef struct {
    batten_surface *surface;
    batten_curve *curves[4][3];
    batten_ribbon sides[4];
} frame_of_surface;

static inline batten_curve *inward(batten_curve *curve)
{
    const batten_affine minus = batten_affine_scaling(-1, -1, -1);
    batten_curve *turned = NULL;
    CHECK_OK(batten_curve_transform(curve, &minus, &turned));
    batten_curve_unref(curve);
    return turned;
}

/* A surface of degrees p, q with inner knots, over the unit square. */
static inline batten_surface *bumpy(test_random *random, int p, int q, int spans_u, int spans_v)
{
    double U[40], V[40], points[14 * 14 * 3];
    const int n = p + spans_u, m = q + spans_v;
    for (int i = 0; i < n + p + 1; i++)
        U[i] = i <= p ? 0 : i >= n ? 1 : (i - p + test_random_in(random, -0.3, 0.3)) / spans_u;
    for (int i = 0; i < m + q + 1; i++)
        V[i] = i <= q ? 0 : i >= m ? 1 : (i - q + test_random_in(random, -0.3, 0.3)) / spans_v;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            double *point = points + (i * m + j) * 3;
            point[0] = (double)i / (n - 1) + test_random_in(random, -0.05, 0.05);
            point[1] = (double)j / (m - 1) + test_random_in(random, -0.05, 0.05);
            point[2] = test_random_in(random, -0.3, 0.3);
        }
    const batten_axis u = {p, n, U, false}, v = {q, m, V, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    return surface;
}

static inline void frame_surface(batten_surface *surface, frame_of_surface *out)
{
    out->surface = surface;
    for (int e = 0; e < 4; e++) {
        for (int k = 0; k < 3; k++)
            out->curves[e][k] = NULL;
        CHECK_EACH_ALLOCATION(
            batten_edge_ribbon(surface, (batten_edge)e, 2, 0, NULL, out->curves[e]));
        out->curves[e][1] = inward(out->curves[e][1]);
        out->sides[e] =
            (batten_ribbon){out->curves[e][0], out->curves[e][1], out->curves[e][2]};
    }
}

static inline void frame_release(frame_of_surface *frame)
{
    for (int e = 0; e < 4; e++)
        for (int k = 0; k < 3; k++)
            batten_curve_unref(frame->curves[e][k]);
    batten_surface_unref(frame->surface);
}

/* The largest difference of the derivative (k, l) of two surfaces at count x count points, or
 * on the four edges alone. */
static inline double apart(const batten_surface *a, const batten_surface *b, int count, int k,
                           int l, bool edges_only)
{
    double worst = 0, p[30], q[30];
    const int d = batten_surface_dimension(a), at = BATTEN_SURFACE_DERIVATIVE(k, l) * d;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            const double u = (double)i / (count - 1), v = (double)j / (count - 1);
            if (edges_only && i > 0 && j > 0 && i < count - 1 && j < count - 1)
                continue;
            CHECK_OK(batten_surface_evaluate(a, u, v, k + l, p));
            CHECK_OK(batten_surface_evaluate(b, u, v, k + l, q));
            for (int x = 0; x < d; x++)
                worst = fmax(worst, fabs(p[at + x] - q[at + x]));
        }
    return worst;
}

#endif
