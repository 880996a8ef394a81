/* Parts of the curves of a STEP file: between parameters or points, and trimmed curves. */
#include "exchange/step/read/geometry.h"
#include "numeric/vector.h"

/* ---- between parameters ---- */

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
    const double slack = BAT_WRITTEN * (domain.b - domain.a);
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
    batten_status status = bat_step_resolve(reading, &instance);
    if (status == BATTEN_OK)
        status = bat_step_conic_in(reading, instance, &conic, &is_conic);
    if (status != BATTEN_OK)
        return status;
    if (is_conic)
        return bat_step_conic_part(reading, instance, &conic,
                                   bat_step_conic_parameter(reading, &conic, t0),
                                   bat_step_conic_parameter(reading, &conic, t1), forward, out);
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
                         "", "#%llu: an end is %g off the curve; it ends at the nearest point",
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
        return bat_step_conic_part(reading, instance, &conic, t[0], t[1], forward, out);
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

batten_status bat_step_trimmed(const bat_step_reading *reading,
                               const bat_step_instance *instance, const bat_step_record *record,
                               batten_curve **out)
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
