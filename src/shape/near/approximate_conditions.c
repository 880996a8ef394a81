/* What a curve near points must meet, as rows over its control points. */
#include "numeric/vector.h"
#include "shape/near/approximate.h"
#include "spline/spline.h"

#include <string.h>

enum { MOST_ORDER = 4 };

void bat_condition_rows_free(bat_condition_rows *rows)
{
    bat_release(rows->rows);
    *rows = (bat_condition_rows){0};
}

bool bat_fit_has_conditions(const batten_curve_least_squares_options *o)
{
    return o->condition_count > 0 || o->shape || o->side != BATTEN_FIT_BOTH || o->band > 0;
}

/* What is being asked, while the rows are made. */
typedef struct {
    const bat_fit *fit;
    const batten_curve_least_squares_options *options;
    const double *U; /* all knots */
    bat_condition_rows rows;
} asking;

/* ---- rows ---- */

static bat_condition_row *next_row(asking *a, bat_condition_for what, int number)
{
    bat_condition_row *row = &a->rows.rows[a->rows.count++];
    *row = (bat_condition_row){.what = what, .number = number};
    return row;
}

/* Derivative `order` at u, which lies in the domain. */
static void fill_row(const asking *a, double u, int order, bat_condition_row *row)
{
    const int p = a->fit->degree, n = bat_fit_all_count(a->fit);
    double basis[(MOST_ORDER + 1) * (BATTEN_MAX_DEGREE + 1)];
    const int span = bat_knots_span(p, n, a->U, u, BATTEN_FROM_RIGHT);
    bat_basis(p, a->U, span, u, order, basis);
    row->first = (span - p) % a->fit->count;
    row->length = p + 1;
    memcpy(row->values, basis + (size_t)order * (size_t)(p + 1),
           (size_t)row->length * sizeof *row->values);
}

static void turn_around(bat_condition_row *row)
{
    for (int k = 0; k < row->length; k++)
        row->values[k] = -row->values[k];
    row->right = -row->right;
}

static void ask_ends(asking *a)
{
    const bat_fit *fit = a->fit;
    for (int e = 0; e < 2; e++)
        for (int c = 0; fit->fixed[e] && c < fit->dimension; c++) {
            bat_condition_row *row = next_row(a, e == 0 ? BAT_FOR_START : BAT_FOR_END, c);
            row->first = e == 0 ? 0 : fit->count - 1;
            row->length = 1;
            row->values[0] = row->normal[c] = 1;
            row->right = fit->ends[e][c];
        }
}

/* ---- the conditions of the caller ---- */

static batten_status check_condition(const asking *a, int i, double *u)
{
    const batten_condition *c = &a->options->conditions[i];
    const int d = a->fit->dimension, p = a->fit->degree, n = bat_fit_all_count(a->fit);
    const bool equal = c->kind == BATTEN_CONDITION_EQUAL;
    if ((int)c->kind < 0 || c->kind > BATTEN_CONDITION_AT_MOST)
        return bat_fail(BATTEN_BAD_ARGUMENT, "condition %d is of no kind: %d", i + 1,
                        (int)c->kind);
    if (!equal && (c->kind == BATTEN_CONDITION_DIRECTION) == (d == 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "condition %d is for a %s", i + 1,
                        d == 1 ? "curve, not a function" : "function, not a curve");
    if (c->index >= a->fit->data_count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "condition %d is for point %d of %d", i + 1,
                        c->index + 1, a->fit->data_count);
    if (c->order < (c->kind == BATTEN_CONDITION_DIRECTION) || c->order > MOST_ORDER)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "condition %d is for the derivative of order %d; it must be in %d..%d",
                        i + 1, c->order, c->kind == BATTEN_CONDITION_DIRECTION, MOST_ORDER);
    for (int k = 0; k < d; k++)
        if (!isfinite(c->value[k]))
            return bat_fail(BATTEN_NOT_FINITE, "number %d of condition %d is %g", k + 1, i + 1,
                            c->value[k]);
    if (c->kind == BATTEN_CONDITION_DIRECTION && !(bat_norm(d, c->value) > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "condition %d is a direction of length 0", i + 1);
    *u = c->index >= 0 ? a->fit->parameters[c->index] : c->parameter;
    if (!(*u >= a->U[p] && *u <= a->U[n]))
        return bat_fail(isfinite(*u) ? BATTEN_OUT_OF_DOMAIN : BATTEN_NOT_FINITE,
                        "condition %d is at %g, outside %g .. %g", i + 1, *u, a->U[p], a->U[n]);
    return BATTEN_OK;
}

/* Two directions across `v`, and v itself, of length 1. */
static void frame_of(int d, const double *v, double out[3][3])
{
    memset(out, 0, 9 * sizeof(double));
    const double length = bat_norm(d, v);
    for (int k = 0; k < d; k++)
        out[2][k] = v[k] / length;
    const double *t = out[2];
    if (d == 2) {
        out[0][0] = -t[1];
        out[0][1] = t[0];
        return;
    }
    int least = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(t[k]) < fabs(t[least]))
            least = k;
    const batten_vec3 along = {t[0], t[1], t[2]}, axis = {least == 0, least == 1, least == 2};
    const batten_vec3 across = bat_vec3_cross(along, axis),
                      other = bat_vec3_cross(along, across);
    const double size = bat_vec3_norm(across);
    const batten_vec3 both[2] = {across, other};
    for (int k = 0; k < 2; k++) {
        out[k][0] = both[k].x / size;
        out[k][1] = both[k].y / size;
        out[k][2] = both[k].z / size;
    }
}

