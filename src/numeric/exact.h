/*
 * Sums and products of doubles without any rounding, for signs that must be right.
 *
 * A value is the sum of its parts, which do not overlap and grow in size. It is exact as long
 * as no product of two parts is below 2^-1021 or overflows.
 */
#ifndef BAT_EXACT_H
#define BAT_EXACT_H
#include "base/base.h"

/* All doubles together span 2098 binary places; 41 full parts hold any value, and 48 leave room
 * to add a while before parts are made full again. */
enum { BAT_EXACT_PARTS = 48 };

typedef struct {
    int count;
    double part[BAT_EXACT_PARTS];
} bat_exact;

/* a - b */
bat_exact bat_exact_difference(double a, double b);
/* sum += factor a, for a factor that is a small whole number */
void bat_exact_add(bat_exact *sum, double factor, const bat_exact *a);
/* sum += factor a b */
void bat_exact_add_product(bat_exact *sum, double factor, const bat_exact *a,
                           const bat_exact *b);
/* -1, 0 or 1 */
int bat_exact_sign(const bat_exact *a);

#endif
