#include <batten/blend.h>
#include <batten/standard.h>
#include <stdio.h>

#include "support/faults.h"
#include "support/surfaces.h"

static batten_surface *make_plane(double x, double z)
{
    const batten_vec3 p[] = {{0, 0, 0}, {x, 0, z}, {0, 3, 0}, {x, 3, z}};
    batten_surface *plane = NULL;
    CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &plane));
    return plane;
}

/* Two planes that meet with the angle theta: a cylinder, contacts r / tan(theta / 2) from the
 * edge. */
TEST(a_ball_between_planes_leaves_a_cylinder)
{
    for (int i = 0; i < 5; i++) {
        const double theta = 0.5 + 0.5 * i, r = 0.4, far = r / tan(theta / 2);
        batten_surface *a = make_plane(4, 0), *b = make_plane(4 * cos(theta), 4 * sin(theta));
        const batten_surface *const pair[2] = {a, b};
        const double radii[2] = {r, -r};
        batten_surface_fillet fillet;
        CHECK_EACH_ALLOCATION(batten_surfaces_fillet(pair, radii, NULL, 1e-9, &fillet));
        CHECK_NEAR(fillet.least, acos(-1) - theta, 1e-9);
        CHECK_NEAR(fillet.most, acos(-1) - theta, 1e-9);
        const batten_interval u = batten_curve_domain(fillet.spine);
        CHECK_NEAR(u.b - u.a, 3, 1e-9);
        CHECK(fillet.error <= 1e-9 && fillet.stations >= 7);
        /* Both planes end there. */
        for (int end = 0; end < 2; end++)
            CHECK(fillet.ends[end] == BATTEN_FILLET_BORDER_1 ||
                  fillet.ends[end] == BATTEN_FILLET_BORDER_2);
        for (int k = 0; k < 30; k++) {
            double p[3], c[3];
            const double s = u.a + (u.b - u.a) * (k / 29.0);
            CHECK_OK(batten_surface_evaluate(fillet.surface, s, fmod(0.37 * k, 1), 0, p));
            CHECK_OK(batten_curve_evaluate(fillet.spine, s, 0, c));
            CHECK_NEAR(hypot(p[0] - c[0], p[2] - c[2]), r, 1e-11);
            CHECK_NEAR(c[0], far, 1e-11);
            CHECK_NEAR(c[2], r, 1e-11);
            CHECK_OK(batten_curve_evaluate(fillet.contacts[1], s, 0, p));
            CHECK_NEAR(hypot(p[0], p[2]), far, 1e-11);
            CHECK_OK(batten_curve_evaluate(fillet.contacts[0], s, 0, p));
            CHECK_NEAR(p[0], far, 1e-11);
            CHECK_NEAR(p[1], c[1], 1e-11);
            CHECK_NEAR(p[2], 0, 1e-11);
            for (int side = 0; side < 2; side++) {
                CHECK_OK(batten_curve_evaluate(fillet.on[side], s, 0, p));
                CHECK_NEAR(p[0], far / 4, 1e-11);
                CHECK_NEAR(p[1], c[1] / 3, 1e-11);
            }
        }
        batten_surface_fillet_release(&fillet);
        batten_surface_unref(a);
        batten_surface_unref(b);
    }
}

