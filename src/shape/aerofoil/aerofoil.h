/* Aerofoil sections: what the steps from points to the normal form share. */
#ifndef BAT_AEROFOIL_H
#define BAT_AEROFOIL_H
#include "base/base.h"

#include <batten/approximate.h>

/* A row of points in order, from the trailing edge over the upper side. */
typedef struct {
    int count;
    double (*points)[2]; /* [count] */
    int *index;          /* [count], of the given points */
    double *at;          /* [count], parameters on the spline through them */
} bat_aerofoil_row;

/* A curve with its nose at the origin and the middle of its trailing edge at (1, 0). */
typedef struct {
    const batten_curve *curve;
    double start, nose, end; /* parameters */
    double reach[2];         /* x of the upper and of the lower end */
} bat_aerofoil_sides;

/* How a section changes across its chord: both sides about the middle between them. */
typedef struct {
    const bat_aerofoil_sides *sides;
    bool is_asked;
    double given_edge, edge; /* heights of the trailing edge */
    double factor, blend;
} bat_aerofoil_change;

/* Points in order without repetitions and base; release it with bat_aerofoil_row_release, also after a failure. */
batten_status bat_aerofoil_take(batten_points points, bat_aerofoil_row *row,
                                batten_curve_aerofoil_report *report);
/* The first `count` of the points the other way round. */
void bat_aerofoil_reverse(bat_aerofoil_row *row, int count);
void bat_aerofoil_row_release(bat_aerofoil_row *row);

/* The parameter where the curve is farthest from the middle of its ends, and that distance. */
batten_status bat_aerofoil_nose(const batten_curve *curve, double *nose, double *chord);
/* Turn the points so that the chord is the x axis from 0 to 1, upper side first. */
batten_status bat_aerofoil_normalise(bat_aerofoil_row *row, batten_curve **spline,
                                     bat_aerofoil_sides *sides,
                                     batten_curve_aerofoil_report *report);

/* The height of a side (0: upper) at x, where its end is at x = 1. */
batten_status bat_aerofoil_height(const bat_aerofoil_sides *sides, int side, double x,
                                  double *y);
/* Thickness, camber, trailing edge of a curve in normal position; its chord is left alone. */
batten_status bat_aerofoil_measure(const bat_aerofoil_sides *sides, batten_aerofoil_shape *out);
/* The factor of all heights above the middle that gives the thickness asked for. */
batten_status bat_aerofoil_set_thickness(bat_aerofoil_change *change, double thickness);
/* Where the point of a parameter goes. */
batten_status bat_aerofoil_move(const bat_aerofoil_change *change, double u, double to[2]);

#endif
