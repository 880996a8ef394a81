/* What is wrong with a body: its edges and shells, and all the rest asked for. */
#include "body/check/parts.h"
#include "body/edge_box.h"
#include "numeric/vector.h"
#include <batten/measure.h>

#include <stdio.h>
#include <string.h>

/* How the faces use an edge. */
typedef struct {
    int first_face;      /* of those that use it; -1 for none */
    int last_face[2];    /* for each way */
    int shell, in_shell; /* the shell looked at last, and how often that uses it */
} edge_uses;

static void note_edge(const bat_check *check, int edge, const edge_uses *uses, const char *what,
                      double number, const char *unit)
{
    char face[BAT_CHECK_NAME] = "no face", name[32];
    if (uses->first_face >= 0)
        bat_check_face_name(check, uses->first_face, face);
    snprintf(name, sizeof name, "edge %d", edge + 1);
    batten_notes_add(check->notes, "", 0, name, "%s: %g %s; it is of %s", what, number, unit,
                     face);
}

/* ---- uses ---- */

static void count_use(bat_check *check, int face, const batten_body_use *use, edge_uses *uses,
                      bat_edge_ways *ways)
{
    edge_uses *of = &uses[use->edge];
    const int way = use->reversed;
    ways[use->edge].count[way]++;
    if (of->first_face < 0)
        of->first_face = face;
    if (of->last_face[way] != face && of->last_face[!way] == face)
        check->faults->seams++;
    of->last_face[way] = face;
}

static void count_uses(bat_check *check, edge_uses *uses, bat_edge_ways *ways)
{
    const batten_body_parts *p = check->parts;
    for (int e = 0; e < p->edge_count; e++)
        uses[e] = (edge_uses){.first_face = -1, .last_face = {-1, -1}, .shell = -1};
    for (int f = 0; f < p->face_count; f++)
        for (int l = p->faces[f].first; l < p->faces[f].first + p->faces[f].count; l++)
            for (int i = 0; i < p->loops[l].count; i++)
                count_use(check, f, &p->uses[p->loops[l].first + i], uses, ways);
}

/* What number of faces an edge bounds. Those without a curve are poles, of one face each. */
static void check_uses(bat_check *check, int edge, const edge_uses *uses,
                       const bat_edge_ways *ways)
{
    batten_body_faults *faults = check->faults;
    const int count = ways->count[0] + ways->count[1];
    if (count == 0)
        return;
    if (!check->parts->edges[edge].curve) {
        faults->poles++;
    } else if (count == 1) {
        faults->free_edges++;
    } else if (count > 2) {
        faults->crowded_edges++;
        note_edge(check, edge, uses, "more than two uses", count, "uses");
    } else if (ways->count[0] == 1) {
        faults->shared_edges++;
    } else {
        faults->wrong_edges++;
        note_edge(check, edge, uses,
                  "two uses the same way: its faces are turned against "
                  "each other",
                  count, "uses");
    }
}

/* ---- the curves of edges ---- */

static void check_gap(bat_check *check, int edge, const edge_uses *uses, double gap)
{
    check->faults->largest_gap = bat_max(check->faults->largest_gap, gap);
    if (gap <= check->tolerance)
        return;
    check->faults->gaps++;
    note_edge(check, edge, uses, "an end of the curve misses its vertex", gap, "units");
}

/* A polyline through a few places of each span is shorter than the curve. */
static batten_status is_tiny(const batten_curve *curve, double tolerance, bool *tiny,
                             double *length)
{
    enum { PLACES = 4 };
    const batten_interval d = batten_curve_domain(curve);
    double at[3], before[3];
    *tiny = false;
    *length = 0;
    batten_status status = batten_curve_evaluate(curve, d.a, 0, before);
    for (int i = 1; i <= PLACES && status == BATTEN_OK; i++, memcpy(before, at, sizeof at)) {
        status = batten_curve_evaluate(curve, d.a + (d.b - d.a) * i / PLACES, 0, at);
        if (status == BATTEN_OK)
            *length += bat_distance(3, at, before);
    }
    if (status != BATTEN_OK || *length >= tolerance)
        return status;
    status = batten_curve_length(curve, tolerance / 100, NULL, length);
    *tiny = *length < tolerance;
    return status == BATTEN_TOLERANCE_NOT_MET ? BATTEN_OK : status;
}

static batten_status check_curve(bat_check *check, int edge, const edge_uses *uses)
{
    const batten_body_edge *of = &check->parts->edges[edge];
    if (!of->curve)
        return BATTEN_OK;
    const batten_interval d = batten_curve_domain(of->curve);
    bool tiny = false, close = false;
    double length = 0, knot_gap = 0;
    for (int end = 0; end < 2; end++) {
        double at[3];
        const batten_status status = batten_curve_evaluate_side(
            of->curve, end ? d.b : d.a, end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 0, at);
        if (status != BATTEN_OK)
            return status;
        check_gap(check, edge, uses,
                  bat_distance(3, at, check->parts->vertices + 3 * (size_t)of->vertices[end]));
    }
    batten_status status = is_tiny(of->curve, check->tolerance, &tiny, &length);
    if (status == BATTEN_OK && tiny) {
        check->faults->tiny_edges++;
        note_edge(check, edge, uses, "shorter than the tolerance", length, "units");
    }
    if (status == BATTEN_OK)
        status = bat_check_curve_knots(of->curve, &close, &knot_gap);
    if (status == BATTEN_OK && close) {
        check->faults->close_knots++;
        note_edge(check, edge, uses, "its curve has knots very near each other", knot_gap,
                  "of the domain");
    }
    return status;
}

