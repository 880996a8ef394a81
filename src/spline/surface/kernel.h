/*
 * The inner loops of surface evaluation. Two numbers at a time where the compiler knows
 * vectors; each number of a pair is computed as in the plain form beside it, so the bits are
 * the same.
 */
#ifndef BAT_SURFACE_KERNEL_H
#define BAT_SURFACE_KERNEL_H
#include "base/base.h"

#include <string.h>

#if defined(__GNUC__)
#define BAT_INLINE static inline __attribute__((always_inline))
typedef double bat_pair __attribute__((vector_size(16)));
enum { BAT_LANES = 2 };
#else
#define BAT_INLINE static inline
typedef double bat_pair;
enum { BAT_LANES = 1 };
#endif

BAT_INLINE bat_pair bat_load(const double *x)
{
    bat_pair pair;
    memcpy(&pair, x, sizeof pair);
    return pair;
}

BAT_INLINE void bat_store(double *x, bat_pair pair)
{
    memcpy(x, &pair, sizeof pair);
}

/* out [length] = the sum of c[i] rows[i * stride ..], i = 0 .. terms - 1, added in this order.
 * Called with constants for `terms` and `length` where it pays. */
BAT_INLINE void bat_combine_rows(const int terms, const size_t length, const double *c,
                                 const double *rows, const size_t stride, double *out)
{
    size_t x = 0;
    for (; x + BAT_LANES <= length; x += BAT_LANES) {
        bat_pair sum = c[0] * bat_load(rows + x);
        if (terms == 4)
            sum = sum + c[1] * bat_load(rows + stride + x) +
                  c[2] * bat_load(rows + 2 * stride + x) +
                  c[3] * bat_load(rows + 3 * stride + x);
        else
            for (int i = 1; i < terms; i++)
                sum += c[i] * bat_load(rows + (size_t)i * stride + x);
        bat_store(out + x, sum);
    }
    for (; x < length; x++) {
        double sum = c[0] * rows[x];
        if (terms == 4)
            sum = sum + c[1] * rows[stride + x] + c[2] * rows[2 * stride + x] +
                  c[3] * rows[3 * stride + x];
        else
            for (int i = 1; i < terms; i++)
                sum += c[i] * rows[(size_t)i * stride + x];
        out[x] = sum;
    }
}

/* Rows of three numbers in registers: stores of pairs that are read back across their borders
 * are slow. */
typedef struct {
    bat_pair xy[2 / BAT_LANES];
    double z;
} bat_triple;

BAT_INLINE bat_triple bat_scaled_triple(double c, const double *row)
{
    bat_triple made = {.z = c * row[2]};
    for (int k = 0; k < 2 / BAT_LANES; k++)
        made.xy[k] = c * bat_load(row + k * BAT_LANES);
    return made;
}

BAT_INLINE bat_triple bat_add_triples(bat_triple a, bat_triple b)
{
    for (int k = 0; k < 2 / BAT_LANES; k++)
        a.xy[k] += b.xy[k];
    a.z += b.z;
    return a;
}

BAT_INLINE bat_triple bat_scale_triple(double c, bat_triple a)
{
    for (int k = 0; k < 2 / BAT_LANES; k++)
        a.xy[k] = c * a.xy[k];
    a.z = c * a.z;
    return a;
}

BAT_INLINE void bat_store_triple(double *row, bat_triple a)
{
    for (int k = 0; k < 2 / BAT_LANES; k++)
        bat_store(row + k * BAT_LANES, a.xy[k]);
    row[2] = a.z;
}

/* bat_combine_rows of four rows of three numbers. */
BAT_INLINE bat_triple bat_combine_triples(const double *c, const double *rows,
                                          const size_t stride)
{
    bat_triple sum = bat_scaled_triple(c[0], rows);
    sum = bat_add_triples(sum, bat_scaled_triple(c[1], rows + stride));
    sum = bat_add_triples(sum, bat_scaled_triple(c[2], rows + 2 * stride));
    return bat_add_triples(sum, bat_scaled_triple(c[3], rows + 3 * stride));
}

/* The point of homogeneous coordinates. */
BAT_INLINE void bat_project(const int dimension, const double *h, double *point)
{
    const double w = h[dimension];
    for (int k = 0; k < dimension; k++)
        point[k] = h[k] / w;
}

#endif
