/* Points that a corner parts (fair_points.c). */
#include "support/test.h"

#include <batten/fair.h>
#include <math.h>

/* A corner at MIDDLE parts the points: either side is faired as it would be alone. */
enum { MIDDLE = 14, LAST = 33 };

static void fair_range(int d, int first, int last, const double *points,
                       const batten_fair_options *options, double *z)
{
    double t[LAST + 1], within[LAST + 1];
    batten_fair_options own = *options;
    for (int i = first; i <= last; i++) {
        t[i - first] = i + 0.3 * (i % 3);
        within[i - first] = 0.01 * (2 + i % 5);
    }
    own.within_each = within;
    CHECK_OK(batten_fair_points((batten_points){d, last - first + 1, points + d * first}, t,
                                &own, NULL, NULL, z));
}

TEST(pieces_beside_a_corner_are_faired_as_each_would_be_alone)
{
    static const batten_fair_order orders[] = {BATTEN_FAIR_WORST_FIRST, BATTEN_FAIR_SWEEPS,
                                               BATTEN_FAIR_ALTERNATE};
    static const int corner[] = {MIDDLE};
    test_random random = test_random_begin("pieces");
    for (int k = 0; k < 18; k++) {
        const int d = 1 + k % 3;
        double points[3 * (LAST + 1)], whole[3 * (LAST + 1)], part[3 * (LAST + 1)];
        batten_fair_options options = batten_fair_defaults(0.1);
        options.order = orders[k / 3 % 3];
        options.stop_when_fair = k >= 9;
        for (int i = 0; i < d * (LAST + 1); i++) {
            const int n = i / d;
            points[i] = (i % d + 1) * fabs((double)n - MIDDLE) +
                        (i % d == 0 && d > 1 ? 5 * n : 0) +
                        0.03 * test_random_in(&random, -1, 1);
        }
        fair_range(d, 0, MIDDLE, points, &options, part);
        fair_range(d, MIDDLE, LAST, points, &options, part + d * MIDDLE);
        options.corners = corner;
        options.corner_count = 1;
        fair_range(d, 0, LAST, points, &options, whole);
        for (int i = 0; i < d * (LAST + 1); i++)
            CHECK_NEAR(whole[i], part[i], 1e-12);
    }
}
