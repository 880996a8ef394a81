/* How far cylinders and cones reach along their axis, spheres and tori around theirs, and what has no surface. */
#include "body/elementary/elementary.h"
#include "support/test.h"

#include <math.h>

static const double SLOPE = 0.5; /* of the cones: half the radius more at each height */

static batten_status make(const bat_elementary *e, int count, const double *points,
                          batten_surface **out)
{
    double error = -1;
    return bat_elementary_surface(e, count, points, 1e-6, out, &error);
}

static void check_domain(const bat_elementary *e, int count, const double *points, double low,
                         double high)
{
    batten_surface *surface = NULL;
    double at[3], end[3];
    CHECK_OK(make(e, count, points, &surface));
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    CHECK_NEAR(u.a, 0, 0);
    CHECK_NEAR(u.b, 2 * BAT_PI, 0);
    CHECK_NEAR(v.a, low, 1e-13);
    CHECK_NEAR(v.b, high, 1e-13);
    CHECK_OK(batten_surface_evaluate(surface, 0, v.a, 0, at));
    CHECK_OK(batten_surface_evaluate(surface, 0, v.b, 0, end));
    if (e->kind == BAT_CYLINDER ||
        e->kind == BAT_CONE) { /* the parameter is the slant height */
        CHECK_NEAR(at[2], low * cos(e->b), 1e-13);
        CHECK_NEAR(end[2], high * cos(e->b), 1e-13);
    }
    batten_surface_unref(surface);
}

/* A twentieth of the extent more at each end, or of the radius where there is none. */
TEST(a_cylinder_reaches_a_twentieth_beyond_its_points)
{
    const bat_elementary e = {.kind = BAT_CYLINDER, .frame = batten_frame_world(), .a = 2};
    static const double points[] = {2, 0, -3, 0, -2, 7};
    check_domain(&e, 2, points, -3.5, 7.5);
    check_domain(&e, 1, points, -3.1, -2.9);
}

/* Towards its apex at -a / slope a cone reaches half the way to it at most; to it where a point does. */
static const struct {
    double a, sign, from, to; /* heights of two points */
    double low, high;         /* of the surface */
} cones[] = {
    {1, 1, 0, 4, -0.2, 4.2}, /* apex at -2 */
    {1, 1, -1.999, 4, -1.9995, 4.29995},
    {1, 1, -2, 4, -2, 4.3},
    {1, 1, 3, 3, 2.875, 3.125},   /* of radius 2.5 */
    {1, 1, -6, -3, -6.15, -2.85}, /* the other half */
    {1, 1, -3, -2.01, -3.0495, -2.005},
    {1, -1, -4, 0, -4.2, 0.2}, /* apex at 2 */
    {1, -1, -4, 1.999, -4.29995, 1.9995},
    {1, -1, -4, 2, -4.3, 2},
    {1, -1, 3, 6, 2.85, 6.15},
    {2, 0, -3, 7, -3.5, 7.5}, /* a cylinder */
};

TEST(a_cone_reaches_a_twentieth_beyond_its_points_but_not_over_its_apex)
{
    for (int i = 0; i < COUNT(cones); i++) {
        const double slope = cones[i].sign * SLOPE, half = atan(slope);
        const bat_elementary e = {
            .kind = BAT_CONE, .frame = batten_frame_world(), .a = cones[i].a, .b = half};
        const double points[] = {
            fabs(e.a + cones[i].from * slope), 0,          cones[i].from, 0,
            fabs(e.a + cones[i].to * slope),   cones[i].to};
        check_domain(&e, 2, points, cones[i].low / cos(half), cones[i].high / cos(half));
    }
}

TEST(spheres_and_tubes_have_angles_for_parameters)
{
    const bat_elementary sphere = {.kind = BAT_SPHERE, .frame = batten_frame_world(), .a = 2};
    const bat_elementary ring = {
        .kind = BAT_TORUS, .frame = batten_frame_world(), .a = 3, .b = 1};
    /* the tube of radius 2 about a circle of radius 1 meets the axis at 120 degrees, or 60 */
    bat_elementary spindle = {.kind = BAT_TORUS, .frame = batten_frame_world(), .a = 1, .b = 2};
    check_domain(&sphere, 0, NULL, -BAT_PI / 2, BAT_PI / 2);
    check_domain(&ring, 0, NULL, 0, 2 * BAT_PI);
    check_domain(&spindle, 0, NULL, -2 * BAT_PI / 3, 2 * BAT_PI / 3);
    spindle.is_inner = true;
    check_domain(&spindle, 0, NULL, -BAT_PI / 3, BAT_PI / 3);
    spindle.is_inner =
        false; /* the points say which: (1, 0, 0) lies on the lemon, (3, 0, 0) on the apple */
    check_domain(&spindle, 1, (const double[]){1, 0, 0}, -BAT_PI / 3, BAT_PI / 3);
    check_domain(&spindle, 1, (const double[]){3, 0, 0}, -2 * BAT_PI / 3, 2 * BAT_PI / 3);
}

static const struct {
    bat_elementary_kind kind;
    double a, b;
    batten_status status;
    const char *message;
} refused[] = {
    {BAT_CYLINDER, 0, 0, BATTEN_BAD_ARGUMENT,
     "the radius of the cylinder is 0; it must be positive"},
    {BAT_CYLINDER, NAN, 0, BATTEN_NOT_FINITE, "the cylinder has the measures nan and 0"},
    {BAT_SPHERE, -1, 0, BATTEN_BAD_ARGUMENT, "the radius of the sphere is -1"},
    {BAT_TORUS, 3, 0, BATTEN_BAD_ARGUMENT, "the radius of the tube of the torus is 0"},
    {BAT_CONE, 1, 1.6, BATTEN_BAD_ARGUMENT,
     "the half angle of the cone is 1.6; it must be below a right angle"},
    {BAT_CONE, 1, -1.6, BATTEN_BAD_ARGUMENT, "the half angle of the cone is -1.6"},
    {BAT_CONE, 0, 0.5, BATTEN_NOT_COMPATIBLE,
     "the points lie on both halves of the cone: the radius runs from"},
};

TEST(what_has_no_surface_is_refused_with_its_numbers)
{
    static const double points[] = {1, 0, -1, 0, 1, 1};
    for (int i = 0; i < COUNT(refused); i++) {
        const bat_elementary e = {.kind = refused[i].kind,
                                  .frame = batten_frame_world(),
                                  .a = refused[i].a,
                                  .b = refused[i].b};
        batten_surface *surface = NULL;
        CHECK_STATUS(make(&e, 2, points, &surface), refused[i].status);
        CHECK_MESSAGE(refused[i].message);
        CHECK(!surface);
    }
}
