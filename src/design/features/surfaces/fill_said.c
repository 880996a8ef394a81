/* Notes on fills: how the patches meet the given sides and each other, edge by edge. */
#include "base/plural.h"
#include "design/features/surfaces/fill.h"
#include <stdio.h>

#define DEGREES (180 / BAT_PI)

void bat_name_edge(const bat_objects *curves, const batten_fill_edge *edge, char name[160])
{
    if (edge->curve >= 0)
        snprintf(name, 160, "along '%.100s'", curves->at[edge->curve]->name);
    else
        snprintf(name, 160, "between surfaces %d and %d", edge->first + 1, edge->second + 1);
}

static void keep_worst(const batten_fill_edge *edge, bat_worst_edges *worst)
{
    if (!worst->gap || edge->gap > worst->gap->gap)
        worst->gap = edge;
    if (edge->has_slope && (!worst->angle || edge->angle > worst->angle->angle))
        worst->angle = edge;
    if (edge->has_curvature &&
        (!worst->curvature || edge->curvature > worst->curvature->curvature))
        worst->curvature = edge;
}

/* One line: the worst gap, angle and curvature, each where it is. */
void bat_remark_worst_edges(const bat_run *run, const bat_objects *curves, const char *unit,
                            const bat_worst_edges *worst)
{
    char gap[160], text[3][360] = {"", "", ""};
    bat_name_edge(curves, worst->gap, gap);
    if (worst->angle) {
        const double *at = worst->angle->angle_at;
        char name[160];
        bat_name_edge(curves, worst->angle, name);
        batten_text_print(text[0], sizeof text[0],
                          "; tangent planes differ by up to %.2g degree%s (%s, at %g, %g, %g)",
                          worst->angle->angle * DEGREES,
                          bat_plural_real(worst->angle->angle * DEGREES, 2), name, at[0], at[1],
                          at[2]);
    }
    if (worst->curvature) {
        const double *at = worst->curvature->curvature_at;
        char name[160];
        bat_name_edge(curves, worst->curvature, name);
        batten_text_print(text[1], sizeof text[1],
                          "; curvatures across by up to %.3g per %s (%s, at %g, %g, %g)",
                          worst->curvature->curvature, unit, name, at[0], at[1], at[2]);
    }
    bat_remark(run, "gaps of up to %.2g %s (%s)%s%s", worst->gap->gap, unit, gap, text[0],
               text[1]);
}

/* An edge that has more than it may. */
void bat_remark_excess(const bat_run *run, const bat_objects *curves,
                       const bat_edge_bounds *most, const batten_fill_edge *edge)
{
    char name[160];
    bat_name_edge(curves, edge, name);
    if (edge->gap > most->gap)
        bat_remark(run, "%s: a gap of %.3g %s at (%g, %g, %g), more than %g", name, edge->gap,
                   most->unit, edge->gap_at[0], edge->gap_at[1], edge->gap_at[2], most->gap);
    if (edge->has_slope && edge->angle > most->angle)
        bat_remark(run, "%s: tangent planes differ by %.3g degree%s at (%g, %g, %g)", name,
                   edge->angle * DEGREES, bat_plural_real(edge->angle * DEGREES, 3),
                   edge->angle_at[0], edge->angle_at[1], edge->angle_at[2]);
    if (edge->has_curvature && edge->curvature > most->curvature)
        bat_remark(run, "%s: curvatures across differ by %.3g per %s at (%g, %g, %g)", name,
                   edge->curvature, most->unit, edge->curvature_at[0], edge->curvature_at[1],
                   edge->curvature_at[2]);
}

bat_worst_edges bat_find_worst_edges(int count, const batten_fill_edge *edges,
                                     bat_worst_edges worst)
{
    for (int i = 0; i < count; i++)
        keep_worst(&edges[i], &worst);
    return worst;
}