/* A pipe that stands on a plane: the fillet is a part of a torus. */
TEST(a_ball_around_a_pipe_on_a_plane_leaves_a_torus)
{
    const batten_frame frame = batten_frame_world();
    const batten_vec3 p[] = {{-4, -4, 0}, {4, -4, 0}, {-4, 4, 0}, {4, 4, 0}};
    batten_surface *pipe = NULL, *plane = NULL;
    CHECK_OK(batten_surface_cylinder(&frame, 1, 3, &pipe));
    CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &plane));
    batten_vec3 n;
    CHECK_OK(batten_surface_normal(pipe, 0.1, 0.5, NULL, &n));
    const batten_surface *const pair[2] = {pipe, plane};
    const double radii[2] = {n.x > 0 ? 0.5 : -0.5, 0.5};
    batten_surface_fillet fillet;
    CHECK_EACH_ALLOCATION(batten_surfaces_fillet(pair, radii, NULL, 1e-6, &fillet));
    CHECK(fillet.error <= 1e-6);
    const batten_interval u = batten_curve_domain(fillet.spine);
    CHECK_NEAR(u.b - u.a, 2 * acos(-1) * 1.5, 0.01);
    for (int k = 0; k < 60; k++) {
        double q[3];
        const double s = u.a + (u.b - u.a) * (k / 59.0);
        CHECK_OK(batten_surface_evaluate(fillet.surface, s, fmod(0.37 * k, 1), 0, q));
        CHECK_NEAR(hypot(hypot(q[0], q[1]) - 1.5, q[2] - 0.5), 0.5, 2e-6);
        CHECK_OK(batten_curve_evaluate(fillet.contacts[0], s, 0, q));
        CHECK_NEAR(hypot(q[0], q[1]), 1, 2e-6);
        CHECK_NEAR(q[2], 0.5, 2e-6);
    }
    batten_surface_fillet_release(&fillet);
    batten_surface_unref(pipe);
    batten_surface_unref(plane);
}

TEST(G5_balls_that_do_not_fit_are_refused)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *a = make_plane(1, 0), *b = make_plane(0, 1), *pipe = NULL;
    const batten_surface *const pair[2] = {a, b};
    batten_surface_fillet fillet;
    const double large[2] = {5, -5}, none[2] = {0, 0}, bad[2] = {(double)NAN, 1};
    CHECK_STATUS(batten_surfaces_fillet(pair, large, NULL, 1e-6, &fillet), BATTEN_NOT_FOUND);
    CHECK_STATUS(batten_surfaces_fillet(pair, none, NULL, 1e-6, &fillet), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surfaces_fillet(pair, bad, NULL, 1e-6, &fillet), BATTEN_NOT_FINITE);
    batten_surface_unref(b);
    /* Inside of a pipe of radius 1 across the plane. */
    const batten_vec3 p[] = {{-4, -4, 1}, {4, -4, 1}, {-4, 4, 1}, {4, 4, 1}};
    CHECK_OK(batten_surface_cylinder(&frame, 1, 3, &pipe));
    CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &b));
    batten_vec3 n;
    CHECK_OK(batten_surface_normal(pipe, 0.1, 0.5, NULL, &n));
    const batten_surface *const inside[2] = {pipe, b};
    const double radii[2] = {n.x > 0 ? -1.2 : 1.2, 1.2};
    CHECK_STATUS(batten_surfaces_fillet(inside, radii, NULL, 1e-6, &fillet),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("does not fit on surface 1");
    batten_surface_unref(a);
    batten_surface_unref(b);
    batten_surface_unref(pipe);
}

