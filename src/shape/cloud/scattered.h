/*
 * Fits to scattered data. Parameters are moved and scaled so that the longer side of the domain
 * is 1, values so that their mean is 0: the equations then know no units.
 */
#ifndef BAT_SCATTERED_H
#define BAT_SCATTERED_H
#include "shape/grid/fit_frame.h"
#include "shape/near/smooth.h"
#include <batten/scattered.h>

/* `share` and `hold` of a fit, see bat_scatter. */
#define BAT_SCATTER_SHARE 1e-4
#define BAT_SCATTER_HOLD 1e-2

/* The highest degree of a net in both directions. */
enum { BAT_SCATTER_MAX_DEGREE = 9, BAT_SCATTER_WIDE = BAT_SCATTER_MAX_DEGREE + 1 };

/* One direction of the net. */
typedef struct {
    int degree, count;
    double *knots; /* [count + degree + 1] */
} bat_net_axis;

/* The equations of one net: for control point (i, j) the products with (i + a, j + b), 0 <= a
 * <= p, -q <= b <= q, at [(i * nv + j) * stencil + a * (2 q + 1) + b + q]; those with a = 0, b
 * < 0 are 0. */
typedef struct {
    size_t unknowns, stencil;
    int rights;     /* values and probes */
    double *data;   /* of the weighted data */
    double *energy; /* of the penalty */
    double *open;   /* of the penalty where no data are */
    double floor;   /* the least weight of `open` */
    double *right;  /* [rights][unknowns] */
    double *solved; /* [rights][unknowns] */
    double scale;   /* trace of `data` by that of `energy` */
    double *factor; /* band, when solved directly */
    int lower;      /* its width */
    int inner;      /* the direction whose index runs fastest there */
    int iterations; /* of conjugate gradients, in all */
} bat_net_system;

typedef struct bat_scatter bat_scatter;
struct bat_scatter {
    int dimension;
    size_t count;
    const double *values; /* the caller's, [count][d] */
    const double *given;  /* the caller's weights or NULL */
    const batten_surface_scattered_options *options;
    bat_work work;
    double *uv;                                   /* [count][2], scaled */
    double *weights;                              /* [count], what counts now */
    double *away;                                 /* [count], distances */
    double centre[3], origin[2], length, side[2]; /* side: lengths of the domain, scaled */
    bat_net_axis axis[2];
    double *control; /* [count u][count v][d], about the centre */
    bat_net_system system;
    int probes;
    /* What the penalty weighs at least, by the scale of both: with knots that follow the data,
     * and where no data are. With the first, shapes of the length of a cell lose about that
     * part, longer ones its fourth power: well below what the knots themselves cost. */
    double share, hold;
    bool keep;                           /* lambda and weights stay in the next fit */
    double lambda, sum, weight, freedom; /* lambda of the scaled domain */
    int counted;
    batten_surface_fit_report report;
    /* Of a cloud: its points about the centre, and how parameters are corrected: `most` rounds,
     * each with a fit. */
    double *centred;
    batten_status (*correct)(bat_scatter *s, batten_status (*fit)(bat_scatter *s), int most);
};

/* ---- the data (scattered_data.c) ---- */

batten_status bat_scatter_begin(bat_scatter *s, const double *uv, const batten_job *job);
void bat_scatter_end(bat_scatter *s);
/* ---- the net (fitted_net.c) ---- */

/* Even knots. */
batten_status bat_scatter_even(bat_net_axis *axis, int degree, int spans, double side);
/* Basis at datum t: first control points and values in both directions. */
void bat_scatter_basis(const bat_scatter *s, size_t t, int first[2], double *u, double *v);
/* What the control points give at datum t, minus the datum. */
void bat_scatter_rest(const bat_scatter *s, size_t t, double rest[3]);
/* Distances, weighted sum of squares. */
void bat_scatter_measure(bat_scatter *s);
/* The surface of the control points as they are, scaled and about the centre, and the net of
 * such a surface, clamped. */
batten_status bat_scatter_net(const bat_scatter *s, batten_surface **out);
batten_status bat_scatter_take(bat_scatter *s, const batten_surface *surface);
/* The surface of the control points, in the caller's units. */
batten_status bat_scatter_surface(const bat_scatter *s, batten_surface **out);
/* ---- around a fit ---- */

/* Coordinates in the plane of least squares, [count][2]; COINCIDENT when points lie on a line.
 */
batten_status bat_scatter_on_plane(size_t count, const double *points, double *uv);
/* How many points of a cloud lie in several layers over the base, into the report. */
batten_status bat_scatter_layers(bat_scatter *s);
/* How far the surface leaves the box of the data, into the report. */
batten_status bat_scatter_outside(bat_scatter *s);
/* max, rms, where. */
batten_status bat_scatter_report(bat_scatter *s);
/* By the method of the options. */
batten_status bat_scatter_fit(bat_scatter *s);

/* ---- the equations (net_equations.c, energy_without_data.c) ---- */

batten_status bat_scatter_make(bat_scatter *s);
void bat_scatter_release(bat_net_system *system);
/* Matrices and right sides of the data with their weights; `probes` more right sides. */
batten_status bat_scatter_assemble(bat_scatter *s);
/* The matrix `open`. */
batten_status bat_scatter_open(bat_scatter *s);
/* Control points and distances with this lambda. */
batten_status bat_scatter_solve(bat_scatter *s, double lambda);
/* An entry of the matrix with this lambda. */
static inline double bat_net_entry(const bat_net_system *y, size_t k, double lambda)
{
    return y->data[k] + lambda * y->energy[k] + bat_max(0, y->floor - lambda) * y->open[k];
}
/* By conjugate gradients, from what was solved before (net_gradients.c). */
batten_status bat_scatter_solve_gradients(bat_scatter *s, double lambda);
/* The trace, from the probes, after bat_scatter_solve. */
double bat_scatter_freedom(const bat_scatter *s);

/* ---- the methods ---- */

batten_status bat_scatter_penalised(bat_scatter *s);
/* Least squares over the axes as they are, with no more of a penalty than gaps ask for. */
batten_status bat_scatter_nearly(bat_scatter *s);
batten_status bat_scatter_within(bat_scatter *s);
batten_status bat_scatter_levels(bat_scatter *s);

#endif
