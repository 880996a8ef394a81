/*
 * Large angles: x = m 2^e for a whole m, and of m 2^e / (2 pi) only what lies below the point matters, so a window of
 * the bits of 1/(2 pi) is enough. Source: [PH83].
 */
#include "base/elementary/turn.h"

#include <stdbool.h>

enum { WINDOW = 6 /* words of 32 bits: 53 are m, 61 may cancel, 64 are left */ };

/* The fraction of m 2^e / (2 pi) in WINDOW words, the first in front. */
static void fraction_of_turns(uint64_t m, int e, uint32_t fraction[WINDOW])
{
    /* 2^e moves e bits before the point: the words from `first` on, shifted left by `shift`. The table begins with a
     * word that is 0, for e from -32 on. */
    const int first = (e + 32) / 32, shift = (e + 32) % 32;
    uint32_t words[WINDOW + 1];
    for (int i = 0; i <= WINDOW; i++)
        words[i] = bat_turns[first + i];
    if (shift > 0)
        for (int i = 0; i < WINDOW; i++)
            words[i] = words[i] << shift | words[i + 1] >> (32 - shift);
    /* Times m, as two words; what runs over are whole turns. */
    uint64_t carry = 0;
    for (int i = WINDOW - 1; i >= 0; i--) {
        const uint64_t sum = (uint64_t)words[i] * (uint32_t)m + carry;
        fraction[i] = (uint32_t)sum;
        carry = sum >> 32;
    }
    carry = 0;
    for (int i = WINDOW - 1; i > 0; i--) {
        const uint64_t sum = words[i] * (m >> 32) + fraction[i - 1] + carry;
        fraction[i - 1] = (uint32_t)sum;
        carry = sum >> 32;
    }
}

/* The sum of words[i] 2^(-32 (i + 1)), of which the first that is not 0 is among the first two. */
static bat_twin value_of_words(const uint32_t words[WINDOW])
{
    double parts[WINDOW], place = 1;
    for (int i = 0; i < WINDOW; i++)
        parts[i] = words[i] * (place *= 0x1p-32);
    const bat_twin a = bat_twin_sum(parts[0], parts[1]), b = bat_twin_any_sum(a.low, parts[2]),
                   c = bat_twin_any_sum(b.low, parts[3]), sum = bat_twin_sum(a.high, b.high);
    return bat_twin_sum(sum.high, sum.low + (c.high + (c.low + (parts[4] + parts[5]))));
}

bat_angle bat_reduce_large_angle(double x)
{
    if (!isfinite(x))
        return (bat_angle){0, {NAN, NAN}};
    const uint64_t bits = bat_bits_of(x);
    uint32_t f[WINDOW];
    fraction_of_turns((bits & 0xfffffffffffff) | 0x10000000000000,
                      (int)(bits >> 52 & 0x7ff) - 1075, f);
    /* The first eight bits are whole steps, and where the ninth is set one more less what is missing. */
    int steps = (int)(f[0] >> 24);
    const bool is_above = f[0] >> 23 & 1;
    for (int i = 0; i < WINDOW; i++) {
        f[i] = f[i] << 8 | (i + 1 < WINDOW ? f[i + 1] >> 24 : 0);
        if (is_above)
            f[i] = ~f[i];
    }
    const bat_twin share = value_of_words(f);
    const bat_twin d = bat_twin_product(share.high, BAT_WHOLE_TURN_1 / 256);
    const double low =
        d.low + (share.high * (BAT_WHOLE_TURN_2 / 256) + share.low * (BAT_WHOLE_TURN_1 / 256));
    const double sign = (x < 0) != is_above ? -1 : 1;
    steps += is_above;
    return (bat_angle){(x < 0 ? -steps : steps) & 255, bat_twin_sum(sign * d.high, sign * low)};
}
