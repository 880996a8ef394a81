/*
 * Reading numbers from text: doubles, correctly rounded, and whole numbers.
 *
 * The digits are multiplied by a power of ten, first known to 64 bits, then to 128, while the
 * error is kept track of; that decides nearly always. Where it leaves the answer open long
 * integers compute the same quantity.
 */
#include "base/decimal.h"
#include "base/digits.h"
#include "base/real.h"

#include <string.h>

/* ---- any number ---- */

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
static uint64_t rounded(bat_wide top, int e)
{
    const int last = bat_wide_high(top) >> 63 ? 127 : 126;
    const int exponent = e + last;
    const int shift = last - BAT_FRACTION_BITS + bat_max_int(0, -1022 - exponent);
    if (exponent > 1023)
        return BAT_INFINITE_BITS;
    if (shift > 128)
        return 0;
    uint64_t m = shift == 128 ? 0 : bat_wide_low(bat_wide_right(top, shift));
    const bat_wide rest = shift == 128 ? top : bat_wide_rest(top, shift);
    const int order = bat_wide_compare(rest, bat_wide_left(bat_wide_of(0, 1), shift - 1));
    m += order > 0 || (order == 0 && m % 2 == 1);
    /* The leading 1 of m adds one to the exponent, and so does a carry. */
    return (exponent < -1022 ? 0 : (uint64_t)(exponent + 1022) << BAT_FRACTION_BITS) + m;
}

/* All digits as an integer, at most DIGITS_KEPT and a 1 for others; its power of ten. */
static void all_digits(const decimal *d, bat_big *out, int *exponent)
{
    int count = 0;
    bool has_more = false;
    bat_big_set(out, 0);
    for (const char *c = d->digits; c < d->digits_end; c++) {
        if (*c == '.')
            continue;
        if (count < DIGITS_KEPT)
            bat_big_multiply(out, 10, (uint32_t)(*c - '0'));
        else
            has_more |= *c != '0';
        count++;
    }
    /* The first 19 digits, or all when there are fewer, end at last_exponent. */
    *exponent =
        (int)d->last_exponent + bat_min_int(count, 19) - bat_min_int(count, DIGITS_KEPT);
    if (has_more) {
        bat_big_multiply(out, 10, 1);
        --*exponent;
    }
}

/* The double at `bits` or the next, whichever is nearer. */
static uint64_t decide(const decimal *d, uint64_t bits)
{
    uint64_t m;
    int e, ten;
    bat_take_apart(bits, &m, &e);
    bat_big digits, midpoint;
    all_digits(d, &digits, &ten);
    bat_big_set(&midpoint, 2 * m + 1);
    bat_big_scale(&digits, ten, 1 - e);
    bat_big_scale(&midpoint, -ten, e - 1);
    const int order = bat_big_compare(&digits, &midpoint);
    return bits + (order > 0 || (order == 0 && m % 2 == 1));
}

static uint64_t to_double(const decimal *d)
{
    if (d->leading == 0 || d->last_exponent < BAT_LOWEST_POWER)
        return 0; /* below 10^19 10^-352, less than half of the least double */
    if (d->last_exponent > BAT_HIGHEST_POWER)
        return BAT_INFINITE_BITS;
    const bat_power p = bat_power_of_ten((int)d->last_exponent);
    const int shift = __builtin_clzll(d->leading);
    const uint64_t w = d->leading << shift;
    const bat_wide low = bat_wide_product(w, p.low);
    const bat_wide top =
        bat_wide_add(bat_wide_product(w, p.high), bat_wide_of(0, bat_wide_high(low)));
    const int e = p.exponent + 64 - shift;

    /* What the true product may be above `top`: a cut, 2 units of the power, one of the digits.
     */
    bat_wide above = bat_wide_of(0, p.exact && bat_wide_low(low) == 0 ? 0 : 3);
    if (d->has_more)
        above = bat_wide_add(above, bat_wide_of((uint64_t)2 << shift, 0));
    const uint64_t least = rounded(top, e);
    const bat_wide most = bat_wide_add(top, above);
    const bool is_carried = bat_wide_compare(most, top) < 0;
    return !is_carried && rounded(most, e) == least ? least : decide(d, least);
}

