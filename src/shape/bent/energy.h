/*
 * Curves of least energy: the density of the energy along a curve, and Newton's method on nodes
 * that carry point, first and second derivative.
 */
#ifndef BAT_ENERGY_H
#define BAT_ENERGY_H
#include "base/base.h"
#include <batten/bent.h>
#include <batten/chain.h>

/* ---- density ---- */

/* What is integrated over the parameter: `energy` times the density of the energy and `length`
 * times that of the length. */
typedef struct {
    batten_energy kind;
    double energy, length;
} bat_energy_weights;

/* Of the first three derivatives of a point by the parameter, 3 d numbers, d = 2 or 3. */
typedef struct {
    double energy, length; /* their densities, unweighted */
    double size;           /* of the terms that were summed to `energy` */
    double gradient[9];    /* of the weighted sum */
    double hessian[81];    /* [3 d][3 d] */
} bat_energy_density;

/* `derivatives` [3][d]; gradient and hessian only when `all`. */
void bat_energy_density_at(const bat_energy_weights *weights, int d, const double *derivatives,
                           bool all, bat_energy_density *out);

/* ---- the curve ---- */

/* Nodes [count], each with 3 d numbers: point, first and second derivative. Between nodes j and
 * j + 1 stands one quintic over a parameter of length step[j]. */
typedef struct {
    int d, count, spans;
    bool closed;
    double *x;     /* [count][3][d] */
    double *step;  /* [spans] */
    int *unknown;  /* [count][3][d], along the axes of the node: its number, -1 when fixed */
    double *frame; /* [count][d][d]: square axes, by columns, the first along the tangent */
    int unknown_count, band;
} bat_energy_curve;

typedef struct {
    batten_energy kind;
    bool scale_invariant;
    double tension;
    int max_steps;
    double longest; /* a curve beyond this length is growing without end */
} bat_energy_task;

/* Where a search ended. */
typedef enum {
    BAT_ENERGY_LEAST,    /* at the least, to rounding */
    BAT_ENERGY_UNDERWAY, /* after max_steps */
    BAT_ENERGY_STUCK,    /* no step lowers the energy, though its derivatives say so */
    BAT_ENERGY_GROWING   /* it became longer than it may be */
} bat_energy_end;

/* Lower the energy towards its least near x. */
batten_status bat_energy_minimise(const bat_energy_task *task, bat_energy_curve *curve,
                                  batten_curve_minimum_energy_report *report,
                                  bat_energy_end *end);

/* ---- the parameter ---- */

double bat_energy_length(const bat_energy_curve *curve);
/* Make the parameter the arc length, as near as quintics with the same points, tangents and
 * curvatures at the nodes come to it; false where the curve stands still. */
bool bat_energy_by_length(bat_energy_curve *curve);

/* The six Bernstein coefficients [6][d] of span j. */
void bat_energy_bezier(const bat_energy_curve *curve, int j, double *points);

/* ---- from points to nodes and back: energy_spline.c ---- */

/* The points in units of their mean chord, from the first one; then all numbers are near 1. */
typedef struct {
    const batten_curve_minimum_energy_options *options;
    int d, count, pieces; /* pieces: quintics between points */
    const double *given;
    double unit;
    double rest;        /* a search ends when its energy can fall by no more than this part */
    double *points;     /* [count][d] */
    double *parameters; /* [count + 1] of the curve that the nodes are sampled from */
    bat_energy_curve nodes;
} bat_energy_spline;

/* Points and their chord lengths. To be ended, also after a failure. */
batten_status bat_energy_spline_begin(bat_energy_spline *t);
void bat_energy_spline_end(bat_energy_spline *t);
/* A chain, or a curve when that is NULL, through the points at `parameters`, which also has the
 * end of the domain. */
typedef struct {
    batten_chain *chain;
    batten_curve *curve;
    double *parameters; /* [count + 1] */
    double energy;      /* what is minimised, of this curve */
    bool is_rival;      /* it meets what is given at the ends */
} bat_energy_start;
/* Take all nodes from there, `pieces` between points, with the ends as given. */
batten_status bat_energy_spline_sample(bat_energy_spline *t, const bat_energy_start *start,
                                       int pieces);
/* Cut each quintic in two; the curve stays as it is. */
batten_status bat_energy_spline_halve(bat_energy_spline *t);
/* The curve in units of the model, and its parameters [count] at the points, [count + 1] when
 * closed. */
batten_status bat_energy_spline_curve(const bat_energy_spline *t, double *parameters,
                                      batten_curve **out);

/* ---- where searches start: energy_start.c ---- */

/* One part in a thousand does not count, nor does what quintics make of an arc; both in units of
 * the mean chord, the second for each point. */
#define BAT_ENERGY_WORTH 1e-3
#define BAT_ENERGY_NOTHING 1e-9
/* What may be left where a search ends; it is reported. */
#define BAT_ENERGY_REST 1e-6

enum { BAT_ENERGY_MOST_STARTS = 7 };
/* Batten's other curves through the same points that have as many conditions at the ends, the
 * one with the least energy first. To be released, also after a failure. */
typedef struct {
    int count;
    bat_energy_start at[BAT_ENERGY_MOST_STARTS];
} bat_energy_starts;
batten_status bat_energy_starts_make(const bat_energy_spline *t, bat_energy_starts *out);
void bat_energy_starts_release(bat_energy_starts *starts);

/* ---- searches: energy_search.c, energy_hold.c ---- */

enum { BAT_ENERGY_MOST_PIECES = 16 };

/* A curve of the model that beats its rivals. */
typedef struct {
    batten_curve *curve;
    double *parameters;                        /* [count + 1] */
    batten_curve_minimum_energy_report report; /* in units of the mean chord */
    bool is_growing;                           /* why there is none */
} bat_energy_found;
void bat_energy_found_release(bat_energy_found *found);

/*
 * From one start, with more and more quintics until that saves nothing. A result counts when it
 * is no worse than its rivals, and when the sums that were lowered had seen all of its energy;
 * else the next search begins at the start again. `best` stays as it was when nothing counts.
 */
batten_status bat_energy_search_start(bat_energy_spline *t, const bat_energy_start *start,
                                      double rival, bat_energy_found *best);
/* Where a curve bends less and less by growing: the least among those not much longer than its
 * rival, the best of Batten's other curves; a tension holds it. */
batten_status bat_energy_hold(bat_energy_spline *t, const bat_energy_start *rival,
                              const bat_energy_start *start, bat_energy_found *best);
/* What an energy in units of the mean chord is over one in those of the model. */
double bat_energy_unit(const bat_energy_spline *t);

/* ---- what a curve's energy is: energy_measure.c ---- */

/* What a tension in units of the mean chord is over one in those of the model. */
double bat_energy_tension_unit(const bat_energy_spline *t);
/* The tension in units of the mean chord. */
double bat_energy_tension(const bat_energy_spline *t);
/* What is minimised, in units of the mean chord, of a chain or of a curve when that is NULL,
 * whose own unit is `unit` of these: 1, or of a curve of the model the mean chord. By
 * adaptive quadrature: HUGE_VAL where it is not known, as at cusps. */
batten_status bat_energy_measure(const bat_energy_spline *t, const batten_chain *chain,
                                 const batten_curve *curve, double unit, double *out);

#endif
