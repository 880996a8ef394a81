/* A box that is found once and kept with what it is around, by whichever thread finds it first. */
#ifndef BAT_KEPT_BOX_H
#define BAT_KEPT_BOX_H
#include "base/base.h"
#include <batten/geometry.h>

typedef struct {
    atomic_int state; /* 0: none, 1: one is being put in, 2: it is there */
    batten_box box;
} bat_kept_box;

static inline void bat_kept_box_begin(bat_kept_box *kept)
{
    atomic_init(&kept->state, 0);
}

/* False when there is none yet. */
static inline bool bat_kept_box_get(const bat_kept_box *kept, batten_box *out)
{
    if (atomic_load_explicit(&kept->state, memory_order_acquire) != 2)
        return false;
    *out = kept->box;
    return true;
}

/* The first to come keeps its own; all find the same. */
static inline void bat_kept_box_put(bat_kept_box *kept, batten_box box)
{
    int none = 0;
    if (!atomic_compare_exchange_strong(&kept->state, &none, 1))
        return;
    kept->box = box;
    atomic_store_explicit(&kept->state, 2, memory_order_release);
}

#endif
