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
     "161 x 161 points prove no error below 1e-06; has the surface a corner"},
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

/* u^6 through the points 0, 1/5 ... 1 misses the product of u less them; interpolation of degree 5 at the
 * Chebyshev nodes of [0, 1] leaves 1 / 2^11 of u^6. */
static double missed_at_nodes(void)
{
    double worst = 0;
    for (int i = 0; i < 6; i++) {
        double product = 1;
        for (int k = 0; k <= 5; k++)
            product *= 0.5 - 0.5 * cos((2 * i + 1) * 3.14159265358979323846 / 12) - k / 5.0;
        worst = fmax(worst, fabs(product));
    }
    return worst;
}

static const struct {
    const char *third;
    double tolerance, u, v,
        off; /* how often the two bounds count, and what is missed at nodes */
    int count[2];
} bounds[] = {
    {"u^6", 0.1, 1, 0, 1, {6, 6}},
    {"v^6", 0.1, 0, 1, 1, {6, 6}},
    {"u^6 + v^6", 0.1, 1, 1, 2, {6, 6}},
    {"u^5*v^5", 0.1, 0, 0, 0, {6, 6}},
    {"u^6", 5e-4, -1, 0, 0, {11, 6}},
    {"v^6", 5e-4, 0, -1, 0, {6, 11}},
    {"u^6 + v^6", 5e-4, -1, -1, 0, {11, 11}},
    {"u^6 + v^6/9", 5e-4, -1, -1, 0, {11, 6}},
    {"u^6/9 + v^6", 5e-4, -1, -1, 0, {6, 11}},
};

TEST(the_error_of_a_surface_is_the_bounds_of_both_directions_and_what_is_missed_at_nodes)
{
    const batten_interval unit[] = {{0, 1}, {0, 1}};
    batten_equation *read[3] = {NULL, NULL, NULL};
    CHECK_OK(batten_equation_read("u", &names, &read[0]));
    CHECK_OK(batten_equation_read("v", &names, &read[1]));
    for (int i = 0; i < COUNT(bounds); i++) {
        batten_surface *surface = NULL;
        double error = -1;
        CHECK_OK(batten_equation_read(bounds[i].third, &names, &read[2]));
        CHECK_OK(batten_surface_parametric((const batten_equation *const *)read, unit,
                                           bounds[i].tolerance, NULL, &error, &surface));
        const double lebesgue = 2.11, left = 1.0 / 2048;
        const double all = bounds[i].u * left + bounds[i].v * lebesgue * left +
                           lebesgue * lebesgue * bounds[i].off * missed_at_nodes();
        if (bounds[i].u >= 0 && bounds[i].v >= 0)
            CHECK_NEAR(error, all, 1e-13);
        CHECK(error <= bounds[i].tolerance);
        CHECK_INT(batten_surface_degree(surface, BATTEN_U), 5);
        CHECK_INT(batten_surface_degree(surface, BATTEN_V), 5);
        CHECK_INT(batten_surface_point_count(surface, BATTEN_U), bounds[i].count[0]);
        CHECK_INT(batten_surface_point_count(surface, BATTEN_V), bounds[i].count[1]);
        batten_surface_unref(surface);
        batten_equation_free(read[2]);
    }
    batten_equation_free(read[0]);
    batten_equation_free(read[1]);
}

TEST(a_surface_without_a_value_is_refused_with_its_place)
{
    static const struct {
        const char *third;
        batten_status status;
        const char *says;
    } refused[] = {
        {"1/(u + v - 0.5)", BATTEN_OUT_OF_DOMAIN, "there is no finite value at (0, 0.5); take"},
        {"ln(0.9 - u)", BATTEN_OUT_OF_DOMAIN,
         "there is no finite value at (1, -2); take ranges"},
    };
    const batten_interval ranges[] = {{0, 0.5}, {-2, 0.5}};
    batten_equation *read[3] = {NULL, NULL, NULL};
    CHECK_OK(batten_equation_read("u", &names, &read[0]));
    CHECK_OK(batten_equation_read("v", &names, &read[1]));
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface *none = NULL;
        double error = -1;
        const batten_interval range[] = {{0, 1}, ranges[i]};
        CHECK_OK(batten_equation_read(refused[i].third, &names, &read[2]));
        CHECK_STATUS(batten_surface_parametric((const batten_equation *const *)read, range,
                                               1e-6, NULL, &error, &none),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].says);
        CHECK(!none && error == -1);
        batten_equation_free(read[2]);
    }
    batten_equation_free(read[0]);
    batten_equation_free(read[1]);
}

static bool stop(void *user)
{
    return --*(int *)user < 0;
}

TEST(a_job_ends_a_surface_of_equations)
{
    const batten_interval unit[] = {{0, 1}, {0, 1}};
    batten_equation *read[3] = {NULL, NULL, NULL};
    static const char *const texts[] = {"u", "v", "sin(9*u)*v"};
    for (int k = 0; k < 3; k++)
        CHECK_OK(batten_equation_read(texts[k], &names, &read[k]));
    for (int i = 0; i < 2; i++) {
        batten_surface *none = NULL;
        double error = -1;
        int left = 0;
        batten_job job = BATTEN_JOB;
        job.user = &left;
        job.is_cancelled = i ? stop : NULL;
        job.work_limit = i ? 0 : 1;
        CHECK_STATUS(batten_surface_parametric((const batten_equation *const *)read, unit, 1e-9,
                                               &job, &error, &none),
                     i ? BATTEN_CANCELLED : BATTEN_INCOMPLETE);
        CHECK(!none && error == -1);
    }
    for (int k = 0; k < 3; k++)
        batten_equation_free(read[k]);
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
