/*
 * Writing numbers as text: integers, and doubles in the fewest digits that read back as the
 * same value.
 *
 * Every decimal strictly between the midpoints to the neighbours of x reads back as x, and the
 * midpoints do when the last bit of x is 0. With 10^k at most the distance of the midpoints,
 * some multiple of 10^k lies there; at most one multiple of 10^(k + 1) does, and if so it is
 * shorter. So all that is needed are the midpoints and x in units of 10^k. Source:
 * [Giulietti22].
 */
#include "base/digits.h"
#include "base/real.h"

#include <stdlib.h>
#include <string.h>

typedef enum { NOTHING, BELOW_HALF, HALF, ABOVE_HALF, UNCLEAR } rest_kind;

typedef struct {
    uint64_t whole;
    rest_kind rest;
} scaled;

/* t p with all its bits: (top 2^64 + bottom) 2^exponent. */
typedef struct {
    bat_wide top;
    uint64_t bottom;
} product;

static product multiply(bat_power p, uint64_t t)
{
    const bat_wide low = bat_wide_product(t, p.low), high = bat_wide_product(t, p.high);
    return (product){bat_wide_add(high, bat_wide_of(0, bat_wide_high(low))), bat_wide_low(low)};
}

static product add_products(product a, product b)
{
    const uint64_t bottom = a.bottom + b.bottom;
    const bat_wide carry = bat_wide_of(0, bottom < a.bottom);
    return (product){bat_wide_add(bat_wide_add(a.top, b.top), carry), bottom};
}

static product subtract(product a, product b)
{
    const bat_wide carry = bat_wide_of(0, a.bottom < b.bottom);
    return (product){bat_wide_subtract(bat_wide_subtract(a.top, b.top), carry),
                     a.bottom - b.bottom};
}

/* The product by 2^-shift, of which the caller knows that it is below 2^60. */
static inline scaled split(product t, int shift, bool exact)
{
    const bat_wide one = bat_wide_left(bat_wide_of(0, 1), shift), half = bat_wide_right(one, 1);
    const bat_wide part = bat_wide_rest(t.top, shift);
    const uint64_t whole = bat_wide_low(bat_wide_right(t.top, shift));
    const int order = bat_wide_compare(part, half);

    /* Not exact: the true part is above `part` by less than 2, one for each cut. */
    if (!exact || t.bottom != 0) {
        const bat_wide above = bat_wide_add(part, bat_wide_of(0, 2));
        if (bat_wide_is_zero(part) || bat_wide_compare(above, one) >= 0 ||
            (order <= 0 && bat_wide_compare(above, half) >= 0))
            return (scaled){whole, UNCLEAR};
    }
    if (bat_wide_is_zero(part))
        return (scaled){whole, NOTHING};
    return (scaled){whole, order < 0 ? BELOW_HALF : order == 0 ? HALF : ABOVE_HALF};
}

/* t 2^e / 10^k by long division, bit by bit. */
static scaled scale_long(uint64_t t, int e, int k)
{
    bat_big dividend, divisor;
    bat_big_set(&dividend, t);
    bat_big_scale(&dividend, -k, e);
    bat_big_set(&divisor, 1);
    bat_big_scale(&divisor, k, 60);
    bat_big_scale(&divisor, 0, -e);
    uint64_t whole = 0;
    for (int bit = 0; bit < 60; bit++) {
        bat_big_halve(&divisor);
        whole <<= 1;
        if (bat_big_compare(&dividend, &divisor) >= 0) {
            bat_big_subtract(&dividend, &divisor);
            whole |= 1;
        }
    }
    if (dividend.count == 0)
        return (scaled){whole, NOTHING};
    bat_big_multiply(&dividend, 2, 0);
    const int against_half = bat_big_compare(&dividend, &divisor);
    return (scaled){whole, against_half < 0    ? BELOW_HALF
                           : against_half == 0 ? HALF
                                               : ABOVE_HALF};
}

/* The product is that of t and 10^-k; t 2^e / 10^k is asked for. */
static inline scaled scale(product at, bat_power p, uint64_t t, int e, int k)
{
    const scaled fast = split(at, -(e + p.exponent) - 64, p.exact);
    return fast.rest == UNCLEAR ? scale_long(t, e, k) : fast;
}

