#include "picture/scenes.h"

#include <stdlib.h>

#include <batten/base.h>

static batten_draw_options small(batten_shading shading)
{
    batten_draw_options options = batten_draw_defaults();
    options.width = 300;
    options.height = 200;
    options.shading = shading;
    return options;
}

static scene_image image_of(const batten_model *model, batten_draw_options options)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_shaded(model, &options, NULL, &data, &size));
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    return image;
}

/* The background of each row is what its left edge shows. */
static bool is_covered(const scene_image *image, int x, int y)
{
    return scene_pixel(image, x, y) != scene_pixel(image, 0, y);
}

TEST(a_sphere_is_a_disc_of_its_radius)
{
    batten_model *model = scene_of(scene_sphere(7));
    const scene_image image = image_of(model, small(BATTEN_SHADING_PLAIN));
    int left = image.width, right = 0, top = image.height, bottom = 0, area = 0;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            if (!is_covered(&image, x, y))
                continue;
            area++;
            left = x < left ? x : left;
            right = x > right ? x : right;
            top = y < top ? y : top;
            bottom = y > bottom ? y : bottom;
        }
    /* em is 5, above and below two of them stay free: the disc is 180 pixels high. */
    const double radius = 90, pi = 3.14159265358979323846;
    CHECK_NEAR(bottom - top + 1, 2 * radius, 1.01);
    CHECK_NEAR(right - left + 1, 2 * radius, 1.01);
    /* Pixels that the rim only touches count: half a pixel more, all around. */
    CHECK_NEAR(area, pi * (radius + 0.4) * (radius + 0.4), 0.01 * pi * radius * radius);
    batten_model_unref(model);
}

TEST(the_zebra_of_a_cylinder_has_as_many_stripes_as_asked)
{
    static const int stripes[] = {5, 12, 24};
    batten_model *model = scene_of(scene_cylinder(1, 3));
    for (int i = 0; i < test_cases(COUNT(stripes)); i++) {
        batten_draw_options options = small(BATTEN_SHADING_ZEBRA);
        options.width = 600;
        options.height = 800;
        options.view = BATTEN_VIEW_SIDE;
        options.stripes = stripes[i];
        const scene_image image = image_of(model, options);
        int dark = 0;
        bool in_dark = false;
        for (int y = 0; y < image.height; y++) {
            const bool is_dark = scene_red(scene_pixel(&image, 300, y)) < 80;
            dark += is_dark && !in_dark;
            in_dark = is_dark;
        }
        CHECK(abs(dark - stripes[i]) <= 1);
    }
    batten_model_unref(model);
}

TEST(a_torus_is_red_outside_and_blue_inside)
{
    batten_model *model = scene_of(scene_torus(3, 1));
    batten_draw_options options = small(BATTEN_SHADING_GAUSSIAN);
    options.width = 600;
    options.height = 400;
    options.view = BATTEN_VIEW_TOP;
    const scene_image image = image_of(model, options);
    /* The ring leaves nine letters of 6.6 free at the right, two at the left: find its
     * middle. */
    int left = 0, right = 0;
    const int y = 200;
    while (!is_covered(&image, left, y) && left < 300)
        left++;
    for (int x = left; x < 530; x++)
        if (is_covered(&image, x, y))
            right = x;
    const double scale = (right - left) / 8.0, middle = 0.5 * (left + right);
    const uint32_t outside = scene_pixel(&image, (int)(middle + 3.7 * scale), y);
    const uint32_t inside = scene_pixel(&image, (int)(middle + 2.3 * scale), y);
    const uint32_t crest = scene_pixel(&image, (int)(middle + 3 * scale), y);
    CHECK(scene_red(outside) > scene_blue(outside) + 50);
    CHECK(scene_blue(inside) > scene_red(inside) + 50);
    CHECK(abs(scene_red(crest) - scene_blue(crest)) < 30); /* K = 0 on top */
    CHECK(!is_covered(&image, (int)middle, y));            /* the hole */
    batten_model_unref(model);
}

