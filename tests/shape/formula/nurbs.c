/* Splines near surfaces that are formulas. */
#include "shape/formula/nurbs.h"
#include "shape/formula/formula.h"
#include "support/test.h"

#include <batten/surface.h>

static void keep(void *data)
{
    (void)data;
}

typedef double (*height)(double u, double v);

static batten_status graph(const void *data, const bat_surface_place *at, int order,
                           double *out)
{
    const double u = at->u, v = at->v;
    memset(out, 0, 3 * (size_t)BATTEN_SURFACE_DERIVATIVES(order) * sizeof *out);
    out[0] = u;
    out[1] = v;
    out[2] = (*(const height *)data)(u, v);
    return BATTEN_OK;
}

static double quintic(double u, double v)
{
    return 1 + u * u * u * u * u - 3 * u * v * v * v * v * v + v * v;
}

static double kinked(double u, double v)
{
    return fabs(u - 0.4) + v;
}

/* u^2 on one side of 0.4, its tangent on the other: of class C1 */
static double bent(double u, double v)
{
    return (u > 0.4 ? u * u : 0.8 * u - 0.16) + v;
}

static double waves(double u, double v)
{
    return sin(9 * u) * cos(5 * v);
}

static double ripples(double u, double v)
{
    return sin(70 * u) * cos(70 * v);
}

static double jump(double u, double v)
{
    return (u + v > 0.7123) + v;
}

/* Over [0, 1]^2 with a break at u = 0.4 when `broken`. */
static batten_surface *graph_of(height *f, bool broken, int smoothness)
{
    static const double two[] = {0, 1}, three[] = {0, 0.4, 1};
    const bat_formula formula = {"graph", graph, NULL, keep};
    const bat_formula_axis u = {broken ? 3 : 2, broken ? three : two, smoothness};
    const bat_formula_axis v = {2, two, 2};
    batten_surface *surface = NULL;
    CHECK_OK(bat_formula_create(&formula, f, 3, &u, &v, 2, &surface));
    return surface;
}

static double farthest(const batten_surface *a, const batten_surface *b)
{
    double worst = 0;
    for (int i = 0; i <= 60; i++)
        for (int j = 0; j <= 60; j++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(a, i / 60.0, j / 60.0, 0, p));
            CHECK_OK(batten_surface_evaluate(b, i / 60.0, j / 60.0, 0, q));
            worst = fmax(worst, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
        }
    return worst;
}

