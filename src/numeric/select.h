/* Order statistics without sorting. */
#ifndef BAT_SELECT_H
#define BAT_SELECT_H
#include <stddef.h>

/* The k-th smallest of `values` [count], k from 0; they are put in another order. Each round
 * throws away at least the pivot. Cost linear in the mean. */
double bat_select(size_t count, double *values, size_t k);

#endif