/* ---- shells ---- */

static void check_shell(bat_check *check, int shell, edge_uses *uses)
{
    const batten_body_parts *p = check->parts;
    const batten_body_shell *of = &p->shells[shell];
    int rim = 0;
    for (int f = of->first; f < of->first + of->count; f++)
        for (int l = p->faces[f].first; l < p->faces[f].first + p->faces[f].count; l++)
            for (int i = 0; i < p->loops[l].count; i++) {
                const int edge = p->uses[p->loops[l].first + i].edge;
                edge_uses *e = &uses[edge];
                if (e->shell != shell)
                    e->in_shell = 0;
                e->shell = shell;
                e->in_shell++;
                if (p->edges[edge].curve)
                    rim += e->in_shell == 1 ? 1 : e->in_shell == 2 ? -1 : 0;
            }
    if (rim == 0 || !of->closed)
        return;
    char name[32];
    check->faults->open_shells++;
    snprintf(name, sizeof name, "shell %d", shell + 1);
    batten_notes_add(check->notes, "", 0, name,
                     "is marked as closed, but %d of its edges have one face only", rim);
}

/* ---- faces ---- */

static batten_status check_face(bat_check *check, int face)
{
    bool close = false;
    double gap = 0;
    char name[BAT_CHECK_NAME];
    batten_status status = bat_check_misses(check, face);
    if (status == BATTEN_OK)
        status = bat_check_surface_knots(check->parts->faces[face].surface, &close, &gap);
    if (status == BATTEN_OK && close) {
        check->faults->close_knots++;
        batten_notes_add(check->notes, "", 0, bat_check_face_name(check, face, name),
                         "its surface has knots very near each other: %g of the domain", gap);
    }
    if (status == BATTEN_OK)
        status = bat_work_step(&check->work, 1, (double)face / check->parts->face_count,
                               "checking faces");
    return status;
}

static batten_status check_all_loops(bat_check *check)
{
    const int count = check->parts->face_count;
    batten_status status = BATTEN_OK;
    for (int f = 0; f < count && status == BATTEN_OK; f++) {
        status = bat_check_loops(check, f);
        if (status == BATTEN_OK)
            status = bat_work_step(&check->work, 1, (double)f / count, "checking loops");
    }
    return status;
}

/* Loops are looked at where they have curves in the parameters, which tracing gives them. */
static batten_status check_traced(bat_check *check, const bat_traced_all *traced)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < traced->count && status == BATTEN_OK; i++) {
        bat_check loops = *check;
        loops.parts = batten_body_view(traced->at[i].body);
        loops.numbers = traced->at[i].numbers;
        status = check_all_loops(&loops);
    }
    return status;
}

/* The loops of faces, and to which side they face. */
static batten_status check_loops(bat_check *check, const batten_body *body,
                                 const bat_edge_ways *ways)
{
    const batten_box box = bat_body_edge_box(body);
    bat_traced_all traced;
    batten_status status = bat_trace_all(
        body,
        bat_max(check->tolerance, 1e-3 * bat_vec3_norm(bat_vec3_subtract(box.high, box.low))),
        check->work.job, &traced);
    if (status != BATTEN_OK)
        return status;
    for (int f = 0; f < check->parts->face_count && traced.failed > 0; f++) {
        char name[BAT_CHECK_NAME];
        if (traced.is_failed[f])
            batten_notes_add(check->notes, "", 0, bat_check_face_name(check, f, name),
                             "its loops cannot be closed in the parameters of its surface");
    }
    status = check_traced(check, &traced);
    if (status == BATTEN_OK)
        status = bat_check_shells(check, body, &traced, ways);
    bat_trace_all_end(&traced);
    return status;
}

static batten_status check_edges(bat_check *check, edge_uses *uses, bat_edge_ways *ways)
{
    batten_status status = BATTEN_OK;
    count_uses(check, uses, ways);
    for (int e = 0; e < check->parts->edge_count && status == BATTEN_OK; e++) {
        check_uses(check, e, &uses[e], &ways[e]);
        status = check_curve(check, e, &uses[e]);
    }
    for (int s = 0; s < check->parts->shell_count && status == BATTEN_OK; s++)
        check_shell(check, s, uses);
    return status;
}

batten_status batten_body_check(const batten_body *body, double tolerance,
                                const batten_job *job, batten_notes *notes,
                                batten_body_faults *out)
{
    assert(body && out);
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be positive",
                        tolerance);
    const batten_body_parts *parts = batten_body_view(body);
    batten_body_faults faults = {.gaps = 0};
    bat_check check = {parts, tolerance, {.job = job}, notes, &faults, parts, NULL};
    edge_uses *uses = bat_array((size_t)parts->edge_count, sizeof *uses);
    bat_edge_ways *ways = bat_array((size_t)parts->edge_count, sizeof *ways);
    batten_status status = uses && ways ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = check_edges(&check, uses, ways);
    for (int f = 0; f < parts->face_count && status == BATTEN_OK; f++)
        status = check_face(&check, f);
    if (status == BATTEN_OK)
        status = check_loops(&check, body, ways);
    bat_release(ways);
    bat_release(uses);
    if (status == BATTEN_OK)
        *out = faults;
    return status;
}
