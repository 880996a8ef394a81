/* Fits of closed curves that are not periodic. */
#include "shape/sections.h"
#include "shape/skin/common_knots.h"

#include <batten/interpolate.h>

/* Closed curves without periodic knots: the ends stay, and so do two derivatives across them. */
TEST(K7_curves_that_close_smoothly_still_do_with_held_knots)
{
    enum { N = 3 };
    const double held[] = {0.31};
    test_random random = test_random_begin("seams");
    batten_curve *open[N], *common[N] = {NULL};
    double deviation[N];
    bat_work work = {NULL, 0};
    for (int k = 0; k < N; k++) {
        batten_curve *ring = jittered_ring(&random, 24, k);
        CHECK_OK(batten_curve_clamp(ring, &open[k]));
        batten_curve_unref(ring);
        CHECK(!batten_curve_is_periodic(open[k]));
    }
    const bat_common_request request = {
        .tolerance = 1e-2, .held_count = 1, .held = held, .seam = true};
    CHECK_OK(bat_common_knots_held(N, (const batten_curve *const *)open, &request, &work,
                                   common, deviation));
    CHECK(batten_curve_spans(common[0], NULL) - 2 < 23 * N);
    for (int k = 0; k < N; k++) {
        const batten_interval domain = batten_curve_domain(open[k]);
        double first[9], last[9], given[3];
        CHECK(deviation[k] <= 1e-2);
        CHECK_OK(batten_curve_evaluate(common[k], 0, 2, first));
        CHECK_OK(batten_curve_evaluate(common[k], 1, 2, last));
        for (int i = 0; i < 9; i++)
            CHECK_NEAR(last[i], first[i], 1e-9);
        CHECK_OK(batten_curve_evaluate(open[k], domain.a, 0, given));
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(first[c], given[c], 1e-14);
        for (int i = 0; i <= 100; i++) {
            const double s = i / 100.0;
            double p[3], q[3];
            CHECK_OK(batten_curve_evaluate(common[k], s, 0, p));
            CHECK_OK(
                batten_curve_evaluate(open[k], domain.a + s * (domain.b - domain.a), 0, q));
            CHECK(hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]) <= deviation[k]);
        }
    }
    unref_all(N, common);
    unref_all(N, open);
}
