/* What a chain is inside, and what each kind of span knows. */
#ifndef BAT_CHAIN_H
#define BAT_CHAIN_H
#include "base/base.h"
#include <batten/chain.h>

enum { BAT_CHAIN_ORDER = 3 };

/* The point and derivatives of one span at its own parameter t in [0, length], of dimension d:
 * out [order + 1][d]. What leaves the numbers is caught by the chain. */
typedef void (*bat_span_evaluate)(int d, const batten_span *span, double t, int order,
                                  double *out);

/* One row of the table of kinds (chain_kinds.c). */
typedef struct {
    const char *name;
    bool plane;
    bat_span_evaluate evaluate;
    /* Is the span possible at all? NULL: always. */
    batten_status (*check)(const batten_span *span, int index);
} bat_span_type;

/* NULL for a number that is no kind. */
const bat_span_type *bat_span_type_of(batten_span_kind kind);

/* The point of an arc, or line, at the arc length t. */
void bat_arc_at(const batten_span *arc, double t, double out[2]);
void bat_span_spiral(int d, const batten_span *span, double t, int order, double *out);
batten_status bat_span_spiral_check(const batten_span *span, int index);
void bat_span_tension(int d, const batten_span *span, double t, int order, double *out);
batten_status bat_span_tension_check(const batten_span *span, int index);

/* The shape of a span in tension z (by its length) that begins with the second derivative 0 and
 * ends with 1, at x of its length, `rest` = 1 - x: (sinh(z x) / sinh z - x) / z^2 and its three
 * derivatives by x; z = 0: (x^3 - x) / 6. */
void bat_tension_shape(double z, double x, double rest, double out[4]);
void bat_span_elastica(int d, const batten_span *span, double t, int order, double *out);
void bat_span_geometric(int d, const batten_span *span, double t, int order, double *out);
batten_status bat_span_elastica_check(const batten_span *span, int index);
batten_status bat_span_geometric_check(const batten_span *span, int index);

/* How far the span is at most, on [a, b] of its own parameter, from the quintic with its point and
 * two derivatives at both ends; infinity where nothing is known (quintic_bound.c). */
double bat_span_quintic_bound(int d, const batten_span *span, double a, double b);

/* ---- what the families of nonlinear splines know of their spans ---- */

/* A free elastica at the end of its arc length s, which begins at (0, 0) along the x axis. */
typedef struct {
    double point[2], tangent[2]; /* of length 1 */
    double turn;                 /* from the first tangent, -pi .. pi: it never turns farther */
    double curvature, slope;     /* and its derivative by arc length */
    double waves;                /* lambda s: how much of the period of 7.416 it has gone */
    double energy;               /* the integral of the squared curvature */
} bat_elastica;

/* From the curvature at the start and its derivative by arc length. To rounding; no loops. */
void bat_elastica_at(double curvature, double slope, double s, bat_elastica *out);

/* Over the abscissa x from 0 to 1 with the sine u(x) = sine + a x + b x^2 / 2 of the angle
 * from the chord: what curves with curvature a + b x integrate. */
typedef struct {
    double rise;       /* of u / w; w = sqrt(1 - u^2), the cosine */
    double length;     /* of 1 / w: the arc length */
    double moments[3]; /* of 1 / w^3, x / w^3, x^2 / w^3: how the rise changes with sine, a and
                          2 b */
    double energy;     /* of (a + b x)^2 / w: the squared curvature along the arc */
} bat_geometric;

/* |u| < 1 from 0 to 1. To 1e-14 of the integrals of the absolute values. */
void bat_geometric_at(double sine, double a, double b, bat_geometric *out);

struct batten_chain {
    bat_references references;
    int dimension; /* of the spans */
    int count;
    bool closed, placed;
    batten_frame frame; /* square */
    batten_vec3 y;      /* its second axis */
    batten_span *spans;
    double *breaks;
};

/* Put `t` on the span: which one holds u, and where there. */
batten_status bat_chain_locate(const batten_chain *chain, double u, batten_side side, int *span,
                               double *t);

#endif
