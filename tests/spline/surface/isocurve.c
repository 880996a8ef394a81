#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"

TEST(an_isocurve_lies_on_its_surface_and_keeps_the_knots)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        surface_data_random(&random, 4, &data);
        const batten_direction fixed = c % 2 ? BATTEN_U : BATTEN_V, along = bat_other(fixed);
        batten_surface *surface = NULL;
        batten_curve *curve = NULL;
        CHECK_OK(surface_data_create(&data, &surface));
        const double at = random_parameter(&random, surface, fixed);
        CHECK_OK(batten_surface_isocurve(surface, fixed, at, &curve));
        CHECK_INT(batten_curve_knot_count(curve), batten_surface_knot_count(surface, along));
        CHECK(memcmp(batten_curve_knots(curve), batten_surface_knots(surface, along),
                     sizeof(double) * (size_t)batten_curve_knot_count(curve)) == 0);
        CHECK(batten_curve_is_periodic(curve) == batten_surface_is_periodic(surface, along));
        for (int i = 0; i < 10; i++) {
            const double t = random_parameter(&random, surface, along);
            double on_surface[3], on_curve[3];
            CHECK_OK(batten_surface_evaluate(surface, fixed == BATTEN_U ? at : t,
                                             fixed == BATTEN_U ? t : at, 0, on_surface));
            CHECK_OK(batten_curve_evaluate(curve, t, 0, on_curve));
            for (int k = 0; k < data.dimension; k++)
                CHECK_NEAR(on_curve[k], on_surface[k], 1e-13 * 10);
        }
        batten_curve_unref(curve);
        batten_surface_unref(surface);
    }
}

TEST(an_isocurve_outside_is_refused)
{
    static const double knots[] = {0, 0, 1, 1}, points[] = {0, 1, 2, 3};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    batten_curve *curve = NULL;
    CHECK_OK(batten_surface_create(1, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(batten_surface_isocurve(surface, BATTEN_V, 1.5, &curve), BATTEN_OUT_OF_DOMAIN);
    CHECK(curve == NULL);
    batten_surface_unref(surface);
}
