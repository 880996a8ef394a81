/*
 * bat_wide as two words of 64 bits, for compilers without a wider one; see base/wide.h, which chooses.
 */
#ifndef BAT_WIDE_WORDS_H
#define BAT_WIDE_WORDS_H
#include <stdint.h>

typedef struct {
    uint64_t high, low;
} bat_wide;

static inline bat_wide bat_wide_of(uint64_t high, uint64_t low)
{
    return (bat_wide){high, low};
}

static inline uint64_t bat_wide_high(bat_wide a)
{
    return a.high;
}

static inline uint64_t bat_wide_low(bat_wide a)
{
    return a.low;
}

/* By halves of 32 bits. */
static inline bat_wide bat_wide_product(uint64_t a, uint64_t b)
{
    const uint64_t a1 = a >> 32, a0 = a & UINT32_MAX, b1 = b >> 32, b0 = b & UINT32_MAX;
    const uint64_t low = a0 * b0, middle = a1 * b0 + (low >> 32);
    const uint64_t other = a0 * b1 + (middle & UINT32_MAX);
    return (bat_wide){a1 * b1 + (middle >> 32) + (other >> 32),
                      other << 32 | (low & UINT32_MAX)};
}

static inline bat_wide bat_wide_add(bat_wide a, bat_wide b)
{
    const uint64_t low = a.low + b.low;
    return (bat_wide){a.high + b.high + (low < a.low), low};
}

static inline bat_wide bat_wide_subtract(bat_wide a, bat_wide b)
{
    return (bat_wide){a.high - b.high - (a.low < b.low), a.low - b.low};
}

/* a 2^n and a 2^-n, 0 <= n < 128 */
static inline bat_wide bat_wide_left(bat_wide a, int n)
{
    if (n >= 64)
        return (bat_wide){a.low << (n - 64), 0};
    return n == 0 ? a : (bat_wide){a.high << n | a.low >> (64 - n), a.low << n};
}

static inline bat_wide bat_wide_right(bat_wide a, int n)
{
    if (n >= 64)
        return (bat_wide){0, a.high >> (n - 64)};
    return n == 0 ? a : (bat_wide){a.high >> n, a.low >> n | a.high << (64 - n)};
}

#endif
