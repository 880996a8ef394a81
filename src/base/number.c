#include "base/base.h"
#include "base/real.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/*
 * Both directions multiply by a power of ten known to 128 bits, keep track of the error, and
 * decide from that in nearly all cases. Where the error leaves the answer open they compute the
 * same quantity with long integers.
 */

__extension__ typedef unsigned __int128 wide;

/* ---- powers of ten ---- */

/* 10^(27 j) for j = -13 .. 12, its first 192 bits, the first of them 1, cut off. */
static const uint64_t coarse[26][3] = {
    {0x8049a4ac0c5811aeu, 0x205b896d777d6278u, 0xac261e9f5141430bu}, /* 1e-351 */
    {0xcf42894a5dce35eau, 0x52064cac828675b9u, 0x475f2b7d7df1ad7au}, /* 1e-324 */
    {0xa76c582338ed2621u, 0xaf2af2b80af6f24eu, 0x657c8f4d43323a36u}, /* 1e-297 */
    {0x873e4f75e2224e68u, 0x5a7744a6e804a291u, 0xcc35eddfcf0996d7u}, /* 1e-270 */
    {0xda7f5bf590966848u, 0xaf39a475506a899eu, 0xa30294cc2934e662u}, /* 1e-243 */
    {0xb080392cc4349decu, 0xbd8d794d96aacfb3u, 0xfe13a5c86af64418u}, /* 1e-216 */
    {0x8e938662882af53eu, 0x547eb47b7282ee9cu, 0x41b0230e1421487du}, /* 1e-189 */
    {0xe65829b3046b0afau, 0x0cb4a5a3112a5112u, 0xa3b561b1cb208396u}, /* 1e-162 */
    {0xba121a4650e4ddebu, 0x92f34d62616ce413u, 0x21a0183e10583cd3u}, /* 1e-135 */
    {0x964e858c91ba2655u, 0x3a6a07f8d510f86fu, 0xe9082f25e9c5e9ecu}, /* 1e-108 */
    {0xf2d56790ab41c2a2u, 0xfae27299423fb9c3u, 0x3695dad7e8858901u}, /* 1e-81 */
    {0xc428d05aa4751e4cu, 0xaa97e14c3c26b886u, 0x96842dc95323f5a8u}, /* 1e-54 */
    {0x9e74d1b791e07e48u, 0x775ea264cf55347du, 0xca49f1c05120c9c7u}, /* 1e-27 */
    {0x8000000000000000u, 0x0000000000000000u, 0x0000000000000000u}, /* 1e0 */
    {0xcecb8f27f4200f3au, 0x0000000000000000u, 0x0000000000000000u}, /* 1e27 */
    {0xa70c3c40a64e6c51u, 0x999090b65f67d924u, 0x0000000000000000u}, /* 1e54 */
    {0x86f0ac99b4e8dafdu, 0x69a028bb3ded71a3u, 0xdf9f915627c04e28u}, /* 1e81 */
    {0xda01ee641a708de9u, 0xe80e6f4820cc9495u, 0xd74baad03bc1d8d3u}, /* 1e108 */
    {0xb01ae745b101e9e4u, 0x5ec05dcff72e7f8fu, 0xc04c79ffe324301fu}, /* 1e135 */
    {0x8e41ade9fbebc27du, 0x14588f13be847307u, 0x23bd6a2059c002f5u}, /* 1e162 */
    {0xe5d3ef282a242e81u, 0x8f1668c8a86da5fau, 0xf0b5ccf5176ecc7cu}, /* 1e189 */
    {0xb9a74a0637ce2ee1u, 0x6d953e2bd7173692u, 0x88efb0037ac08bdeu}, /* 1e216 */
    {0x95f83d0a1fb69cd9u, 0x4abdaf101564f98eu, 0x0d5a4af7b3a98e47u}, /* 1e243 */
    {0xf24a01a73cf2dccfu, 0xbc633b39673c8cecu, 0x3d9c44cd2f36917cu}, /* 1e270 */
    {0xc3b8358109e84f07u, 0x0a862f80ec4700c8u, 0x02606ea01029dc37u}, /* 1e297 */
    {0x9e19db92b4e31ba9u, 0x6c07a2c26a8346d1u, 0x4944d9f52cd0dec2u}, /* 1e324 */
};
#define COARSE_FIRST (-13)