/* Does the integer lie between the midpoints? */
static bool is_inside(uint64_t n, scaled low, scaled high, bool ends_belong)
{
    const bool above = n > low.whole || (ends_belong && n == low.whole && low.rest == NOTHING);
    const bool below =
        n < high.whole || (n == high.whole && (high.rest != NOTHING || ends_belong));
    return above && below;
}

/* The shortest digits of m 2^e, and the power of ten of the last of them. */
static uint64_t shortest(uint64_t m, int e, int *exponent)
{
    /* In quarters of the distance to the next double; that below a power of two is half as far.
     */
    const bool is_near_below = m == (uint64_t)1 << BAT_FRACTION_BITS && e > -1074;
    /* floor(log10) of the distance of the midpoints: 2^e, or 3/4 2^e. */
    const int k = (e * 1262611 - (is_near_below ? 524031 : 0)) >> 22;
    const bat_power p = bat_power_of_ten(-k);
    const uint64_t below = is_near_below ? 1 : 2;
    const product at = multiply(p, 4 * m), two = multiply(p, 2);
    const scaled low =
        scale(subtract(at, is_near_below ? multiply(p, 1) : two), p, 4 * m - below, e - 2, k);
    const scaled high = scale(add_products(at, two), p, 4 * m + 2, e - 2, k);
    const bool ends_belong = m % 2 == 0;

    *exponent = k;
    uint64_t ten = high.whole - high.whole % 10;
    if (ten == high.whole && !is_inside(ten, low, high, ends_belong))
        ten -= 10;
    if (is_inside(ten, low, high, ends_belong))
        return ten;

    const scaled x = scale(at, p, 4 * m, e - 2, k);
    const bool is_up = x.rest == ABOVE_HALF || (x.rest == HALF && x.whole % 2 == 1);
    const uint64_t nearest = x.whole + is_up;
    return is_inside(nearest, low, high, ends_belong) ? nearest : x.whole + !is_up;
}

static const char pairs[201] = "00010203040506070809101112131415161718192021222324"
                               "25262728293031323334353637383940414243444546474849"
                               "50515253545556575859606162636465666768697071727374"
                               "75767778798081828384858687888990919293949596979899";

/* Eight digits, also when the first are zeros. */
static inline void write_eight(char *to, uint32_t value)
{
    const uint32_t high = value / 10000, low = value % 10000;
    memcpy(to, &pairs[2 * (high / 100)], 2);
    memcpy(to + 2, &pairs[2 * (high % 100)], 2);
    memcpy(to + 4, &pairs[2 * (low / 100)], 2);
    memcpy(to + 6, &pairs[2 * (low % 100)], 2);
}

/* The digits of a value below 10^24, with none before them that is zero; *count of them. */
static const char *write_digits(char digits[24], uint64_t value, int *count)
{
    int first = 16;
    if (value < 10) {
        digits[23] = (char)('0' + value);
        *count = 1;
        return digits + 23;
    }
    write_eight(digits + 16, (uint32_t)(value % 100000000));
    if (value >= 100000000) {
        const uint64_t high = value / 100000000;
        write_eight(digits + 8, (uint32_t)(high % 100000000));
        first = 8;
        if (high >= 100000000) {
            write_eight(digits, (uint32_t)(high / 100000000));
            first = 0;
        }
    }
    while (digits[first] == '0')
        first++;
    *count = 24 - first;
    return digits + first;
}

/* Numbers are put together here, where there is room to copy more than is needed. */
enum { ROOM = 72, COPIED = 24 };

/* Digits d1 d2 ... dn stand for d1.d2...dn 10^exponent; from 1e-5 to below 1e17 they are
 * written without it. */
static char *write_plain(char *to, const char *digits, int count, int exponent)
{
    if (exponent < 0) {
        memcpy(to, "0.0000", 6);
        memcpy(to + 1 - exponent, digits, COPIED);
        return to + 1 - exponent + count;
    }
    if (count <= exponent + 1) {
        memcpy(to, digits, COPIED);
        memset(to + count, '0', COPIED);
        return to + exponent + 1;
    }
    memcpy(to, digits, COPIED);
    memcpy(to + exponent + 2, digits + exponent + 1, COPIED);
    to[exponent + 1] = '.';
    return to + count + 1;
}

