/* OFF: vertices and polygons as text. It is read. Source: [Geomview]. */
#ifndef BAT_OFF_H
#define BAT_OFF_H
#include "exchange/reading/input.h"
#include <batten/exchange.h>

/* By the first word: OFF, with C for colours and N for normals before it. Other forms are
 * refused. */
batten_status bat_off_recognise(const bat_input *input, bool *is_such);
batten_status bat_read_off(bat_input *input, batten_model **out);

#endif
