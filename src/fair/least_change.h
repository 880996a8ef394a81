/*
 * The program of fairing by least change: how a batten moves when the coefficients of its difference from another do.
 *
 * The difference of two natural cubic splines over the same ducks is one itself: a sum of cubic B-splines with knots at the
 * ducks, whose second and last but one coefficients follow from the second derivative of 0 at its ends. The unknowns are the
 * others, one for each duck and coordinate, in units of the largest bound.
 */
#ifndef BAT_LEAST_CHANGE_H
#define BAT_LEAST_CHANGE_H
#include "base/arena.h"
#include "fair/fair_points.h"

enum { BAT_CHANGE_SUPPORT = 4 };

/* A number that is linear in the unknowns of one coordinate: weights of four of them. */
typedef struct {
    int first;
    double weight[BAT_CHANGE_SUPPORT];
} bat_change_row;

typedef struct {
    const bat_fair_piece *piece;
    int ducks, width;
    double unit;   /* the largest bound */
    double *knots; /* [ducks + 6] */
    bat_arena arena;
    double
        *bend; /* [3 * spans][width]: of the first derivative on each span, its Bezier points */
    double *moments; /* [ducks][width] */
    int *signs;      /* [ducks]: that the turning at each has in the end */
    int row_room, entry_room;
    int row_count, *start, *column;
    double *value, *bounds, *prices, *hessian, *linear, *x;
} bat_least_change;

/* The arrays, and the knots. End with the arena, also when it fails. */
batten_status bat_change_begin(const bat_fair_piece *piece, bat_least_change *out);

/* A derivative of the difference, up to the second, on span `span` at its first or its last end; at duck i. */
bat_change_row bat_change_row_on(const bat_least_change *c, int span, bool last, int order);
bat_change_row bat_change_row_at(const bat_least_change *c, int i, int order);

/* Of the batten through z: moments, and the Bezier points of the first derivative. */
void bat_change_bend(bat_least_change *c, const double *z);
/* How it turns at each duck [ducks]: of a function the second derivative, of a plane curve P' x P''. 0 at the ends. */
void bat_change_turning(const bat_least_change *c, double *turning);

/* The program of least change with these signs, to the first order about z; its solution moves z and is `length` units of the
 * largest bound long. */
batten_status bat_change_step(bat_least_change *c, double *z, double *length);

#endif
