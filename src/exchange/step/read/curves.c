/* The curves of a STEP file. */
#include "base/plural.h"
#include "body/trace/lift.h"
#include "exchange/step/read/geometry.h"
#include "numeric/vector.h"
#include <batten/offset.h>

/* ---- curves on surfaces ---- */

static bool is_surface_curve(const bat_step_file *file, const bat_step_instance *instance,
                             const bat_step_record **record)
{
    static const char *const keywords[] = {"SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE",
                                           "BOUNDED_SURFACE_CURVE"};
    for (size_t k = 0; k < sizeof keywords / sizeof keywords[0]; k++) {
        *record = bat_step_as(file, instance, keywords[k]);
        if (*record)
            return true;
    }
    return false;
}

batten_status bat_step_resolve(const bat_step_reading *reading,
                               const bat_step_instance **instance)
{
    const bat_step_record *record = NULL;
    bat_step_reading inner = *reading, next;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && is_surface_curve(reading->file, *instance, &record)) {
        status = bat_step_deeper(&inner, *instance, &next);
        inner = next;
        if (status == BATTEN_OK)
            status = bat_step_get_reference(reading->file, record, 1, instance);
    }
    return status;
}

/* ---- other curves ---- */

/* The parameter of a POLYLINE is 0, 1, 2 ... at its points. */
static batten_status read_polyline(const bat_step_reading *reading,
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
            batten_curve_create(reading->dimension, 1, count, points, NULL, knots, out));
    }
    bat_input_release(input, (size_t)count * (size_t)reading->dimension, sizeof *points,
                      points);
    bat_input_release(input, (size_t)count + 2, sizeof *knots, knots);
    return status;
}

/* OFFSET_CURVE_3D(name, basis, distance, self_intersect, V): along V x T. */
static batten_status read_offset(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_record *record, batten_curve **out)
{
    const bat_step_instance *basis = NULL, *across = NULL;
    double distance = 0;
    batten_offset_options options = batten_offset_defaults();
    batten_offset_report report;
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
static batten_status read_on_surface(const bat_step_reading *reading,
                                     const bat_step_instance *instance,
                                     const bat_step_record *record, batten_curve **out)
{
    const bat_step_instance *on = NULL;
    batten_curve *parameters = NULL;
    batten_surface *surface = NULL;
    batten_status status = bat_step_get_reference(reading->file, record, 1, &on);
    if (status == BATTEN_OK)
        status =
            bat_step_read_pcurve(reading->file, instance, on, &reading->scale, &parameters);
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

/* ---- any curve ---- */

typedef batten_status read_curve(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_record *record, batten_curve **out);

static const struct {
    const char *keyword;
    read_curve *read;
    bool in_plane;
} curves[] = {{"TRIMMED_CURVE", bat_step_trimmed, true},
              {"POLYLINE", read_polyline, true},
              {"COMPOSITE_CURVE", bat_step_composite, true},
              {"COMPOSITE_CURVE_ON_SURFACE", bat_step_composite, false},
              {"BOUNDARY_CURVE", bat_step_composite, false},
              {"OUTER_BOUNDARY_CURVE", bat_step_composite, false},
              {"OFFSET_CURVE_3D", read_offset, false},
              {"PCURVE", read_on_surface, false}};

batten_status bat_step_curve_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, batten_curve **out)
{
    bat_step_reading inner;
    bat_conic conic;
    bool is_it = false;
    batten_status status = bat_step_deeper(reading, instance, &inner);
    if (status == BATTEN_OK)
        status = bat_step_resolve(&inner, &instance);
    if (status == BATTEN_OK)
        status = bat_step_spline_curve(&inner, instance, out, &is_it);
    if (status != BATTEN_OK || is_it)
        return status;
    status = bat_step_conic_in(&inner, instance, &conic, &is_it);
    if (status == BATTEN_OK && is_it)
        status = bat_step_whole_conic(&inner, instance, &conic, out);
    if (status != BATTEN_OK || is_it)
        return status;
    for (size_t k = 0; k < sizeof curves / sizeof curves[0]; k++) {
        const bat_step_record *record = bat_step_as(reading->file, instance, curves[k].keyword);
        if (record && (curves[k].in_plane || reading->dimension == 3))
            return curves[k].read(&inner, instance, record, out);
    }
    return bat_step_fail(reading->file, instance, BATTEN_UNSUPPORTED,
                         "it is no curve that is read");
}

/* ---- for other files ---- */

batten_status bat_step_as_conic(const bat_step_file *file, const bat_step_instance *instance,
                                const bat_step_scale *scale, bat_conic *conic, bool *is_conic)
{
    const bat_step_reading reading = bat_step_reading_of(file, scale);
    return bat_step_conic_in(&reading, instance, conic, is_conic);
}

batten_status bat_step_read_curve(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, batten_curve **out)
{
    const bat_step_reading reading = bat_step_reading_of(file, scale);
    return bat_step_curve_in(&reading, instance, out);
}

/* The PCURVE on a surface that an instance is or has; NULL when there is none. */
static batten_status find_pcurve(const bat_step_file *file, const bat_step_instance *instance,
                                 const bat_step_instance *surface, const bat_step_record **out)
{
    const bat_step_record *record = bat_step_as(file, instance, "PCURVE"), *of = NULL;
    const bat_step_instance *on = NULL, *item = instance;
    int count = 1;
    size_t at = 0;
    batten_status status = BATTEN_OK;
    *out = NULL;
    if (!record && is_surface_curve(file, instance, &of))
        status = bat_step_get_list(file, of, 2, &count, &at);
    for (int i = 0; status == BATTEN_OK && i < count && !*out; i++) {
        if (of)
            status = bat_step_item_reference(file, of, &at, &item);
        if (status != BATTEN_OK)
            break;
        record = bat_step_as(file, item, "PCURVE");
        if (record)
            status = bat_step_get_reference(file, record, 1, &on);
        if (status == BATTEN_OK && record && on == surface)
            *out = record;
    }
    return status;
}

batten_status bat_step_read_pcurve(const bat_step_file *file, const bat_step_instance *instance,
                                   const bat_step_instance *surface,
                                   const bat_step_scale *scale, batten_curve **out)
{
    bat_step_reading reading = bat_step_reading_of(file, scale);
    const bat_step_record *pcurve = NULL, *definition = NULL;
    const bat_step_instance *curve = NULL;
    int count = 0;
    size_t at = 0;
    reading.dimension = 2;
    reading.scale.length = 1;
    if (!bat_step_is_spline_surface(file, surface))
        return BATTEN_OK;
    batten_status status = find_pcurve(file, instance, surface, &pcurve);
    if (status != BATTEN_OK || !pcurve)
        return status;
    status = bat_step_get_record(file, pcurve, 2, "DEFINITIONAL_REPRESENTATION", &definition);
    if (status == BATTEN_OK)
        status = bat_step_get_list(file, definition, 1, &count, &at);
    if (status == BATTEN_OK)
        status = bat_step_item_reference(file, definition, &at, &curve);
    if (status == BATTEN_OK)
        status = bat_step_curve_in(&reading, curve, out);
    return status == BATTEN_NOT_COMPATIBLE ? BATTEN_OK : status; /* a line has no ends */
}
