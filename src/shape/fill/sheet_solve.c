/*
 * The z of a sheet: the integral of the squares of the second derivatives, and a hundredth of
 * those of the third, becomes least among the splines that meet the conditions best.
 *
 * Conditions are met by the method of multipliers: each counts as a square that outweighs
 * the energy, and what it is missed by is added to what is asked the next time. That ends
 * as soon as all are missed by less than is allowed.
 */
#include "numeric/banded.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/fill/sheet.h"
#include "spline/spline.h"
#include <string.h>

enum { DEGREE = 5, LOCAL = DEGREE + 1, SQUARE = LOCAL * LOCAL, ORDERS = 4 };

/* One direction. */
typedef struct {
    int spans, count;
    double low, step;
    double *knots; /* [count + DEGREE + 1] */
    double *gram;  /* [spans][ORDERS][LOCAL][LOCAL]: integrals of products of derivatives */
} sheet_axis;

typedef struct {
    const bat_sheet_outline *outline;
    const bat_sheet_conditions *conditions;
    sheet_axis axes[2];
    int count, band;
    double *matrix; /* [count][band + 1] */
    double *rows;   /* [conditions][SQUARE]: what the points around give */
    int *first;     /* [conditions]: the first of them */
    double *asked;  /* [conditions]: values, and what they were missed by */
    double *z;      /* [count] */
} sheet_system;

/* ---- the spline ---- */

static batten_status make_axis(double low, double high, int spans, sheet_axis *out)
{
    *out = (sheet_axis){spans, spans + DEGREE, low, (high - low) / spans, NULL, NULL};
    out->knots = bat_array((size_t)(out->count + LOCAL), sizeof(double));
    out->gram = bat_array((size_t)spans * ORDERS * SQUARE, sizeof(double));
    if (!out->knots || !out->gram)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < out->count + LOCAL; i++) {
        const int k = bat_max_int(0, bat_min_int(spans, i - DEGREE));
        out->knots[i] = k == spans ? high : low + k * out->step;
    }
    double nodes[LOCAL], weights[LOCAL], N[ORDERS][LOCAL];
    bat_gauss(LOCAL, nodes, weights);
    for (int s = 0; s < spans; s++)
        for (int g = 0; g < LOCAL; g++) {
            const double u = low + (s + (nodes[g] + 1) / 2) * out->step;
            bat_basis(DEGREE, out->knots, s + DEGREE, u, ORDERS - 1, N[0]);
            for (int d = 0; d < ORDERS; d++)
                for (int k = 0; k < SQUARE; k++)
                    out->gram[(s * ORDERS + d) * SQUARE + k] +=
                        weights[g] / 2 * out->step * N[d][k / LOCAL] * N[d][k % LOCAL];
        }
    return BATTEN_OK;
}

static int span_at(const sheet_axis *axis, double u)
{
    return bat_max_int(0, bat_min_int(axis->spans - 1, (int)((u - axis->low) / axis->step)));
}

/* ---- the energy ---- */

/* How much the second derivatives count beside the third, over a hole of size 1: less, and sides
 * that leave a quadric nearly free would be met by a balloon. */
static const double second_order = 100;

/* Beyond the outline the spline only has to continue. */
static const double outside = 1e-3;

static void add_cell(sheet_system *s, int su, int sv, double weight)
{
    const double *U = s->axes[0].gram + (size_t)su * ORDERS * SQUARE;
    const double *V = s->axes[1].gram + (size_t)sv * ORDERS * SQUARE;
    const int nv = s->axes[1].count;
    for (int a = 0; a < SQUARE; a++)
        for (int b = 0; b < SQUARE; b++) {
            const int row = (su + a / LOCAL) * nv + sv + b / LOCAL;
            const int column = (su + a % LOCAL) * nv + sv + b % LOCAL;
            if (column > row)
                continue;
            double u[ORDERS], v[ORDERS];
            for (int d = 0; d < ORDERS; d++) {
                u[d] = U[d * SQUARE + a];
                v[d] = V[d * SQUARE + b];
            }
            const double third = u[3] * v[0] + 3 * u[2] * v[1] + 3 * u[1] * v[2] + u[0] * v[3];
            const double second = u[2] * v[0] + 2 * u[1] * v[1] + u[0] * v[2];
            s->matrix[(size_t)row * (size_t)(s->band + 1) + (size_t)(column - row + s->band)] +=
                weight * (third + second_order * second);
        }
}

