/* Folds are found where a normal reverses, however narrow, and edges are none. */
#include "support/test.h"

#include <batten/measure.h>
#include <math.h>

static batten_surface *bicubic_wave(double amplitude)
{
    /* x runs forth, back by `amplitude` and forth again. */
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, straight[] = {0, 0, 1, 1};
    const double x[4] = {0, 1 + amplitude, -amplitude, 1};
    double points[4][2][3];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 2; j++) {
            points[i][j][0] = x[i];
            points[i][j][1] = j;
            points[i][j][2] = 0;
        }
    const batten_axis u = {3, 4, knots, false}, v = {1, 2, straight, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0][0], NULL, &surface));
    return surface;
}

TEST(a_surface_that_runs_back_folds)
{
    batten_surface *surface = bicubic_wave(0.5);
    batten_surface_fold fold = {.found = false};
    CHECK_OK(batten_surface_find_fold(surface, &fold));
    CHECK(fold.found);
    /* Two folds, symmetric about the middle; the first comes first. */
    CHECK(fold.u > 0.1 && fold.u < 0.5);
    batten_surface_unref(surface);
}

TEST(a_surface_that_slows_down_does_not_fold)
{
    batten_surface *surface = bicubic_wave(-0.2);
    batten_surface_fold fold = {.found = true};
    CHECK_OK(batten_surface_find_fold(surface, &fold));
    CHECK(!fold.found);
    batten_surface_unref(surface);
}

TEST(an_edge_as_sharp_as_a_knife_is_no_fold)
{
    static const double knots[] = {0, 0, 0.5, 1, 1}, straight[] = {0, 0, 1, 1};
    static const double points[3][2][3] = {
        {{0, 0, 0}, {0, 0, 1}}, {{1, 0.001, 0}, {1, 0.001, 1}}, {{0, 0.002, 0}, {0, 0.002, 1}}};
    const batten_axis u = {1, 3, knots, false}, v = {1, 2, straight, false};
    batten_surface *surface = NULL;
    batten_surface_fold fold = {.found = true};
    CHECK_OK(batten_surface_create(3, &u, &v, points[0][0], NULL, &surface));
    CHECK_OK(batten_surface_find_fold(surface, &fold));
    CHECK(!fold.found);
    batten_surface_unref(surface);
}

/* x runs back near u = 0, as far as `end` along v. */
static batten_surface *corner_wave(double back, double end)
{
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, straight[] = {0, 0, 1, 1};
    double points[4][2][3];
    for (int j = 0; j < 2; j++) {
        const double x[4] = {0, j ? end : -back, 0.6, 1};
        for (int i = 0; i < 4; i++) {
            points[i][j][0] = x[i];
            points[i][j][1] = j;
            points[i][j][2] = 0;
        }
    }
    const batten_axis u = {3, 4, knots, false}, v = {1, 2, straight, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0][0], NULL, &surface));
    return surface;
}

TEST(a_fold_at_a_corner_is_seen_however_narrow)
{
    static const double backs[] = {1e-2, 1e-4, 1e-6};
    for (int i = 0; i < COUNT(backs); i++) {
        batten_surface *surface = corner_wave(backs[i], 0.3);
        batten_surface_fold fold = {.found = false};
        CHECK_OK(batten_surface_find_fold(surface, &fold));
        CHECK(fold.found);
        CHECK(fold.u < 0.01 && fold.v < 0.05);
        batten_surface_unref(surface);
        surface = corner_wave(-backs[i], 0.3);
        CHECK_OK(batten_surface_find_fold(surface, &fold));
        CHECK(!fold.found);
        batten_surface_unref(surface);
    }
}

