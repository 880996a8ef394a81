/* Coordinates as text. */
#include "base/number_common.h"

#include "base/numbers.h"

/* Most of them have 16 or 17 digits. */
TEST(coordinates_have_the_nearest_of_the_fewest_digits)
{
    test_random random = test_random_begin("coordinates");
    for (int i = test_cases(100000); i > 0; i--) {
        const double value =
            test_random_in(&random, -1, 1) * pow(10, test_random_int(&random, -8, 9));
        char text[BATTEN_NUMBER_SIZE], rounded[64], digits[64], expected[64];
        check_round_trip(value, true);
        batten_number_write(value, text);
        const int count = significant_digits(text, digits);
        snprintf(rounded, sizeof rounded, "%.*e", count - 1, value);
        significant_digits(rounded, expected);
        CHECK_TEXT(digits, expected);
    }
}

TEST(powers_of_two_and_tiny_and_huge_numbers_are_left_to_the_long_way)
{
    static const double others[] = {0, 0.5, 1e-6, 1e9, 123456789.5, 1e300};
    static const double common[] = {0.3, 12345.678, 0.1, 99.5, 0.00012};
    char text[32];
    uint64_t bits;
    for (int i = 0; i < COUNT(others); i++) {
        memcpy(&bits, &others[i], sizeof bits);
        CHECK(!bat_number_write_common(text, bits));
    }
    for (int i = 0; i < COUNT(common); i++) {
        memcpy(&bits, &common[i], sizeof bits);
        char *end = bat_number_write_common(text, bits);
        CHECK(end != NULL);
        if (end)
            *end = 0;
        CHECK_BITS(strtod(text, NULL), common[i]);
    }
}