TEST(what_is_near_hides_what_is_far)
{
    /* Two squares over each other, a green one above a red one. */
    batten_model *model = scene_empty();
    for (int k = 0; k < 2; k++) {
        const double z = 1 - k, h = 1 + k;
        const double points[] = {-h, -h, z, -h, h, z, h, -h, z, h, h, z};
        batten_surface *surface = scene_net(1, 2, 1, 2, points);
        const batten_object object = {.name = "square",
                                      .layer = "",
                                      .kind = BATTEN_OBJECT_SURFACE,
                                      .surface = surface,
                                      .has_colour = true,
                                      .colour = {k, 1 - k, 0}};
        CHECK_OK(batten_model_add(model, &object));
        batten_surface_unref(surface);
    }
    batten_draw_options options = small(BATTEN_SHADING_PLAIN);
    options.view = BATTEN_VIEW_TOP;
    const scene_image above = image_of(model, options);
    CHECK(scene_green(scene_pixel(&above, 150, 100)) >
          scene_red(scene_pixel(&above, 150, 100)));
    const uint32_t rim = scene_pixel(&above, 150, 20);
    CHECK(scene_red(rim) > scene_green(rim));
    /* From below the red one hides all of the green one. */
    options.view = BATTEN_VIEW_AXONOMETRIC;
    options.elevation = -1.55;
    const scene_image below = image_of(model, options);
    for (int x = 60; x < 240; x++) {
        const uint32_t pixel = scene_pixel(&below, x, 100);
        CHECK(scene_green(pixel) <= scene_red(pixel) || !is_covered(&below, x, 100));
    }
    batten_model_unref(model);
}

TEST(curves_lie_over_the_surface_that_carries_them_and_behind_others)
{
    /* A red line on the front of a cylinder and one on its back. */
    static const double sides[] = {-1, 1};
    for (int i = 0; i < COUNT(sides); i++) {
        batten_model *model = scene_of(scene_cylinder(1, 3));
        const double line[] = {-1.5, sides[i], 0, 1.5, sides[i], 0};
        scene_add_curve(model, "line", scene_curve(3, 1, 2, line));
        batten_draw_options options = small(BATTEN_SHADING_PLAIN);
        options.view = BATTEN_VIEW_SIDE;
        const scene_image image = image_of(model, options);
        bool seen = false;
        for (int y = 90; y < 110; y++) {
            const uint32_t pixel = scene_pixel(&image, 100, y);
            seen |= scene_red(pixel) > 2 * scene_green(pixel);
        }
        CHECK_INT(seen, sides[i] < 0); /* the eye is at -y */
        batten_model_unref(model);
    }
}

TEST(points_are_dots_beside_and_before_the_surface_and_not_behind_it)
{
    static const struct {
        double x, y;
        bool seen;
    } rows[] = {{0, -1, true}, {0, -1.5, true}, {0, 1, false}, {2.5, 0, true}, {-2.5, 1, true}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_model *model = scene_of(scene_cylinder(1, 3));
        const double point[3] = {rows[i].x, rows[i].y, 0};
        const batten_object object = {.kind = BATTEN_OBJECT_POINTS,
                                      .name = "point",
                                      .layer = "",
                                      .has_colour = true,
                                      .colour = {1, 0, 0},
                                      .point_count = 1,
                                      .points = point};
        CHECK_OK(batten_model_add(model, &object));
        batten_draw_options options = small(BATTEN_SHADING_PLAIN);
        options.view = BATTEN_VIEW_SIDE;
        const scene_image image = image_of(model, options);
        int red = 0;
        for (int y = 0; y < image.height; y++)
            for (int x = 0; x < image.width; x++) {
                const uint32_t pixel = scene_pixel(&image, x, y);
                red += scene_red(pixel) > scene_green(pixel) + 40;
            }
        CHECK_INT(red > 0, rows[i].seen);
        CHECK(red < 30);
        batten_model_unref(model);
    }
}

