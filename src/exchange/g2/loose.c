/* The tolerance of the loops of a face that is written: bodies say one for all, which some
 * faces do not keep; alone in a file a face has to say its own. */
#include "body/trace/chart.h"
#include "exchange/g2/g2.h"
#include "numeric/box.h"
#include "numeric/vector.h"

/* How far both ends of an edge are from its vertices. */
static batten_status ends_miss(const batten_body_parts *parts, const batten_body_edge *edge,
                               double *miss)
{
    const batten_interval on = batten_curve_domain(edge->curve);
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const double *vertex = &parts->vertices[3 * (size_t)edge->vertices[k]];
        double end[3];
        status = batten_curve_evaluate(edge->curve, k ? on.b : on.a, 0, end);
        if (status == BATTEN_OK)
            *miss = bat_max(*miss, bat_distance(3, end, vertex));
    }
    return status;
}

static batten_status find_miss(const batten_body_parts *parts, const batten_body_face *face,
                               bat_chart *chart, double *miss, batten_box *box)
{
    enum { PLACES = 16 };
    batten_status status = BATTEN_OK;
    for (int l = face->first; l < face->first + face->count; l++)
        for (int i = 0; status == BATTEN_OK && i < parts->loops[l].count; i++) {
            const batten_body_edge *edge =
                &parts->edges[parts->uses[parts->loops[l].first + i].edge];
            double off = 0;
            if (!edge->curve)
                continue;
            bat_box_join(box, batten_curve_box(edge->curve));
            status = ends_miss(parts, edge, miss);
            if (status == BATTEN_OK)
                status = bat_chart_miss(chart, edge->curve, PLACES, &off);
            *miss = bat_max(*miss, off);
        }
    return status;
}

batten_status bat_g2_loop_tolerance(const batten_body_parts *parts,
                                    const batten_body_face *face, const batten_surface *surface,
                                    double *tolerance)
{
    bat_chart chart;
    batten_box box = bat_box_of_nothing();
    double miss = 0;
    *tolerance = parts->tolerance;
    if (parts->is_traced || face->count == 0)
        return BATTEN_OK;
    batten_status status = bat_chart_begin(surface, parts->tolerance, &chart);
    if (status == BATTEN_OK)
        status = find_miss(parts, face, &chart, &miss, &box);
    bat_chart_end(&chart);
    if (status != BATTEN_OK) /* the face is written as it is */
        return status == BATTEN_OUT_OF_MEMORY ? status : BATTEN_OK;
    /* Half as much again is for what is between the places; edges that miss by a good part of
     * the face are not of it, whatever the tolerance. */
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    if (miss > parts->tolerance && 1.5 * miss <= 0.02 * size)
        *tolerance = 1.5 * miss;
    return BATTEN_OK;
}
