/* The first parameters of a cloud without a base: its projection on the plane of least squares.
 */
#include "numeric/eigen.h"
#include "numeric/vector.h"
#include "shape/cloud/scattered.h"

#include <string.h>

/* Of every third number. */
static batten_interval range_of(size_t count, const double *x)
{
    batten_interval range = {HUGE_VAL, -HUGE_VAL};
    for (size_t t = 0; t < count; t++) {
        range.a = bat_min(range.a, x[3 * t]);
        range.b = bat_max(range.b, x[3 * t]);
    }
    return range;
}

/* The mean of every third number, summed from `low` on so that nothing overflows. */
static double mean_above(double low, size_t count, const double *x)
{
    double mean = 0;
    for (size_t t = 0; t < count; t++)
        mean += (x[3 * t] - low) / (double)count;
    return mean + low;
}

static void find_mean(size_t count, const double *points, double mean[3], double *size)
{
    *size = 0;
    for (size_t c = 0; c < 3; c++) {
        const batten_interval range = range_of(count, points + c);
        *size = bat_max(*size, range.b - range.a);
        mean[c] = mean_above(range.a, count, points + c);
    }
}

/* The axes of a plane turned by an angle. */
static void turn_axes(double from[2][3], double angle, double to[2][3])
{
    for (int c = 0; c < 3; c++) {
        to[0][c] = from[0][c] * bat_cos(angle) + from[1][c] * bat_sin(angle);
        to[1][c] = from[1][c] * bat_cos(angle) - from[0][c] * bat_sin(angle);
    }
}

/* Points about their mean, by a size. */
typedef struct {
    size_t count;
    const double *points, *mean;
    double size;
} centred;

/* How wide the points are along both axes. */
static void widths_along(const centred *p, double axes[2][3], double widths[2])
{
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t t = 0; t < p->count; t++) {
        double off[3];
        for (size_t c = 0; c < 3; c++)
            off[c] = (p->points[3 * t + c] - p->mean[c]) / p->size;
        for (int k = 0; k < 2; k++) {
            const double at = bat_dot(3, off, axes[k]);
            low[k] = bat_min(low[k], at);
            high[k] = bat_max(high[k], at);
        }
    }
    for (int k = 0; k < 2; k++)
        widths[k] = high[k] - low[k];
}

/* Turn the axes to the smallest rectangle around the points, by whole degrees: the principal
 * axes of a square may be its diagonals, and half of the domain would be empty. A gain of less
 * than a tenth does not count: what is long keeps its direction. */
static void turn_to_smallest(size_t count, const double *points, const double mean[3],
                             double size, double axes[2][3])
{
    double found[2][3], turned[2][3], widths[2], least;
    const centred all = {count, points, mean, size};
    widths_along(&all, axes, widths);
    least = 0.9 * widths[0] * widths[1];
    memcpy(found, axes, sizeof found);
    for (int degrees = 1; degrees < 90; degrees++) {
        turn_axes(axes, degrees * BAT_PI / 180, turned);
        widths_along(&all, turned, widths);
        if (widths[0] * widths[1] >= least)
            continue;
        least = widths[0] * widths[1];
        memcpy(found[0], turned[widths[0] >= widths[1] ? 0 : 1], sizeof found[0]);
        memcpy(found[1], turned[widths[0] >= widths[1] ? 1 : 0], sizeof found[1]);
    }
    memcpy(axes, found, sizeof found);
}

/* The directions of the plane of least squares: the longest first, pointing up their longest
 * coordinate. */
static batten_status find_plane(size_t count, const double *points, double mean[3],
                                double axes[2][3])
{
    double size, a[9] = {0}, values[3], vectors[9];
    find_mean(count, points, mean, &size);
    for (size_t t = 0; size > 0 && t < count; t++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                a[3 * i + j] += (points[3 * t + (size_t)i] - mean[i]) / size *
                                ((points[3 * t + (size_t)j] - mean[j]) / size);
    /* Of squares: widths of 1e-7 of the length, where the rounding of the sums begins. */
    bat_eigen_symmetric(3, a, values, vectors);
    if (!(values[1] > 1e-14 * values[2]))
        return bat_fail(BATTEN_COINCIDENT, "the points lie on a line and define no plane");
    for (int k = 0; k < 2; k++)
        memcpy(axes[k], vectors + 3 * (2 - k), 3 * sizeof(double));
    turn_to_smallest(count, points, mean, size, axes);
    for (int k = 0; k < 2; k++) {
        /* The first of equal components: equal to nine digits, lest rounding choose. */
        double longest = 0;
        for (int c = 0; c < 3; c++)
            if (fabs(axes[k][c]) > fabs(longest) * (1 + 1e-9))
                longest = axes[k][c];
        for (int c = 0; c < 3; c++)
            axes[k][c] = copysign(1, longest) * axes[k][c];
    }
    return BATTEN_OK;
}

batten_status bat_scatter_on_plane(size_t count, const double *points, double *uv)
{
    double mean[3], axes[2][3], off[3];
    const batten_status status = find_plane(count, points, mean, axes);
    for (size_t t = 0; status == BATTEN_OK && t < count; t++) {
        for (size_t c = 0; c < 3; c++)
            off[c] = points[3 * t + c] - mean[c];
        for (int k = 0; k < 2; k++)
            uv[2 * t + (size_t)k] = bat_dot(3, off, axes[k]);
    }
    return status;
}
