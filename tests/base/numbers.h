/* Numbers written and read, the C library's conversions for a witness. */
#ifndef TESTS_BASE_NUMBERS_H
#define TESTS_BASE_NUMBERS_H
#include "support/test.h"

#include <batten/text.h>
#include <stdlib.h>

static inline double read_all(const char *text)
{
    double value = NAN;
    CHECK_OK(batten_number_read(text, strlen(text), &value, NULL));
    return value;
}

static inline double random_double(test_random *random)
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
static inline int significant_digits(const char *text, char *digits)
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
static inline void check_round_trip(double value, bool is_shortest)
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

#endif
