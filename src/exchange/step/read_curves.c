/* The curves of a STEP file. */
#include "body/lift.h"
#include "exchange/step/geometry.h"
#include "numeric/vector.h"
#include <batten/curve_offset.h>

#include <string.h>

/* ---- lines and conics ---- */

static batten_status check_positive(const bat_step_reading *reading,
                                    const bat_step_instance *instance, const char *what,
                                    double value)
{
    if (value > 0 && isfinite(value))
        return BATTEN_OK;
    return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                         "its %s is %g; it must be positive", what, value);
}

/* Of a line x measures the parameter; z is any direction across. */
static batten_status read_line(const bat_step_reading *reading, const bat_step_record *record,
                               bat_conic *conic)
{
    const bat_step_instance *point = NULL, *vector = NULL;
    double origin[3];
    batten_vec3 x = {0, 0, 0};
    batten_status status = bat_step_get_reference(reading->file, record, 1, &point);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(reading->file, record, 2, &vector);
    if (status == BATTEN_OK)
        status = bat_step_point_in(reading, point, origin);
    if (status == BATTEN_OK)
        status = bat_step_vector_in(reading, vector, &x);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 along = bat_vec3_scale(x, 1 / bat_vec3_norm(x));
    const batten_vec3 across = bat_vec3_cross(
        along, fabs(along.x) < 0.6 ? (batten_vec3){1, 0, 0} : (batten_vec3){0, 1, 0});
    *conic = (bat_conic){.kind = BAT_LINE,
                         .frame = {.origin = bat_vec3_of(3, origin),
                                   .x = x,
                                   .z = bat_vec3_scale(across, 1 / bat_vec3_norm(across))}};
    return BATTEN_OK;
}

/* KEYWORD(name, placement, a[, b]) */
typedef struct {
    const char *keyword;
    bat_conic_kind kind;
    int arguments;
    const char *what[2];
} conic_form;

static batten_status read_conic(const bat_step_reading *reading,
                                const bat_step_instance *instance,
                                const bat_step_record *record, const conic_form *form,
                                bat_conic *conic)
{
    const bat_step_instance *placement = NULL;
    bat_conic read = {.kind = form->kind};
    double measure[2] = {0, 0};
    batten_status status = bat_step_get_reference(reading->file, record, 1, &placement);
    if (status == BATTEN_OK)
        status = bat_step_frame_in(reading, placement, &read.frame);
    for (int k = 0; status == BATTEN_OK && k + 2 < form->arguments; k++) {
        status = bat_step_get_real(reading->file, record, 2 + k, &measure[k]);
        measure[k] *= reading->scale.length;
        if (status == BATTEN_OK)
            status = check_positive(reading, instance, form->what[k], measure[k]);
    }
    if (status != BATTEN_OK)
        return status;
    read.a = measure[0];
    read.b = form->arguments == 3 ? measure[0] : measure[1];
    *conic = read;
    return BATTEN_OK;
}

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

/* A SURFACE_CURVE stands for its 3-D curve, which may be one again. */
static batten_status resolve(const bat_step_reading *reading,
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

batten_status bat_step_conic_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, bat_conic *conic,
                                bool *is_conic)
{
    static const conic_form forms[] = {
        {"LINE", BAT_LINE, 3, {NULL, NULL}},
        {"CIRCLE", BAT_ELLIPSE, 3, {"radius", NULL}},
        {"ELLIPSE", BAT_ELLIPSE, 4, {"first half axis", "second half axis"}},
        {"PARABOLA", BAT_PARABOLA, 3, {"focal distance", NULL}},
        {"HYPERBOLA", BAT_HYPERBOLA, 4, {"half axis", "imaginary half axis"}},
    };
    batten_status status = resolve(reading, &instance);
    *is_conic = false;
    for (size_t k = 0; status == BATTEN_OK && k < sizeof forms / sizeof forms[0]; k++) {
        const bat_step_record *record = bat_step_as(reading->file, instance, forms[k].keyword);
        if (!record)
            continue;
        *is_conic = true;
        status = bat_step_check_arguments(reading->file, record, forms[k].arguments);
        if (status != BATTEN_OK)
            return status;
        return k == 0 ? read_line(reading, record, conic)
                      : read_conic(reading, instance, record, &forms[k], conic);
    }
    return status;
}

