/* Addresses and a number for each, found in constant time. */
#ifndef BAT_ADDRESSES_H
#define BAT_ADDRESSES_H
#include "base/base.h"

typedef struct {
    const void *address; /* NULL: none */
    int number;
} bat_address;

/* Begin with all 0; release by bat_addresses_end. */
typedef struct {
    size_t count, capacity; /* of the table, a power of 2 */
    bat_address *table;
} bat_addresses;

/* The number of an address, or -1. */
int bat_addresses_find(const bat_addresses *addresses, const void *address);
/* Add one that is not there. */
batten_status bat_addresses_add(bat_addresses *addresses, const void *address, int number);
void bat_addresses_end(bat_addresses *addresses);

#endif
