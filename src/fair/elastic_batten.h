/*
 * The elastic batten: a natural cubic spline over ducks at the parameters t, as the loftsman's
 * strip of wood pressed by forces at the ducks.
 *
 * Its energy is the integral of |z''|^2, E = z^T K z with K = Q R^-1 Q^T for each coordinate;
 * the force on duck i is F_i = (K z)_i, the jump of the third derivative there. Ordinates,
 * moments (second derivatives) and forces are rows of `width` numbers, one for each coordinate.
 */
#ifndef BAT_BATTEN_H
#define BAT_BATTEN_H
#include "base/base.h"
#include "numeric/vector.h"
#include <batten/fair.h>

/* Sweeps and the method of least energy end when no duck would move farther than this share of
 * its bound: less is nothing that anyone sees or measures. */
#define BAT_DUCK_AT_REST 1e-6

typedef struct {
    int count;
    const double *t;  /* [count], borrowed */
    double *factor;   /* R = L D L^T, [count - 2][2]: subdiagonal of L, then D */
    double *diagonal; /* of K, [count] */
} bat_batten;

/* t must increase; at least two ducks. */
batten_status bat_batten_begin(int count, const double *t, bat_batten *out);
void bat_batten_end(bat_batten *batten);

/* Moments [count][width] of the batten through the ordinates z and, unless NULL, the forces.
 * The result is the energy E. Cost: linear. */
double bat_batten_bend(const bat_batten *batten, int width, const double *z, double *moments,
                       double *forces);

/* The batten itself: the cubic curve through the ordinates z. */
batten_status bat_batten_curve(const bat_batten *batten, int width, const double *z,
                               batten_curve **out);

/* What holds the ducks of one batten, and what else pulls at them. */
typedef struct {
    int width;
    const double *centre; /* [count][width], where each was given */
    const double *within; /* [count], how far it may go from there */
    const int
        *freedom; /* [count], along how many rows of its frame; 0 holds it at its centre */
    const double *frames; /* [count][width][width], orthonormal rows */
    const double *pull;   /* [count], the stiffness of a spring to `anchor`; or NULL */
    const double *anchor; /* [count][width] */
} bat_ducks;

/* Where duck i, now at z [width] under the `force` [width] of the batten, goes when it alone is
 * released: `relaxation` times its whole way, brought back into its bound. */
void bat_duck_release(const bat_batten *batten, const bat_ducks *ducks, int i, const double *z,
                      const double *force, double relaxation, double *to);

/*
 * The ordinates of least E / 2 + sum pull |z - anchor|^2 / 2 with every duck within its bound:
 * what releasing one duck after another tends to.
 *
 * `residual`: the farthest that a duck would still go if it alone were released, as a part of
 * its bound. TOLERANCE_NOT_MET when that is above 1e-6.
 */
batten_status bat_batten_least(const bat_batten *batten, const bat_ducks *ducks,
                               const batten_job *job, double *z, double *residual);

/* Bring z back to where its distance from `centre` is at most `within` in exact arithmetic. */
void bat_clip(int width, const double *centre, double within, double *z);

#endif
