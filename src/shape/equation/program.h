/* What an expression is: operations in the order in which a stack carries them out. */
#ifndef BAT_EQUATION_PROGRAM_H
#define BAT_EQUATION_PROGRAM_H
#include "numeric/interval/jet.h"
#include <batten/contours.h>

/* How many values may wait, and how many operations there may be. */
#define BAT_EQUATION_DEPTH 24
#define BAT_EQUATION_LENGTH 2000

typedef enum {
    BAT_DO_CONSTANT,
    BAT_DO_VARIABLE,
    BAT_DO_ADD,
    BAT_DO_SUBTRACT,
    BAT_DO_MULTIPLY,
    BAT_DO_DIVIDE,
    BAT_DO_POWER,
    BAT_DO_NEGATE,
    BAT_DO_LEAST,
    BAT_DO_GREATEST,
    BAT_DO_FUNCTION
} bat_equation_operation;

typedef struct {
    bat_equation_operation operation;
    int which; /* of the variables or of bat_ijet_function */
    double constant;
} bat_equation_step;

struct batten_equation {
    int variable_count, count, room;
    bat_equation_step *steps;
};

/* The expression of jets: `variables` [variable_count]; what went wrong is in space->state. */
void bat_equation_jet(const batten_equation *equation, bat_jet_space *space,
                      const bat_interval_jet *variables, bat_interval_jet *out);

/* Over a box, with the derivatives by each variable; space: of order 1 or 0 in all variables. */
void bat_equation_over(const batten_equation *equation, bat_jet_space *space,
                       const bat_interval *box, bat_interval_jet *out);

#endif
