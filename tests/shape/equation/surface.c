#include <batten/contours.h>

#include "support/generate.h"
#include "support/test.h"

static const char *const variables[] = {"u", "v"};
static const batten_equation_names names = {2, 0, variables, NULL};

static const struct {
    const char *text[3];
    batten_interval range[2];
    double tolerance;
    batten_status status;
    const char *says;
} rows[] = {
    {{"u", "v", "u*v"}, {{-1, 1}, {-1, 1}}, 1e-9, BATTEN_OK, NULL},
    {{"u", "v", "sin(3*u)*exp(v)"}, {{0, 2}, {-1, 1}}, 1e-6, BATTEN_OK, NULL},
    {{"(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)"},
     {{0, 6.3}, {0, 3}},
     1e-6,
     BATTEN_OK,
     NULL},
    {{"u", "v", "abs(u - 0.3)"},
     {{-1, 1}, {0, 1}},
     1e-6,
     BATTEN_TOLERANCE_NOT_MET,
     "has the surface a corner"},
    {{"u", "v", "1/(u + v)"},
     {{0, 1}, {0, 1}},
     1e-6,
     BATTEN_OUT_OF_DOMAIN,
     "no finite value at (0, 0)"},
    {{"u", "v", "u"},
     {{0, 0}, {0, 1}},
     1e-6,
     BATTEN_BAD_ARGUMENT,
     "the range of u from 0 to 0 is empty"},
};

TEST(surfaces_are_within_the_error_that_was_proved_or_refused)
{
    test_random random = test_random_begin("parameters");
    for (int i = 0; i < COUNT(rows); i++) {
        batten_equation *read[3] = {NULL, NULL, NULL};
        batten_surface *surface = NULL;
        double error = 0;
        for (int k = 0; k < 3; k++)
            CHECK_OK(batten_equation_read(rows[i].text[k], &names, &read[k]));
        CHECK_STATUS(batten_surface_parametric((const batten_equation *const *)read,
                                               rows[i].range, rows[i].tolerance, NULL, &error,
                                               &surface),
                     rows[i].status);
        if (rows[i].says)
            CHECK_MESSAGE(rows[i].says);
        for (int n = 0; n < 3000 && surface; n++) {
            const double at[] = {
                test_random_in(&random, rows[i].range[0].a, rows[i].range[0].b),
                test_random_in(&random, rows[i].range[1].a, rows[i].range[1].b)};
            double p[3], value, sum = 0;
            CHECK_OK(batten_surface_evaluate(surface, at[0], at[1], 0, p));
            for (int k = 0; k < 3; k++) {
                CHECK_OK(batten_equation_value(read[k], at, &value, NULL));
                sum += (p[k] - value) * (p[k] - value);
            }
            CHECK(sqrt(sum) <= error && error <= rows[i].tolerance);
        }
        batten_surface_unref(surface);
        for (int k = 0; k < 3; k++)
            batten_equation_free(read[k]);
    }
}

TEST(coordinates_and_ranges_of_surfaces_are_checked_with_their_numbers)
{
    static const char *const one[] = {"u"};
    const batten_equation_names line = {1, 0, one, NULL};
    batten_equation *good = NULL, *bad = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_equation_read("u + v", &names, &good));
    CHECK_OK(batten_equation_read("u", &line, &bad));
    const struct {
        const batten_equation *third;
        batten_interval range[2];
        double tolerance;
        batten_status status;
        const char *says;
    } refused[] = {
        {bad,
         {{0, 1}, {0, 1}},
         1,
         BATTEN_BAD_ARGUMENT,
         "coordinate 3 has 1 variables, expected 2"},
        {good, {{0, INFINITY}, {0, 1}}, 1, BATTEN_NOT_FINITE, "the range of u is not finite"},
        {good, {{0, 1}, {NAN, 1}}, 1, BATTEN_NOT_FINITE, "the range of v is not finite"},
        {good, {{0, 1}, {3, 2}}, 1, BATTEN_BAD_ARGUMENT, "the range of v from 3 to 2 is empty"},
        {good,
         {{0, 1}, {0, 1}},
         0,
         BATTEN_BAD_ARGUMENT,
         "the tolerance must be above 0, not 0"},
        {good,
         {{0, 1}, {0, 1}},
         INFINITY,
         BATTEN_BAD_ARGUMENT,
         "the tolerance must be above 0, not inf"},
    };
    for (int i = 0; i < COUNT(refused); i++) {
        const batten_equation *const three[] = {good, good, refused[i].third};
        CHECK_STATUS(batten_surface_parametric(three, refused[i].range, refused[i].tolerance,
                                               NULL, NULL, &surface),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].says);
    }
    CHECK(!surface);
    batten_equation_free(good);
    batten_equation_free(bad);
}
