/* Curves on surfaces: the curve in space that they stand for, and the one in the parameters. */
#include "exchange/step/read/geometry.h"

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

/* Where its own arguments begin: in complex instances the name stands in REPRESENTATION_ITEM. */
static int first_argument(const bat_step_file *file, const bat_step_record *surface_curve)
{
    return bat_step_argument_count(file, surface_curve) > 3 ? 1 : 0;
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
            status = bat_step_get_reference(reading->file, record,
                                            first_argument(reading->file, record), instance);
    }
    return status;
}

int bat_step_pcurve_surface(const bat_step_file *file, const bat_step_record *pcurve)
{
    return bat_step_argument_count(file, pcurve) > 2 ? 1 : 0;
}

batten_status bat_step_pcurves_of(const bat_step_file *file,
                                  const bat_step_instance *surface_curve, int *count,
                                  size_t *first, const bat_step_record **record)
{
    *count = 0;
    if (!is_surface_curve(file, surface_curve, record))
        return BATTEN_OK;
    return bat_step_get_list(file, *record, 1 + first_argument(file, *record), count, first);
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
    if (!record)
        status = bat_step_pcurves_of(file, instance, &count, &at, &of);
    for (int i = 0; status == BATTEN_OK && i < count && !*out; i++) {
        if (of)
            status = bat_step_item_reference(file, of, &at, &item);
        if (status != BATTEN_OK)
            break;
        record = bat_step_as(file, item, "PCURVE");
        if (record)
            status = bat_step_get_reference(file, record, bat_step_pcurve_surface(file, record),
                                            &on);
        if (status == BATTEN_OK && record && on == surface)
            *out = record;
    }
    return status;
}

batten_status bat_step_pcurve_in(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_instance *surface, batten_curve **out)
{
    const bat_step_file *file = reading->file;
    bat_step_reading flat = bat_step_reading_of(file, &reading->scale);
    const bat_step_record *pcurve = NULL, *definition = NULL;
    const bat_step_instance *curve = NULL;
    int count = 0;
    size_t at = 0;
    flat.any = reading->any;
    flat.dimension = 2;
    flat.scale.length = 1;
    if (!bat_step_is_spline_surface(file, surface))
        return BATTEN_OK;
    batten_status status = find_pcurve(file, instance, surface, &pcurve);
    if (status != BATTEN_OK || !pcurve)
        return status;
    status = bat_step_get_record(file, pcurve, 1 + bat_step_pcurve_surface(file, pcurve),
                                 "DEFINITIONAL_REPRESENTATION", &definition);
    if (status == BATTEN_OK)
        status = bat_step_get_list(file, definition, 1, &count, &at);
    if (status == BATTEN_OK)
        status = bat_step_item_reference(file, definition, &at, &curve);
    if (status == BATTEN_OK)
        status = bat_step_curve_in(&flat, curve, out);
    return status == BATTEN_NOT_COMPATIBLE ? BATTEN_OK : status; /* a line has no ends */
}
