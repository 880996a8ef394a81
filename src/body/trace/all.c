/* Faces traced round after round, those that fail each time more coarsely. */
#include "body/trace/all.h"

#include <string.h>

bool bat_is_traced(const batten_body_parts *parts)
{
    bool is = parts->is_traced;
    for (int f = 0; f < parts->face_count; f++)
        is = is && parts->faces[f].count > 0;
    return is;
}

/* ---- some faces of a body ---- */

typedef struct {
    batten_body_use *uses;
    batten_body_loop *loops;
    batten_body_face *faces;
} part_lists;

static batten_status make_lists(const batten_body_parts *parts, part_lists *lists)
{
    lists->uses = bat_array((size_t)parts->use_count, sizeof *lists->uses);
    lists->loops = bat_array((size_t)parts->loop_count, sizeof *lists->loops);
    lists->faces = bat_array((size_t)parts->face_count, sizeof *lists->faces);
    return lists->uses && lists->loops && lists->faces ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void release_lists(part_lists *lists)
{
    bat_release(lists->uses);
    bat_release(lists->loops);
    bat_release(lists->faces);
}

/* The wanted faces as a sheet, and their numbers in the given body. */
static batten_status take_faces(const batten_body_parts *from, const bool *wanted, int *numbers,
                                batten_body **out)
{
    batten_body_parts some = *from;
    part_lists lists = {0};
    batten_status status = make_lists(from, &lists);
    some.use_count = some.loop_count = some.face_count = 0;
    for (int f = 0; f < from->face_count && status == BATTEN_OK; f++) {
        const batten_body_face *face = &from->faces[f];
        if (!wanted[f])
            continue;
        numbers[some.face_count] = f;
        lists.faces[some.face_count] = *face;
        lists.faces[some.face_count++].first = some.loop_count;
        for (int l = face->first; l < face->first + face->count; l++) {
            const batten_body_loop loop = from->loops[l];
            lists.loops[some.loop_count++] = (batten_body_loop){some.use_count, loop.count};
            memcpy(lists.uses + some.use_count, from->uses + loop.first,
                   (size_t)loop.count * sizeof *lists.uses);
            some.use_count += loop.count;
        }
    }
    const batten_body_shell shell = {0, some.face_count, false};
    some.uses = lists.uses;
    some.loops = lists.loops;
    some.faces = lists.faces;
    some.shells = &shell;
    some.shell_count = some.face_count > 0;
    some.is_solid = false;
    if (status == BATTEN_OK)
        status = batten_body_create(&some, out);
    release_lists(&lists);
    return status;
}

/* ---- rounds ---- */

/* Keep what was traced of some faces; `numbers` are theirs in the given body. */
static void keep_traced(bat_traced traced, const int *numbers, bat_traced_all *all)
{
    const batten_body_parts *parts = batten_body_view(traced.body);
    for (int f = 0; f < parts->face_count; f++) {
        traced.numbers[f] = numbers[traced.numbers[f]];
        all->is_failed[traced.numbers[f]] = false;
    }
    all->at[all->count++] = traced;
}

static batten_status trace_round(const batten_body_parts *from, double tolerance,
                                 const batten_job *job, bat_traced_all *all)
{
    batten_body *some = NULL;
    bat_traced traced = {0};
    batten_body_trace_report report = {0};
    int *numbers = bat_array((size_t)from->face_count, sizeof *numbers);
    batten_status status = numbers ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = take_faces(from, all->is_failed, numbers, &some);
    if (status == BATTEN_OK)
        status = bat_body_trace(some, tolerance, job, NULL, &report, &traced);
    if (status == BATTEN_OK)
        keep_traced(traced, numbers, all);
    batten_body_unref(some);
    bat_release(numbers);
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
    all.is_failed = bat_array((size_t)from->face_count, sizeof *all.is_failed);
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
    for (int i = 0; i < all->count; i++)
        bat_traced_end(&all->at[i]);
    bat_release(all->is_failed);
    *all = (bat_traced_all){0};
}
