/*
 * What reading and writing of numbers share: powers of ten known to 128 bits, long integers for
 * what these leave open, and doubles taken apart.
 */
#ifndef BAT_DECIMAL_H
#define BAT_DECIMAL_H
#include "base/base.h"
#include "base/wide.h"

#include <stdint.h>

/* ---- powers of ten ---- */

#define BAT_COARSE_FIRST (-13)
/* 10^(27 j) for j = -13 .. 12, its first 192 bits, the first of them 1, cut off; 5^i. */
extern const uint64_t bat_coarse_powers[26][3], bat_fives[27];

/* The first 128 bits of 10^k, the first of them 1; the true value is above it by at most 2
 * units of the last. */
typedef struct {
    uint64_t high, low;
    int exponent; /* 10^k = (high 2^64 + low) 2^exponent */
    bool exact;
} bat_power;

#define BAT_LOWEST_POWER (27 * BAT_COARSE_FIRST)
#define BAT_HIGHEST_POWER (27 * 13 - 1)

static inline int bat_floor_log2_of_power(int k)
{
    return (k * 217706) >> 16; /* log2 10 = 3.32193; right for |k| <= 400 */
}

/* A 255-bit product of 10^(27 j) and 5^i, i < 27; the cut of the first factor stays below 2^-64
 * of a unit. */
static inline bat_power bat_power_of_ten(int k)
{
    assert(k >= BAT_LOWEST_POWER && k <= BAT_HIGHEST_POWER);
    const int j = (k - BAT_LOWEST_POWER) / 27, i = (k - BAT_LOWEST_POWER) % 27;
    const uint64_t five = bat_fives[i];
    const bat_wide low = bat_wide_product(bat_coarse_powers[j][2], five);
    const bat_wide middle = bat_wide_add(bat_wide_product(bat_coarse_powers[j][1], five),
                                         bat_wide_of(0, bat_wide_high(low)));
    const bat_wide high = bat_wide_add(bat_wide_product(bat_coarse_powers[j][0], five),
                                       bat_wide_of(0, bat_wide_high(middle)));
    const uint64_t first = bat_wide_high(high);
    const int shift = __builtin_clzll(first ? first : bat_wide_low(high)) + (first ? 0 : 64);
    /* 1 <= shift <= 64 */
    const bat_wide top = bat_wide_add(bat_wide_left(high, shift),
                                      bat_wide_of(0, bat_wide_low(middle) >> (64 - shift)));
    return (bat_power){bat_wide_high(top), bat_wide_low(top), bat_floor_log2_of_power(k) - 127,
                       k >= 0 && k <= 55}; /* 5^55 < 2^128 */
}

/* ---- long integers ---- */

/* 801 digits times 2^1075, and 10^1125 times 54 bits, have fewer than 3800 bits. */
typedef struct {
    int count; /* words in use; the highest is not 0 */
    uint32_t words[128];
} bat_big;

void bat_big_set(bat_big *b, uint64_t value);
/* b = b * factor + more */
void bat_big_multiply(bat_big *b, uint32_t factor, uint32_t more);
/* b = b * 10^ten * 2^two; what is negative is left out. */
void bat_big_scale(bat_big *b, int ten, int two);
int bat_big_compare(const bat_big *a, const bat_big *b);
/* a = a - b, where a >= b */
void bat_big_subtract(bat_big *a, const bat_big *b);
void bat_big_halve(bat_big *b);

/* ---- doubles taken apart ---- */

#define BAT_FRACTION_BITS 52
#define BAT_INFINITE_BITS ((uint64_t)0x7ff << BAT_FRACTION_BITS)
#define BAT_SIGN_BIT ((uint64_t)1 << 63)

/* A positive double is m 2^e. */
static inline void bat_take_apart(uint64_t bits, uint64_t *m, int *e)
{
    const int biased = (int)(bits >> BAT_FRACTION_BITS);
    *m = bits & (((uint64_t)1 << BAT_FRACTION_BITS) - 1);
    *e = -1074;
    if (biased > 0) {
        *m |= (uint64_t)1 << BAT_FRACTION_BITS;
        *e = biased - 1075;
    }
}

#endif
