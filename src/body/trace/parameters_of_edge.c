/* The parameter curve of an edge by the first way that does: the given one kept, exact in a
 * plane, straight, or by following the edge. */
#include "body/trace/parameters.h"
#include "spline/curve/curve.h"

/* NOT_FOUND when it is no good. */
static batten_status keep_given(const bat_chart *chart, const batten_curve *curve,
                                const batten_curve *given, batten_curve **out, double *miss)
{
    const batten_interval on = batten_curve_domain(curve), of = batten_curve_domain(given);
    batten_curve *made = NULL;
    batten_status status = batten_curve_clamp(given, &made);
    if (status == BATTEN_OK && (of.a != on.a || of.b != on.b)) {
        batten_curve *mapped = NULL;
        status = batten_curve_set_domain(made, on.a, on.b, &mapped);
        status = bat_curve_replace(status, &made, &mapped);
    }
    if (status == BATTEN_OK && !bat_parameters_inside(chart, made))
        status = BATTEN_NOT_FOUND;
    if (status == BATTEN_OK)
        status = bat_parameters_miss(chart, curve, made, chart->tolerance, miss);
    if (status == BATTEN_OK && *miss > chart->tolerance)
        status = BATTEN_NOT_FOUND;
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_curve_unref(made);
    return status == BATTEN_BAD_KNOTS ? BATTEN_NOT_FOUND : status;
}

batten_status bat_parameters_of_edge(bat_chart *chart, const batten_curve *curve,
                                     const batten_curve *given, const double *guess,
                                     batten_curve **out, bool *kept, double *miss)
{
    batten_status status = BATTEN_NOT_FOUND;
    *kept = false;
    if (given) {
        status = keep_given(chart, curve, given, out, miss);
        *kept = status == BATTEN_OK;
    }
    if (status == BATTEN_NOT_FOUND)
        status = bat_parameters_in_plane(chart, curve, out, miss);
    if (status == BATTEN_NOT_FOUND)
        status = bat_parameters_straight(chart, curve, guess, out, miss);
    if (status == BATTEN_NOT_FOUND)
        status = bat_parameters_follow(chart, curve, guess, out, miss);
    return status;
}
