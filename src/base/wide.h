/*
 * Whole numbers of 128 bits without a sign: those of the compiler where it has them, two words elsewhere. Sums and
 * differences wrap around. BAT_WIDE_BY_WORDS asks for the two words anyway; tests compare both.
 */
#ifndef BAT_WIDE_H
#define BAT_WIDE_H
#include <stdbool.h>
#include <stdint.h>

#if defined(__SIZEOF_INT128__) && !defined(BAT_WIDE_BY_WORDS)

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

#else

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

/* -1, 0 or 1 */
static inline int bat_wide_compare(bat_wide a, bat_wide b)
{
    if (bat_wide_high(a) != bat_wide_high(b))
        return bat_wide_high(a) < bat_wide_high(b) ? -1 : 1;
    return (bat_wide_low(a) > bat_wide_low(b)) - (bat_wide_low(a) < bat_wide_low(b));
}

static inline bool bat_wide_is_zero(bat_wide a)
{
    return (bat_wide_high(a) | bat_wide_low(a)) == 0;
}

/* The last n bits, 0 <= n < 128. */
static inline bat_wide bat_wide_rest(bat_wide a, int n)
{
    const bat_wide one = bat_wide_left(bat_wide_of(0, 1), n);
    const bat_wide mask = bat_wide_subtract(one, bat_wide_of(0, 1));
    return bat_wide_of(bat_wide_high(a) & bat_wide_high(mask),
                       bat_wide_low(a) & bat_wide_low(mask));
}

#endif
