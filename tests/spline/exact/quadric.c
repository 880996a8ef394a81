#include <batten/standard.h>

#include "support/test.h"

static const double pi = 3.141592653589793;
static const batten_frame tilted = {{1, -2, 0.5}, {1, 1, 0}, {0.3, -0.2, 2}};

/* Coordinates in the frame made square. */
static batten_vec3 seen(batten_frame f, const double *at)
{
    const double zn = sqrt(f.z.x * f.z.x + f.z.y * f.z.y + f.z.z * f.z.z);
    const batten_vec3 z = {f.z.x / zn, f.z.y / zn, f.z.z / zn};
    const double along = f.x.x * z.x + f.x.y * z.y + f.x.z * z.z;
    batten_vec3 x = {f.x.x - along * z.x, f.x.y - along * z.y, f.x.z - along * z.z};
    const double xn = sqrt(x.x * x.x + x.y * x.y + x.z * x.z);
    x = (batten_vec3){x.x / xn, x.y / xn, x.z / xn};
    const batten_vec3 y = {z.y * x.z - z.z * x.y, z.z * x.x - z.x * x.z, z.x * x.y - z.y * x.x};
    const double d[3] = {at[0] - f.origin.x, at[1] - f.origin.y, at[2] - f.origin.z};
    return (batten_vec3){d[0] * x.x + d[1] * x.y + d[2] * x.z,
                         d[0] * y.x + d[1] * y.y + d[2] * y.z,
                         d[0] * z.x + d[1] * z.y + d[2] * z.z};
}

/* How far from the shape a point of (radius, height) is, relative to the size of the shape. */
typedef double (*distance)(double radius, double height);

static double from_sphere(double r, double z)
{
    return (hypot(r, z) - 2.5) / 2.5;
}

static double from_cylinder(double r, double z)
{
    return z < -1e-14 || z > 4 + 1e-14 ? 1 : (r - 1.5) / 4;
}

static double from_cone(double r, double z)
{
    return (r - 3 * (1 - z / 4)) / 4;
}

static double from_torus(double r, double z)
{
    return (hypot(r - 3, z) - 1) / 4;
}

static void check_shape(const batten_surface *surface, batten_frame frame, double tolerance,
                        distance off)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 40; j++) {
            double at[3];
            CHECK_OK(batten_surface_evaluate(surface, u.a + (u.b - u.a) * i / 40,
                                             v.a + (v.b - v.a) * j / 40, 0, at));
            const batten_vec3 local = seen(frame, at);
            CHECK_NEAR(off(hypot(local.x, local.y), local.z), 0, tolerance);
        }
}

TEST(standard_surfaces_are_exact_to_4_eps)
{
    const batten_frame frames[] = {batten_frame_world(), tilted};
    for (int i = 0; i < COUNT(frames); i++) {
        /* A tilted frame adds the roundoff of its directions and origin, here and in the test.
         */
        const double tolerance = (i ? 12 : 4) * DBL_EPSILON;
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_sphere(&frames[i], 2.5, &surface));
        check_shape(surface, frames[i], tolerance, from_sphere);
        batten_surface_unref(surface);
        CHECK_OK(batten_surface_cylinder(&frames[i], 1.5, 4, &surface));
        check_shape(surface, frames[i], tolerance, from_cylinder);
        batten_surface_unref(surface);
        CHECK_OK(batten_surface_cone(&frames[i], 3, 0, 4, &surface));
        check_shape(surface, frames[i], tolerance, from_cone);
        batten_surface_unref(surface);
        CHECK_OK(batten_surface_torus(&frames[i], 3, 1, &surface));
        check_shape(surface, frames[i], tolerance, from_torus);
        batten_surface_unref(surface);
    }
}

TEST(a_sphere_has_9_by_5_points_and_circles_of_latitude)
{
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    CHECK_OK(batten_surface_sphere(&world, 1, &sphere));
    CHECK_INT(batten_surface_point_count(sphere, BATTEN_U), 9);
    CHECK_INT(batten_surface_point_count(sphere, BATTEN_V), 5);
    CHECK(batten_surface_is_closed(sphere, BATTEN_U, 0));
    CHECK(!batten_surface_is_closed(sphere, BATTEN_V, 1));
    for (int j = 1; j < 10; j++) {
        batten_curve *circle = NULL;
        double at[3];
        CHECK_OK(batten_surface_evaluate(sphere, 0, j / 10.0, 0, at));
        const double radius = sqrt(1 - at[2] * at[2]);
        CHECK_OK(batten_surface_isocurve(sphere, BATTEN_V, j / 10.0, &circle));
        for (int i = 0; i <= 20; i++) {
            CHECK_OK(batten_curve_evaluate(circle, i / 20.0, 0, at));
            CHECK_NEAR(hypot(at[0], at[1]), radius, 4 * DBL_EPSILON);
        }
        batten_curve_unref(circle);
    }
    batten_surface_unref(sphere);
}

