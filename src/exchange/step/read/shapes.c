/*
 * Any curve and any surface of a STEP file: which keyword is read by whom. Curves and surfaces
 * stand on others of any kind, so their readers are handed `makers` to ask for those.
 */
#include "exchange/step/read/geometry.h"

/* ---- curves ---- */

typedef batten_status read_curve(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_record *record, batten_curve **out);

static const struct {
    const char *keyword;
    read_curve *read;
    bool in_plane;
} curves[] = {{"TRIMMED_CURVE", bat_step_trimmed, true},
              {"POLYLINE", bat_step_polyline, true},
              {"COMPOSITE_CURVE", bat_step_composite, true},
              {"COMPOSITE_CURVE_ON_SURFACE", bat_step_composite, false},
              {"BOUNDARY_CURVE", bat_step_composite, false},
              {"OUTER_BOUNDARY_CURVE", bat_step_composite, false},
              {"OFFSET_CURVE_3D", bat_step_offset_curve, false},
              {"PCURVE", bat_step_curve_on_surface, false}};

static batten_status make_curve(const bat_step_reading *reading,
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
                         "it is not a curve that can be read");
}

/* ---- surfaces ---- */

static batten_status whole_elementary(const bat_step_reading *reading,
                                      const bat_step_instance *instance,
                                      const bat_elementary *elementary, bool is_reversed,
                                      batten_surface **out)
{
    const bat_input *input = reading->file->input;
    batten_surface *made = NULL;
    double error = 0;
    batten_status status =
        bat_elementary_surface(elementary, 0, NULL, reading->scale.tolerance, &made, &error);
    if (status == BATTEN_OK && error > 0)
        batten_notes_remark(input->notes, input->file,
                            bat_step_line(reading->file, instance->at), "",
                            "#%llu: offset within %g", (unsigned long long)instance->id, error);
    if (status == BATTEN_OK && is_reversed)
        status = batten_surface_reverse(made, BATTEN_U, out);
    else if (status == BATTEN_OK)
        *out = batten_surface_ref(made);
    batten_surface_unref(made);
    return bat_step_blame(reading->file, instance, status);
}

static batten_status make_surface(const bat_step_reading *reading,
                                  const bat_step_instance *instance, batten_surface **out)
{
    bat_step_reading inner;
    bat_elementary elementary;
    bat_step_basis basis = {NULL, NULL, false};
    bool is_it = false;
    batten_status status = bat_step_deeper(reading, instance, &inner);
    if (status == BATTEN_OK)
        status = bat_step_spline_surface(&inner, instance, out, &is_it);
    if (status != BATTEN_OK || is_it)
        return status;
    const bat_step_record *record =
        bat_step_as(reading->file, instance, "RECTANGULAR_TRIMMED_SURFACE");
    if (record)
        return bat_step_trimmed_surface(&inner, instance, record, out);
    status = bat_step_elementary_in(&inner, instance, &elementary, &basis, &is_it);
    if (status == BATTEN_OK && is_it)
        status = whole_elementary(&inner, instance, &elementary, basis.is_reversed, out);
    else if (status == BATTEN_OK)
        status = bat_step_fail(reading->file, instance, BATTEN_UNSUPPORTED,
                               "it is not a surface that can be read");
    bat_step_basis_end(&basis);
    return status;
}

/* ---- for other files ---- */

/* A reading that can ask for any curve and surface. */
static bat_step_reading reading_of_any(const bat_step_file *file, const bat_step_scale *scale)
{
    static const bat_step_makers makers = {make_curve, make_surface};
    bat_step_reading reading = bat_step_reading_of(file, scale);
    reading.any = &makers;
    return reading;
}

batten_status bat_step_as_conic(const bat_step_file *file, const bat_step_instance *instance,
                                const bat_step_scale *scale, bat_conic *conic, bool *is_conic)
{
    const bat_step_reading reading = reading_of_any(file, scale);
    return bat_step_conic_in(&reading, instance, conic, is_conic);
}

batten_status bat_step_read_curve(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, batten_curve **out)
{
    const bat_step_reading reading = reading_of_any(file, scale);
    return make_curve(&reading, instance, out);
}

batten_status bat_step_read_pcurve(const bat_step_file *file, const bat_step_instance *instance,
                                   const bat_step_instance *surface,
                                   const bat_step_scale *scale, batten_curve **out)
{
    const bat_step_reading reading = reading_of_any(file, scale);
    return bat_step_pcurve_in(&reading, instance, surface, out);
}

batten_status bat_step_as_elementary(const bat_step_file *file,
                                     const bat_step_instance *instance,
                                     const bat_step_scale *scale, bat_elementary *elementary,
                                     bat_step_basis *basis, bool *is_elementary)
{
    const bat_step_reading reading = reading_of_any(file, scale);
    return bat_step_elementary_in(&reading, instance, elementary, basis, is_elementary);
}

batten_status bat_step_read_surface(const bat_step_file *file,
                                    const bat_step_instance *instance,
                                    const bat_step_scale *scale, batten_surface **out)
{
    const bat_step_reading reading = reading_of_any(file, scale);
    return make_surface(&reading, instance, out);
}
