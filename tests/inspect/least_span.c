/* The shortest spans of surfaces. */
#include <batten/measure.h>

#include "support/test.h"

TEST(the_least_span_is_found_with_its_length)
{
    /* u from 0 to 4 along x, which it follows at twice the speed; the height grows with v. */
    const double knots_u[] = {0, 0, 1, 1.25, 4, 4}, knots_v[] = {0, 0, 1, 1};
    const double x[] = {0, 2, 2.5, 8};
    double points[24];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 2; j++) {
            points[6 * i + 3 * j] = x[i];
            points[6 * i + 3 * j + 1] = j * x[i];
            points[6 * i + 3 * j + 2] = j;
        }
    const batten_axis u = {1, 4, knots_u, false}, v = {1, 2, knots_v, false};
    batten_surface *surface = NULL;
    batten_least_span found;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    CHECK_OK(batten_surface_least_span(surface, BATTEN_U, &found));
    CHECK_NEAR(found.share, 0.0625, 1e-15);
    CHECK_NEAR(found.length, sqrt(0.5), 1e-14); /* at v = 1, the longest line */
    CHECK_NEAR(found.from, 1, 0);
    CHECK_NEAR(found.to, 1.25, 0);
    CHECK_NEAR(found.total, 8 * sqrt(2), 1e-13);
    CHECK_OK(batten_surface_least_span(surface, BATTEN_V, &found));
    CHECK_NEAR(found.share, 1, 0);
    CHECK_NEAR(found.length, hypot(8, 1), 1e-13);
    batten_surface_unref(surface);
}
