/* One Bezier patch of a hull, and what is asked of it along its rows. */
#ifndef BAT_HYDROSTATICS_PATCH_H
#define BAT_HYDROSTATICS_PATCH_H
#include "base/base.h"
#include <batten/curve.h>
#include <batten/surface.h>

/* Patches of no lid have one of these in its place: the surfaces themselves, and lids that have
 * their like, seen from the other side, along a joint. */
enum { BAT_SKIN = -1, BAT_JOINT = -2 };

/* N = sign S_u x S_v points outwards. Coordinates are those of the hull from its centre, as
 * parts of its size. */
typedef struct {
    int lid; /* which one, or BAT_SKIN, BAT_JOINT */
    int degree[2];
    double sign;
    double *points; /* [degree[0] + 1][degree[1] + 1][4]: weight times (x, y, z), and weight */
} bat_patch;

/* A row of a patch, where one parameter is constant: its Bezier points, and how they change with
 * that parameter; both homogeneous. */
typedef struct {
    int degree;
    double at[BATTEN_MAX_DEGREE + 1][4], change[BATTEN_MAX_DEGREE + 1][4];
} bat_row;

/* The row at `t` of direction `constant`. */
void bat_patch_row(const bat_patch *patch, batten_direction constant, double t, bat_row *row);

/* A point of a row: derivative 0 is along the parameter that is constant in the row, derivative
 * 1 along the row. */
typedef struct {
    double at[3], derivative[2][3];
} bat_row_point;
void bat_row_at(const bat_row *row, double t, bat_row_point *out);

/* The form n.P - d over a row in Bernstein form, times the weights, which are above 0: its
 * signs are those of the height above the plane. */
void bat_row_heights(const bat_row *row, const double n[3], double d,
                     double heights[BATTEN_MAX_DEGREE + 1]);

/* Where a polynomial in Bernstein form is 0, rising; none where it is 0 all along. OUT_OF_MEMORY. */
batten_status bat_row_roots(int degree, const double *heights, double roots[BATTEN_MAX_DEGREE],
                            int *count);

#endif