TEST(any_sweep_goes_from_the_profile_to_its_angle)
{
    const double a[] = {2, 0, 0}, points[] = {2, 0, 0, 1, 0, 1}, knots[] = {0, 0, 1, 1};
    const double angles[] = {1e-6, 0.1, 1, pi / 2, 2, pi, 4, 1.5 * pi, 6, 2 * pi};
    const batten_vec3 origin = {0, 0, 0}, axis = {0, 0, 7};
    batten_curve *profile = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &profile));
    for (int i = 0; i < COUNT(angles); i++) {
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_revolved(profile, origin, axis, angles[i], &surface));
        double at[3];
        CHECK_OK(batten_surface_evaluate(surface, 0, 0, 0, at));
        for (int k = 0; k < 3; k++)
            CHECK_BITS(at[k] + 0, a[k]);
        for (int k = 0; k <= 50; k++) {
            CHECK_OK(batten_surface_evaluate(surface, k / 50.0, 0, 0, at));
            CHECK_NEAR(hypot(at[0], at[1]) / 2, 1, 4 * DBL_EPSILON);
        }
        CHECK_NEAR(at[0], 2 * cos(angles[i]), 8 * DBL_EPSILON);
        CHECK_NEAR(at[1], 2 * sin(angles[i]), 8 * DBL_EPSILON);
        batten_surface_unref(surface);
    }
    batten_curve_unref(profile);
}

static batten_status revolve(int degree, int count, const double *points, const double *knots,
                             batten_surface **out)
{
    batten_curve *profile = NULL;
    batten_status status =
        batten_curve_create((batten_points){3, count, points}, degree, NULL, knots, &profile);
    if (status == BATTEN_OK)
        status = batten_surface_revolved(profile, (batten_vec3){0, 0, 0},
                                         (batten_vec3){0, 0, 1}, 1, out);
    batten_curve_unref(profile);
    return status;
}

TEST(a_profile_that_crosses_the_axis_is_refused_and_one_that_touches_has_a_pole)
{
    const double knots[] = {0, 0, 1, 1}, curved[] = {0, 0, 0, 1, 1, 1};
    const double crossing[] = {-1, 0, 0, 2, 0, 1}, touching[] = {0, 0, 0, 2, 0, 1};
    const double on_axis[] = {0, 0, 0, 0, 0, 1}, skew[] = {-1, 0.5, 0, 2, 0.5, 1};
    /* The middle point is across the axis, the curve is not: its least x is 0.25. */
    const double bulge[] = {1, 0, 0, -0.5, 0, 1, 1, 0, 2};
    /* Here the curve is, between its ends. */
    const double deep[] = {1, 0, 0, -1.5, 0, 1, 1, 0, 2};
    batten_surface *surface = NULL;
    CHECK_STATUS(revolve(1, 2, crossing, knots, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("crosses the axis");
    CHECK_STATUS(revolve(1, 2, on_axis, knots, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(revolve(2, 3, deep, curved, &surface), BATTEN_BAD_ARGUMENT);
    CHECK(surface == NULL);
    CHECK_OK(revolve(2, 3, bulge, curved, &surface));
    batten_surface_unref(surface);
    CHECK_OK(revolve(1, 2, skew, knots, &surface));
    batten_surface_unref(surface);
    CHECK_OK(revolve(1, 2, touching, knots, &surface));
    for (int i = 0; i <= 10; i++) {
        double at[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 10.0, 0, 0, at));
        CHECK(at[0] == 0 && at[1] == 0 && at[2] == 0);
    }
    batten_surface_unref(surface);
}

/* Each point of a skew line keeps its height and its distance from the axis. */
TEST(a_skew_line_turns_into_a_hyperboloid)
{
    const double knots[] = {0, 0, 1, 1}, skew[] = {-1, 0.5, 0, 2, 0.5, 1};
    batten_surface *surface = NULL;
    CHECK_OK(revolve(1, 2, skew, knots, &surface));
    for (int i = 0; i <= 10; i++)
        for (int j = 0; j <= 10; j++) {
            double at[3];
            CHECK_OK(batten_surface_evaluate(surface, i / 10.0, j / 10.0, 0, at));
            CHECK_NEAR(at[2], j / 10.0, 4 * DBL_EPSILON);
            CHECK_NEAR(hypot(at[0], at[1]), hypot(3 * at[2] - 1, 0.5), 8 * DBL_EPSILON);
        }
    batten_surface_unref(surface);
}

TEST(a_bilinear_patch_of_the_saddle_is_the_saddle)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){-1, -1, 1}, (batten_vec3){1, -1, -1},
                                     (batten_vec3){-1, 1, -1}, (batten_vec3){1, 1, 1},
                                     &surface));
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++) {
            double at[3];
            CHECK_OK(batten_surface_evaluate(surface, i / 8.0, j / 8.0, 0, at));
            CHECK_BITS(at[0], i / 4.0 - 1);
            CHECK_BITS(at[1], j / 4.0 - 1);
            CHECK_BITS(at[2] + 0.0, at[0] * at[1] + 0.0);
        }
    batten_surface_unref(surface);
}