TEST(a_polynomial_of_degree_five_is_one_patch)
{
    height f = quintic;
    batten_surface *surface = graph_of(&f, false, 2), *made = NULL;
    double error = -1;
    CHECK_OK(bat_surface_approximate(surface, 1e-12, 36, &made, &error));
    CHECK_INT(batten_surface_point_count(made, BATTEN_U), 6);
    CHECK_INT(batten_surface_point_count(made, BATTEN_V), 6);
    CHECK(error >= 0 && error < 1e-13);
    CHECK(farthest(surface, made) < 1e-13);
    batten_surface_unref(made);
    /* A point fewer is not enough, and the error may stay unknown. */
    made = NULL;
    CHECK_STATUS(bat_surface_approximate(surface, 1e-12, 35, &made, &error),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("6 x 6 control points");
    CHECK(!made);
    CHECK_OK(bat_surface_approximate(surface, 1e-12, 36, &made, NULL));
    batten_surface_unref(made);
    batten_surface_unref(surface);
}

TEST(a_break_has_the_multiplicity_of_its_smoothness)
{
    height f[2] = {kinked, bent};
    for (int smoothness = 0; smoothness < 2; smoothness++) {
        batten_surface *surface = graph_of(&f[smoothness], true, smoothness), *made = NULL;
        double error = -1;
        CHECK_OK(bat_surface_approximate(surface, 1e-12, 1000, &made, &error));
        CHECK_INT(batten_surface_point_count(made, BATTEN_U), 11 - smoothness);
        CHECK_INT(batten_surface_point_count(made, BATTEN_V), 6);
        const double *knots = batten_surface_knots(made, BATTEN_U);
        for (int i = 0; i < 5 - smoothness; i++)
            CHECK_BITS(knots[6 + i], 0.4);
        CHECK_BITS(knots[11 - smoothness], 1);
        CHECK(farthest(surface, made) < 1e-13);
        batten_surface_unref(made);
        batten_surface_unref(surface);
    }
}

TEST(the_error_of_a_spline_holds_between_its_probes_and_falls_by_the_sixth_power)
{
    height f = waves;
    batten_surface *surface = graph_of(&f, false, 2);
    int last = 0;
    for (int e = 3; e <= 9; e += 3) {
        batten_surface *made = NULL;
        double error = -1;
        CHECK_OK(bat_surface_approximate(surface, pow(10, -e), 100000, &made, &error));
        CHECK(error <= pow(10, -e) && farthest(surface, made) <= error);
        const int count = batten_surface_point_count(made, BATTEN_U);
        /* A thousandth takes 1000^(1/6) = 3.2 times the spans: two halvings at most. */
        CHECK(last == 0 || (count > last && count - 5 <= 4 * (last - 5)));
        last = count;
        batten_surface_unref(made);
    }
    batten_surface_unref(surface);
}

TEST(spans_are_halved_where_the_surface_needs_it_and_nowhere_else)
{
    height f = kinked; /* without its break */
    batten_surface *surface = graph_of(&f, false, 2), *made = NULL;
    CHECK_OK(bat_surface_approximate(surface, 1e-3, 100000, &made, NULL));
    CHECK_INT(batten_surface_point_count(made, BATTEN_V), 6);
    double spans[200];
    const int count = batten_surface_spans(made, BATTEN_U, spans);
    CHECK(count > 5 && count < 60);
    for (int i = 0; i + 1 < count; i++) /* short ones are beside the kink */
        if (spans[i + 1] - spans[i] < 0.01)
            CHECK(fabs(spans[i] - 0.4) < 0.06);
    CHECK(farthest(surface, made) <= 1e-3);
    batten_surface_unref(made);
    batten_surface_unref(surface);
}

TEST(a_surface_that_jumps_is_given_up_early)
{
    height f = jump;
    batten_surface *surface = graph_of(&f, false, 2), *made = NULL;
    CHECK_STATUS(bat_surface_approximate(surface, 1e-6, 1000000, &made, NULL),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("graph surface");
    CHECK(!made);
    batten_surface_unref(surface);
}

TEST(short_waves_are_not_given_up_before_they_are_found)
{
    height f =
        ripples; /* eleven periods: the errors of the first few hundred points do not fall */
    batten_surface *surface = graph_of(&f, false, 2), *made = NULL;
    CHECK_OK(bat_surface_approximate(surface, 1e-3, 1000000, &made, NULL));
    CHECK(farthest(surface, made) <= 1e-3);
    CHECK(batten_surface_point_count(made, BATTEN_U) < 150);
    batten_surface_unref(made);
    batten_surface_unref(surface);
}

TEST(isocurves_keep_the_break_of_the_direction_that_they_follow)
{
    height f = kinked;
    batten_surface *surface = graph_of(&f, true, 0);
    batten_curve *across = NULL, *along = NULL;
    CHECK_OK(batten_surface_isocurve(surface, BATTEN_V, 0.25, &along));
    CHECK_OK(batten_surface_isocurve(surface, BATTEN_U, 0.25, &across));
    CHECK_INT(batten_curve_point_count(along), 11);
    CHECK_INT(batten_curve_point_count(across), 6);
    for (int i = 0; i <= 50; i++) {
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate(along, i / 50.0, 0, p));
        CHECK_OK(batten_curve_evaluate(across, i / 50.0, 0, q));
        CHECK_NEAR(p[0], i / 50.0, 1e-13);
        CHECK_NEAR(p[1], 0.25, 1e-13);
        CHECK_NEAR(p[2], kinked(i / 50.0, 0.25), 1e-13);
        CHECK_NEAR(q[2], kinked(0.25, i / 50.0), 1e-13);
    }
    CHECK_STATUS(batten_surface_isocurve(surface, BATTEN_U, 1.5, &across),
                 BATTEN_OUT_OF_DOMAIN);
    batten_curve_unref(across);
    batten_curve_unref(along);
    batten_surface_unref(surface);
}
