/* Nets of control points, which files list with u fastest. */
#ifndef BAT_NET_H
#define BAT_NET_H
#include "exchange/reading/input.h"

/* count_u x count_v numbers, `width` at a time, that run with u fastest, in our order, v
 * fastest; the caller releases them. */
batten_status bat_net_transpose(bat_input *input, size_t count_u, size_t count_v, size_t width,
                                const double *values, double **out);

#endif
