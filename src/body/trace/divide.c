/* Edges divided at cuts, in all their uses: what is shared stays shared. */
#include "body/trace/trace.h"
#include "numeric/vector.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static int by_place(const void *a, const void *b)
{
    const bat_trace_cut *x = a, *y = b;
    if (x->edge != y->edge)
        return x->edge < y->edge ? -1 : 1;
    return x->t < y->t ? -1 : x->t > y->t;
}

/* Is the part of the edge between a and b no longer than the tolerance? */
static batten_status is_nothing(const bat_trace *trace, int edge, double a, double b,
                                bool *nothing)
{
    const batten_curve *curve = trace->builder.parts.edges[edge].curve;
    double p[3], q[3], middle[3];
    *nothing = false;
    if (!(b > a)) {
        *nothing = true;
        return BATTEN_OK;
    }
    batten_status status = batten_curve_evaluate(curve, a, 0, p);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, b, 0, q);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, a + (b - a) / 2, 0, middle);
    if (status == BATTEN_OK)
        *nothing = bat_distance(3, p, middle) + bat_distance(3, middle, q) <= trace->tolerance;
    return status;
}

/* Sort the cuts; drop those that would leave a piece of no length. */
static batten_status settle_cuts(bat_trace *trace)
{
    batten_status status = BATTEN_OK;
    int kept = 0;
    qsort(trace->cuts, (size_t)trace->cut_count, sizeof *trace->cuts, by_place);
    for (int i = 0; status == BATTEN_OK && i < trace->cut_count; i++) {
        const bat_trace_cut cut = trace->cuts[i];
        const batten_interval on =
            batten_curve_domain(trace->builder.parts.edges[cut.edge].curve);
        const bool same = kept && trace->cuts[kept - 1].edge == cut.edge;
        bool before = false, after = false;
        status =
            is_nothing(trace, cut.edge, same ? trace->cuts[kept - 1].t : on.a, cut.t, &before);
        if (status == BATTEN_OK)
            status = is_nothing(trace, cut.edge, cut.t, on.b, &after);
        if (status == BATTEN_OK && !before && !after)
            trace->cuts[kept++] = cut;
    }
    trace->cut_count = kept;
    return status;
}

/* Add the pieces of the edge cut at cuts[0 .. count - 1] to the builder, one after the other.
 */
static batten_status divide_edge(bat_trace *trace, const bat_trace_cut *cuts, int count,
                                 int *first)
{
    const batten_body_edge edge = trace->builder.parts.edges[cuts[0].edge];
    batten_curve *rest = batten_curve_ref(edge.curve);
    int vertex = edge.vertices[0], index = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        batten_curve *low = NULL, *high = NULL;
        double point[3];
        int end = 0;
        status = batten_curve_evaluate(rest, cuts[i].t, 0, point);
        if (status == BATTEN_OK)
            status = bat_builder_vertex(&trace->builder, point, &end);
        if (status == BATTEN_OK)
            status = batten_curve_split(rest, cuts[i].t, &low, &high);
        if (status == BATTEN_OK) {
            status = bat_builder_edge(&trace->builder, low, vertex, end, &index);
            batten_curve_unref(low);
            batten_curve_unref(rest);
            rest = high;
        }
        if (i == 0)
            *first = index;
        vertex = end;
    }
    if (status == BATTEN_OK)
        status = bat_builder_edge(&trace->builder, rest, vertex, edge.vertices[1], &index);
    batten_curve_unref(rest);
    return status;
}

/* The pieces of a parameter curve, for the cuts of its edge; NULL stays NULL. */
static batten_status divide_curve(const batten_curve *curve, batten_interval on,
                                  const bat_trace_cut *cuts, int count, batten_curve **pieces)
{
    batten_curve *rest = NULL;
    if (!curve)
        return BATTEN_OK;
    batten_status status = batten_curve_clamp(curve, &rest);
    /* Those of the file may have a domain of their own. */
    const batten_interval of = batten_curve_domain(curve);
    const bool same = of.a == on.a && of.b == on.b;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const double t = cuts[i].t;
        const double at = same ? t : of.a + (of.b - of.a) * ((t - on.a) / (on.b - on.a));
        batten_curve *low = NULL, *high = NULL;
        status = batten_curve_split(rest, at, &low, &high);
        if (status == BATTEN_OK) {
            batten_curve_unref(rest);
            pieces[i] = low;
            rest = high;
        }
    }
    if (status == BATTEN_OK)
        pieces[count] = rest;
    else
        batten_curve_unref(rest);
    return status;
}

/* The pieces of a use in the order of its loop. */
static batten_status add_pieces(bat_trace_loops *loops, const bat_trace_use *use,
                                batten_interval on, const bat_trace_cut *cuts, int count,
                                int first)
{
    batten_curve **pieces = bat_array((size_t)count + 1, sizeof *pieces);
    batten_status status = pieces ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = divide_curve(use->curve, on, cuts, count, pieces);
    for (int i = 0; status == BATTEN_OK && i <= count; i++) {
        const int k = use->reversed ? count - i : i;
        status = bat_trace_add_use(loops, first + k, use->reversed, false, pieces[k]);
        pieces[k] = NULL;
    }
    for (int i = 0; pieces && i <= count; i++)
        batten_curve_unref(pieces[i]);
    bat_release(pieces);
    return status;
}

/* For each edge its range of cuts, and its first piece. */
typedef struct {
    int first_cut, cut_count, piece;
} division;

static batten_status divide_loops(const bat_trace *trace, const division *divisions,
                                  bat_trace_loops *loops)
{
    bat_trace_loops made = {0};
    bool any = false;
    for (int i = 0; !any && i < loops->use_count; i++)
        any = divisions[loops->uses[i].edge].cut_count > 0;
    if (!any)
        return BATTEN_OK;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < loops->loop_count; i++) {
        status = bat_trace_add_loop(&made);
        for (int k = 0; status == BATTEN_OK && k < loops->loops[i].count; k++) {
            bat_trace_use *use = &loops->uses[loops->loops[i].first + k];
            const division *d = &divisions[use->edge];
            if (d->cut_count) {
                status =
                    add_pieces(&made, use,
                               batten_curve_domain(trace->builder.parts.edges[use->edge].curve),
                               trace->cuts + d->first_cut, d->cut_count, d->piece);
            } else {
                batten_curve *curve = use->curve;
                use->curve = NULL;
                status =
                    bat_trace_add_use(&made, use->edge, use->reversed, use->is_pole, curve);
            }
        }
    }
    bat_trace_end_loops(loops);
    *loops = made;
    return status;
}

batten_status bat_trace_divide(bat_trace *trace)
{
    const int edges = trace->builder.parts.edge_count;
    if (trace->cut_count == 0)
        return BATTEN_OK;
    division *divisions = bat_array((size_t)edges, sizeof *divisions);
    batten_status status = divisions ? settle_cuts(trace) : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < trace->cut_count;) {
        int next = i + 1;
        while (next < trace->cut_count && trace->cuts[next].edge == trace->cuts[i].edge)
            next++;
        division *d = &divisions[trace->cuts[i].edge];
        *d = (division){i, next - i, 0};
        status = divide_edge(trace, trace->cuts + i, next - i, &d->piece);
        i = next;
    }
    for (int f = 0; status == BATTEN_OK && f < trace->face_count; f++)
        status = divide_loops(trace, divisions, &trace->faces[f].loops);
    trace->cut_count = 0;
    bat_release(divisions);
    return status;
}
