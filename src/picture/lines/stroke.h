/* Curves as polylines in space, fine enough for any picture. */
#ifndef BAT_STROKE_H
#define BAT_STROKE_H
#include "base/base.h"
#include <batten/model.h>

typedef struct {
    size_t count;
    double *points; /* [count][3] */
} bat_stroke;

/* Growing list of strokes. */
typedef struct {
    size_t count, capacity;
    bat_stroke *strokes;
} bat_strokes;

/* As few points as keep the polyline within 1/40,000 of the size of the curve, each knot among them;
 * coordinates it has not are 0. */
batten_status bat_stroke_curve(const batten_curve *curve, bat_stroke *out);
/* The same for the curve on a surface at a fixed parameter. */
batten_status bat_stroke_isoline(const batten_surface *surface, batten_direction direction,
                                 double at, bat_stroke *out);
/* The same within `tolerance`. */
batten_status bat_stroke_isoline_within(const batten_surface *surface,
                                        batten_direction direction, double at, double tolerance,
                                        bat_stroke *out);
/* The edges of all triangles, in their order, then lines inside along which one barycentric
 * coordinate is constant: with one triangle `isolines` - 1 for each, fewer with more. */
batten_status bat_stroke_triangles(const batten_triangles *triangles, int isolines,
                                   bat_strokes *lines);
/* Which edges of a mesh are drawn: where it ends or turns by more than 30 degrees, of a body's
 * mesh those between its faces; these, or all when there are none; all; others between
 * triangles that face the eye and those that do not. */
typedef enum {
    BAT_MESH_EDGES,
    BAT_MESH_EDGES_OR_ALL,
    BAT_MESH_ALL,
    BAT_MESH_OUTLINE
} bat_mesh_lines;
typedef struct {
    double at[3]; /* of the eye; far away: the direction to it */
    bool is_far;
} bat_mesh_eye;
batten_status bat_stroke_mesh(const batten_mesh *mesh, bat_mesh_lines which,
                              const bat_mesh_eye *eye, bat_strokes *lines);
/* Edges between vertices [vertex_count][3] as polylines that end where other than two of the
 * edges meet. */
batten_status bat_chain_edges(int vertex_count, const double *points, size_t count,
                              const int (*ends)[2], bat_strokes *out);
/* Of unit length; 0 of a triangle without area. */
void bat_triangle_normal(const batten_mesh_parts *mesh, int triangle, double n[3]);
/* Does the isoline shrink to a point, as at a pole? */
bool bat_stroke_is_point(const bat_stroke *stroke, double tolerance);
void bat_stroke_free(bat_stroke *stroke);

/* Take a stroke over; it is freed when there is no memory to keep it. */
batten_status bat_strokes_add(bat_strokes *list, bat_stroke stroke);
void bat_strokes_free(bat_strokes *list);

/* Parameters at every knot and `steps` - 1 evenly between each two. */
batten_status bat_divide_spans(int knot_count, const double *knots, int steps, size_t *count,
                               double **out);

#endif
