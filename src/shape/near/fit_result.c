/* What comes out of a least squares fit: residuals, what is undetermined, the curve, its report. */
#include "numeric/vector.h"
#include "shape/near/approximate.h"

/* ---- what came out ---- */

void bat_fit_residuals(const bat_fit *fit, const double *control, double *residuals)
{
    const int d = fit->dimension, width = fit->data.width;
    for (int i = 0; i < fit->data_count; i++) {
        const double *row = fit->data.values + (size_t)i * (size_t)width;
        double *r = residuals + (size_t)i * (size_t)d;
        for (int c = 0; c < d; c++)
            r[c] = -fit->points[(size_t)i * (size_t)d + (size_t)c];
        for (int k = 0; k < width; k++) {
            const int j = (fit->data.first[i] + k) % fit->count;
            for (int c = 0; c < d; c++)
                r[c] += row[k] * control[(size_t)j * (size_t)d + (size_t)c];
        }
    }
}

/* Take the data as they come and give each control value the first that bears on it. */
int bat_fit_undetermined(const bat_fit *fit)
{
    const int width = fit->data.width;
    int datum = 0;
    double last = -INFINITY;
    for (int j = 0; j < fit->count; j++) {
        if ((j == 0 && fit->fixed[0]) || (j == fit->count - 1 && fit->fixed[1]))
            continue;
        for (;; datum++) {
            if (datum == fit->data_count || fit->data.first[datum] > j)
                return j;
            const int k = j - fit->data.first[datum];
            const bool bears =
                k < width && fit->data.values[(size_t)datum * (size_t)width + (size_t)k] > 0;
            if (bears && fit->factors[datum] > 0 && fit->parameters[datum] > last)
                break;
        }
        last = fit->parameters[datum];
    }
    return -1;
}

batten_status bat_fit_curve(const bat_fit *fit, const double *control, batten_curve **out)
{
    return fit->periodic
               ? batten_curve_create_periodic(
                     (batten_points){fit->dimension, fit->count, control}, fit->degree, NULL,
                     fit->knots, out)
               : batten_curve_create((batten_points){fit->dimension, fit->count, control},
                                     fit->degree, NULL, fit->knots, out);
}

void bat_fit_measure(const bat_fit *fit, const double *residuals, batten_fit_report *report)
{
    const int d = fit->dimension;
    double squares = 0, sum = 0;
    int count = 0;
    report->error = 0;
    report->worst = 0;
    for (int i = 0; i < fit->data_count; i++) {
        if (!(fit->factors[i] > 0))
            continue;
        const double distance = bat_norm(d, residuals + (size_t)i * (size_t)d);
        if (distance > report->error) {
            report->error = distance;
            report->worst = i;
        }
        squares += distance * distance;
        sum += fit->factors[i] * fit->factors[i] * distance * distance;
        count++;
    }
    report->rms = count > 0 ? sqrt(squares / count) : 0;
    report->sum = sum;
}
