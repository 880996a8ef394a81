/* How ends of curves, and edges of surfaces, meet: one pair of them, and all that do. */
#ifndef BAT_JOINS_H
#define BAT_JOINS_H
#include "inspect/joins/walk.h"

static inline bool bat_join_is_in(const batten_box *box, batten_vec3 p, double tolerance)
{
    return p.x >= box->low.x - tolerance && p.x <= box->high.x + tolerance &&
           p.y >= box->low.y - tolerance && p.y <= box->high.y + tolerance &&
           p.z >= box->low.z - tolerance && p.z <= box->high.z + tolerance;
}

/* The edge of a surface on one of its sides: u low, u high, v low, v high. */
batten_status bat_side_curve(const batten_surface *surface, int side, batten_curve **out);
/* How an end of a curve runs on into an end of another. */
batten_status bat_join_of_curves(const batten_curve *a, int side_a, const batten_curve *b,
                                 int side_b, const batten_curve_continuity_options *bounds,
                                 batten_join *join);
/* The same at all places of the edge of the first. */
batten_status bat_join_of_surfaces(const batten_surface *a, int side_a, const batten_surface *b,
                                   int side_b, const batten_curve_continuity_options *bounds,
                                   batten_join *join);

#endif
