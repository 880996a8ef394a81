/* An arena: many arrays which live and die together, with one release and one check for memory.
 * Inline throughout, so that the sister libraries share it.
 *
 *     bat_arena arena = {0};
 *     double *sums = bat_arena_array(&arena, n, sizeof *sums);
 *     int *order = bat_arena_array(&arena, n, sizeof *order);
 *     batten_status status = bat_arena_status(&arena);
 *     if (status == BATTEN_OK)
 *         ...
 *     bat_arena_free(&arena);
 */
#ifndef BAT_ARENA_H
#define BAT_ARENA_H
#include "base/base.h"

#include <stdint.h>
#include <string.h>

typedef struct bat_arena_block {
    struct bat_arena_block *before;
    size_t used, size;
    _Alignas(16) unsigned char bytes[];
} bat_arena_block;

/* Begin with {0}. */
typedef struct {
    bat_arena_block *last;
    bool failed; /* since bat_arena_status was asked */
} bat_arena;

/* Blocks double from the first size to the last: a few small arrays cost little memory, and
 * many cost few blocks. */
enum { BAT_ARENA_FIRST_BLOCK = 1024, BAT_ARENA_LAST_BLOCK = 16384 };

static inline bat_arena_block *bat_arena_add_block(bat_arena *arena, size_t bytes)
{
    size_t size = BAT_ARENA_FIRST_BLOCK;
    if (arena->last)
        size = 2 * arena->last->size;
    if (size > BAT_ARENA_LAST_BLOCK)
        size = BAT_ARENA_LAST_BLOCK;
    if (size < bytes)
        size = bytes;
    bat_arena_block *block = bat_array(1, sizeof *block + size);
    if (!block)
        return NULL;
    block->size = size;
    block->before = arena->last;
    return arena->last = block;
}

/* Zeroed memory for `count` items, aligned for any type; NULL and the message when there is
 * none. What was taken before stays. */
static inline void *bat_arena_array(bat_arena *arena, size_t count, size_t size)
{
    /* A quarter leaves room for rounding up and for the head of a block. */
    if (size && count > SIZE_MAX / 4 / size) {
        bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for %zu items of %zu bytes", count, size);
        arena->failed = true;
        return NULL;
    }
    const size_t bytes = (count * size + 15) & ~(size_t)15;
    bat_arena_block *block = arena->last;
    if (!block || block->size - block->used < bytes)
        block = bat_arena_add_block(arena, bytes);
    if (!block) {
        arena->failed = true;
        return NULL;
    }
    void *memory = block->bytes + block->used;
    block->used += bytes;
    return memory;
}

/* A copy of bytes with a zero byte after it; NULL and the message when there is no memory. */
static inline char *bat_arena_copy(bat_arena *arena, const char *bytes, size_t length)
{
    char *copy = bat_arena_array(arena, length + 1, 1);
    if (copy && length)
        memcpy(copy, bytes, length);
    return copy;
}

/* BATTEN_OUT_OF_MEMORY when an array was refused since this was last asked. */
static inline batten_status bat_arena_status(bat_arena *arena)
{
    const bool failed = arena->failed;
    arena->failed = false;
    return failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
}

/* Give all of it back; the arena is then empty and may be used again. */
static inline void bat_arena_free(bat_arena *arena)
{
    while (arena->last) {
        bat_arena_block *before = arena->last->before;
        bat_release(arena->last);
        arena->last = before;
    }
    arena->failed = false;
}

#endif
