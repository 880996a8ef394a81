/* Entities of a DXF file as shapes. */
#ifndef BAT_DXF_ENTITIES_H
#define BAT_DXF_ENTITIES_H
#include "exchange/dxf/pairs.h"
#include <batten/model.h>

/* The axes of a plane with this normal, as the format chooses them; its origin is that of the
 * world. */
batten_status bat_dxf_plane(const bat_dxf_pairs *pairs, batten_frame *frame);

/* The curve of a LINE, ARC, CIRCLE, ELLIPSE, SPLINE or LWPOLYLINE; *is_curve is false for other
 * kinds. A message for a note on failure. */
batten_status bat_dxf_read_curve(const bat_dxf_pairs *pairs, bool *is_curve,
                                 batten_curve **out);

/* Of a mesh of faces: corners as the file counts them, from 1. */
typedef struct {
    int corners[4], line;
} bat_dxf_face;

/* A POLYLINE comes in several entities: its own, one VERTEX after another, SEQEND. */
typedef struct {
    bool is_open;  /* begun, and without its SEQEND so far */
    bool is_plane; /* with bulges, in the plane of `frame` */
    bool closed;
    bool is_mesh, is_polyface; /* a mesh is of faces, or a grid */
    int rows, columns;         /* of the grid */
    bool closed_along;         /* its rows; `closed` is said of its columns */
    int line;
    batten_frame frame;
    bat_list vertices; /* of double[4]: x, y, z, bulge */
    bat_list faces;    /* of bat_dxf_face */
} bat_dxf_polyline;
batten_status bat_dxf_polyline_begin(const bat_dxf_pairs *pairs, bat_dxf_polyline *polyline);
batten_status bat_dxf_polyline_vertex(const bat_dxf_pairs *pairs, bat_dxf_polyline *polyline);
batten_status bat_dxf_polyline_curve(const bat_dxf_pairs *pairs,
                                     const bat_dxf_polyline *polyline, batten_curve **out);

/* Of a POLYLINE that is a mesh (src/exchange/dxf/polymesh.c): what its own entity says, a
 * VERTEX that is a face, and the mesh, with a message for a note on failure. */
batten_status bat_dxf_polymesh_begin(const bat_dxf_pairs *pairs, int flags,
                                     bat_dxf_polyline *polyline);
batten_status bat_dxf_polymesh_face(const bat_dxf_pairs *pairs, bat_dxf_polyline *polyline);
batten_status bat_dxf_polymesh(bat_input *input, const bat_dxf_polyline *polyline,
                               const char *name, batten_mesh **out);

/* The three or four corners of a 3DFACE; *count says how many. */
batten_status bat_dxf_read_face(const bat_dxf_pairs *pairs, double corners[4][3], int *count);

#endif
