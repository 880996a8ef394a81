#include <batten/measure.h>
#include <batten/skin.h>
#include <batten/standard.h>

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
    CHECK_OK(batten_curve_interpolate((batten_points){3, 4, points}, NULL, u, &spine));
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
    CHECK_OK(batten_curve_create((batten_points){3, 3, cusp}, 2, NULL, knots, &halted));
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
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &spine));
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &circle));
    const batten_curve *sections[] = {circle, circle, circle, circle, circle, circle};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.spine = spine;
    double v[6];
    batten_surface *pipe = NULL;
    CHECK_OK(
        batten_surface_skin((batten_curve_row){6, sections}, &options, NULL, v, NULL, &pipe));
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
        CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &spine));
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

/* A closed curve in space as a quintic spline through exact derivatives. */
static batten_curve *ring(void (*place)(double t, double *values), int count)
{
    double *t = test_array((size_t)count + 1, sizeof *t);
    double *values = test_array((size_t)count + 1, 9 * sizeof *values);
    batten_curve *curve = NULL;
    for (int i = 0; i <= count; i++) {
        t[i] = 4 * acos(0) * i / count;
        place(i == count ? 0 : t[i], values + 9 * i);
    }
    CHECK_OK(batten_curve_from_hermite(3, count + 1, 3, t, values, &curve));
    return curve;
}

static void torus_knot(double t, double *v)
{
    const double r = 3 + cos(3 * t), r1 = -3 * sin(3 * t), r2 = -9 * cos(3 * t);
    const double c = cos(2 * t), s = sin(2 * t);
    const double values[9] = {r * c,
                              r * s,
                              sin(3 * t),
                              r1 * c - 2 * r * s,
                              r1 * s + 2 * r * c,
                              3 * cos(3 * t),
                              r2 * c - 4 * r1 * s - 4 * r * c,
                              r2 * s + 4 * r1 * c - 4 * r * s,
                              -9 * sin(3 * t)};
    memcpy(v, values, sizeof values);
}

/* On the unit sphere: the normalised (cos t, sin t, 0.4 cos 2t). */
static void spherical(double t, double *v)
{
    const double h = 0.4, p[3] = {cos(t), sin(t), h * cos(2 * t)},
                 p1[3] = {-sin(t), cos(t), -2 * h * sin(2 * t)},
                 p2[3] = {-cos(t), -sin(t), -4 * h * cos(2 * t)};
    double s = 0, s1 = 0, s2 = 0;
    for (int k = 0; k < 3; k++) {
        s += p[k] * p[k];
        s1 += 2 * p[k] * p1[k];
        s2 += 2 * (p1[k] * p1[k] + p[k] * p2[k]);
    }
    const double f = 1 / sqrt(s), f1 = -s1 * f / (2 * s),
                 f2 = -s2 * f / (2 * s) + 0.75 * s1 * s1 * f / (s * s);
    for (int k = 0; k < 3; k++) {
        v[k] = f * p[k];
        v[3 + k] = f1 * p[k] + f * p1[k];
        v[6 + k] = f2 * p[k] + 2 * f1 * p1[k] + f * p2[k];
    }
}

TEST(the_turn_of_a_round_is_minus_the_total_torsion)
{
    batten_curve *knot = ring(torus_knot, 120);
    double angle, error, torsion = 0;
    const int n = 24000;
    for (int i = 0; i < n; i++) { /* the middle rule, of a periodic integrand */
        batten_curve_local local;
        const double u = 4 * acos(0) * (i + 0.5) / n;
        CHECK_OK(batten_curve_local_at(knot, u, BATTEN_FROM_RIGHT, &local));
        torsion += local.torsion * local.speed * 4 * acos(0) / n;
    }
    CHECK_OK(batten_curve_holonomy(knot, 1e-10, &error, &angle));
    CHECK(error <= 1e-10);
    CHECK_NEAR(remainder(angle + torsion, 4 * acos(0)), 0, 1e-5);
    CHECK(fabs(angle) > 0.1);
    batten_curve_unref(knot);
}

