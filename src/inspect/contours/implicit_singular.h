/* Singular points of an implicit curve: where the field and its gradient vanish. */
#ifndef BAT_INSPECT_CONTOURS_IMPLICIT_SINGULAR_H
#define BAT_INSPECT_CONTOURS_IMPLICIT_SINGULAR_H
#include <batten/contours.h>

typedef struct {
    batten_field field;
    const void *context;
    int cells;
    double low[2], step[2];
    double tolerance;
    double *values, *gradients; /* of the nodes: [cells + 1][cells + 1], and [2] */
    double *points;             /* [edges][2] */
    int *links;                 /* [edges][2] neighbours, -1 for none */
    bool *crossed, *used;       /* [edges] */
} bat_tracer;

static inline int bat_tracer_node(const bat_tracer *t, int i, int j)
{
    return j * (t->cells + 1) + i;
}

static inline double bat_tracer_at(const bat_tracer *t, int axis, double k)
{
    return t->low[axis] + k * t->step[axis];
}

batten_status bat_tracer_find_singular(const bat_tracer *t, batten_trace *out);

#endif
