/* The range of the colours of curvature: two digits, beyond 95 of 100 samples, and never nothing. */
#include "picture/scenes.h"
#include "picture/shaded/shade.h"

/* The range over these surfaces; the extremes in p. */
static double range_of(bat_shaded *p, batten_shading shading, double size, int count,
                       bat_shaded_solid *solids)
{
    batten_draw_options options = batten_draw_defaults();
    options.shading = shading;
    *p = (bat_shaded){.options = &options, .solid_count = count, .solids = solids};
    CHECK_OK(bat_shaded_choose_range(p, size));
    return p->scene.range;
}

static bat_shaded_solid solid_of(size_t count_u, size_t count_v, double *curvatures)
{
    return (bat_shaded_solid){
        .tiles = {.count_u = count_u, .count_v = count_v, .curvature = curvatures}};
}

static const struct {
    double curvature[4], range;
} digits[] = {
    {{0.123, 0.123, 0.123, 0.123}, 0.13}, {{-0.121, -0.121, -0.121, -0.121}, 0.13},
    {{0.25, 0.25, 0.25, 0.25}, 0.25},     {{999, 999, 999, 999}, 1000},
    {{20.1, 20.1, 20.1, 20.1}, 21},       {{3, 1, -2, 9}, 3},
};

TEST(the_range_has_two_digits_and_is_not_below_the_samples)
{
    for (int i = 0; i < COUNT(digits); i++) {
        double curvatures[4];
        bat_shaded p;
        memcpy(curvatures, digits[i].curvature, sizeof curvatures);
        bat_shaded_solid solid = solid_of(2, 2, curvatures);
        CHECK_NEAR(range_of(&p, BATTEN_SHADING_GAUSSIAN, 1, 1, &solid), digits[i].range,
                   1e-12 * digits[i].range);
    }
}

/* Of 2 x 50 samples -99 .. 0, in any order, 95 of 100 are within 94. */
TEST(five_of_a_hundred_samples_of_all_surfaces_lie_beyond_the_range)
{
    double curvatures[2][50];
    bat_shaded_solid solids[2];
    bat_shaded p;
    for (int i = 0; i < 100; i++)
        curvatures[i % 2][i / 2] = -(37 * i % 100);
    for (int k = 0; k < 2; k++)
        solids[k] = solid_of(5, 10, curvatures[k]);
    CHECK_BITS(range_of(&p, BATTEN_SHADING_MEAN, 1, 2, solids), 94);
    CHECK_BITS(p.least, -99);
    CHECK_BITS(p.greatest, 0);
}

/* Poles have no curvature; without any there are no extremes. */
TEST(places_without_a_curvature_do_not_count)
{
    double some[] = {NAN, 2, -5, NAN, 5, 1}, none[] = {NAN, NAN};
    bat_shaded_solid solid = solid_of(3, 2, some);
    bat_shaded p;
    CHECK_BITS(range_of(&p, BATTEN_SHADING_MEAN, 1, 1, &solid), 5);
    CHECK_BITS(p.least, -5);
    CHECK_BITS(p.greatest, 5);
    solid = solid_of(1, 2, none);
    CHECK_NEAR(range_of(&p, BATTEN_SHADING_MEAN, 1, 1, &solid), 1e-6, 1.01e-7);
    CHECK(p.least > p.greatest);
}

/* A millionth of the curvature of a ball of that size: 1/size of H, 1/size^2 of K. */
TEST(roundings_of_what_is_flat_stay_white)
{
    static const double sizes[] = {1, 40, 0.002};
    double curvatures[] = {1e-17, -1e-17};
    bat_shaded_solid solid = solid_of(1, 2, curvatures);
    bat_shaded p;
    for (int i = 0; i < COUNT(sizes); i++) {
        const double mean = 1e-6 / sizes[i], gaussian = mean / sizes[i];
        CHECK_NEAR(range_of(&p, BATTEN_SHADING_MEAN, sizes[i], 1, &solid), 1.05 * mean,
                   0.0501 * mean);
        CHECK_NEAR(range_of(&p, BATTEN_SHADING_GAUSSIAN, sizes[i], 1, &solid), 1.05 * gaussian,
                   0.0501 * gaussian);
    }
}

/* 150,000 samples, 1 to 100 evenly, after one of 7: they are thinned, and 95 of 100 remain. */
TEST(many_samples_are_thinned_evenly)
{
    enum { MANY = 150000 };
    double *many = test_array(MANY, sizeof *many), one = -7;
    bat_shaded_solid solids[2];
    bat_shaded p;
    for (int i = 0; i < MANY; i++)
        many[i] = 1 + 99.0 * i / (MANY - 1);
    solids[0] = solid_of(1, 1, &one);
    solids[1] = solid_of(300, 500, many);
    CHECK_BITS(range_of(&p, BATTEN_SHADING_MEAN, 1, 2, solids), 96); /* 95.05 */
    CHECK_BITS(p.least, -7);
    CHECK_BITS(p.greatest, 100);
}

TEST(curvatures_without_bound_are_refused)
{
    double curvatures[] = {1, INFINITY};
    bat_shaded_solid solid = solid_of(2, 1, curvatures);
    batten_draw_options options = batten_draw_defaults();
    options.shading = BATTEN_SHADING_MEAN;
    bat_shaded p = {.options = &options, .solid_count = 1, .solids = &solid};
    curvatures[0] = INFINITY;
    CHECK_STATUS(bat_shaded_choose_range(&p, 1), BATTEN_OVERFLOW);
    CHECK_TEXT(batten_message(), "curvatures up to inf are too large to show");
}
