/*
 * Newton's step of a convex program: the numbers of an iteration, products with the rows and the
 * Hessian, and the factored system.
 */
#ifndef BAT_CONVEX_SYSTEM_H
#define BAT_CONVEX_SYSTEM_H
#include "numeric/programs/convex_program.h"

/* The four nonnegative numbers of each row; t and q are 0 in rows that must hold. */
typedef struct {
    double *s, *z, *t, *q;
} bat_convex_rows;

typedef struct {
    const bat_convex_program *of;
    int n, m, priced;
    double unit;              /* the mean diagonal of H: the objective is divided by it */
    double size;              /* of the bounds: their median */
    double *norm;             /* [m] of the rows, which are divided by it */
    double *bound, *price;    /* [m], of normed rows; price HUGE_VAL where none is given */
    double *x, *dx;           /* [n] */
    bat_convex_rows at, step; /* [m] each */
    double *unmet;            /* [n]: H x + c + At z */
    double *missed;           /* [m]: A x - t + s - b */
    double *middle;           /* [m]: D */
    double *right;            /* [m], then [n]: right sides of a step */
    double *sum;              /* [n] */
    double *factor;           /* [n][band + 1] */
    double mean;              /* of s z and t q */
    double *best_x, *best_z;  /* [n], [m]: where the conditions were met best */
    double merit, best;       /* how well: the largest miss against what is aimed at */
    bat_convex_report report, best_report;
} bat_convex_system;

static inline bool bat_convex_has_price(const bat_convex_system *p, int i)
{
    return p->price[i] < HUGE_VAL;
}

/* Row i, normed, times a vector. */
double bat_convex_row_times(const bat_convex_system *p, int i, const double *x);
/* to += factor times row i, normed. */
void bat_convex_add_row(const bat_convex_system *p, int i, double factor, double *to);
/* to = H x / unit. */
void bat_convex_hessian_times(const bat_convex_system *p, const double *x, double *to);

/* Factor H + At D^-1 A. Rows that press hard drown H in their rounding: the diagonal is then
 * raised, which shortens the step and does not move where it leads. */
batten_status bat_convex_factor(bat_convex_system *p);
/* Newton's step towards s z = `target` and t q = `target`, less the products of the step before
 * where it corrects. */
void bat_convex_find_step(bat_convex_system *p, double target, bool correct);

#endif
