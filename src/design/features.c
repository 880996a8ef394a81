/* The table of all operations, in the order of the manual, and how one is found by its name. */
#include "design/feature.h"
#include "design/text/spelling.h"

#include <assert.h>
#include <string.h>

/* All operations, in the order in which the manual shows them: GROUP begins a group of them. */
#define GROUP(title)
#define ROW(name) extern const bat_feature bat_feature_##name;
#include "design/features.list"
#undef ROW
#define ROW(name) &bat_feature_##name,
static const bat_feature *const features[] = {
#include "design/features.list"
};
#undef ROW
#undef GROUP

#define FEATURE_COUNT ((int)(sizeof features / sizeof features[0]))

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

const bat_feature *bat_feature_at(int index)
{
    assert(index >= 0 && index < FEATURE_COUNT);
    return features[index];
}

const batten_feature *batten_feature_at(int index)
{
    return &bat_feature_at(index)->shown;
}

const char *batten_feature_group(int index)
{
    assert(index >= 0 && index < FEATURE_COUNT);
    return group_of(index);
}

const bat_feature *bat_feature_find(const char *name)
{
    for (int i = 0; i < FEATURE_COUNT; i++)
        if (strcmp(features[i]->shown.name, name) == 0)
            return features[i];
    return NULL;
}

const batten_feature *batten_feature_find(const char *name)
{
    const bat_feature *found = bat_feature_find(name);
    return found ? &found->shown : NULL;
}

const char *batten_feature_nearest(const char *name)
{
    const char *near = NULL;
    int best = 99;
    for (int i = 0; i < FEATURE_COUNT; i++)
        if (bat_is_nearer(name, features[i]->shown.name, &best))
            near = features[i]->shown.name;
    return near;
}
