#define _XOPEN_SOURCE 700
#include "base/digits.h"
#include <batten/text.h>

#include "support/test.h"
#include <locale.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

static double read_all(const char *text)
{
    double value = NAN;
    CHECK_OK(batten_number_read(text, strlen(text), &value, NULL));
    return value;
}

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

static double random_double(test_random *random)
{
    for (;;) {
        const uint64_t bits = test_random_bits(random);
        double value;
        memcpy(&value, &bits, sizeof value);
        if (isfinite(value))
            return value;
    }
}

/* The significant digits of a written number, to digits[64]: how many. */
static int significant_digits(const char *text, char *digits)
{
    int count = 0;
    for (const char *c = text; *c && *c != 'e'; c++)
        if (*c >= '0' && *c <= '9' && (*c != '0' || count > 0))
            digits[count++] = *c;
    while (count > 0 && digits[count - 1] == '0')
        count--;
    digits[count] = 0;
    return count;
}

/* The C library's own conversions are correctly rounded and serve as a witness in the C locale.
 */
static void check_round_trip(double value, bool is_shortest)
{
    char text[BATTEN_NUMBER_SIZE] = "", shorter[64], digits[64];
    const int length = batten_number_write(value, text);
    CHECK_INT(length, strlen(text));
    CHECK_BITS(strtod(text, NULL), value);
    CHECK_BITS(read_all(text), value);
    const int count = significant_digits(text, digits);
    if (is_shortest && count > 1) {
        snprintf(shorter, sizeof shorter, "%.*e", count - 2, value);
        CHECK(strtod(shorter, NULL) != value);
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

static void check_locale(const char *name)
{
    if (!setlocale(LC_ALL, name))
        SKIP("the locale %s is not installed", name);
    char text[BATTEN_NUMBER_SIZE];
    batten_number_write(1234567.25, text);
    const double value = read_all("1.5");
    setlocale(LC_ALL, "C");
    CHECK_TEXT(text, "1234567.25");
    CHECK_BITS(value, 1.5);
}

TEST(F5_numbers_are_the_same_in_german)
{
    check_locale("de_DE.UTF-8");
}

TEST(F5_numbers_are_the_same_in_turkish)
{
    check_locale("tr_TR.UTF-8");
}

static atomic_bool stop_switching;

static void *switch_locale(void *user)
{
    (void)user;
    while (!atomic_load(&stop_switching)) {
        setlocale(LC_ALL, "de_DE.UTF-8");
        setlocale(LC_ALL, "C");
    }
    return NULL;
}

TEST(F5_numbers_are_the_same_while_another_thread_switches_the_locale)
{
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        SKIP("the locale de_DE.UTF-8 is not installed");
    pthread_t thread;
    atomic_store(&stop_switching, false);
    CHECK(pthread_create(&thread, NULL, switch_locale, NULL) == 0);
    bool same = true;
    for (int i = 0; i < test_cases(2000) && same; i++) {
        char text[BATTEN_NUMBER_SIZE];
        double value = 0;
        batten_number_write(i + 0.5, text);
        same = strchr(text, '.') &&
               batten_number_read(text, strlen(text), &value, NULL) == BATTEN_OK &&
               value == i + 0.5;
    }
    atomic_store(&stop_switching, true);
    pthread_join(thread, NULL);
    setlocale(LC_ALL, "C");
    CHECK(same);
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

/* As the reader of IGES does, which knows where the digits, the point and the end are. */
TEST(numbers_of_known_digits_are_those_of_the_long_way)
{
    test_random random = test_random_begin(__func__);
    int refused = 0;
    for (int i = 0; i < test_cases(50000); i++) {
        char text[64];
        const int before = test_random_int(&random, 0, 8);
        const int places = test_random_int(&random, 0, 20);
        const bool has_zeros = test_random_int(&random, 0, 3) == 0;
        int n = 0;
        for (int k = 0; k < before + places; k++) {
            if (k == before)
                text[n++] = '.';
            text[n++] = (char)('0' + (has_zeros ? 0 : test_random_int(&random, 0, 9)));
        }
        /* What follows must not count. */
        for (int k = n; k < COUNT(text) - 1; k++)
            text[k] = (char)test_random_int(&random, 1, 255);
        text[COUNT(text) - 1] = 0;
        uint64_t bits;
        double value;
        if (!bat_number_of_digits(text, before, places, &bits)) {
            refused += before <= 7 && before + places > 0 && before + places <= 19;
            continue;
        }
        memcpy(&value, &bits, sizeof value);
        text[n] = 0;
        CHECK_BITS(value, strtod(text, NULL));
    }
    CHECK(refused < 10 + test_cases(50000) / 100); /* those near the middle of two doubles */
}

TEST(what_is_no_digit_is_marked_among_64)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(2000); i++) {
        char text[64];
        for (int k = 0; k < COUNT(text); k++)
            text[k] = (char)(test_random_int(&random, 0, 1) ? test_random_int(&random, '/', ':')
                                                            : test_random_int(&random, 0, 255));
        const uint64_t marks = bat_no_digits(text);
        CHECK(marks == bat_no_digits_plainly(text));
        for (int k = 0; k < COUNT(text); k++)
            CHECK_INT((int)(marks >> k & 1), text[k] < '0' || text[k] > '9');
    }
}