/* ---- reading quickly ---- */

const uint64_t bat_quick_powers[2 * BAT_QUICK_POWER + 1] = {
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

const uint64_t bat_small_tens[8] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000};

/* The digits among eight characters up to the first that is none, put behind those of the
 * value: how many. */
static inline int some_digits(const char *c, uint64_t *value)
{
    const uint64_t chunk = bat_eight_characters(c);
    /* Marks what is no digit; carries come from such bytes only, so the lowest is right. */
    const uint64_t digits = chunk - '0' * BAT_BYTES;
    const uint64_t others = ((chunk + 0x46 * BAT_BYTES) | digits) & 0x80 * BAT_BYTES;
    if (!others) {
        *value = 100000000 * *value + bat_eight_digits(digits);
        return 8;
    }
    const int bit = __builtin_ctzll(others); /* 7, 15 .. 63 */
    *value = bat_small_tens[bit >> 3] * *value + bat_eight_digits(digits << (63 - bit) << 8);
    return bit >> 3;
}

/* The digits from c on; beyond 19 the value means nothing. */
static const char *quick_digits(const char *c, const char *end, uint64_t *value)
{
    while (end - c >= 8) {
        const int count = some_digits(c, value);
        c += count;
        if (count < 8)
            return c;
    }
    for (; c < end && is_digit(*c); c++)
        *value = 10 * *value + (uint64_t)(*c - '0');
    return c;
}

/* With any places, and with an exponent. */
static const char *read_quickly(const char *c, const char *end, double *value)
{
    const bool is_negative = c < end && *c == '-';
    uint64_t w = 0, bits = 0;
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
    if (w != 0 && (exponent < -BAT_QUICK_POWER || exponent > BAT_QUICK_POWER ||
                   !bat_quick_double(w, (int)exponent, &bits)))
        return NULL;
    bits |= (uint64_t)is_negative << 63;
    memcpy(value, &bits, sizeof bits);
    return c;
}

/* What a number of at most 7 digits, a '.', at most 23 more and the character behind them take.
 */
enum { COMMON_ROOM = 40 };

/* Most numbers are such, and this is the shortest way to them: where the number ends, or NULL when it is of another
 * kind. */
static const char *read_common(const char *text, const char *end, double *value)
{
    if (end - text < COMMON_ROOM)
        return read_quickly(text, end, value);
    const bool is_negative = *text == '-';
    const char *c = text + is_negative;
    uint64_t w = 0, bits = 0;
    const int before = some_digits(c, &w);
    if (before == 0 || before == 8 || c[before] != '.')
        return read_quickly(text, end, value);
    c += before + 1;
    int places = some_digits(c, &w);
    if (places == 8)
        places += some_digits(c + 8, &w);
    if (places == 16)
        places += some_digits(c + 16, &w);
    c += places;
    if (before + places > 19 || *c == 'E' || *c == 'e' ||
        (w != 0 && !bat_quick_double(w, -places, &bits)))
        return read_quickly(text, end, value);
    bits |= (uint64_t)is_negative << 63;
    memcpy(value, &bits, sizeof bits);
    return c;
}

batten_status batten_number_read(const char *text, size_t length, double *value, size_t *used)
{
    char shown[BAT_SHOWN_SIZE];
    decimal d;
    double quick;
    const char *end = read_common(text, text + length, &quick);
    if (end && (used || end == text + length)) {
        *value = quick;
        if (used)
            *used = (size_t)(end - text);
        return BATTEN_OK;
    }
    end = read_decimal(text, text + length, &d);
    if (!end || (!used && end != text + length))
        return bat_fail(BATTEN_BAD_FORMAT, "'%s' is not a number",
                        bat_shown(text, length, shown));
    uint64_t bits = to_double(&d);
    if (bits == BAT_INFINITE_BITS)
        return bat_fail(BATTEN_OVERFLOW, "the number %s is too large for a double",
                        bat_shown(text, (size_t)(end - text), shown));
    if (d.is_negative)
        bits |= BAT_SIGN_BIT;
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
