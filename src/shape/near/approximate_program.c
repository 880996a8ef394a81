/* Least squares under conditions: a quadratic program over the control points. */
#include "numeric/programs/quadratic_program.h"
#include "numeric/vector.h"
#include "shape/near/approximate.h"

#include <batten/text.h>
#include <stdio.h>
#include <string.h>

/* The cube of this is what a desk computer does in a few seconds. */
enum { MOST_UNKNOWNS = 1000 };
/* Numbers in the rows of all conditions: 200 megabytes, and as much again where they are
 * solved.
 */
#define MOST_NUMBERS 25e6

/* Some or all coordinates of the control points as unknowns: j * width + c - from. */
typedef struct {
    const bat_fit *fit;
    const bat_condition_rows *rows;
    double lambda, scale; /* of the data, a power of 2 */
    int from, width;      /* coordinates */
    int count;
    double *hessian, *linear, *x;
    double *values[2], *rights[2]; /* equations and inequalities */
    int counts[2];
} quadratic_model;

static int unknown_of(const quadratic_model *p, int place, int c)
{
    return place % p->fit->count * p->width + c;
}

static bool bears(const quadratic_model *p, const bat_condition_row *row)
{
    bool any = p->width == p->fit->dimension;
    for (int c = 0; c < p->width; c++)
        any = any || row->normal[p->from + c] != 0;
    return any;
}

/* ---- the squares ---- */

static void add_square(quadratic_model *p, int first, int length, const double *values,
                       double factor, const double *right)
{
    for (int a = 0; a < length; a++)
        for (int c = 0; c < p->width; c++) {
            const int i = unknown_of(p, first + a, c);
            const double value = factor * values[a];
            double *row = p->hessian + (size_t)i * (size_t)p->count;
            for (int b = 0; b < length; b++)
                row[unknown_of(p, first + b, c)] += value * values[b];
            if (right)
                p->linear[i] += value * (p->scale * right[p->from + c]);
        }
}

static void add_squares(quadratic_model *p)
{
    const bat_fit *fit = p->fit;
    const bat_rows_of_fit *data = &fit->data, *penalty = &fit->penalty;
    for (int i = 0; i < data->count; i++)
        if (fit->factors[i] > 0)
            add_square(p, data->first[i], data->width,
                       data->values + (size_t)i * (size_t)data->width,
                       fit->factors[i] * fit->factors[i],
                       fit->points + (size_t)i * (size_t)fit->dimension);
    for (int i = 0; p->lambda > 0 && i < penalty->count; i++)
        add_square(p, penalty->first[i], penalty->width,
                   penalty->values + (size_t)i * (size_t)penalty->width, p->lambda, NULL);
}

/* ---- the conditions ---- */

static void add_condition(quadratic_model *p, const bat_condition_row *row)
{
    double *values = p->values[row->least] + (size_t)p->counts[row->least] * (size_t)p->count;
    const double largest = bat_largest(row->length, row->values);
    const double factor = largest > 0 ? 1 / largest : 1;
    for (int k = 0; k < row->length; k++)
        for (int c = 0; c < p->width; c++)
            values[unknown_of(p, row->first + k, c)] +=
                factor * row->values[k] * row->normal[p->from + c];
    p->rights[row->least][p->counts[row->least]++] = factor * (p->scale * row->right);
}

/* Row `index` of the equations, or of the inequalities, of this program. */
static const bat_condition_row *row_at(const quadratic_model *p, bool least, int index)
{
    const bat_condition_row *row = p->rows->rows;
    for (;; row++)
        if (row->least == least && bears(p, row) && index-- == 0)
            return row;
}

static void say_numbers(int d, const double *v, char out[100])
{
    if (d == 1)
        batten_text_print(out, 100, "%.9g", v[0]);
    else if (d == 2)
        batten_text_print(out, 100, "(%.9g, %.9g)", v[0], v[1]);
    else
        batten_text_print(out, 100, "(%.9g, %.9g, %.9g)", v[0], v[1], v[2]);
}

