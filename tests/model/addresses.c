/* Addresses and the numbers that are kept with them. */
#include "model/addresses.h"
#include "support/test.h"

TEST(every_address_has_the_number_that_it_was_given_and_no_other_is_known)
{
    enum { MANY = 2000 };
    static char places[2 * MANY];
    bat_addresses addresses = {0};
    CHECK_INT(bat_addresses_find(&addresses, places), -1);
    for (int i = 0; i < MANY; i++) {
        CHECK_INT(bat_addresses_find(&addresses, places + 2 * i), -1);
        CHECK_OK(bat_addresses_add(&addresses, places + 2 * i, 7 * i));
        CHECK_INT(bat_addresses_find(&addresses, places + 2 * i), 7 * i);
    }
    CHECK_INT((long long)addresses.count, MANY);
    CHECK(addresses.capacity > MANY && (addresses.capacity & (addresses.capacity - 1)) == 0);
    for (int i = 0; i < MANY; i++) {
        CHECK_INT(bat_addresses_find(&addresses, places + 2 * i), 7 * i);
        CHECK_INT(bat_addresses_find(&addresses, places + 2 * i + 1), -1);
    }
    bat_addresses_end(&addresses);
}
