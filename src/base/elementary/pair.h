/*
 * Numbers of twice the digits for the elementary functions: sums of two doubles, of which the second is at most a few
 * units of the last place of the first. Without fused multiply-add, so that the same bits come from every processor.
 * Source: [Dekker71].
 */
#ifndef BAT_ELEMENTARY_PAIR_H
#define BAT_ELEMENTARY_PAIR_H
#include <stdint.h>
#include <string.h>

typedef struct {
    double high, low;
} bat_twin;

static inline uint64_t bat_bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double bat_of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* 2^n, -1022 <= n <= 1023. */
static inline double bat_power_of_two(int n)
{
    return bat_of_bits((uint64_t)(n + 1023) << 52);
}

/* The first 26 bits of a: the products of two such are exact. */
static inline double bat_first_half(double a)
{
    return bat_of_bits(bat_bits_of(a) & ~(uint64_t)0x7ffffff);
}

/* a + b exactly, |a| >= |b| or a = 0. */
static inline bat_twin bat_twin_sum(double a, double b)
{
    const double high = a + b;
    return (bat_twin){high, b - (high - a)};
}

/* a + b exactly. */
static inline bat_twin bat_twin_any_sum(double a, double b)
{
    const double high = a + b, part = high - a;
    return (bat_twin){high, (a - (high - part)) + (b - part)};
}

/* a b to 106 bits; the halves' products neither overflow nor fall below 2^-1022. */
static inline bat_twin bat_twin_product(double a, double b)
{
    const double high = a * b, a1 = bat_first_half(a), a2 = a - a1, b1 = bat_first_half(b),
                 b2 = b - b1;
    return (bat_twin){high, ((a1 * b1 - high) + (a1 * b2 + a2 * b1)) + a2 * b2};
}

/* a^2 to 106 bits. */
static inline bat_twin bat_twin_square(double a)
{
    const double high = a * a, a1 = bat_first_half(a), a2 = a - a1;
    return (bat_twin){high, (a1 * a1 - high) + a2 * (a + a1)};
}

/* a / b to about 78 bits, 1/b being given to 40: the first part has 26, and the second is no longer below its last place.
 * The second parts of a and b may be as large as 2^-13 of the first. */
static inline bat_twin bat_twin_quotient(bat_twin a, bat_twin b, double inverse)
{
    const double first = bat_first_half(a.high * inverse), b1 = bat_first_half(b.high),
                 b2 = (b.high - b1) + b.low;
    return (bat_twin){first, ((a.high - first * b1) + (a.low - first * b2)) * inverse};
}

/* The twin times 2^n, rounded once, also where the result is below 2^-1022. 1/2 < |x| < 4. */
double bat_twin_scaled(bat_twin x, int n);

#endif
