/* The bicubic patch through sixteen points. */
#include <batten/standard.h>

#include "support/test.h"

TEST(the_patch_passes_its_sixteen_points_and_reproduces_bicubics)
{
    test_random random = test_random_begin("sixteen");
    double points[48], net[48];
    const double unit[2] = {0, 1};
    batten_surface *given = NULL, *made = NULL;
    for (int i = 0; i < 48; i++)
        net[i] = test_random_in(&random, -3, 5);
    CHECK_OK(batten_surface_from_bezier(3, (batten_pieces){3, 1, unit},
                                        (batten_pieces){3, 1, unit}, net, NULL, &given));
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            CHECK_OK(
                batten_surface_evaluate(given, i / 3.0, j / 3.0, 0, points + 3 * (4 * i + j)));
    CHECK_OK(batten_surface_sixteen_points(points, &made));
    for (int i = 0; i < 48; i++)
        CHECK_NEAR(batten_surface_points(made)[i], net[i], 1e-12);
    batten_surface_unref(made);
    batten_surface_unref(given);
}

TEST(S1_sixteen_points_are_finite)
{
    double points[48] = {0};
    batten_surface *none = NULL;
    points[16] = NAN;
    CHECK_STATUS(batten_surface_sixteen_points(points, &none), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of point 6");
    CHECK(none == NULL);
}
