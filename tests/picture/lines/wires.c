#include "picture/lines/wires.h"

#include "picture/scenes.h"

/* What lines a surface has, and where the eye sees points. */

static bat_wires gather_wires(batten_model *model, batten_draw_options *options)
{
    bat_wires wires = {.model = model, .options = options};
    CHECK_OK(bat_wires_measure(&wires));
    CHECK_OK(bat_wires_gather(&wires, 100));
    return wires;
}

static int count_of(const bat_wires *wires, bat_wire_kind kind)
{
    int count = 0;
    for (size_t i = 0; i < wires->count; i++)
        count += wires->wires[i].kind == kind;
    return count;
}

/* A rectangle 4 x 3 that rises by 2 along y. */
static batten_model *ramp(void)
{
    static const double points[] = {0, 0, 0, 0, 3, 2, 4, 0, 0, 4, 3, 2};
    return scene_of(scene_net(1, 2, 1, 2, points));
}

TEST(a_plane_patch_has_four_edges_and_isolines_between_them)
{
    for (int isolines = 1; isolines <= 7; isolines += 3) {
        batten_model *model = ramp();
        batten_draw_options options = batten_draw_defaults();
        options.isolines = isolines;
        bat_wires wires = gather_wires(model, &options);
        CHECK_INT(count_of(&wires, BAT_WIRE_EDGE), 4);
        CHECK_INT(count_of(&wires, BAT_WIRE_ISOLINE), 2 * (isolines - 1));
        CHECK_INT(count_of(&wires, BAT_WIRE_CONTOUR), 0);
        for (size_t i = 0; i < wires.count; i++) {
            const bat_stroke *s = &wires.wires[i].stroke;
            const double *p = s->points, *q = s->points + 3 * (s->count - 1);
            /* Each is straight, and crosses the whole patch. */
            const double length = hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
            CHECK(fabs(length - 4) < 1e-12 || fabs(length - sqrt(13)) < 1e-12);
            CHECK_NEAR(3 * p[2], 2 * p[1], 1e-12);
        }
        bat_wires_free(&wires);
        batten_model_unref(model);
    }
}

TEST(contours_are_level_and_as_far_apart_as_asked)
{
    batten_model *model = ramp();
    batten_draw_options options = batten_draw_defaults();
    options.contours = true;
    options.contour_spacing = 0.5;
    bat_wires wires = gather_wires(model, &options);
    CHECK_NEAR(wires.level_step, 0.5, 1e-15);
    CHECK(count_of(&wires, BAT_WIRE_CONTOUR) >= 3);
    for (size_t i = 0; i < wires.count; i++)
        if (wires.wires[i].kind == BAT_WIRE_CONTOUR) {
            const bat_wire *w = &wires.wires[i];
            CHECK_NEAR(remainder(w->value, 0.5), 0, 1e-12);
            for (size_t k = 0; k < w->stroke.count; k++)
                CHECK_NEAR(w->stroke.points[3 * k + 2], w->value, 1e-9);
        }
    bat_wires_free(&wires);
    batten_model_unref(model);
}

TEST(poles_and_smooth_seams_are_no_edges)
{
    batten_model *model = scene_of(scene_sphere(2));
    batten_draw_options options = batten_draw_defaults();
    bat_wires wires = gather_wires(model, &options);
    for (size_t i = 0; i < wires.count; i++) {
        const bat_stroke *s = &wires.wires[i].stroke;
        double far = 0;
        for (size_t k = 0; k < s->count; k++) {
            const double *p = s->points + 3 * k;
            CHECK_NEAR(hypot(hypot(p[0], p[1]), p[2]), 2, 1e-9);
            far = fmax(far, hypot(hypot(p[0] - s->points[0], p[1] - s->points[1]),
                                  p[2] - s->points[2]));
        }
        CHECK(far > 1e-3);
    }
    CHECK_INT(count_of(&wires, BAT_WIRE_EDGE), 0);
    bat_wires_free(&wires);
    batten_model_unref(model);
}

TEST(the_silhouette_of_a_sphere_is_a_circle_across_the_view)
{
    batten_model *model = scene_of(scene_sphere(2));
    batten_draw_options options = batten_draw_defaults();
    options.silhouettes = true;
    bat_wires wires = gather_wires(model, &options);
    const bat_eye eye = {.view = bat_view_make(BATTEN_VIEW_AXONOMETRIC, 0.3, 0.2)};
    CHECK_OK(bat_wires_add_silhouettes(&wires, &eye));
    CHECK(count_of(&wires, BAT_WIRE_SILHOUETTE) >= 1);
    for (size_t i = 0; i < wires.count; i++)
        if (wires.wires[i].kind == BAT_WIRE_SILHOUETTE) {
            const bat_stroke *s = &wires.wires[i].stroke;
            for (size_t k = 0; k < s->count; k++) {
                double q[3];
                bat_eye_project(&eye, s->points + 3 * k, q);
                CHECK_NEAR(hypot(q[0], q[1]), 2, 0.02);
                CHECK_NEAR(q[2], 0, 0.05);
            }
        }
    bat_wires_free(&wires);
    batten_model_unref(model);
}

TEST(perspective_divides_by_the_distance_from_the_eye)
{
    const bat_eye parallel = {.view = bat_view_make(BATTEN_VIEW_TOP, 0, 0),
                              .centre = {1, 2, 3}};
    bat_eye near = parallel;
    near.distance = 10;
    const double at[3] = {2, 4, 8};
    double p[3], q[3];
    bat_eye_project(&parallel, at, p);
    bat_eye_project(&near, at, q);
    /* 5 nearer to the eye, half of its distance: all is twice as large. */
    CHECK_NEAR(p[2], 5, 1e-12);
    CHECK_NEAR(hypot(p[0], p[1]), hypot(1, 2), 1e-12);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(q[k], 2 * p[k], 1e-12);
}
