/* Triangles of a body in the making: edges first, then face after face. */
#ifndef BAT_MESHING_H
#define BAT_MESHING_H
#include "base/work.h"
#include "body/trace/traced_body.h"
#include "base/pairs.h"
#include <batten/mesh.h>

/* A surface that is asked beyond its seam too. */
typedef struct {
    const batten_surface *surface;
    batten_interval domain[2];
    batten_interval steady[2]; /* the domain without spans at its ends so short that derivatives
                                  there are roundoff */
    bool closed[2];
} bat_sheet;

void bat_sheet_begin(bat_sheet *sheet, const batten_surface *surface, double tolerance);
/* Into the domain: by whole periods where the surface is closed, else to its border. */
void bat_sheet_wrap(const bat_sheet *sheet, double uv[2]);
/* Derivatives at a place, after batten_surface_evaluate_side, which are steady: d is [3][3]. */
batten_status bat_sheet_steady(const bat_sheet *sheet, const double uv[2],
                               const batten_side side[2], double *d);
/* Su x Sv made a unit vector; false where it vanishes. d: S, Su, Sv ... */
bool bat_sheet_normal(const double *d, double normal[3]);

/* An edge as samples: first and last are its vertices. */
typedef struct {
    int count, room;
    double *t;   /* [count], rising */
    int *vertex; /* [count] of the mesh */
} bat_polyline;

/* What the triangles of a face reach. */
typedef struct {
    double chord, angle;
    int beyond; /* triangles farther than the chord asked for */
    double off; /* of edges at those, the largest */
} bat_reached;

/* An edge of a triangle of a face, between points of edges but none itself. */
typedef struct {
    int face, ends[2];
} bat_across;

typedef struct {
    const batten_body_parts *parts; /* traced */
    const bat_traced *traced;       /* knows the given face of each */
    double chord, angle, longest;   /* longest: infinite for any */
    double fine; /* what is aimed at within faces: less than the chord, as samples see less than
                    all */
    int most;
    const batten_job *job;
    batten_notes *notes;
    bat_work work;
    batten_mesh_report report;

    int point_count, point_room;
    double (*points)[3];
    int *
        same; /* [vertex_count] the vertex that stands for each; itself but where loops touch */
    bool *touched;       /* [vertex_count] it stands for others */
    bat_polyline *edges; /* [edge_count] */
    int *use_face;       /* [use_count] */
    int *edge_first;     /* [edge_count + 1] into edge_uses */
    int *edge_uses;      /* [use_count] uses in the order of their edges */
    bat_sheet *sheets;   /* [face_count] */
    bool *failed;        /* [face_count] */
    bool *spread;        /* [face_count] border corners are where the edges are, see rim.h */
    bat_reached *done;   /* [face_count] */
    bat_pairs taken;     /* directed edges between points of edges: sides, and those across */
    int across_count, across_room;
    bat_across *across;

    int triangle_count, triangle_room;
    int (*corners)[3];
    double (*normals)[9];
    int *owners; /* [triangle_count] faces of `parts` */
} bat_meshing;

/* Lists for the parts, and the vertices as the first points. To be ended, also on failure. */
batten_status bat_meshing_begin(bat_meshing *m);
void bat_meshing_end(bat_meshing *m);
batten_status bat_meshing_point(bat_meshing *m, const double point[3], int *index);
batten_status bat_meshing_triangle(bat_meshing *m, const int corners[3],
                                   const double normals[9], int face);

/* The body with parameter curves, itself when it has them; faces that cannot have any are left
 * out and counted as failed (trace.c). To be ended. */
batten_status bat_meshing_trace(bat_meshing *m, const batten_body *body, bat_traced *traced);
/* The face of the given body. */
static inline int bat_meshing_number(const bat_meshing *m, int face)
{
    return bat_traced_number(m->traced, face);
}

/* TOO_LARGE when more triangles are to be expected than allowed (predict.c). */
batten_status bat_meshing_predict(bat_meshing *m);

/* Vertices where loops of a face touch become one (touches.c). */
batten_status bat_meshing_join(bat_meshing *m);

/* Sample all edges (edges.c). */
batten_status bat_meshing_edges(bat_meshing *m);
/* New samples in the middles of segments (edge, segment) of one edge, the last one first; *made
 * of them, for where the edge is too short there is none. */
batten_status bat_meshing_split(bat_meshing *m, int count, const int (*splits)[2], int *made);

/* Finer samples until the border of no face crosses itself (borders.c). */
batten_status bat_meshing_settle(bat_meshing *m);
/* The segments (edge, segment) halved. Their faces are asked again; *any: some were halved. */
batten_status bat_meshing_apply_splits(bat_meshing *m, bat_pairs *splits, bool *ask, bool *any);
/* The face is left out, with a note. */
void bat_meshing_give_up(bat_meshing *m, int face, const char *why);
/* What ends all work, and not that on one face alone. */
bool bat_meshing_is_final(batten_status status);

/* Triangles of all faces (faces.c). */
batten_status bat_meshing_faces(bat_meshing *m);
/* No other face may have the edge from a to b. */
batten_status bat_meshing_take(bat_meshing *m, int face, int a, int b);

/* How far from the shape triangles may be where an edge is `off` its face, when `most` is aimed
 * at elsewhere: together within the chord where that can be, without dividing for ever. */
static inline double bat_meshing_limit(const bat_meshing *m, double most, double off)
{
    return off < m->chord ? bat_max(most, off + 0.12 * m->chord) : off + most;
}

/* How far a point is from a segment, and from a triangle (distance.c). Beside a triangle by
 * less than half its least height counts the distance from its plane: a straight side in (u, v)
 * is a curve on the surface, and what is beside one triangle is over the next. */
double bat_distance_to_segment(const double *p, const double *a, const double *b);
double bat_distance_to_triangle(const double *p, const double *a, const double *b,
                                const double *c);

#endif