static void add_energy(sheet_system *s)
{
    const sheet_axis *u = &s->axes[0], *v = &s->axes[1];
    for (int i = 0; i < u->spans; i++)
        for (int j = 0; j < v->spans; j++) {
            const double middle[2] = {u->low + (i + 0.5) * u->step,
                                      v->low + (j + 0.5) * v->step};
            add_cell(s, i, j, bat_sheet_is_inside(s->outline, middle) ? 1 : outside);
        }
}

/* ---- the conditions ---- */

/* The derivative that a condition is about, as a row over the points around its place. */
static void make_row(sheet_system *s, int k)
{
    const bat_sheet_condition *c = &s->conditions->at[k];
    double N[2][3][LOCAL], *row = s->rows + (size_t)k * SQUARE;
    int spans[2];
    for (int d = 0; d < 2; d++) {
        spans[d] = span_at(&s->axes[d], c->at[d]);
        bat_basis(DEGREE, s->axes[d].knots, spans[d] + DEGREE, c->at[d], 2, N[d][0]);
    }
    s->first[k] = spans[0] * s->axes[1].count + spans[1];
    const double x = c->along[0], y = c->along[1];
    for (int a = 0; a < LOCAL; a++)
        for (int b = 0; b < LOCAL; b++) {
            double(*U)[LOCAL] = N[0], (*V)[LOCAL] = N[1];
            const double values[3] = {
                U[0][a] * V[0][b], x * U[1][a] * V[0][b] + y * U[0][a] * V[1][b],
                x * x * U[2][a] * V[0][b] + 2 * x * y * U[1][a] * V[1][b] +
                    y * y * U[0][a] * V[2][b]};
            row[a * LOCAL + b] = values[c->order];
        }
}

static int point_of(const sheet_system *s, int k, int local)
{
    return s->first[k] + local / LOCAL * s->axes[1].count + local % LOCAL;
}

static void add_condition(sheet_system *s, int k, double weight)
{
    const double *row = s->rows + (size_t)k * SQUARE;
    for (int a = 0; a < SQUARE; a++)
        for (int b = 0; b <= a; b++) {
            const int i = point_of(s, k, a), j = point_of(s, k, b);
            s->matrix[(size_t)i * (size_t)(s->band + 1) + (size_t)(j - i + s->band)] +=
                weight * row[a] * row[b];
        }
}

/* ---- multipliers ---- */

/* How much more a condition weighs than the stiffest of the energy: so little that the sheet
 * comes to its sides round by round, and stops before it bends for what is not asked. */
static const double stiffness = 100;

/* By how much the conditions are missed, the root of the mean of the weighed squares; `over`: and
 * the most against what is allowed. The misses are added to what is asked. */
static double carry_misses(sheet_system *s, double *over)
{
    double sum = 0, weights = 0;
    *over = 0;
    for (int k = 0; k < s->conditions->count; k++) {
        const bat_sheet_condition *c = &s->conditions->at[k];
        double missed = c->value;
        for (int a = 0; a < SQUARE; a++)
            missed -= s->rows[(size_t)k * SQUARE + (size_t)a] * s->z[point_of(s, k, a)];
        s->asked[k] += missed;
        *over = bat_max(*over, fabs(missed) / c->allowed);
        sum += c->weight * missed * missed;
        weights += c->weight;
    }
    return sqrt(sum / weights);
}

