/* The methods of 'fair' that move control points of a curve: what the curve passed before it may miss by the bound. */
#include "design/features/change/fair.h"

#include <string.h>

/* Control points [count][dimension] back into the plane, or space, of the curve they are from. */
static batten_status lift_curve(const batten_curve *from, const batten_curve *plane, int axis,
                                batten_curve **out)
{
    const int wrapped = batten_curve_point_count(from), degree = batten_curve_degree(from);
    const bool periodic = batten_curve_is_periodic(from);
    double *points = bat_array3((size_t)wrapped, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(points, batten_curve_points(from), 3 * (size_t)wrapped * sizeof *points);
    bat_points_from_plane(axis, wrapped, batten_curve_points(plane), points);
    const batten_points all = {3, periodic ? wrapped - degree : wrapped, points};
    const double *knots = batten_curve_knots(from);
    const batten_status status =
        periodic ? batten_curve_create_periodic(all, degree, NULL, knots + degree, out)
                 : batten_curve_create(all, degree, NULL, knots, out);
    bat_release(points);
    return status;
}

/* Of a curve in a plane two coordinates are made fair, for in space there are no inflections. */
static batten_status fair_net(const bat_run *run, const batten_curve *curve, int axis,
                              batten_fair_report *report, batten_curve **out)
{
    batten_curve_fair_options options = batten_curve_fair_defaults(bat_number(run, "within"));
    batten_curve *plane = NULL, *made = NULL;
    options.method =
        (batten_curve_fair_method)(bat_word(run, "method") - BAT_METHODS_OF_POINTS);
    options.hold = bat_yes(run, "hold-ends");
    if (axis < 0)
        return batten_curve_fair(curve, &options, run->job, report, out);
    batten_status status = bat_curve_in_plane(curve, axis, &plane);
    if (status == BATTEN_OK)
        status = batten_curve_fair(plane, &options, run->job, report, &made);
    if (status == BATTEN_OK)
        status = lift_curve(curve, made, axis, out);
    const double height = batten_curve_points(curve)[axis];
    bat_fair_lift_moves(axis, height, report->moves, report->move_count);
    batten_curve_unref(plane);
    batten_curve_unref(made);
    return status;
}

batten_status bat_fair_control_points(bat_run *run, const batten_object *object, int set)
{
    const int count = batten_curve_point_count(object->curve);
    batten_fair_report report = {0};
    batten_curve *curve = NULL;
    batten_status status =
        fair_net(run, object->curve, bat_flat_axis(count, batten_curve_points(object->curve)),
                 &report, &curve);
    if (status == BATTEN_OK)
        status = bat_fair_add_report(&run->result->fairing, &report, set, count);
    else if (status != BATTEN_OUT_OF_MEMORY && status != BATTEN_CANCELLED)
        status = bat_fail(status, "'%s': %s", object->name, batten_message());
    status = bat_put_curve_like(run, status, curve, object, true);
    batten_fair_report_release(&report);
    return status;
}
