/*
 * The allocator that all memory of the library comes from, which the caller may replace. Sizes
 * are checked for overflow before anything is allocated.
 */
#include "base/base.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void *default_resize(void *user, void *memory, size_t bytes)
{
    (void)user;
    return realloc(memory, bytes);
}

static void default_release(void *user, void *memory)
{
    (void)user;
    free(memory);
}

static const batten_allocator default_allocator = {default_resize, default_release, NULL};
static batten_allocator allocator = {default_resize, default_release, NULL};

void batten_set_allocator(const batten_allocator *chosen)
{
    allocator = chosen ? *chosen : default_allocator;
}

/* The one place where a size is made of factors. */
static bool product(size_t a, size_t b, size_t *bytes)
{
    return !__builtin_mul_overflow(a, b, bytes) && *bytes <= PTRDIFF_MAX;
}

static void *out_of_memory(size_t count, size_t size)
{
    bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for %zu items of %zu bytes", count, size);
    return NULL;
}

void *batten_resize(void *memory, size_t count, size_t size)
{
    size_t bytes;
    if (!product(count, size, &bytes))
        return out_of_memory(count, size);
    void *resized = allocator.resize(allocator.user, memory, bytes ? bytes : 1);
    return resized ? resized : out_of_memory(count, size);
}

void *batten_array(size_t count, size_t size)
{
    void *memory = batten_resize(NULL, count, size);
    if (memory)
        memset(memory, 0, count * size);
    return memory;
}

void *batten_array3(size_t count_u, size_t count_v, size_t size)
{
    size_t count;
    if (!product(count_u, count_v, &count))
        return out_of_memory(SIZE_MAX, size);
    return batten_array(count, size);
}

void batten_release(void *memory)
{
    if (memory)
        allocator.release(allocator.user, memory);
}
