/* A feature beside the call behind it: the same curve, parameters of its points, and error, for each
 * set of options. */
#ifndef TESTS_DESIGN_AGREE_H
#define TESTS_DESIGN_AGREE_H
#include "support/test.h"

#include <batten/chain.h>
#include <batten/design.h>

enum { AGREE_POINTS = 24 };

/* What the call makes of the points that the feature takes: in space, in their plane, or of a function. */
typedef struct {
    batten_points points;    /* dimension 3, 2, or 1 of a function */
    const double *abscissae; /* [count] of a function; else NULL */
    int axis;            /* unless in space: the coordinate that is the same for all of them, */
    double level;        /* and what it is */
    batten_curve *curve; /* or a chain */
    batten_chain *chain;
    double parameters[AGREE_POINTS]; /* of the points; NaN first of all: they have none */
    double error, rms;               /* NaN: none is reported */
} agree_made;

typedef struct {
    const char *feature; /* what follows "a: " */
    batten_status (*call)(agree_made *made);
} agree_row;

/* Evaluate each feature as `a` after these lines of a design, and compare. */
void agree_rows(const char *before, const agree_made *data, const agree_row *rows, int count);
#define AGREE(before, data, rows) agree_rows(before, data, rows, COUNT(rows))

/* Of surfaces: the call takes what other features of the design have made. */
typedef struct {
    batten_surface *surface;
    double error; /* NaN: none is reported */
} agree_surface;

typedef struct {
    const char *feature;
    batten_status (*call)(const batten_design *design, agree_surface *made);
} agree_surface_row;

/* The curve that a feature of the design has made. */
const batten_curve *agree_input(const batten_design *design, const char *feature);
void agree_surfaces(const char *before, const agree_surface_row *rows, int count);
#define AGREE_SURFACES(before, rows) agree_surfaces(before, rows, COUNT(rows))

#endif
