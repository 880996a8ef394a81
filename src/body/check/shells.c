/* Whether the shells of a solid have their outside away from the material: by the volumes that
 * they enclose, which are above 0 of the outer shell and below 0 of voids. */
#include "body/check/parts.h"
#include "body/measure/face_integral.h"

#include <stdio.h>

/* The side is asked for, not the volume: a thousandth will do, and what is thinner than its
 * error has no answer. */
static const double PRECISION = 1e-3;
static const size_t MOST = 1u << 18;

/* What the faces of a shell add up to. */
typedef struct {
    bat_face_sums sums;
    bool is_sound; /* each edge is used once each way, and every face was measured */
} shell_sums;

/* Used once each way, or without a length. */
static bool is_matched(const batten_body_parts *p, const bat_edge_ways *ways, int edge)
{
    return !p->edges[edge].curve || (ways[edge].count[0] == 1 && ways[edge].count[1] == 1);
}

static bool is_balanced(const batten_body_parts *p, const batten_body_shell *shell,
                        const bat_edge_ways *ways)
{
    for (int f = shell->first; f < shell->first + shell->count; f++)
        for (int l = p->faces[f].first; l < p->faces[f].first + p->faces[f].count; l++)
            for (int i = 0; i < p->loops[l].count; i++)
                if (!is_matched(p, ways, p->uses[p->loops[l].first + i].edge))
                    return false;
    return shell->count > 0;
}

/* The shell of each face. */
static void find_shells(const batten_body_parts *p, int *shell_of)
{
    for (int s = 0; s < p->shell_count; s++)
        for (int f = p->shells[s].first; f < p->shells[s].first + p->shells[s].count; f++)
            shell_of[f] = s;
}

static batten_status add_faces(bat_check *check, const bat_traced *part,
                               const bat_face_rules *rules, const int *shell_of,
                               shell_sums *shells)
{
    const batten_body_parts *parts = batten_body_view(part->body);
    batten_status status = BATTEN_OK;
    for (int f = 0; f < parts->face_count && status == BATTEN_OK; f++) {
        shell_sums *shell = &shells[shell_of[bat_traced_number(part, f)]];
        bat_face_sums face;
        if (!shell->is_sound)
            continue;
        status = bat_face_integrate(parts, f, rules, &face);
        if (status == BATTEN_OK)
            bat_face_add(&shell->sums, &face);
        if (status == BATTEN_OK)
            status = bat_work_step(&check->work, 1, (double)f / parts->face_count,
                                   "measuring shells");
    }
    return status;
}

static void judge(bat_check *check, int shell, const bat_face_sums *sums, double size)
{
    const double volume = bat_face_volume(sums), error = bat_face_volume_error(sums);
    const bool is_void = shell > 0;
    const double unit = size * size * size;
    char name[32];
    if (!(fabs(volume) > error) || (volume < 0) == is_void)
        return;
    check->faults->turned_shells++;
    snprintf(name, sizeof name, "shell %d", shell + 1);
    batten_notes_add(check->notes, "", 0, name,
                     is_void
                         ? "bounds a void of the solid and is turned outward: its volume is "
                           "%g, within %.2g, and should be below 0"
                         : "bounds the solid and is turned inward: its volume is %g, within "
                           "%.2g, and should be above 0",
                     volume * unit, error * unit);
}

static batten_status measure_shells(bat_check *check, const batten_body *body,
                                    const bat_traced_all *traced, int *shell_of,
                                    shell_sums *shells)
{
    const batten_body_parts *p = check->parts;
    bat_face_rules rules = bat_face_rules_of(body);
    batten_status status = BATTEN_OK;
    rules.area_precision = rules.volume_precision = PRECISION;
    rules.most = MOST;
    find_shells(p, shell_of);
    for (int f = 0; f < p->face_count && traced->failed > 0; f++)
        if (traced->is_failed[f])
            shells[shell_of[f]].is_sound = false;
    for (int i = 0; i < traced->count && status == BATTEN_OK; i++)
        status = add_faces(check, &traced->at[i], &rules, shell_of, shells);
    for (int s = 0; s < p->shell_count && status == BATTEN_OK; s++)
        if (shells[s].is_sound)
            judge(check, s, &shells[s].sums, rules.size);
    return status;
}

batten_status bat_check_shells(bat_check *check, const batten_body *body,
                               const bat_traced_all *traced, const bat_edge_ways *ways)
{
    const batten_body_parts *p = check->parts;
    if (!p->is_solid || traced->rims > 0)
        return BATTEN_OK;
    shell_sums *shells = bat_array((size_t)p->shell_count, sizeof *shells);
    int *shell_of = bat_array((size_t)p->face_count, sizeof *shell_of);
    batten_status status = shells && shell_of ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int s = 0; s < p->shell_count && status == BATTEN_OK; s++)
        shells[s].is_sound = is_balanced(p, &p->shells[s], ways);
    if (status == BATTEN_OK)
        status = measure_shells(check, body, traced, shell_of, shells);
    bat_release(shell_of);
    bat_release(shells);
    return status;
}
