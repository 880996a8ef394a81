#include "inspect/shapes.h"
#include <batten/invariants.h>

static batten_cubic classify(const double *points)
{
    batten_cubic cubic;
    CHECK_OK(batten_cubic_classify(2, points, 0, &cubic));
    return cubic;
}

TEST(the_plane_agrees_with_the_cubics)
{
    test_random random = test_random_begin("plane");
    for (int n = test_cases(20000); n > 0; n--) {
        const double lambda = test_random_in(&random, -3, 5),
                     mu = test_random_in(&random, -3, 5);
        double points[8];
        batten_cubic_place place;
        batten_cubic_from_lengths(lambda, mu, points);
        const batten_cubic cubic = classify(points);
        CHECK_OK(batten_cubic_look_up(lambda, mu, &place));
        if (cubic.margin > 1e-12)
            CHECK_TEXT(batten_cubic_class_name(place.segment),
                       batten_cubic_class_name(cubic.segment));
        CHECK(cubic.has_tangents);
        CHECK_NEAR(cubic.lambda, lambda, 1e-13 * (1 + fabs(lambda)) / fabs(mu));
        CHECK_NEAR(cubic.mu, mu, 1e-13 * (1 + fabs(mu)) / fabs(lambda));
        /* D is -lambda mu H times the square of the cross product of both legs, 1 here */
        CHECK_NEAR(cubic.b * cubic.b - 4 * cubic.a * cubic.c, place.d,
                   1e-12 * (1 + fabs(place.d)));
    }
}

TEST(stone_and_derose_agree_with_the_cubics)
{
    test_random random = test_random_begin("canonical");
    for (int n = test_cases(20000); n > 0; n--) {
        const double x = test_random_in(&random, -4, 4), y = test_random_in(&random, -4, 4);
        const double points[8] = {0, 0, 0, 1, 1, 1, x, y};
        const batten_cubic cubic = classify(points);
        double found_x, found_y;
        if (cubic.margin > 1e-12)
            CHECK_TEXT(batten_cubic_class_name(batten_cubic_canonical_class(x, y)),
                       batten_cubic_class_name(cubic.segment));
        CHECK_OK(batten_cubic_canonical(points, &found_x, &found_y));
        CHECK_NEAR(found_x, x, 1e-15 * (1 + fabs(x)));
        CHECK_NEAR(found_y, y, 1e-15 * (1 + fabs(y)));
    }
}

TEST(all_four_ways_agree_on_random_cubics)
{
    test_random random = test_random_begin("ways");
    for (int n = test_cases(5000); n > 0; n--) {
        double points[8], x, y;
        batten_cubic_place place;
        for (int k = 0; k < 8; k++)
            points[k] = test_random_in(&random, -1, 1);
        const batten_cubic cubic = classify(points);
        if (cubic.margin < 1e-9)
            continue;
        CHECK_OK(batten_cubic_canonical(points, &x, &y));
        CHECK_INT(batten_cubic_canonical_class(x, y), cubic.segment);
        CHECK_OK(batten_cubic_look_up(cubic.lambda, cubic.mu, &place));
        CHECK_INT(place.segment, cubic.segment);
        /* I and D have one sign */
        CHECK_INT(cubic.whole, cubic.invariant > 0   ? BATTEN_CUBIC_TWO_INFLECTIONS
                               : cubic.invariant < 0 ? BATTEN_CUBIC_LOOP
                                                     : BATTEN_CUBIC_CUSP);
    }
}

TEST(on_the_hyperbola_there_is_a_cusp)
{
    for (double s = 0.01; s < 50; s *= 1.3) {
        const double lambda = 4.0 / 3 + s, mu = 4.0 / 3 + 4 / (9 * s);
        double points[8], at[4];
        batten_curve *curve = NULL;
        batten_cubic cubic;
        batten_cubic_from_lengths(lambda, mu, points);
        CHECK_OK(batten_cubic_classify(2, points, 1e-12, &cubic));
        CHECK_INT(cubic.segment, BATTEN_CUBIC_CUSP);
        CHECK_OK(shape_bezier(2, 3, points, &curve));
        CHECK_OK(batten_curve_evaluate(curve, cubic.cusp, 1, at));
        CHECK_NEAR(hypot(at[2], at[3]), 0, 1e-7);
        batten_curve_unref(curve);
    }
}

