/*
 * A surface as the plane (u, v) that covers it: where it closes, parameters go on beyond the
 * domain, and points recur with the period.
 */
#ifndef BAT_CHART_H
#define BAT_CHART_H
#include "base/base.h"
#include <batten/body.h>

/* Sides as in border.c: 0 least v, 1 greatest u, 2 greatest v, 3 least u. */
typedef struct {
    batten_surface *surface; /* clamped NURBS, owned */
    double tolerance;
    batten_interval domain[2];
    double period[2];
    bool closed[2];
    double near[2]; /* parameters so near are the same: half the tolerance in space or less */
    double size;    /* the length of lines along it, as far as these were looked at */
    bool pole[4];   /* sides that are one point */
    double pole_at[4][3];
    bool complete; /* all its sides are seams or poles */
    int seed_count[2];
    double *seed_at[2], *seeds; /* [count], and points [count u][count v][3]; NULL until used */
} bat_chart;

batten_status bat_chart_begin(const batten_surface *surface, double tolerance,
                              bat_chart *chart);
void bat_chart_end(bat_chart *chart);
/* From now on with this tolerance. */
void bat_chart_loosen(bat_chart *chart, double tolerance);

/* Brought into the domain: by whole periods, or to its nearest end. */
void bat_chart_wrap(const bat_chart *chart, const double uv[2], double in[2]);
/* out [BATTEN_SURFACE_DERIVATIVES(order)][3] */
batten_status bat_chart_evaluate(const bat_chart *chart, const double uv[2], int order,
                                 double *out);
/* The nearest point of the surface to q, downhill from uv; what lies within a hair of a border
 * is put on it. */
batten_status bat_chart_foot(const bat_chart *chart, const double q[3], double uv[2],
                             double *distance);
/* The same with the whole of the surface searched; `guess` may be NULL, and counts when it
 * leads within the tolerance. */
batten_status bat_chart_find(bat_chart *chart, const double q[3], const double *guess,
                             double uv[2], double *distance);
/* How far a curve is off it, at so many places: the foot is looked for once, then it follows
 * the curve. */
batten_status bat_chart_miss(bat_chart *chart, const batten_curve *curve, int places,
                             double *miss);
/* How the foot moves while the point moves by d; 0 along what has no extent there. */
void bat_chart_velocity(const double *derivatives, const double d[3], double uv[2]);
/* The side that is a pole within the tolerance of q; -1 for none. */
int bat_chart_pole(const bat_chart *chart, const double q[3]);

#endif
