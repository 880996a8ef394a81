/* Colours of DXF: the numbers 1 to 255, and 24 bits. */
#ifndef BAT_DXF_COLOURS_H
#define BAT_DXF_COLOURS_H
#include "base/base.h"

/* False for 0 (as the block), 256 (as the layer) and what is no colour. */
bool bat_dxf_colour(int index, double rgb[3]);
/* Red in the third byte. */
void bat_dxf_true_colour(int value, double rgb[3]);

#endif
