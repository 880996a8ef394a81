/* Circles, arcs and ellipses as entities of DXF say them. */
#ifndef BAT_DXF_ROUND_H
#define BAT_DXF_ROUND_H
#include "base/base.h"
#include <batten/curve.h>

typedef enum {
    BAT_DXF_NOT_ROUND,
    BAT_DXF_CIRCLE,
    BAT_DXF_ARC,
    BAT_DXF_ELLIPSE
} bat_dxf_round_kind;

typedef struct {
    bat_dxf_round_kind kind;
    double normal[3]; /* of its plane */
    double centre[3]; /* of an ellipse in the world, else in the axes of the plane */
    double axis[3];   /* of an ellipse: the long half axis, in the world */
    double size;      /* the radius; of an ellipse short axis / long axis */
    double
        angles[2]; /* counter-clockwise from one to the other: degrees, of an ellipse radians */
} bat_dxf_round;

/*
 * Rational quadratics that are one arc of a circle or an ellipse but for rounding, with numbers
 * short of their last places, so that the curve made of them gives the same numbers again: that
 * is tried, and what fails is not round, nor is an arc of a circle in a level plane that goes
 * clockwise, which needed a mirrored plane. A full turn begins where the entity does.
 * @param curve dimension 3, clamped
 */
batten_status bat_dxf_round_of(const batten_curve *curve, bat_dxf_round *out);

/* The curve of such an entity; BAD_FORMAT when its radius or an axis is not above 0. */
batten_status bat_dxf_round_curve(const bat_dxf_round *round, batten_curve **out);

#endif
