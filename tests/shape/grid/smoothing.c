/* What the options of grid fits may be, and what smoothing leaves as it is. */
#include <batten/grid.h>

#include "support/test.h"

enum { NU = 9, NV = 7 };

static void change_options(int which, batten_surface_fit_grid_options *o)
{
    o->by = BATTEN_SMOOTH_BY_LAMBDA;
    if (which == 0 || which == 1)
        o->order = which == 0 ? 0 : 5;
    if (which == 2 || which == 3)
        o->amount = which == 2 ? -1 : (double)NAN;
    if (which == 4)
        o->points_v = 1000000;
    if (which == 5)
        o->degree_u = 0;
    if (which == 6)
        o->degree_v = BATTEN_MAX_DEGREE + 1;
    if (which == 7)
        o->tolerance = -1;
    if (which == 8)
        o->tolerance = INFINITY;
}

static const struct {
    batten_status status;
    const char *message;
} refused[] = {
    {BATTEN_BAD_ARGUMENT, "the order of the penalty is 0, not 1 to 4"},
    {BATTEN_BAD_ARGUMENT, "the order of the penalty is 5, not 1 to 4"},
    {BATTEN_BAD_ARGUMENT, "the amount of smoothing is -1, below 0"},
    {BATTEN_BAD_ARGUMENT, "the amount of smoothing is nan, below 0"},
    {BATTEN_TOO_LARGE, "1000000 control points in one direction; the limit is "},
    {BATTEN_BAD_DEGREE, "the degree along u is 0, not 1 to "},
    {BATTEN_BAD_DEGREE, "the degree along v is "},
    {BATTEN_BAD_ARGUMENT, "the tolerance is -1, not 0 or above"},
    {BATTEN_BAD_ARGUMENT, "the tolerance is inf, not 0 or above"},
};

TEST(options_of_grid_fits_out_of_bounds_are_named_with_their_numbers)
{
    double z[NU * NV];
    batten_surface *none = NULL;
    for (int i = 0; i < NU * NV; i++)
        z[i] = i % 5;
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
        change_options(i, &options);
        CHECK_STATUS(
            i < 5 ? batten_surface_smooth_grid((batten_grid){1, NU, NV, z}, &options, NULL,
                                               (batten_uv_out){NULL, NULL}, NULL, &none)
                  : batten_surface_fit_grid((batten_grid){1, NU, NV, z}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &none),
            refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    CHECK(!none);
}

/* The penalty of order k is 0 for degrees below k in either parameter, so these stay, whatever
 * its weight. */
TEST(polynomials_below_the_order_of_the_penalty_are_not_smoothed)
{
    for (int order = 1; order <= 4; order++) {
        batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
        batten_surface *surface = NULL;
        double z[NU * NV], u[NU], v[NV];
        for (int i = 0; i < NU; i++)
            for (int j = 0; j < NV; j++)
                z[i * NV + j] =
                    1 + pow(i / (NU - 1.0), order - 1) - 2 * pow(j / (NV - 1.0), order - 1);
        options.order = order;
        options.parameters = BATTEN_UNIFORM;
        options.by = BATTEN_SMOOTH_BY_LAMBDA;
        options.amount = 1e3;
        options.degree_u = options.degree_v = 4;
        CHECK_OK(batten_surface_smooth_grid((batten_grid){1, NU, NV, z}, &options, NULL,
                                            (batten_uv_out){u, v}, NULL, &surface));
        for (int i = 0; i < NU; i++)
            for (int j = 0; j < NV; j++) {
                double value;
                CHECK_OK(batten_surface_evaluate(surface, u[i], v[j], 0, &value));
                CHECK_NEAR(value, z[i * NV + j], 1e-7);
            }
        batten_surface_unref(surface);
    }
}

/* A plane with one datum that is far off and does not count. */
TEST(data_of_no_weight_are_no_data_of_the_report)
{
    double z[NU * NV], rows[NU], none[NU] = {0};
    for (int i = 0; i < NU * NV; i++)
        z[i] = 2 * (i / NV) - 3 * (i % NV) + (i / NV == 4 ? 1000 : 0);
    for (int i = 0; i < NU; i++)
        rows[i] = i == 4 ? 0 : 1;
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    batten_surface_fit_report report;
    batten_surface *s = NULL;
    options.parameters = BATTEN_UNIFORM;
    options.points_u = options.points_v = 4;
    options.weights_u = rows;
    CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, z}, &options, NULL,
                                     (batten_uv_out){NULL, NULL}, &report, &s));
    CHECK(report.error < 1e-11 && report.rms < 1e-11 && report.most < 1e-11);
    batten_surface_unref(s);
    s = NULL;
    options.weights_u = none;
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    CHECK_STATUS(batten_surface_smooth_grid((batten_grid){1, NU, NV, z}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("control point 1 has no grid line of its own");
    CHECK(!s);
}
