/* Scalar fields on surfaces from the derivatives at a point. */
#ifndef BAT_FIELD_H
#define BAT_FIELD_H
#include <batten/contours.h>

/* BAD_ARGUMENT or NOT_FINITE for a field that cannot be; its directions become unit vectors. */
batten_status bat_field_prepare(const batten_surface_field *field, batten_surface_field *out);

/* To which order a surface must be evaluated for bat_field_value. */
int bat_field_order(const batten_surface_field *field);

/* What is roundoff of a field on a shape of this size, whatever its values. */
double bat_field_roundoff(const batten_surface_field *field, double size);

/* The value and, with respect to u and v, the gradient, from derivatives
 * [BATTEN_SURFACE_DERIVATIVES(order)][3]. NaN where the surface is singular. */
double bat_field_value(const batten_surface_field *field, const double *derivatives,
                       double gradient[2]);

#endif
