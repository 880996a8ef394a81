#include "design/text/pool.h"

#include <stdint.h>
#include <string.h>

/* Large enough that a usual design needs a handful of blocks. */
#define BLOCK_BYTES ((size_t)16384)

typedef struct bat_block {
    struct bat_block *before;
    size_t used, size;
    _Alignas(16) unsigned char bytes[];
} bat_block;

static bat_block *add_block(bat_pool *pool, size_t bytes)
{
    const size_t size = bytes > BLOCK_BYTES ? bytes : BLOCK_BYTES;
    bat_block *block = bat_array(1, sizeof *block + size);
    if (!block)
        return NULL;
    block->size = size;
    block->before = pool->last;
    return pool->last = block;
}

void *bat_pool_array(bat_pool *pool, size_t count, size_t size)
{
    if (size && count > (SIZE_MAX / 4) / size) {
        bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for %zu items of %zu bytes", count, size);
        return NULL;
    }
    const size_t bytes = (count * size + 15) & ~(size_t)15;
    bat_block *block = pool->last;
    if (!block || block->size - block->used < bytes)
        block = add_block(pool, bytes);
    if (!block)
        return NULL;
    void *memory = block->bytes + block->used;
    block->used += bytes;
    return memory;
}

char *bat_pool_copy(bat_pool *pool, const char *bytes, size_t length)
{
    char *copy = bat_pool_array(pool, length + 1, 1);
    if (copy && length)
        memcpy(copy, bytes, length);
    return copy;
}

void bat_pool_free(bat_pool *pool)
{
    while (pool->last) {
        bat_block *before = pool->last->before;
        bat_release(pool->last);
        pool->last = before;
    }
}
