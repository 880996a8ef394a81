/*
 * A model as lines in space: edges, creases and isoparametric lines of its surfaces, contours,
 * curves; and, for each view, its silhouettes and the facets that hide lines.
 */
#ifndef BAT_WIRES_H
#define BAT_WIRES_H
#include "picture/lines/hidden.h"
#include "picture/lines/stroke.h"
#include "picture/lines/tiles.h"
#include "picture/sheet/canvas.h"
#include "picture/sheet/view.h"

typedef enum {
    BAT_WIRE_ISOLINE,
    BAT_WIRE_CONTOUR,
    BAT_WIRE_EDGE, /* of a surface, and creases in it */
    BAT_WIRE_SILHOUETTE,
    BAT_WIRE_CURVE,
    BAT_WIRE_KINDS
} bat_wire_kind;

typedef struct {
    bat_wire_kind kind;
    int object;   /* of the model */
    double value; /* of a contour */
    bat_stroke stroke;
    double *away; /* of a silhouette: at each point, unit vectors to where the surface is not */
} bat_wire;

/* From space to the sheet, but for its place: parallel, or as seen from `distance` before
 * `centre`. */
typedef struct {
    bat_view view;
    double centre[3];
    double distance; /* 0: parallel */
} bat_eye;

typedef struct {
    const batten_model *model;
    const batten_draw_options *options;
    const batten_job *job;
    batten_box box;
    double size;       /* of the box */
    double tolerance;  /* of lines, model units; facets are nearer */
    bat_tiles *tiles;  /* [objects]; of surfaces */
    double level_step; /* of contours; 0: there are none */
    size_t count, capacity;
    bat_wire *wires;
    size_t lasting; /* so many are there for every view; silhouettes follow */
    bool has_silhouettes;
    bat_eye silhouettes_of;
} bat_wires;

/* All that does not depend on the view; `wires` has model, options and job. `scale` is the
 * largest at which it will be drawn, points per unit. */
batten_status bat_wires_measure(bat_wires *wires);
batten_status bat_wires_gather(bat_wires *wires, double scale);
/* Instead of those of an earlier view. */
batten_status bat_wires_add_silhouettes(bat_wires *wires, const bat_eye *eye);
void bat_wires_free(bat_wires *wires);

/* A contour more; those after the first `count` no more. */
batten_status bat_wires_add_contour(bat_wires *wires, bat_wire_kind kind, int object,
                                    double value, const batten_polyline *line);
void bat_wires_drop(bat_wires *wires, size_t count);

/* Edges of a mesh, each as a wire. */
batten_status bat_wires_add_mesh(bat_wires *wires, bat_wire_kind kind, int object,
                                 bat_mesh_lines which, const bat_mesh_eye *eye);

/* Is it a surface that is drawn? */
bool bat_wires_shows(const batten_object *object);

/* To the right, up, and towards the eye, from the middle. */
void bat_eye_project(const bat_eye *eye, const double point[3], double out[3]);
/* Every facet on a sheet whose point (x, y) lies at x0 + scale x, y0 - scale y. */
batten_status bat_wires_facets(const bat_wires *wires, const bat_eye *eye, double scale,
                               double x0, double y0, bat_facets *out);

#endif
