/* Surfaces under deformations: images with all their derivatives, and splines near them. */
#include "support/faults.h"
#include "support/lattices.h"
#include "support/surfaces.h"

#include <batten/standard.h>

/* A ball of radius 0.45 in the box. */
static batten_surface *ball(void)
{
    batten_frame frame = batten_frame_world();
    frame.origin = (batten_vec3){0.4, 0.5, 0.3};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 0.45, &surface));
    return surface;
}

static batten_deformation *shaken(test_random *random, int count, int degree, double by)
{
    const batten_lattice l = test_lattice(count, degree);
    double points[3 * LATTICE_MOST];
    batten_deformation *d = NULL;
    test_lattice_shaken(random, &l, by, 0, points);
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    return d;
}

static double distance_from_image(const batten_surface *surface, const batten_deformation *d,
                                  const batten_surface *made)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                          v = batten_surface_domain(surface, BATTEN_V);
    double most = 0;
    for (int i = 0; i <= 60; i++)
        for (int j = 0; j <= 60; j++) {
            const double s = i < 60 ? u.a + (u.b - u.a) * i / 60 : u.b;
            const double t = j < 60 ? v.a + (v.b - v.a) * j / 60 : v.b;
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(surface, s, t, 0, p));
            CHECK_OK(batten_deformation_apply(d, (batten_points){3, 1, p}, p));
            CHECK_OK(batten_surface_evaluate(made, s, t, 0, q));
            most = fmax(most, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
        }
    return most;
}

TEST(the_spline_is_within_the_tolerance_of_the_image_of_a_ball_and_stays_closed)
{
    static const double tolerances[] = {1e-2, 1e-4, 1e-6};
    test_random random = test_random_begin("ball");
    batten_surface *given = ball();
    for (int k = 0; k < COUNT(tolerances); k++) {
        batten_deformation *d = shaken(&random, 4 + k, 3, 0.03);
        batten_surface *made = NULL;
        double error = -1;
        CHECK_OK(batten_surface_deform(given, d, tolerances[k], &error, &made));
        CHECK(error > 0 && error <= tolerances[k]);
        CHECK(distance_from_image(given, d, made) <= tolerances[k]);
        CHECK(batten_surface_is_closed(made, BATTEN_U, 1e-12));
        batten_surface_unref(made);
        batten_deformation_unref(d);
    }
    batten_surface_unref(given);
}

/* Each derivative of the image is the difference quotient of the one below. */
TEST(derivatives_of_the_image_are_those_of_its_points)
{
    test_random random = test_random_begin("derivatives");
    batten_deformation *d = shaken(&random, 6, 3, 0.03);
    batten_surface *given = ball(), *image = NULL;
    CHECK_OK(batten_surface_deform(given, d, 0, NULL, &image));
    CHECK_TEXT(batten_surface_kind(image), "deformed");
    const double h = 1e-5;
    for (int trial = 0; trial < 10; trial++) {
        const batten_interval a = batten_surface_domain(given, BATTEN_U),
                              b = batten_surface_domain(given, BATTEN_V);
        const double u = test_random_in(&random, a.a, a.b - h),
                     v = test_random_in(&random, b.a, b.b - h);
        double at[30], more[30], across[30];
        CHECK_OK(batten_surface_evaluate(image, u, v, 3, at));
        CHECK_OK(batten_surface_evaluate(image, u + h, v, 3, more));
        CHECK_OK(batten_surface_evaluate(image, u, v + h, 3, across));
        for (int k = 0; k < 3; k++)
            for (int l = 0; k + l < 3; l++)
                for (int c = 0; c < 3; c++) {
                    const int from = 3 * BATTEN_SURFACE_DERIVATIVE(k, l) + c;
                    const double size = 1e-3 * (1 + fabs(at[from]) + fabs(more[from]));
                    const double by_u = at[3 * BATTEN_SURFACE_DERIVATIVE(k + 1, l) + c];
                    const double by_v = at[3 * BATTEN_SURFACE_DERIVATIVE(k, l + 1) + c];
                    CHECK_NEAR((more[from] - at[from]) / h, by_u, size * (1 + fabs(by_u)));
                    CHECK_NEAR((across[from] - at[from]) / h, by_v, size * (1 + fabs(by_v)));
                }
    }
    batten_surface_unref(image);
    batten_surface_unref(given);
    batten_deformation_unref(d);
}

TEST(images_of_low_degree_are_exact)
{
    static const double corners[] = {-1, 0, -2, -1, 1, -2, 2, 0, 2, 2, 1, 2},
                        knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_lattice l;
    double points[3 * 27], error = 1;
    batten_deformation *d = NULL;
    batten_surface *flat = NULL, *made = NULL;
    test_lattice_sheared(0.1, &l, points);
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_surface_create(3, &axis, &axis, corners, NULL, &flat));
    CHECK_EACH_ALLOCATION(batten_surface_deform(flat, d, 1e-6, &error, &made));
    CHECK(error < 1e-14);
    CHECK(distance_from_image(flat, d, made) < 1e-14);
    CHECK_INT(batten_surface_spans(made, BATTEN_U, NULL), 2);
    batten_surface_unref(made);
    batten_surface_unref(flat);
    batten_deformation_unref(d);
}

TEST(surfaces_that_cannot_be_deformed_are_refused)
{
    const batten_lattice l = test_lattice(4, 3);
    const batten_frame frame = batten_frame_world();
    double points[3 * 64];
    batten_deformation *d = NULL;
    batten_surface *large = NULL, *given = ball(), *none = NULL;
    CHECK_OK(batten_lattice_home(&l, points));
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_surface_sphere(&frame, 1, &large));
    CHECK_STATUS(batten_surface_deform(large, d, 1e-3, NULL, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("the surface reaches 1 out of the box where y is least");
    CHECK_STATUS(batten_surface_deform(given, d, -1, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_deform(given, d, NAN, NULL, &none), BATTEN_BAD_ARGUMENT);
    batten_deformation_unref(d);
    d = NULL;
    points[0] += 5; /* a corner beyond all others */
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_STATUS(batten_surface_deform(given, d, 1e-3, NULL, &none), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the deformation folds");
    CHECK(none == NULL);
    batten_surface_unref(large);
    batten_surface_unref(given);
    batten_deformation_unref(d);
}
