/* Random splines of any knots, and their values by definition. */
#ifndef TESTS_SUPPORT_SPLINES_H
#define TESTS_SUPPORT_SPLINES_H
#include "spline/spline.h"

#include "support/test.h"

enum { TEST_SPANS = 5 };

static inline int put_times(double knot, int times, int count, double *knots)
{
    for (int k = 0; k < times; k++)
        knots[count++] = knot;
    return count;
}

/* Values in [-1, 1]. Half of them are clamped; inner knots stand once to p times. */
static inline batten_status random_spline(test_random *random, int degree, size_t width,
                                          bat_spline *out)
{
    double knots[(TEST_SPANS + 1) * (BATTEN_MAX_DEGREE + 1)];
    const int p = degree, spans = test_random_int(random, 1, TEST_SPANS);
    const bool clamped = test_random_int(random, 0, 1) == 1;
    double at = test_random_in(random, -2, 2);
    int count = 0;
    /* Outside an unclamped domain the knots rise by small steps. */
    if (clamped)
        count = put_times(at, p + 1, count, knots);
    else
        for (int k = 0; k <= p; k++)
            count = put_times(at += test_random_in(random, 0.1, 0.5), 1, count, knots);
    for (int k = 1; k < spans; k++)
        count = put_times(at += test_random_in(random, 0.2, 1), test_random_int(random, 1, p),
                          count, knots);
    at += test_random_in(random, 0.2, 1);
    if (clamped)
        count = put_times(at, p + 1, count, knots);
    else
        for (int k = 0; k <= p; k++)
            count = put_times(at += test_random_in(random, 0.1, 0.5), 1, count, knots);
    const batten_status status = bat_spline_make(p, count - p - 1, width, out);
    if (status != BATTEN_OK)
        return status;
    memcpy(out->knots, knots, (size_t)count * sizeof *knots);
    for (size_t i = 0; i < (size_t)out->count * width; i++)
        out->values[i] = test_random_in(random, -1, 1);
    return BATTEN_OK;
}

/* N_(i, p) or a derivative by the recurrence of Cox and de Boor on span k. */
static inline long double basis_by_definition(int degree, const double *knots, int span, int i,
                                              double u, int order)
{
    const int p = degree;
    if (order > p)
        return 0;
    if (p == 0)
        return i == span;
    const long double low = (long double)knots[i + p] - knots[i],
                      high = (long double)knots[i + p + 1] - knots[i + 1];
    const bool lower = low > 0 && i <= span && i + p - 1 >= span,
               upper = high > 0 && i + 1 <= span && i + p >= span;
    long double sum = 0;
    if (lower)
        sum += (order ? p : (long double)u - knots[i]) / low *
               basis_by_definition(p - 1, knots, span, i, u, order ? order - 1 : 0);
    if (upper)
        sum += (order ? -p : (long double)knots[i + p + 1] - u) / high *
               basis_by_definition(p - 1, knots, span, i + 1, u, order ? order - 1 : 0);
    return sum;
}

/* One column of the spline, or of a derivative of it, at u, seen from one side. */
static inline double spline_by_definition(const bat_spline *spline, size_t column, double u,
                                          batten_side side, int order)
{
    const int p = spline->degree, n = spline->count;
    int k = p;
    while (k + 1 < n &&
           (side == BATTEN_FROM_LEFT ? spline->knots[k + 1] < u : spline->knots[k + 1] <= u))
        k++;
    while (spline->knots[k] == spline->knots[k + 1])
        k += k + 1 < n ? 1 : -1;
    long double sum = 0;
    for (int i = k - p; i <= k; i++)
        sum += basis_by_definition(p, spline->knots, k, i, u, order) *
               spline->values[(size_t)i * spline->width + column];
    return (double)sum;
}

/* The largest difference of two splines of one domain at many places. */
static inline double spline_distance(const bat_spline *a, const bat_spline *b)
{
    enum { PLACES = 60 };
    const double start = a->knots[a->degree], end = a->knots[a->count];
    double largest = 0;
    for (int i = 0; i <= PLACES; i++)
        for (size_t c = 0; c < a->width; c++) {
            const double u = i < PLACES ? start + (end - start) * i / PLACES : end;
            largest = fmax(largest, fabs(spline_by_definition(a, c, u, BATTEN_FROM_RIGHT, 0) -
                                         spline_by_definition(b, c, u, BATTEN_FROM_RIGHT, 0)));
        }
    return largest;
}

#endif
