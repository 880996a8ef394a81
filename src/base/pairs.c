/* A table of pairs of numbers, with open addresses. */
#include "base/pairs.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>

static size_t place_of(const bat_pairs *pairs, int a, int b)
{
    uint64_t mixed = ((uint64_t)(uint32_t)a << 32 | (uint32_t)b) * 0x9e3779b97f4a7c15u;
    mixed = (mixed ^ mixed >> 32) * 0xd6e8feb86659fd93u;
    return (size_t)(mixed ^ mixed >> 29) & pairs->mask;
}

/* The place of the pair, or of the empty one where it belongs. */
static size_t seek(const bat_pairs *pairs, int a, int b)
{
    size_t at = place_of(pairs, a, b);
    while (pairs->table[at]) {
        const int *known = pairs->pairs[pairs->table[at] - 1];
        if (known[0] == a && known[1] == b)
            break;
        at = (at + 1) & pairs->mask;
    }
    return at;
}

/* Room for twice as many, the table at most half full. */
static batten_status grow_table(bat_pairs *pairs, size_t room)
{
    size_t size = 16;
    while (size < 2 * room)
        size *= 2;
    if (size / 2 > INT_MAX)
        return bat_fail(BATTEN_TOO_LARGE, "a table of %zu pairs", room);
    int(*list)[2] = bat_resize(pairs->pairs, size / 2, sizeof *list);
    if (!list)
        return BATTEN_OUT_OF_MEMORY;
    pairs->pairs = list;
    int *table = bat_array(size, sizeof *table);
    if (!table)
        return BATTEN_OUT_OF_MEMORY;
    bat_release(pairs->table);
    pairs->table = table;
    pairs->mask = size - 1;
    pairs->room = (int)(size / 2);
    for (int i = 0; i < pairs->count; i++)
        table[seek(pairs, list[i][0], list[i][1])] = i + 1;
    return BATTEN_OK;
}

batten_status bat_pairs_begin(bat_pairs *pairs, size_t expected)
{
    *pairs = (bat_pairs){0};
    const batten_status status = grow_table(pairs, expected);
    if (status != BATTEN_OK)
        bat_pairs_end(pairs);
    return status;
}

void bat_pairs_end(bat_pairs *pairs)
{
    bat_release(pairs->pairs);
    bat_release(pairs->table);
    *pairs = (bat_pairs){0};
}

void bat_pairs_clear(bat_pairs *pairs)
{
    pairs->count = 0;
    memset(pairs->table, 0, (pairs->mask + 1) * sizeof *pairs->table);
}

int bat_pairs_find(const bat_pairs *pairs, int a, int b)
{
    return pairs->table[seek(pairs, a, b)] - 1;
}

batten_status bat_pairs_add(bat_pairs *pairs, int a, int b, int *index)
{
    size_t at = seek(pairs, a, b);
    if (pairs->table[at] == 0) {
        if (pairs->count == pairs->room) {
            const batten_status status = grow_table(pairs, 2 * (size_t)pairs->room);
            if (status != BATTEN_OK)
                return status;
            at = seek(pairs, a, b);
        }
        pairs->pairs[pairs->count][0] = a;
        pairs->pairs[pairs->count][1] = b;
        pairs->table[at] = ++pairs->count;
    }
    *index = pairs->table[at] - 1;
    return BATTEN_OK;
}
