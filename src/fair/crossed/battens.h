/*
 * A rectangular net of points in space as crossed battens: one along each row, one along
 * each column, which share their ducks.
 *
 * All battens of a direction have the parameters of the net, the mean of their chords, so that
 * one factor serves for all. The energy of all is the sum of their integrals of |z''|^2,
 * each direction times the cube of its mean spacing, so that a duck listens to both.
 */
#ifndef BAT_CROSSED_H
#define BAT_CROSSED_H
#include "fair/elastic_batten.h"
#include "fair/fair_points.h"
#include "numeric/banded.h"

/* Of fewer points in a row there is nothing to fair. */
enum { BAT_CROSSED_FEWEST = 4 };

/* The battens of one direction; `closed` ones are periodic. */
typedef struct {
    int count;         /* ducks of each */
    const double *t;   /* [count], closed [count + 1], increasing; borrowed */
    bat_batten open;   /* of open ones */
    bat_cyclic *wrap;  /* of closed ones: what bat_batten's factor is */
    double *stiffness; /* [count]: the diagonal of K times the weight */
    double weight;
    double spread; /* the largest sum of |K_ij| / K_ii over a row: no eigenvalue is above it */
} bat_crossed_side;

typedef struct {
    int count_u, count_v;
    const double *given;  /* [count_u][count_v][3], borrowed */
    const double *within; /* [count_u][count_v], 0: held; borrowed */
    bat_crossed_side u, v;
    double *room; /* for one batten: [longest][3] three times */
} bat_crossed;

batten_status bat_crossed_begin(batten_grid points, const double *within, batten_uv parameters,
                                const bool closed[2], bat_crossed *out);
void bat_crossed_end(bat_crossed *battens);

/* The forces [count_u][count_v][3] on all ducks at z; the result is the energy. Linear. */
batten_status bat_crossed_bend(bat_crossed *battens, const double *z, double *forces,
                               double *energy);

/*
 * The places z of least energy with every duck within its ball; z comes as given. Ends when no
 * duck that is released alone would go farther than a thousandth of the lesser of its bound and of
 * the farthest that one would have gone at the start, or after a number of steps: `residual` is
 * the farthest, as a part of that.
 */
batten_status bat_crossed_least(bat_crossed *battens, const batten_job *job, double *z,
                                double *residual);

/*
 * Points that agree with neither their row nor their column, the worst first: `suspects` of the
 * tally. Each is held against the cubics through its neighbours in both directions, and then put
 * where these are in the mean in `mended` [count_u][count_v][3], which comes as given.
 */
batten_status bat_crossed_blunders(const bat_crossed *battens, double *mended,
                                   bat_fair_tally *tally);

#endif