TEST(an_edge_is_as_wide_where_two_surfaces_meet_as_elsewhere)
{
    /* Both halves of a square, and how many samples of its middle and its rim are dark. */
    batten_model *model = scene_empty();
    const double port[] = {-1, 0, 0, -1, 1, 0, 1, 0, 0, 1, 1, 0};
    const double starboard[] = {-1, -1, 0, -1, 0, 0, 1, -1, 0, 1, 0, 0};
    scene_add_surface(model, "port", scene_net(1, 2, 1, 2, port));
    scene_add_surface(model, "starboard", scene_net(1, 2, 1, 2, starboard));
    static const batten_shading shadings[] = {BATTEN_SHADING_PLAIN, BATTEN_SHADING_ISOLINES};
    for (int i = 0; i < COUNT(shadings); i++) {
        batten_draw_options options = small(shadings[i]);
        options.view = BATTEN_VIEW_TOP;
        options.isolines = 2;
        const scene_image image = image_of(model, options);
        for (int x = 70; x < 140; x++) { /* the square reaches from 60 to 240, 10 to 190 */
            int rim = 0, middle = 0;
            for (int y = -4; y <= 4; y++) {
                rim += scene_red(scene_pixel(&image, x, 10 + y)) < 110;
                middle += scene_red(scene_pixel(&image, x, 100 + y)) < 110;
            }
            CHECK(rim >= 1 && rim <= 2);
            CHECK(middle >= 1 && middle <= 2);
        }
    }
    batten_model_unref(model);
}

