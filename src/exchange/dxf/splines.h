/* Splines of a DXF file. */
#ifndef BAT_DXF_SPLINES_H
#define BAT_DXF_SPLINES_H
#include "exchange/dxf/pairs.h"

/* The curve of a SPLINE. A message for a note on failure. */
batten_status bat_dxf_read_spline(const bat_dxf_pairs *pairs, batten_curve **out);

#endif