static char *write_exponent(char *to, const char *digits, int count, int exponent, char letter)
{
    char place[24];
    int length;
    *to++ = digits[0];
    if (count > 1 || letter == 'E')
        *to++ = '.';
    memcpy(to, digits + 1, COPIED);
    to += count - 1;
    *to++ = letter;
    if (exponent < 0)
        *to++ = '-';
    const char *ten = write_digits(place, (uint64_t)abs(exponent), &length);
    memcpy(to, ten, (size_t)length);
    return to + length;
}

static char *write_positive(char *to, uint64_t bits, char letter)
{
    char space[24 + COPIED] = {0};
    uint64_t m;
    int e, exponent, count;
    bat_take_apart(bits, &m, &e);
    const uint64_t value = shortest(m, e, &exponent);
    const char *digits = write_digits(space, value, &count);
    exponent += count - 1;
    while (digits[count - 1] == '0')
        count--;
    if (exponent < -5 || exponent >= 17)
        return write_exponent(to, digits, count, exponent, letter);
    char *end = write_plain(to, digits, count, exponent);
    if (letter == 'E' && count <= exponent + 1)
        *end++ = '.';
    return end;
}

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

/* A number that is not whole, from 1e-5 to below 1e8, as most coordinates are: its end, or NULL
 * for others. Up to 24 characters of `to` are overwritten. */
static inline char *write_common(char *to, uint64_t bits)
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

/* Whole numbers below 2^53 are their digits: there is no other number as near to them. */
static char *write_whole(char *to, uint64_t value, char letter)
{
    char space[24 + COPIED] = {0};
    int count;
    const char *digits = write_digits(space, value, &count);
    memcpy(to, digits, COPIED);
    if (letter == 'E')
        to[count++] = '.';
    return to + count;
}

static char *write_finite(char *to, uint64_t bits, char letter)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    if (value < 9007199254740992.0) {
        const uint64_t whole = (uint64_t)value;
        if ((double)whole == value)
            return write_whole(to, whole, letter);
    }
    return write_positive(to, bits, letter);
}

/* What is neither common nor whole and small, also what is no number. */
static int write_other(uint64_t bits, char letter, char *text)
{
    char space[ROOM];
    char *to = space;
    const bool is_nan = (bits & ~BAT_SIGN_BIT) > BAT_INFINITE_BITS;
    if ((bits & BAT_SIGN_BIT) && !is_nan)
        *to++ = '-';
    bits &= ~BAT_SIGN_BIT;
    if (is_nan)
        to = (char *)memcpy(to, "nan", 3) + 3;
    else if (bits == BAT_INFINITE_BITS)
        to = (char *)memcpy(to, "inf", 3) + 3;
    else
        to = write_finite(to, bits, letter);
    *to = 0;
    memcpy(text, space, BATTEN_NUMBER_SIZE);
    return (int)(to - space);
}

/* With the letter 'e' as batten_number_write has it; with 'E' a '.' always stands there. */
static inline int write_number(double value, char letter, char *text)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    const bool is_negative = bits >> 63;
    const double size = fabs(value);
    const bool is_whole = size < 1e8 && (double)(int)size == size;
    char *end = text + is_negative;
    text[0] = '-';
    if (is_whole && size < 10) { /* weights and knots are often such */
        *end++ = (char)('0' + (int)size);
        *end = '.';
        end += letter == 'E';
    } else {
        end = is_whole ? NULL : write_common(end, bits & ~BAT_SIGN_BIT);
    }
    if (!end)
        return write_other(bits, letter, text);
    *end = 0;
    return (int)(end - text);
}

int batten_number_write(double value, char *text)
{
    return write_number(value, 'e', text);
}

int bat_real_write(double value, char *text)
{
    return write_number(value, 'E', text);
}

int bat_integer_write(int64_t value, char *text)
{
    char digits[24];
    char *to = text;
    int count;
    if (value < 0)
        *to++ = '-';
    const char *first =
        write_digits(digits, value < 0 ? 0 - (uint64_t)value : (uint64_t)value, &count);
    memcpy(to, first, (size_t)count);
    to[count] = 0;
    return (int)(to - text) + count;
}
