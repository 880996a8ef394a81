/* The chord of an aerofoil: its nose, and the points turned so that it lies on the x axis. */
#include "base/elementary.h"
#include "numeric/vector.h"
#include "shape/aerofoil/aerofoil.h"

#include <batten/interpolate.h>

static batten_status find_tail(const batten_curve *curve, double tail[2])
{
    const batten_interval domain = batten_curve_domain(curve);
    double ends[2][2];
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, ends[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, domain.b, 0, ends[1]);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        tail[k] = (ends[0][k] + ends[1][k]) / 2;
    return status;
}

/* Half the derivative of the squared distance from the tail. */
static batten_status find_slope(const batten_curve *curve, const double tail[2], double u,
                                double *slope)
{
    double at[2][2];
    const batten_status status = batten_curve_evaluate(curve, u, 1, at[0]);
    if (status == BATTEN_OK)
        *slope = (at[0][0] - tail[0]) * at[1][0] + (at[0][1] - tail[1]) * at[1][1];
    return status;
}

/* Halve an interval where the distance rises first and falls last, down to rounding. */
static batten_status refine_nose(const batten_curve *curve, const double tail[2], double low,
                                 double high, double *nose)
{
    batten_status status = BATTEN_OK;
    double middle = low + (high - low) / 2;
    while (status == BATTEN_OK && low < middle && middle < high) {
        double slope = 0;
        status = find_slope(curve, tail, middle, &slope);
        if (slope > 0)
            low = middle;
        else
            high = middle;
        middle = low + (high - low) / 2;
    }
    *nose = middle;
    return status;
}

batten_status bat_aerofoil_nose(const batten_curve *curve, double *nose, double *chord)
{
    /* Within a span a cubic turns little: the farthest of these lies beside the nose. */
    enum { PLACES = 8 };
    const batten_interval domain = batten_curve_domain(curve);
    const int count = PLACES * batten_curve_knot_count(curve);
    const double step = (domain.b - domain.a) / count;
    double tail[2], at[2], far = -1, beside = domain.a;
    batten_status status = find_tail(curve, tail);
    for (int i = 1; i < count && status == BATTEN_OK; i++) {
        const double u = domain.a + i * step;
        status = batten_curve_evaluate(curve, u, 0, at);
        if (status == BATTEN_OK && bat_distance(2, at, tail) > far) {
            far = bat_distance(2, at, tail);
            beside = u;
        }
    }
    if (status == BATTEN_OK)
        status = refine_nose(curve, tail, bat_max(domain.a, beside - step),
                             bat_min(domain.b, beside + step), nose);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, *nose, 0, at);
    if (status == BATTEN_OK)
        *chord = bat_distance(2, at, tail);
    return status;
}

/* Twice the area within the points. */
static double find_area(const bat_aerofoil_row *row)
{
    double sum = 0;
    for (int i = 0; i < row->count; i++) {
        const double *p = row->points[i], *q = row->points[(i + 1) % row->count];
        sum += p[0] * q[1] - p[1] * q[0];
    }
    return sum;
}

/* A nose on the right comes to the left as in a mirror, so that the upper side stays above. */
static void turn_points(bat_aerofoil_row *row, const double nose[2], const double tail[2],
                        batten_curve_aerofoil_report *report)
{
    const double chord = bat_distance(2, nose, tail);
    report->mirrored = tail[0] < nose[0];
    const double hand = report->mirrored ? -1 : 1;
    const double x = hand * (tail[0] - nose[0]) / chord, y = (tail[1] - nose[1]) / chord;
    report->turn = bat_atan2(y, x);
    for (int i = 0; i < row->count; i++) {
        double *p = row->points[i];
        const double dx = hand * (p[0] - nose[0]) / chord, dy = (p[1] - nose[1]) / chord;
        p[0] = dx * x + dy * y;
        p[1] = dy * x - dx * y;
    }
    report->reversed = find_area(row) < 0;
    if (report->reversed)
        bat_aerofoil_reverse(row, row->count);
}

static batten_status interpolate_row(bat_aerofoil_row *row, batten_curve **out)
{
    return batten_curve_interpolate((batten_points){2, row->count, row->points[0]}, NULL,
                                    row->at, out);
}

batten_status bat_aerofoil_normalise(bat_aerofoil_row *row, batten_curve **spline,
                                     bat_aerofoil_sides *sides,
                                     batten_curve_aerofoil_report *report)
{
    batten_curve *given = NULL, *made = NULL;
    double nose = 0, at[2], tail[2];
    batten_status status = interpolate_row(row, &given);
    if (status == BATTEN_OK)
        status = bat_aerofoil_nose(given, &nose, &report->given.chord);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(given, nose, 0, at);
    if (status == BATTEN_OK)
        status = find_tail(given, tail);
    batten_curve_unref(given);
    if (status != BATTEN_OK)
        return status;
    turn_points(row, at, tail, report);
    status = interpolate_row(row, &made);
    if (status == BATTEN_OK)
        status = bat_aerofoil_nose(made, &sides->nose, &nose);
    if (status != BATTEN_OK) {
        batten_curve_unref(made);
        return status;
    }
    *spline = made;
    sides->curve = made;
    sides->start = batten_curve_domain(made).a;
    sides->end = batten_curve_domain(made).b;
    sides->reach[0] = row->points[0][0];
    sides->reach[1] = row->points[row->count - 1][0];
    return BATTEN_OK;
}
