#include <batten/offset.h>

#include "support/test.h"

#include <string.h>

/* z = ((x - a)^2 + (y - b)^2) / 2 bends most, by 1, at its lowest point (a, b) = (u, v). */
TEST(the_place_of_the_least_factor_is_reported)
{
    static const double knots[6] = {0, 0, 0, 1, 1, 1};
    const double a = 0.25, b = 0.625, x[3] = {0, 0.5, 1};
    const double f[3] = {a * a, a * a - a, (1 - a) * (1 - a)};
    const double g[3] = {b * b, b * b - b, (1 - b) * (1 - b)};
    const batten_axis axis = {2, 3, knots, false};
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface_offset_report report;
    batten_surface *bowl = NULL, *made = NULL;
    double points[27];
    for (int i = 0; i < 9; i++)
        memcpy(points + 3 * i, (const double[3]){x[i / 3], x[i % 3], (f[i / 3] + g[i % 3]) / 2},
               3 * sizeof *points);
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &bowl));
    options.tolerance = 1e-4;
    CHECK_OK(batten_surface_offset(bowl, 0.5, &options, &report, &made));
    CHECK_NEAR(report.at[0], a, 1e-3);
    CHECK_NEAR(report.at[1], b, 1e-3);
    CHECK_NEAR(report.factor, 0.5, 1e-6);
    CHECK_NEAR(report.most, 1, 1e-6);
    batten_surface_unref(made);
    batten_surface_unref(bowl);
}
