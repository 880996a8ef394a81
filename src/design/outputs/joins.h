/* Ends of curves and edges of surfaces that meet: finding them, and comparing them. */
#ifndef BAT_DESIGN_JOINS_H
#define BAT_DESIGN_JOINS_H
#include "design/outputs/fairness.h"
#include "numeric/vector.h"

static inline double bat_join_norm(batten_vec3 a)
{
    return bat_hypot(bat_hypot(a.x, a.y), a.z);
}

static inline double bat_join_gap(batten_vec3 p, batten_vec3 q)
{
    return bat_join_norm(bat_vec3_along(p, -1, q));
}

static inline bool bat_join_is_in(const batten_box *box, batten_vec3 p, double tolerance)
{
    return p.x >= box->low.x - tolerance && p.x <= box->high.x + tolerance &&
           p.y >= box->low.y - tolerance && p.y <= box->high.y + tolerance &&
           p.z >= box->low.z - tolerance && p.z <= box->high.z + tolerance;
}

/* ---- join_compare.c ---- */

/* The edge of a surface on one of its sides. */
batten_status bat_edge_curve(const batten_surface *surface, int side, batten_curve **out);
/* How smoothly the first runs on into the second, into `join`. */
batten_status bat_compare_curves(const batten_curve *a, int side_a, const batten_curve *b,
                                 int side_b, double tolerance, bat_join *join);
/* The same at all points of the edge of the first; what bulges by less than `straight`, a
 * curvature, counts as straight. */
batten_status bat_compare_surfaces(const batten_surface *a, int side_a, const batten_surface *b,
                                   int side_b, double tolerance, double straight,
                                   bat_join *join);

#endif
