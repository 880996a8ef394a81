/* The box, isocurves and NURBS near a surface that is a formula. */
#ifndef BAT_FORMULA_NURBS_H
#define BAT_FORMULA_NURBS_H
#include "shape/formula/formula.h"

/* The box of samples, widened by what they can miss as far as their second differences tell. */
batten_status bat_formula_find_box(const batten_surface *surface, batten_box *out);
/* The isocurve of a surface that is not a NURBS, within 1e-9 of the size of its box. */
batten_status bat_formula_isocurve(const batten_surface *surface, batten_direction direction,
                                   double at, batten_curve **out);

#endif
