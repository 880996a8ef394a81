/* A path of lines and arcs in a plane: what machines cut, and what DXF calls a polyline with
 * bulges. */
#ifndef BAT_PATH_H
#define BAT_PATH_H
#include "base/base.h"
#include <batten/model.h>

/* One vertex, and how the path goes on from it: the bulge is tan(sweep / 4), positive to the
 * left, 0 for a line and what is one but for rounding. No arc sweeps more than a half circle.
 */
typedef struct {
    double x, y, bulge;
} bat_vertex;

typedef struct {
    int count;
    bool closed;          /* the last vertex goes on to the first */
    bat_vertex *vertices; /* [count] */
    batten_frame frame;   /* the plane: x and y are measured along its axes */
} bat_path;

/* The path of a curve that is one: a chain of arcs and lines, a polyline in a plane
 * z = constant, or a NURBS curve that batten_arcs_from_curve_exact finds to be arcs and lines. *is_path is
 * false, and nothing is made, for other objects. */
batten_status bat_path_of(const batten_object *object, bool *is_path, bat_path *out);
void bat_path_release(bat_path *path);

/* A path as a curve in space: lines as degree 1 when there are no arcs, else rational arcs of a
 * quarter at most, degree 2; the domain is measured by chords. COINCIDENT when two neighbours
 * are one point. */
batten_status bat_path_curve(const bat_path *path, batten_curve **out);

/* How far the arc from vertex `from` to the point (x, y) is beside its chord. */
double bat_path_sagitta(const bat_vertex *from, double x, double y);
/* The arc from vertex `from` to the point (x, y): its centre and radius; the bulge is not 0. */
void bat_path_centre(const bat_vertex *from, double x, double y, double *cx, double *cy,
                     double *radius);

#endif
