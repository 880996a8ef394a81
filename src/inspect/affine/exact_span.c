/* A span in exact numbers, and the dimension that it spans. */
#include "inspect/affine/exact_span.h"
#include "numeric/vector.h"

#include <limits.h>

/* ---- reading ---- */

/* The exponents of the first and the last bit of all numbers of one coordinate. */
static void measure_bits(int count, int stride, const double *values, int *low, int *high)
{
    *low = INT_MAX;
    *high = INT_MIN;
    for (int i = 0; i < count; i++) {
        int exponent;
        const double value = values[(size_t)i * (size_t)stride];
        if (value == 0)
            continue;
        int64_t mantissa = (int64_t)(frexp(value, &exponent) * 0x1p53);
        *high = bat_max_int(*high, exponent);
        for (exponent -= 53; mantissa % 2 == 0; exponent++)
            mantissa /= 2;
        *low = bat_min_int(*low, exponent);
    }
}

/* Powers of t from Bezier numbers: C(n, k) times their k-th difference. */
static bat_whole_poly powers_of(bat_wholes *pool, int n, int stride, const double *values,
                                int shift)
{
    bat_whole_poly p = bat_poly_make(pool, n);
    int64_t binomial = 1;
    for (int i = 0; i <= p.degree; i++)
        p.c[i] = bat_whole_of_double(pool, values[(size_t)i * (size_t)stride], shift);
    for (int r = 1; r <= p.degree; r++)
        for (int i = p.degree; i >= r; i--)
            p.c[i] = bat_whole_subtract(pool, p.c[i], p.c[i - 1]);
    for (int k = 0; k <= p.degree; k++) {
        p.c[k] = bat_whole_times(pool, p.c[k], binomial);
        binomial = binomial * (n - k) / (k + 1);
    }
    return bat_poly_trim(p);
}

batten_status bat_exact_span_read(bat_wholes *pool, int dimension, int degree,
                                  const double *points, bat_exact_span *out)
{
    bat_exact_span span = {.dimension = dimension};
    for (int k = 0; k < dimension; k++) {
        int low, high;
        measure_bits(degree + 1, dimension, points + k, &low, &high);
        if (low <= high && high - low > BAT_SPAN_BITS)
            return bat_fail(BATTEN_INCOMPLETE,
                            "coordinates %d have %d binary places, which is more than the %d "
                            "that are counted with",
                            k + 1, high - low, BAT_SPAN_BITS);
        span.shift[k] = low <= high ? -low : 0;
        span.at[k] = powers_of(pool, degree, dimension, points + k, span.shift[k]);
        span.degree = bat_max_int(span.degree, span.at[k].degree);
    }
    *out = span;
    return pool->effort->status;
}

/* 2^n x((1 + u) / 2) */
static bat_whole_poly centred(bat_wholes *pool, bat_whole_poly p, int n)
{
    bat_whole_poly scaled = bat_poly_copy(pool, p);
    for (int i = 0; i <= scaled.degree; i++)
        scaled.c[i] = bat_whole_shift(pool, scaled.c[i], n - i);
    return bat_poly_shift(pool, scaled, bat_whole_of_int(pool, 1));
}

void bat_exact_span_centred(bat_wholes *pool, const bat_exact_span *span, int stride,
                            double *powers)
{
    const int n = span->degree;
    bat_whole_poly p[3];
    int highest = INT_MIN;
    for (int k = 0; k < span->dimension; k++) {
        p[k] = centred(pool, span->at[k], n);
        for (int i = 1; i <= p[k].degree; i++)
            if (p[k].c[i].sign)
                highest = bat_max_int(highest, bat_whole_bits(p[k].c[i]) - span->shift[k]);
    }
    for (int k = 0; k < span->dimension; k++)
        for (int i = 0; i <= n; i++) {
            int exponent = 0;
            const bool is_there = i > 0 && i <= p[k].degree && p[k].c[i].sign;
            const double part = is_there ? bat_whole_frexp(p[k].c[i], &exponent) : 0;
            powers[k * stride + i] =
                is_there ? ldexp(part, exponent - span->shift[k] - highest) : 0;
        }
}

/* ---- exact dimension ---- */

static bat_whole coefficient(const bat_exact_span *span, int axis, int k)
{
    return k <= span->at[axis].degree ? span->at[axis].c[k] : (bat_whole){0, 0, NULL};
}

