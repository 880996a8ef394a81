#include "picture/lines/stroke.h"

#include "picture/scenes.h"

TEST(a_circle_becomes_a_polyline_close_to_it)
{
    batten_curve *circle = scene_circle(10);
    bat_stroke stroke = {0, NULL};
    CHECK_OK(bat_stroke_curve(circle, &stroke));
    for (size_t i = 0; i < stroke.count; i++) {
        const double *p = stroke.points + 3 * i;
        CHECK_NEAR(hypot(p[0], p[1]), 10, 1e-13);
        CHECK_BITS(p[2], 0);
        if (i > 0) /* the middle of each chord too */
            CHECK_NEAR(hypot(0.5 * (p[0] + p[-3]), 0.5 * (p[1] + p[-2])), 10, 10 / 2000.0);
    }
    bat_stroke_free(&stroke);
    batten_curve_unref(circle);
}

TEST(a_polyline_keeps_its_corners_and_gets_no_others)
{
    const double corners[][3] = {{0, 0, 1}, {1, 0, 2}, {1, 1, 3}, {5, 1, 4}};
    batten_curve *curve = scene_curve(3, 1, 4, corners[0]);
    bat_stroke stroke = {0, NULL};
    CHECK_OK(bat_stroke_curve(curve, &stroke));
    CHECK_INT(stroke.count, 4);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(stroke.points[3 * i + k], corners[i][k], 1e-15);
    bat_stroke_free(&stroke);
    batten_curve_unref(curve);
}

TEST(a_curve_of_one_dimension_lies_on_the_x_axis)
{
    batten_curve *curve = scene_curve(1, 2, 3, (double[]){0, 1, 4});
    bat_stroke stroke = {0, NULL};
    CHECK_OK(bat_stroke_curve(curve, &stroke));
    for (size_t i = 0; i < stroke.count; i++)
        CHECK(stroke.points[3 * i + 1] == 0 && stroke.points[3 * i + 2] == 0);
    CHECK_NEAR(stroke.points[3 * (stroke.count - 1)], 4, 0);
    bat_stroke_free(&stroke);
    batten_curve_unref(curve);
}

TEST(G5_the_pole_of_a_sphere_is_known_as_a_point)
{
    batten_surface *sphere = scene_sphere(2);
    const batten_interval v = batten_surface_domain(sphere, BATTEN_V);
    bat_stroke pole = {0, NULL}, equator = {0, NULL};
    CHECK_OK(bat_stroke_isoline(sphere, BATTEN_V, v.a, &pole));
    CHECK_OK(bat_stroke_isoline(sphere, BATTEN_V, 0.5 * (v.a + v.b), &equator));
    CHECK(bat_stroke_is_point(&pole, 1e-12));
    CHECK(!bat_stroke_is_point(&equator, 1e-12));
    bat_stroke_free(&equator);
    bat_stroke_free(&pole);
    batten_surface_unref(sphere);
}

TEST(a_list_keeps_all_its_strokes)
{
    bat_strokes list = {0, 0, NULL};
    for (int i = 0; i < 100; i++) {
        batten_status status;
        do { /* with a failing allocation once more */
            double *points = batten_array(3, sizeof *points);
            status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
            if (points) {
                points[0] = i;
                status = bat_strokes_add(&list, (bat_stroke){1, points});
            }
        } while (test_memory_failed(status, BATTEN_OK));
        CHECK(status == BATTEN_OK);
    }
    CHECK_INT(list.count, 100);
    for (int i = 0; i < 100; i++)
        CHECK_BITS(list.strokes[i].points[0], i);
    bat_strokes_free(&list);
}
