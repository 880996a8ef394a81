/* The driver of tracing: takes the given body apart, leads all its faces through the steps of
 * trace.h together, and builds the traced body, with the numbers of the faces it came from. */
#include "body/trace/trace.h"
#include "base/work.h"
#include "body/edge_box.h"
#include "body/trace/traced_body.h"
#include "numeric/vector.h"

#include <stdint.h>

/* ---- the given body ---- */

static batten_status copy_edges(bat_trace *trace)
{
    const batten_body_parts *p = trace->from;
    batten_status status = BATTEN_OK;
    int index;
    for (int i = 0; status == BATTEN_OK && i < p->vertex_count; i++)
        status = bat_builder_vertex(&trace->builder, p->vertices + 3 * (size_t)i, &index);
    for (int i = 0; status == BATTEN_OK && i < p->edge_count; i++)
        status = bat_builder_edge(&trace->builder, p->edges[i].curve, p->edges[i].vertices[0],
                                  p->edges[i].vertices[1], &index);
    trace->balance = bat_array((size_t)p->edge_count, sizeof *trace->balance);
    if (status == BATTEN_OK && !trace->balance)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < p->use_count; i++)
        trace->balance[p->uses[i].edge] += p->uses[i].reversed ? -1 : 1;
    return status;
}

/* The uses of a loop that have curves; poles are put in again where they are. */
static batten_status copy_loop(bat_trace *trace, const batten_body_loop *loop,
                               bat_trace_loops *loops)
{
    const batten_body_parts *p = trace->from;
    batten_status status = BATTEN_OK;
    bool any = false;
    for (int i = 0; i < loop->count; i++)
        any = any || p->edges[p->uses[loop->first + i].edge].curve;
    if (any)
        status = bat_trace_add_loop(loops);
    for (int i = 0; status == BATTEN_OK && any && i < loop->count; i++) {
        const batten_body_use *use = &p->uses[loop->first + i];
        if (p->edges[use->edge].curve)
            status =
                bat_trace_add_use(loops, use->edge, use->reversed, false,
                                  use->parameters ? batten_curve_ref(use->parameters) : NULL);
        else
            trace->report.poles--;
    }
    return status;
}

static batten_status begin_loop(bat_trace *trace, const batten_body_loop *loop,
                                bat_trace_face *face)
{
    const int before = face->loops.loop_count;
    const batten_status status = copy_loop(trace, loop, &face->loops);
    if (status == BATTEN_OK && face->reversed && face->loops.loop_count > before)
        bat_trace_turn(&face->loops, before);
    return status;
}

static batten_status begin_face(bat_trace *trace, int index, bat_trace_face *face)
{
    const batten_body_face *from = &trace->from->faces[index];
    *face = (bat_trace_face){.from = index, .reversed = from->reversed};
    batten_status status = bat_chart_begin(from->surface, trace->tolerance, &face->chart);
    for (int i = 0; status == BATTEN_OK && i < from->count; i++)
        status = begin_loop(trace, &trace->from->loops[from->first + i], face);
    return status;
}

/* One that fails is left out. */
static batten_status add_face(bat_trace *trace, int index)
{
    bat_trace_face *face = &trace->faces[trace->face_count++];
    batten_status status = begin_face(trace, index, face);
    if (status == BATTEN_OK)
        status = bat_trace_pole_cuts(trace, face);
    if (status != BATTEN_OK && bat_trace_fails(trace, face, status))
        status = BATTEN_OK;
    return status;
}

static batten_status begin_faces(bat_trace *trace)
{
    trace->faces = bat_array((size_t)trace->from->face_count, sizeof *trace->faces);
    batten_status status = trace->faces ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < trace->from->face_count; i++)
        status = add_face(trace, i);
    return status;
}

/* ---- steps over all faces ---- */

static batten_status trace_face(bat_trace *trace, bat_trace_face *face)
{
    batten_status status = bat_trace_face_loops(trace, face);
    if (status == BATTEN_OK)
        status = bat_trace_right(trace, face);
    return status;
}

typedef batten_status (*face_step)(bat_trace *trace, bat_trace_face *face);

static batten_status for_faces(bat_trace *trace, face_step step, const char *what)
{
    bat_work work = {.job = trace->job};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < trace->face_count; i++) {
        bat_trace_face *face = &trace->faces[i];
        if (face->failed)
            continue;
        status = step(trace, face);
        if (status != BATTEN_OK && bat_trace_fails(trace, face, status))
            status = BATTEN_OK;
        if (status == BATTEN_OK)
            status = bat_work_step(&work, 1 + (uint64_t)face->loops.use_count,
                                   (double)i / trace->face_count, what);
    }
    return status;
}

