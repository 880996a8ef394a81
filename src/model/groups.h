/* Objects in groups within groups, "outer/inner", as files have them: one group after another.
 */
#ifndef BAT_GROUPS_H
#define BAT_GROUPS_H
#include "base/base.h"

/* An item that the file knows by a number, and the path of its group or the name of its layer,
 * which are somebody else's. */
typedef struct {
    const char *path;
    int item;
} bat_member;

typedef struct {
    bat_member *members;
    int count, capacity;
} bat_members;

batten_status bat_members_add(bat_members *list, const char *path, int item);
void bat_members_end(bat_members *list);
/* By path, so that a group stands before those within it; then by item. */
void bat_members_sort(bat_members *list);
/* The first of that path, in what is sorted; it must be there. */
const bat_member *bat_members_find(const bat_members *list, const char *path);
/* How many from `first` on have its path. */
int bat_members_same(const bat_members *list, int first);

enum { BAT_GROUPS_DEEPEST = 64 }; /* deeper, the rest of a path is one name */

/* A group is entered, gets its own items if it has any, then others may be entered and left,
 * and is left. The outermost has depth 0. */
typedef struct {
    void *context;
    batten_status (*enter)(void *context, int depth, const char *name);
    batten_status (*items)(void *context, int depth, const bat_member *members, int count);
    batten_status (*leave)(void *context, int depth);
} bat_group_visitor;
/* Sorts the members. */
batten_status bat_groups_visit(bat_members *list, const bat_group_visitor *visitor);

#endif