/* The first 128 bits of 10^k, the first of them 1; the true value is above it by at most 2
 * units of the last. */
typedef struct {
    uint64_t high, low;
    int exponent; /* 10^k = (high 2^64 + low) 2^exponent */
    bool exact;
} power;

#define LOWEST_POWER (27 * COARSE_FIRST)
#define HIGHEST_POWER (27 * 13 - 1)

static int floor_log2_of_power(int k)
{
    return (k * 217706) >> 16; /* log2 10 = 3.32193; right for |k| <= 400 */
}

/* A 255-bit product of 10^(27 j) and 5^i, i < 27; the cut of the first factor stays below 2^-64
 * of a unit. */
static power power_of_ten(int k)
{
    assert(k >= LOWEST_POWER && k <= HIGHEST_POWER);
    const int j = (k - LOWEST_POWER) / 27, i = (k - LOWEST_POWER) % 27;
    static const uint64_t fives[27] = {1u,
                                       5u,
                                       25u,
                                       125u,
                                       625u,
                                       3125u,
                                       15625u,
                                       78125u,
                                       390625u,
                                       1953125u,
                                       9765625u,
                                       48828125u,
                                       244140625u,
                                       1220703125u,
                                       6103515625u,
                                       30517578125u,
                                       152587890625u,
                                       762939453125u,
                                       3814697265625u,
                                       19073486328125u,
                                       95367431640625u,
                                       476837158203125u,
                                       2384185791015625u,
                                       11920928955078125u,
                                       59604644775390625u,
                                       298023223876953125u,
                                       1490116119384765625u};
    const uint64_t five = fives[i];
    const wide low = (wide)coarse[j][2] * five;
    const wide middle = (wide)coarse[j][1] * five + (uint64_t)(low >> 64);
    const wide high = (wide)coarse[j][0] * five + (uint64_t)(middle >> 64);
    const int shift =
        __builtin_clzll((uint64_t)(high >> 64 ? high >> 64 : high)) + (high >> 64 ? 0 : 64);
    const wide top = high << shift | (uint64_t)middle >> (64 - shift); /* 1 <= shift <= 64 */
    return (power){(uint64_t)(top >> 64), (uint64_t)top, floor_log2_of_power(k) - 127,
                   k >= 0 && k <= 55}; /* 5^55 < 2^128 */
}

/* ---- long integers, for what 128 bits leave open ---- */

/* 801 digits times 2^1075, and 10^1125 times 54 bits, have fewer than 3800 bits. */
typedef struct {
    int count; /* words in use; the highest is not 0 */
    uint32_t words[128];
} big;

static void big_set(big *b, uint64_t value)
{
    b->count = 0;
    for (; value; value >>= 32)
        b->words[b->count++] = (uint32_t)value;
}