static batten_status cut_along(bat_trace *trace, int direction)
{
    trace->direction = direction;
    batten_status status = for_faces(trace, bat_trace_choose_seam, "choosing seams");
    if (status == BATTEN_OK)
        status = bat_trace_divide(trace);
    if (status == BATTEN_OK)
        status = for_faces(trace, bat_trace_relink, "closing loops");
    return status;
}

/* Cut what closes in u, then in v; and in u again, for seams in v may have left the cell that
 * nothing had left before. */
static batten_status cut_faces(bat_trace *trace)
{
    static const int rounds[] = {0, 1, 0};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < 3; i++)
        status = cut_along(trace, rounds[i]);
    return status;
}

/* A given face may become several, or none: ends[i] is the number of faces in the builder after
 * face i was put. */
static batten_status put_faces(bat_trace *trace, int *ends)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < trace->from->shell_count; i++) {
        const batten_body_shell *shell = &trace->from->shells[i];
        status = bat_builder_shell(&trace->builder, shell->closed);
        for (int k = 0; status == BATTEN_OK && k < shell->count; k++) {
            bat_trace_face *face = &trace->faces[shell->first + k];
            const int mark = bat_builder_mark(&trace->builder);
            if (!face->failed)
                status = bat_trace_put(trace, face);
            if (status != BATTEN_OK && bat_trace_fails(trace, face, status)) {
                bat_builder_back(&trace->builder, mark);
                status = BATTEN_OK;
            }
            ends[shell->first + k] = trace->builder.parts.face_count;
        }
    }
    return status;
}

/* Put all faces, and list the given face that each came from. */
static batten_status put_numbered(bat_trace *trace, int **numbers)
{
    int *ends = bat_array((size_t)trace->from->face_count, sizeof *ends);
    batten_status status = ends ? put_faces(trace, ends) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        *numbers = bat_array((size_t)trace->builder.parts.face_count, sizeof **numbers);
        status = *numbers ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    for (int i = 0, f = 0; status == BATTEN_OK && i < trace->from->face_count; i++)
        while (f < ends[i])
            (*numbers)[f++] = i;
    bat_release(ends);
    return status;
}

static void trace_end(bat_trace *trace)
{
    for (int i = 0; i < trace->face_count; i++) {
        bat_trace_end_loops(&trace->faces[i].loops);
        bat_chart_end(&trace->faces[i].chart);
    }
    bat_release(trace->faces);
    bat_release(trace->balance);
    bat_release(trace->cuts);
    bat_builder_end(&trace->builder);
}

static batten_status trace_all_steps(bat_trace *trace, int **numbers)
{
    batten_status status = copy_edges(trace);
    if (status == BATTEN_OK)
        status = begin_faces(trace);
    if (status == BATTEN_OK)
        status = bat_trace_divide(trace);
    if (status == BATTEN_OK)
        status = for_faces(trace, trace_face, "tracing faces");
    if (status == BATTEN_OK)
        status = cut_faces(trace);
    if (status == BATTEN_OK)
        status = for_faces(trace, bat_trace_close, "closing loops");
    if (status == BATTEN_OK)
        status = put_numbered(trace, numbers);
    return status;
}

batten_status bat_body_trace(const batten_body *body, double tolerance, const batten_job *job,
                             batten_notes *notes, batten_body_trace_report *report,
                             bat_traced *out)
{
    const batten_body_parts *from = batten_body_view(body);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    bat_trace trace = {.from = from, .tolerance = tolerance, .job = job, .notes = notes};
    const batten_box box = bat_body_edge_box(body);
    bat_traced made = {.tolerance = tolerance};
    trace.size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    bat_builder_begin(&trace.builder, from->tolerance);
    batten_status status = trace_all_steps(&trace, &made.numbers);
    if (status == BATTEN_OK) {
        trace.builder.parts.tolerance = bat_max(from->tolerance, trace.report.error);
        trace.builder.parts.is_traced = true;
        status = bat_builder_finish(&trace.builder, from->is_solid, &made.body);
    }
    trace.report.poles = bat_max_int(0, trace.report.poles);
    if (status == BATTEN_OK && report)
        *report = trace.report;
    if (status == BATTEN_OK)
        *out = made;
    else
        bat_traced_end(&made);
    trace_end(&trace);
    return status;
}

void bat_traced_end(bat_traced *traced)
{
    batten_body_unref(traced->body);
    bat_release(traced->numbers);
    *traced = (bat_traced){0};
}

batten_status batten_body_trace(const batten_body *body, double tolerance,
                                const batten_job *job, batten_notes *notes,
                                batten_body_trace_report *report, batten_body **out)
{
    bat_traced traced = {0};
    const batten_status status = bat_body_trace(body, tolerance, job, notes, report, &traced);
    if (status == BATTEN_OK)
        *out = batten_body_ref(traced.body);
    bat_traced_end(&traced);
    return status;
}