TEST(whole_numbers_lie_where_they_lie)
{
    static const struct {
        double lambda, mu;
        batten_cubic_region region;
    } rows[] = {
        {2, 2, BATTEN_REGION_CUSP},           {1, 1, BATTEN_REGION_REGULAR},
        {3, 3, BATTEN_REGION_LOOP},           {2, 1, BATTEN_REGION_ONE_INFLECTION},
        {1.25, 1.25, BATTEN_REGION_EXCESS},   {0.5, -1, BATTEN_REGION_S_SHAPED},
        {-1, 1, BATTEN_REGION_S_SHAPED},      {1.01, -1, BATTEN_REGION_S_EXCESS},
        {1.25, -0.5, BATTEN_REGION_TURNING},  {2, -7, BATTEN_REGION_S_LOOP},
        {2, -5, BATTEN_REGION_TURNING},       {-7, 2, BATTEN_REGION_S_LOOP},
        {-1, -2, BATTEN_REGION_FAR},          {0, 2, BATTEN_REGION_DEGENERATE},
        {1.25, -4, BATTEN_REGION_S_CUSP},     {1.25, -2, BATTEN_REGION_S_LOOP},
        {2, -6, BATTEN_REGION_TURNING},       {-18, 3, BATTEN_REGION_TURNING},
        {2, -6.125, BATTEN_REGION_S_LOOP},    {3, -17.875, BATTEN_REGION_TURNING},
        {1, 2, BATTEN_REGION_ONE_INFLECTION}, {1, -3, BATTEN_REGION_S_SHAPED},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_cubic_place place;
        double points[8];
        CHECK_OK(batten_cubic_look_up(rows[i].lambda, rows[i].mu, &place));
        CHECK_TEXT(batten_cubic_region_name(place.region),
                   batten_cubic_region_name(rows[i].region));
        batten_cubic_from_lengths(rows[i].lambda, rows[i].mu, points);
        if (rows[i].region != BATTEN_REGION_DEGENERATE)
            CHECK_INT(classify(points).segment, place.segment);
    }
    CHECK_TEXT(batten_cubic_region_name((batten_cubic_region)77), "unknown");
}

TEST(special_places_have_their_special_curves)
{
    double points[8];
    batten_cubic_from_lengths(2, 2, points);
    CHECK_NEAR(classify(points).cusp, 0.5, 0);
    batten_cubic_from_lengths(3, 3, points);
    const batten_cubic loop = classify(points);
    CHECK_NEAR(loop.crossing[0] + loop.crossing[1], 1, 1e-15);
    /* (1, 1): the polygon runs through T, both ends are flat */
    batten_cubic_from_lengths(1, 1, points);
    const batten_cubic flat = classify(points);
    CHECK(flat.a == 0 && flat.c == 0);
    CHECK_INT(flat.inflection_count, 2);
    CHECK_NEAR(flat.inflections[0], 0, 0);
    CHECK_NEAR(flat.inflections[1], 1, 0);
}

TEST(g9_what_has_no_place_says_so)
{
    const double parallel[8] = {0, 0, 0, 1, 2, 1, 2, 0}, line[8] = {0, 0, 1, 0, 2, 0, 3, 1};
    batten_cubic_place place;
    double x, y;
    CHECK(!classify(parallel).has_tangents);
    CHECK(isnan(classify(parallel).lambda));
    CHECK_STATUS(batten_cubic_canonical(line, &x, &y), BATTEN_SINGULAR_HERE);
    CHECK_STATUS(batten_cubic_look_up(NAN, 1, &place), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_cubic_look_up(1, INFINITY, &place), BATTEN_NOT_FINITE);
}

/* On the line lambda = 1 the curve is flat at its end, on mu = 1 at its start. */
TEST(lengths_that_reach_the_corner_make_an_end_flat)
{
    for (double other = -2; other <= 3; other += 0.25) {
        double points[8];
        if (other == 0 || other == 1)
            continue;
        for (int end = 0; end < 2; end++) {
            batten_curve *curve = NULL;
            batten_curve_local at;
            batten_cubic_from_lengths(end ? 1 : other, end ? other : 1, points);
            CHECK_OK(shape_bezier(2, 3, points, &curve));
            CHECK_OK(batten_curve_local_at(curve, end,
                                           end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &at));
            CHECK_NEAR(at.curvature, 0, 1e-14);
            CHECK_OK(batten_curve_local_at(curve, 1 - end,
                                           end ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &at));
            CHECK(fabs(at.curvature) > 1e-3);
            batten_curve_unref(curve);
        }
    }
}
