#include "picture/sheet/numbers.h"

#include "picture/scenes.h"

TEST(a_round_step_is_the_smallest_that_gives_few_enough_parts)
{
    static const struct {
        double range, count, step;
    } rows[] = {{10, 10, 1},  {1, 10, 0.1},  {12, 10, 2},    {25, 10, 5},
                {60, 10, 10}, {0.3, 5, 0.1}, {2e-7, 4, 5e-8}};
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_NEAR(bat_round_step(rows[i].range, rows[i].count) / rows[i].step, 1, 1e-12);

    test_random random = test_random_begin("steps");
    for (int i = 0; i < test_cases(1000); i++) {
        const double range = pow(10, test_random_in(&random, -12, 12));
        const double step = bat_round_step(range, 7);
        CHECK(range / step <= 7 * (1 + 1e-8));
        CHECK(range / step > 7 / 2.5 * (1 - 1e-8));
    }
}

TEST(numbers_are_written_with_the_decimals_of_their_step)
{
    static const struct {
        double value;
        int decimals;
        const char *text;
    } rows[] = {{3 * 0.1, 1, "0.3"}, {-0.04, 1, "0"}, {1234.5, -2, "1200"},
                {7, 0, "7"},         {2.5, 2, "2.5"}, {-1.25, 2, "-1.25"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[BATTEN_NUMBER_SIZE];
        bat_number_text(rows[i].value, rows[i].decimals, text);
        CHECK_TEXT(text, rows[i].text);
    }
    CHECK_INT(bat_decimals_of_step(0.05), 2);
    CHECK_INT(bat_decimals_of_step(0.1), 1);
    CHECK_INT(bat_decimals_of_step(1), 0);
    CHECK_INT(bat_decimals_of_step(500), -2);
}

TEST(digits_are_kept_and_no_more)
{
    static const struct {
        double value;
        int digits;
        const char *text;
    } rows[] = {{12.3456, 4, "12.35"},
                {0.00123456, 3, "0.00123"},
                {123456, 3, "123000"},
                {-9.996, 3, "-10"},
                {0, 3, "0"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[BATTEN_NUMBER_SIZE];
        bat_digits_text(rows[i].value, rows[i].digits, text);
        CHECK_TEXT(text, rows[i].text);
    }
}
