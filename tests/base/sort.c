#include "base/sort.h"

#include "support/test.h"

TEST(sorted_numbers_rise_and_are_those_that_were_given)
{
    double values[200], sum = 0;
    test_random random = test_random_begin("sorted numbers");
    for (int i = 0; i < COUNT(values); i++) {
        values[i] = floor(test_random_in(&random, -50, 50));
        sum += values[i];
    }
    bat_sort_doubles(COUNT(values), values);
    for (int i = 0; i < COUNT(values); i++) {
        CHECK(i == 0 || values[i - 1] <= values[i]);
        sum -= values[i];
    }
    CHECK_BITS(sum, 0.0);
}

TEST(the_order_is_total_down_to_zeros_and_what_is_not_a_number)
{
    double values[] = {0.0, NAN, -0.0, INFINITY, 0.0, -INFINITY, -0.0, NAN, 1};
    bat_sort_doubles(COUNT(values), values);
    CHECK(values[0] == -INFINITY);
    CHECK_BITS(values[1], -0.0);
    CHECK_BITS(values[2], -0.0);
    CHECK_BITS(values[3], 0.0);
    CHECK_BITS(values[4], 0.0);
    CHECK(values[5] == 1 && values[6] == INFINITY && isnan(values[7]) && isnan(values[8]));
    bat_sort_doubles(0, NULL);
}

TEST(unique_values_are_more_than_so_far_apart)
{
    double values[] = {1, 1, 1.5, 2, 2.25, 2.5, 2.75, 4};
    CHECK_INT((int)bat_unique(COUNT(values), values, 0.5), 4);
    const double kept[] = {1, 2, 2.75, 4};
    for (int i = 0; i < COUNT(kept); i++)
        CHECK_BITS(values[i], kept[i]);
    CHECK_INT((int)bat_unique(0, values, 0.5), 0);
}

TEST(with_nothing_apart_only_equal_values_fall_together)
{
    double values[] = {-3, -3, 0, 0, 4e-324, 4e-324, 1, 1 + DBL_EPSILON};
    CHECK_INT((int)bat_unique(COUNT(values), values, 0), 5);
    CHECK_BITS(values[2], 4e-324);
    CHECK_BITS(values[4], 1 + DBL_EPSILON);
}
