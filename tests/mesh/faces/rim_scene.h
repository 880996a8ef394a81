/* Borders made by hand, in a plane in which (u, v) are the places. */
#ifndef TESTS_MESH_FACES_RIM_SCENE_H
#define TESTS_MESH_FACES_RIM_SCENE_H
#include "mesh/faces/rim.h"
#include "support/test.h"

enum { MOST = 128 };

typedef struct {
    bat_rim rim;
    bat_rim_corner corners[MOST];
    double at[MOST][2];
    int vertex_of[MOST];
    double u[2];
    int cells[1];
    bat_lattice lattice;
    bat_pairs splits;
} border;

border *begin_border(void);
/* A closed polygon whose sides are segments 0, 1, ... of this edge; each corner is a vertex of its own. */
void add_polygon(border *b, int edge, int count, const double (*places)[2]);

#endif
