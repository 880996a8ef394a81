/*
 * Setting up the interpolation system: which conditions it has, the knots that go with them,
 * and the factored collocation matrix, banded or cyclic.
 */
#include "shape/linear/linear_system.h"
#include "base/plural.h"
#include "numeric/banded.h"
#include "numeric/vector.h"
#include "shape/linear/linear_matrix.h"
#include "spline/curve/curve.h"

/* ---- which rows the equations have ---- */

static int end_order(batten_end_kind kind)
{
    switch (kind) {
    case BATTEN_END_NOT_A_KNOT:
        return 0;
    case BATTEN_END_NATURAL:
    case BATTEN_END_SECOND:
        return 2;
    case BATTEN_END_PARABOLIC:
        return 3;
    default:
        return 1;
    }
}

static int end_source(batten_end_kind kind, bool at_start)
{
    switch (kind) {
    case BATTEN_END_NATURAL:
    case BATTEN_END_PARABOLIC:
        return BAT_FROM_ZERO;
    case BATTEN_END_BESSEL:
    case BATTEN_END_FAIR:
        return at_start ? BAT_FROM_BESSEL_START : BAT_FROM_BESSEL_END;
    default:
        return at_start ? BAT_FROM_START : BAT_FROM_END;
    }
}

/* Is the end made from the data alone? Then two points leave nothing to make it from. */
static bool is_free(batten_end_kind kind)
{
    return kind != BATTEN_END_CLAMPED && kind != BATTEN_END_SECOND;
}

/* The request as it is carried out: the ends that count. */
static bat_request effective(const bat_request *request)
{
    bat_request r = *request;
    if (r.periodic || !r.knots_at_data)
        r.start = r.end = BATTEN_END_NOT_A_KNOT;
    if (r.count == 2) {
        const bool line = is_free(r.start) && is_free(r.end);
        if (is_free(r.start) && (line || r.start != BATTEN_END_NATURAL))
            r.start = BATTEN_END_NOT_A_KNOT;
        if (is_free(r.end) && (line || r.end != BATTEN_END_NATURAL))
            r.end = BATTEN_END_NOT_A_KNOT;
    }
    return r;
}

/* Conditions at an end, the end's own one included. */
static int conditions_at(const bat_request *r, int index, batten_end_kind kind)
{
    int count = end_order(kind) > 0;
    for (int i = 0; i < r->condition_count; i++)
        count += r->conditions[i].index == index;
    return count;
}

static batten_status check_degree(const bat_request *r)
{
    if (r->degree < 1 || r->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d, not 1 to %d", r->degree,
                        BATTEN_MAX_DEGREE);
    if (!r->periodic && r->knots_at_data && r->degree % 2 == 0)
        return bat_fail(
            BATTEN_BAD_DEGREE,
            "knots at the data need an odd degree, and it is %d; averaged knots take any",
            r->degree);
    if (r->degree != 3 && (r->start == BATTEN_END_FAIR || r->end == BATTEN_END_FAIR ||
                           r->start == BATTEN_END_PARABOLIC || r->end == BATTEN_END_PARABOLIC))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "fair and parabolic ends are cubic, and the degree is %d", r->degree);
    return BATTEN_OK;
}

static batten_status check_condition(const bat_request *r, int i)
{
    const batten_derivative *c = &r->conditions[i];
    if (c->index < 0 || c->index >= r->count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "derivative %d is at point %d of %d", i + 1,
                        c->index + 1, r->count);
    if (c->order < 1 || c->order > r->degree)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "derivative %d has the order %d, and the degree is %d", i + 1, c->order,
                        r->degree);
    if (r->knots_at_data && c->index > 0 && c->index < r->count - 1)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "derivative %d is at point %d: with knots at the data only ends take them", i + 1,
            c->index + 1);
    return BATTEN_OK;
}

static batten_status check_request(const bat_request *r)
{
    batten_status status = check_degree(r);
    if (status == BATTEN_OK && r->periodic && r->condition_count > 0)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "a periodic curve takes no derivatives, and %d are given",
                          r->condition_count);
    for (int i = 0; status == BATTEN_OK && i < r->condition_count; i++)
        status = check_condition(r, i);
    for (int side = 0; status == BATTEN_OK && r->knots_at_data && !r->periodic && side < 2;
         side++) {
        const int given = conditions_at(r, side ? r->count - 1 : 0, side ? r->end : r->start);
        if (given > (r->degree - 1) / 2)
            status = bat_fail(BATTEN_BAD_ARGUMENT,
                              "the %s has %d condition%s, and degree %d takes %d",
                              side ? "end" : "start", given, bat_plural(given), r->degree,
                              (r->degree - 1) / 2);
    }
    return status;
}