TEST(isolines_divide_the_surface_evenly)
{
    const double points[] = {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
    batten_model *model = scene_of(scene_net(1, 2, 1, 2, points));
    batten_draw_options options = small(BATTEN_SHADING_ISOLINES);
    options.width = 600;
    options.height = 400;
    options.view = BATTEN_VIEW_TOP;
    options.isolines = 5;
    const scene_image image = image_of(model, options);
    int lines = 0;
    bool in_line = false;
    const int y = 200 + 20; /* between two of the level lines */
    for (int x = 0; x < image.width; x++) {
        const bool dark =
            is_covered(&image, x, y) && scene_red(scene_pixel(&image, x, y)) < 130;
        lines += dark && !in_line;
        in_line = dark;
    }
    CHECK_INT(lines, 5 + 1);
    batten_model_unref(model);
}

TEST(the_bytes_do_not_depend_on_threads)
{
    batten_model *model = scene_of(scene_torus(3, 1));
    for (int shading = BATTEN_SHADING_PLAIN; shading <= BATTEN_SHADING_GAUSSIAN; shading++) {
        const batten_draw_options options = small(shading);
        char *first = NULL;
        size_t first_size = 0;
        CHECK_OK(batten_draw_shaded(model, &options, NULL, &first, &first_size));
        for (int threads = 1; threads <= 3; threads++) {
            batten_job job = BATTEN_JOB;
            job.thread_count = threads;
            char *data = NULL;
            size_t size = 0;
            CHECK_OK(batten_draw_shaded(model, &options, &job, &data, &size));
            CHECK_INT(size, first_size);
            CHECK(memcmp(data, first, size) == 0);
            batten_release(data);
        }
        batten_release(first);
    }
    batten_model_unref(model);
}

TEST(G5_poles_and_collapsed_edges_are_shaded)
{
    /* A triangle as a square with one edge shrunk to a point, and a cone's apex, where no
     * normal exists. */
    const double triangle[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    const double cone[] = {1, 0, 1, 0.5, 0.5, 1, 0, 1, 1};
    for (int shading = BATTEN_SHADING_PLAIN; shading <= BATTEN_SHADING_GAUSSIAN; shading++) {
        batten_model *model = scene_of(scene_net(1, 2, 1, 2, triangle));
        scene_add_surface(model, "cone", scene_turned(3, cone));
        const scene_image image = image_of(model, small(shading));
        CHECK(is_covered(&image, 150, 100));
        batten_model_unref(model);
    }
}

static bool after_three(void *user)
{
    return ++*(int *)user > 3;
}

static void keep_last(void *user, double fraction, const char *what)
{
    (void)user;
    CHECK(fraction >= 0 && fraction <= 1);
    CHECK(what && *what);
}

TEST(I8_a_cancelled_picture_leaves_nothing)
{
    batten_model *model = scene_of(scene_sphere(1));
    const batten_draw_options options = small(BATTEN_SHADING_PLAIN);
    int asked = 0;
    batten_job job = BATTEN_JOB;
    job.is_cancelled = after_three;
    job.progress = keep_last;
    job.user = &asked;
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(batten_draw_shaded(model, &options, &job, &data, &size), BATTEN_CANCELLED);
    CHECK(data == NULL);
    batten_model_unref(model);
}

TEST(what_cannot_be_shaded_is_refused)
{
    batten_model *empty = scene_empty(), *model = scene_of(scene_sphere(1));
    const batten_draw_options usual = small(BATTEN_SHADING_PLAIN);
    batten_draw_options rows[] = {usual, usual, usual, usual, usual, usual, usual};
    rows[1].format = BATTEN_PICTURE_SVG;
    rows[2].width = 0;
    rows[3].height = 100000;
    rows[4].isolines = 0;
    rows[5].stripes = -1;
    rows[6].elevation = INFINITY;
    static const batten_status expected[] = {
        BATTEN_BAD_ARGUMENT, BATTEN_UNSUPPORTED,  BATTEN_BAD_ARGUMENT, BATTEN_TOO_LARGE,
        BATTEN_BAD_ARGUMENT, BATTEN_BAD_ARGUMENT, BATTEN_NOT_FINITE};
    for (int i = 0; i < COUNT(rows); i++) {
        char *data = NULL;
        size_t size = 0;
        CHECK_STATUS(batten_draw_shaded(i == 0 ? empty : model, &rows[i], NULL, &data, &size),
                     expected[i]);
        CHECK(data == NULL);
    }
    batten_model_unref(model);
    batten_model_unref(empty);
}

TEST(a_very_small_and_an_uneven_picture_are_made)
{
    batten_model *model = scene_of(scene_sphere(1));
    batten_draw_options options = small(BATTEN_SHADING_GAUSSIAN);
    options.width = 64;
    options.height = 64;
    scene_image image = image_of(model, options);
    CHECK_INT(image.width, 64);
    options.height = 97; /* the last band is not full */
    image = image_of(model, options);
    CHECK_INT(image.height, 97);
    batten_model_unref(model);
}

TEST(the_mean_curvature_of_a_thick_torus_changes_its_sign)
{
    /* n outwards: H = -(R + 2 r cos v) / (2 r (R + r cos v)), 0.5 inside and -0.7 outside */
    batten_model *model = scene_of(scene_torus(1.5, 1));
    batten_draw_options options = small(BATTEN_SHADING_MEAN);
    options.width = 600;
    options.height = 400;
    options.view = BATTEN_VIEW_TOP;
    const scene_image image = image_of(model, options);
    int left = 0, right = 0;
    const int y = 200;
    while (!is_covered(&image, left, y) && left < 300)
        left++;
    for (int x = left; x < 530; x++)
        if (is_covered(&image, x, y))
            right = x;
    const double scale = (right - left) / 5.0, middle = 0.5 * (left + right);
    const uint32_t outside = scene_pixel(&image, (int)(middle + 2.2 * scale), y);
    const uint32_t inside = scene_pixel(&image, (int)(middle + 0.6 * scale), y);
    const int sign = scene_red(outside) > scene_blue(outside) ? 1 : -1;
    CHECK(sign * (scene_red(outside) - scene_blue(outside)) > 40);
    CHECK(sign * (scene_blue(inside) - scene_red(inside)) > 40);
    batten_model_unref(model);
}

/* The range of the colours follows the curvatures, whatever the size. */
TEST(the_colours_of_curvature_do_not_depend_on_the_unit)
{
    static const batten_shading shadings[] = {BATTEN_SHADING_GAUSSIAN, BATTEN_SHADING_MEAN};
    batten_model *small_torus = scene_of(scene_torus(3, 1)),
                 *large_torus = scene_of(scene_torus(3 * 0x1p20, 0x1p20));
    for (int i = 0; i < COUNT(shadings); i++) {
        batten_draw_options options = small(shadings[i]);
        options.view = BATTEN_VIEW_TOP;
        const scene_image a = image_of(small_torus, options),
                          b = image_of(large_torus, options);
        int coloured = 0;
        for (int x = 0; x < 230; x++) { /* the legend's numbers are beyond */
            const uint32_t one = scene_pixel(&a, x, 100), other = scene_pixel(&b, x, 100);
            CHECK(abs(scene_red(one) - scene_red(other)) < 20);
            CHECK(abs(scene_blue(one) - scene_blue(other)) < 20);
            coloured += abs(scene_red(one) - scene_blue(one)) > 50;
        }
        CHECK(coloured > 10);
    }
    batten_model_unref(small_torus);
    batten_model_unref(large_torus);
}
