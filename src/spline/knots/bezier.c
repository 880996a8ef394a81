/* Parts of splines: clamped at a and b, or cut into Bezier pieces. */
#include "spline/spline.h"

#include <string.h>

/* The part of `spline` between a and b, each of which is a knot at least p times. */
static batten_status trim(const bat_spline *spline, double a, double b, bat_spline *out)
{
    const int p = spline->degree, n = spline->count;
    const double *U = spline->knots;
    int last_a = 0, first_b = n + p;
    while (U[last_a + 1] <= a)
        last_a++;
    while (U[first_b - 1] >= b)
        first_b--;
    bat_spline made;
    const batten_status status = bat_spline_make(p, first_b - last_a + p, spline->width, &made);
    if (status != BATTEN_OK)
        return status;
    memcpy(made.values, spline->values + (size_t)(last_a - p) * spline->width,
           (size_t)made.count * spline->width * sizeof *made.values);
    for (int i = 0; i <= p; i++) {
        made.knots[i] = a;
        made.knots[made.count + i] = b;
    }
    for (int i = p + 1; i < made.count; i++)
        made.knots[i] = U[last_a - p + i];
    *out = made;
    return BATTEN_OK;
}

/* Add u to `knots` so often that it stands p times. */
static int fill_up(const bat_spline *spline, double u, int count, double *knots)
{
    const int have = bat_knots_multiplicity(spline->degree, spline->count, spline->knots, u);
    for (int i = have; i < spline->degree; i++)
        knots[count++] = u;
    return count;
}

static batten_status insert_and_trim(const bat_spline *spline, double a, double b, int count,
                                     const double *knots, bat_spline *out)
{
    bat_spline refined;
    batten_status status = bat_spline_insert(spline, count, knots, &refined);
    if (status != BATTEN_OK)
        return status;
    status = trim(&refined, a, b, out);
    bat_spline_free(&refined);
    return status;
}

batten_status bat_spline_subrange(const bat_spline *spline, double a, double b, bat_spline *out)
{
    double knots[2 * BATTEN_MAX_DEGREE];
    int count = fill_up(spline, a, 0, knots);
    count = fill_up(spline, b, count, knots);
    return insert_and_trim(spline, a, b, count, knots, out);
}

batten_status bat_spline_split(const bat_spline *spline, double u, bat_spline *low,
                               bat_spline *high)
{
    const double a = spline->knots[spline->degree], b = spline->knots[spline->count];
    double knots[3 * BATTEN_MAX_DEGREE];
    int count = fill_up(spline, a, 0, knots);
    count = fill_up(spline, u, count, knots);
    count = fill_up(spline, b, count, knots);
    bat_spline refined, first, second;
    batten_status status = bat_spline_insert(spline, count, knots, &refined);
    if (status != BATTEN_OK)
        return status;
    status = trim(&refined, a, u, &first);
    if (status == BATTEN_OK) {
        status = trim(&refined, u, b, &second);
        if (status != BATTEN_OK)
            bat_spline_free(&first);
    }
    bat_spline_free(&refined);
    if (status != BATTEN_OK)
        return status;
    *low = first;
    *high = second;
    return BATTEN_OK;
}

batten_status bat_spline_to_bezier(const bat_spline *spline, bat_spline *out)
{
    const int p = spline->degree, n = spline->count;
    const double *U = spline->knots;
    double *knots = bat_array3((size_t)n + 1, (size_t)p, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int i = p; i <= n; i++)
        if (i == p || U[i] > U[i - 1])
            count = fill_up(spline, U[i], count, knots);
    const batten_status status = insert_and_trim(spline, U[p], U[n], count, knots, out);
    bat_release(knots);
    return status;
}
