/* Powers of ten and long integers, by arithmetic that is exact. */
#include "base/decimal.h"

#include "support/test.h"

/* b as a double, exact up to 2^53. */
static double big_value(const bat_big *b)
{
    double value = 0;
    for (int i = b->count - 1; i >= 0; i--)
        value = value * 4294967296.0 + b->words[i];
    return value;
}

TEST(powers_of_ten_have_their_first_bits)
{
    for (int k = 0; k <= 27; k++) { /* 10^27 = 5^27 2^27, and 5^27 < 2^63 */
        uint64_t five = 1;
        for (int i = 0; i < k; i++)
            five *= 5;
        const bat_power power = bat_power_of_ten(k);
        const int shift = __builtin_clzll(five);
        CHECK(power.high == five << shift && power.low == 0 && power.exact);
        CHECK_INT(power.exponent, k - 64 - shift);
    }
    CHECK(!bat_power_of_ten(-1).exact && !bat_power_of_ten(56).exact);
    /* 1/10 = 0.8 2^-3 and 0.8 = 0.110011001100... */
    CHECK(bat_power_of_ten(-1).high == 0xccccccccccccccccu);
}

TEST(powers_of_ten_times_ten_are_the_next)
{
    for (int k = BAT_LOWEST_POWER; k < BAT_HIGHEST_POWER; k++) {
        const bat_power here = bat_power_of_ten(k), next = bat_power_of_ten(k + 1);
        CHECK(here.high >> 63 == 1);
        const double ratio =
            ldexp((double)next.high, next.exponent - here.exponent) / (double)here.high;
        CHECK_NEAR(ratio, 10, 1e-14);
    }
}

TEST(long_integers_multiply_compare_subtract_and_halve)
{
    bat_big a, b;
    bat_big_set(&a, 0);
    CHECK_INT(a.count, 0);
    bat_big_set(&a, ((uint64_t)5 << 32) + 7);
    CHECK(a.count == 2 && a.words[0] == 7 && a.words[1] == 5);
    bat_big_multiply(&a, 1000, 1);
    CHECK_NEAR(big_value(&a), 1000 * (5 * 4294967296.0 + 7) + 1, 0);
    bat_big_set(&b, 1);
    CHECK(bat_big_compare(&a, &b) > 0 && bat_big_compare(&b, &a) < 0);
    CHECK_INT(bat_big_compare(&a, &a), 0);
    bat_big_subtract(&a, &b);
    CHECK_NEAR(big_value(&a), 1000 * (5 * 4294967296.0 + 7), 0);
    bat_big_halve(&a);
    CHECK_NEAR(big_value(&a), 500 * (5 * 4294967296.0 + 7), 0);
    b = a;
    bat_big_subtract(&a, &b);
    CHECK_INT(a.count, 0);
}

TEST(long_integers_are_scaled_by_powers_of_ten_and_two)
{
    for (int ten = 0; ten <= 15; ten++)
        for (int two = 0; two <= 3; two++) {
            bat_big a, b;
            bat_big_set(&a, 3);
            bat_big_scale(&a, ten, two);
            CHECK_NEAR(big_value(&a), 3 * pow(10, ten) * (1 << two), 0);
            bat_big_set(&b, 3);
            bat_big_scale(&b, -ten, -two); /* what is negative is left out */
            CHECK_NEAR(big_value(&b), 3, 0);
        }
    /* 10^300 2^100 against 2^1096: 300 log2(10) = 996.58 */
    bat_big a, b;
    bat_big_set(&a, 1);
    bat_big_scale(&a, 300, 100);
    bat_big_set(&b, 1);
    bat_big_scale(&b, 0, 1096);
    CHECK(bat_big_compare(&a, &b) > 0);
    bat_big_halve(&a);
    CHECK(bat_big_compare(&a, &b) < 0);
}

TEST(a_double_is_an_integer_times_a_power_of_two)
{
    static const double values[] = {1, 0.1, 1e300, 5e-324, 2.2250738585072014e-308, 3e-310};
    for (int i = 0; i < COUNT(values); i++) {
        uint64_t bits, m;
        int e;
        memcpy(&bits, &values[i], sizeof bits);
        bat_take_apart(bits, &m, &e);
        CHECK(m < (uint64_t)1 << 53);
        CHECK_BITS(ldexp((double)m, e), values[i]);
    }
}
