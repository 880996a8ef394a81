#include <batten/skin.h>

#include "support/test.h"

static double dot(batten_vec3 a, batten_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static batten_vec3 cross(batten_vec3 a, batten_vec3 b)
{
    return (batten_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* Two turns of the helix of radius 1 and pitch pi, from exact derivatives: so close that frames
 * see no difference. */
static batten_curve *helix(void)
{
    double t[81], values[81 * 9];
    for (int i = 0; i <= 80; i++) {
        t[i] = 8 * acos(0) * i / 80;
        const double c = cos(t[i]), s = sin(t[i]);
        const double value[9] = {c, s, t[i] / 2, -s, c, 0.5, -c, -s, 0};
        memcpy(values + 9 * i, value, sizeof value);
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_hermite(3, 81, 3, t, values, &curve));
    return curve;
}

TEST(a_minimising_frame_turns_against_the_torsion_of_a_helix)
{
    batten_curve *spine = helix();
    const double end = 8 * acos(0), at[] = {0, 1, 2.5, end};
    batten_frame frames[4], frenet[4];
    CHECK_OK(batten_curve_frames(spine, 4, at, BATTEN_FRAME_ROTATION_MINIMISING, frames));
    CHECK_OK(batten_curve_frames(spine, 4, at, BATTEN_FRAME_FRENET, frenet));
    double first = 0;
    for (int k = 0; k < 4; k++) {
        CHECK_NEAR(dot(frames[k].x, frames[k].x), 1, 1e-14);
        CHECK_NEAR(dot(frames[k].z, frames[k].z), 1, 1e-14);
        CHECK_NEAR(dot(frames[k].x, frames[k].z), 0, 1e-14);
        CHECK_NEAR(frenet[k].x.x, -cos(at[k]), 1e-7);
        CHECK_NEAR(frenet[k].x.y, -sin(at[k]), 1e-7);
        const batten_vec3 n = frenet[k].x, binormal = cross(frenet[k].z, n);
        const double angle = atan2(dot(frames[k].x, binormal), dot(frames[k].x, n));
        if (k == 0)
            first = angle;
        /* tau = 0.4, ds = sqrt(1.25) dt: over the whole -5.61985 rad. */
        CHECK_NEAR(remainder(angle - first + 0.4 * sqrt(1.25) * at[k], 4 * acos(0)), 0, 1e-6);
    }
    CHECK_NEAR(0.4 * sqrt(1.25) * end, 5.61985, 1e-5);
    batten_curve_unref(spine);
}

TEST(along_a_plane_spine_the_normal_of_the_plane_stays)
{
    const double points[] = {0, 0, 0, 1, 2, 0, 3, 1, 0, 4, 4, 0};
    batten_curve *spine = NULL;
    double u[4];
    CHECK_OK(batten_curve_interpolate(3, 4, points, NULL, u, &spine));
    batten_frame frames[4];
    CHECK_OK(batten_curve_frames(spine, 4, u, BATTEN_FRAME_ROTATION_MINIMISING, frames));
    const batten_vec3 up = {0, 0, 1};
    const double first = dot(frames[0].x, up);
    for (int k = 0; k < 4; k++) {
        CHECK_NEAR(dot(frames[k].x, up), first, 1e-14);
        CHECK_NEAR(frames[k].origin.x, points[3 * k], 1e-14);
    }
    CHECK_OK(batten_curve_frames(spine, 4, u, BATTEN_FRAME_FIXED, frames));
    for (int k = 1; k < 4; k++)
        CHECK(frames[k].x.x == frames[0].x.x && frames[k].z.y == frames[0].z.y);
    batten_curve_unref(spine);
}

TEST(the_first_frame_of_a_spine_along_z_is_that_of_the_world)
{
    const double a[] = {0, 0, 0}, z[] = {0, 0, 2}, x[] = {3, 0, 0}, tilted[] = {1, 2, 0};
    const double at[] = {0, 1};
    batten_frame frames[2];
    batten_curve *spine = NULL;
    CHECK_OK(batten_curve_line(3, a, z, &spine));
    CHECK_OK(batten_curve_frames(spine, 2, at, BATTEN_FRAME_ROTATION_MINIMISING, frames));
    CHECK(frames[1].x.x == 1 && frames[1].z.z == 1 && frames[1].origin.z == 2);
    batten_curve_unref(spine);
    CHECK_OK(batten_curve_line(3, a, x,
                               &spine)); /* along a ship: x of the section to the side, y up */
    CHECK_OK(batten_curve_frames(spine, 2, at, BATTEN_FRAME_ROTATION_MINIMISING, frames));
    CHECK(frames[0].x.y == 1 && cross(frames[0].z, frames[0].x).z == 1);
    batten_curve_unref(spine);
    CHECK_OK(batten_curve_line(3, a, tilted, &spine));
    CHECK_OK(batten_curve_frames(spine, 2, at, BATTEN_FRAME_ROTATION_MINIMISING, frames));
    CHECK(frames[0].x.z == 1);
    batten_curve_unref(spine);
}

TEST(frames_that_do_not_exist_are_refused)
{
    const double a[] = {0, 0, 0}, b[] = {1, 1, 1}, at[] = {0, 1}, outside[] = {0, 2},
                 back[] = {1, 0};
    const double cusp[] = {0, 0, 0, 0, 0, 0, 1, 0, 0}, knots[] = {0, 0, 0, 1, 1, 1};
    batten_frame frames[2];
    batten_curve *line = NULL, *halted = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_OK(batten_curve_create(3, 2, 3, cusp, NULL, knots, &halted));
    CHECK_STATUS(batten_curve_frames(line, 2, at, BATTEN_FRAME_FRENET, frames),
                 BATTEN_SINGULAR_HERE);
    CHECK_STATUS(batten_curve_frames(line, 2, outside, BATTEN_FRAME_FIXED, frames),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_frames(line, 2, back, BATTEN_FRAME_FIXED, frames),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_curve_frames(line, 0, at, BATTEN_FRAME_FIXED, frames),
                 BATTEN_BAD_ARGUMENT);
    for (int kind = 0; kind < 3; kind++)
        CHECK_STATUS(batten_curve_frames(halted, 2, at, (batten_frame_kind)kind, frames),
                     BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the spine has no tangent at 0");
    batten_curve_unref(halted);
    batten_curve_unref(line);
}

TEST(sections_stand_evenly_by_arc_length)
{
    /* A line whose speed grows fourfold. */
    const double points[] = {0, 0, 0, 1, 0, 0, 5, 0, 0}, knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *spine = NULL, *circle = NULL;
    CHECK_OK(batten_curve_create(3, 2, 3, points, NULL, knots, &spine));
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    const batten_curve *sections[] = {circle, circle, circle, circle, circle, circle};
    batten_skin_options options = batten_skin_defaults();
    options.spine = spine;
    double v[6];
    batten_surface *pipe = NULL;
    CHECK_OK(batten_surface_skin(6, sections, &options, NULL, v, NULL, &pipe));
    for (int k = 0; k < 6; k++) {
        double out[3];
        CHECK_OK(batten_surface_evaluate(pipe, 0.1, v[k], 0, out));
        CHECK_NEAR(out[0], k, 1e-7);
    }
    batten_surface_unref(pipe);
    batten_curve_unref(circle);
    batten_curve_unref(spine);
}

TEST(a_frenet_frame_is_square_where_the_spine_bends_little)
{
    const double knots[] = {0, 0, 0, 1, 1, 1}, bends[] = {1e-3, 1e-6, 1e-9, 1e-12};
    for (int i = 0; i < COUNT(bends); i++) {
        const double points[] = {0, 0, 0, 1, 1.1, 1.3, 5, 5.5 + bends[i], 6.5};
        batten_curve *spine = NULL;
        CHECK_OK(batten_curve_create(3, 2, 3, points, NULL, knots, &spine));
        for (int k = 0; k <= 8; k++) {
            const double at = k / 8.0;
            batten_frame frame;
            CHECK_OK(batten_curve_frames(spine, 1, &at, BATTEN_FRAME_FRENET, &frame));
            const batten_vec3 x = frame.x, z = frame.z;
            CHECK_NEAR(x.x * z.x + x.y * z.y + x.z * z.z, 0, 4 * DBL_EPSILON);
            CHECK_NEAR(hypot(hypot(x.x, x.y), x.z), 1, 4 * DBL_EPSILON);
        }
        batten_curve_unref(spine);
    }
}
