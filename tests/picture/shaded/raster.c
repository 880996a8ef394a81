#include "picture/shaded/raster.h"

#include "picture/scenes.h"

enum { WIDTH = 90, HEIGHT = 60 };
static const float black[3] = {0, 0, 0};

/* Adds up how often a sample is painted, and keeps the first value as its colour. */
static void count_fragment(const void *user, const bat_fragment *fragment, float colour[3])
{
    *(int *)(uintptr_t)user += 1;
    colour[0] = colour[1] = colour[2] = (float)fragment->value[0];
}

static bat_corner at(double x, double y, double depth, double value)
{
    return (bat_corner){x, y, depth, {value}};
}

static int fill(bat_raster *raster, bat_corner a, bat_corner b, bat_corner c)
{
    int count = 0;
    bat_raster_triangle(raster, &a, &b, &c, count_fragment, &count);
    return count;
}

TEST(a_triangle_covers_its_area)
{
    bat_raster raster;
    CHECK_OK(bat_raster_make(WIDTH, HEIGHT, &raster));
    bat_raster_begin(&raster, 0, HEIGHT, black, black);
    /* Half of 80 x 50; the samples at the rim are within its length. */
    CHECK_NEAR(fill(&raster, at(5, 5, 0, 1), at(85, 5, 0, 1), at(5, 55, 0, 1)), 2000, 70);
    bat_raster_begin(&raster, 0, HEIGHT, black, black);
    /* Larger than the picture. */
    CHECK_INT(fill(&raster, at(-500, -500, 0, 1), at(900, -500, 0, 1), at(-500, 900, 0, 1)),
              WIDTH * HEIGHT);
    bat_raster_free(&raster);
}

TEST(triangles_without_area_paint_nothing)
{
    bat_raster raster;
    CHECK_OK(bat_raster_make(WIDTH, HEIGHT, &raster));
    bat_raster_begin(&raster, 0, HEIGHT, black, black);
    CHECK_INT(fill(&raster, at(5, 5, 0, 1), at(50, 50, 0, 1), at(20, 20, 0, 1)), 0);
    CHECK_INT(fill(&raster, at(5, 5, 0, 1), at(5, 5, 0, 1), at(5, 5, 0, 1)), 0);
    CHECK_INT(fill(&raster, at(-50, 5, 0, 1), at(-9, 5, 0, 1), at(-20, 30, 0, 1)), 0);
    CHECK_INT(fill(&raster, at(NAN, 5, 0, 1), at(50, 5, 0, 1), at(20, 30, 0, 1)), 0);
    /* Beyond any integer, to all sides. */
    for (int far = -1; far <= 1; far += 2) {
        const double x = 1e12 * far;
        CHECK_INT(fill(&raster, at(x, 5, 0, 1), at(2 * x, 5, 0, 1), at(x, 30, 0, 1)), 0);
        CHECK_INT(fill(&raster, at(5, x, 0, 1), at(50, x, 0, 1), at(5, 2 * x, 0, 1)), 0);
    }
    bat_raster_free(&raster);
}

TEST(triangles_that_share_edges_leave_no_gap)
{
    bat_raster raster;
    CHECK_OK(bat_raster_make(WIDTH, HEIGHT, &raster));
    test_random random = test_random_begin("fans");
    for (int i = 0; i < test_cases(200); i++) {
        /* A fan about a random point covers the whole picture. */
        const double x = test_random_in(&random, 0, WIDTH),
                     y = test_random_in(&random, 0, HEIGHT);
        bat_raster_begin(&raster, 0, HEIGHT, black, black);
        for (int k = 0; k < 16; k++) {
            const double a = k * atan(1) / 2, b = (k + 1) % 16 * atan(1) / 2;
            fill(&raster, at(x, y, 0, 1), at(x + 900 * cos(a), y + 900 * sin(a), 0, 1),
                 at(x + 900 * cos(b), y + 900 * sin(b), 0, 1));
        }
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            CHECK(raster.colour[3 * k] > 0.99f);
    }
    bat_raster_free(&raster);
}

TEST(the_nearer_triangle_wins_whatever_the_order)
{
    bat_raster raster;
    CHECK_OK(bat_raster_make(WIDTH, HEIGHT, &raster));
    for (int order = 0; order < 2; order++) {
        bat_raster_begin(&raster, 0, HEIGHT, black, black);
        for (int k = 0; k < 2; k++) {
            const double near = k == order ? 1 : 0;
            fill(&raster, at(-99, -99, near, near), at(400, -99, near, near),
                 at(-99, 400, near, near));
        }
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            CHECK_NEAR(raster.colour[3 * k], 1, 1e-6);
    }
    bat_raster_free(&raster);
}

TEST(values_run_linearly)
{
    bat_raster raster;
    CHECK_OK(bat_raster_make(WIDTH, HEIGHT, &raster));
    bat_raster_begin(&raster, 0, HEIGHT, black, black);
    fill(&raster, at(0, 0, 0, 0), at(100, 0, 0, 1), at(0, 100, 0, 2));
    for (int j = 0; j < HEIGHT; j++)
        for (int i = 0; i < 100 - 1 - j && i < WIDTH; i++)
            CHECK_NEAR(raster.colour[3 * (j * WIDTH + i)], 0.01 * (i + 0.5) + 0.02 * (j + 0.5),
                       1e-6);
    bat_raster_free(&raster);
}

TEST(bands_paint_what_the_whole_picture_paints)
{
    bat_raster whole, band;
    CHECK_OK(bat_raster_make(WIDTH, HEIGHT, &whole));
    CHECK_OK(bat_raster_make(WIDTH, HEIGHT / 4, &band));
    static const float white[3] = {1, 1, 1};
    const bat_corner a = at(3.3, 1.7, 0, 0.1), b = at(88, 20, 1, 0.5), c = at(30, 58.5, 2, 0.9);
    uint32_t expected[HEIGHT / 3][WIDTH / 3], pixels[HEIGHT / 3][WIDTH / 3];
    bat_raster_begin(&whole, 0, HEIGHT, black, white);
    fill(&whole, a, b, c);
    bat_raster_resolve(&whole, expected[0], WIDTH / 3);
    for (int k = 0; k < 4; k++) {
        bat_raster_begin(&band, k * HEIGHT / 4, HEIGHT, black, white);
        fill(&band, a, b, c);
        bat_raster_resolve(&band, pixels[k * HEIGHT / 12], WIDTH / 3);
    }
    CHECK(memcmp(pixels, expected, sizeof pixels) == 0);
    bat_raster_free(&band);
    bat_raster_free(&whole);
}
