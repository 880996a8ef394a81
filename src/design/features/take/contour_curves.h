/* The contours of a shape as the curves of a feature. */
#ifndef BAT_DESIGN_CONTOUR_CURVES_H
#define BAT_DESIGN_CONTOUR_CURVES_H
#include "design/feature.h"

#include <batten/contours.h>

typedef struct {
    batten_surface_field field;
    int level_count;
    double *levels;
    double within;
    bool smooth;
    double error; /* the largest so far */
    int open;     /* contours that do not close */
} bat_contours_wanted;

/* The contours of a surface or of triangles within `tolerance`, as chords or as cubics. */
batten_status bat_contours_find(const bat_run *run, const batten_object *object,
                                const bat_contours_wanted *wanted, double tolerance,
                                bool cubics, batten_contours *out);
/* The same, so fine that bat_contour_curve makes curves of them within what is wanted. */
batten_status bat_contours_find_fine(const bat_run *run, const batten_object *object,
                                     const bat_contours_wanted *wanted, batten_contours *out);
/* A contour as a curve; `rise` is the error of the contours. Error and open lines are counted. */
batten_status bat_contour_curve(bat_contours_wanted *wanted, const batten_contour *contour,
                                double rise, batten_curve **out);
/* Cubics between the points of a line; `arms` [count][2][3]: the control points before and after
 * each. */
batten_status bat_armed_curve(const batten_polyline *line, const double *arms,
                              batten_curve **out);

#endif