static void ask_direction(asking *a, int i, double u)
{
    const batten_condition *c = &a->options->conditions[i];
    const int d = a->fit->dimension;
    double frame[3][3];
    frame_of(d, c->value, frame);
    for (int k = 0; k < d; k++) {
        const int axis = k < d - 1 ? k : 2;
        bat_condition_row *row = next_row(a, BAT_FOR_CONDITION, i);
        fill_row(a, u, c->order, row);
        memcpy(row->normal, frame[axis], sizeof row->normal);
        row->least = axis == 2;
    }
    a->rows.coupled = true;
}

static batten_status ask_condition(asking *a, int i)
{
    const batten_condition *c = &a->options->conditions[i];
    double u = 0;
    const batten_status status = check_condition(a, i, &u);
    if (status != BATTEN_OK)
        return status;
    if (c->kind == BATTEN_CONDITION_DIRECTION) {
        ask_direction(a, i, u);
        return BATTEN_OK;
    }
    for (int k = 0; k < a->fit->dimension; k++) {
        bat_condition_row *row = next_row(a, BAT_FOR_CONDITION, i);
        fill_row(a, u, c->order, row);
        row->normal[k] = 1;
        row->right = c->value[k];
        row->least = c->kind != BATTEN_CONDITION_EQUAL;
        if (c->kind == BATTEN_CONDITION_AT_MOST)
            turn_around(row);
    }
    return BATTEN_OK;
}

/* ---- shapes of functions ---- */

/* Coefficient i of the first derivative, without its factor. */
static void ask_slope(asking *a, int i, bool falling)
{
    bat_condition_row *row = next_row(a, BAT_FOR_SHAPE, i);
    row->first = i;
    row->length = 2;
    row->values[0] = -1;
    row->values[1] = row->normal[0] = 1;
    row->least = true;
    if (falling)
        turn_around(row);
}

/* Coefficient i of the second derivative: slopes over the distances of Greville's abscissae. */
static void ask_bend(asking *a, int i, bool concave)
{
    const int p = a->fit->degree;
    const double h = a->U[i + p + 1] - a->U[i + 1], next = a->U[i + p + 2] - a->U[i + 2];
    const double size = bat_max(h, next);
    if (!(size > 0))
        return;
    bat_condition_row *row = next_row(a, BAT_FOR_SHAPE, i);
    row->first = i;
    row->length = 3;
    row->values[0] = next / size;
    row->values[1] = -(h + next) / size;
    row->values[2] = h / size;
    row->normal[0] = 1;
    row->least = true;
    if (concave)
        turn_around(row);
}

