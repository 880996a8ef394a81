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

TEST(points_are_counted_over_curves_surfaces_and_the_faces_of_bodies)
{
    test_random random = test_random_begin(__func__);
    batten_model *model = NULL;
    batten_curve *curve = random_curve(&random);
    batten_surface *surface = random_surface(&random);
    batten_body *body = NULL;
    const long long of_curve = batten_curve_point_count(curve);
    const long long of_surface = (long long)batten_surface_point_count(surface, BATTEN_U) *
                                 batten_surface_point_count(surface, BATTEN_V);
    CHECK_OK(batten_model_create(1, &model));
    CHECK_INT((long long)bat_count_points(model), 0);
    add_curve(model, "c", curve);
    CHECK_INT((long long)bat_count_points(model), of_curve);
    add_surface(model, "s", surface);
    CHECK_INT((long long)bat_count_points(model), of_curve + of_surface);
    const batten_status status = batten_body_from_surface("b", surface, 1e-6, &body);
    if (status == BATTEN_OK) {
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = "b", .kind = BATTEN_OBJECT_BODY, .body = body}));
        CHECK_INT((long long)bat_count_points(model), of_curve + 2 * of_surface);
    }
    batten_body_unref(body);
    batten_surface_unref(surface);
    batten_curve_unref(curve);
    batten_model_unref(model);
}

TEST(each_direction_is_clamped_where_an_end_is_not)
{
    const double points[] = {0, 0, 0, 0, 0, 4, 2, 0, 0, 2, 0, 4,
                             4, 2, 0, 4, 2, 4, 6, 3, 0, 6, 3, 4};
    const double line[] = {0, 0, 1, 1};
    /* Clamped nowhere, at the start, at the end. */
    static const double knots[][7] = {
        {0, 1, 2, 3, 4, 5, 6}, {2, 2, 2, 3, 4, 5, 6}, {0, 1, 2, 3, 4, 4, 4}};
    for (int n = 0; n < COUNT(knots); n++)
        for (int across = 0; across < 2; across++) {
            const batten_axis along = {2, 4, knots[n], false}, up = {1, 2, line, false};
            double turned[24];
            for (int i = 0; i < 4; i++)
                for (int j = 0; j < 2; j++)
                    memcpy(turned + 3 * (4 * j + i), points + 3 * (2 * i + j),
                           3 * sizeof(double));
            batten_surface *surface = NULL, *prepared = NULL;
            CHECK_OK(batten_surface_create(3, across ? &up : &along, across ? &along : &up,
                                           across ? turned : points, NULL, &surface));
            CHECK_OK(bat_prepare_surface(&(batten_object){.name = "", .surface = surface}, 1e-6,
                                         NULL, &prepared));
            const double *made = batten_surface_knots(prepared, across ? BATTEN_V : BATTEN_U);
            const int count = batten_surface_knot_count(prepared, across ? BATTEN_V : BATTEN_U);
            CHECK(made[0] == 2 && made[2] == 2 && made[count - 1] == 4 && made[count - 3] == 4);
            for (int i = 0; i <= 10; i++) {
                const double t = 2 + i / 5.0;
                double p[3], q[3];
                CHECK_OK(batten_surface_evaluate(surface, across ? 0.25 : t, across ? t : 0.25,
                                                 0, p));
                CHECK_OK(batten_surface_evaluate(prepared, across ? 0.25 : t, across ? t : 0.25,
                                                 0, q));
                for (int k = 0; k < 3; k++)
                    CHECK_NEAR(q[k], p[k], 1e-14);
            }
            batten_surface_unref(prepared);
            batten_surface_unref(surface);
        }
}
