/* The feature 'extend': curves made longer at their ends, surfaces at their edges. */
#include "base/plural.h"
#include "design/feature.h"

#include <batten/extend.h>

static const batten_parameter parameters[] = {
    {"extend", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves or surfaces"},
    {"start", BATTEN_VALUE_LENGTH, false, false, NULL, NULL, "by how much, before the start"},
    {"end", BATTEN_VALUE_LENGTH, false, false, NULL, NULL, "by how much, beyond the end"},
    {"from", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "instead of 'start': the parameter at which the longer curve begins"},
    {"to", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "instead of 'end': the parameter at which it ends"},
    {"shape", BATTEN_VALUE_WORD, false, false, "arc", "line arc spiral natural",
     "how the curve or surface continues"},
    {"by", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "surfaces: by how much, on the shortest line across the edge"},
    {"edges", BATTEN_VALUE_WORD, true, false, NULL, "v0 u1 v1 u0",
     "surfaces: which, v0 for that of least v and so on; one after another"},
};

static const char *const names[2][2] = {{"start", "from"}, {"end", "to"}};

/* One end of a curve, as asked. */
static batten_status extend(const bat_run *run, const char *name, batten_curve_end end,
                            const batten_curve *curve, batten_curve_extend_report *report,
                            batten_curve **out)
{
    const batten_extension shape = (batten_extension)bat_word(run, "shape");
    const double within = bat_tolerance(run) / 10;
    const bool by_length = bat_has(run, names[end][0]);
    const double amount = bat_number(run, names[end][by_length ? 0 : 1]);
    const batten_status status =
        by_length ? batten_curve_extend(curve, end, (batten_lengthening){shape, within}, amount,
                                        report, out)
                  : batten_curve_extend_to(curve, end, (batten_lengthening){shape, within},
                                           amount, report, out);
    return status == BATTEN_OK
               ? status
               : bat_fail(status, "%s: the %s: %s", name, names[end][0], batten_message());
}

static batten_status change_extend(bat_run *run, const batten_object *object)
{
    batten_curve *curve = batten_curve_ref(object->curve);
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        batten_curve *longer = NULL;
        batten_curve_extend_report report;
        if (!bat_has(run, names[k][0]) && !bat_has(run, names[k][1]))
            continue;
        status = extend(run, object->name, (batten_curve_end)k, curve, &report, &longer);
        if (status != BATTEN_OK)
            break;
        bat_remark(run, "%s: the %s joins with G%d", object->name, names[k][0],
                   report.join.geometric);
        bat_report_error(run, report.error, report.error);
        batten_curve_unref(curve);
        curve = longer;
    }
    return bat_put_curve_like(run, status, curve, object, false);
}

/* ---- surfaces ---- */

static void report_extend(const bat_run *run, const batten_object *object, const char *edge,
                          const batten_surface_extend_report *report)
{
    const double degrees = 180 / 3.14159265358979323846;
    bat_remark(run,
               "%s: %s is longer by %.6g to %.6g; over the old edge the normal jumps by %.2g "
               "degree%s, curvature by %.2g",
               object->name, edge, report->least, report->most, report->angle * degrees,
               bat_plural_real(report->angle * degrees, 2), report->curvature);
    if (report->turn * degrees > 90)
        bat_note(run, "%s: beyond %s the surface turns by %.3g degree%s", object->name, edge,
                 report->turn * degrees, bat_plural_real(report->turn * degrees, 3));
}

static batten_status change_surface(bat_run *run, const batten_object *object)
{
    static const char *const edge_names[] = {"v0", "u1", "v1", "u0"};
    const bat_argument *edges = bat_argument_of(run, "edges");
    batten_surface *surface = batten_surface_ref(object->surface);
    batten_status status = BATTEN_OK;
    for (int k = 0; k < edges->count && status == BATTEN_OK; k++) {
        const int edge = edges->items[k].count;
        batten_surface *longer = NULL;
        batten_surface_extend_report report;
        status =
            batten_surface_extend(surface, (batten_edge)edge,
                                  (batten_lengthening){(batten_extension)bat_word(run, "shape"),
                                                       bat_tolerance(run) / 10},
                                  bat_number(run, "by"), &report, &longer);
        if (status != BATTEN_OK) {
            status = bat_fail(status, "%s: %s: %s", object->name, edge_names[edge],
                              batten_message());
            break;
        }
        report_extend(run, object, edge_names[edge], &report);
        bat_report_error(run, report.error, report.error);
        batten_surface_unref(surface);
        surface = longer;
    }
    if (status == BATTEN_OK)
        return bat_put_surface_like(run, status, surface, object);
    batten_surface_unref(surface);
    return status;
}

static batten_status check_object_words(const batten_object *object, bool ends, bool edges)
{
    const bool surface = object->kind == BATTEN_OBJECT_SURFACE;
    if (surface && !edges)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%s' is a surface: 'by' and 'edges' must be "
                        "given",
                        object->name);
    if (!surface && !ends)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'start', 'end', 'from' or 'to' must be given");
    return BATTEN_OK;
}

/* Different parameters say where curves and surfaces are extended. */
static batten_status check_words(const bat_run *run, const bat_objects *all)
{
    const bool ends = bat_has(run, "start") || bat_has(run, "end") || bat_has(run, "from") ||
                      bat_has(run, "to");
    const bool edges = bat_has(run, "by") && bat_has(run, "edges");
    for (int i = 0; i < all->count; i++) {
        const batten_status status = check_object_words(all->at[i], ends, edges);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

static batten_status run_extend(bat_run *run)
{
    bat_objects all;
    for (int k = 0; k < 2; k++)
        if (bat_has(run, names[k][0]) && bat_has(run, names[k][1]))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "'%s' and '%s' set the same thing; give one of them", names[k][0],
                            names[k][1]);
    batten_status status = bat_gather(run, "extend", BAT_CURVES | BAT_SURFACES, &all);
    if (status != BATTEN_OK)
        return status;
    status = check_words(run, &all);
    for (int i = 0; i < all.count && status == BATTEN_OK; i++)
        status = all.at[i]->kind == BATTEN_OBJECT_SURFACE ? change_surface(run, all.at[i])
                                                          : change_extend(run, all.at[i]);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_extend = {
    .shown =
        {"extend", "Curves made longer at their ends, surfaces at their edges",
         "By an arc length, or to a parameter outside the domain. The old part stays where it is\n"
         "and keeps its parameters. 'line' continues along the tangent; 'arc' along the circle of\n"
         "curvature, exactly; 'spiral' lets curvature keep changing at the rate it has at the end,\n"
         "like a clothoid, within a tenth of the tolerance of the design; 'natural' evaluates the\n"
         "last piece beyond its end, which is the smoothest but may stray far out. A note says how\n"
         "each end joins. A periodic curve has no end to extend, a curve that stands still at its\n"
         "end has no direction there, and an arc goes around once at most. Surfaces continue\n"
         "beyond 'edges', on all lines across an edge at once, by the length 'by' on the shortest\n"
         "of them: straight, along circles of curvature, or naturally; 'line' and 'natural' are\n"
         "exact. The result is one surface, and a note says how it joins and how far it turns.",
         "features:\n"
         "  d: {points: [[0, 0], [1 m, 0.6 m], [2 m, 0.7 m]]}\n"
         "  rail: {interpolate: d, ends: circle}\n"
         "  longer: {extend: rail, start: 0.2 m, end: 0.5 m, shape: spiral}\n",
         "[PT97]", "batten_curve_extend, batten_surface_extend", BAT_PARAMETERS(parameters),
         false, .also = "lengthen, extrapolate, prolong"},
    .run = run_extend};
