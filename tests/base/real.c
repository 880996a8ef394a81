#include "base/real.h"

#include <stdlib.h>

#include "support/test.h"

TEST(reals_have_a_point_and_a_capital_E)
{
    const struct {
        double value;
        const char *text;
    } cases[] = {
        {0, "0."},       {-0.0, "-0."},        {1, "1."}, {0.1, "0.1"}, {-2.5e-7, "-2.5E-7"},
        {1e22, "1.E22"}, {4.9e-324, "5.E-324"}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[BAT_REAL_SIZE];
        bat_real_write(cases[i].value, text);
        CHECK_TEXT(text, cases[i].text);
    }
}

TEST(any_number_reads_back_to_the_same_bits)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(2000); i++) {
        const uint64_t bits = test_random_bits(&random);
        char text[BAT_REAL_SIZE];
        double value;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value))
            continue;
        bat_real_write(value, text);
        CHECK(strchr(text, '.') != NULL && strchr(text, 'e') == NULL);
        CHECK_BITS(strtod(text, NULL), value);
    }
}

TEST(whole_numbers_are_written_in_their_digits)
{
    const struct {
        int64_t value;
        const char *text;
    } cases[] = {{0, "0"},
                 {7, "7"},
                 {-7, "-7"},
                 {1234567, "1234567"},
                 {INT64_MAX, "9223372036854775807"},
                 {INT64_MIN, "-9223372036854775808"}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[BAT_INTEGER_SIZE];
        CHECK_INT(bat_integer_write(cases[i].value, text), (int)strlen(cases[i].text));
        CHECK_TEXT(text, cases[i].text);
    }
}

/* Numbers of every length with something behind them, near the end of the text and far from it:
 * the quick way must say the same as the whole one, or nothing. */
TEST(the_quick_way_to_a_number_says_the_same_as_the_whole_one)
{
    static const char *const shapes[] = {"0.",
                                         "1.",
                                         "-1.5",
                                         ".5",
                                         "5",
                                         "12345678.5",
                                         "0.000000001234",
                                         "1.E5",
                                         "1e5",
                                         "-2.5E-7",
                                         "3.14159265358979312",
                                         "0.12345678901234567",
                                         "99999999999999999999.",
                                         "1234567.12345678901234567890123",
                                         "0.0",
                                         "-0.",
                                         "1e300",
                                         "1e-300",
                                         "+1",
                                         "x",
                                         ".",
                                         "-",
                                         "123456.7",
                                         "9007199254740993.",
                                         "0.30000000000000004",
                                         "1e",
                                         "1.e+",
                                         "00012.50"};
    static const char *const behind[] = {"",
                                         ",",
                                         ";",
                                         " ",
                                         ",1.,2.,3.,4.,5.,6.,7.,8.,9.,10.,11.",
                                         "                                                   "};
    for (int i = 0; i < COUNT(shapes); i++)
        for (int k = 0; k < COUNT(behind); k++) {
            char text[160];
            const int length = snprintf(text, sizeof text, "%s%s", shapes[i], behind[k]);
            double whole = 8;
            size_t used = 0;
            char *end = NULL;
            const batten_status status =
                batten_number_read(text, (size_t)length, &whole, &used);
            if (status != BATTEN_OK)
                continue;
            CHECK_BITS(whole, strtod(text, &end));
            CHECK_INT(end - text, (int)used);
        }
}

/* Of one to nineteen digits on both sides of the point. */
TEST(numbers_of_any_length_are_read_as_the_c_library_reads_them)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(3000); i++) {
        char text[160];
        int at = 0;
        const int before = test_random_int(&random, 0, 10),
                  after = test_random_int(&random, 0, 26);
        if (before + after == 0)
            continue;
        if (test_random_int(&random, 0, 1))
            text[at++] = '-';
        for (int k = 0; k < before; k++)
            text[at++] = (char)('0' + test_random_int(&random, 0, 9));
        text[at++] = '.';
        for (int k = 0; k < after; k++)
            text[at++] = (char)('0' + test_random_int(&random, 0, 9));
        if (test_random_int(&random, 0, 2) == 0)
            at += snprintf(text + at, sizeof text - (size_t)at, "E%d",
                           test_random_int(&random, -30, 30));
        snprintf(text + at, sizeof text - (size_t)at, "%s",
                 test_random_int(&random, 0, 1) ? ",                                          "
                                                : "");
        double value = 0;
        size_t used = 0;
        CHECK_OK(batten_number_read(text, strlen(text), &value, &used));
        CHECK_INT(used, at);
        CHECK_BITS(value, strtod(text, NULL));
    }
}
