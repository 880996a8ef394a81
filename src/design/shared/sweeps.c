/* What the features of sweeps share: sections, frames, laws, corners. */
#include "design/shared/sweeps.h"
#include "base/plural.h"

#include <batten/measure.h>
#include <stdio.h>

double bat_sweep_within(const bat_run *run)
{
    return bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
}

void bat_remark_space_section(const bat_run *run, const batten_curve *section)
{
    batten_box box;
    if (batten_curve_dimension(section) < 3 || batten_curve_bounds(section, &box) != BATTEN_OK)
        return;
    if (box.low.z != 0 || box.high.z != 0)
        bat_remark(run,
                   "the section is a space curve in the moving frame: its z, from %.4g to "
                   "%.4g, is taken along the spine",
                   box.low.z, box.high.z);
}

static batten_status through(int count, const double *values, batten_curve **out)
{
    double *at = bat_array((size_t)count, sizeof *at);
    if (!at)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        at[i] = i < count - 1 ? (double)i / (count - 1) : 1;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = at;
    const batten_status status =
        batten_curve_interpolate((batten_points){1, count, values}, &options, NULL, out);
    bat_release(at);
    return status;
}

batten_status bat_sweep_law(const bat_run *run, const char *parameter, batten_curve **out)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    if (given->count == 0)
        return BATTEN_OK;
    const int count = given->count < 2 ? 2 : given->count;
    double *values = bat_array((size_t)count, sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        values[i] = given->items[i < given->count ? i : 0].number[0];
    const batten_status status = through(count, values, out);
    bat_release(values);
    return status;
}

static void report_sweep(bat_run *run, const batten_surface_sweep_report *report)
{
    bat_report_error(run, report->error, report->error);
    if (report->turn != 0)
        bat_remark(run, "%d section%s; the frames are turned back by %.4g degree%s in a round",
                   report->section_count, bat_plural(report->section_count),
                   report->turn * 180 / BAT_PI,
                   bat_plural_real(report->turn * 180 / BAT_PI, 4));
    else
        bat_remark(run, "%d section%s", report->section_count,
                   bat_plural(report->section_count));
    if (report->reversed_count > 0)
        bat_remark(
            run, "%d section%s reversed, the first of them section %d", report->reversed_count,
            bat_one_or_many(report->reversed_count, " was", "s were"), report->reversed + 1);
    if (report->turned_count > 0)
        bat_remark(
            run, "%d section%s elsewhere, the first of them section %d", report->turned_count,
            bat_one_or_many(report->turned_count, " starts", "s start"), report->turned + 1);
    if (report->clearance <= 0)
        bat_note(run,
                 "the sections run into each other around %.6g of the spine: curvature times "
                 "their reach is %.4g",
                 report->clearance_at, 1 - report->clearance);
}

/* Several are numbered from 1; `number` is 0 for one alone. */
static batten_status put_swept(bat_run *run, batten_status status, batten_surface *surface,
                               int number)
{
    char name[200];
    if (number == 0)
        snprintf(name, sizeof name, "%s", run->name);
    else
        snprintf(name, sizeof name, "%.180s %d", run->name, number);
    const batten_object like = {.name = name, .layer = ""};
    return bat_put_surface_like(run, status, surface, &like);
}

batten_status bat_put_sweep(bat_run *run, batten_status status, int count,
                            batten_surface **surfaces,
                            const batten_surface_sweep_report *report)
{
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < count; k++)
        status = put_swept(run, status, surfaces[k], count == 1 ? 0 : k + 1);
    bat_release(surfaces);
    if (status == BATTEN_OK)
        report_sweep(run, report);
    return status;
}

/* ---- sections ---- */

/* The curve that stands still in a point. */
static batten_status take_tip(const batten_object *object, bool is_end, batten_curve **out)
{
    static const double knots[] = {0, 0, 1, 1};
    double points[6];
    if (!is_end || object->point_count != 1)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%s' is %d point%s: one point may be the first or the last section; "
                        "'interpolate' makes a curve through several",
                        object->name, object->point_count, bat_plural(object->point_count));
    for (int i = 0; i < 6; i++)
        points[i] = object->points[i % 3];
    return batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, out);
}

batten_status bat_take_tipped(const bat_objects *all, bat_tipped *out)
{
    *out = (bat_tipped){.curves = bat_array((size_t)all->count, sizeof *out->curves)};
    batten_status status = out->curves ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->count && status == BATTEN_OK; i++) {
        const batten_object *object = all->at[i];
        out->curves[i] = object->curve;
        if (object->kind == BATTEN_OBJECT_CURVE)
            continue;
        status = take_tip(object, i == 0 || i == all->count - 1, &out->tips[i > 0]);
        out->curves[i] = out->tips[i > 0];
    }
    return status;
}

void bat_tipped_release(bat_tipped *tipped)
{
    batten_curve_unref(tipped->tips[0]);
    batten_curve_unref(tipped->tips[1]);
    bat_release(tipped->curves);
    *tipped = (bat_tipped){0};
}
