/* What the features of local interpolation share: tangents and slopes by rules. */
#include "design/shared/local.h"
#include "base/plural.h"

#include <string.h>

void bat_note_turns(bat_run *run, const bat_data *data, const batten_tangents_report *report)
{
    if (report->turned_back > 0)
        bat_note(
            run,
            "'%s' turns back on itself at %d point%s, the first is point %d: its tangent is "
            "at right angles there",
            data->name, report->turned_back, bat_plural(report->turned_back),
            report->first_turned_back + 1);
}

/* Parameters, closed one more, and tangents of a row. */
typedef struct {
    double *t, *leaving, *arriving;
} tangent_rows;

static bool tangents_make(const bat_data *data, tangent_rows *out)
{
    const size_t n = (size_t)data->count, d = (size_t)data->dimension;
    out->t = bat_array(n + 1, sizeof *out->t);
    out->leaving = bat_array3(n, d, sizeof *out->leaving);
    out->arriving = bat_array3(n, d, sizeof *out->arriving);
    return out->t && out->leaving && out->arriving;
}

static void tangents_free(tangent_rows *of)
{
    bat_release(of->t);
    bat_release(of->leaving);
    bat_release(of->arriving);
}

static batten_status make_curve(const bat_data *data, const tangent_rows *of, bool closed,
                                bat_made *made)
{
    memcpy(made->parameters, of->t, (size_t)data->count * sizeof *of->t);
    return batten_curve_from_tangents(
        (batten_points){data->dimension, data->count, data->points}, of->t, of->leaving,
        of->arriving, closed, &made->curve);
}

batten_status bat_make_of_tangents(bat_run *run, const bat_data *data,
                                   const batten_tangents_options *options, bat_made *made)
{
    batten_tangents_report report;
    tangent_rows found;
    batten_status status = tangents_make(data, &found) ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_tangents((batten_points){data->dimension, data->count, data->points},
                                 options, found.t, &report, found.leaving, found.arriving);
    if (status == BATTEN_OK)
        status = make_curve(data, &found, options->closed, made);
    if (status == BATTEN_OK)
        bat_note_turns(run, data, &report);
    tangents_free(&found);
    return status;
}

batten_status bat_make_kochanek_bartels(bat_run *run, const bat_data *data,
                                        batten_tangents_kochanek_bartels_options *options,
                                        bat_made *made)
{
    tangent_rows found;
    options->alpha = bat_number(run, "alpha");
    options->given = data->abscissae;
    options->closed = bat_yes(run, "closed");
    options->phantoms = (batten_phantoms)bat_word(run, "beyond");
    batten_status status = tangents_make(data, &found) ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_check_closed(run, data);
    if (status == BATTEN_OK)
        status = batten_tangents_kochanek_bartels(
            (batten_points){data->dimension, data->count, data->points}, options, found.t,
            found.leaving, found.arriving);
    if (status == BATTEN_OK)
        status = make_curve(data, &found, options->closed, made);
    tangents_free(&found);
    return status;
}

batten_status bat_make_of_slopes(const bat_data *data, batten_slope_rule rule, bat_made *made)
{
    double *slopes = bat_array((size_t)data->count, sizeof *slopes);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (slopes)
        status = batten_slopes(data->count, data->abscissae, data->points, rule, slopes);
    if (status == BATTEN_OK)
        status = batten_curve_from_tangents((batten_points){1, data->count, data->points},
                                            data->abscissae, slopes, NULL, false, &made->curve);
    if (status == BATTEN_OK)
        memcpy(made->parameters, data->abscissae, (size_t)data->count * sizeof *slopes);
    bat_release(slopes);
    return status;
}

batten_status bat_make_local(bat_run *run, const bat_data *data, batten_slope_rule slopes,
                             batten_tangent_rule tangents, batten_tangent_length length,
                             bat_made *made)
{
    const batten_status status = bat_check_closed(run, data);
    if (status != BATTEN_OK)
        return status;
    if (data->dimension == 1)
        return bat_make_of_slopes(data, slopes, made);
    batten_tangents_options options = batten_tangents_defaults();
    options.rule = tangents;
    options.length = length;
    options.closed = bat_yes(run, "closed");
    return bat_make_of_tangents(run, data, &options, made);
}

batten_status bat_vectors(const bat_run *run, const bat_data *data, const char *parameter,
                          double **out)
{
    const bat_argument *list = bat_argument_of(run, parameter);
    *out = NULL;
    if (list->count == 0)
        return BATTEN_OK;
    if (list->count != data->count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d vector%s for %d point%s", parameter,
                        list->count, bat_plural(list->count), data->count,
                        bat_plural(data->count));
    double *rows = bat_array3((size_t)list->count, 3, sizeof *rows);
    if (!rows)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < list->count; i++)
        memcpy(rows + 3 * i, list->items[i].number, 3 * sizeof *rows);
    *out = bat_points_in_plane(data->axis, list->count, rows);
    bat_release(rows);
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}
