#include "exchange/shapes/prepare.h"

#include "exchange/shapes.h"

TEST(clamped_shapes_keep_their_bits)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(20); i++) {
        batten_surface *surface = random_surface(&random), *prepared = NULL;
        batten_curve *curve = random_curve(&random), *ready = NULL;
        CHECK_OK(bat_prepare_surface(&(batten_object){.name = "", .surface = surface}, 1e-6,
                                     NULL, &prepared));
        CHECK_OK(bat_prepare_curve(&(batten_object){.name = "", .curve = curve}, &ready));
        check_same_surface(surface, prepared);
        check_same_curve(curve, ready);
        batten_surface_unref(surface);
        batten_surface_unref(prepared);
        batten_curve_unref(curve);
        batten_curve_unref(ready);
    }
}

TEST(a_periodic_surface_is_clamped)
{
    const double points[] = {0, 0, 0, 0, 0, 4, 2, 0, 0, 2, 0, 4,
                             2, 2, 0, 2, 2, 4, 0, 2, 0, 0, 2, 4};
    const double u[] = {0, 1, 2, 3, 4}, v[] = {0, 0, 1, 1};
    const batten_axis around = {2, 4, u, true}, up = {1, 2, v, false};
    batten_surface *surface = NULL, *prepared = NULL;
    CHECK_OK(batten_surface_create(3, &around, &up, points, NULL, &surface));
    CHECK_OK(bat_prepare_surface(&(batten_object){.name = "", .surface = surface}, 1e-6, NULL,
                                 &prepared));
    const double *knots = batten_surface_knots(prepared, BATTEN_U);
    CHECK(knots[0] == knots[2] && !batten_surface_is_periodic(prepared, BATTEN_U));
    for (int i = 0; i <= 40; i++) {
        double p[3], q[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 10.0, 0.25, 0, p));
        CHECK_OK(batten_surface_evaluate(prepared, i / 10.0, 0.25, 0, q));
        CHECK_NEAR(hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]), 0, 1e-14);
    }
    batten_surface_unref(prepared);
    batten_surface_unref(surface);
}

TEST(a_surface_in_the_plane_is_refused)
{
    const double points[] = {0, 0, 1, 0, 0, 1, 1, 1}, knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL, *prepared = NULL;
    CHECK_OK(batten_surface_create(2, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(bat_prepare_surface(&(batten_object){.name = "flat", .surface = surface}, 1e-6,
                                     NULL, &prepared),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("surface 'flat' has 2 dimensions");
    batten_surface_unref(surface);
}
