#include <batten/curvature.h>
#include <batten/offset.h>
#include <batten/standard.h>

#include "support/faults.h"
#include "support/surfaces.h"

#include <stdio.h>

static batten_surface *make_sphere(double radius)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_sphere(&frame, radius, &surface));
    return surface;
}

/* A bicubic dome with two spans each way, of the size `scale`. */
static batten_surface *make_dome(double scale)
{
    const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    double points[75];
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            const double x = i / 4.0, y = j / 4.0;
            const double p[] = {x + 0.05 * y * y, y - 0.04 * x,
                                0.6 * x * (1 - x) + 0.3 * y * y};
            for (int c = 0; c < 3; c++)
                points[15 * i + 3 * j + c] = scale * p[c];
        }
    const batten_axis axis = {3, 5, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

/* Is the offset exact, and the same as `wanted` at equal parameters? */
static void check_exact(const batten_surface *surface, double distance,
                        const batten_surface *wanted, double tolerance)
{
    batten_surface_offset_report report;
    batten_surface *made = NULL;
    CHECK_EACH_ALLOCATION(batten_surface_offset(surface, distance, NULL, &report, &made));
    CHECK(report.exact && report.error == 0 && report.factor > 0);
    check_same_shape(made, wanted, tolerance);
    batten_surface_unref(made);
}

TEST(the_offset_of_a_sphere_is_a_sphere)
{
    const double distances[] = {0.5, -0.75, 3};
    batten_surface *sphere = make_sphere(2);
    for (int i = 0; i < COUNT(distances); i++) {
        batten_surface *wanted = make_sphere(2 + distances[i]);
        check_exact(sphere, distances[i], wanted, 1e-12);
        batten_surface_unref(wanted);
    }
    batten_surface_unref(sphere);
}

TEST(the_offsets_of_cylinders_and_tori_are_such)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *torus = NULL, *fat = NULL, *pipe = NULL, *wide = NULL;
    CHECK_OK(batten_surface_torus(&frame, 3, 1, &torus));
    CHECK_OK(batten_surface_torus(&frame, 3, 1.25, &fat));
    CHECK_OK(batten_surface_cylinder(&frame, 1, 4, &pipe));
    CHECK_OK(batten_surface_cylinder(&frame, 1.5, 4, &wide));
    check_exact(torus, 0.25, fat, 1e-12);
    check_exact(pipe, 0.5, wide, 1e-12);
    batten_surface_unref(torus);
    batten_surface_unref(fat);
    batten_surface_unref(pipe);
    batten_surface_unref(wide);
}

/* The offset of a cone of half angle a by d: radius + d cos a, height - d sin a; its apex is a
 * circle. */
TEST(the_offset_of_a_cone_is_a_cone)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *cone = NULL, *made = NULL;
    batten_surface_offset_report report;
    CHECK_OK(batten_surface_cone(&frame, 3, 0, 4, &cone));
    CHECK_EACH_ALLOCATION(batten_surface_offset(cone, 0.5, NULL, &report, &made));
    CHECK(report.exact);
    for (int i = 0; i < 40; i++) {
        double p[3];
        const double v = i % 8 / 7.0;
        CHECK_OK(batten_surface_evaluate(made, i / 39.0, v, 0, p));
        CHECK_NEAR(p[2], 4 * v + 0.5 * 0.6, 1e-12);
        CHECK_NEAR(hypot(p[0], p[1]), 3 * (1 - v) + 0.5 * 0.8, 1e-12);
    }
    batten_surface_unref(cone);
    batten_surface_unref(made);
}

