/* Numbers of files, many characters at once. */
#ifndef BAT_DIGITS_H
#define BAT_DIGITS_H
#include "base/decimal.h"

#include <string.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

/* A byte in each of eight: 'x' * BAT_BYTES. */
#define BAT_BYTES ((uint64_t)0x0101010101010101u)

/* The first is the least byte. */
static inline uint64_t bat_eight_characters(const char *c)
{
    uint64_t chunk;
    memcpy(&chunk, c, sizeof chunk);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    chunk = __builtin_bswap64(chunk);
#endif
    return chunk;
}

/* Eight digits less '0' each, the first of them the least byte, as a number: pairs, then fours,
 * then all. */
static inline uint64_t bat_eight_digits(uint64_t digits)
{
    digits = digits * 10 + (digits >> 8);
    return ((digits & 0x000000ff000000ffu) * 0x000f424000000064u +
            ((digits >> 16) & 0x000000ff000000ffu) * 0x0000271000000001u) >>
           32;
}

/* ---- numbers ---- */

/*
 * Nearly all numbers of files have at most 19 digits and a small exponent. For them 64 bits of
 * the power of ten say enough, but where what is cut off may lie on either side of the middle
 * between two doubles; those few, and all others, go the long way. Source: [Lemire21].
 */
enum { BAT_QUICK_POWER = 27 };

/* The first 64 bits of 10^k, k = -27 .. 27, cut off; 10^0 to 10^7. */
extern const uint64_t bat_quick_powers[2 * BAT_QUICK_POWER + 1], bat_small_tens[8];

/* w 10^k as a double; false when 64 bits leave it open. */
static inline bool bat_quick_double(uint64_t w, int k, uint64_t *bits)
{
    enum { DROP = 63 - BAT_FRACTION_BITS, HALF = 1 << (DROP - 1), MASK = 2 * HALF - 1 };
    const int shift = __builtin_clzll(w);
    const uint64_t product =
        bat_wide_high(bat_wide_product(w << shift, bat_quick_powers[k + BAT_QUICK_POWER]));
    const int short_of = !(product >> 63);
    const uint64_t high = product << short_of;
    /* The true product is above `high` by less than 4: is the half among what it may be? */
    if (((high - (HALF - 3)) & MASK) <= 3)
        return false;
    const int exponent = 64 - short_of - shift + bat_floor_log2_of_power(k);
    *bits = ((uint64_t)(exponent + 1022) << BAT_FRACTION_BITS) + (high >> DROP) +
            (high >> (DROP - 1) & 1);
    return true;
}

/* The first `count` of eight characters, 0 to 7, which are digits, put behind w. */
static inline uint64_t bat_with_digits(uint64_t w, const char *c, int count)
{
    const uint64_t digits = bat_eight_characters(c) - '0' * BAT_BYTES;
    return bat_small_tens[count] * w + bat_eight_digits(digits << (56 - 8 * count) << 8);
}

/* The number whose digits begin at c: `before` of them, then, behind a '.', `places`. Up to
 * sixteen characters behind the last are looked at. False when there are too many digits, or
 * none, or when 64 bits leave it open. */
static inline bool bat_number_of_digits(const char *c, int before, int places, uint64_t *bits)
{
    const int count = before + places;
    if (count == 1 && places == 0) { /* weights and knots are often such */
        const double value = c[0] - '0';
        memcpy(bits, &value, sizeof value);
        return true;
    }
    if (before > 7 || (unsigned)(count - 1) > 18)
        return false;
    /* Up to eight digits without the '.' among or behind them. */
    const uint64_t first = bat_eight_characters(c), next = bat_eight_characters(c + 1);
    const uint64_t behind = ~(uint64_t)0 << 8 * before;
    const uint64_t digits = ((first & ~behind) | (next & behind)) - '0' * BAT_BYTES;
    uint64_t w;
    if (count >= 16) {
        w = 100000000 * bat_eight_digits(digits) +
            bat_eight_digits(bat_eight_characters(c + 9) - '0' * BAT_BYTES);
        w = bat_with_digits(w, c + 17, count - 16);
    } else if (count >= 8) {
        w = bat_with_digits(bat_eight_digits(digits), c + 9, count - 8);
    } else {
        w = bat_eight_digits(digits << (64 - 8 * count));
    }
    if (w == 0) {
        *bits = 0;
        return true;
    }
    return bat_quick_double(w, -places, bits);
}

/* ---- what is a digit ---- */

/* Bit i of the result: character i of 64 is no digit. */
static inline uint64_t bat_no_digits_plainly(const char *c)
{
    uint64_t marks = 0;
    for (int i = 0; i < 64; i += 8) {
        const uint64_t digits = bat_eight_characters(c + i) ^ '0' * BAT_BYTES;
        const uint64_t others = ((digits & 0x7f * BAT_BYTES) + 0x76 * BAT_BYTES) | digits;
        /* The highest bit of each byte, brought together. */
        marks |= ((others >> 7 & BAT_BYTES) * 0x0102040810204080u >> 56) << i;
    }
    return marks;
}

#ifdef __SSE2__
/* Bit i of the result: character i of 16 is a digit. */
static inline uint64_t bat_sixteen_digits(const char *c)
{
    const __m128i some = _mm_loadu_si128((const __m128i *)(const void *)c);
    const __m128i digits = _mm_sub_epi8(some, _mm_set1_epi8('0'));
    const __m128i is_digit = _mm_cmpeq_epi8(digits, _mm_min_epu8(digits, _mm_set1_epi8(9)));
    return (uint64_t)_mm_movemask_epi8(is_digit);
}
#endif

/* The same, at once where the processor can. */
static inline uint64_t bat_no_digits(const char *c)
{
#ifdef __SSE2__
    return ~(bat_sixteen_digits(c) | bat_sixteen_digits(c + 16) << 16 |
             bat_sixteen_digits(c + 32) << 32 | bat_sixteen_digits(c + 48) << 48);
#else
    return bat_no_digits_plainly(c);
#endif
}

#endif
