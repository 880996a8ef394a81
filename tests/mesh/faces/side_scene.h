/* Triangles with kept sides on a grid: whole numbers, in which all decisions are exact. */
#ifndef TESTS_MESH_FACES_SIDE_SCENE_H
#define TESTS_MESH_FACES_SIDE_SCENE_H
#include "mesh/faces/sides.h"
#include "support/test.h"

enum { CENTRE = 64, UNIT = 128, MOST_POINTS = 200, MOST_SIDES = 200 };

/* Points of a grid, places in units of 1/UNIT; the distinct ones have the numbers of the vertices. */
typedef struct {
    int count;
    double at[MOST_POINTS][2];
    int vertex_of[MOST_POINTS];
    int side_count, sides[MOST_SIDES][2]; /* kept */
    bat_sides triangles;
} scene;

/* The place is in units, from 0 to UNIT. */
void scene_point(scene *c, int x, int y);
/* Delaunay between the points so far. */
void scene_begin(scene *c);
/* Coordinate k of a vertex in units, and twice the area of a triangle. */
long long scene_whole(const scene *c, int vertex, int k);
long long scene_area(const scene *c, int p, int q, int r);
/* Keep a side; what that says is what brute force says. */
bat_side_result scene_keep(scene *c, int a, int b);
bool scene_has_side(const scene *c, int a, int b);
/* Sides between points from `first` on, all the way around. */
void scene_keep_star(scene *c, int first, int corners);
/* Neighbours know each other and the edge between them alike, all triangles turn to the left, and
 * the sides that are fixed are those that were kept. Returns twice their area. */
long long scene_check(const scene *c);
/* No vertex beyond an edge that is no side lies in the circle of the triangle before it. */
void scene_check_delaunay(const scene *c);
/* By the sides that a ray to the right meets: x and y in thirds of units, so that middles are
 * whole. On a side: *is_on. */
bool scene_is_inside(const scene *c, long long x, long long y, bool *is_on);
/* What is inside is so by the sides around it; twice the area of it. */
long long scene_check_inside(const scene *c);
/* An outer border, a hole, an island in the hole: settled. Released by bat_sides_end. */
scene *scene_rings(test_random *random, int corners);

#endif
