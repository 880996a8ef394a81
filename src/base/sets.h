/* Sets that are joined: `of[i]` leads from each of the numbers 0 .. count - 1 to the lowest of its
 * set, over others of it. */
#ifndef BAT_SETS_H
#define BAT_SETS_H
#include "base/base.h"

/* Each on its own. */
static inline void bat_sets_begin(int count, int *of)
{
    for (int i = 0; i < count; i++)
        of[i] = i;
}

/* The lowest number of the set of i. Paths are halved on the way: many calls cost little more than
 * one step each. */
static inline int bat_sets_root(int *of, int i)
{
    while (of[i] != i)
        i = of[i] = of[of[i]];
    return i;
}

/* The sets of a and b become one; false when they are it already. */
static inline bool bat_sets_join(int *of, int a, int b)
{
    const int i = bat_sets_root(of, a), k = bat_sets_root(of, b);
    of[bat_max_int(i, k)] = bat_min_int(i, k);
    return i != k;
}

#endif
