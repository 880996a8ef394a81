/* Quadrics with three axes: images of round ones under affine maps, exact to rounding. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/standard.h>

static batten_status check_axis(double value, const char *name)
{
    if (!isfinite(value))
        return bat_fail(BATTEN_NOT_FINITE, "the %s is %g", name, value);
    if (!(value > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the %s is %g; it must be positive", name, value);
    return BATTEN_OK;
}

static batten_status check_axes(double a, double b, double c, const char *third)
{
    batten_status status = check_axis(a, "half axis along x");
    if (status == BATTEN_OK)
        status = check_axis(b, "half axis along y");
    if (status == BATTEN_OK)
        status = check_axis(c, third);
    return status;
}

/* The image of a surface about the world's axes, stretched by a, b, c, in the frame. */
static batten_status place_in_frame(const batten_surface *round, const batten_frame *frame,
                                    double a, double b, double c, batten_surface **out)
{
    batten_frame f;
    batten_vec3 y;
    const batten_status status = bat_frame_square(frame, &f, &y);
    if (status != BATTEN_OK)
        return status;
    const batten_affine map = {{{a * f.x.x, b * y.x, c * f.z.x},
                                {a * f.x.y, b * y.y, c * f.z.y},
                                {a * f.x.z, b * y.z, c * f.z.z}},
                               {f.origin.x, f.origin.y, f.origin.z}};
    return batten_surface_transform(round, &map, out);
}

/* Turn the Bezier curve through these points about the z-axis. */
static batten_status revolve_bezier(int degree, const double *points, batten_surface **out)
{
    static const double breaks[2] = {0, 1};
    const batten_vec3 origin = {0, 0, 0}, up = {0, 0, 1};
    batten_curve *profile = NULL;
    batten_status status =
        batten_curve_from_bezier(3, (batten_pieces){degree, 1, breaks}, points, NULL, &profile);
    if (status == BATTEN_OK)
        status = batten_surface_revolved(profile, origin, up, 2 * BAT_PI, out);
    batten_curve_unref(profile);
    return status;
}

batten_status batten_surface_ellipsoid(const batten_frame *frame, double a, double b, double c,
                                       batten_surface **out)
{
    assert(frame && out);
    const batten_frame world = batten_frame_world();
    batten_surface *sphere = NULL;
    batten_status status = check_axes(a, b, c, "half axis along z");
    if (status == BATTEN_OK)
        status = batten_surface_sphere(&world, 1, &sphere);
    if (status == BATTEN_OK)
        status = place_in_frame(sphere, frame, a, b, c, out);
    batten_surface_unref(sphere);
    return status;
}

batten_status batten_surface_paraboloid(const batten_frame *frame, double a, double b,
                                        double height, batten_surface **out)
{
    assert(frame && out);
    static const double parabola[9] = {0, 0, 0, 0.5, 0, 0, 1, 0, 1};
    batten_surface *round = NULL;
    batten_status status = check_axes(a, b, height, "height");
    if (status == BATTEN_OK)
        status = revolve_bezier(2, parabola, &round);
    if (status == BATTEN_OK)
        status = place_in_frame(round, frame, a, b, height, out);
    batten_surface_unref(round);
    return status;
}

batten_status batten_surface_hyperboloid(const batten_frame *frame, double a, double b,
                                         double c, batten_interval height, batten_surface **out)
{
    assert(frame && out);
    batten_surface *round = NULL;
    batten_status status = check_axes(a, b, c, "half axis along z");
    if (status == BATTEN_OK && (!isfinite(height.a) || !isfinite(height.b)))
        status = bat_fail(BATTEN_NOT_FINITE, "the heights are %g to %g", height.a, height.b);
    if (status == BATTEN_OK && !(height.a < height.b))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the heights go from %g to %g: they must rise",
                          height.a, height.b);
    if (status != BATTEN_OK)
        return status;
    /* (1, t, t) lies on x^2 + y^2 - z^2 = 1 for every t. */
    const double line[6] = {1, height.a / c, height.a / c, 1, height.b / c, height.b / c};
    status = revolve_bezier(1, line, &round);
    if (status == BATTEN_OK)
        status = place_in_frame(round, frame, a, b, c, out);
    batten_surface_unref(round);
    return status;
}
