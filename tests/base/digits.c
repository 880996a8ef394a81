/* Digits by the word. */
#include "base/digits.h"

#include "base/numbers.h"

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