TEST(N1_shapes_without_a_size_are_refused)
{
    const batten_frame world = batten_frame_world();
    const batten_frame flat = {{0, 0, 0}, {0, 0, 2}, {0, 0, 1}},
                       empty = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    const batten_frame wild = {{0, 0, 0}, {NAN, 0, 0}, {0, 0, 1}},
                       far = {{INFINITY, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_sphere(&world, 0, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_sphere(&world, NAN, &surface), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_sphere(&flat, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_sphere(&empty, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_sphere(&wild, 1, &surface), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_sphere(&far, 1, &surface), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_cylinder(&world, -1, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_cylinder(&world, 1, 0, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_cone(&world, 0, 0, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_cone(&world, -1, 0, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_torus(&world, 1, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_torus(&world, 0, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_torus(&world, 1, -1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK(surface == NULL);
}

TEST(N1_axes_and_angles_that_are_none_are_refused)
{
    const double knots[] = {0, 0, 1, 1}, points[] = {1, 0, 0, 1, 0, 1};
    const batten_vec3 zero = {0, 0, 0}, up = {0, 0, 1}, wild = {0, INFINITY, 0};
    batten_curve *profile = NULL, *plane = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &profile));
    CHECK_OK(batten_curve_create((batten_points){2, 2, points}, 1, NULL, knots, &plane));
    CHECK_STATUS(batten_surface_revolved(plane, zero, up, 1, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_revolved(profile, zero, zero, 1, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_revolved(profile, zero, wild, 1, &surface), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_revolved(profile, wild, up, 1, &surface), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_revolved(profile, zero, up, NAN, &surface), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_revolved(profile, zero, up, 0, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_revolved(profile, zero, up, 6.3, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK(surface == NULL);
    batten_curve_unref(profile);
    batten_curve_unref(plane);
}

TEST(normals_of_closed_shapes_point_outwards_and_profiles_start_outside)
{
    const batten_frame world = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    batten_surface *sphere = NULL, *torus = NULL;
    double at[3];
    CHECK_OK(batten_surface_sphere(&world, 2, &sphere));
    CHECK_OK(batten_surface_torus(&world, 3, 1, &torus));
    for (int i = 1; i < 12; i++)
        for (int j = 1; j < 12; j++) {
            const double s = i / 12.0, t = j / 12.0;
            batten_surface *const both[2] = {sphere, torus};
            for (int k = 0; k < 2; k++) {
                const batten_interval u = batten_surface_domain(both[k], BATTEN_U),
                                      v = batten_surface_domain(both[k], BATTEN_V);
                const double a = u.a + s * (u.b - u.a), b = v.a + t * (v.b - v.a);
                batten_vec3 normal;
                CHECK_OK(batten_surface_evaluate(both[k], a, b, 0, at));
                CHECK_OK(batten_surface_normal(both[k], a, b, NULL, &normal));
                /* Away from the centre, or from the circle of centres of radius 3. */
                const double r = hypot(at[0], at[1]), back = k == 0 ? 1 : 1 - 3 / r;
                CHECK_NEAR(normal.x * at[0] * back + normal.y * at[1] * back + normal.z * at[2],
                           k == 0 ? 2 : 1, 1e-12);
            }
        }
    CHECK_OK(batten_surface_evaluate(torus, batten_surface_domain(torus, BATTEN_U).a,
                                     batten_surface_domain(torus, BATTEN_V).a, 0, at));
    CHECK_NEAR(at[0], 4, 1e-15);
    CHECK_NEAR(at[1], 0, 1e-15);
    CHECK_NEAR(at[2], 0, 1e-15);
    batten_surface_unref(sphere);
    batten_surface_unref(torus);
}

/* Profiles in a plane with the axis and how far they reach to both sides, in the message. */
static const struct {
    int degree, count;
    double points[15], knots[9];
    const char *words; /* NULL: it is a surface */
} profiles[] = {
    {1,
     3,
     {2, 0, 0, 1, 0, 1, -0.25, 0, 2},
     {0, 0, 1, 2, 2},
     "it reaches from -0.25 to 2 across it"},
    {1,
     3,
     {-0.5, 0, 0, 1, 0, 1, 3, 0, 2},
     {0, 0, 1, 2, 2},
     "it reaches from -0.5 to 3 across it"},
    {1, 3, {1, 0, 0, -4, 0, 1, 3, 0, 2}, {0, 0, 1, 2, 2}, "it reaches from -3 to 4 across it"},
    {2,
     3,
     {1, 0, 0, -3, 0, 1, 1, 0, 2},
     {0, 0, 0, 1, 1, 1},
     "it reaches from -1 to 1 across it"},
    {2,
     5,
     {1, 0, 0, 1, 0, 1, 1, 0, 2, -2, 0, 3, 1, 0, 4},
     {0, 0, 0, 1, 1, 2, 2, 2},
     "it reaches from -1 to 0.5 across it"},
    {1, 2, {0, 0, 5, 0, 0, 7}, {0, 0, 1, 1}, "the profile lies on the axis"},
    {1, 3, {2, 0, 0, 0, 0, 1, 3, 0, 2}, {0, 0, 1, 2, 2}, NULL},
    {1, 3, {2, 0, 0, 1e-16, 0, 1, 3, 0, 2}, {0, 0, 1, 2, 2}, NULL},
    {1, 3, {2, 1, 0, -1, 0, 1, 3, 0, 2}, {0, 0, 1, 2, 2}, NULL}, /* in no plane with the axis */
};

TEST(a_profile_that_crosses_the_axis_is_measured_on_both_sides)
{
    for (int i = 0; i < COUNT(profiles); i++) {
        batten_surface *surface = NULL;
        CHECK_STATUS(revolve(profiles[i].degree, profiles[i].count, profiles[i].points,
                             profiles[i].knots, &surface),
                     profiles[i].words ? BATTEN_BAD_ARGUMENT : BATTEN_OK);
        if (profiles[i].words)
            CHECK_MESSAGE(profiles[i].words);
        CHECK((surface != NULL) == !profiles[i].words);
        batten_surface_unref(surface);
    }
}

typedef batten_status (*shape_maker)(const batten_frame *frame, const double *v,
                                     batten_surface **out);

static batten_status make_cone(const batten_frame *frame, const double *v, batten_surface **out)
{
    return batten_surface_cone(frame, v[0], v[1], v[2], out);
}

static batten_status make_cylinder(const batten_frame *frame, const double *v,
                                   batten_surface **out)
{
    return batten_surface_cylinder(frame, v[0], v[1], out);
}

static batten_status make_torus(const batten_frame *frame, const double *v,
                                batten_surface **out)
{
    return batten_surface_torus(frame, v[0], v[1], out);
}

static const struct {
    shape_maker make;
    double sizes[3];
    const char *words; /* NULL: it is a surface */
} sizes[] = {
    {make_cone, {0, 1, 2}, NULL},
    {make_cone, {1, 0, 2}, NULL},
    {make_cone, {0, 0, 2}, "the radius at the height is 0; it must be positive"},
    {make_cone, {-1, 1, 2}, "the radius at the origin is -1; it must be positive"},
    {make_cone, {1, -2, 2}, "the radius at the height is -2; it must be positive"},
    {make_cone, {1, INFINITY, 2}, "the radius at the height is inf"},
    {make_cone, {1, 1, 0}, "the height is 0; it must be positive"},
    {make_cone, {1, 1, -3}, "the height is -3; it must be positive"},
    {make_cylinder, {0, 1}, "the radius is 0; it must be positive"},
    {make_cylinder, {2, 0}, "the height is 0; it must be positive"},
    {make_cylinder, {2, 1}, NULL},
    {make_torus, {0, 1}, "the major radius is 0; it must be positive"},
    {make_torus, {2, 0}, "the minor radius is 0; it must be positive"},
    {make_torus, {2, 2}, "the major radius is 2, not above the minor one, 2"},
    {make_torus, {2, 1.99}, NULL},
};

TEST(a_size_that_cannot_be_is_named)
{
    const batten_frame world = batten_frame_world();
    for (int i = 0; i < COUNT(sizes); i++) {
        batten_surface *surface = NULL;
        CHECK_STATUS(sizes[i].make(&world, sizes[i].sizes, &surface),
                     !sizes[i].words               ? BATTEN_OK
                     : isfinite(sizes[i].sizes[1]) ? BATTEN_BAD_ARGUMENT
                                                   : BATTEN_NOT_FINITE);
        if (sizes[i].words)
            CHECK_MESSAGE(sizes[i].words);
        CHECK((surface != NULL) == !sizes[i].words);
        batten_surface_unref(surface);
    }
}
