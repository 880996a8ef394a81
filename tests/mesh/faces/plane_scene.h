/* Faces in the plane z = 0, whose (u, v) are (x, y), and their meshes. */
#ifndef TESTS_MESH_FACES_PLANE_SCENE_H
#define TESTS_MESH_FACES_PLANE_SCENE_H
#include "body/builder.h"
#include "support/test.h"

#include <batten/mesh.h>

typedef struct {
    bat_builder builder;
    batten_surface *plane;
} plane_face;

/* One face, without loops so far, of the rectangle from the origin. */
void plane_begin(plane_face *s, double width, double height);
/* An edge of the loop begun last, between two vertices. */
void plane_add(plane_face *s, const batten_curve *flat, int from, int to, bool reversed);
/* Loops with vertices of their own. */
void plane_polygon(plane_face *s, int count, const double (*points)[2]);
void plane_circle(plane_face *s, double x, double y, double radius, bool is_hole);
batten_body *plane_end(plane_face *s);

/* Its triangles, none of them flat, with each edge once each way; `report` and `out` may be NULL. */
batten_mesh_facts mesh_well(const batten_body *body, const batten_mesh_options *options,
                            batten_mesh_report *report, batten_mesh **out);
/* The same of a surface, which it takes; no face may fail. */
batten_mesh_facts mesh_surface_well(batten_surface *surface, const batten_mesh_options *options,
                                    batten_mesh_report *report, batten_mesh **out);

#endif
