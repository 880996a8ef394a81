/* What the formats of meshes share: triangles of polygons, normals, names, remarks on units. */
#ifndef BAT_FACETS_H
#define BAT_FACETS_H
#include "exchange/reading/input.h"
#include <batten/exchange.h>

/* The unit normal of a triangle; 0 0 0 when it has none. Right for corners of any size. */
void bat_facet_normal(const double a[3], const double b[3], const double c[3],
                      double normal[3]);

/* Above this, a polygon that is not convex is cut without looking for the best cuts: so that
 * the time stays in proportion to the file. */
enum { BAT_POLYGON_MOST = 100 };

/*
 * Cut a polygon in space into count - 2 triangles of its corners: a fan when that covers it,
 * else by ears in the plane on which it is largest. *is_odd when no cut covers it once: it
 * crosses itself, or has a hole's bridge, or more than BAT_POLYGON_MOST corners and a bay.
 *
 * @param points [count][3]; count >= 3
 * @param[out] triangles [count - 2][3] indices of the corners
 */
void bat_polygon_triangles(int count, const double *points, int *triangles, bool *is_odd);

/* Say how many polygons of a file were cut so, if any were. */
void bat_remark_polygons(const bat_input *input, size_t polygons);

/*
 * Number what differs at corners: corners at one vertex with equal normals are one, when they
 * follow each other there. index[corner] from 0 on; source[number] is a corner of each. Without
 * normals the numbers are the vertices, in the order in which triangles use them.
 */
typedef struct {
    int count;
    int *index, *source; /* [3 triangle_count]; [count] */
} bat_corners;
batten_status bat_number_corners(const batten_mesh_parts *parts, bat_corners *out);
void bat_corners_end(bat_corners *corners);

/* A name for one line of text, without the blanks and control characters around it; `otherwise`
 * when nothing is left. */
bat_span bat_name_core(const char *name, const char *otherwise);

/* Say in which unit the numbers of a file without units are. */
void bat_remark_unit(const batten_model *model, const char *title, batten_notes *notes);
/* Triangles without area. */
int bat_count_flat(const batten_mesh *mesh);
/* How often has a mesh triangles without area? A remark says so. */
void bat_remark_flat(const batten_mesh *mesh, const char *file, const char *name,
                     batten_notes *notes);

/*
 * The mesh of an object as a format keeps it that has 32 bits for each coordinate, times
 * `scale` (rounded_mesh.c): without the triangles of which rounding makes two corners one,
 * which leaves a closed mesh closed, with its coordinates as they were. A remark says how many
 * those are, a note what else is worse than it was: triangles without area, edges of more than
 * two triangles, a rim.
 */
batten_status bat_rounded_mesh(const batten_object *object, double scale, batten_notes *notes,
                               batten_mesh **out);

#endif
