/* Boxes of surfaces that are formulas. */
#include "shape/formula/formula.h"
#include "support/test.h"

#include <batten/surface.h>

static void keep(void *data)
{
    (void)data;
}

/* (a plane, a roof with its ridge at u = 0.37, a trough along v) */
static batten_status roof(const void *data, const bat_surface_place *at, int order, double *out)
{
    (void)data;
    const double u = at->u, v = at->v;
    memset(out, 0, 3 * (size_t)BATTEN_SURFACE_DERIVATIVES(order) * sizeof *out);
    out[0] = 2 * u - v;
    out[1] = -fabs(u - 0.37);
    out[2] = (v - 0.3) * (v - 0.3);
    return BATTEN_OK;
}

static batten_box box_with_breaks(int count_u, const double *u, int count_v, const double *v)
{
    const bat_formula formula = {"roof", roof, NULL, keep};
    const bat_formula_axis axes[2] = {{count_u, u, 0}, {count_v, v, 0}};
    batten_surface *surface = NULL;
    CHECK_OK(bat_formula_create(&formula, NULL, 3, &axes[0], &axes[1], 2, &surface));
    const batten_box box = batten_surface_box(surface);
    batten_surface_unref(surface);
    return box;
}

TEST(a_box_holds_its_surface_whatever_the_number_of_spans)
{
    static const int counts[] = {1, 2, 3, 32, 33, 40, 600};
    for (int c = 0; c < COUNT(counts); c++)
        for (int along = 0; along < 2; along++) {
            const int n = counts[c];
            double breaks[601];
            const double three[] = {0, 0.37, 1}, two[] = {0, 1};
            for (int i = 0; i <= n; i++)
                breaks[i] = (double)i * i / ((double)n * n);
            const batten_box box = along == 0 ? box_with_breaks(n + 1, breaks, 2, two)
                                              : box_with_breaks(3, three, n + 1, breaks);
            /* A plane has its corners, but for the margin of samples that are not even. */
            const double margin = n == 1 && along == 0 ? 1e-12 : 0.02;
            CHECK(box.low.x <= -1 + 1e-12 && box.high.x >= 2 - 1e-12);
            CHECK_NEAR(box.low.x, -1, margin);
            CHECK_NEAR(box.high.x, 2, margin);
            CHECK_NEAR(box.low.y, -0.63, 0.02);
            CHECK(box.low.y <= -0.63 && box.high.z >= 0.49 && box.low.z <= 1e-12);
            CHECK_NEAR(box.high.z, 0.49, 0.02);
            CHECK_NEAR(box.low.z, 0, 0.02);
            if (along == 1) { /* its ridge, on a break, is a sample */
                CHECK(box.high.y >= 0);
                CHECK_NEAR(box.high.y, 0, 0.02);
            }
        }
}

TEST(the_box_of_a_parabola_is_too_large_by_the_margin_of_one_sample_alone)
{
    /* 16 parts of [0, 1] by v, second difference 2 / 32^2 on even samples: the margin is an eighth
     * of it, and the roof has its ridge between samples. */
    const double two[] = {0, 1};
    const batten_box box = box_with_breaks(2, two, 2, two);
    CHECK_NEAR(box.high.z, 0.49 + 2.0 / 32 / 32 / 8, 1e-13);
    CHECK(box.low.z <= 0 && box.low.z >= -2.0 / 32 / 32 / 8);
    CHECK(box.high.y >= 0 && box.high.y < 2.0 / 32 / 8);
}
