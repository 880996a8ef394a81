/* Parameter curves for bodies that have none. */
#include "mesh/faces/meshing.h"

#include <stdio.h>

static bool needs_tracing(const batten_body_parts *parts)
{
    bool needs = !parts->is_traced;
    for (int i = 0; i < parts->face_count; i++)
        needs = needs || parts->faces[i].count == 0;
    return needs;
}

enum { NAME = 24 };

/* The same body, each face named by its number. */
static batten_status number_faces(const batten_body *body, batten_body **out)
{
    batten_body_parts parts = *batten_body_view(body);
    const size_t count = (size_t)parts.face_count;
    batten_body_face *faces = bat_array(count, sizeof *faces);
    char(*names)[NAME] = bat_array(count, sizeof *names);
    batten_status status = faces && names ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < count; i++) {
        snprintf(names[i], sizeof names[i], "%zu", i);
        faces[i] = parts.faces[i];
        faces[i].name = names[i];
    }
    parts.faces = faces;
    if (status == BATTEN_OK)
        status = batten_body_create(&parts, out);
    bat_release(names);
    bat_release(faces);
    return status;
}

/* Some faces failed: once more with numbers for names, to know which are left. */
static batten_status trace_numbered(const bat_meshing *m, const batten_body *body,
                                    double tolerance, batten_body **traced, int **names)
{
    batten_body *numbered = NULL, *made = NULL;
    batten_trace_report report;
    batten_status status = number_faces(body, &numbered);
    if (status == BATTEN_OK)
        status = batten_body_trace(numbered, tolerance, m->job, NULL, &report, &made);
    batten_body_unref(numbered);
    if (status != BATTEN_OK)
        return status;
    const batten_body_parts *parts = batten_body_view(made);
    *names = bat_array((size_t)parts->face_count, sizeof **names);
    if (!*names) {
        batten_body_unref(made);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (int i = 0; i < parts->face_count; i++)
        for (const char *digit = parts->faces[i].name; *digit; digit++)
            (*names)[i] = 10 * (*names)[i] + (*digit - '0');
    *traced = made;
    return BATTEN_OK;
}

/* Files promise more than they keep: where edges are farther off their faces than they say, but
 * not farther than tracing bears or triangles may be, the faces are meshed all the same. The
 * edges stay what is shared. */
static batten_status trace_loosely(const bat_meshing *m, const batten_body *body,
                                   double *tolerance, batten_trace_report *told,
                                   batten_body **out)
{
    /* The body's own first: near poles coarse curves swing about in (u, v). */
    static const double parts[] = {0, 0.05, 0.3, 1};
    const double own = batten_body_view(body)->tolerance;
    batten_body *best = NULL;
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < sizeof parts / sizeof *parts && (i == 0 || told->failed > 0); i++) {
        const double tried = bat_max(own, parts[i] * m->chord);
        batten_trace_report report;
        batten_body *made = NULL;
        if (i > 0 && tried == own)
            continue;
        status = batten_body_trace(body, tried, m->job, NULL, &report, &made);
        if (status != BATTEN_OK)
            break;
        const bool better = !best || report.failed < told->failed;
        if (better) {
            *tolerance = tried;
            *told = report;
        }
        batten_body_unref(better ? best : made);
        best = better ? made : best;
    }
    if (status == BATTEN_OK)
        *out = best;
    else
        batten_body_unref(best);
    return status;
}

/* The faces left out, each with a note, and the numbers of the others. */
static batten_status name_faces(bat_meshing *m, const batten_body *body, double tolerance,
                                batten_body **traced, int **names)
{
    batten_trace_report report;
    batten_body *again = NULL;
    batten_status status =
        batten_body_trace(body, tolerance, m->job, m->notes, &report, &again);
    batten_body_unref(again);
    if (status == BATTEN_OK)
        status = trace_numbered(m, body, tolerance, traced, names);
    return status;
}

batten_status bat_meshing_trace(bat_meshing *m, const batten_body *body, batten_body **traced,
                                int **names)
{
    const batten_body_parts *parts = batten_body_view(body);
    batten_trace_report told = {0};
    double tolerance = 0;
    *names = NULL;
    if (!needs_tracing(parts)) {
        *traced = batten_body_ref(body);
        return BATTEN_OK;
    }
    batten_body *made = NULL;
    batten_status status = trace_loosely(m, body, &tolerance, &told, &made);
    if (status != BATTEN_OK)
        return status;
    m->report.failed += told.failed;
    if (told.miss > bat_max(parts->tolerance, 0.05 * m->chord))
        batten_notes_remark(m->notes, "", 0, "",
                            "edges are up to %g off their faces, more than %g, which the body "
                            "states",
                            told.miss, parts->tolerance);
    if (told.failed == 0) {
        *traced = made;
        return BATTEN_OK;
    }
    batten_body_unref(made);
    return name_faces(m, body, tolerance, traced, names);
}
