/* Common numbers as text: those of few digits, without long arithmetic. */
#ifndef BAT_BASE_NUMBER_COMMON_H
#define BAT_BASE_NUMBER_COMMON_H
#include "base/real.h"

/* A number that is not whole, from 1e-5 to below 1e8, as most coordinates are: its end, or NULL
 * for others. Up to 24 characters of `to` are overwritten. */
char *bat_number_write_common(char *to, uint64_t bits);

#endif
