/* Groups of items, and groups within groups. */
#ifndef BAT_STEP_GROUPS_H
#define BAT_STEP_GROUPS_H
#include "exchange/step/text/instances.h"

enum { BAT_STEP_PATH = 1024 };

typedef struct {
    const bat_step_file *file;
    bat_list groups;      /* with the group that each lies in, by their instances */
    bat_list members;     /* items with their group, by their instances */
    bat_list relations;   /* uint32_t: GROUP_RELATIONSHIPs */
    bat_list assignments; /* uint32_t: APPLIED_GROUP_ASSIGNMENTs */
} bat_step_groups;

void bat_step_groups_begin(const bat_step_file *file, bat_step_groups *groups);
void bat_step_groups_end(bat_step_groups *groups);
/* Take in a GROUP; in the order of their instances. */
batten_status bat_step_groups_add(bat_step_groups *groups, const bat_step_instance *instance);
/* Once all are in: who lies in what. What is broken is noted and without effect. */
batten_status bat_step_groups_resolve(bat_step_groups *groups);
/* The path "outer/inner" of the group that the item is in; false when it is in none. A ring of
 * groups, or more than 64 of them, is cut. */
bool bat_step_group_of(const bat_step_groups *groups, const bat_step_instance *item,
                       char path[BAT_STEP_PATH]);

#endif
