/* Products of splines. */
#ifndef BAT_PRODUCT_H
#define BAT_PRODUCT_H
#include "base/base.h"
#include <batten/curve.h>

/*
 * The curve scalar(t) curve(t): both polynomial, over the same domain but for rounding,
 * `scalar` of dimension 1. The result has the domain of `curve` and is in Bezier form, every
 * inner knot p
 * + q times; batten_curve_remove_knots thins them.
 * @return BATTEN_OK, BAD_DEGREE when p + q is too high, OVERFLOW ...
 */
batten_status bat_curve_product(const batten_curve *scalar, const batten_curve *curve,
                                batten_curve **out);

#endif
