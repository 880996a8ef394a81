/* Meshing step by step, and surfaces whose bounds are known. */
#ifndef TESTS_MESH_FACES_MESHING_SCENE_H
#define TESTS_MESH_FACES_MESHING_SCENE_H
#include "mesh/faces/lattice.h"
#include "support/test.h"

#include <batten/mesh.h>

/* Without a body: cells may be as far off as the chord. */
bat_meshing meshing_alone(double chord, double angle);

/* z = (a x^2 + b y^2) / 2 + c x y over the rectangle from the origin, with x and y as parameters. */
batten_surface *meshing_quadric(double width, double height, double a, double b, double c);
/* A roof over [0, 1]^2 with its ridge at this u, this high. */
batten_surface *meshing_roof(double ridge, double height);
/* Around z. */
batten_surface *meshing_cylinder(double radius, double height);

/* The lattice over the box, or over the whole domain. */
bat_lattice meshing_lattice(const batten_surface *surface, const bat_meshing *m,
                            bat_sheet *sheet, const batten_interval *box);

/* The meshing of a traced body, to be taken from stage to stage. */
typedef struct {
    batten_body *body;
    bat_traced traced;
    bat_meshing m;
} staged;

/* Takes the body. */
staged *stage_begin(batten_body *body, double chord, double angle);
void stage_end(staged *s);

/* Each allocation fails in turn: that is said, or the mesh is the same. */
void check_mesh_faults(const batten_body *body, const batten_mesh_options *options);

#endif
