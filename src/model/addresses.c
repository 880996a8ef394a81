/* Addresses and a number for each, in a table of hashes. */
#include "model/addresses.h"

#include <stdint.h>

/* Where the address is in the table, or would be. */
static size_t place_of(const bat_addresses *a, const void *address)
{
    const uint64_t mixed = (uint64_t)(uintptr_t)address * 0x9e3779b97f4a7c15u;
    size_t at = (size_t)(mixed >> 20) & (a->capacity - 1);
    while (a->table[at].address && a->table[at].address != address)
        at = (at + 1) & (a->capacity - 1);
    return at;
}

static batten_status grow_table(bat_addresses *a)
{
    const bat_addresses before = *a;
    const size_t capacity = a->capacity ? 2 * a->capacity : 16;
    bat_address *table = bat_array(capacity, sizeof *table);
    if (!table)
        return BATTEN_OUT_OF_MEMORY;
    a->capacity = capacity;
    a->table = table;
    for (size_t i = 0; i < before.capacity; i++)
        if (before.table[i].address)
            a->table[place_of(a, before.table[i].address)] = before.table[i];
    bat_release(before.table);
    return BATTEN_OK;
}

int bat_addresses_find(const bat_addresses *a, const void *address)
{
    const bat_address *found = a->capacity ? &a->table[place_of(a, address)] : NULL;
    return found && found->address ? found->number : -1;
}

batten_status bat_addresses_add(bat_addresses *a, const void *address, int number)
{
    const batten_status status = 2 * (a->count + 1) > a->capacity ? grow_table(a) : BATTEN_OK;
    if (status != BATTEN_OK)
        return status;
    a->table[place_of(a, address)] = (bat_address){address, number};
    a->count++;
    return BATTEN_OK;
}

void bat_addresses_end(bat_addresses *a)
{
    bat_release(a->table);
}
