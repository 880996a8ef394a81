/* Equations read from a design, and what becomes of them. */
#include "design/features/given/equations.h"
#include "design/text/document.h"

#include <string.h>

/* ---- reading ---- */

static const char *hidden_by(const char *name, int count, const char *const *variables)
{
    for (int i = 0; i < count; i++)
        if (strcmp(name, variables[i]) == 0)
            return variables[i];
    return NULL;
}

batten_status bat_equation(const bat_run *run, const char *text, int variable_count,
                           const char *const *variables, batten_equation **out)
{
    const struct bat_document *d = run->document;
    batten_equation_constant *constants =
        bat_array((size_t)d->parameter_count, sizeof *constants);
    if (!constants)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < d->parameter_count; i++) {
        const bat_parameter *p = &d->parameters[i];
        constants[i] = (batten_equation_constant){p->name, p->value.value};
        const char *hiding = hidden_by(p->name, variable_count, variables);
        if (hiding)
            bat_remark(run, "%s is the variable here, not the parameter %s of the design",
                       hiding, hiding);
    }
    const batten_equation_names names = {variable_count, d->parameter_count, variables,
                                         constants};
    const batten_status status = batten_equation_read(text, &names, out);
    bat_release(constants);
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY)
        return status;
    return bat_fail(status, "\"%.80s\": %s", text, batten_message());
}

double bat_equation_within(const bat_run *run)
{
    return bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
}

batten_status bat_equation_range(const bat_run *run, const char *parameter,
                                 batten_interval *out)
{
    const bat_argument *range = bat_argument_of(run, parameter);
    if (!range->count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the range of %s is missing; write %s: [a, b]",
                        parameter, parameter);
    *out = (batten_interval){range->items[0].number[0], range->items[0].number[1]};
    return BATTEN_OK;
}

/* ---- special points ---- */

static const char *kind_name(batten_equation_point_kind kind)
{
    static const char *const names[] = {
        "a node, where branches cross,", "an isolated point", "a singular point",
        "a halt, where the derivative may vanish,", "a corner, without a derivative,"};
    return names[kind];
}

void bat_remark_points(const bat_run *run, const batten_equation_curves *curves)
{
    enum { SHOWN = 6 };
    for (int i = 0; i < curves->point_count && i < SHOWN; i++) {
        const batten_equation_point *p = &curves->points[i];
        bat_remark(run, "%s at (%.6g, %.6g, %.6g)", kind_name(p->kind), p->point.x, p->point.y,
                   p->point.z);
    }
    if (curves->point_count > SHOWN)
        bat_remark(run, "%d more special points", curves->point_count - SHOWN);
}

/* ---- curves and surfaces ---- */

batten_status bat_put_equation_curve(bat_run *run, int dimension, batten_equation *const *read,
                                     batten_interval range)
{
    batten_equation_curves made = {0};
    batten_curve *curve = NULL;
    batten_status status =
        batten_curve_parametric(dimension, (const batten_equation *const *)read, range,
                                bat_equation_within(run), run->job, &made);
    if (status == BATTEN_OK) {
        bat_remark_points(run, &made);
        bat_report_error(run, made.error, made.error);
        status = batten_curve_to_dimension(made.curves[0], 3, &curve);
    }
    status = bat_put_curve(run, status, curve);
    batten_equation_curves_release(&made);
    return status;
}

batten_status bat_put_equation_surface(bat_run *run, batten_equation *const read[3],
                                       const batten_interval range[2])
{
    batten_surface *surface = NULL;
    double error = 0;
    const batten_status status =
        batten_surface_parametric((const batten_equation *const *)read, range,
                                  bat_equation_within(run), run->job, &error, &surface);
    if (status == BATTEN_OK)
        bat_report_error(run, error, error);
    return bat_put_surface(run, status, surface);
}
