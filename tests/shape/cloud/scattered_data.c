/* What scattered data and their options may be. */
#include <batten/scattered.h>

#include "support/test.h"

enum { COUNT_OF_DATA = 16 };

static void change_options(int which, batten_surface_scattered_options *o)
{
    static const double no_weights[COUNT_OF_DATA] = {0};
    if (which < 2)
        o->method = (batten_scattered_method)(which ? BATTEN_SCATTERED_MULTILEVEL + 1 : -1);
    if (which == 2)
        o->degree_u = 1;
    if (which == 3)
        o->degree_v = 10;
    if (which == 4)
        o->spans_v = -2;
    if (which == 5)
        o->spans_u = o->spans_v = 50000;
    if (which == 6 || which == 7)
        o->tolerance = which == 6 ? -0.5 : INFINITY;
    if (which == 8) {
        o->by = BATTEN_SMOOTH_BY_LAMBDA;
        o->amount = -3;
    }
    if (which == 9)
        o->threshold = -1;
    if (which == 10)
        o->most_points = -1;
    if (which == 11)
        o->levels = -1;
    if (which == 12)
        o->levels = 13;
    if (which == 13)
        o->corrections = -1;
    if (which == 14)
        o->weights = no_weights;
}

static const struct {
    batten_status status;
    const char *message;
} refused[] = {
    {BATTEN_BAD_ARGUMENT, "there is no method -1"},
    {BATTEN_BAD_ARGUMENT, "there is no method 2"},
    {BATTEN_BAD_DEGREE, "the degree along u is 1, not 2 to 9"},
    {BATTEN_BAD_DEGREE, "the degree along v is 10, not 2 to 9"},
    {BATTEN_BAD_ARGUMENT, "0 x -2 spans; 0 to "},
    {BATTEN_TOO_LARGE, "50000 x 50000 spans; 0 to "},
    {BATTEN_BAD_ARGUMENT, "the tolerance is -0.5, not 0 or above"},
    {BATTEN_BAD_ARGUMENT, "the tolerance is inf, not 0 or above"},
    {BATTEN_BAD_ARGUMENT, "the amount of smoothing is -3, below 0"},
    {BATTEN_BAD_ARGUMENT,
     "a threshold -1, at most 0 points, 0 levels (12 at most), 20 corrections"},
    {BATTEN_BAD_ARGUMENT, "a threshold 0, at most -1 points, 0 levels"},
    {BATTEN_BAD_ARGUMENT, "at most 0 points, -1 levels (12 at most)"},
    {BATTEN_BAD_ARGUMENT, "at most 0 points, 13 levels (12 at most)"},
    {BATTEN_BAD_ARGUMENT, "0 levels (12 at most), -1 corrections: one is out of bounds"},
    {BATTEN_BAD_WEIGHT, "the sum of all weights is 0"},
};

static void put_data(double *uv, double *z)
{
    for (int i = 0; i < COUNT_OF_DATA; i++) {
        uv[2 * i] = i % 4;
        uv[2 * i + 1] = i / 4;
        z[i] = 1 + i % 4 - 2 * (i / 4);
    }
}

TEST(options_of_scattered_data_out_of_bounds_are_named_with_their_numbers)
{
    double uv[2 * COUNT_OF_DATA], z[COUNT_OF_DATA];
    batten_surface *none = NULL;
    put_data(uv, z);
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        change_options(i, &options);
        CHECK_STATUS(batten_surface_scattered(uv, (batten_points){1, COUNT_OF_DATA, z},
                                              &options, NULL, NULL, &none),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){4, 4, z}, NULL, NULL, NULL, &none),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the dimension is 4, not 1 to 3");
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 2, z}, NULL, NULL, NULL, &none),
        BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there are 2 data, and 3 are needed at least");
    CHECK(!none);
}

/* A plane is met by any method over the box of its data, at their own parameters. */
TEST(a_plane_is_met_over_the_box_of_its_data_or_the_given_domain)
{
    double uv[2 * COUNT_OF_DATA], z[COUNT_OF_DATA], value;
    put_data(uv, z);
    for (int wide = 0; wide < 2; wide++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface_fit_report report;
        batten_surface *surface = NULL;
        if (wide) {
            options.domain[0][0] = -1;
            options.domain[0][1] = 5;
            options.domain[1][0] = -2;
            options.domain[1][1] = 3;
        }
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, COUNT_OF_DATA, z}, &options,
                                          NULL, &report, &surface));
        const batten_interval u = batten_surface_domain(surface, BATTEN_U);
        const batten_interval v = batten_surface_domain(surface, BATTEN_V);
        CHECK(u.a == (wide ? -1 : 0) && u.b == (wide ? 5 : 3));
        CHECK(v.a == (wide ? -2 : 0) && v.b == 3);
        for (int i = 0; i < COUNT_OF_DATA; i++) {
            CHECK_OK(batten_surface_evaluate(surface, uv[2 * i], uv[2 * i + 1], 0, &value));
            CHECK_NEAR(value, z[i], 1e-6);
        }
        CHECK(report.error < 1e-6 && report.rms <= report.error);
        batten_surface_unref(surface);
    }
}