/* x(u) has its turns at 1/2 -+ 1/sqrt(28); the place is one of twelve in the direction, the first beyond it. */
TEST(the_place_of_a_fold_is_just_beyond_it_in_either_direction_at_any_size)
{
    const double turn = 0.5 - 1 / sqrt(28);
    static const double sizes[] = {1, 1e-120, 1e120};
    batten_surface *wave = bicubic_wave(0.5), *swapped = NULL;
    CHECK_OK(batten_surface_swap(wave, &swapped));
    for (int i = 0; i < 2 * COUNT(sizes); i++) {
        const batten_affine map =
            batten_affine_scaling(sizes[i / 2], sizes[i / 2], sizes[i / 2]);
        batten_surface *surface = NULL;
        batten_surface_fold fold = {.found = false};
        double p[3];
        CHECK_OK(batten_surface_transform(i % 2 ? swapped : wave, &map, &surface));
        CHECK_OK(batten_surface_find_fold(surface, &fold));
        CHECK(fold.found);
        const double along = i % 2 ? fold.v : fold.u, across = i % 2 ? fold.u : fold.v;
        CHECK(along > turn && along <= turn + 1. / 12);
        CHECK_NEAR(across, 0, 0); /* on the rim, where the search begins */
        CHECK_OK(batten_surface_evaluate(surface, fold.u, fold.v, 0, p));
        CHECK_NEAR(fold.point.x, p[0], 0);
        CHECK_NEAR(fold.point.y, p[1], 0);
        CHECK_NEAR(fold.point.z, p[2], 0);
        batten_surface_unref(surface);
    }
    batten_surface_unref(swapped);
    batten_surface_unref(wave);
}

/* A dome over a quarter of a circle with a ring of radius `before` before its pole, whose points at the pole were made apart: they differ in their last digits, or not
 * at all. Before them the cone of u runs on, so that only the pole is singular. */
static batten_surface *dome_with_pole(double noise, double size, double far, double before)
{
    static const double quadratic[] = {0, 0, 0, 0.5, 1, 1, 1};
    static const double rim[4][2] = {{1, 0}, {1, 0.5}, {0.5, 1}, {0, 1}};
    const double rings[4][2] = {{1, 0}, {0.9, 0.4}, {before, 0.5}, {0, 0.6}};
    double points[4][4][3];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            const double off = j == 3 ? noise * (i % 2 ? 1 : -1) * (i + 1) : 0;
            points[i][j][0] = far + size * (rim[i][0] * rings[j][0] + off);
            points[i][j][1] = size * (rim[i][1] * rings[j][0] - off);
            points[i][j][2] = size * rings[j][1];
        }
    const batten_axis axis = {2, 4, quadratic, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0][0], NULL, &surface));
    return surface;
}

TEST(at_a_pole_only_lines_that_pass_it_make_a_fold)
{
    static const struct {
        double noise, size, far, before;
        bool folds;
    } rows[] = {{0, 1, 0, 0.5, false},
                {1e-16, 1, 0, 0.5, false},
                {1e-14, 1, 0, 0.5, false},
                {1e-14, 1e60, 0, 0.5, false},
                {1e-14, 1e-60, 0, 0.5, false},
                {1e-9, 1, 1e6, 0.5, false},
                {1e-2, 1, 0, 0.5, true},
                /* Its lines pass the pole and return to it, within a thousandth of the way. */
                {1e-14, 1, 0, 1e-4, false},
                {1e-14, 1, 0, -1e-4, true},
                {0, 1, 0, -1e-4, true}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface *dome = dome_with_pole(rows[i].noise, rows[i].size, rows[i].far,
                                              rows[i].before),
                       *other;
        batten_surface_fold fold = {.found = true};
        CHECK_OK(batten_surface_swap(dome, &other));
        CHECK_OK(batten_surface_find_fold(dome, &fold));
        CHECK(fold.found == rows[i].folds);
        CHECK_OK(batten_surface_find_fold(other, &fold));
        CHECK(fold.found == rows[i].folds);
        batten_surface_unref(dome);
        batten_surface_unref(other);
    }
}

TEST(folds_of_functions_are_not_looked_for)
{
    const batten_axis axis = {1, 2, (const double[]){0, 0, 1, 1}, false};
    batten_surface *heights = NULL;
    batten_surface_fold fold = {.u = 42};
    CHECK_OK(
        batten_surface_create(1, &axis, &axis, (const double[]){0, 1, 1, 0}, NULL, &heights));
    CHECK_STATUS(batten_surface_find_fold(heights, &fold), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("folds are looked for in 2 or 3 dimensions, and there are 1");
    CHECK_NEAR(fold.u, 42, 0);
    batten_surface_unref(heights);
}
