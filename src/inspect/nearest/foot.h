/*
 * The foot of the perpendicular from a point: where the distance from it to a curve or a
 * surface is least nearby. Here are the steps towards it, and the descent of two parameters
 * that takes them: Newton's method on the square of the distance, which falls back to Gauss and
 * Newton where the second derivatives are of no use, halves what does not come nearer, and
 * stays inside limits. Where there is a foot at all, who searches all of a shape knows:
 * surface_deviation.c, deviation.c, body/trace/chart.c.
 */
#ifndef BAT_FOOT_H
#define BAT_FOOT_H
#include "base/base.h"
#include <batten/surface.h>

/* ---- one step ---- */

/* The step along a curve towards the foot of q; `at` [3][d] are point and two derivatives. That
 * of Gauss and Newton where Newton's matrix is less than half of theirs. */
double bat_foot_curve_step(int d, const double *at, const double *q);

/* A place of two parameters, and what is made least there. */
typedef struct {
    double at[2];
    double value;       /* half the square of the distance, or what rises with it */
    double gradient[2]; /* of half the square of the distance */
    double second[3];   /* its second derivatives uu, uv, vv ... */
    double normal[3];   /* ... and without those of the shape: Su Su, Su Sv, Sv Sv */
} bat_foot_place;

/* All but `at` from the derivatives s [BATTEN_SURFACE_DERIVATIVES(order)][d] at a place; of
 * order 1 the second derivatives are without those of the surface. */
void bat_foot_slopes(int d, const double *s, int order, const double *q, bat_foot_place *out);

/* The step downhill with the symmetric matrix h (uu, uv, vv) along the free directions; false
 * when h is not positive there. */
bool bat_foot_solve(const double h[3], const double g[2], const bool free[2], double step[2]);

/* Newton's step along the free directions. That of Gauss and Newton where his matrix is not
 * positive, or less than `trust` of theirs; each direction by itself where the tangents span no
 * plane. A trust of 0 is for those who halve steps, 1/4 for those who take one. */
void bat_foot_step(const bat_foot_place *here, const bool free[2], double trust,
                   double step[2]);

/* ---- downhill ---- */

typedef struct {
    batten_status (*look)(const void *context, const double at[2], bat_foot_place *out);
    void (*step)(const bat_foot_place *here, const bool free[2], double step[2]);
    const void *context;
    double low[2], high[2]; /* where the search stays; infinite where there is no limit */
    double longest[2];      /* a step is cut to this */
    double least[2];        /* and is not taken when it is below this both ways */
    int steps, halvings;    /* at most */
} bat_foot_descent;

/* From `foot->at`, which lies inside the limits, downhill. */
batten_status bat_foot_descend(const bat_foot_descent *descent, bat_foot_place *foot);

/* A part of the parameter plane of a surface of dimension d <= 3. */
typedef struct {
    const batten_surface *surface;
    double low[2], high[2];
} bat_foot_area;

/* The same on a surface, inside the area and with the derivatives from inside it; of order 1
 * only, or 2. The value is half the square of the distance. */
batten_status bat_foot_on_surface(const bat_foot_area *area, int order, int steps,
                                  const double *q, bat_foot_place *foot);

#endif
