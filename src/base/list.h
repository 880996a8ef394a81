/* The one growing array: three members `T *items; int count, room;` (or size_t) of whatever
 * struct holds it. Inline throughout, so that the sister libraries share it. */
#ifndef BAT_LIST_H
#define BAT_LIST_H
#include "base/base.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>

/* Make room for `more` items behind the first `count` of `items`, which has room for `room`:
 *
 *     batten_status status = BAT_LIST_GROW(l->items, l->count, l->room, 3);
 *
 * On BATTEN_OUT_OF_MEMORY, the only failure, all is as it was. New items are not zeroed. Begin
 * with {NULL, 0, 0} and end with bat_release(items). `count` and `room` are both int or both
 * size_t; nothing else compiles. */
#define BAT_LIST_GROW(items, count, room, more) \
    _Generic(&(room), int *: bat_list_grow_int, size_t *: bat_list_grow_size) \
        ((void *)&(items), (count), &(room), (more), sizeof *(items))

/* Append one item: `status = BAT_LIST_ADD(l->items, l->count, l->room, (point){x, y});` The
 * first three are evaluated more than once. */
#define BAT_LIST_ADD(items, count, room, ...)                      \
    (BAT_LIST_GROW(items, count, room, 1) == BATTEN_OK             \
         ? ((void)((items)[(count)++] = (__VA_ARGS__)), BATTEN_OK) \
         : BATTEN_OUT_OF_MEMORY)

/* Never less than this at first: most lists are short, and few are empty. */
enum { BAT_LIST_FIRST_ROOM = 8 };

/* The room to ask for when `needed` items no longer fit in `room`: doubled, so that n items
 * move no more than 2 n times in all, while that can be counted. */
static inline size_t bat_list_next_room(size_t room, size_t needed)
{
    size_t next = room < BAT_LIST_FIRST_ROOM ? BAT_LIST_FIRST_ROOM : room;
    while (next < needed && next <= SIZE_MAX / 2)
        next *= 2;
    return next < needed ? needed : next;
}

/* @param items  the address of the pointer to the items, of whatever type */
static inline batten_status bat_list_move(void *items, size_t *room, size_t count, size_t more,
                                          size_t most, size_t size)
{
    if (more > most - count)
        return bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for %zu items more than %zu", more,
                        count);
    size_t wanted = bat_list_next_room(*room, count + more);
    if (wanted > most)
        wanted = most;
    void *old;
    memcpy(&old, items, sizeof old);
    void *larger = bat_resize(old, wanted, size);
    if (!larger)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(items, &larger, sizeof larger);
    *room = wanted;
    return BATTEN_OK;
}

static inline batten_status bat_list_grow_size(void *items, size_t count, size_t *room,
                                               size_t more, size_t size)
{
    return more <= *room - count ? BATTEN_OK
                                 : bat_list_move(items, room, count, more, SIZE_MAX, size);
}

static inline batten_status bat_list_grow_int(void *items, int count, int *room, int more,
                                              size_t size)
{
    if (more <= *room - count)
        return BATTEN_OK;
    size_t wide = (size_t)*room;
    const batten_status status =
        bat_list_move(items, &wide, (size_t)count, (size_t)more, INT_MAX, size);
    *room = (int)wide;
    return status;
}

#endif