TEST(on_a_sphere_a_minimising_frame_comes_back)
{
    batten_curve *curve = ring(spherical, 160);
    double angle = 7;
    CHECK_OK(batten_curve_holonomy(curve, 1e-9, NULL, &angle));
    CHECK_NEAR(angle, 0, 1e-7);
    batten_curve_unref(curve);
}

TEST(closing_frames_close_and_differ_evenly_from_minimising_ones)
{
    batten_curve *knot = ring(torus_knot, 120);
    double at[9], turn, length, part;
    batten_frame closed[9], free[9];
    for (int k = 0; k < 9; k++)
        at[k] = batten_curve_domain(knot).b * k / 8;
    CHECK_OK(batten_curve_frames(knot, 9, at, BATTEN_FRAME_CLOSING, closed));
    CHECK_OK(batten_curve_frames(knot, 9, at, BATTEN_FRAME_ROTATION_MINIMISING, free));
    CHECK_OK(batten_curve_holonomy(knot, 1e-9, NULL, &turn));
    CHECK_OK(batten_curve_length(knot, 1e-12, NULL, &length));
    CHECK_NEAR(dot(closed[0].x, closed[8].x), 1, 1e-12);
    CHECK(dot(free[0].x, free[8].x) < 0.99);
    for (int k = 0; k < 9; k++) {
        const batten_vec3 y = cross(free[k].z, free[k].x);
        CHECK_OK(batten_curve_length_between(knot, 0, at[k], 1e-12, NULL, &part));
        const double angle = atan2(dot(closed[k].x, y), dot(closed[k].x, free[k].x));
        CHECK_NEAR(remainder(angle + turn * part / length, 4 * acos(0)), 0, 1e-6);
        CHECK_NEAR(dot(closed[k].x, closed[k].z), 0, 1e-14);
        CHECK_NEAR(dot(closed[k].x, closed[k].x), 1, 1e-14);
    }
    batten_curve_unref(knot);
}

TEST(the_error_of_minimising_frames_falls_with_the_fourth_power)
{
    /* The helix: its frame after u has turned by -0.4 sqrt(1.25) u against Frenet's. */
    batten_curve *spine = helix();
    const double end = 8 * acos(0), at[] = {0, end};
    const double tolerances[] = {1e-3, 1e-6, 1e-9, 1e-12};
    for (int i = 0; i < COUNT(tolerances); i++) {
        batten_frame frames[2], frenet[2];
        double error;
        CHECK_OK(batten_curve_minimising_frames(spine, 2, at, tolerances[i], &error, frames));
        CHECK(error <= tolerances[i]);
        CHECK_OK(batten_curve_frames(spine, 2, at, BATTEN_FRAME_FRENET, frenet));
        const batten_vec3 n0 = frenet[0].x, b0 = cross(frenet[0].z, n0);
        const batten_vec3 n1 = frenet[1].x, b1 = cross(frenet[1].z, n1);
        const double turn = atan2(dot(frames[1].x, b1), dot(frames[1].x, n1)) -
                            atan2(dot(frames[0].x, b0), dot(frames[0].x, n0));
        /* What is left of tight tolerances is that the spline is not quite the helix. */
        CHECK_NEAR(remainder(turn + 0.4 * sqrt(1.25) * end, 4 * acos(0)), 0,
                   fmax(tolerances[i] / 5, 1e-6));
    }
    batten_curve_unref(spine);
}

TEST(closing_frames_of_open_spines_are_refused)
{
    batten_curve *spine = helix();
    const double at[] = {0, 1};
    batten_frame frames[2];
    double angle = 7;
    CHECK_STATUS(batten_curve_frames(spine, 2, at, BATTEN_FRAME_CLOSING, frames),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curve_holonomy(spine, 1e-6, NULL, &angle), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curve_minimising_frames(spine, 2, at, 0, NULL, frames),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_minimising_frames(spine, 2, at, NAN, NULL, frames),
                 BATTEN_BAD_ARGUMENT);
    CHECK_NEAR(angle, 7, 0);
    batten_curve_unref(spine);
}
