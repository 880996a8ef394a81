/* How far a NURBS surface or isocurve is from the formula it stands for. */
#ifndef BAT_FORMULA_NURBS_ERROR_H
#define BAT_FORMULA_NURBS_ERROR_H
#include "shape/formula/nurbs.h"

enum { BAT_FORMULA_DEGREE = 5 };

/* One direction: its spans, and the spline over them. Of an isocurve one direction is fixed:
 * no spans, one parameter. */
typedef struct {
    int span_count, room;
    double *breaks; /* [span_count + 1] */
    int *times;     /* [span_count + 1]: how often the knot stands there */
    double *knots;
    int count;        /* of control points */
    double *greville; /* [count] */
    double *lu;       /* [count][2 DEGREE + 1] */
    double *errors;   /* [span_count]: the largest one measured */
} bat_formula_line;

typedef struct {
    const batten_surface *surface;
    int dimension;
    double tolerance;
    double angle; /* between normals along the edges, radians; 0: any */
    int most;     /* points */
    bat_formula_line lines[2];
    double *points; /* [count u][count v][dimension]: data, then control points */
    double error;   /* of the spline that was checked last */
    double turned; /* the largest angle between its normals and the surface's along the edges */
} bat_formula_fit;

batten_status bat_formula_fit_surface(const bat_formula_fit *t, batten_surface **out);
batten_status bat_formula_fit_curve(const bat_formula_fit *t, const bat_formula_line *l,
                                    batten_curve **out);
/* Along each direction where the other is exact; or, at last, between everything. */
batten_status bat_formula_fit_errors(bat_formula_fit *t, bool between);
/* Along the edges: where normals are too far off, errors without bound of the span along the edge
 * and of the one across that begins there. */
batten_status bat_formula_fit_angles(bat_formula_fit *t);

#endif
