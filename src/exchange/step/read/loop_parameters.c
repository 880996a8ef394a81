/* Loops with their curves in the parameters of a B-spline surface of the file. */
#include "exchange/step/read/geometry.h"
#include "exchange/step/read/topology.h"
#include "numeric/vector.h"

/* ---- curves in the parameters ---- */

/* What of a SEAM_CURVE belongs to one way along it: the PCURVE that stands first is that of the
 * use along the edge, says the order that most write. */
static const bat_step_instance *seam_part(const bat_step_topology *t,
                                          const bat_step_instance *seam,
                                          const bat_step_instance *surface, int wanted)
{
    const bat_step_record *record = NULL;
    int count = 0, found = 0;
    size_t at = 0;
    if (bat_step_pcurves_of(t->file, seam, &count, &at, &record) != BATTEN_OK)
        return NULL;
    for (int k = 0; k < count && k < 2; k++) {
        const bat_step_instance *part = NULL, *on = NULL;
        if (bat_step_item_reference(t->file, record, &at, &part) != BATTEN_OK)
            return NULL;
        const bat_step_record *curve = bat_step_as(t->file, part, "PCURVE");
        if (curve &&
            bat_step_get_reference(t->file, curve, bat_step_pcurve_surface(t->file, curve),
                                   &on) == BATTEN_OK &&
            on == surface && found++ == wanted)
            return part;
    }
    return NULL;
}

/* The curve in the parameters of the surface, when it belongs to the whole of the edge; `other`
 * asks for the other one of a seam. */
static batten_status read_parameters(bat_step_topology *t, const bat_step_instance *surface,
                                     const bat_step_use *use, bool other, batten_curve **out)
{
    const bat_step_edge *edge = (const bat_step_edge *)t->edges.items + use->edge;
    const bat_step_instance *instances = t->file->instances.items;
    const bat_step_instance *geometry = &instances[edge->geometry];
    batten_curve *curve = NULL;
    *out = NULL;
    if (!edge->is_whole)
        return BATTEN_OK;
    if (bat_step_as(t->file, geometry, "SEAM_CURVE"))
        geometry = seam_part(t, geometry, surface, use->reversed != other);
    batten_status status =
        geometry ? bat_step_read_pcurve(t->file, geometry, surface, &t->scale, &curve)
                 : BATTEN_OK;
    if (status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED)
        return status;
    if (status != BATTEN_OK) {
        bat_step_warn(
            t->file, geometry,
            "its curve in the parameters is left out, the one in space is used: %.200s",
            batten_message());
        return BATTEN_OK;
    }
    if (!curve || !edge->is_turned) {
        *out = curve;
        return BATTEN_OK;
    }
    status = batten_curve_reverse(curve, out);
    batten_curve_unref(curve);
    return status;
}

/* How far apart in (u, v) the ends of the curves of a loop are, in all; 0 when one is missing.
 */
static double gaps_of(const bat_step_use *uses, batten_curve *const *curves, int count)
{
    double sum = 0;
    for (int k = 0; k < count; k++) {
        const int next = (k + 1) % count;
        double ends[2][2];
        const int uses_of[2] = {k, next};
        for (int i = 0; i < 2; i++) {
            const batten_curve *curve = curves[uses_of[i]];
            if (!curve)
                return 0;
            const batten_interval domain = batten_curve_domain(curve);
            const bool at_end = uses[uses_of[i]].reversed == (i == 1);
            if (batten_curve_evaluate_side(curve, at_end ? domain.b : domain.a,
                                           at_end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 0,
                                           ends[i]) != BATTEN_OK)
                return INFINITY;
        }
        sum += bat_distance(2, ends[0], ends[1]);
    }
    return sum;
}

static batten_status read_loop_parameters(bat_step_topology *t,
                                          const bat_step_instance *surface,
                                          const bat_step_use *uses, int count, bool other,
                                          batten_curve **curves)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = read_parameters(t, surface, &uses[k], other, &curves[k]);
    return status;
}

static void drop_curves(batten_curve **curves, int count)
{
    for (int k = 0; curves && k < count; k++)
        batten_curve_unref(curves[k]);
    bat_release(curves);
}

/* Is an edge used twice by the loop? */
static bool has_seam(const bat_step_topology *t, const bat_step_use *uses, int count)
{
    const bat_step_edge *edges = t->edges.items;
    const bat_step_instance *instances = t->file->instances.items;
    for (int k = 0; k < count; k++)
        if (bat_step_as(t->file, &instances[edges[uses[k].edge].geometry], "SEAM_CURVE"))
            return true;
    return false;
}

/* The curves of a loop; those of a seam the way round in which the loop hangs together. */
static batten_status loop_parameters(bat_step_topology *t, const bat_step_instance *surface,
                                     const bat_step_use *uses, int count, batten_curve ***out)
{
    batten_curve **first = bat_array((size_t)count, sizeof(batten_curve *)), **second = NULL;
    batten_status status = first ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = read_loop_parameters(t, surface, uses, count, false, first);
    if (status == BATTEN_OK && has_seam(t, uses, count)) {
        second = bat_array((size_t)count, sizeof(batten_curve *));
        status = second ? read_loop_parameters(t, surface, uses, count, true, second)
                        : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK && second &&
        gaps_of(uses, second, count) < gaps_of(uses, first, count)) {
        batten_curve **const kept = first;
        first = second;
        second = kept;
    }
    drop_curves(second, count);
    if (status == BATTEN_OK)
        *out = first;
    else
        drop_curves(first, count);
    return status;
}

/* ---- faces in the builder ---- */

static batten_status put_loop(bat_step_topology *t, const bat_step_instance *surface,
                              const bat_step_use *uses, int count)
{
    batten_curve **curves = NULL;
    batten_status status = bat_builder_loop(&t->builder);
    if (status == BATTEN_OK && surface)
        status = loop_parameters(t, surface, uses, count, &curves);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = bat_builder_use(&t->builder, uses[k].edge, uses[k].reversed,
                                 curves ? curves[k] : NULL);
    drop_curves(curves, count);
    return status;
}

batten_status bat_step_put_loops(bat_step_topology *t, const bat_step_instance *surface)
{
    const bat_step_use *uses = t->uses.items;
    const int *counts = t->loops.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < t->loops.count; k++) {
        status = put_loop(t, surface, uses, counts[k]);
        uses += counts[k];
    }
    return status;
}