static bat_whole minor_of(bat_wholes *pool, const bat_exact_span *s, int x, int y, int i, int j)
{
    return bat_whole_subtract(
        pool, bat_whole_multiply(pool, coefficient(s, x, i), coefficient(s, y, j)),
        bat_whole_multiply(pool, coefficient(s, y, i), coefficient(s, x, j)));
}

/* The rank of the coefficients of t, t^2 ...: the first that is not 0, one beside it, one out
 * of their plane. *axes: coordinates in which that is seen. */
static int exact_dimension(bat_wholes *pool, const bat_exact_span *s, int *axes)
{
    int first = 0, second = 0;
    for (int k = s->degree; k > 0; k--)
        for (int x = 0; x < s->dimension; x++)
            if (coefficient(s, x, k).sign) {
                first = k;
                axes[0] = x;
            }
    if (first == 0)
        return 0;
    for (int k = first + 1; k <= s->degree; k++)
        for (int y = 1; y < s->dimension && second == 0; y++)
            for (int x = 0; x < y && second == 0; x++)
                if (minor_of(pool, s, x, y, first, k).sign) {
                    second = k;
                    axes[0] = x;
                    axes[1] = y;
                }
    if (second == 0)
        return 1;
    for (int k = second + 1; k <= s->degree && s->dimension == 3; k++) {
        bat_whole volume = {0, 0, NULL};
        for (int x = 0; x < 3; x++)
            volume = bat_whole_add(
                pool, volume,
                bat_whole_multiply(pool, coefficient(s, x, k),
                                   minor_of(pool, s, (x + 1) % 3, (x + 2) % 3, first, second)));
        if (volume.sign)
            return 3;
    }
    return 2;
}

/* ---- dimension by tolerance ---- */

typedef struct {
    double edge[3], normal[3]; /* the longest from the first point, the largest product */
    double length, width, height;
} extent;

static extent measure_extent(int d, int count, const double *points)
{
    extent e = {{0}, {0}, 0, 0, 0};
    double scale = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < d; k++)
            scale = bat_max(scale, fabs(points[i * d + k] / 2 - points[k] / 2));
    for (int pass = 0; pass < 3 && scale > 0; pass++)
        for (int i = 1; i < count; i++) {
            double v[3] = {0}, n[3];
            for (int k = 0; k < d; k++)
                v[k] = (points[i * d + k] / 2 - points[k] / 2) / scale;
            for (int k = 0; k < 3; k++)
                n[k] =
                    e.edge[(k + 1) % 3] * v[(k + 2) % 3] - e.edge[(k + 2) % 3] * v[(k + 1) % 3];
            const double sizes[3] = {bat_norm(3, v), bat_norm(3, n),
                                     fabs(bat_dot(3, e.normal, v))};
            double *const most[3] = {&e.length, &e.width, &e.height};
            if (sizes[pass] <= *most[pass])
                continue;
            *most[pass] = sizes[pass];
            for (int k = 0; k < 3 && pass < 2; k++)
                (pass ? e.normal : e.edge)[k] = pass ? n[k] : v[k];
        }
    return e;
}

static int largest_axis(const double *v)
{
    return fabs(v[0]) >= fabs(v[1]) && fabs(v[0]) >= fabs(v[2]) ? 0
           : fabs(v[1]) >= fabs(v[2])                           ? 1
                                                                : 2;
}

bat_flatness bat_flatness_of_points(int d, int count, const double *points, double tolerance)
{
    const extent e = measure_extent(d, count, points);
    const double wide = e.length > 0 ? e.width / (e.length * e.length) : 0;
    const double high = e.width > 0 ? e.height / (e.width * e.length) : 0;
    bat_flatness flat = {e.length == 0       ? 0
                         : wide <= tolerance ? 1
                         : high <= tolerance ? 2
                                             : 3,
                         0,
                         {0, 1}};
    flat.flatness = flat.dimension == 3 ? high : flat.dimension == 2 ? wide : 0;
    if (flat.dimension == 1)
        flat.axes[0] = largest_axis(e.edge);
    if (flat.dimension == 2 && d == 3) {
        const int across = largest_axis(e.normal);
        flat.axes[0] = across == 0;
        flat.axes[1] = across == 2 ? 1 : 2;
    }
    return flat;
}

bat_flatness bat_exact_span_flatness(bat_wholes *pool, const bat_exact_span *span,
                                     const double *points, int degree, double tolerance)
{
    bat_flatness flat = bat_flatness_of_points(span->dimension, degree + 1, points, tolerance);
    if (tolerance == 0)
        flat.dimension = exact_dimension(pool, span, flat.axes);
    return flat;
}