/* Two planes of the size 1e80, and 1e-80. */
TEST(K7_huge_and_tiny_fillets)
{
    const double scales[] = {1e80, 1e-80};
    for (int i = 0; i < 2; i++) {
        const double s = scales[i], radii[2] = {0.3 * s, -0.3 * s};
        const batten_vec3 p[] = {{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {s, s, 0}};
        const batten_vec3 q[] = {{0, 0, 0}, {0, 0, s}, {0, s, 0}, {0, s, s}};
        batten_surface *a = NULL, *b = NULL;
        batten_surface_fillet fillet;
        double c[3];
        CHECK_OK(batten_surface_bilinear(p[0], p[1], p[2], p[3], &a));
        CHECK_OK(batten_surface_bilinear(q[0], q[1], q[2], q[3], &b));
        const batten_surface *const pair[2] = {a, b};
        CHECK_OK(batten_surfaces_fillet(pair, radii, NULL, 1e-6 * s, &fillet));
        CHECK_OK(
            batten_curve_evaluate(fillet.spine, batten_curve_domain(fillet.spine).a, 0, c));
        CHECK_NEAR(c[0] / s, 0.3, 1e-12);
        CHECK_NEAR(c[2] / s, 0.3, 1e-12);
        batten_surface_fillet_release(&fillet);
        batten_surface_unref(a);
        batten_surface_unref(b);
    }
}

/* On both contacts the fillet has the normals of the surfaces. */
TEST(a_fillet_is_tangent_to_both_surfaces)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *a = NULL, *b = NULL;
    batten_surface_fillet fillet;
    batten_frame aside = frame;
    aside.origin.x = 1.5;
    CHECK_OK(batten_surface_sphere(&frame, 1, &a));
    CHECK_OK(batten_surface_sphere(&aside, 1.2, &b));
    const batten_surface *const pair[2] = {a, b};
    const double radii[2] = {0.4, 0.4}, start[4] = {0.1, 0.5, 0.4, 0.5};
    CHECK_OK(batten_surfaces_fillet(pair, radii, start, 1e-7, &fillet));
    const batten_interval u = batten_curve_domain(fillet.spine);
    for (int i = 0; i < 40; i++) {
        const double s = u.a + (u.b - u.a) * (i + 0.3) / 40;
        for (int k = 0; k < 2; k++) {
            batten_vec3 n, m;
            double on[2];
            CHECK_OK(batten_curve_evaluate(fillet.on[k], s, 0, on));
            CHECK_OK(batten_surface_normal(fillet.surface, s, k, NULL, &n));
            CHECK_OK(batten_surface_normal(pair[k], on[0], on[1], NULL, &m));
            CHECK_NEAR(fabs(n.x * m.x + n.y * m.y + n.z * m.z), 1, 1e-6);
        }
    }
    batten_surface_fillet_release(&fillet);
    batten_surface_unref(a);
    batten_surface_unref(b);
}

TEST(radii_and_starts_that_cannot_be_are_named_with_their_numbers)
{
    static const struct {
        double radii[2], tolerance;
        batten_status status;
        const char *message;
    } rows[] = {
        {{NAN, 1}, 1e-3, BATTEN_NOT_FINITE, "radii nan and 1, within 0.001"},
        {{1, INFINITY}, 1e-3, BATTEN_NOT_FINITE, "radii 1 and inf, within 0.001"},
        {{1, 1}, NAN, BATTEN_NOT_FINITE, "radii 1 and 1, within nan"},
        {{0, 0}, 1e-3, BATTEN_BAD_ARGUMENT, "radii 0 and 0, within 0.001: one radius and a"},
        {{1, 2}, 1e-3, BATTEN_BAD_ARGUMENT, "radii 1 and 2, within 0.001: one radius and a"},
        {{1, -1},
         0,
         BATTEN_BAD_ARGUMENT,
         "radii 1 and -1, within 0: one radius and a tolerance"},
    };
    static const double knots[4] = {0, 0, 1, 1}, z[4] = {0, 1, 2, 3};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *a = make_plane(1, 0), *b = make_plane(0, 1), *function = NULL;
    const batten_surface *const pair[2] = {a, b};
    batten_surface_fillet fillet;
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(
            batten_surfaces_fillet(pair, rows[i].radii, NULL, rows[i].tolerance, &fillet),
            rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
    const double radii[2] = {1, 1};
    CHECK_OK(batten_surface_create(1, &axis, &axis, z, NULL, &function));
    const batten_surface *const flat[2] = {a, function};
    CHECK_STATUS(batten_surfaces_fillet(flat, radii, NULL, 1e-3, &fillet), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("surface 2 is not a NURBS surface in space");
    for (int i = 0; i < 8; i++) {
        double start[4] = {0.5, 0.5, 0.5, 0.5};
        char words[60];
        start[i / 2] = i % 2 ? 9 : -9;
        snprintf(words, sizeof words, "the start %g on surface %d is outside", start[i / 2],
                 i / 4 + 1);
        CHECK_STATUS(batten_surfaces_fillet(pair, radii, start, 1e-3, &fillet),
                     BATTEN_OUT_OF_DOMAIN);
        CHECK_MESSAGE(words);
    }
    batten_surface_unref(function);
    batten_surface_unref(a);
    batten_surface_unref(b);
}
