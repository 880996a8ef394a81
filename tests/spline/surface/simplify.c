#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"

TEST(a_knot_inserted_can_be_removed_and_an_elevated_degree_reduced)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        batten_surface *surface, *more, *back, *higher, *lower;
        surface_data_random(&random, 4, &data);
        CHECK_OK(surface_data_create(&data, &surface));
        const batten_direction direction = c % 2 ? BATTEN_U : BATTEN_V;
        const batten_interval domain = batten_surface_domain(surface, direction);
        const double at = domain.a + (domain.b - domain.a) * test_random_in(&random, 0.2, 0.8);
        CHECK_OK(batten_surface_insert_knot(surface, direction, at, 1, &more));
        int removed;
        double error;
        CHECK_OK(batten_surface_remove_knot(more, (batten_knot_line){direction, at, 1}, 1e-9,
                                            &removed, &error, &back));
        CHECK_INT(removed, 1);
        CHECK(error >= 0 && error <= 1e-9);
        CHECK_INT(batten_surface_point_count(back, direction),
                  batten_surface_point_count(more, direction) - 1);
        check_same_shape(surface, back, error + 1e-12);
        CHECK_OK(batten_surface_elevate(surface, direction, 1, &higher));
        CHECK_OK(batten_surface_reduce(higher, direction,
                                       batten_surface_degree(surface, direction), 1e-8, &error,
                                       &lower));
        CHECK(error <= 1e-8);
        check_same_shape(surface, lower, error + 1e-11);
        batten_surface *all[] = {surface, more, back, higher, lower};
        for (int i = 0; i < COUNT(all); i++)
            batten_surface_unref(all[i]);
    }
}

/* The shape never moves farther than the bound that is reported. */
TEST(a_knot_removed_within_a_tolerance_keeps_to_it)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        batten_surface *surface, *made;
        surface_data_random(&random, 4, &data);
        CHECK_OK(surface_data_create(&data, &surface));
        double breaks[64];
        if (batten_surface_spans(surface, BATTEN_U, breaks) > 2) {
            int removed;
            double error;
            CHECK_OK(batten_surface_remove_knot(surface,
                                                (batten_knot_line){BATTEN_U, breaks[1], 3},
                                                1000, &removed, &error, &made));
            CHECK(error <= 1000 && removed >= 0);
            check_same_shape(surface, made, error * (1 + 1e-9) + 1e-11);
            batten_surface_unref(made);
        }
        batten_surface_unref(surface);
    }
}

TEST(N6_what_cannot_be_simplified_is_refused)
{
    static const double u[] = {0, 0, 0, 1, 2, 2, 2}, v[] = {0, 0, 1, 1},
                        points[8] = {0, 1, 20, 3, 4, -50, 6, 7};
    const batten_axis axes[2] = {{2, 4, u, false}, {1, 2, v, false}};
    batten_surface *surface = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(1, &axes[0], &axes[1], points, NULL, &surface));
    CHECK_STATUS(batten_surface_remove_knot(surface, (batten_knot_line){BATTEN_U, 0.5, 1}, 1,
                                            NULL, NULL, &made),
                 BATTEN_NOT_FOUND);
    CHECK_STATUS(batten_surface_remove_knot(surface, (batten_knot_line){BATTEN_U, 0, 1}, 1,
                                            NULL, NULL, &made),
                 BATTEN_NOT_FOUND);
    CHECK_STATUS(batten_surface_remove_knot(surface, (batten_knot_line){BATTEN_U, NAN, 1}, 1,
                                            NULL, NULL, &made),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_remove_knot(surface, (batten_knot_line){BATTEN_U, 1, -1}, 1,
                                            NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_remove_knot(surface, (batten_knot_line){BATTEN_U, 1, 1}, -1,
                                            NULL, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_reduce(surface, BATTEN_U, 1, 1e-6, NULL, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_STATUS(batten_surface_reduce(surface, BATTEN_U, 3, 1, NULL, &made),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_surface_reduce(surface, BATTEN_U, 0, 1, NULL, &made),
                 BATTEN_BAD_DEGREE);
    CHECK(made == NULL);
    CHECK_OK(batten_surface_remove_knot(surface, (batten_knot_line){BATTEN_U, 1, 1}, 1e-6, NULL,
                                        NULL, &made));
    CHECK_INT(batten_surface_point_count(made, BATTEN_U), 4);
    batten_surface_unref(made);
    batten_surface_unref(surface);
}
