/* Circles, arcs and ellipses of a DXF file as curves. */
#ifndef BAT_EXCHANGE_DXF_ROUND_CURVE_H
#define BAT_EXCHANGE_DXF_ROUND_CURVE_H
#include "numeric/vector.h"

batten_vec3 bat_dxf_vector(const double v[3]);
void bat_dxf_put_vector(batten_vec3 v, double out[3]);

#endif