/* Derivatives of the kind "offset" against differences, poles too. */
TEST(the_derivatives_of_an_offset_are_its_own)
{
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface *dome = make_dome(1), *made = NULL;
    batten_surface_offset_report report;
    options.tolerance = 0;
    CHECK_OK(batten_surface_offset(dome, 0.1, &options, &report, &made));
    CHECK(!report.exact);
    CHECK_TEXT(batten_surface_kind(made), "offset");
    const double h = 1e-5;
    for (int i = 0; i < 30; i++) {
        const double u = 0.03 + i / 32.0, v = 0.89 - i / 40.0;
        double at[30], plus[30], minus[30], alone[3];
        CHECK_OK(batten_surface_evaluate(made, u, v, 3, at));
        CHECK_OK(batten_surface_evaluate(made, u, v, 0, alone)); /* a way of its own */
        for (int c = 0; c < 3; c++)
            CHECK_BITS(alone[c], at[c]);
        for (int k = 0; k < 2; k++) {
            CHECK_OK(batten_surface_evaluate(made, u + (k ? 0 : h), v + (k ? h : 0), 3, plus));
            CHECK_OK(batten_surface_evaluate(made, u - (k ? 0 : h), v - (k ? h : 0), 3, minus));
            for (int order = 0; order < 3; order++)
                for (int l = 0; l <= order; l++)
                    for (int c = 0; c < 3; c++) {
                        const int from = BATTEN_SURFACE_DERIVATIVE(order - l, l);
                        const int to = BATTEN_SURFACE_DERIVATIVE(order - l + !k, l + k);
                        CHECK_NEAR((plus[3 * from + c] - minus[3 * from + c]) / (2 * h),
                                   at[3 * to + c], 2e-6 * (1 + fabs(at[3 * to + c])));
                    }
        }
    }
    batten_surface_unref(dome);
    batten_surface_unref(made);
}

/* kappa / (1 - d kappa). */
TEST(curvatures_of_an_offset_follow_those_of_the_surface)
{
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface *dome = make_dome(1), *made = NULL;
    const double d = -0.2;
    options.tolerance = 0;
    CHECK_OK(batten_surface_offset(dome, d, &options, NULL, &made));
    for (int i = 0; i < 50; i++) {
        const double u = (i + 0.5) / 50, v = fmod(0.37 * i, 1);
        batten_surface_local a, b;
        CHECK_OK(batten_surface_local_at(dome, u, v, &a));
        CHECK_OK(batten_surface_local_at(made, u, v, &b));
        CHECK_NEAR(b.kappa1, a.kappa1 / (1 - d * a.kappa1), 1e-11);
        CHECK_NEAR(b.kappa2, a.kappa2 / (1 - d * a.kappa2), 1e-11);
        CHECK_NEAR(b.normal.z, a.normal.z, 1e-13);
    }
    batten_surface_unref(dome);
    batten_surface_unref(made);
}

TEST(there_and_back_is_where_it_began)
{
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface *dome = make_dome(1), *there = NULL, *back = NULL;
    batten_surface_offset_report report, second;
    options.tolerance = 1e-7;
    CHECK_OK(batten_surface_offset(dome, 0.15, &options, &report, &there));
    CHECK_OK(batten_surface_offset(there, -0.15, &options, &second, &back));
    CHECK(report.error <= 1e-7 && second.error <= 1e-7);
    for (int i = 0; i < 60; i++) {
        const double u = i / 59.0, v = fmod(0.71 * i, 1);
        double a[3], b[3], far = 0;
        CHECK_OK(batten_surface_evaluate(dome, u, v, 0, a));
        CHECK_OK(batten_surface_evaluate(back, u, v, 0, b));
        for (int c = 0; c < 3; c++)
            far = hypot(far, a[c] - b[c]);
        CHECK(far < 1e-6);
    }
    batten_surface_unref(dome);
    batten_surface_unref(there);
    batten_surface_unref(back);
}

/* The pole of an ellipsoid, where Su vanishes: its derivatives are those just beside it. */
TEST(a_pole_stays_a_pole)
{
    const batten_frame frame = batten_frame_world();
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface_offset_report report;
    batten_surface *egg = NULL, *truth = NULL, *made = NULL;
    CHECK_OK(batten_surface_ellipsoid(&frame, 1, 1.2, 1.5, &egg));
    options.tolerance = 0;
    CHECK_OK(batten_surface_offset(egg, 0.3, &options, &report, &truth));
    options.tolerance = 1e-5;
    CHECK_OK(batten_surface_offset(egg, 0.3, &options, &report, &made));
    const batten_interval v = batten_surface_domain(egg, BATTEN_V);
    for (int i = 0; i <= 20; i++)
        for (int e = 0; e < 2; e++) {
            double at[30], beside[30], pole[3];
            const double to = e ? v.b - 1e-4 : v.a + 1e-4;
            CHECK_OK(batten_surface_evaluate(truth, i / 20.0, e ? v.b : v.a, 2, at));
            CHECK_OK(batten_surface_evaluate(truth, i / 20.0, to, 2, beside));
            CHECK_NEAR(hypot(at[0], at[1]), 0, 1e-12);
            CHECK_NEAR(fabs(at[2]), 1.8, 1e-12);
            for (int k = 3; k < 18; k++)
                CHECK_NEAR(at[k], beside[k], 2e-2);
            CHECK_OK(batten_surface_evaluate(made, i / 20.0, e ? v.b : v.a, 0, pole));
            CHECK_NEAR(fabs(pole[2]), 1.8, 1e-12);
            CHECK_NEAR(hypot(pole[0], pole[1]), 0, 1e-12);
        }
    batten_surface_unref(egg);
    batten_surface_unref(truth);
    batten_surface_unref(made);
}

