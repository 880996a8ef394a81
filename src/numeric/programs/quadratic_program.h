/*
 * Quadratic programs of moderate size: minimise x.H x / 2 - g.x under linear equations and
 * inequalities.
 */
#ifndef BAT_QUADRATIC_PROGRAM_H
#define BAT_QUADRATIC_PROGRAM_H
#include "base/base.h"

typedef struct {
    int count;             /* unknowns */
    const double *hessian; /* H [count][count], symmetric, no negative eigenvalue */
    const double *linear;  /* g [count]; NULL for zeros */
    int equal_count;
    const double *equal_rows;   /* [equal_count][count] */
    const double *equal_values; /* [equal_count]: row.x = value */
    int least_count;
    const double *least_rows;   /* [least_count][count] */
    const double *least_values; /* [least_count]: row.x >= value */
} bat_quadratic_program;

typedef struct {
    int redundant_count; /* equations that follow from those before them and were left out */
    int redundant;       /* the first of them; -1 for none */
    int active_count;    /* inequalities that hold with equality and press */
    int steps;           /* inequalities taken up or dropped */
    int refused_equation, refused_inequality; /* what NOT_COMPATIBLE names; -1 for none */
    double missed;                            /* by how much */
} bat_quadratic_report;

/*
 * The minimum x [count]. `forces` [least_count]: how hard each inequality presses, >= 0; may be
 * NULL. NOT_COMPATIBLE naming the equation that contradicts those before it, or the inequality
 * that cannot hold with the others, also in the report; SINGULAR_SYSTEM when H does not
 * determine x.
 *
 * Cost: count^3 and, for each step, count (count + inequalities).
 * Source: [GI83], after the equations are eliminated by reflections.
 */
batten_status bat_quadratic_program_solve(const bat_quadratic_program *program, double *x,
                                          double *forces, bat_quadratic_report *report);

#endif
