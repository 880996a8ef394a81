/* Places on the edges of surfaces. */
#ifndef BAT_NEAR_EDGES_H
#define BAT_NEAR_EDGES_H
#include <batten/coons.h>

/* The parameters of a point on an edge, `t` from 0 to 1 along it. */
void bat_on_edge(const batten_surface *surface, batten_edge edge, double t, double at[2]);

#endif
