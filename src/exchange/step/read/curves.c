/* Polylines, offsets, and curves in the parameters of a surface. */
#include "base/plural.h"
#include "body/trace/lift.h"
#include "exchange/step/read/geometry.h"
#include "numeric/vector.h"
#include <batten/offset.h>

/* The parameter of a POLYLINE is 0, 1, 2 ... at its points. */
batten_status bat_step_polyline(const bat_step_reading *reading,
                                const bat_step_instance *instance,
                                const bat_step_record *record, batten_curve **out)
{
    bat_input *input = reading->file->input;
    int count = 0;
    size_t at = 0;
    double *points = NULL, *knots = NULL;
    batten_status status = bat_step_check_arguments(reading->file, record, 2);
    if (status == BATTEN_OK)
        status = bat_step_get_list(reading->file, record, 1, &count, &at);
    if (status == BATTEN_OK && count < 2)
        status = bat_step_fail(reading->file, instance, BATTEN_TOO_FEW_POINTS,
                               "it has %d point%s, and needs two", count, bat_plural(count));
    if (status == BATTEN_OK)
        status = bat_input_limit(input, 0, (size_t)count, input->limits.points,
                                 "points in an object");
    if (status == BATTEN_OK)
        status = bat_input_array(input, (size_t)count * (size_t)reading->dimension,
                                 sizeof *points, &points);
    if (status == BATTEN_OK)
        status = bat_input_array(input, (size_t)count + 2, sizeof *knots, &knots);
    if (status == BATTEN_OK)
        status = bat_step_points_in(reading, record, &at, count, points);
    if (status == BATTEN_OK) {
        for (int i = 0; i < count + 2; i++)
            knots[i] = bat_min_int(bat_max_int(i - 1, 0), count - 1);
        status = bat_step_blame(
            reading->file, instance,
            batten_curve_create((batten_points){reading->dimension, count, points}, 1, NULL,
                                knots, out));
    }
    bat_input_release(input, (size_t)count * (size_t)reading->dimension, sizeof *points,
                      points);
    bat_input_release(input, (size_t)count + 2, sizeof *knots, knots);
    return status;
}

/* OFFSET_CURVE_3D(name, basis, distance, self_intersect, V): along V x T. */
batten_status bat_step_offset_curve(const bat_step_reading *reading,
                                    const bat_step_instance *instance,
                                    const bat_step_record *record, batten_curve **out)
{
    const bat_step_instance *basis = NULL, *across = NULL;
    double distance = 0;
    batten_curve_offset_options options = batten_curve_offset_defaults();
    batten_curve_offset_report report;
    batten_curves made = {0, NULL};
    batten_curve *base = NULL;
    batten_status status = bat_step_check_arguments(reading->file, record, 5);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(reading->file, record, 1, &basis);
    if (status == BATTEN_OK)
        status = bat_step_get_real(reading->file, record, 2, &distance);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(reading->file, record, 4, &across);
    if (status == BATTEN_OK)
        status = bat_step_direction_in(reading, across, &options.normal);
    if (status == BATTEN_OK)
        status = bat_step_curve_in(reading, basis, &base);
    if (status != BATTEN_OK)
        return status;
    options.tolerance = reading->scale.tolerance;
    options.loops = BATTEN_LOOPS_KEEP;
    options.most_pieces =
        bat_input_most_near(reading->file->input, batten_curve_point_count(base));
    status =
        batten_curve_offset(base, distance * reading->scale.length, &options, &report, &made);
    if (status == BATTEN_OK && made.count != 1)
        status = bat_fail(BATTEN_SINGULAR_HERE, "its offset by %g is %d curve%s", distance,
                          made.count, bat_plural(made.count));
    if (status == BATTEN_OK)
        *out = batten_curve_ref(made.at[0]);
    batten_curves_release(&made);
    batten_curve_unref(base);
    return bat_step_blame(reading->file, instance, status);
}

/* A PCURVE as a curve in space; the parameters are known of B-spline surfaces alone. */
batten_status bat_step_curve_on_surface(const bat_step_reading *reading,
                                        const bat_step_instance *instance,
                                        const bat_step_record *record, batten_curve **out)
{
    const bat_step_instance *on = NULL;
    batten_curve *parameters = NULL;
    batten_surface *surface = NULL;
    batten_status status = bat_step_get_reference(
        reading->file, record, bat_step_pcurve_surface(reading->file, record), &on);
    if (status == BATTEN_OK)
        status = bat_step_pcurve_in(reading, instance, on, &parameters);
    if (status == BATTEN_OK && !parameters)
        status = bat_step_fail(reading->file, instance, BATTEN_UNSUPPORTED,
                               "a curve in the parameters of such a surface is not read");
    if (status == BATTEN_OK)
        status = bat_step_surface_in(reading, on, &surface);
    if (status == BATTEN_OK)
        status =
            bat_step_blame(reading->file, instance,
                           bat_lift(surface, parameters, reading->scale.tolerance, out, NULL));
    batten_curve_unref(parameters);
    batten_surface_unref(surface);
    return status;
}
