/*
 * Taylor arithmetic over boxes: a function together with its partial derivatives up to a total
 * order, each as an interval that holds its values at all points of a box. So the remainder of an
 * interpolation is bounded, and a gradient that cannot vanish is proved.
 *
 * A coefficient is the derivative over the factorials of its orders. A jet that is not smooth in
 * the box has everything for the derivatives that are not there; one that has no value in part or
 * all of the box sets `state` of the space.
 */
#ifndef BAT_INTERVAL_JET_H
#define BAT_INTERVAL_JET_H
#include "numeric/interval/interval.h"

/* One variable to order 6, two to order 2 (6 coefficients), three to order 1 (4). */
#define BAT_JET_COEFFICIENTS 7
#define BAT_JET_VARIABLES 3

typedef enum {
    BAT_DEFINED,  /* in all of the box, as far as is known */
    BAT_PARTLY,   /* perhaps not everywhere */
    BAT_UNDEFINED /* nowhere */
} bat_definition;

/* Which coefficients there are, by increasing order. */
typedef struct {
    int variables, order, count;
    signed char exponents[BAT_JET_COEFFICIENTS][BAT_JET_VARIABLES];
    signed char product[BAT_JET_COEFFICIENTS][BAT_JET_COEFFICIENTS]; /* -1: beyond the order */
    bat_definition state;                                            /* the worst that met */
    int side; /* in one variable: a corner at a point is taken from above, 1, or from below, -1 */
} bat_jet_space;

typedef struct {
    bat_interval c[BAT_JET_COEFFICIENTS];
} bat_interval_jet;

/* 1, 2 or 3 variables to order 6, 2 or 1 at most. */
void bat_jet_space_begin(bat_jet_space *space, int variables, int order);
/* `state` becomes this one when it is worse. */
static inline void bat_jet_space_meet(bat_jet_space *space, bat_definition state)
{
    if (state > space->state)
        space->state = state;
}

void bat_ijet_constant(const bat_jet_space *s, bat_interval value, bat_interval_jet *out);
/* The variable of this index, over an interval. */
void bat_ijet_variable(const bat_jet_space *s, int which, bat_interval range,
                       bat_interval_jet *out);

/* `out` may be one of the operands. */
void bat_ijet_add(const bat_jet_space *s, const bat_interval_jet *a, const bat_interval_jet *b,
                  bat_interval_jet *out);
void bat_ijet_subtract(const bat_jet_space *s, const bat_interval_jet *a,
                       const bat_interval_jet *b, bat_interval_jet *out);
void bat_ijet_multiply(const bat_jet_space *s, const bat_interval_jet *a,
                       const bat_interval_jet *b, bat_interval_jet *out);
void bat_ijet_divide(bat_jet_space *s, const bat_interval_jet *a, const bat_interval_jet *b,
                     bat_interval_jet *out);
/* The sign of a on the side of the point that the space names; 0: not known. */
int bat_ijet_side(const bat_jet_space *s, const bat_interval_jet *a);
/* g(a), where g [order + 1] holds the coefficients of g over the values of a. */
void bat_ijet_compose(const bat_jet_space *s, const bat_interval *g, bat_interval_jet *a);
/* Nothing is known of the derivatives of total order `first` and above. */
void bat_ijet_forget(const bat_jet_space *s, int first, bat_interval_jet *a);
void bat_ijet_least(const bat_jet_space *s, const bat_interval_jet *a,
                    const bat_interval_jet *b, bat_interval_jet *out);

/* ---- jet_functions.c ---- */

/* a^b; a whole constant exponent takes any a, another one a >= 0. */
void bat_ijet_power(bat_jet_space *s, const bat_interval_jet *a, const bat_interval_jet *b,
                    bat_interval_jet *out);

typedef enum {
    BAT_IJET_SIN,
    BAT_IJET_COS,
    BAT_IJET_TAN,
    BAT_IJET_ASIN,
    BAT_IJET_ACOS,
    BAT_IJET_ATAN,
    BAT_IJET_SINH,
    BAT_IJET_COSH,
    BAT_IJET_TANH,
    BAT_IJET_EXP,
    BAT_IJET_LN,
    BAT_IJET_LOG10,
    BAT_IJET_SQRT,
    BAT_IJET_ABS
} bat_ijet_function;
void bat_ijet_apply(bat_jet_space *s, bat_ijet_function function, bat_interval_jet *a);

#endif
