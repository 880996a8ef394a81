/* Parameter curves for bodies that have none. */
#include "body/trace/all.h"
#include "mesh/faces/meshing.h"

/* Files often claim a smaller tolerance than their edges keep. Where edges are farther off
 * their faces than claimed, but not farther than tracing accepts or triangles may be, the faces
 * are meshed all the same: the edges stay what is shared. */
static batten_status trace_loosely(const bat_meshing *m, const batten_body *body,
                                   batten_body_trace_report *told, bat_traced *out)
{
    /* The body's own first: near poles coarse curves swing about in (u, v). */
    static const double parts[] = {0, 0.05, 0.3, 1};
    const double own = batten_body_view(body)->tolerance;
    bat_traced best = {0};
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < sizeof parts / sizeof *parts && (i == 0 || told->failed > 0); i++) {
        const double tried = bat_max(own, parts[i] * m->chord);
        batten_body_trace_report report;
        bat_traced made = {0};
        if (i > 0 && tried == own)
            continue;
        status = bat_body_trace(body, tried, m->job, NULL, &report, &made);
        if (status != BATTEN_OK)
            break;
        const bool better = !best.body || report.failed < told->failed;
        if (better)
            *told = report;
        bat_traced_end(better ? &best : &made);
        best = better ? made : best;
    }
    if (status == BATTEN_OK)
        *out = best;
    else
        bat_traced_end(&best);
    return status;
}

/* Edges as far off their faces as the triangles may be at most are reported when the body
 * claims better, and when they take a twentieth of the chord. */
static void remark_miss(bat_meshing *m, const batten_body_parts *parts, double miss)
{
    if (miss > bat_max(parts->tolerance, 0.05 * m->chord))
        batten_notes_remark(m->notes, "", 0, "",
                            "edges are up to %g off their faces, more than %g, which the body "
                            "states",
                            miss, parts->tolerance);
}

batten_status bat_meshing_trace(bat_meshing *m, const batten_body *body, bat_traced *traced)
{
    const batten_body_parts *parts = batten_body_view(body);
    batten_body_trace_report told = {0};
    if (bat_is_traced(parts)) {
        *traced = (bat_traced){.body = batten_body_ref(body)};
        return BATTEN_OK;
    }
    bat_traced made = {0};
    batten_status status = trace_loosely(m, body, &told, &made);
    if (status != BATTEN_OK)
        return status;
    m->report.failed += told.failed;
    remark_miss(m, parts, told.error);
    if (told.failed == 0) {
        *traced = made;
        return BATTEN_OK;
    }
    /* Once more, with a note for each face left out. */
    const double tolerance = made.tolerance;
    bat_traced_end(&made);
    return bat_body_trace(body, tolerance, m->job, m->notes, NULL, traced);
}
