/* Colours of DXF: the numbers 1 to 255, and 24 bits. */
#ifndef BAT_DXF_COLOURS_H
#define BAT_DXF_COLOURS_H
#include "base/base.h"

/* The colour of what has none: black on white and white on black. */
enum { BAT_DXF_PLAIN = 7 };

/* False for 0 (as the block), 256 (as the layer) and what is no colour. The plain
 * one is black. */
bool bat_dxf_colour(int index, double rgb[3]);
/* Red in the third byte. */
void bat_dxf_true_colour(int value, double rgb[3]);

/* A colour as the file says it. */
typedef struct {
    int index; /* the nearest of the numbers 1 to 255 */
    int full;  /* 24 bits where no number is that colour, also for black, else -1 */
} bat_dxf_colour_code;
bat_dxf_colour_code bat_dxf_code_of_colour(const double rgb[3]);

#endif
