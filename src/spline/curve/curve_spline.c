/* Between curves, which have Cartesian points, and splines, which have homogeneous rows. */
#include "spline/curve/curve.h"

#include <string.h>

batten_status bat_curve_to_spline(const batten_curve *curve, bat_spline *out)
{
    const batten_status status =
        bat_spline_make(curve->degree, curve->count, bat_curve_width(curve), out);
    if (status != BATTEN_OK)
        return status;
    bat_curve_rows(curve, 0, curve->count, out->width, out->values);
    memcpy(out->knots, curve->knots,
           ((size_t)curve->count + (size_t)curve->degree + 1) * sizeof *out->knots);
    return BATTEN_OK;
}

/* Which row of `from`, at or soon after `next`, is this one? -1 for none. */
static int find_row(const bat_spline *from, int next, const double *row)
{
    const int end = bat_min_int(from->count, next + 2 * from->degree + 2);
    for (int i = next; i < end; i++)
        if (memcmp(from->values + (size_t)i * from->width, row, from->width * sizeof *row) == 0)
            return i;
    return -1;
}

static void fill_point(const batten_curve *like, int known, const double *row, int i,
                       batten_curve *curve)
{
    const size_t d = (size_t)curve->dimension;
    double *point = curve->points + (size_t)i * d;
    if (known >= 0) {
        memcpy(point, like->points + (size_t)known * d, d * sizeof *point);
        curve->weights[i] = like->weights[known];
        return;
    }
    for (size_t k = 0; k < d; k++)
        point[k] = row[k] / row[d];
    curve->weights[i] = row[d] / like->weight_scale;
}

static batten_status check_rows(const bat_spline *spline)
{
    const size_t total = (size_t)spline->count * spline->width;
    const size_t i = bat_first_not_finite(spline->values, total);
    if (i < total)
        return bat_fail(BATTEN_OVERFLOW, "control point %zu became too large for a number",
                        i / spline->width + 1);
    return BATTEN_OK;
}

batten_status bat_curve_from_spline(const batten_curve *like, const bat_spline *from, int first,
                                    const bat_spline *made, batten_curve **out)
{
    batten_curve *curve = NULL;
    batten_status status = check_rows(made);
    if (status == BATTEN_OK)
        status = bat_curve_make_like(like, made->degree, made->count, &curve);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)made->count;
    memcpy(curve->knots, made->knots, (n + (size_t)made->degree + 1) * sizeof *made->knots);
    if (!curve->weights)
        memcpy(curve->points, made->values, n * made->width * sizeof *made->values);
    for (int i = 0; curve->weights && i < made->count; i++) {
        const double *row = made->values + (size_t)i * made->width;
        const int known = from ? find_row(from, first, row) : -1;
        fill_point(like, known, row, i, curve);
        first = known >= 0 ? known + 1 : first;
    }
    return bat_curve_finish(curve, out);
}

batten_status bat_curve_of_changed(batten_status change, const batten_curve *like,
                                   bat_spline *from, bat_spline *made, batten_curve **out)
{
    batten_status status = change;
    if (status == BATTEN_OK) {
        status = bat_curve_from_spline(like, from, 0, made, out);
        bat_spline_free(made);
    }
    bat_spline_free(from);
    return status;
}

/* ---- periodic curves ---- */

batten_status bat_curve_unwrap(const batten_curve *curve, int more, bat_spline *out)
{
    const int p = curve->degree, m = curve->count - p;
    bat_spline made;
    const batten_status status =
        bat_spline_make(p, (2 * more + 1) * m + p, bat_curve_width(curve), &made);
    if (status != BATTEN_OK)
        return status;
    bat_knots_wrap(more * m + p, m, curve->knots + p, made.knots);
    for (int i = 0; i < made.count; i++)
        bat_curve_rows(curve, i % m, 1, made.width, made.values + (size_t)i * made.width);
    *out = made;
    return BATTEN_OK;
}

batten_status bat_curve_wrap(const batten_curve *like, const bat_spline *spline, double a,
                             int m, batten_curve **out)
{
    const int p = spline->degree;
    int last_a = 0;
    while (spline->knots[last_a + 1] <= a)
        last_a++;
    bat_spline part = *spline;
    part.values += (size_t)(last_a - p) * part.width;
    part.knots += last_a - p;
    part.count = m;
    batten_curve *open;
    batten_status status = bat_curve_from_spline(like, NULL, 0, &part, &open);
    if (status != BATTEN_OK)
        return status;
    status =
        batten_curve_create_periodic((batten_points){like->dimension, part.count, open->points},
                                     p, open->weights, open->knots + p, out);
    batten_curve_unref(open);
    return status;
}
