/*
 * Exact sums and products of doubles, kept as expansions: sums of doubles that do not overlap.
 * Source: [Shewchuk97], sections 2.4 and 2.8.
 */
#include "numeric/exact.h"

/* a + b = *high + *low exactly. */
static void two_sum(double a, double b, double *high, double *low)
{
    const double sum = a + b, part = sum - a;
    *low = (a - (sum - part)) + (b - part);
    *high = sum;
}

/* The fewest parts of the same value. */
static void compress(bat_exact *a)
{
    double full[BAT_EXACT_PARTS];
    int bottom = a->count - 1, top = 0;
    double q = a->part[bottom];
    for (int i = bottom - 1; i >= 0; i--) {
        double low;
        two_sum(q, a->part[i], &q, &low);
        if (low != 0) {
            full[bottom--] = q;
            q = low;
        }
    }
    full[bottom] = q;
    for (int i = bottom + 1; i < a->count; i++) {
        double low;
        two_sum(full[i], q, &q, &low);
        if (low != 0)
            a->part[top++] = low;
    }
    a->part[top++] = q;
    a->count = top;
}

static void add_number(bat_exact *sum, double b)
{
    double q = b;
    int count = 0;
    for (int i = 0; i < sum->count; i++) {
        double low;
        two_sum(q, sum->part[i], &q, &low);
        if (low != 0)
            sum->part[count++] = low;
    }
    if (q != 0)
        sum->part[count++] = q;
    sum->count = count;
    if (count == BAT_EXACT_PARTS)
        compress(sum);
}

bat_exact bat_exact_difference(double a, double b)
{
    bat_exact difference = {.count = 0};
    add_number(&difference, a);
    add_number(&difference, -b);
    return difference;
}

/* The two halves of a: high has 26 bits, the products of halves are exact. For |a| < 2^996. */
static double high_half(double a)
{
    const double scaled = a * 0x8000001p0; /* 2^27 + 1 [Dekker71] */
    return scaled - (scaled - a);
}

/* a b - high without rounding, where high is a * b. By Dekker's product and not by fma(), which is wrong in some C
 * libraries (MinGW). Factors that are too large for it are scaled down, and what of the product is below all doubles
 * is computed 2^200 higher. Source: [Dekker71], section 5. */
static double product_error(double a, double b, double high)
{
    if (fabs(a) > 0x1p970)
        return 0x1p60 * product_error(0x1p-60 * a, b, 0x1p-60 * high);
    if (fabs(b) > 0x1p970)
        return 0x1p60 * product_error(a, 0x1p-60 * b, 0x1p-60 * high);
    /* The product of the low halves is 2^-106 of the whole, and the least double is 2^-1074; below all doubles the
     * error is 0. Then the smaller factor is below 2^-480. */
    if (fabs(high) < 0x1p-960) {
        const double small = 0x1p400 * (fabs(a) < fabs(b) ? a : b),
                     other = fabs(a) < fabs(b) ? b : a;
        const double scaled = small * other;
        return fabs(scaled) < 0x1p-960
                   ? 0
                   : 0x1p-400 * (scaled - 0x1p400 * high + product_error(small, other, scaled));
    }
    const double a1 = high_half(a), a2 = a - a1, b1 = high_half(b), b2 = b - b1;
    return ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2;
}

static void add_scaled(bat_exact *sum, double a, double b)
{
    const double high = a * b;
    add_number(sum, product_error(a, b, high));
    add_number(sum, high);
}

void bat_exact_add(bat_exact *sum, double factor, const bat_exact *a)
{
    for (int i = 0; i < a->count; i++)
        add_scaled(sum, factor, a->part[i]);
}

void bat_exact_add_product(bat_exact *sum, double factor, const bat_exact *a,
                           const bat_exact *b)
{
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++) {
            const double high = a->part[i] * b->part[j];
            add_scaled(sum, factor, product_error(a->part[i], b->part[j], high));
            add_scaled(sum, factor, high);
        }
}

int bat_exact_sign(const bat_exact *a)
{
    if (a->count == 0)
        return 0;
    return a->part[a->count - 1] > 0 ? 1 : -1;
}
