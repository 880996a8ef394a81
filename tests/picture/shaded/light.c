#include "picture/shaded/light.h"

#include "picture/scenes.h"

#include <stdlib.h>

static const double pi = 3.14159265358979323846;
static const bat_light white = {1, 1, 1};

static bat_light light_at(const bat_scene *scene, const double n[3])
{
    return bat_light_of_sample(scene, white, 0, n);
}

TEST(a_cylinder_shows_as_many_dark_stripes_as_asked)
{
    static const double stripes[] = {1, 2, 7, 24, 60};
    const bat_view view = bat_view_make(BATTEN_VIEW_SIDE, 0, 0);
    for (int i = 0; i < COUNT(stripes); i++) {
        const bat_scene scene = bat_scene_make(BATTEN_SHADING_ZEBRA, &view, 0, stripes[i]);
        int changes = 0;
        double before = -1;
        for (int k = 0; k <= 100000; k++) {
            /* The normal turns from the lower to the upper edge; the eye is at -y. */
            const double a = pi * ((k + 0.5) / 100001 - 0.5);
            const bat_light light = light_at(&scene, (double[]){0, -cos(a), sin(a)});
            const double bright = light.red > 0.1;
            changes += before >= 0 && bright != before;
            before = bright;
        }
        /* Every stripe begins and ends, but for one that the rim may cut. */
        CHECK(abs(changes - (int)(2 * stripes[i])) <= 1);
    }
}

TEST(a_plane_shows_no_change_of_stripe_or_light)
{
    const bat_view view = bat_view_make(BATTEN_VIEW_AXONOMETRIC, 1, 0.5);
    const bat_scene scene = bat_scene_make(BATTEN_SHADING_ZEBRA, &view, 0, 24);
    const double n[] = {0.6, 0, 0.8}, turned[] = {-0.6, 0, -0.8};
    const bat_light a = light_at(&scene, n), b = light_at(&scene, turned);
    CHECK_BITS(a.red, b.red); /* both sides look alike */
    const bat_scene plain = bat_scene_make(BATTEN_SHADING_PLAIN, &view, 0, 24);
    const bat_light c = light_at(&plain, n), d = light_at(&plain, turned);
    CHECK_BITS(c.green, d.green);
}

TEST(light_comes_from_the_upper_left_and_is_never_negative)
{
    const bat_view view = bat_view_make(BATTEN_VIEW_TOP, 0, 0);
    const bat_scene scene = bat_scene_make(BATTEN_SHADING_PLAIN, &view, 0, 24);
    const bat_light albedo = bat_light_of((bat_colour){0.5, 0.5, 0.5});
    CHECK_NEAR(albedo.red, 0.25, 1e-15);
    const double tilt = sqrt(0.5);
    const bat_light lit = bat_light_of_sample(&scene, albedo, 0, (double[]){-0.5, 0.5, tilt});
    const bat_light away = bat_light_of_sample(&scene, albedo, 0, (double[]){0.5, -0.5, tilt});
    CHECK(lit.red > away.red);
    CHECK(away.red > 0);
}

TEST(the_colours_of_curvature_are_red_above_and_blue_below_zero)
{
    for (double t = 0.2; t <= 1; t += 0.1) {
        const bat_colour above = bat_colour_diverging(t), below = bat_colour_diverging(-t);
        CHECK(above.red > above.blue);
        CHECK(below.blue > below.red);
    }
    const bat_colour zero = bat_colour_diverging(0), far = bat_colour_diverging(1e9);
    CHECK(fabs(zero.red - zero.blue) < 0.02);
    CHECK(zero.red > 0.9);
    CHECK_BITS(far.red, bat_colour_diverging(1).red);
}

TEST(a_point_without_curvature_is_grey)
{
    const bat_view view = bat_view_make(BATTEN_VIEW_TOP, 0, 0);
    const bat_scene scene = bat_scene_make(BATTEN_SHADING_GAUSSIAN, &view, 0, 24);
    const bat_light light = bat_light_of_sample(&scene, white, NAN, (double[]){0, 0, 1});
    CHECK_BITS(light.red, light.blue);
    CHECK(isfinite(light.red));
}

TEST(isophotes_are_stripes_of_equal_angle_to_the_light)
{
    const bat_view view = bat_view_make(BATTEN_VIEW_AXONOMETRIC, 0.4, 0.3);
    const double stripes = 18;
    const bat_scene scene = bat_scene_make(BATTEN_SHADING_ISOPHOTES, &view, 0, stripes);
    /* From the light through the eye and on, through 2 radians: all of it faces the eye. */
    const double facing = bat_dot(3, scene.eye, scene.key), off = sqrt(1 - facing * facing);
    int changes = 0;
    double before = -1;
    for (int i = 0; i <= 20000; i++) {
        double n[3], back[3];
        for (int k = 0; k < 3; k++) {
            const double towards = (scene.eye[k] - facing * scene.key[k]) / off;
            n[k] = cos(i * 1e-4) * scene.key[k] + sin(i * 1e-4) * towards;
            back[k] = -n[k];
        }
        const bat_light light = light_at(&scene, n);
        CHECK_BITS(light.red, light_at(&scene, back).red);
        const double bright = light.red > 0.3;
        changes += before >= 0 && bright != before;
        before = bright;
    }
    CHECK_INT(changes, (int)(2 * stripes * 2 / pi));
}