static void say_condition(const bat_fit *fit, const batten_condition *c, int number,
                          char out[300])
{
    static const char *const verbs[] = {"be", "point along", "be at least", "be at most"};
    char value[100], what[60] = "the curve";
    const double u = c->index >= 0 ? fit->parameters[c->index] : c->parameter;
    say_numbers(fit->dimension, c->value, value);
    if (c->order > 0)
        snprintf(what, sizeof what, "derivative %d", c->order);
    batten_text_print(out, 300, "condition %d, that %s must %s %s at %.9g,", number + 1, what,
                      verbs[c->kind], value, u);
}

static void say_row(const quadratic_model *p, const batten_curve_least_squares_options *o,
                    const bat_condition_row *row, char out[300])
{
    const double *U = p->fit->knots;
    switch (row->what) {
    case BAT_FOR_START:
    case BAT_FOR_END:
        snprintf(out, 300, "the condition that the curve must %s point",
                 row->what == BAT_FOR_START ? "begin in the first" : "end in the last");
        return;
    case BAT_FOR_CONDITION:
        say_condition(p->fit, &o->conditions[row->number], row->number, out);
        return;
    case BAT_FOR_SHAPE:
        batten_text_print(out, 300, "the shape between %.9g and %.9g", U[row->number + 1],
                          U[row->number + p->fit->degree + 1]);
        return;
    case BAT_FOR_SIDE:
        snprintf(out, 300, "the condition that the function must not be %s point %d",
                 o->side == BATTEN_FIT_OVER ? "below" : "above", row->number + 1);
        return;
    case BAT_FOR_BAND:
        batten_text_print(out, 300,
                          "the condition that the curve must be within %.9g of point %d",
                          o->band, row->number + 1);
        return;
    }
}

static batten_status name_refused(const quadratic_model *p,
                                  const batten_curve_least_squares_options *o,
                                  const bat_quadratic_report *report)
{
    char text[300];
    const bool least = report->refused_equation < 0;
    const int index = least ? report->refused_inequality : report->refused_equation;
    const bat_condition_row *row = row_at(p, least, index);
    say_row(p, o, row, text);
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "%s cannot hold together with the others: it is missed by %.3g", text,
                    report->missed / p->scale * bat_largest(row->length, row->values));
}

/* ---- one program ---- */