/* Put a row in its place among those of its data point: by increasing order, at the last point
 * by decreasing order, so that no pivot is lost. */
static batten_status place_row(bat_operator *op, int *first, int *used, bat_row row)
{
    bat_row *rows = op->rows + first[row.index];
    const int direction = row.index == op->data_count - 1 ? -1 : 1;
    int i = used[row.index]++;
    for (; i > 0 && direction * rows[i - 1].order > direction * row.order; i--)
        rows[i] = rows[i - 1];
    rows[i] = row;
    if (i > 0 && rows[i - 1].order == row.order)
        return bat_fail(BATTEN_BAD_ARGUMENT, "derivative %d at point %d is given twice",
                        row.order, row.index + 1);
    return BATTEN_OK;
}

static batten_status fill_rows(const bat_request *r, bat_operator *op, int *first, int *used)
{
    const int last = r->count - 1;
    const bool start = end_order(r->start) > 0, end = end_order(r->end) > 0;
    for (int i = 0; i < r->condition_count; i++)
        first[r->conditions[i].index + 1]++;
    first[1] += start;
    first[last + 1] += end;
    for (int i = 0; i < r->count; i++)
        first[i + 1] += first[i] + 1;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < r->count && status == BATTEN_OK; i++)
        status = place_row(op, first, used, (bat_row){i, 0, BAT_FROM_DATA});
    for (int i = 0; i < r->condition_count && status == BATTEN_OK; i++)
        status = place_row(op, first, used,
                           (bat_row){r->conditions[i].index, r->conditions[i].order, i});
    if (status == BATTEN_OK && start)
        status = place_row(op, first, used,
                           (bat_row){0, end_order(r->start), end_source(r->start, true)});
    if (status == BATTEN_OK && end)
        status = place_row(op, first, used,
                           (bat_row){last, end_order(r->end), end_source(r->end, false)});
    return status;
}

static batten_status make_rows(const bat_request *r, bat_operator *op)
{
    int *first = bat_array((size_t)r->count + 1, sizeof *first);
    int *used = bat_array((size_t)r->count, sizeof *used);
    op->rows = bat_array((size_t)op->count, sizeof *op->rows);
    const batten_status status =
        first && used && op->rows ? fill_rows(r, op, first, used) : BATTEN_OUT_OF_MEMORY;
    bat_release(used);
    bat_release(first);
    return status;
}

/* ---- knots ---- */

/* Of odd degree they stand at the parameters, of even degree midway: data at the knots would
 * leave the equations singular. */
static void periodic_knots(const bat_request *r, double *knots)
{
    const double *t = r->parameters;
    const int m = r->count;
    for (int j = 0; j <= m; j++)
        knots[j] = t[j];
    if (r->degree % 2 == 1)
        return;
    for (int j = m; j > 0; j--)
        knots[j] = t[j - 1] + (t[j] - t[j - 1]) / 2;
    knots[0] = t[0] - (t[m] - t[m - 1]) / 2;
}

/* The average of the parameters of the p rows before control value j + p. */
static double averaged_knot(const bat_request *r, const bat_operator *op, int j)
{
    double sum = 0;
    for (int i = j; i < j + op->degree; i++)
        sum += r->parameters[op->rows[i].index];
    return sum / op->degree;
}

static void clamped_knots(const bat_request *r, const bat_operator *op)
{
    const int p = op->degree, n = op->count, inner = n - p - 1;
    double *U = op->knots;
    for (int i = 0; i <= p; i++) {
        U[i] = r->parameters[0];
        U[n + i] = r->parameters[r->count - 1];
    }
    /* An end with fewer conditions than (p - 1) / 2 does without the knots next to it. */
    const int dropped = (p - 1) / 2 - conditions_at(r, 0, r->start);
    for (int j = 1; j <= inner; j++)
        U[p + j] = r->knots_at_data ? r->parameters[j + dropped] : averaged_knot(r, op, j);
}

static batten_status make_knots(const bat_request *r, bat_operator *op)
{
    const size_t knot_count = (size_t)op->count + (op->periodic ? 1 : (size_t)op->degree + 1);
    op->knots = bat_array(knot_count, sizeof *op->knots);
    if (!op->knots)
        return BATTEN_OUT_OF_MEMORY;
    if (op->periodic)
        periodic_knots(r, op->knots);
    else
        clamped_knots(r, op);
    return BATTEN_OK;
}

