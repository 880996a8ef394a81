/* The border of a surface as a loop of edges: seams where it closes, poles where it collapses.
 */
#ifndef BAT_BORDER_H
#define BAT_BORDER_H
#include "body/builder.h"

/* The surface as a clamped NURBS surface in space: itself where it is one. */
batten_status bat_border_surface(const batten_surface *surface, double tolerance,
                                 batten_surface **out);
/* Is the curve one point, to the tolerance? By its control points. */
bool bat_border_is_point(const batten_curve *curve, double tolerance);
/* The straight curve in (u, v) from `a` to `b` with the domain `on`. */
batten_status bat_border_line(const double a[2], const double b[2], batten_interval on,
                              batten_curve **out);

typedef struct {
    int seams, poles, rims; /* edges of each kind */
} bat_border_count;
/* The border as a loop of the face begun last, whose surface this is: with the side of the face
 * on its left. What is there is added to *count. */
batten_status bat_border_loop(bat_builder *builder, const batten_surface *surface,
                              bool reversed, double tolerance, bat_border_count *count);

#endif
