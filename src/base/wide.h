/*
 * Whole numbers of 128 bits without a sign: those of the compiler where it has them, two words elsewhere. Sums and
 * differences wrap around. BAT_WIDE_BY_WORDS asks for the two words anyway; tests compare both.
 */
#ifndef BAT_WIDE_H
#define BAT_WIDE_H
#if defined(__SIZEOF_INT128__) && !defined(BAT_WIDE_BY_WORDS)
#include "base/wide_native.h"
#else
#include "base/wide_words.h"
#endif
#include <stdbool.h>

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
