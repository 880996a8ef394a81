/* Pieces of NURBS curves that are arcs of ellipses, as SVG says them. */
#ifndef BAT_SVG_ELLIPTICAL_H
#define BAT_SVG_ELLIPTICAL_H
#include <stdbool.h>

/* Less than half around; the first half axis is turned by `angle`, counter-clockwise. */
typedef struct {
    double rx, ry, angle;
    bool is_clockwise;
} bat_svg_elliptical;

/* Is the Bezier piece, of degree 2 or of degree 3 raised from it, an arc of an ellipse as seen
 * along z? Only to `rounding` is one: its ends are those of the piece, and its middle is found
 * again from the ends and the half axes, the way a reader goes. */
bool bat_svg_is_elliptical(int dimension, int degree, const double *points,
                           const double *weights, double rounding, bat_svg_elliptical *out);

#endif
