/* The one order of numbers, the same on every machine. Inline throughout, so that the sister
 * libraries share it. */
#ifndef BAT_SORT_H
#define BAT_SORT_H
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

/* For qsort: rising, -0 before 0 and what is not a number last, so that no two different values
 * are equal and no library may choose between them. */
static inline int bat_compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    if (x != y)
        return x < y ? -1 : x > y ? 1 : !!isnan(x) - !!isnan(y);
    return !!signbit(y) - !!signbit(x);
}

static inline void bat_sort_doubles(size_t count, double *values)
{
    if (count > 1)
        qsort(values, count, sizeof *values, bat_compare_doubles);
}

/* Of rising values, keep those that are more than `apart` above the last one kept, in front;
 * the first is always kept. @return how many are kept */
static inline size_t bat_unique(size_t count, double *values, double apart)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (kept == 0 || values[i] - values[kept - 1] > apart)
            values[kept++] = values[i];
    return kept;
}

#endif
