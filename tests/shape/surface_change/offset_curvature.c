#include <batten/offset.h>

#include "support/test.h"

#include <math.h>
#include <string.h>

/* z = ((x - a)^2 + (y - b)^2) / 2 with the lowest point at (u, v) = (a, b). */
static const double LOWEST[2] = {0.25, 0.625};

static batten_surface *paraboloid(void)
{
    static const double knots[6] = {0, 0, 0, 1, 1, 1};
    const double a = LOWEST[0], b = LOWEST[1], x[3] = {0, 0.5, 1};
    const double f[3] = {a * a, a * a - a, (1 - a) * (1 - a)};
    const double g[3] = {b * b, b * b - b, (1 - b) * (1 - b)};
    const batten_axis axis = {2, 3, knots, false};
    double points[27];
    batten_surface *bowl = NULL;
    for (int i = 0; i < 9; i++)
        memcpy(points + 3 * i, (const double[3]){x[i / 3], x[i % 3], (f[i / 3] + g[i % 3]) / 2},
               3 * sizeof *points);
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &bowl));
    return bowl;
}

/* At r from the lowest point the curvatures are (1 + r^2)^(-3/2) and (1 + r^2)^(-1/2): the least at the corner
 * (1, 0), which is farthest. */
TEST(an_offset_reports_the_extreme_curvatures_and_where_the_factor_is_least)
{
    const double r2 = 0.75 * 0.75 + 0.625 * 0.625, least = pow(1 + r2, -1.5);
    for (int outside = 0; outside < 2; outside++) {
        batten_surface_offset_options options = batten_surface_offset_defaults();
        batten_surface_offset_report report;
        batten_surface *bowl = paraboloid(), *made = NULL;
        options.tolerance = 1e-4;
        CHECK_OK(batten_surface_offset(bowl, outside ? -0.5 : 0.5, &options, &report, &made));
        CHECK_NEAR(report.most, 1, 1e-6);
        CHECK_NEAR(report.least, least, 1e-6);
        CHECK_NEAR(report.factor, outside ? 1 + 0.5 * least : 0.5, 1e-6);
        CHECK_NEAR(report.at[0], outside ? 1 : LOWEST[0], 1e-3);
        CHECK_NEAR(report.at[1], outside ? 0 : LOWEST[1], 1e-3);
        CHECK(!report.exact && report.error > 0 && report.error <= 1e-4);
        for (int k = 0; k < 2; k++)
            CHECK(report.turned[k].a > report.turned[k].b);
        batten_surface_unref(made);
        batten_surface_unref(bowl);
    }
}

/* By 1.05 it turns over where 1 + r^2 <= 1.05^2: within 0.3202 of the lowest point. */
TEST(the_box_of_what_turns_over_lies_within_the_true_one_and_holds_the_worst)
{
    const double reach = sqrt(1.05 * 1.05 - 1);
    batten_surface_offset_report report;
    batten_surface *bowl = paraboloid(), *made = NULL;
    CHECK_STATUS(batten_surface_offset(bowl, 1.05, NULL, &report, &made), BATTEN_SINGULAR_HERE);
    CHECK_NEAR(report.factor, -0.05, 1e-6);
    for (int k = 0; k < 2; k++) {
        CHECK(report.turned[k].a >= LOWEST[k] - reach &&
              report.turned[k].b <= LOWEST[k] + reach);
        CHECK(report.turned[k].a <= LOWEST[k] + 1e-3 && report.turned[k].b >= LOWEST[k] - 1e-3);
    }
    CHECK(made == NULL);
    batten_surface_unref(bowl);
}
