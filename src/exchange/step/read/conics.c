/* The lines and conics of a STEP file, whole and in part. */
#include "exchange/step/read/geometry.h"
#include "numeric/vector.h"

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
    batten_status status = bat_step_resolve(reading, &instance);
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

double bat_step_conic_parameter(const bat_step_reading *reading, const bat_conic *conic,
                                double t)
{
    return conic->kind == BAT_ELLIPSE ? t * reading->scale.angle : t;
}

batten_status bat_step_conic_part(const bat_step_reading *reading,
                                  const bat_step_instance *instance, const bat_conic *conic,
                                  double t0, double t1, bool forward, batten_curve **out)
{
    const double around = 2 * BAT_PI;
    double low = forward ? t0 : t1, high = forward ? t1 : t0;
    if (conic->kind != BAT_ELLIPSE)
        return conic_between(reading, instance, conic, bat_min(t0, t1), bat_max(t0, t1),
                             t1 < t0, out);
    /* An angle of a million radians has lost ten of its digits, and means nothing. */
    if (!(fabs(low) < 1e6 && fabs(high) < 1e6))
        return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                             "the angles %g and %g do not bound a part", t0, t1);
    high -= around * floor((high - low) / around);
    if (high - low < BAT_WRITTEN || high - low > around - BAT_WRITTEN)
        high = low + around; /* the same place: all around */
    return conic_between(reading, instance, conic, low, high, !forward, out);
}

batten_status bat_step_whole_conic(const bat_step_reading *reading,
                                   const bat_step_instance *instance, const bat_conic *conic,
                                   batten_curve **out)
{
    if (conic->kind != BAT_ELLIPSE)
        return bat_step_fail(reading->file, instance, BATTEN_NOT_COMPATIBLE, "it has no ends");
    return conic_between(reading, instance, conic, 0, 2 * BAT_PI, false, out);
}
