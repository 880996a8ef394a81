/* Expressions evaluated in jets of intervals. */
#include "shape/equation/program.h"

static void negate(const bat_jet_space *s, bat_interval_jet *a)
{
    for (int i = 0; i < s->count; i++)
        a->c[i] = bat_interval_negative(a->c[i]);
}

/* max(a, b) = -min(-a, -b) */
static void take_greatest(const bat_jet_space *s, bat_interval_jet *a, bat_interval_jet *b)
{
    negate(s, a);
    negate(s, b);
    bat_ijet_least(s, a, b, a);
    negate(s, a);
}

/* a becomes a o b. */
static void combine(bat_equation_operation operation, bat_jet_space *s, bat_interval_jet *a,
                    bat_interval_jet *b)
{
    switch (operation) {
    case BAT_DO_ADD:
        bat_ijet_add(s, a, b, a);
        return;
    case BAT_DO_SUBTRACT:
        bat_ijet_subtract(s, a, b, a);
        return;
    case BAT_DO_MULTIPLY:
        bat_ijet_multiply(s, a, b, a);
        return;
    case BAT_DO_DIVIDE:
        bat_ijet_divide(s, a, b, a);
        return;
    case BAT_DO_POWER:
        bat_ijet_power(s, a, b, a);
        return;
    case BAT_DO_LEAST:
        bat_ijet_least(s, a, b, a);
        return;
    default:
        take_greatest(s, a, b);
    }
}

void bat_equation_jet(const batten_equation *equation, bat_jet_space *space,
                      const bat_interval_jet *variables, bat_interval_jet *out)
{
    bat_interval_jet stack[BAT_EQUATION_DEPTH];
    int top = -1;
    space->state = BAT_DEFINED;
    for (int i = 0; i < equation->count; i++) {
        const bat_equation_step *step = &equation->steps[i];
        switch (step->operation) {
        case BAT_DO_CONSTANT:
            bat_ijet_constant(space, bat_interval_at(step->constant), &stack[++top]);
            break;
        case BAT_DO_VARIABLE:
            stack[++top] = variables[step->which];
            break;
        case BAT_DO_NEGATE:
            negate(space, &stack[top]);
            break;
        case BAT_DO_FUNCTION:
            bat_ijet_apply(space, (bat_ijet_function)step->which, &stack[top]);
            break;
        default:
            combine(step->operation, space, &stack[top - 1], &stack[top]);
            top--;
        }
    }
    *out = stack[0];
}

void bat_equation_over(const batten_equation *equation, bat_jet_space *space,
                       const bat_interval *box, bat_interval_jet *out)
{
    bat_interval_jet variables[BAT_JET_VARIABLES];
    for (int i = 0; i < equation->variable_count; i++)
        bat_ijet_variable(space, i, box[i], &variables[i]);
    bat_equation_jet(equation, space, variables, out);
}

batten_status batten_equation_value(const batten_equation *equation, const double *at,
                                    double *value, double *error)
{
    bat_jet_space space;
    bat_interval box[BAT_JET_VARIABLES];
    bat_interval_jet made;
    bat_jet_space_begin(&space, equation->variable_count, 0);
    for (int i = 0; i < equation->variable_count; i++)
        box[i] = bat_interval_at(at[i]);
    bat_equation_over(equation, &space, box, &made);
    if (space.state != BAT_DEFINED || !bat_interval_is_finite(made.c[0]))
        return bat_fail(BATTEN_OUT_OF_DOMAIN, "the expression has no finite value there");
    *value = bat_interval_middle(made.c[0]);
    if (error)
        *error = bat_above(0.5 * bat_interval_width(made.c[0]));
    return BATTEN_OK;
}

void batten_equation_free(batten_equation *equation)
{
    if (equation)
        bat_release(equation->steps);
    bat_release(equation);
}