/* b = b * factor + more */
static void big_multiply(big *b, uint32_t factor, uint32_t more)
{
    uint64_t carry = more;
    for (int i = 0; i < b->count; i++) {
        carry += (uint64_t)b->words[i] * factor;
        b->words[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry) {
        assert(b->count < 128);
        b->words[b->count++] = (uint32_t)carry;
    }
}

/* b = b * 10^ten * 2^two; what is negative is left out. */
static void big_scale(big *b, int ten, int two)
{
    for (; ten >= 9; ten -= 9)
        big_multiply(b, 1000000000, 0);
    for (; ten > 0; ten--)
        big_multiply(b, 10, 0);
    for (; two >= 31; two -= 31)
        big_multiply(b, (uint32_t)1 << 31, 0);
    if (two > 0)
        big_multiply(b, (uint32_t)1 << two, 0);
}

static int big_compare(const big *a, const big *b)
{
    if (a->count != b->count)
        return a->count < b->count ? -1 : 1;
    for (int i = a->count - 1; i >= 0; i--)
        if (a->words[i] != b->words[i])
            return a->words[i] < b->words[i] ? -1 : 1;
    return 0;
}

static void big_trim(big *b)
{
    while (b->count > 0 && b->words[b->count - 1] == 0)
        b->count--;
}

/* a = a - b, where a >= b */
static void big_subtract(big *a, const big *b)
{
    int64_t carry = 0;
    for (int i = 0; i < a->count; i++) {
        carry += (int64_t)a->words[i] - (i < b->count ? b->words[i] : 0);
        a->words[i] = (uint32_t)carry;
        carry = carry < 0 ? -1 : 0;
    }
    big_trim(a);
}

static void big_halve(big *b)
{
    for (int i = 0; i < b->count; i++) {
        const uint32_t above = i + 1 < b->count ? b->words[i + 1] : 0;
        b->words[i] = b->words[i] >> 1 | above << 31;
    }
    big_trim(b);
}

/* ---- doubles taken apart ---- */

#define FRACTION_BITS 52
#define INFINITE_BITS ((uint64_t)0x7ff << FRACTION_BITS)
#define SIGN_BIT ((uint64_t)1 << 63)

/* A positive double is m 2^e. */
static void take_apart(uint64_t bits, uint64_t *m, int *e)
{
    const int biased = (int)(bits >> FRACTION_BITS);
    *m = bits & (((uint64_t)1 << FRACTION_BITS) - 1);
    *e = -1074;
    if (biased > 0) {
        *m |= (uint64_t)1 << FRACTION_BITS;
        *e = biased - 1075;
    }
}

/* ---- writing ---- */

/*
 * Every decimal strictly between the midpoints to the neighbours of x reads back as x, and the
 * midpoints do when the last bit of x is 0. With 10^k at most the distance of the midpoints,
 * some multiple of 10^k lies there; at most one multiple of 10^(k + 1) does, and if so it is
 * shorter. So all that is needed are the midpoints and x in units of 10^k. Source:
 * [Giulietti22].
 */

typedef enum { NOTHING, BELOW_HALF, HALF, ABOVE_HALF, UNCLEAR } rest_kind;

typedef struct {
    uint64_t whole;
    rest_kind rest;
} scaled;

/* t p with all its bits: (top 2^64 + bottom) 2^exponent. */
typedef struct {
    wide top;
    uint64_t bottom;
} product;

static product multiply(power p, uint64_t t)
{
    const wide low = (wide)t * p.low;
    return (product){(wide)t * p.high + (uint64_t)(low >> 64), (uint64_t)low};
}

static product add(product a, product b)
{
    const uint64_t bottom = a.bottom + b.bottom;
    return (product){a.top + b.top + (bottom < a.bottom), bottom};
}

static product subtract(product a, product b)
{
    return (product){a.top - b.top - (a.bottom < b.bottom), a.bottom - b.bottom};
}

/* The product by 2^-shift, of which the caller knows that it is below 2^60. */
static inline scaled split(product t, int shift, bool exact)
{
    const wide one = (wide)1 << shift, half = one >> 1, part = t.top & (one - 1);
    const uint64_t whole = (uint64_t)(t.top >> shift);

    /* Not exact: the true part is above `part` by less than 2, one for each cut. */
    if (!exact || t.bottom != 0) {
        if (part == 0 || part + 2 >= one || (part <= half && part + 2 >= half))
            return (scaled){whole, UNCLEAR};
    }
    if (part == 0)
        return (scaled){whole, NOTHING};
    return (scaled){whole, part < half ? BELOW_HALF : part == half ? HALF : ABOVE_HALF};
}

/* t 2^e / 10^k by long division, bit by bit. */
static scaled scale_long(uint64_t t, int e, int k)
{
    big dividend, divisor;
    big_set(&dividend, t);
    big_scale(&dividend, -k, e);
    big_set(&divisor, 1);
    big_scale(&divisor, k, 60);
    big_scale(&divisor, 0, -e);
    uint64_t whole = 0;
    for (int bit = 0; bit < 60; bit++) {
        big_halve(&divisor);
        whole <<= 1;
        if (big_compare(&dividend, &divisor) >= 0) {
            big_subtract(&dividend, &divisor);
            whole |= 1;
        }
    }
    if (dividend.count == 0)
        return (scaled){whole, NOTHING};
    big_multiply(&dividend, 2, 0);
    const int against_half = big_compare(&dividend, &divisor);
    return (scaled){whole, against_half < 0    ? BELOW_HALF
                           : against_half == 0 ? HALF
                                               : ABOVE_HALF};
}

/* The product is that of t and 10^-k; t 2^e / 10^k is asked for. */
static inline scaled scale(product at, power p, uint64_t t, int e, int k)
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
    const bool is_near_below = m == (uint64_t)1 << FRACTION_BITS && e > -1074;
    /* floor(log10) of the distance of the midpoints: 2^e, or 3/4 2^e. */
    const int k = (e * 1262611 - (is_near_below ? 524031 : 0)) >> 22;
    const power p = power_of_ten(-k);
    const uint64_t below = is_near_below ? 1 : 2;
    const product at = multiply(p, 4 * m), two = multiply(p, 2);
    const scaled low =
        scale(subtract(at, is_near_below ? multiply(p, 1) : two), p, 4 * m - below, e - 2, k);
    const scaled high = scale(add(at, two), p, 4 * m + 2, e - 2, k);
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
    take_apart(bits, &m, &e);
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
    if (value < 9007199254740992.0) {
        const uint64_t whole = (uint64_t)value;
        if ((double)whole == value)
            return write_whole(to, whole, letter);
    }
    return write_positive(to, bits, letter);
}

