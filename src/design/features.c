#include "design/feature.h"
#include "design/value.h"

#include <assert.h>
#include <string.h>

/* All operations, in the order in which the manual shows them. */
#define FEATURES(ROW)                                                                         \
    ROW(read)                                                                                 \
    ROW(points) ROW(interpolate) ROW(interpolate_grid) ROW(fair) ROW(skin) ROW(ruled)         \
        ROW(extrude) ROW(revolve) ROW(line) ROW(polyline) ROW(arc) ROW(circle) ROW(ellipse)   \
            ROW(conic) ROW(cylinder) ROW(cone) ROW(sphere) ROW(torus) ROW(mirror) ROW(move)   \
                ROW(rotate) ROW(scale) ROW(elevate) ROW(reduce) ROW(refine) ROW(remove_knots) \
                    ROW(split) ROW(part) ROW(join) ROW(reverse) ROW(swap) ROW(curve_of)       \
                        ROW(collect) ROW(select) ROW(write) ROW(picture) ROW(lines_plan)      \
                            ROW(check)

#define DECLARE(name) extern const bat_feature bat_feature_##name;
FEATURES(DECLARE)
#undef DECLARE

#define ADDRESS(name) &bat_feature_##name,
static const bat_feature *const features[] = {FEATURES(ADDRESS)};
#undef ADDRESS

#define FEATURE_COUNT ((int)(sizeof features / sizeof features[0]))

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