static batten_status meet_conditions(sheet_system *s, double weight)
{
    enum { ROUNDS = 40 };
    const int count = s->conditions->count;
    double last = HUGE_VAL;
    const batten_status status = bat_symmetric_factor(s->count, s->band, s->matrix);
    for (int k = 0; k < count; k++)
        s->asked[k] = s->conditions->at[k].value;
    for (int round = 0; status == BATTEN_OK && round < ROUNDS; round++) {
        memset(s->z, 0, (size_t)s->count * sizeof *s->z);
        for (int k = 0; k < count; k++)
            for (int a = 0; a < SQUARE; a++)
                s->z[point_of(s, k, a)] += weight * s->conditions->at[k].weight * s->asked[k] *
                                           s->rows[(size_t)k * SQUARE + (size_t)a];
        bat_symmetric_solve(s->count, s->band, s->matrix, 1, s->z);
        double over;
        const double missed = carry_misses(s, &over);
        /* To ask for more than is needed would bend the sheet for nothing. What falls by less than
         * a twentieth a round is what the spline cannot do. */
        if (over <= 1 || (round > 4 && !(missed < 0.95 * last)))
            break;
        last = missed;
    }
    return status;
}

/* ---- all ---- */

static batten_status begin_system(sheet_system *s, int spans)
{
    const bat_sheet_outline *o = s->outline;
    const size_t conditions = (size_t)s->conditions->count;
    const double extent[2] = {o->high[0] - o->low[0], o->high[1] - o->low[1]};
    const double longer = bat_max(extent[0], extent[1]);
    batten_status status = BATTEN_OK;
    for (int d = 0; status == BATTEN_OK && d < 2; d++)
        status = make_axis(o->low[d], o->high[d],
                           bat_max_int(2, (int)ceil(spans * extent[d] / longer)), &s->axes[d]);
    if (status != BATTEN_OK)
        return status;
    s->count = s->axes[0].count * s->axes[1].count;
    s->band = DEGREE * s->axes[1].count + DEGREE;
    s->matrix = bat_array3((size_t)s->count, (size_t)s->band + 1, sizeof *s->matrix);
    s->rows = bat_array3(conditions, SQUARE, sizeof *s->rows);
    s->first = bat_array(conditions, sizeof *s->first);
    s->asked = bat_array(conditions, sizeof *s->asked);
    s->z = bat_array((size_t)s->count, sizeof *s->z);
    return s->matrix && s->rows && s->first && s->asked && s->z ? BATTEN_OK
                                                                : BATTEN_OUT_OF_MEMORY;
}

static void end_system(sheet_system *s)
{
    for (int d = 0; d < 2; d++) {
        bat_release(s->axes[d].knots);
        bat_release(s->axes[d].gram);
    }
    bat_release(s->matrix);
    bat_release(s->rows);
    bat_release(s->first);
    bat_release(s->asked);
    bat_release(s->z);
}

static batten_status make_surface(const sheet_system *s, batten_surface **out)
{
    const sheet_axis *u = &s->axes[0], *v = &s->axes[1];
    const batten_axis axes[2] = {{DEGREE, u->count, u->knots, false},
                                 {DEGREE, v->count, v->knots, false}};
    double *net = bat_array3((size_t)u->count, (size_t)v->count, 3 * sizeof *net);
    if (!net)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < s->count; k++) {
        net[3 * k] = bat_greville(DEGREE, u->knots, k / v->count);
        net[3 * k + 1] = bat_greville(DEGREE, v->knots, k % v->count);
        net[3 * k + 2] = s->z[k];
    }
    const batten_status status = batten_surface_create(3, &axes[0], &axes[1], net, NULL, out);
    bat_release(net);
    return status;
}

batten_status bat_sheet_solve(const bat_sheet_outline *outline,
                              const bat_sheet_conditions *conditions, int spans,
                              batten_surface **out)
{
    sheet_system s = {.outline = outline, .conditions = conditions};
    batten_status status = begin_system(&s, spans);
    if (status == BATTEN_OK) {
        double weight = 0;
        add_energy(&s);
        for (int i = 0; i < s.count; i++) /* the stiffest of the energy */
            weight = bat_max(weight,
                             stiffness * s.matrix[(size_t)(i + 1) * (size_t)(s.band + 1) - 1]);
        for (int k = 0; k < conditions->count; k++) {
            make_row(&s, k);
            add_condition(&s, k, weight * conditions->at[k].weight);
        }
        status = meet_conditions(&s, weight);
    }
    if (status == BATTEN_OK)
        status = make_surface(&s, out);
    end_system(&s);
    return status;
}
