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

void bat_span_arc(int d, const batten_span *span, double t, int order, double *out);
void bat_span_tension(int d, const batten_span *span, double t, int order, double *out);
batten_status bat_span_tension_check(const batten_span *span, int index);

/* The shape of a span in tension z (by its length) that begins with the second derivative 0 and
 * ends with 1, at x of its length, `rest` = 1 - x: (sinh(z x) / sinh z - x) / z^2 and its three
 * derivatives by x; z = 0: (x^3 - x) / 6. */
void bat_tension_shape(double z, double x, double rest, double out[4]);

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
