/* The equations of a spiro spline, one by one. */
#ifndef BAT_BENT_SPIRO_EQUATIONS_H
#define BAT_BENT_SPIRO_EQUATIONS_H
#include "numeric/givens.h"
#include "shape/bent/spiro.h"

/* Unknowns of the two spans that an equation knows. */
enum { BAT_SPIRO_WIDTH = 2 * BAT_SPIRO_UNKNOWNS };

typedef struct {
    double *c;             /* [spans][4] */
    bat_spiro_span *spans; /* at c */
    double *values;        /* [count][4], of the equations at each point */
    double worst;          /* the largest of them */
    int worst_at;          /* its point */
    double size;           /* the largest turning of a span */
} bat_spiro_iterate;

typedef struct {
    const bat_spiro_task *task;
    double part; /* 0: Euler spirals; 1: what smooth points ask for */
    bat_givens qr;
    double *step, *rest; /* [spans][4]: Newton's, and what it would be at the next iterate */
    bat_spiro_iterate now, next;
    int steps, max_steps;
} bat_spiro_search;

/* value = 0; its derivatives by the unknowns of the span before the point and of that after. */
typedef struct {
    double value, row[BAT_SPIRO_WIDTH];
} bat_spiro_terms;

/* Equation `which` of 0..3 at point i between the two spans. */
bat_spiro_terms bat_spiro_equation(const bat_spiro_search *s, const bat_spiro_iterate *it,
                                   int i, int before, int after, int which);
/* Equation 0 or 1 at the start (end 0) or the end of an open curve. */
bat_spiro_terms bat_spiro_end_equation(const bat_spiro_search *s, const bat_spiro_iterate *it,
                                       int end, int which);

#endif
