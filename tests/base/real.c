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