/* ---- fair ends ---- */

/* The jumps of the third derivatives of the five basis functions about knot s. */
static void jumps_at(const double *U, int s, double g[5])
{
    double before[16], after[16];
    bat_basis(3, U, s - 1, U[s], 3, before);
    bat_basis(3, U, s, U[s], 3, after);
    for (int j = 0; j < 4; j++) {
        g[j] -= before[12 + j];
        g[j + 1] += after[12 + j];
    }
}

/* gradient = G^T G response, where row i of G gives the jump of the third derivative at inner
 * knot i of a cubic, from five control values. */
static void jump_gradient(const bat_operator *op, const double *response, double *gradient)
{
    for (int s = 4; s < op->count; s++) {
        double g[5] = {0};
        jumps_at(op->knots, s, g);
        const double jump = bat_dot(5, g, response + s - 4);
        for (int j = 0; j < 5; j++)
            gradient[s - 4 + j] += jump * g[j];
    }
}

static batten_status make_fair(bat_operator *op)
{
    const size_t n = (size_t)op->count;
    op->response = bat_array3((size_t)op->fair_count, n, sizeof *op->response);
    op->gradient = bat_array3((size_t)op->fair_count, n, sizeof *op->gradient);
    if (!op->response || !op->gradient)
        return BATTEN_OUT_OF_MEMORY;
    for (int e = 0; e < op->fair_count; e++) {
        double *response = op->response + (size_t)e * n;
        response[op->fair_row[e]] = 1;
        bat_banded_solve(op->count, op->lower, op->upper, op->factor, 1, response);
        jump_gradient(op, response, op->gradient + (size_t)e * n);
    }
    for (int e = 0; e < op->fair_count; e++)
        for (int f = 0; f < op->fair_count; f++)
            op->gram[e][f] =
                bat_dot(op->count, op->gradient + (size_t)e * n, op->response + (size_t)f * n);
    return BATTEN_OK;
}

/* The rows of the ends that are fair. With fewer jumps than such ends Bessel's slopes, which
 * these rows begin with, stay: then the parabola through three points has no jump. */
static void find_fair(const bat_request *r, bat_operator *op)
{
    for (int i = 0; i < op->count; i++)
        if ((op->rows[i].source == BAT_FROM_BESSEL_START && r->start == BATTEN_END_FAIR) ||
            (op->rows[i].source == BAT_FROM_BESSEL_END && r->end == BATTEN_END_FAIR))
            op->fair_row[op->fair_count++] = i;
    if (op->count - op->degree - 1 < op->fair_count)
        op->fair_count = 0;
}

/* ---- making ---- */

static batten_status factor_operator(const bat_request *r, bat_operator *op)
{
    const double *t = r->parameters;
    const int n = r->count;
    op->data_count = n;
    op->periodic = r->periodic;
    op->count = n + r->condition_count + (end_order(r->start) > 0) + (end_order(r->end) > 0);
    op->degree = op->periodic ? r->degree : bat_min_int(r->degree, op->count - 1);
    op->step[0] = t[1] - t[0];
    op->step[1] = n > 2 ? t[2] - t[1] : op->step[0];
    op->step[3] = n > 1 ? t[n - 1] - t[n - 2] : op->step[0]; /* one periodic datum */
    op->step[2] = n > 2 ? t[n - 2] - t[n - 3] : op->step[3];
    batten_status status = make_rows(r, op);
    if (status == BATTEN_OK)
        status = make_knots(r, op);
    if (status == BATTEN_OK)
        status = bat_linear_matrix_make(r, op);
    if (status == BATTEN_OK)
        find_fair(r, op);
    if (status == BATTEN_OK && op->fair_count > 0)
        status = make_fair(op);
    return status;
}

batten_status bat_operator_make(const bat_request *request, bat_operator *out)
{
    const bat_request r = effective(request);
    batten_status status = check_request(&r);
    if (status != BATTEN_OK)
        return status;
    bat_operator op = {0};
    status = factor_operator(&r, &op);
    if (status == BATTEN_OK)
        *out = op;
    else
        bat_operator_free(&op);
    return status;
}

void bat_operator_free(bat_operator *op)
{
    bat_release(op->knots);
    bat_release(op->rows);
    bat_release(op->matrix);
    bat_release(op->factor);
    bat_cyclic_free(op->cyclic);
    bat_release(op->response);
    bat_release(op->gradient);
    *op = (bat_operator){0};
}
