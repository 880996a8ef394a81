/* The table of all operations, in the order of the manual, and how one is found by its name. */
#include "design/feature.h"
#include "design/text/spelling.h"

#include <assert.h>

/* All operations, in the order in which the manual shows them: GROUP begins a group of them. */
#define GROUP(title)
#define ROW(name) extern const bat_feature bat_feature_##name;
#include "design/features.list"
#undef ROW
#define ROW(name) &bat_feature_##name,
static const bat_feature *const rows[] = {
#include "design/features.list"
};
#undef ROW
#undef GROUP

#define FEATURE_COUNT ((int)(sizeof rows / sizeof rows[0]))

const bat_features bat_all_features = {FEATURE_COUNT, rows};

/* The group of each: its title stands before its rows. */
static const char *group_of(int index)
{
    const char *group = "";
    int i = 0;
#define GROUP(title) group = (title);
#define ROW(name)       \
    if (i++ == index) { \
        return group;   \
    }
#include "design/features.list"
#undef ROW
#undef GROUP
    return group;
}

int batten_feature_count(void)
{
    return FEATURE_COUNT;
}

const batten_feature *batten_feature_at(int index)
{
    assert(index >= 0 && index < FEATURE_COUNT);
    return &rows[index]->shown;
}

const char *batten_feature_group(int index)
{
    assert(index >= 0 && index < FEATURE_COUNT);
    return group_of(index);
}

const batten_feature *batten_feature_find(const char *name)
{
    const bat_feature *found = bat_features_find(&bat_all_features, name);
    return found ? &found->shown : NULL;
}

const char *batten_feature_nearest(const char *name)
{
    const char *near = NULL;
    int best = 99;
    for (int i = 0; i < FEATURE_COUNT; i++)
        if (bat_is_nearer(name, rows[i]->shown.name, &best))
            near = rows[i]->shown.name;
    return near;
}
