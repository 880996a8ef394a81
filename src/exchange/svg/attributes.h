/* What attributes of SVG say in short: transforms and colours. */
#ifndef BAT_SVG_ATTRIBUTES_H
#define BAT_SVG_ATTRIBUTES_H
#include "exchange/reading/input.h"

/* x' = a x + c y + e, y' = b x + d y + f */
typedef struct {
    double a, b, c, d, e, f;
} bat_svg_map;
bat_svg_map bat_svg_compose(bat_svg_map first, bat_svg_map then);

/* "translate(1 2) rotate(30)" and so on. BAD_FORMAT with a message for a note. */
batten_status bat_svg_transform(const bat_input *input, int line, bat_span text,
                                bat_svg_map *map);
/* "#f80", "#ff8800", "rgb(255, 128, 0)", "red"; false for "none" and what is not known. */
bool bat_svg_colour(bat_span text, double rgb[3]);

#endif