static batten_status ask_shape(asking *a)
{
    const unsigned shape = a->options->shape;
    const int n = a->fit->count;
    if (shape == 0)
        return BATTEN_OK;
    if (a->fit->dimension > 1 || a->fit->periodic)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a shape is for open functions, not for a %s",
                        a->fit->dimension > 1 ? "curve" : "closed one");
    if (shape > 15)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown shape %u", shape);
    for (int i = 0; i < n - 1; i++) {
        if (shape & BATTEN_INCREASING)
            ask_slope(a, i, false);
        if (shape & BATTEN_DECREASING)
            ask_slope(a, i, true);
        if (i < n - 2 && shape & BATTEN_CONVEX)
            ask_bend(a, i, false);
        if (i < n - 2 && shape & BATTEN_CONCAVE)
            ask_bend(a, i, true);
    }
    return BATTEN_OK;
}

/* ---- at the data ---- */

static void ask_datum(asking *a, bat_condition_for what, int i, int c, double right, bool most)
{
    bat_condition_row *row = next_row(a, what, i);
    const bat_rows_of_fit *data = &a->fit->data;
    row->first = data->first[i];
    row->length = data->width;
    memcpy(row->values, data->values + (size_t)i * (size_t)data->width,
           (size_t)data->width * sizeof *row->values);
    row->normal[c] = 1;
    row->right = right;
    row->least = true;
    if (most)
        turn_around(row);
}

static batten_status ask_side_and_band(asking *a)
{
    const batten_curve_least_squares_options *o = a->options;
    const bat_fit *fit = a->fit;
    if ((int)o->side < 0 || o->side > BATTEN_FIT_UNDER ||
        (o->side != BATTEN_FIT_BOTH && fit->dimension > 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "side %d of a %s", (int)o->side,
                        fit->dimension > 1 ? "curve" : "function");
    for (int i = 0; i < fit->data_count; i++) {
        const double *q = fit->points + (size_t)i * (size_t)fit->dimension;
        if (!(fit->factors[i] > 0))
            continue;
        if (o->side != BATTEN_FIT_BOTH)
            ask_datum(a, BAT_FOR_SIDE, i, 0, q[0], o->side == BATTEN_FIT_UNDER);
        for (int c = 0; o->band > 0 && c < fit->dimension; c++) {
            ask_datum(a, BAT_FOR_BAND, i, c, q[c] - o->band, false);
            ask_datum(a, BAT_FOR_BAND, i, c, q[c] + o->band, true);
        }
    }
    return BATTEN_OK;
}

batten_status bat_fit_conditions(const bat_fit *fit,
                                 const batten_curve_least_squares_options *o,
                                 bat_condition_rows *out)
{
    const size_t d = (size_t)fit->dimension;
    if (o->condition_count < 0 || o->condition_count > BAT_MAX_CONDITIONS)
        return bat_fail(BATTEN_TOO_LARGE, "%d conditions; the limit is %d", o->condition_count,
                        BAT_MAX_CONDITIONS);
    const size_t at_data = (o->side != BATTEN_FIT_BOTH) + (o->band > 0 ? 2 * d : 0);
    const size_t most = 2 * d + (size_t)o->condition_count * d + 4 * (size_t)fit->count +
                        (size_t)fit->data_count * at_data;
    double *U = NULL;
    asking a = {.fit = fit, .options = o};
    a.rows.rows = bat_array(most, sizeof *a.rows.rows);
    batten_status status = a.rows.rows ? bat_fit_all_knots(fit, &U) : BATTEN_OUT_OF_MEMORY;
    a.U = U;
    if (status == BATTEN_OK)
        ask_ends(&a);
    for (int i = 0; status == BATTEN_OK && i < o->condition_count; i++)
        status = ask_condition(&a, i);
    if (status == BATTEN_OK)
        status = ask_shape(&a);
    if (status == BATTEN_OK)
        status = ask_side_and_band(&a);
    bat_release(U);
    if (status == BATTEN_OK)
        *out = a.rows;
    else
        bat_condition_rows_free(&a.rows);
    return status;
}
