/* The sections of a surface where its data have rows, and how fair they are. */
#include "design/outputs/fairness.h"
#include "design/shared/rows.h"

#include <batten/continuity.h>
#include <batten/fair.h>
#include <string.h>

/* Cells of the grid on which sections are sought, and the points by which one is judged. */
#define SECTION_CELLS 64
#define SECTION_POINTS 61

typedef struct {
    bat_check *check;
    bat_checked *checked;
} section_context;

static batten_status count_section(void *context, const bat_row *row)
{
    bat_checked *checked = ((section_context *)context)->checked;
    checked->section_count += row->count >= 3 && bat_flat_axis(row->count, row->points) >= 0;
    return BATTEN_OK;
}

static const batten_polyline *longest(const batten_polylines *lines)
{
    const batten_polyline *found = NULL;
    for (int i = 0; i < lines->count; i++)
        if (!found || lines->lines[i].count > found->count)
            found = &lines->lines[i];
    return found;
}

/* Some points of a section, evenly taken, in its plane. @param[out] plane [SECTION_POINTS][2]
 */
static int thin(const batten_polyline *line, int axis, double *plane)
{
    const int count = bat_min_int(line->count, SECTION_POINTS);
    for (int i = 0; i < count; i++) {
        const double *p = line->points + 3 * (size_t)(i * (line->count - 1) / (count - 1));
        for (int k = 0, c = 0; k < 3; k++)
            if (k != axis)
                plane[2 * i + c++] = p[k];
    }
    return count;
}

/* Judge a section by the curve through its points, and the inflections that the row as it was
 * given needs. */
static batten_status judge_section(const section_context *c, const batten_polyline *line,
                                   int axis, const bat_row *row, bat_section *section)
{
    double plane[2 * SECTION_POINTS];
    double *data = NULL;
    batten_curve *curve = NULL;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    batten_fairness_options bounds = batten_fairness_defaults();
    options.parameters = BATTEN_CHORD;
    const int count = thin(line, axis, plane);
    batten_status status =
        batten_curve_interpolate((batten_points){2, count, plane}, &options, NULL, &curve);
    if (status == BATTEN_OK)
        status = bat_check_given_row(c->check, c->checked, row->count, row->points, axis, &data,
                                     &bounds.within);
    if (status == BATTEN_OK)
        status = batten_curve_fairness(
            curve, (batten_points){batten_curve_dimension(curve), row->count, data}, &bounds,
            &section->fairness);
    section->found = status == BATTEN_OK;
    section->visible = batten_polyline_inflections(count, plane, bat_tolerance(c->check->run));
    section->point_count = row->count;
    section->required = section->fairness.inflections - section->fairness.excess_inflections;
    bat_release(data);
    batten_curve_unref(curve);
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ? status : BATTEN_OK;
}

static batten_status add_section(void *context, const bat_row *row)
{
    static const char *const families[2][3] = {{"x section", "y section", "z section"},
                                               {"station", "buttock", "waterline"}};
    const section_context *c = context;
    const int axis = bat_flat_axis(row->count, row->points);
    if (row->count < 3 || axis < 0)
        return BATTEN_OK;
    bat_section *section = &c->checked->sections[c->checked->section_count++];
    const char *name = bat_arena_copy(&c->check->arena, row->name, strlen(row->name));
    if (!name)
        return BATTEN_OUT_OF_MEMORY;
    *section = (bat_section){
        .family = families[c->checked->is_hull][axis], .name = name, .at = row->points[axis]};
    batten_polylines lines = {0, NULL};
    batten_status status = batten_surface_section(
        c->checked->object->surface, (batten_vec3){axis == 0, axis == 1, axis == 2},
        section->at, SECTION_CELLS, SECTION_CELLS, &lines);
    if (status != BATTEN_OK)
        return status;
    const batten_polyline *line = longest(&lines);
    if (line && line->count >= 4)
        status = judge_section(c, line, axis, row, section);
    c->check->judged_count += section->found;
    batten_polylines_release(&lines);
    return status;
}

/* So few points say little of their row: a hollow entry of three points looks straight. */
enum { FEW_POINTS = 5 };

/* What the nearest row of the family with enough points requires, above or below it. */
static int ask_neighbour(const bat_checked *checked, const bat_section *of, bool above)
{
    const bat_section *nearest = NULL;
    for (int i = 0; i < checked->section_count; i++) {
        const bat_section *s = checked->sections + i;
        if (!s->found || s->family != of->family || s->point_count < FEW_POINTS)
            continue;
        if ((above ? s->at > of->at : s->at < of->at) &&
            (!nearest || fabs(s->at - of->at) < fabs(nearest->at - of->at)))
            nearest = s;
    }
    return nearest ? nearest->required : 0;
}

static void count_excess(bat_check *check, const bat_checked *checked)
{
    for (int i = 0; i < checked->section_count; i++) {
        bat_section *s = checked->sections + i;
        if (!s->found)
            continue;
        if (s->point_count < FEW_POINTS)
            s->required =
                bat_max_int(s->required, bat_max_int(ask_neighbour(checked, s, false),
                                                     ask_neighbour(checked, s, true)));
        s->excess = bat_max_int(0, s->visible - s->required);
        check->unfairness.inflections += s->excess;
    }
}

/* The rows of the points that the surface was made from last: those after fairing where they were
 * made fair. */
static batten_status visit_last_rows(section_context *context, bat_row_visit visit)
{
    const bat_data_roots *data = &context->checked->data;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < data->count && status == BATTEN_OK; i++)
        if (data->at[i].is_last)
            status =
                bat_check_visit_rows(context->check, data->at[i].feature, true, visit, context);
    return status;
}

batten_status bat_check_add_sections(bat_check *check, bat_checked *checked)
{
    section_context context = {check, checked};
    batten_status status = visit_last_rows(&context, count_section);
    checked->sections = bat_arena_array(&check->arena, (size_t)checked->section_count,
                                        sizeof *checked->sections);
    checked->section_count = 0;
    if (status == BATTEN_OK && !checked->sections)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = visit_last_rows(&context, add_section);
    count_excess(check, checked);
    return status;
}
