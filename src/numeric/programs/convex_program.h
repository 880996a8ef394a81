/*
 * Convex programs of many unknowns with narrow support: minimise x.H x / 2 + c.x under
 * row.x <= bound, with H and the products of the rows in a band. What is lofted from splines is
 * of this kind. Small dense programs with equations: numeric/programs/quadratic_program.h.
 */
#ifndef BAT_CONVEX_PROGRAM_H
#define BAT_CONVEX_PROGRAM_H
#include "base/base.h"

/* Rows of few nonzeros, one after the other. */
typedef struct {
    int count;
    const int *start;  /* [count + 1]: row i has the entries start[i] .. start[i + 1] - 1 */
    const int *column; /* ascending within a row */
    const double *value;
} bat_sparse_rows;

typedef struct {
    int count; /* unknowns */
    int band;  /* columns of one row, and the nonzeros of H, are at most so far apart */
    const double *hessian; /* [count][band + 1], lower half as in bat_symmetric_factor */
    const double *linear;  /* c [count] */
    bat_sparse_rows rows;
    const double *bounds; /* [rows.count]: row.x <= bound */
    /* [rows.count]: what a unit beyond the bound costs; HUGE_VAL where it must hold. NULL: all
     * must hold. */
    const double *prices;
} bat_convex_program;

typedef struct {
    double *x; /* [count] */
    double
        *multipliers; /* [rows.count], >= 0: the objective falls so fast as a bound is eased */
    double *beyond;   /* [rows.count]: by how much a row with a price exceeds its bound */
} bat_convex_solution;

typedef struct {
    int iterations;
    double
        violated; /* the most that a row misses its bound by, against the bound or the median of all */
    double unmet; /* the largest entry of H x + c + rows' multipliers, against its terms */
    double gap;   /* between the program and its dual, against the objective */
} bat_convex_report;

/*
 * The minimum. `warm`: a solution of a program of the same shape to start from, may be the
 * arrays of `out`; NULL starts from zeros. NOT_COMPATIBLE when the rows that must hold cannot
 * hold together, NO_CONVERGENCE when the answer is not reached; `out` is then as it was.
 *
 * Cost: for each of 10 to 40 iterations, count band^2 and the squares of the nonzeros of the
 * rows. Source: Mehrotra's predictor and corrector, [NW06] 16.6; the start, [YW02].
 */
batten_status bat_convex_program_solve(const bat_convex_program *program,
                                       const bat_convex_solution *warm,
                                       bat_convex_solution *out, bat_convex_report *report);

#endif
