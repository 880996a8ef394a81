/* Resolves groups of items, and groups within groups, to their paths. */
#include "exchange/step/read/groups.h"
#include "exchange/step/read/marks.h"

#include <stdio.h>

enum { DEEPEST = 64 };

typedef struct {
    uint32_t instance, outer; /* the group around it; UINT32_MAX for none */
    char name[128];
} group_row;

typedef struct {
    uint32_t item, group;
} member_row;

void bat_step_groups_begin(const bat_step_file *file, bat_step_groups *groups)
{
    *groups = (bat_step_groups){.file = file,
                                .groups = {.size = sizeof(group_row)},
                                .members = {.size = sizeof(member_row)},
                                .relations = {.size = sizeof(uint32_t)},
                                .assignments = {.size = sizeof(uint32_t)}};
}

void bat_step_groups_end(bat_step_groups *groups)
{
    bat_release(groups->groups.items);
    bat_release(groups->members.items);
    bat_release(groups->relations.items);
    bat_release(groups->assignments.items);
}

batten_status bat_step_groups_add(bat_step_groups *groups, const bat_step_instance *instance)
{
    const bat_step_record *record = bat_step_as(groups->file, instance, "GROUP");
    group_row row = {.instance = bat_step_index(groups->file, instance), .outer = UINT32_MAX};
    batten_status status =
        bat_step_get_string(groups->file, record, 0, sizeof row.name, row.name);
    return status == BATTEN_OK ? bat_list_add(groups->file->input, &groups->groups, &row)
                               : bat_step_mark_failed(groups->file, instance, status);
}

/* ---- who lies in what ---- */

static int compare_members(const void *a, const void *b)
{
    const member_row *x = a, *y = b;
    const int by_item = bat_step_compare_indices(x->item, y->item);
    return by_item ? by_item : bat_step_compare_indices(x->group, y->group);
}

/* The group of an instance, by its place in the list; UINT32_MAX when it is none. */
static uint32_t group_at(const bat_step_groups *groups, const bat_step_instance *instance)
{
    const group_row *row =
        bat_step_first_row(&groups->groups, bat_step_index(groups->file, instance));
    return row ? (uint32_t)(row - (const group_row *)groups->groups.items) : UINT32_MAX;
}

static batten_status relate(bat_step_groups *groups, const bat_step_instance *instance)
{
    const bat_step_record *record = bat_step_first(groups->file, instance);
    const bat_step_instance *outer = NULL, *inner = NULL;
    batten_status status = bat_step_get_reference(groups->file, record, 2, &outer);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(groups->file, record, 3, &inner);
    if (status != BATTEN_OK)
        return bat_step_mark_failed(groups->file, instance, status);
    const uint32_t of[2] = {group_at(groups, outer), group_at(groups, inner)};
    if (of[0] != UINT32_MAX && of[1] != UINT32_MAX)
        ((group_row *)groups->groups.items)[of[1]].outer = of[0];
    return BATTEN_OK;
}

static batten_status assign(bat_step_groups *groups, const bat_step_instance *instance)
{
    const bat_step_file *file = groups->file;
    const bat_step_record *record = bat_step_first(file, instance);
    const bat_step_instance *group = NULL;
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_reference(file, record, 0, &group);
    if (status == BATTEN_OK)
        status = bat_step_get_list(file, record, 1, &count, &at);
    member_row row = {.group = status == BATTEN_OK ? group_at(groups, group) : UINT32_MAX};
    for (int k = 0; status == BATTEN_OK && row.group != UINT32_MAX && k < count; k++) {
        const bat_step_instance *item = NULL;
        status = bat_step_item_reference(file, record, &at, &item);
        if (status != BATTEN_OK)
            break;
        row.item = bat_step_index(file, item);
        status = bat_list_add(file->input, &groups->members, &row);
    }
    return bat_step_mark_failed(file, instance, status);
}

batten_status bat_step_groups_resolve(bat_step_groups *groups)
{
    const bat_step_instance *instances = groups->file->instances.items;
    const uint32_t *relations = groups->relations.items,
                   *assignments = groups->assignments.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < groups->relations.count; k++)
        status = relate(groups, &instances[relations[k]]);
    for (size_t k = 0; status == BATTEN_OK && k < groups->assignments.count; k++)
        status = assign(groups, &instances[assignments[k]]);
    bat_step_sort_rows(&groups->members, compare_members);
    return status;
}

/* ---- asking ---- */

bool bat_step_group_of(const bat_step_groups *groups, const bat_step_instance *item,
                       char path[BAT_STEP_PATH])
{
    const member_row *row =
        bat_step_first_row(&groups->members, bat_step_index(groups->file, item));
    const group_row *all = groups->groups.items;
    uint32_t around[DEEPEST];
    int depth = 0;
    size_t length = 0;
    if (!row)
        return false;
    for (uint32_t at = row->group; at != UINT32_MAX && depth < DEEPEST; at = all[at].outer)
        around[depth++] = at;
    path[0] = '\0';
    while (depth-- > 0 && length < BAT_STEP_PATH)
        length += (size_t)snprintf(path + length, BAT_STEP_PATH - length, "%s%s",
                                   length ? "/" : "", all[around[depth]].name);
    return true;
}
