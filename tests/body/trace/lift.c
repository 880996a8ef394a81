#include "body/trace/lift.h"
#include "support/test.h"

#include <batten/standard.h>

static batten_surface *cylinder(void)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_cylinder(&frame, 2, 5, &surface));
    return surface;
}

/* Where the curve is off S(B) at most, at `count` places. */
static double miss_of(const batten_surface *surface, const batten_curve *parameters,
                      const batten_curve *curve, int count)
{
    const batten_interval domain = batten_curve_domain(parameters);
    double worst = 0;
    for (int i = 0; i <= count; i++) {
        const double t = domain.a + (domain.b - domain.a) * i / count;
        double uv[2], s[3], c[3];
        CHECK_OK(batten_curve_evaluate(parameters, t, 0, uv));
        CHECK_OK(batten_surface_evaluate(surface, uv[0], uv[1], 0, s));
        CHECK_OK(batten_curve_evaluate(curve, t, 0, c));
        worst = fmax(worst, hypot(hypot(s[0] - c[0], s[1] - c[1]), s[2] - c[2]));
    }
    return worst;
}

TEST(lines_along_the_parameters_are_lifted_exactly)
{
    batten_surface *surface = cylinder();
    const double lines[][4] = {
        {0.1, 0.25, 0.9, 0.25}, {0.9, 0.5, 0.1, 0.5}, {0.3, 0, 0.3, 1}, {0.3, 1, 0.3, 0.25}};
    for (int i = 0; i < COUNT(lines); i++) {
        const batten_interval u = batten_surface_domain(surface, BATTEN_U);
        const batten_interval v = batten_surface_domain(surface, BATTEN_V);
        const double p[] = {u.a + lines[i][0] * (u.b - u.a), v.a + lines[i][1] * (v.b - v.a),
                            u.a + lines[i][2] * (u.b - u.a), v.a + lines[i][3] * (v.b - v.a)};
        const double knots[] = {3, 3, 7, 7};
        batten_curve *line = NULL, *curve = NULL;
        double error = -1;
        CHECK_OK(batten_curve_create((batten_points){2, 2, p}, 1, NULL, knots, &line));
        CHECK_OK(bat_lift(surface, line, 1e-9, &curve, &error));
        CHECK_BITS(error, 0);
        CHECK(miss_of(surface, line, curve, 50) < 1e-14);
        CHECK_NEAR(batten_curve_domain(curve).b, 7, 0);
        batten_curve_unref(line);
        batten_curve_unref(curve);
    }
    batten_surface_unref(surface);
}

TEST(any_curve_on_a_surface_is_lifted_within_the_tolerance)
{
    batten_surface *surface = cylinder();
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    /* A zigzag over the cylinder, with a corner. */
    const double share[] = {0, 0, 0.4, 1, 1, 0.2};
    double p[6];
    for (int i = 0; i < 3; i++) {
        p[2 * i] = u.a + share[2 * i] * (u.b - u.a);
        p[2 * i + 1] = v.a + share[2 * i + 1] * (v.b - v.a);
    }
    batten_curve *zigzag = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, p}, &zigzag));
    const double tolerances[] = {1e-2, 1e-4, 1e-7};
    for (int i = 0; i < COUNT(tolerances); i++) {
        batten_curve *curve = NULL;
        double error = 0;
        CHECK_OK(bat_lift(surface, zigzag, tolerances[i], &curve, &error));
        CHECK(error <= tolerances[i] && error > 0);
        CHECK(miss_of(surface, zigzag, curve, 500) <= 1.2 * tolerances[i]);
        batten_curve_unref(curve);
    }
    batten_curve_unref(zigzag);
    batten_surface_unref(surface);
}

TEST(N6_a_tolerance_of_nothing_is_refused)
{
    batten_surface *surface = cylinder();
    const double p[] = {0, 0, 1, 1};
    batten_curve *line = NULL, *curve = NULL;
    CHECK_OK(batten_curve_line(2, p, p + 2, &line));
    CHECK_STATUS(bat_lift(surface, line, 0, &curve, NULL), BATTEN_BAD_ARGUMENT);
    const double out[] = {-5, 0, 1, 1};
    batten_curve *outside = NULL;
    CHECK_OK(batten_curve_line(2, out, out + 2, &outside));
    CHECK_STATUS(bat_lift(surface, outside, 1e-3, &curve, NULL), BATTEN_OUT_OF_DOMAIN);
    CHECK(!curve);
    batten_curve_unref(outside);
    batten_curve_unref(line);
    batten_surface_unref(surface);
}