/* The part of a conic as a curve of the reading's dimension; t0 < t1. */
static batten_status conic_between(const bat_step_reading *reading,
                                   const bat_step_instance *instance, const bat_conic *conic,
                                   double t0, double t1, bool reversed, batten_curve **out)
{
    batten_curve *made = NULL, *turned = NULL;
    batten_status status = bat_conic_between(conic, t0, t1, &made);
    if (status == BATTEN_OK && reversed)
        status = batten_curve_reverse(made, &turned);
    const batten_curve *last = turned ? turned : made;
    if (status == BATTEN_OK && reading->dimension == 2)
        status = batten_curve_to_dimension(last, 2, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(last);
    batten_curve_unref(made);
    batten_curve_unref(turned);
    return bat_step_blame(reading->file, instance, status);
}

/* ---- parts ---- */

/* An angle for ellipses, in radians, else a number. */
static double conic_parameter(const bat_step_reading *reading, const bat_conic *conic, double t)
{
    return conic->kind == BAT_ELLIPSE ? t * reading->scale.angle : t;
}

/* From parameter t0 to t1 of the conic, with rising t when `forward`. */
static batten_status conic_part(const bat_step_reading *reading,
                                const bat_step_instance *instance, const bat_conic *conic,
                                double t0, double t1, bool forward, batten_curve **out)
{
    const double around = 2 * BAT_PI;
    double low = forward ? t0 : t1, high = forward ? t1 : t0;
    if (conic->kind != BAT_ELLIPSE)
        return conic_between(reading, instance, conic, bat_min(t0, t1), bat_max(t0, t1),
                             t1 < t0, out);
    if (!(fabs(low) < 1e6 && fabs(high) < 1e6))
        return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                             "the angles %g and %g are no angles of a part", t0, t1);
    high -= around * floor((high - low) / around);
    if (high - low < 1e-9 || high - low > around - 1e-9)
        high = low + around; /* the same place: all around */
    return conic_between(reading, instance, conic, low, high, !forward, out);
}

static batten_status reversed(batten_curve *curve, batten_curve **out)
{
    batten_status status = batten_curve_reverse(curve, out);
    batten_curve_unref(curve);
    return status;
}

static batten_status spline_part(const bat_step_reading *reading,
                                 const bat_step_instance *instance, const batten_curve *curve,
                                 double t0, double t1, bool forward, batten_curve **out)
{
    const batten_interval domain = batten_curve_domain(curve);
    const double slack = 1e-9 * (domain.b - domain.a);
    const double low = forward ? t0 : t1, high = forward ? t1 : t0;
    batten_curve *part = NULL;
    if (!(bat_min(t0, t1) >= domain.a - slack && bat_max(t0, t1) <= domain.b + slack))
        return bat_step_fail(reading->file, instance, BATTEN_OUT_OF_DOMAIN,
                             "the part from %g to %g is not in its domain from %g to %g", t0,
                             t1, domain.a, domain.b);
    const double a = bat_max(low, domain.a), b = bat_min(high, domain.b);
    batten_status status = BATTEN_OK;
    if (a < b) {
        status = batten_curve_subrange(curve, a, b, &part);
    } else if (batten_curve_is_closed(curve, reading->scale.tolerance) && domain.a < b &&
               a < domain.b) { /* over the ends */
        batten_curve *first = NULL, *second = NULL;
        status = batten_curve_subrange(curve, a, domain.b, &first);
        if (status == BATTEN_OK)
            status = batten_curve_subrange(curve, domain.a, b, &second);
        if (status == BATTEN_OK)
            status = batten_curve_join(first, second, reading->scale.tolerance, &part);
        batten_curve_unref(first);
        batten_curve_unref(second);
    } else { /* the wrong sense: the order of the ends counts */
        status =
            batten_curve_subrange(curve, bat_max(b, domain.a), bat_min(a, domain.b), &part);
        forward = !forward;
    }
    if (status == BATTEN_OK && forward)
        *out = part;
    else if (status == BATTEN_OK)
        status = reversed(part, out);
    return bat_step_blame(reading->file, instance, status);
}