static batten_status allocate_program(quadratic_model *p)
{
    int counts[2] = {0, 0};
    p->count = p->fit->count * p->width;
    if (p->count > MOST_UNKNOWNS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d unknowns under conditions; the limit is %d: use fewer control "
                        "points",
                        p->count, MOST_UNKNOWNS);
    for (int i = 0; i < p->rows->count; i++)
        counts[p->rows->rows[i].least] += bears(p, &p->rows->rows[i]);
    const double numbers = (double)p->count * ((double)counts[0] + counts[1]);
    if (numbers > MOST_NUMBERS)
        return bat_fail(
            BATTEN_TOO_LARGE,
            "%d conditions on %d unknowns are %g numbers; the limit is %g: use fewer "
            "control points",
            counts[0] + counts[1], p->count, numbers, MOST_NUMBERS);
    const size_t n = (size_t)p->count;
    p->hessian = bat_array3(n, n, sizeof *p->hessian);
    p->linear = bat_array(n, sizeof *p->linear);
    p->x = bat_array(n, sizeof *p->x);
    bool all = p->hessian && p->linear && p->x;
    for (int k = 0; k < 2; k++) {
        p->values[k] = bat_array3((size_t)counts[k], n, sizeof **p->values);
        p->rights[k] = bat_array((size_t)counts[k], sizeof **p->rights);
        all = all && p->values[k] && p->rights[k];
    }
    return all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void release_program(quadratic_model *p)
{
    bat_release(p->hessian);
    bat_release(p->linear);
    bat_release(p->x);
    for (int k = 0; k < 2; k++) {
        bat_release(p->values[k]);
        bat_release(p->rights[k]);
    }
}

/* Do all conditions hold to rounding? */
static batten_status verify(const quadratic_model *p,
                            const batten_curve_least_squares_options *o)
{
    const double size = bat_largest(p->count, p->x);
    for (int least = 0; least < 2; least++)
        for (int i = 0; i < p->counts[least]; i++) {
            const double *row = p->values[least] + (size_t)i * (size_t)p->count;
            const double right = p->rights[least][i],
                         over = bat_dot(p->count, row, p->x) - right;
            const double allowed = 1e-9 * (size + fabs(right));
            if (over >= -allowed && (least || over <= allowed))
                continue;
            char text[300];
            say_row(p, o, row_at(p, least, i), text);
            return bat_fail(BATTEN_TOLERANCE_NOT_MET, "%s is missed by %g", text,
                            fabs(over) / p->scale);
        }
    return BATTEN_OK;
}

static batten_status solve_program(quadratic_model *p,
                                   const batten_curve_least_squares_options *o,
                                   bat_quadratic_report *report)
{
    batten_status status = allocate_program(p);
    if (status != BATTEN_OK)
        return status;
    add_squares(p);
    for (int i = 0; i < p->rows->count; i++)
        if (bears(p, &p->rows->rows[i]))
            add_condition(p, &p->rows->rows[i]);
    const bat_quadratic_program of = {p->count,     p->hessian,   p->linear,
                                      p->counts[0], p->values[0], p->rights[0],
                                      p->counts[1], p->values[1], p->rights[1]};
    status = bat_quadratic_program_solve(&of, p->x, NULL, report);
    if (status == BATTEN_NOT_COMPATIBLE)
        return name_refused(p, o, report);
    return status == BATTEN_OK ? verify(p, o) : status;
}

/* ---- the whole ---- */

static double scale_of(const bat_fit *fit)
{
    int exponent = 0;
    double largest = 0;
    for (int i = 0; i < fit->data_count; i++)
        if (fit->factors[i] > 0)
            largest =
                bat_max(largest, bat_largest(fit->dimension,
                                             fit->points + (size_t)i * (size_t)fit->dimension));
    frexp(largest, &exponent);
    return largest > 0 ? ldexp(1, bat_min_int(1000, -exponent)) : 1;
}

/* What is held is held to the bit. */
static void hold_ends(const bat_fit *fit, double *control)
{
    const size_t d = (size_t)fit->dimension;
    for (int e = 0; e < 2; e++)
        if (fit->fixed[e])
            memcpy(control + (e == 0 ? 0 : (size_t)(fit->count - 1) * d), fit->ends[e],
                   d * sizeof *control);
}

batten_status bat_fit_solve_under(const bat_fit *fit, double lambda,
                                  const batten_curve_least_squares_options *options,
                                  const bat_condition_rows *rows, double *control,
                                  int *pressing, double *freedom)
{
    const int d = fit->dimension, width = rows->coupled ? d : 1;
    batten_status status = BATTEN_OK;
    *pressing = 0;
    int equations = 0;
    for (int from = 0; status == BATTEN_OK && from < d; from += width) {
        quadratic_model p = {.fit = fit,
                             .rows = rows,
                             .lambda = lambda,
                             .scale = scale_of(fit),
                             .from = from,
                             .width = width};
        bat_quadratic_report report = {0};
        status = solve_program(&p, options, &report);
        for (int i = 0; status == BATTEN_OK && i < p.count; i++)
            control[i / width * d + from + i % width] = p.x[i] / p.scale;
        *pressing += report.active_count;
        equations += p.counts[0] - report.redundant_count;
        release_program(&p);
    }
    /* The matrix from data to values is a projection: its trace is what is left free. */
    *freedom = fit->count - (double)(*pressing + equations) / d;
    if (status == BATTEN_OK)
        hold_ends(fit, control);
    return status;
}
