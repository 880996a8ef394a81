/*
 * bat_wide as the compiler's own whole number of 128 bits; see base/wide.h, which chooses.
 */
#ifndef BAT_WIDE_NATIVE_H
#define BAT_WIDE_NATIVE_H
#include <stdint.h>

__extension__ typedef unsigned __int128 bat_wide;

static inline bat_wide bat_wide_of(uint64_t high, uint64_t low)
{
    return (bat_wide)high << 64 | low;
}

static inline uint64_t bat_wide_high(bat_wide a)
{
    return (uint64_t)(a >> 64);
}

static inline uint64_t bat_wide_low(bat_wide a)
{
    return (uint64_t)a;
}

static inline bat_wide bat_wide_product(uint64_t a, uint64_t b)
{
    return (bat_wide)a * b;
}

static inline bat_wide bat_wide_add(bat_wide a, bat_wide b)
{
    return a + b;
}

static inline bat_wide bat_wide_subtract(bat_wide a, bat_wide b)
{
    return a - b;
}

/* a 2^n and a 2^-n, 0 <= n < 128 */
static inline bat_wide bat_wide_left(bat_wide a, int n)
{
    return a << n;
}

static inline bat_wide bat_wide_right(bat_wide a, int n)
{
    return a >> n;
}

#endif
