/*
 * Arc sine and cosine: near 0 by the series, up to 1/2 by the series about the nearest 256th, and beyond by
 * acos(x) = 2 asin(sqrt((1 - x) / 2)).
 */
#include "base/elementary.h"
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

#include <math.h>

/* The table begins here, in 256ths. */
enum { FIRST_ARC = 24 };

/* Below, the series about 0 serves; above, the nearest 256th stands in the table. */
static const double series_end = 0.0922;

/* 1 - 2 x^2 of it: asked of the argument itself, long before the root is known. */
static const double half_series_begin = 0.983;

/* The sum of four: |step| is at most 1/48 of what begins, or 0, and the others are smaller. */
typedef struct {
    double begin, step, linear, curved;
} arc;

/* asin(x) by its odd series for |x| < 0.0922: what is left out is below 2^-61 of it. */
static inline arc small_arc_sine(double x)
{
    const double s = x * x, s2 = s * s;
    /* The factor of x^(2 k + 1) is (2 k)! / (4^k k!^2 (2 k + 1)). */
    const double end = (63.0 / 2816 + s * (231.0 / 13312)) + s2 * (143.0 / 10240);
    const double tail =
        ((1.0 / 6 + s * (3.0 / 40)) + s2 * (5.0 / 112 + s * (35.0 / 1152))) + s2 * s2 * end;
    return (arc){x, 0, 0, x * s * tail};
}

/* The 256th that is nearest to x, 0 <= x <= 1/2, and its number. */
static inline double nearest_part(double x, int *j)
{
    /* Added and taken away it rounds to a 256th, whose number is in the last bits of the sum. */
    const double round = 0x1.8p44, shifted = x + round;
    *j = (int)(bat_bits_of(shifted) & 255);
    return shifted - round;
}

/* asin(c + d) for the c of an entry. */
static inline arc table_arc_sine(const double *entry, double d)
{
    const double d2 = d * d, end = (entry[5] + d * entry[6]) + d2 * entry[7];
    return (arc){entry[0], d, entry[1] + d * entry[2],
                 d2 * (entry[3] + d * entry[4]) + d2 * d2 * end};
}

/* asin(x), 0 <= x <= 1/2. */
static inline arc arc_sine(double x)
{
    if (x < series_end)
        return small_arc_sine(x);
    int j;
    const double c = nearest_part(x, &j);
    return table_arc_sine(bat_arc_sines[j - FIRST_ARC], x - c);
}

/* asin(sqrt(square)) below the end of the series. */
static arc small_half_arc_cosine(double square)
{
    const double root = sqrt(square), first = bat_first_half(root),
                 rest = (square - first * first) - (root - first) * (root + first);
    arc b = small_arc_sine(root);
    if (root > 0)
        b.linear += rest / (2 * root);
    return b;
}

/* asin(sqrt((1 - x) / 2)), 1/2 < x <= 1. */
static inline __attribute__((always_inline)) arc half_arc_cosine(double x)
{
    const double square = 0.5 * (1 - x);
    if (x > half_series_begin)
        return small_half_arc_cosine(square);
    int j;
    const double root = sqrt(square), c = nearest_part(root, &j), d = root - c;
    const double *entry = bat_arc_sines[j - FIRST_ARC];
    arc b = table_arc_sine(entry, d);
    /* What the root's square lacks: c has eight bits, so but for d^2 nothing is rounded. */
    b.linear += ((square - c * c) - 2 * c * d - d * d) * entry[8];
    return b;
}

/* start, a pair, less factor times an angle. */
static inline double angle_less(bat_twin start, double factor, arc b)
{
    const bat_twin sum = bat_twin_sum(start.high, -factor * b.begin);
    return sum.high +
           ((sum.low + (start.low - factor * (b.step + b.linear))) - factor * b.curved);
}

static inline double angle_of(arc b)
{
    const bat_twin sum = bat_twin_sum(b.begin, b.step);
    return sum.high + ((sum.low + b.linear) + b.curved);
}

static const bat_twin eighth = {BAT_PI_1 / 4, BAT_PI_2 / 4},
                      quarter = {BAT_PI_1 / 2, BAT_PI_2 / 2};

/* asin and acos of what is not between -1 and 1. */
static double strange_arc(double x)
{
    return isnan(x) ? x + x : (double)NAN;
}

double bat_asin(double x)
{
    const double size = fabs(x);
    if (size <= 0.5)
        return size < 0x1p-27 ? x : copysign(angle_of(arc_sine(size)), x);
    if (!(size <= 1))
        return strange_arc(x);
    return copysign(2 * angle_less(eighth, 1, half_arc_cosine(size)), x);
}

double bat_acos(double x)
{
    const double size = fabs(x);
    if (size <= 0.5)
        return angle_less(quarter, x > 0 ? 1 : -1, arc_sine(size));
    if (!(size <= 1))
        return strange_arc(x);
    const arc b = half_arc_cosine(size);
    return x > 0 ? 2 * angle_of(b) : 2 * angle_less(quarter, 1, b);
}
