/* Text as numbers. */
#include "base/numbers.h"

TEST(any_number_of_digits_is_rounded_correctly)
{
    test_random random = test_random_begin("digits");
    char text[1200];
    for (int i = test_cases(20000); i > 0; i--) {
        snprintf(text, sizeof text, "%.*e", test_random_int(&random, 0, 40),
                 random_double(&random));
        if (isfinite(strtod(text, NULL)))
            CHECK_BITS(read_all(text), strtod(text, NULL));
    }
}

/* The midpoint of two doubles has an exact decimal expansion; its last digit decides. */
TEST(midpoints_go_to_the_even_neighbour_and_a_last_digit_decides)
{
    test_random random = test_random_begin("midpoint");
    char text[2400];
    for (int i = test_cases(1000); i > 0; i--) {
        double low = fabs(random_double(&random));
        if (i % 4 == 0)
            low = ldexp(test_random_unit(&random), test_random_int(&random, -1060, -1000));
        const double high = nextafter(low, INFINITY);
        if (!isfinite(high))
            continue;
        const long double midpoint = ((long double)low + high) / 2;
        uint64_t bits;
        memcpy(&bits, &low, sizeof bits);
        int length = snprintf(text, sizeof text, "%.*Lf", 1100, midpoint);
        CHECK_BITS(read_all(text), bits % 2 ? high : low);
        memcpy(text + length, "1", 2);
        CHECK_BITS(read_all(text), high);
        if (low == 0)
            continue;
        /* Below: take one off the last digit that is not 0, with nines behind it. */
        while (text[--length] == '0' || text[length] == '.')
            if (text[length] == '0')
                text[length] = '9';
        text[length]--;
        CHECK_BITS(read_all(text), low);
    }
}