/* The lower half of a paraboloid z = x^2 + y^2 has curvature 2 at its bottom: offsets upwards
 * beyond 1/2 turn over, those below and those downwards do not. */
TEST(G5_offsets_beyond_the_radius_of_curvature_are_refused)
{
    const batten_frame frame = batten_frame_world();
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface_offset_report report;
    batten_surface *bowl = NULL, *made = NULL;
    CHECK_OK(batten_surface_paraboloid(&frame, 1, 1, 1, &bowl));
    batten_vec3 n;
    CHECK_OK(batten_surface_normal(bowl, 0.3, 0.5, NULL, &n));
    const double up = n.z > 0 ? 1 : -1;
    options.tolerance = 1e-3;
    CHECK_OK(batten_surface_offset(bowl, up * 0.45, &options, &report, &made));
    CHECK_NEAR(report.factor, 1 - 0.45 * 2, 1e-3);
    batten_surface_unref(made);
    made = NULL;
    CHECK_OK(batten_surface_offset(bowl, -up * 2, &options, &report, &made));
    batten_surface_unref(made);
    made = NULL;
    CHECK_STATUS(batten_surface_offset(bowl, up * 0.6, &options, &report, &made),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("radius of curvature");
    CHECK(report.factor < 0 && report.turned[0].a <= report.turned[0].b && made == NULL);
    /* 1 - 0.6 kappa = 0 where 2 / (1 + 4 z)^(3/2) = 1 / 0.6 along the meridian. */
    options.keep = true;
    CHECK_OK(batten_surface_offset(bowl, up * 0.6, &options, &report, &made));
    CHECK(report.factor < 0);
    batten_surface_unref(made);
    batten_surface_unref(bowl);
}

TEST(G5_a_sphere_offset_to_its_centre_is_refused)
{
    batten_surface *sphere = make_sphere(2), *made = NULL;
    CHECK_STATUS(batten_surface_offset(sphere, -2, NULL, NULL, &made), BATTEN_SINGULAR_HERE);
    CHECK_STATUS(batten_surface_offset(sphere, (double)NAN, NULL, NULL, &made),
                 BATTEN_NOT_FINITE);
    batten_surface_unref(sphere);
    CHECK(made == NULL);
}

TEST(G5_offsets_of_cusps_are_given_up_before_they_are_large)
{
    /* A bicubic patch that turns over at cusps across its spans: normals jump there, and no
     * spline comes near. The search must see it after few rounds, not at its last point. */
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    const batten_axis axis = {3, 4, knots, false};
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface *patch = NULL, *made = NULL;
    double points[48];
    int count_u = 0, count_v = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            points[12 * i + 3 * j] = (i - 1.5) * (j - 1.4);
            points[12 * i + 3 * j + 1] = (i - 1.3) * (i - 1.7) + 0.01 * j;
            points[12 * i + 3 * j + 2] = 0.3 * j * j;
        }
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &patch));
    options.keep = true;
    CHECK_STATUS(batten_surface_offset(patch, 0.5, &options, NULL, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_INT(sscanf(batten_message(), "%d x %d control points", &count_u, &count_v), 2);
    CHECK(count_u < 1000 && count_v < 1000);
    batten_surface_unref(patch);
}

TEST(G6_a_crease_has_no_offset)
{
    const double knots[] = {0, 0, 1, 2, 2}, along[] = {0, 0, 1, 1};
    const double roof[] = {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 2, 0, 0, 2, 1, 0};
    const double flat[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 3, 0, 0, 3, 1, 0};
    const batten_axis u = {1, 3, knots, false}, v = {1, 2, along, false};
    batten_surface_offset_report report;
    batten_surface *surface = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, roof, NULL, &surface));
    CHECK_STATUS(batten_surface_offset(surface, 0.1, NULL, NULL, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("90 degrees at u = 1");
    batten_surface_unref(surface);
    CHECK_OK(batten_surface_create(3, &u, &v, flat, NULL, &surface));
    CHECK_OK(batten_surface_offset(surface, 0.1, NULL, &report, &made));
    CHECK(report.exact);
    batten_surface_unref(surface);
    batten_surface_unref(made);
}

TEST(G7_surfaces_without_normals_have_no_offset)
{
    const double knots[] = {0, 0, 1, 1};
    const double line[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0};
    const double point[12] = {0};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, line, NULL, &surface));
    CHECK_STATUS(batten_surface_offset(surface, 0.1, NULL, NULL, &made), BATTEN_SINGULAR_HERE);
    batten_surface_unref(surface);
    CHECK_OK(batten_surface_create(3, &axis, &axis, point, NULL, &surface));
    CHECK_STATUS(batten_surface_offset(surface, 0.1, NULL, NULL, &made), BATTEN_SINGULAR_HERE);
    batten_surface_unref(surface);
}

