/* Which format bytes are in. */
#ifndef BAT_RECOGNISE_H
#define BAT_RECOGNISE_H
#include "exchange/reading/input.h"

/*
 * By content alone. Formats that are known but not read are refused by name.
 *
 * Text in columns: a first row that says x, y (and z) alone heads points; one that names
 * station, height and half-breadth, station\height or axis,name heads offsets. Rows of two or
 * three numbers are points; a line of text above rows of two numbers, or Lednicer's two counts,
 * an aerofoil.
 */
batten_status bat_recognise(bat_input *input, batten_format *format);

#endif
