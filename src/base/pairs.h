/* A table of pairs of numbers, such as the ends of edges. */
#ifndef BAT_PAIRS_H
#define BAT_PAIRS_H
#include "base/base.h"

typedef struct {
    size_t mask;
    int count, room;
    int (*pairs)[2]; /* [count], in the order of their coming */
    int *table;      /* index + 1, open addresses; 0: empty */
} bat_pairs;

/* For about `expected` pairs; it grows. On failure there is nothing to release. */
batten_status bat_pairs_begin(bat_pairs *pairs, size_t expected);
void bat_pairs_end(bat_pairs *pairs);
/* Without pairs, keeping the room. */
void bat_pairs_clear(bat_pairs *pairs);
/* The index of (a, b), or -1. */
int bat_pairs_find(const bat_pairs *pairs, int a, int b);
/* The same, put in when it is not there: then *index is the last one, pairs->count - 1. */
batten_status bat_pairs_add(bat_pairs *pairs, int a, int b, int *index);

#endif
