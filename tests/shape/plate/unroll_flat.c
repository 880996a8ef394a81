#include <batten/batten.h>

#include "support/test.h"

#include <math.h>

/* What lies in a plane keeps all distances, wherever its lines meet: here at a corner of the triangle. */
TEST(a_plane_surface_is_laid_flat_as_it_is)
{
    const batten_vec3 corners[2][4] = {{{0, 0, 0}, {3, 0, 0}, {1, 2, 0}, {1, 2, 0}},
                                       {{0, 0, 0}, {3, 1, 0}, {0, 2, 0}, {4, 3, 0}}};
    for (int i = 0; i < 2; i++) {
        const batten_vec3 *c = corners[i];
        batten_surface *plane = NULL;
        CHECK_OK(batten_surface_bilinear(c[0], c[1], c[2], c[3], &plane));
        batten_surface_unroll_options options = batten_surface_unroll_defaults();
        options.tolerance = 1e-5;
        batten_unrolled flat = {0};
        options.straight = BATTEN_STRAIGHT_V;
        CHECK_OK(batten_surface_unroll(plane, &options, &flat));
        CHECK(flat.error < 1e-14 && flat.diagonal[0] < 1e-14);
        for (int k = 0; k <= 10; k++)
            for (int l = 0; l <= 10; l++) {
                double p[3], q[3], a[2], b[2];
                CHECK_OK(batten_surface_evaluate(plane, k / 10.0, 0, 0, p));
                CHECK_OK(batten_surface_evaluate(plane, l / 10.0, 1, 0, q));
                CHECK_OK(batten_curve_evaluate(flat.first, k / 10.0, 0, a));
                CHECK_OK(batten_curve_evaluate(flat.second, l / 10.0, 0, b));
                CHECK_NEAR(hypot(a[0] - b[0], a[1] - b[1]), hypot(p[0] - q[0], p[1] - q[1]),
                           1e-13);
            }
        batten_unrolled_release(&flat);
        batten_surface_unref(plane);
    }
}
