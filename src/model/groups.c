/* Objects in groups within groups, visited one group after another. */
#include "model/groups.h"
#include "base/list.h"

#include <batten/text.h>
#include <stdlib.h>
#include <string.h>

batten_status bat_members_add(bat_members *list, const char *path, int item)
{
    return BAT_LIST_ADD(list->members, list->count, list->capacity, (bat_member){path, item});
}

void bat_members_end(bat_members *list)
{
    bat_release(list->members);
    *list = (bat_members){0};
}

/* '/' comes before all other characters. */
static int compare_paths(const char *s, const char *t)
{
    while (*s && *s == *t) {
        s++;
        t++;
    }
    const int c = *s == '/' ? 1 : 2 * (unsigned char)*s;
    const int d = *t == '/' ? 1 : 2 * (unsigned char)*t;
    return (c > d) - (c < d);
}

static int compare(const void *a, const void *b)
{
    const bat_member *p = a, *q = b;
    const int order = compare_paths(p->path, q->path);
    return order ? order : (p->item > q->item) - (p->item < q->item);
}

void bat_members_sort(bat_members *list)
{
    if (list->count > 0)
        qsort(list->members, (size_t)list->count, sizeof *list->members, compare);
}

const bat_member *bat_members_find(const bat_members *list, const char *path)
{
    int low = 0, high = list->count - 1;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (compare_paths(list->members[middle].path, path) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    assert(low < list->count && strcmp(list->members[low].path, path) == 0);
    return &list->members[low];
}

int bat_members_same(const bat_members *list, int first)
{
    const bat_member *members = &list->members[first];
    int same = 1;
    while (first + same < list->count && strcmp(members[same].path, members[0].path) == 0)
        same++;
    return same;
}

/* ---- groups within groups ---- */

/* The groups that are entered: where the name of each ends in the path. */
typedef struct {
    const bat_group_visitor *visitor;
    const char *path;
    size_t ends[BAT_GROUPS_DEEPEST];
    int depth;
} group_visit;

/* Leave the groups that the path does not lie in. */
static batten_status leave(group_visit *v, const char *path)
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && v->depth > 0) {
        const size_t end = v->ends[v->depth - 1];
        if (strncmp(v->path, path, end) == 0 && (path[end] == 0 || path[end] == '/'))
            break;
        status = v->visitor->leave(v->visitor->context, --v->depth);
    }
    return status;
}

static batten_status enter(group_visit *v, const char *path)
{
    size_t at = v->depth ? v->ends[v->depth - 1] : 0;
    batten_status status = BATTEN_OK;
    while (path[at] && v->depth < BAT_GROUPS_DEEPEST && status == BATTEN_OK) {
        const size_t from = at + (path[at] == '/');
        const bool last = v->depth + 1 == BAT_GROUPS_DEEPEST;
        const size_t length = last ? strlen(path + from) : strcspn(path + from, "/");
        batten_text name = BATTEN_TEXT;
        batten_text_bytes(&name, path + from, length);
        status = name.failed ? BATTEN_OUT_OF_MEMORY
                             : v->visitor->enter(v->visitor->context, v->depth, name.bytes);
        batten_text_free(&name);
        at = from + length;
        v->ends[v->depth++] = at;
    }
    v->path = path;
    return status;
}

batten_status bat_groups_visit(bat_members *list, const bat_group_visitor *visitor)
{
    group_visit v = {.visitor = visitor, .path = ""};
    batten_status status = BATTEN_OK;
    bat_members_sort(list);
    for (int i = 0, count; i < list->count && status == BATTEN_OK; i += count) {
        const char *path = list->members[i].path;
        count = bat_members_same(list, i);
        status = leave(&v, path);
        if (status == BATTEN_OK)
            status = enter(&v, path);
        if (status == BATTEN_OK)
            status = visitor->items(visitor->context, v.depth - 1, &list->members[i], count);
    }
    while (status == BATTEN_OK && v.depth > 0)
        status = visitor->leave(visitor->context, --v.depth);
    return status;
}
