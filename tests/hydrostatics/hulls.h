/* Hulls whose values are known in closed form. */
#ifndef TESTS_HYDROSTATICS_HULLS_H
#define TESTS_HYDROSTATICS_HULLS_H
#include <batten/hull.h>

/* One half of a prism along x, from `count` points (y, z) of its section. */
batten_surface *half_prism(double from, double to, int count, const double (*section)[2]);
/* A hull of one half. */
batten_hull *hull_of(batten_surface *half);
/* From x = 0 to 4, 2 wide, from z = 0 to 2. */
batten_hull *box_hull(void);
/* Wigley's: y = B / 2 (1 - (2 x / L)^2) (1 - (z / T)^2) for z from -T to 0, carried on upwards to z = 1 by straight
 * sides; L 10, B 1, T 0.625. */
batten_hull *wigley_hull(void);

enum { WIGLEY_LENGTH = 10, WIGLEY_BREADTH = 1 };
#define WIGLEY_DRAUGHT 0.625

/* The box with water at z = draught - (x - 2) tan(trim) / cos(heel) - y tan(heel), which meets
 * neither its bottom nor its deck: a draught of 0.9 amidships. Directions as of batten_hydrostatics. */
typedef struct {
    batten_flotation at;
    batten_vec3 n, along, across; /* up, ahead and to the side, from the water */
    batten_vec3 buoyancy;
    double waterplane, second[3]; /* along, mixed, across */
} oblique_box;

oblique_box box_at(double trim, double heel);

#endif