TEST(N3_text_is_a_number_or_is_refused)
{
    static const char *const bad[] = {"",      "+",     "-",     ".",    "-.",      "e5",
                                      "nan",   "inf",   "--1",   "1,5",  "1d5",     "1e",
                                      "1e+",   "1.e",   "0x1p3", " 1",   "1 ",      "1_0",
                                      "1.2.3", "1e1.5", "+-1",   "1e5x", "Infinity"};
    for (int i = 0; i < COUNT(bad); i++) {
        double value = 7;
        CHECK_STATUS(batten_number_read(bad[i], strlen(bad[i]), &value, NULL),
                     BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(bad[i]);
        CHECK_BITS(value, 7);
    }
    static const struct {
        const char *text;
        double value;
    } good[] = {{".5", 0.5},
                {"5.", 5},
                {"+1", 1},
                {"-.5e1", -5},
                {"1E+2", 100},
                {"1e-400", 0},
                {"1e-345", 0},
                {"-1e-400", -0.0},
                {"00012", 12},
                {"0.001e3", 1},
                {"1.e3", 1000},
                {"1e-00000000000000000000002", 0.01},
                {"9007199254740993", 9007199254740992.0},
                {"9007199254740993.00000000000000000000001", 9007199254740994.0},
                {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},
                {"1e23", 1e23},
                {"2.4703282292062327e-324", 0},
                {"2.4703282292062328e-324", 5e-324},
                {"1.7976931348623158e308", DBL_MAX},
                {"1e-99999999999999999999999", 0}};
    for (int i = 0; i < COUNT(good); i++)
        CHECK_BITS(read_all(good[i].text), good[i].value);
}

TEST(N3_a_number_too_large_is_refused)
{
    static const char *const large[] = {"1e400", "-1e400", "1.7976931348623159e308",
                                        "1e309", "2e308",  "1e99999999999999999999999"};
    for (int i = 0; i < COUNT(large); i++) {
        double value = 7;
        size_t used = 9;
        CHECK_STATUS(batten_number_read(large[i], strlen(large[i]), &value, &used),
                     BATTEN_OVERFLOW);
        CHECK_MESSAGE(large[i]);
        CHECK_BITS(value, 7);
        CHECK_INT(used, 9);
    }
}

TEST(N3_four_hundred_digits_are_read)
{
    char text[1500];
    memset(text, '3', 400);
    text[400] = 0;
    double value = 0;
    CHECK_STATUS(batten_number_read(text, 400, &value, NULL), BATTEN_OVERFLOW);
    text[1] = '.';
    CHECK_BITS(read_all(text), 10.0 / 3);
    /* 1000 zeros before, 1000 behind, an exponent that makes up for them. */
    memset(text, '0', sizeof text);
    text[1] = '.';
    strcpy(text + 1001, "25e1001");
    CHECK_BITS(read_all(text), 25);
    memset(text, '0', sizeof text);
    text[0] = '1';
    strcpy(text + 1001, "e-1000");
    CHECK_BITS(read_all(text), 1);
    /* A digit after more than all that are kept decides at a midpoint. */
    memset(text, '0', sizeof text);
    memcpy(text, "9007199254740993.", 17);
    strcpy(text + 1200, "0");
    CHECK_BITS(read_all(text), 9007199254740992.0);
    strcpy(text + 1200, "1");
    CHECK_BITS(read_all(text), 9007199254740994.0);
}

TEST(the_end_of_a_number_is_told)
{
    static const struct {
        const char *text;
        double value;
        int used;
    } cases[] = {{"1.5,2", 1.5, 3}, {"3e", 3, 1},   {"3e+x", 3, 1}, {"3e5-1", 3e5, 3},
                 {"1.2.3", 1.2, 3}, {"0x10", 0, 1}, {"7mm", 7, 1},  {"4E2e", 400, 3}};
    for (int i = 0; i < COUNT(cases); i++) {
        double value = 0;
        size_t used = 0;
        CHECK_OK(batten_number_read(cases[i].text, strlen(cases[i].text), &value, &used));
        CHECK_BITS(value, cases[i].value);
        CHECK_INT(used, cases[i].used);
    }
}

TEST(reading_stops_at_the_length_given)
{
    double value = 0;
    CHECK_OK(batten_number_read("123456", 3, &value, NULL));
    CHECK_BITS(value, 123);
    CHECK_OK(batten_number_read("1e55", 3, &value, NULL));
    CHECK_BITS(value, 1e5);
}

TEST(N4_whole_numbers_are_read_within_their_bounds)
{
    static const struct {
        const char *text;
        int64_t low, high, value;
    } good[] = {{"0", 0, 0, 0},
                {"-0", 0, 5, 0},
                {"+007", 0, 10, 7},
                {"9223372036854775807", 0, INT64_MAX, INT64_MAX},
                {"-9223372036854775808", INT64_MIN, 0, INT64_MIN}};
    for (int i = 0; i < COUNT(good); i++) {
        int64_t value = 99;
        CHECK_OK(batten_integer_read(good[i].text, strlen(good[i].text), good[i].low,
                                     good[i].high, &value, NULL));
        CHECK_INT(value, good[i].value);
    }
    int64_t value = 99;
    size_t used = 99;
    CHECK_OK(batten_integer_read("12,5", 4, 0, 100, &value, &used));
    CHECK(value == 12 && used == 2);
}

TEST(N4_what_is_no_count_is_refused)
{
    static const struct {
        const char *text;
        batten_status status;
    } bad[] = {{"", BATTEN_BAD_FORMAT},
               {"-", BATTEN_BAD_FORMAT},
               {"1e3", BATTEN_BAD_FORMAT},
               {"1.0", BATTEN_BAD_FORMAT},
               {"0x10", BATTEN_BAD_FORMAT},
               {" 1", BATTEN_BAD_FORMAT},
               {"-1", BATTEN_OVERFLOW},
               {"101", BATTEN_OVERFLOW},
               {"2147483648", BATTEN_OVERFLOW},
               {"4294967297", BATTEN_OVERFLOW},
               {"9223372036854775808", BATTEN_OVERFLOW},
               {"18446744073709551617", BATTEN_OVERFLOW},
               {"-9223372036854775809", BATTEN_OVERFLOW},
               {"99999999999999999999999999999999", BATTEN_OVERFLOW}};
    for (int i = 0; i < COUNT(bad); i++) {
        int64_t value = 99;
        CHECK_STATUS(
            batten_integer_read(bad[i].text, strlen(bad[i].text), 0, 100, &value, NULL),
            bad[i].status);
        CHECK_MESSAGE(bad[i].text);
        CHECK_INT(value, 99);
    }
}

TEST(numbers_read_quickly_are_those_of_the_long_way)
{
    /* A digit 0 in front of the exponent's limit, and 20 digits, take the long way. */
    static const char *const texts[] = {"1e27",
                                        "1e28",
                                        "1e-27",
                                        "1e-28",
                                        "9007199254740993",
                                        "9007199254740992.5",
                                        "9007199254740993.0000",
                                        "1234567890123456789",
                                        "12345678901234567890",
                                        "0.0000000000000000001234567890123456789",
                                        "00000000000000000000000000000012.5",
                                        "18014398509481985",
                                        "99999999999999999e5",
                                        "0.30000000000000004",
                                        "1.7976931348623157e15",
                                        "4503599627370496.5",
                                        "4503599627370497.5",
                                        "-0.0e5",
                                        "-12345678.12345678",
                                        "12345678901234567e-27",
                                        "9223372036854775807e27"};
    for (int i = 0; i < COUNT(texts); i++)
        CHECK_BITS(read_all(texts[i]), strtod(texts[i], NULL));
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(20000); i++) {
        char text[64];
        const int digits = test_random_int(&random, 1, 19);
        int n = 0, point = test_random_int(&random, 0, digits);
        for (int k = 0; k < digits; k++) {
            if (k == point)
                text[n++] = '.';
            text[n++] = (char)('0' + test_random_int(&random, 0, 9));
        }
        sprintf(text + n, "e%d", test_random_int(&random, -30, 30));
        CHECK_BITS(read_all(text), strtod(text, NULL));
    }
}
