/* Rows of points out of objects: stations, lines, data of curves. */
#ifndef BAT_DESIGN_ROWS_H
#define BAT_DESIGN_ROWS_H
#include "design/feature.h"

typedef struct {
    const char *name; /* borrowed from the object */
    int count;
    double *points; /* [count][3] */
} bat_row;

typedef struct {
    int count;
    bat_row *rows;
} bat_rows;

/* The rows of one object: the stations or the lines of a table, else its points. */
batten_status bat_rows_of(const batten_object *object, bool lines, bat_rows *out);
void bat_rows_release(bat_rows *rows);
/* The points and the stations' points of all objects of an argument, [count][3]. */
batten_status bat_gather_points(const bat_run *run, const char *parameter, int *count,
                                double **points);

/* Methods multiply lengths, two and three of them: points [count][3] whose largest coordinate
 * is not from 1e-90 to 1e90 (or 0) are refused, with a word about units. */
batten_status bat_points_check_size(int count, const double *points);

/* How far neighbours of one row are from each other: the shortest distance above 0, which begins at point `at` counted
 * from 0, and the longest; the largest coordinate. */
typedef struct {
    double least, most, largest;
    int at;
} bat_spread;

/* Of `count` points, `step` points apart in memory. */
bat_spread bat_spread_of(int count, const double *points, size_t step);
/* A millionth or less: parameters from distances have no six digits left. */
bool bat_spread_is_uneven(const bat_spread *spread);

/* Note points so far from the origin, for the tolerance of the design, that they are at the mercy of rounding. */
void bat_note_reach(const bat_run *run, const char *name, int count, const double *points);
/* The same of a row, and points of it so near each other for the distances of the others. */
void bat_note_spacing(const bat_run *run, const char *name, int count, const double *points);

/* The axis along which all points have the same coordinate bit for bit (the last of several),
 * or -1. */
int bat_flat_axis(int count, const double *points);
/* The points without the coordinate of an axis, [count][2], or [count][3] for axis -1. */
double *bat_points_in_plane(int axis, int count, const double *points);
/* Put coordinates back: `from` as bat_points_in_plane made it, into `to` [count][3]. */
void bat_points_from_plane(int axis, int count, const double *from, double *to);
/* The same of a curve: its projection along an axis, in the plane; axis -1: the curve in space.
 */
batten_status bat_curve_in_plane(const batten_curve *curve, int axis, batten_curve **out);

/* The rigid map that takes the plane of points [count][3] to z = 0; false where they do not lie in one plane, but for
 * the rounding of their coordinates, or all in one line. */
bool bat_plane_find(int count, const double *points, batten_affine *to_plane);
/* The points in their plane, [count][2], which may stand in their own room. */
void bat_plane_points(const batten_affine *to_plane, int count, const double *points,
                      double *plane);
/* A curve in space, in its plane. */
batten_status bat_plane_curve(const batten_affine *to_plane, const batten_curve *curve,
                              batten_curve **out);

#endif