/* With the letter 'e' as batten_number_write has it; with 'E' a '.' always stands there. */
static int write_number(double value, char letter, char *text)
{
    char space[ROOM];
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    char *to = space;
    if ((bits & SIGN_BIT) && !isnan(value))
        *to++ = '-';
    bits &= ~SIGN_BIT;
    if (bits > INFINITE_BITS)
        to = (char *)memcpy(to, "nan", 3) + 3;
    else if (bits == INFINITE_BITS)
        to = (char *)memcpy(to, "inf", 3) + 3;
    else
        to = write_finite(to, bits, letter);
    *to = 0;
    memcpy(text, space, BATTEN_NUMBER_SIZE);
    return (int)(to - space);
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

/* ---- reading ---- */

/* Digits kept for long integers: no midpoint of two doubles has more than 767, so a last 1 may
 * stand for all that follow. */
#define DIGITS_KEPT 800

/* A number as it stands in a text. */
typedef struct {
    bool is_negative;
    const char *digits, *digits_end; /* with a '.' among them, from the first that is not 0 */
    int64_t exponent;                /* of the digit before the '.' or the end */
    int64_t last_exponent;           /* of the last digit of `leading` */
    uint64_t leading;                /* the first 19 digits */
    bool has_more;                   /* others follow that are not 0 */
} decimal;

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Read [sign] digits behind an 'e', if there are any; beyond 10^15 it makes no difference. */
static const char *read_exponent(const char *text, const char *end, int64_t *exponent)
{
    const char *c = text + 1;
    bool is_negative = false;
    if (c < end && (*c == '+' || *c == '-'))
        is_negative = *c++ == '-';
    if (c == end || !is_digit(*c))
        return text;
    int64_t value = 0;
    for (; c < end && is_digit(*c); c++)
        if (value < 1000000000000000)
            value = 10 * value + (*c - '0');
    *exponent = is_negative ? -value : value;
    return c;
}

/* The digits from the first that is not 0 on: up to 19 of them as an integer. `point_place`
 * counts the digits before the '.'. */
static const char *read_digits(const char *c, const char *end, decimal *d, int64_t *point_place,
                               bool *any)
{
    int64_t place = 0, kept = 0;
    const char *point = NULL;
    for (; c < end && (is_digit(*c) || (*c == '.' && !point)); c++) {
        if (*c == '.') {
            point = c;
            *point_place = place;
            continue;
        }
        *any = true;
        if (*c == '0' && kept == 0) {
            place++;
            continue;
        }
        if (kept == 0)
            d->digits = c;
        if (kept < 19) {
            d->leading = 10 * d->leading + (uint64_t)(*c - '0');
            d->last_exponent = -place;
        } else if (*c != '0') {
            d->has_more = true;
        }
        kept++;
        place++;
    }
    if (!point)
        *point_place = place;
    d->digits_end = c;
    return c;
}

/* NULL when no number stands there, else its end. */
static const char *read_decimal(const char *text, const char *end, decimal *d)
{
    *d = (decimal){.digits = text};
    const char *c = text;
    if (c < end && (*c == '+' || *c == '-'))
        d->is_negative = *c++ == '-';
    int64_t point_place = 0, exponent = 0;
    bool any = false;
    c = read_digits(c, end, d, &point_place, &any);
    if (!any)
        return NULL;
    if (c < end && (*c == 'e' || *c == 'E'))
        c = read_exponent(c, end, &exponent);
    d->exponent = exponent;
    d->last_exponent += exponent + point_place - 1;
    return c;
}

/* top 2^e, rounded to a double, ties to even. top has at least 126 bits. */
static uint64_t rounded(wide top, int e)
{
    const int last = top >> 127 ? 127 : 126;
    const int exponent = e + last;
    const int shift = last - FRACTION_BITS + bat_max_int(0, -1022 - exponent);
    if (exponent > 1023)
        return INFINITE_BITS;
    if (shift > 128)
        return 0;
    uint64_t m = shift == 128 ? 0 : (uint64_t)(top >> shift);
    const wide rest = shift == 128 ? top : top & (((wide)1 << shift) - 1);
    const wide half = (wide)1 << (shift - 1);
    m += rest > half || (rest == half && m % 2 == 1);
    /* The leading 1 of m adds one to the exponent, and so does a carry. */
    return (exponent < -1022 ? 0 : (uint64_t)(exponent + 1022) << FRACTION_BITS) + m;
}

/* All digits as an integer, at most DIGITS_KEPT and a 1 for others; its power of ten. */
static void all_digits(const decimal *d, big *out, int *exponent)
{
    int count = 0;
    bool has_more = false;
    big_set(out, 0);
    for (const char *c = d->digits; c < d->digits_end; c++) {
        if (*c == '.')
            continue;
        if (count < DIGITS_KEPT)
            big_multiply(out, 10, (uint32_t)(*c - '0'));
        else
            has_more |= *c != '0';
        count++;
    }
    /* The first 19 digits, or all when there are fewer, end at last_exponent. */
    *exponent =
        (int)d->last_exponent + bat_min_int(count, 19) - bat_min_int(count, DIGITS_KEPT);
    if (has_more) {
        big_multiply(out, 10, 1);
        --*exponent;
    }
}

/* The double at `bits` or the next, whichever is nearer. */
static uint64_t decide(const decimal *d, uint64_t bits)
{
    uint64_t m;
    int e, ten;
    take_apart(bits, &m, &e);
    big digits, midpoint;
    all_digits(d, &digits, &ten);
    big_set(&midpoint, 2 * m + 1);
    big_scale(&digits, ten, 1 - e);
    big_scale(&midpoint, -ten, e - 1);
    const int order = big_compare(&digits, &midpoint);
    return bits + (order > 0 || (order == 0 && m % 2 == 1));
}

static uint64_t to_double(const decimal *d)
{
    if (d->leading == 0 || d->last_exponent < LOWEST_POWER)
        return 0; /* below 10^19 10^-352, less than half of the least double */
    if (d->last_exponent > HIGHEST_POWER)
        return INFINITE_BITS;
    const power p = power_of_ten((int)d->last_exponent);
    const int shift = __builtin_clzll(d->leading);
    const uint64_t w = d->leading << shift;
    const wide low = (wide)w * p.low;
    const wide top = (wide)w * p.high + (uint64_t)(low >> 64);
    const int e = p.exponent + 64 - shift;

    /* What the true product may be above `top`: a cut, 2 units of the power, one of the digits.
     */
    wide above = p.exact && (uint64_t)low == 0 ? 0 : 3;
    if (d->has_more)
        above += (wide)2 << (64 + shift);
    const uint64_t least = rounded(top, e);
    const bool is_carried = top + above < top;
    return !is_carried && rounded(top + above, e) == least ? least : decide(d, least);
}

/* ---- reading quickly ---- */

/*
 * Nearly all numbers of files have at most 19 digits and a small exponent. For them 64 bits of
 * the power of ten say enough, but where what is cut off may lie on either side of the middle
 * between two doubles; those few, and all others, go the long way. Source: [Lemire21].
 */
enum { QUICK_POWER = 27 };

/* The first 64 bits of 10^k, k = -27 .. 27, cut off. */
static const uint64_t quick_powers[2 * QUICK_POWER + 1] = {
    0x9e74d1b791e07e48u, 0xc612062576589ddau, 0xf79687aed3eec551u, 0x9abe14cd44753b52u,
    0xc16d9a0095928a27u, 0xf1c90080baf72cb1u, 0x971da05074da7beeu, 0xbce5086492111aeau,
    0xec1e4a7db69561a5u, 0x9392ee8e921d5d07u, 0xb877aa3236a4b449u, 0xe69594bec44de15bu,
    0x901d7cf73ab0acd9u, 0xb424dc35095cd80fu, 0xe12e13424bb40e13u, 0x8cbccc096f5088cbu,
    0xafebff0bcb24aafeu, 0xdbe6fecebdedd5beu, 0x89705f4136b4a597u, 0xabcc77118461cefcu,
    0xd6bf94d5e57a42bcu, 0x8637bd05af6c69b5u, 0xa7c5ac471b478423u, 0xd1b71758e219652bu,
    0x83126e978d4fdf3bu, 0xa3d70a3d70a3d70au, 0xccccccccccccccccu, 0x8000000000000000u,
    0xa000000000000000u, 0xc800000000000000u, 0xfa00000000000000u, 0x9c40000000000000u,
    0xc350000000000000u, 0xf424000000000000u, 0x9896800000000000u, 0xbebc200000000000u,
    0xee6b280000000000u, 0x9502f90000000000u, 0xba43b74000000000u, 0xe8d4a51000000000u,
    0x9184e72a00000000u, 0xb5e620f480000000u, 0xe35fa931a0000000u, 0x8e1bc9bf04000000u,
    0xb1a2bc2ec5000000u, 0xde0b6b3a76400000u, 0x8ac7230489e80000u, 0xad78ebc5ac620000u,
    0xd8d726b7177a8000u, 0x878678326eac9000u, 0xa968163f0a57b400u, 0xd3c21bcecceda100u,
    0x84595161401484a0u, 0xa56fa5b99019a5c8u, 0xcecb8f27f4200f3au,
};

/* Eight characters, the first of them the least byte, as a number when all are digits. */
static bool eight_digits(const char *text, uint64_t *value)
{
    uint64_t chunk;
    memcpy(&chunk, text, sizeof chunk);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    chunk = __builtin_bswap64(chunk);
#endif
    const uint64_t above = chunk + 0x4646464646464646u, below = chunk - 0x3030303030303030u;
    if ((above | below) & 0x8080808080808080u)
        return false;
    /* Pairs, then fours, then all eight. */
    chunk = below * 10 + (below >> 8);
    chunk = ((chunk & 0x000000ff000000ffu) * 0x000f424000000064u +
             ((chunk >> 16) & 0x000000ff000000ffu) * 0x0000271000000001u) >>
            32;
    *value = chunk;
    return true;
}

/* Four of them. */
static bool four_digits(const char *text, uint64_t *value)
{
    uint32_t chunk;
    memcpy(&chunk, text, sizeof chunk);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    chunk = __builtin_bswap32(chunk);
#endif
    const uint32_t above = chunk + 0x46464646u, below = chunk - 0x30303030u;
    if ((above | below) & 0x80808080u)
        return false;
    chunk = below * 10 + (below >> 8);
    *value = (chunk & 0xff) * 100 + (chunk >> 16 & 0xff);
    return true;
}

static const char *quick_digits(const char *c, const char *end, uint64_t *value)
{
    uint64_t some;
    while (end - c >= 8 && eight_digits(c, &some)) {
        *value = 100000000 * *value + some;
        c += 8;
    }
    if (end - c >= 4 && four_digits(c, &some)) {
        *value = 10000 * *value + some;
        c += 4;
    }
    for (; c < end && is_digit(*c); c++)
        *value = 10 * *value + (uint64_t)(*c - '0');
    return c;
}

/* w 10^k as a double; false when 64 bits leave it open. */
static bool quick_double(uint64_t w, int k, uint64_t *bits)
{
    const int shift = __builtin_clzll(w);
    const uint64_t high =
        (uint64_t)(((wide)(w << shift) * quick_powers[k + QUICK_POWER]) >> 64);
    /* The true product is above `high` by less than 2. */
    const int short_of = !(high >> 63), drop = 11 - short_of;
    const uint64_t rest = high & (((uint64_t)1 << drop) - 1), half = (uint64_t)1 << (drop - 1);
    if (rest == half || rest == half - 1)
        return false;
    const int exponent = 64 - short_of - shift + floor_log2_of_power(k);
    *bits = ((uint64_t)(exponent + 1022) << FRACTION_BITS) + (high >> drop) + (rest > half);
    return true;
}

/* The end of the number, or NULL when it has to go the long way. */
static const char *read_quickly(const char *c, const char *end, uint64_t *bits)
{
    const bool is_negative = c < end && *c == '-';
    uint64_t w = 0;
    int64_t exponent = 0, places = 0;
    c += is_negative;
    if (c == end || !is_digit(*c))
        return NULL;
    while (c < end && *c == '0')
        c++;
    const char *begin = c;
    c = quick_digits(c, end, &w);
    int64_t digits = c - begin;
    if (c < end && *c == '.') {
        const char *point = ++c;
        while (digits == 0 && c < end && *c == '0')
            c++;
        begin = c;
        c = quick_digits(c, end, &w);
        digits += c - begin;
        places = c - point;
    }
    if (digits > 19)
        return NULL;
    if (c < end && (*c == 'e' || *c == 'E'))
        c = read_exponent(c, end, &exponent);
    exponent -= places;
    if (w == 0)
        *bits = 0;
    else if (exponent < -QUICK_POWER || exponent > QUICK_POWER ||
             !quick_double(w, (int)exponent, bits))
        return NULL;
    if (is_negative)
        *bits |= SIGN_BIT;
    return c;
}

batten_status batten_number_read(const char *text, size_t length, double *value, size_t *used)
{
    char shown[BAT_SHOWN_SIZE];
    decimal d;
    uint64_t quick;
    const char *end = read_quickly(text, text + length, &quick);
    if (end && (used || end == text + length)) {
        memcpy(value, &quick, sizeof quick);
        if (used)
            *used = (size_t)(end - text);
        return BATTEN_OK;
    }
    end = read_decimal(text, text + length, &d);
    if (!end || (!used && end != text + length))
        return bat_fail(BATTEN_BAD_FORMAT, "'%s' is not a number",
                        bat_shown(text, length, shown));
    uint64_t bits = to_double(&d);
    if (bits == INFINITE_BITS)
        return bat_fail(BATTEN_OVERFLOW, "the number %s is too large for a double",
                        bat_shown(text, (size_t)(end - text), shown));
    if (d.is_negative)
        bits |= SIGN_BIT;
    memcpy(value, &bits, sizeof bits);
    if (used)
        *used = (size_t)(end - text);
    return BATTEN_OK;
}

/* ---- whole numbers ---- */

batten_status batten_integer_read(const char *text, size_t length, int64_t low, int64_t high,
                                  int64_t *value, size_t *used)
{
    char shown[BAT_SHOWN_SIZE];
    const bool is_signed = length > 0 && (text[0] == '+' || text[0] == '-');
    const bool is_negative = is_signed && text[0] == '-';
    size_t i = is_signed;
    int64_t sum = 0;
    bool is_large = false;
    for (; i < length && is_digit(text[i]); i++) {
        const int64_t digit = text[i] - '0';
        is_large |= __builtin_mul_overflow(sum, (int64_t)10, &sum);
        is_large |= is_negative ? __builtin_sub_overflow(sum, digit, &sum)
                                : __builtin_add_overflow(sum, digit, &sum);
    }
    if (i == (size_t)is_signed || (!used && i < length))
        return bat_fail(BATTEN_BAD_FORMAT, "'%s' is not a whole number",
                        bat_shown(text, length, shown));
    if (is_large || sum < low || sum > high)
        return bat_fail(BATTEN_OVERFLOW, "the number %s is outside %lld .. %lld",
                        bat_shown(text, i, shown), (long long)low, (long long)high);
    *value = sum;
    if (used)
        *used = i;
    return BATTEN_OK;
}
