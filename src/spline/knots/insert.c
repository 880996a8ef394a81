/* Knot insertion [Boehm80]: from left to right, each row is touched at most p times for a knot.
 */
#include "spline/spline.h"

#include <string.h>

/* The refined spline as far as it is made. */
typedef struct {
    const bat_spline *from;
    bat_spline *to;
    int filled; /* knots in `to`; as many rows, while there are rows */
    int done;   /* knots inserted */
} insertion;

static double *row(const bat_spline *spline, int i)
{
    return spline->values + (size_t)i * spline->width;
}

static void copy_row(const bat_spline *to, int i, const bat_spline *from, int j)
{
    memmove(row(to, i), row(from, j), to->width * sizeof *to->values);
}

/* Take over what lies at or before u. */
static void advance(insertion *work, double u)
{
    const bat_spline *from = work->from;
    const int knot_count = from->count + from->degree + 1;
    for (int j = work->filled - work->done; j < knot_count && from->knots[j] <= u; j++) {
        work->to->knots[work->filled] = from->knots[j];
        if (j < from->count)
            copy_row(work->to, work->filled, from, j);
        work->filled++;
    }
}

/* Q_i = a_i P_i + (1 - a_i) P_(i-1), a_i = (u - U_i) / (U_(i+p) - U_i), for i = k - p + 1 .. k
 * - s. */
static void insert_one(insertion *work, double u)
{
    bat_spline *to = work->to;
    const int p = to->degree, k = work->filled - 1;
    int s = 0;
    while (s <= k && to->knots[k - s] == u)
        s++;
    for (int i = bat_min_int(k, work->from->count + work->done - 1); i >= k - s; i--)
        copy_row(to, i + 1, to, i);
    for (int i = k - s; i > k - p; i--) {
        const double right =
            i + p <= k ? to->knots[i + p] : work->from->knots[i + p - work->done];
        const double alpha = (u - to->knots[i]) / (right - to->knots[i]), beta = 1 - alpha;
        double *q = row(to, i);
        const double *before = row(to, i - 1);
        for (size_t c = 0; c < to->width; c++)
            q[c] = alpha * q[c] + beta * before[c];
    }
    to->knots[work->filled++] = u;
    work->done++;
}

static void insert_all(const bat_spline *spline, int count, const double *knots,
                       bat_spline *made)
{
    insertion work = {spline, made, 0, 0};
    for (int i = 0; i < count; i++) {
        advance(&work, knots[i]);
        insert_one(&work, knots[i]);
    }
    advance(&work, HUGE_VAL);
}

batten_status bat_spline_insert(const bat_spline *spline, int count, const double *knots,
                                bat_spline *out)
{
    bat_spline made;
    const batten_status status =
        bat_spline_make(spline->degree, spline->count + count, spline->width, &made);
    if (status != BATTEN_OK)
        return status;
    insert_all(spline, count, knots, &made);
    *out = made;
    return BATTEN_OK;
}
