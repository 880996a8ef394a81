#include "body/trace/all.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool bat_is_traced(const batten_body_parts *parts)
{
    bool is = parts->is_traced;
    for (int f = 0; f < parts->face_count; f++)
        is = is && parts->faces[f].count > 0;
    return is;
}

/* ---- some faces of a body, named by their numbers ---- */

enum { NAME = 16 };

typedef struct {
    batten_body_use *uses;
    batten_body_loop *loops;
    batten_body_face *faces;
    char (*names)[NAME];
} room;

static batten_status make_room(const batten_body_parts *parts, room *r)
{
    r->uses = bat_array((size_t)parts->use_count + 1, sizeof *r->uses);
    r->loops = bat_array((size_t)parts->loop_count + 1, sizeof *r->loops);
    r->faces = bat_array((size_t)parts->face_count + 1, sizeof *r->faces);
    r->names = bat_array((size_t)parts->face_count + 1, sizeof *r->names);
    return r->uses && r->loops && r->faces && r->names ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void end_room(room *r)
{
    bat_release(r->uses);
    bat_release(r->loops);
    bat_release(r->faces);
    bat_release(r->names);
}

static batten_status take_faces(const batten_body_parts *from, const bool *wanted,
                                batten_body **out)
{
    batten_body_parts some = *from;
    room r = {0};
    batten_status status = make_room(from, &r);
    some.use_count = some.loop_count = some.face_count = 0;
    for (int f = 0; f < from->face_count && status == BATTEN_OK; f++) {
        const batten_body_face *face = &from->faces[f];
        if (!wanted[f])
            continue;
        batten_body_face *made = &r.faces[some.face_count];
        *made = *face;
        made->first = some.loop_count;
        snprintf(r.names[some.face_count], NAME, "%d", f);
        made->name = r.names[some.face_count++];
        for (int l = face->first; l < face->first + face->count; l++) {
            const batten_body_loop loop = from->loops[l];
            r.loops[some.loop_count++] = (batten_body_loop){some.use_count, loop.count};
            memcpy(r.uses + some.use_count, from->uses + loop.first,
                   (size_t)loop.count * sizeof *r.uses);
            some.use_count += loop.count;
        }
    }
    const batten_body_shell shell = {0, some.face_count, false};
    some.uses = r.uses;
    some.loops = r.loops;
    some.faces = r.faces;
    some.shells = &shell;
    some.shell_count = some.face_count > 0;
    some.is_solid = false;
    if (status == BATTEN_OK)
        status = batten_body_create(&some, out);
    end_room(&r);
    return status;
}

/* ---- rounds ---- */

/* Keep what was traced, with the numbers that the names are. */
static batten_status keep(batten_body *traced, double tolerance, bat_traced_all *all)
{
    const batten_body_parts *parts = batten_body_view(traced);
    int *numbers = bat_array((size_t)parts->face_count + 1, sizeof *numbers);
    if (!numbers) {
        batten_body_unref(traced);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (int f = 0; f < parts->face_count; f++) {
        numbers[f] = (int)strtol(parts->faces[f].name, NULL, 10);
        all->is_failed[numbers[f]] = false;
    }
    all->at[all->count++] = (bat_traced){traced, numbers, tolerance};
    return BATTEN_OK;
}

static batten_status trace_round(const batten_body_parts *from, double tolerance,
                                 const batten_job *job, bat_traced_all *all)
{
    batten_body *some = NULL, *traced = NULL;
    batten_trace_report report = {0};
    batten_status status = take_faces(from, all->is_failed, &some);
    if (status == BATTEN_OK)
        status = batten_body_trace(some, tolerance, job, NULL, &report, &traced);
    if (status == BATTEN_OK)
        status = keep(traced, tolerance, all);
    batten_body_unref(some);
    all->rims += report.rims;
    all->failed = 0;
    for (int f = 0; f < from->face_count; f++)
        all->failed += all->is_failed[f];
    return status;
}

batten_status bat_trace_all(const batten_body *body, double coarsest, const batten_job *job,
                            bat_traced_all *out)
{
    const batten_body_parts *from = batten_body_view(body);
    bat_traced_all all = {.failed = from->face_count};
    if (bat_is_traced(from)) {
        *out = (bat_traced_all){.count = 1, .at = {{.body = batten_body_ref(body)}}};
        return BATTEN_OK;
    }
    all.is_failed = bat_array((size_t)from->face_count + 1, sizeof *all.is_failed);
    batten_status status = all.is_failed ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int f = 0; f < from->face_count && status == BATTEN_OK; f++)
        all.is_failed[f] = true;
    double tolerance = from->tolerance;
    for (bool last = false; status == BATTEN_OK && all.failed > 0 && !last; tolerance *= 10) {
        last = tolerance * 10 > coarsest || all.count + 1 == BAT_TRACE_ROUNDS;
        status = trace_round(from, tolerance, job, &all);
    }
    if (status == BATTEN_OK)
        *out = all;
    else
        bat_trace_all_end(&all);
    return status;
}

void bat_trace_all_end(bat_traced_all *all)
{
    for (int i = 0; i < all->count; i++) {
        batten_body_unref(all->at[i].body);
        bat_release(all->at[i].numbers);
    }
    bat_release(all->is_failed);
    *all = (bat_traced_all){0};
}
