/* Numbers as text. */
#include "base/numbers.h"

static void check_writes(double value, const char *expected)
{
    char text[BATTEN_NUMBER_SIZE];
    CHECK_INT(batten_number_write(value, text), strlen(expected));
    CHECK_TEXT(text, expected);
}

TEST(numbers_are_written_with_the_fewest_digits)
{
    static const struct {
        double value;
        const char *text;
    } cases[] = {
        {0.1, "0.1"},
        {-2.5e-7, "-2.5e-7"},
        {1e22, "1e22"},
        {1e23, "1e23"},
        {0.0, "0"},
        {1, "1"},
        {-100, "-100"},
        {123.456, "123.456"},
        {0.00001, "0.00001"},
        {0.0000099, "9.9e-6"},
        {12345678901234567.0, "12345678901234568"},
        {1e16, "10000000000000000"},
        {1e17, "1e17"},
        {9007199254740993.0, "9007199254740992"},
        {1.0 / 3, "0.3333333333333333"},
        {5e-324, "5e-324"},
        {2.2250738585072011e-308, "2.225073858507201e-308"},
        {2.2250738585072014e-308, "2.2250738585072014e-308"},
        {1.7976931348623157e308, "1.7976931348623157e308"},
        {-1.2345678901234568e-300, "-1.2345678901234568e-300"},
        {0x1p-20, "9.5367431640625e-7"}, /* nearer below than above */
        {0x1p-1021, "4.450147717014403e-308"},
        {0x1p172, "5.986310706507379e51"},
        {9e15, "9000000000000000"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_writes(cases[i].value, cases[i].text);
}

TEST(numbers_that_are_not_finite_are_written_as_words)
{
    check_writes(NAN, "nan");
    check_writes(-NAN, "nan");
    check_writes(INFINITY, "inf");
    check_writes(-INFINITY, "-inf");
}

TEST(N5_the_sign_of_zero_and_denormals_survive)
{
    check_writes(-0.0, "-0");
    CHECK_BITS(read_all("-0"), -0.0);
    CHECK_BITS(read_all("-0.000e7"), -0.0);
    CHECK_BITS(read_all("0e999999999999999999999"), 0.0);
    for (double value = 1e-300; value > 0; value *= 0.37) {
        char text[BATTEN_NUMBER_SIZE];
        batten_number_write(-value, text);
        CHECK_BITS(read_all(text), -value);
    }
}

TEST(any_bits_survive_writing_and_reading)
{
    test_random random = test_random_begin("bits");
    for (int i = test_cases(100000); i > 0; i--)
        check_round_trip(random_double(&random), true);
}

TEST(numbers_of_people_survive_writing_and_reading)
{
    static const double units[] = {1, 10, 100, 1e3, 1e4, 1e6, 1e9, 25.4, 0.3048};
    test_random random = test_random_begin("people");
    for (int i = test_cases(50000); i > 0; i--)
        check_round_trip(test_random_int(&random, -10000000, 10000000) /
                             units[test_random_int(&random, 0, COUNT(units) - 1)],
                         true);
}

TEST(powers_of_two_and_their_neighbours_survive_writing_and_reading)
{
    for (int e = -1074; e <= 1023; e++) {
        const double power = ldexp(1, e);
        check_round_trip(power, true);
        check_round_trip(nextafter(power, 0), true);
        check_round_trip(nextafter(power, INFINITY), true);
    }
    for (int e = -323; e <= 308; e++) {
        char text[32];
        snprintf(text, sizeof text, "1e%d", e);
        check_round_trip(strtod(text, NULL), true);
    }
}
