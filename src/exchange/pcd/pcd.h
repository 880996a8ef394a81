/* PCD: clouds of points of the Point Cloud Library, as text, bytes, or bytes compressed with
 * LZF. It is read. Source: [PCD]. */
#ifndef BAT_PCD_H
#define BAT_PCD_H
#include "exchange/reading/input.h"
#include <batten/exchange.h>

batten_status bat_pcd_recognise(const bat_input *input, bool *is_such);
batten_status bat_read_pcd(bat_input *input, batten_model **out);

/* Undo LZF: `size` bytes from `from` must become exactly `wanted` bytes. BAD_FORMAT otherwise.
 * Source: [LZF]. */
batten_status bat_lzf(const char *from, size_t size, char *to, size_t wanted);

#endif
