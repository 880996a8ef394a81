/* Curves of a STEP file that are made of others. */
#include "exchange/step/read/geometry.h"

/* A COMPOSITE_CURVE_SEGMENT(transition, same_sense, curve), which has no name. */
static batten_status read_segment(const bat_step_reading *reading,
                                  const bat_step_instance *instance, batten_curve **out)
{
    const bat_step_file *file = reading->file;
    const bat_step_record *record = bat_step_as(file, instance, "COMPOSITE_CURVE_SEGMENT");
    const bat_step_instance *parent = NULL;
    bool forward = true;
    batten_curve *curve = NULL;
    if (!record)
        record = bat_step_as(file, instance, "REPARAMETRISED_COMPOSITE_CURVE_SEGMENT");
    if (!record)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT,
                             "it is not a segment of a "
                             "curve");
    batten_status status = bat_step_get_logical(file, record, 1, &forward);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, 2, &parent);
    if (status == BATTEN_OK)
        status = bat_step_curve_in(reading, parent, &curve);
    if (status == BATTEN_OK && !forward)
        status = batten_curve_reverse(curve, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(curve);
    batten_curve_unref(curve);
    return status;
}

/* Two neighbours joined; a gap that a tolerance a hundred times as large bears is noted. */
static batten_status join(const bat_step_reading *reading, const bat_step_instance *instance,
                          const batten_curve *first, const batten_curve *second,
                          batten_curve **out)
{
    const bat_input *input = reading->file->input;
    const double tolerance = reading->scale.tolerance;
    batten_status status = batten_curve_join(first, second, tolerance, out);
    if (status != BATTEN_NOT_COMPATIBLE)
        return status;
    status = batten_curve_join(first, second, 100 * tolerance, out);
    if (status == BATTEN_OK)
        batten_notes_add(input->notes, input->file, bat_step_line(reading->file, instance->at),
                         "", "#%llu: two of its segments are farther than %g apart; joined",
                         (unsigned long long)instance->id, tolerance);
    return status;
}

/* All into curves[0], by pairs, so that no part is joined more often than the logarithm of
 * their number. */
static batten_status join_all(const bat_step_reading *reading,
                              const bat_step_instance *instance, int count,
                              batten_curve **curves)
{
    batten_status status = BATTEN_OK;
    for (int step = 1; status == BATTEN_OK && step < count; step *= 2)
        for (int i = 0; status == BATTEN_OK && i + step < count; i += 2 * step) {
            batten_curve *joined = NULL;
            status = join(reading, instance, curves[i], curves[i + step], &joined);
            if (status != BATTEN_OK)
                break;
            batten_curve_unref(curves[i]);
            batten_curve_unref(curves[i + step]);
            curves[i] = joined;
            curves[i + step] = NULL;
        }
    return bat_step_blame(reading->file, instance, status);
}

batten_status bat_step_composite(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_record *record, batten_curve **out)
{
    const bat_step_file *file = reading->file;
    const bat_step_instance *segment = NULL;
    batten_curve **curves = NULL;
    int count = 0, made = 0;
    size_t at = 0;
    batten_status status = bat_step_check_arguments(file, record, 3);
    if (status == BATTEN_OK)
        status = bat_step_get_list(file, record, 1, &count, &at);
    if (status == BATTEN_OK && count < 1)
        status = bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "it has no segments");
    if (status == BATTEN_OK)
        status = bat_input_array(file->input, (size_t)count, sizeof(batten_curve *), &curves);
    for (; status == BATTEN_OK && made < count; made += status == BATTEN_OK) {
        status = bat_step_item_reference(file, record, &at, &segment);
        if (status == BATTEN_OK)
            status = read_segment(reading, segment, &curves[made]);
    }
    if (status == BATTEN_OK)
        status = join_all(reading, instance, count, curves);
    if (status == BATTEN_OK)
        *out = batten_curve_ref(curves[0]);
    for (int i = 0; i < made; i++)
        batten_curve_unref(curves[i]);
    bat_input_release(file->input, (size_t)count, sizeof(batten_curve *), curves);
    return status;
}
