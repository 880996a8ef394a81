/* Common numbers as text: those of few digits, without long arithmetic. */
#include "base/number_common.h"
#include "base/digits.h"

#include <string.h>

/* ---- common numbers ---- */

/*
 * With 10^k at most the distance of the midpoints, x / 10^k is m 5^-k 2^(e - k). For k from -25
 * to -1, which are numbers with a fraction above 1e-9, 5^-k fits one word and all quantities
 * are exact in two: whole parts in the upper, what is behind the point in the lower.
 */
enum { COMMON_POWER = 25 };

/* The shortest digits of m 2^e, 2^52 < m < 2^53, as units of 10^-j: 16 or 17 of them. */
static inline uint64_t shortest_common(uint64_t m, int e, int j)
{
    const uint64_t unit = bat_fives[j] << (60 + e + j); /* 10^j 2^e is 1 to 10, in 2^60 */
    const bat_wide x = bat_wide_product(m << 4, unit), half = bat_wide_product(unit, 8);
    const uint64_t odd = m & 1; /* then the midpoints themselves do not belong */
    const bat_wide shy = bat_wide_subtract(half, bat_wide_of(0, odd));
    const uint64_t last = bat_wide_high(bat_wide_add(x, shy)),
                   before = bat_wide_high(
                       bat_wide_subtract(bat_wide_subtract(x, shy), bat_wide_of(0, 1)));
    const uint64_t ten = last / 10 * 10, whole = bat_wide_high(x);
    /* Half a unit is closer than the midpoints: rounding cannot leave the interval. */
    const uint64_t nearest =
        bat_wide_high(bat_wide_add(x, bat_wide_of(0, ((uint64_t)1 << 63) - 1 + (whole & 1))));
    return ten > before ? ten : nearest;
}

/* Eight digits as numbers, the first in the least byte: fours, then pairs, then all. */
static inline uint64_t eight_digits(uint32_t value)
{
    uint64_t digits = value / 10000 | (uint64_t)(value % 10000) << 32;
    uint64_t high = ((digits * 10486) >> 20) & 0x0000007f0000007fu;
    digits = high | (digits - 100 * high) << 16;
    high = ((digits * 103) >> 10) & 0x000f000f000f000fu;
    return high | (digits - 10 * high) << 8;
}

static inline void put_eight(char *to, uint64_t characters)
{
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    characters = __builtin_bswap64(characters);
#endif
    memcpy(to, &characters, sizeof characters);
}

/* How many zeros end sixteen digits. */
static inline int zeros_behind(uint64_t first, uint64_t second)
{
    if (second)
        return __builtin_clzll(second) >> 3;
    return first ? 8 + (__builtin_clzll(first) >> 3) : 16;
}

char *bat_number_write_common(char *to, uint64_t bits)
{
    uint64_t m;
    int e;
    bat_take_apart(bits, &m, &e);
    const int k = (e * 1262611) >> 22, j = -k;
    if (j < 1 || j > COMMON_POWER || m == (uint64_t)1 << BAT_FRACTION_BITS)
        return NULL;
    uint64_t value = shortest_common(m, e, j);
    const bool is_short = value < 10000000000000000u;
    value *= is_short ? 10 : 1;
    const int exponent = 16 - j - is_short;
    if (exponent < -5 || exponent > 7)
        return NULL;
    const uint64_t lead = value / 10000000000000000u;
    const uint64_t behind = value - 10000000000000000u * lead;
    const uint64_t first = eight_digits((uint32_t)(behind / 100000000)),
                   second = eight_digits((uint32_t)(behind % 100000000));
    const uint64_t front = first | '0' * BAT_BYTES, back = second | '0' * BAT_BYTES;
    const int count = 17 - zeros_behind(first, second);
    if (exponent < 0) {
        memcpy(to, "0.0000", 6);
        to += 1 - exponent;
        to[0] = (char)('0' + lead);
        put_eight(to + 1, front);
        put_eight(to + 9, back);
        return to + count;
    }
    /* All behind the point, then, from the left, what is before it. */
    const uint64_t kept = ((uint64_t)1 << 8 * exponent) - 1;
    put_eight(to + 2, front);
    put_eight(to + 10, back);
    to[0] = (char)('0' + lead);
    put_eight(to + 1, (front & kept) | (front & ~kept) << 8 | (uint64_t)'.' << 8 * exponent);
    return to + count + 1;
}