TEST(K7_offsets_of_huge_and_tiny_surfaces)
{
    const double scales[] = {1e80, 1e-80, 1e6};
    for (int i = 0; i < COUNT(scales); i++) {
        batten_surface_offset_options options = batten_surface_offset_defaults();
        batten_surface *dome = make_dome(scales[i]), *sphere = make_sphere(scales[i]);
        batten_surface *twice = make_sphere(2 * scales[i]);
        options.tolerance = 1e-6 * scales[i];
        batten_surface *made = NULL, *big = NULL;
        batten_surface_offset_report report;
        const batten_status status =
            batten_surface_offset(dome, 0.1 * scales[i], &options, &report, &made);
        CHECK_OK(status == BATTEN_OUT_OF_MEMORY ? BATTEN_OK : status);
        CHECK_OK(batten_surface_offset(sphere, scales[i], NULL, &report, &big));
        CHECK(report.exact);
        check_same_shape(big, twice, 1e-12 * scales[i]);
        batten_surface_unref(dome);
        batten_surface_unref(sphere);
        batten_surface_unref(twice);
        batten_surface_unref(made);
        batten_surface_unref(big);
    }
}

/* A plane patch that is folded onto itself: across the fold the normal turns round, and no
 * number of points will do. */
TEST(an_offset_that_jumps_is_given_up_before_it_has_millions_of_points)
{
    static const double points[] = {0, 0, 0, 0, 1, 3, 0, 2, 1, 0, 2, 0}, knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface *folded = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, (double[]){2, 1, 1, 1}, &folded));
    options.tolerance = 1e-9;
    CHECK_STATUS(batten_surface_offset(folded, 0.5, &options, NULL, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("171 x 261 control points come to 1.27");
    options.most_points = 1000;
    CHECK_STATUS(batten_surface_offset(folded, 0.5, &options, NULL, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("37 x 37 control points");
    options.most_points = 0;
    CHECK_STATUS(batten_surface_offset(folded, 0.5, &options, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("at most 0 points");
    batten_surface_unref(folded);
}

TEST(offsets_that_cannot_be_are_named_with_their_numbers)
{
    static const struct {
        double distance, tolerance;
        int most;
        batten_status status;
        const char *message;
    } rows[] = {
        {NAN, 1e-3, 100, BATTEN_NOT_FINITE, "an offset by nan within 0.001"},
        {2, INFINITY, 100, BATTEN_NOT_FINITE, "an offset by 2 within inf"},
        {2, -1e-3, 100, BATTEN_BAD_ARGUMENT, "the tolerance is -0.001"},
        {2, 1e-3, 0, BATTEN_BAD_ARGUMENT, "at most 0 points are asked for"},
        {2, 1e-3, 100, BATTEN_UNSUPPORTED, "a surface in 1 dimension has no normal"},
    };
    static const double knots[4] = {0, 0, 1, 1}, z[4] = {0, 1, 2, 3};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *function = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(1, &axis, &axis, z, NULL, &function));
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface_offset_options options = batten_surface_offset_defaults();
        options.tolerance = rows[i].tolerance;
        options.most_points = rows[i].most;
        CHECK_STATUS(batten_surface_offset(function, rows[i].distance, &options, NULL, &made),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
    CHECK(!made);
    batten_surface_unref(function);
}
