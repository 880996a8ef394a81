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
#include "base/number_common.h"
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
    /* Below 2^53 = 9007199254740992 a whole number has all its digits. */
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
        end = is_whole ? NULL : bat_number_write_common(end, bits & ~BAT_SIGN_BIT);
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
