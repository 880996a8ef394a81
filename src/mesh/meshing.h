/* Triangles of a body in the making: edges first, then face after face. */
#ifndef BAT_MESHING_H
#define BAT_MESHING_H
#include "base/work.h"
#include "mesh/pairs.h"
#include <batten/mesh.h>

/* A surface that is asked beyond its seam too. */
typedef struct {
    const batten_surface *surface;
    batten_interval domain[2];
    bool closed[2];
} bat_sheet;

void bat_sheet_begin(bat_sheet *sheet, const batten_surface *surface, double tolerance);
/* Into the domain: by whole periods where the surface is closed, else to its border. */
void bat_sheet_wrap(const bat_sheet *sheet, double uv[2]);
/* Su x Sv made a unit vector; false where it vanishes. d: S, Su, Sv ... */
bool bat_sheet_normal(const double *d, double normal[3]);

/* An edge as samples: first and last are its vertices. */
typedef struct {
    int count, room;
    double *t;   /* [count], rising */
    int *vertex; /* [count] of the mesh */
} bat_polyline;

typedef struct {
    const batten_body_parts *parts; /* traced */
    const int *names; /* [face_count] the faces of the body that was given; NULL: the same */
    double chord, angle, longest; /* longest: infinite for any */
    double fine; /* what is aimed at within faces: less than the chord, as samples see less than
                    all */
    int most;
    const batten_job *job;
    batten_notes *notes;
    bat_work work;
    batten_mesh_report report;

    int point_count, point_room;
    double (*points)[3]; /* those of the edges, then those of the faces */
    int edge_points;     /* how many are of edges */
    bat_polyline *edges; /* [edge_count] */
    int *use_face;       /* [use_count] */
    int *edge_first;     /* [edge_count + 1] into edge_uses */
    int *edge_uses;      /* [use_count] uses in the order of their edges */
    bat_sheet *sheets;   /* [face_count] */
    bool *failed;        /* [face_count] */
    bool *spread;        /* [face_count] border corners are where the edges are, see rim.h */
    bat_pairs taken;     /* directed edges between points of edges */

    int triangle_count, triangle_room;
    int (*corners)[3];
    double (*normals)[9];
    int *faces;
} bat_meshing;

batten_status bat_meshing_point(bat_meshing *m, const double point[3], int *index);
batten_status bat_meshing_triangle(bat_meshing *m, const int corners[3],
                                   const double normals[9], int face);

/* The body with parameter curves, itself when it has them; faces that cannot have any are left
 * out and counted as failed, and then *names are the numbers of the others, to be released
 * (trace.c). */
batten_status bat_meshing_trace(bat_meshing *m, const batten_body *body, batten_body **traced,
                                int **names);
static inline int bat_meshing_name(const bat_meshing *m, int face)
{
    return m->names ? m->names[face] : face;
}

/* TOO_LARGE when more triangles are to be expected than allowed (predict.c). */
batten_status bat_meshing_predict(bat_meshing *m);

/* Sample all edges (edges.c). */
batten_status bat_meshing_edges(bat_meshing *m);
/* A new sample in the middle behind number `segment`; false when the edge is too short there.
 */
batten_status bat_meshing_split(bat_meshing *m, int edge, int segment, bool *split);

/* How far a point is from a segment, and from a triangle (distance.c). Beside a triangle by
 * less than half its least height counts the distance from its plane: a straight side in (u, v)
 * is a curve on the surface, and what is beside one triangle is over the next. */
double bat_distance_to_segment(const double *p, const double *a, const double *b);
double bat_distance_to_triangle(const double *p, const double *a, const double *b,
                                const double *c);

#endif