/* Are the parameters of the curve that is made those of the file? */
static bool has_own_parameters(const bat_step_file *file, const bat_step_instance *instance)
{
    static const char *const keywords[] = {"B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE",
                                           "UNIFORM_CURVE", "QUASI_UNIFORM_CURVE", "POLYLINE"};
    for (size_t k = 0; k < sizeof keywords / sizeof keywords[0]; k++)
        if (bat_step_as(file, instance, keywords[k]))
            return true;
    return false;
}

batten_status bat_step_curve_between(const bat_step_reading *reading,
                                     const bat_step_instance *instance, double t0, double t1,
                                     bool forward, batten_curve **out)
{
    bat_conic conic;
    bool is_conic = false;
    batten_curve *whole = NULL;
    batten_status status = resolve(reading, &instance);
    if (status == BATTEN_OK)
        status = bat_step_conic_in(reading, instance, &conic, &is_conic);
    if (status != BATTEN_OK)
        return status;
    if (is_conic)
        return conic_part(reading, instance, &conic, conic_parameter(reading, &conic, t0),
                          conic_parameter(reading, &conic, t1), forward, out);
    if (!has_own_parameters(reading->file, instance))
        return bat_step_fail(reading->file, instance, BATTEN_UNSUPPORTED,
                             "its part between parameters is not read");
    status = bat_step_curve_in(reading, instance, &whole);
    if (status == BATTEN_OK)
        status = spline_part(reading, instance, whole, t0, t1, forward, out);
    batten_curve_unref(whole);
    return status;
}

/* ---- trimmed curves ---- */

/* An end of a trimmed curve: a point, a parameter or both. */
typedef struct {
    bool has_point, has_parameter;
    double point[3], parameter;
} trim;

static batten_status read_trim(const bat_step_reading *reading, const bat_step_record *record,
                               int k, trim *t)
{
    const bat_step_file *file = reading->file;
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(file, record, k, &count, &at);
    *t = (trim){.has_point = false};
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        if (bat_step_value_at(file, at).kind == BAT_STEP_REFERENCE) {
            const bat_step_instance *point = NULL;
            status = bat_step_item_reference(file, record, &at, &point);
            if (status == BATTEN_OK)
                status = bat_step_point_in(reading, point, t->point);
            t->has_point = true;
        } else {
            status = bat_step_item_real(file, record, &at, &t->parameter);
            t->has_parameter = true;
        }
    }
    return status;
}

/* A point that is not on its curve is noted. */
static void note_miss(const bat_step_reading *reading, const bat_step_instance *instance,
                      double miss)
{
    const bat_input *input = reading->file->input;
    if (miss > reading->scale.tolerance)
        batten_notes_add(input->notes, input->file, bat_step_line(reading->file, instance->at),
                         "", "#%llu: an end is %g off the curve; it ends at the foot",
                         (unsigned long long)instance->id, miss);
}

