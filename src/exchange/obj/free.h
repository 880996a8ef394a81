/* A free-form curve or surface from its control points. */
#ifndef BAT_OBJ_FREE_H
#define BAT_OBJ_FREE_H
#include "exchange/obj/obj.h"

enum { BAT_OBJ_MOST_DEGREE = 25 };

/* One direction as it will be: pieces of degree p over knots. */
typedef struct {
    int p, given, count; /* control points as given, and of the B-spline */
    int step;            /* from piece to piece; 0 for a B-spline as it stands */
    const double
        *matrix;    /* [p + 1][p + 1] from given points to Bezier points; NULL: as given */
    double *powers; /* the memory of a matrix that is made for it */
    double *knots;  /* [count + p + 1] */
} bat_obj_axis;

/* What is wrong in a direction; NULL when nothing is. */
const char *bat_obj_check_direction(const bat_obj_free *f, int k, bat_obj_axis *d);
/* Knots, and for bases of powers the matrix. */
batten_status bat_obj_prepare_direction(bat_obj *obj, int k, bat_obj_axis *d);
/* The shape out of what was read; a status other than OUT_OF_MEMORY and TOO_LARGE only means
 * that this one is left out. */
batten_status bat_obj_build(bat_obj *obj, const bat_obj_axis d[2], bat_obj_shape *shape);

#endif
