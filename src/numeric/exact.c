#include "numeric/exact.h"

/* Source: [Shewchuk97], sections 2.4 and 2.8. */

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

static void add(bat_exact *sum, double b)
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
    add(&difference, a);
    add(&difference, -b);
    return difference;
}

static void add_scaled(bat_exact *sum, double a, double b)
{
    const double high = a * b;
    add(sum, fma(a, b, -high));
    add(sum, high);
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
            add_scaled(sum, factor, fma(a->part[i], b->part[j], -high));
            add_scaled(sum, factor, high);
        }
}

int bat_exact_sign(const bat_exact *a)
{
    if (a->count == 0)
        return 0;
    return a->part[a->count - 1] > 0 ? 1 : -1;
}