static batten_status between_points(const bat_step_reading *reading,
                                    const bat_step_instance *instance,
                                    const bat_step_instance *basis, const trim ends[2],
                                    bool forward, batten_curve **out)
{
    bat_conic conic;
    bool is_conic = false;
    batten_curve *whole = NULL;
    double miss = 0, at[3], t[2];
    batten_status status = bat_step_conic_in(reading, basis, &conic, &is_conic);
    if (status == BATTEN_OK && is_conic) {
        for (int k = 0; k < 2; k++) {
            t[k] = bat_conic_parameter(&conic, ends[k].point);
            bat_conic_point(&conic, t[k], at);
            miss = bat_max(miss, bat_distance(3, at, ends[k].point));
        }
        note_miss(reading, instance, miss);
        if (bat_distance(3, ends[0].point, ends[1].point) <= reading->scale.tolerance)
            t[1] = t[0];
        return conic_part(reading, instance, &conic, t[0], t[1], forward, out);
    }
    if (status == BATTEN_OK && reading->dimension != 3)
        status =
            bat_step_fail(reading->file, instance, BATTEN_UNSUPPORTED,
                          "between points, in the parameters of a surface, it is not read");
    if (status == BATTEN_OK)
        status = bat_step_curve_in(reading, basis, &whole);
    if (status == BATTEN_OK)
        status = bat_step_blame(reading->file, instance,
                                bat_curve_part(whole, ends[0].point, ends[1].point, forward,
                                               reading->scale.tolerance, out, &miss));
    if (status == BATTEN_OK)
        note_miss(reading, instance, miss);
    batten_curve_unref(whole);
    return status;
}

/* TRIMMED_CURVE(name, basis, (end), (end), sense, what counts) */
static batten_status read_trimmed(const bat_step_reading *reading,
                                  const bat_step_instance *instance,
                                  const bat_step_record *record, batten_curve **out)
{
    const bat_step_instance *basis = NULL;
    trim ends[2];
    bool forward = true;
    batten_status status = bat_step_check_arguments(reading->file, record, 6);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(reading->file, record, 1, &basis);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = read_trim(reading, record, 2 + k, &ends[k]);
    if (status == BATTEN_OK)
        status = bat_step_get_logical(reading->file, record, 4, &forward);
    if (status != BATTEN_OK)
        return status;
    const bool have_points = ends[0].has_point && ends[1].has_point;
    const bool have_parameters = ends[0].has_parameter && ends[1].has_parameter;
    if (!have_points && !have_parameters)
        return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                             "its ends are neither two points nor two parameters");
    if (have_points && (!have_parameters || bat_step_is(reading->file, record, 5, "CARTESIAN")))
        return between_points(reading, instance, basis, ends, forward, out);
    return bat_step_curve_between(reading, basis, ends[0].parameter, ends[1].parameter, forward,
                                  out);
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
                               "it has %d points, and needs two", count);
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
        status = bat_fail(BATTEN_SINGULAR_HERE, "its offset by %g is %d curves", distance,
                          made.count);
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
} curves[] = {{"TRIMMED_CURVE", read_trimmed, true},
              {"POLYLINE", read_polyline, true},
              {"COMPOSITE_CURVE", bat_step_composite, true},
              {"COMPOSITE_CURVE_ON_SURFACE", bat_step_composite, false},
              {"BOUNDARY_CURVE", bat_step_composite, false},
              {"OUTER_BOUNDARY_CURVE", bat_step_composite, false},
              {"OFFSET_CURVE_3D", read_offset, false},
              {"PCURVE", read_on_surface, false}};

static batten_status read_whole_conic(const bat_step_reading *reading,
                                      const bat_step_instance *instance, const bat_conic *conic,
                                      batten_curve **out)
{
    if (conic->kind != BAT_ELLIPSE)
        return bat_step_fail(reading->file, instance, BATTEN_NOT_COMPATIBLE, "it has no ends");
    return conic_between(reading, instance, conic, 0, 2 * BAT_PI, false, out);
}

batten_status bat_step_curve_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, batten_curve **out)
{
    bat_step_reading inner;
    bat_conic conic;
    bool is_it = false;
    batten_status status = bat_step_deeper(reading, instance, &inner);
    if (status == BATTEN_OK)
        status = resolve(&inner, &instance);
    if (status == BATTEN_OK)
        status = bat_step_spline_curve(&inner, instance, out, &is_it);
    if (status != BATTEN_OK || is_it)
        return status;
    status = bat_step_conic_in(&inner, instance, &conic, &is_it);
    if (status == BATTEN_OK && is_it)
        status = read_whole_conic(&inner, instance, &conic, out);
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
