/* All inner knots that can go: knot by knot (remove.c), then many at once (reduce_knots.c). */
#include "spline/spline.h"

/* From the spline as it is, and from the one without what could go knot by knot: whichever way
 * leaves fewer knots. Neither is always the better. */
static batten_status reduce_both(const bat_spline *spline, size_t group, double tolerance,
                                 double *error, bat_spline *made)
{
    bat_spline other;
    double moved = 0;
    batten_status status = bat_spline_reduce_knots(spline, group, tolerance, made, error);
    if (status != BATTEN_OK || tolerance == 0)
        return status;
    status = bat_spline_insert(spline, 0, NULL, &other);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_reduce_knots(spline, group, tolerance, &other, &moved);
    if (status == BATTEN_OK && other.count < made->count) {
        const bat_spline worse = *made;
        *made = other;
        other = worse;
        *error = moved;
    }
    bat_spline_free(&other);
    return status;
}

batten_status bat_spline_remove_all(const bat_spline *spline, size_t group, double tolerance,
                                    int *removed, double *error, bat_spline *out)
{
    bat_spline made;
    batten_status status = bat_spline_insert(spline, 0, NULL, &made);
    if (status != BATTEN_OK)
        return status;
    status = bat_spline_thin(&made, group, tolerance, removed, error);
    if (status == BATTEN_OK)
        status = reduce_both(spline, group, tolerance, error, &made);
    if (status == BATTEN_OK) {
        *removed = spline->count - made.count;
        *out = made;
    } else {
        bat_spline_free(&made);
    }
    return status;
}
