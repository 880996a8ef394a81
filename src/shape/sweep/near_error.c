/* How far interpolated sections are from a sweep. */
#include "shape/sweep/near_error.h"
#include "numeric/vector.h"
#include "shape/sweep/true_sweep.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <float.h>
#include <string.h>

enum { MOST_PLACES = 63 }; /* where the error is largest */

/* ---- its error ---- */

static void made_at(const bat_sweep_fitting *f, double v, double *out)
{
    double basis[BATTEN_MAX_DEGREE + 1];
    const int q = f->degree;
    const int span = bat_knots_span(q, f->count, f->knots, v, BATTEN_FROM_RIGHT);
    bat_basis(q, f->knots, span, v, 0, basis);
    memset(out, 0, f->row * sizeof *out);
    for (int k = 0; k <= q; k++) {
        const double *from = f->rows + (size_t)(span - q + k) * f->row;
        for (size_t c = 0; c < f->row; c++)
            out[c] += basis[k] * from[c];
    }
}

/* With weights that are followed too: A'/w' - A/w is the mean, weighted by w', of what control
 * points miss and of (P - S)(w' - w) / w', where no two points are farther than `extent`. */
static double homogeneous_distance(const bat_sweep_fitting *f, const double *made,
                                   const double *truth)
{
    double worst = 0, least = HUGE_VAL, extent = 0;
    const double *first = truth;
    for (int i = 0; i < f->points; i++) {
        double p[3], q[3];
        const double w = made[4 * i + 3], w0 = truth[4 * i + 3];
        if (!(w > 0))
            return HUGE_VAL;
        for (int c = 0; c < 3; c++) {
            p[c] = truth[4 * i + c] / w0;
            q[c] = first[c] / first[3];
        }
        extent = bat_max(extent, 2 * bat_distance(3, p, q));
        least = bat_min(least, w);
    }
    for (int i = 0; i < f->points; i++) {
        const double w = made[4 * i + 3], w0 = truth[4 * i + 3];
        double p[3], q[3];
        for (int c = 0; c < 3; c++) {
            p[c] = made[4 * i + c] / w;
            q[c] = truth[4 * i + c] / w0;
        }
        worst = bat_max(worst, w * bat_distance(3, p, q) + extent * fabs(w - w0));
    }
    return worst / least;
}

/* No point of the section is farther off than this. */
static double distance_of_rows(const bat_sweep_fitting *f, const double *made,
                               const double *truth)
{
    double worst = 0;
    if (f->width == 4)
        return homogeneous_distance(f, made, truth);
    for (int i = 0; i < f->points; i++)
        worst = bat_max(worst, bat_distance(3, made + 3 * i, truth + 3 * i));
    return worst;
}

static batten_status measure_span(bat_sweep_fitting *f, int s, int places, double *error)
{
    *error = 0;
    for (int i = 0; i < places; i++) {
        const double t = (i + 0.5) / places;
        const double v = (1 - t) * f->mesh[s] + t * f->mesh[s + 1];
        const batten_status status =
            bat_sweep_rows(f->sweep, v, BATTEN_FROM_RIGHT, f->true_row);
        if (status != BATTEN_OK)
            return status;
        made_at(f, v, f->made_row);
        *error = bat_max(*error, distance_of_rows(f, f->made_row, f->true_row));
    }
    return BATTEN_OK;
}

batten_status bat_sweep_measure_spans(bat_sweep_fitting *f, int places)
{
    f->worst = 0;
    for (int s = 0; s + 1 < f->mesh_count; s++) {
        const batten_status status = measure_span(f, s, places, &f->error[s]);
        if (status != BATTEN_OK)
            return status;
        f->worst = bat_max(f->worst, f->error[s]);
    }
    return BATTEN_OK;
}

double bat_sweep_rounding(const bat_sweep_fitting *f)
{
    return 4 * DBL_EPSILON * f->size;
}

batten_status bat_sweep_measure_last(bat_sweep_fitting *f)
{
    batten_status status = bat_sweep_measure_spans(f, BAT_SWEEP_LAST_PLACES);
    const double found = f->worst;
    for (int s = 0; s + 1 < f->mesh_count && status == BATTEN_OK; s++) {
        double error = 0;
        if (f->error[s] < 0.5 * found)
            continue;
        status = measure_span(f, s, MOST_PLACES, &error);
        f->error[s] = bat_max(error, f->error[s]) + bat_max(0, error - f->error[s]);
        f->worst = bat_max(f->worst, f->error[s]);
    }
    f->worst += bat_sweep_rounding(f);
    return status;
}
