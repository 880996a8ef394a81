/*
 * Small vectors: batten_vec3 by value, and rows of d doubles.
 */
#ifndef BAT_VECTOR_H
#define BAT_VECTOR_H
#include "base/base.h"
#include <batten/geometry.h>

static inline batten_vec3 bat_vec3_add(batten_vec3 a, batten_vec3 b)
{
    return (batten_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline batten_vec3 bat_vec3_subtract(batten_vec3 a, batten_vec3 b)
{
    return (batten_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline batten_vec3 bat_vec3_scale(batten_vec3 a, double factor)
{
    return (batten_vec3){factor * a.x, factor * a.y, factor * a.z};
}

/* a + factor b */
static inline batten_vec3 bat_vec3_along(batten_vec3 a, double factor, batten_vec3 b)
{
    return (batten_vec3){a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

static inline double bat_vec3_dot(batten_vec3 a, batten_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline batten_vec3 bat_vec3_cross(batten_vec3 a, batten_vec3 b)
{
    return (batten_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double bat_dot(int d, const double *a, const double *b)
{
    double sum = 0;
    for (int k = 0; k < d; k++)
        sum += a[k] * b[k];
    return sum;
}

/* The cross product of rows of three; `out` may be one of them. */
static inline void bat_cross(const double *a, const double *b, double *out)
{
    const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
    out[0] = x;
    out[1] = y;
}

/* The angle between rows of three, in radians; 0 where one of them vanishes. */
static inline double bat_angle(const double *a, const double *b)
{
    double n[3];
    bat_cross(a, b, n);
    return bat_atan2(bat_hypot(bat_hypot(n[0], n[1]), n[2]),
                     a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/* The largest |a[k]|. */
static inline double bat_largest(int d, const double *a)
{
    double largest = 0;
    for (int k = 0; k < d; k++)
        largest = bat_max(largest, fabs(a[k]));
    return largest;
}

/* The Euclidean norm; right wherever the result is finite, however small or large the numbers.
 */
static inline double bat_norm(int d, const double *a)
{
    const double plain = bat_dot(d, a, a);
    if ((plain > 0x1p-900 && plain < 0x1p1000) || isnan(plain))
        return sqrt(plain);
    const double largest = bat_largest(d, a);
    if (largest == 0 || !isfinite(largest))
        return largest;
    double sum = 0;
    for (int k = 0; k < d; k++)
        sum += (a[k] / largest) * (a[k] / largest);
    return largest * sqrt(sum);
}

static inline double bat_vec3_norm(batten_vec3 a)
{
    return bat_norm(3, (const double[3]){a.x, a.y, a.z});
}

/* The distance of two points of dimension d <= 4. */
static inline double bat_distance(int d, const double *a, const double *b)
{
    double difference[4];
    assert(d <= 4);
    for (int k = 0; k < d; k++)
        difference[k] = a[k] - b[k];
    return bat_norm(d, difference);
}

/* The distance of q from the segment from a to b, which may be a point; d <= 3. */
static inline double bat_segment_distance(int d, const double *a, const double *b,
                                          const double *q)
{
    double along[3] = {0}, off[3] = {0};
    for (int k = 0; k < d; k++) {
        along[k] = b[k] - a[k];
        off[k] = q[k] - a[k];
    }
    const double length2 = bat_dot(d, along, along);
    const double s = length2 > 0 ? bat_max(0, bat_min(1, bat_dot(d, along, off) / length2)) : 0;
    for (int k = 0; k < d; k++)
        off[k] -= s * along[k];
    return bat_norm(d, off);
}

/* A row of 1 to 3 coordinates as a point in space; the others are 0. */
static inline batten_vec3 bat_vec3_of(int d, const double *a)
{
    return (batten_vec3){a[0], d > 1 ? a[1] : 0, d > 2 ? a[2] : 0};
}

#endif
