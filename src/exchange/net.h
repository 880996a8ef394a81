/* Nets of control points, which files list with u fastest. */
#ifndef BAT_NET_H
#define BAT_NET_H
#include "exchange/input.h"

/* Numbers that run with u fastest, `width` at a time, put into our order, v fastest; NULL stays
 * NULL. */
batten_status bat_net_transpose(bat_input *input, size_t count_u, size_t count_v, size_t width,
                                double **values);

#endif
