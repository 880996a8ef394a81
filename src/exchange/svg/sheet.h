/* The sheet of an SVG drawing. */
#ifndef BAT_SVG_SHEET_H
#define BAT_SVG_SHEET_H
#include "exchange/svg/path_data.h"
#include "exchange/svg/svg.h"
#include "exchange/svg/xml.h"

bool bat_svg_says(bat_span text, const char *word);
/* From the numbers of the drawing to millimetres with y upwards, from the lower left corner. */
bat_svg_map bat_svg_sheet_of(const bat_xml *xml);

#endif
