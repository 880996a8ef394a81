/*
 * One control point after another is put where the integral of |C^(r)|^2 is least, r = 3 or the degree if that is less: the one
 * by which the integral falls most. With the matrix G of the integral that place is D_i - (G D)_i / G_ii.
 * Source: [EH95].
 */
#include "fair/fair_curve.h"
#include "numeric/quadrature.h"

#include <string.h>

typedef struct {
    const bat_fair_net *net;
    int order;              /* r */
    int span_count, *first; /* of each span that is not empty: its first control point */
    double *matrix;         /* [span_count][degree + 1][degree + 1] */
    double *diagonal;       /* [count] */
    double *gradient;       /* G z [count][dimension] */
} coefficients;

/* The integral over one span: Gauss's rule is exact for the degree 2 (p - r). */
static void add_span(coefficients *c, int span)
{
    const int p = c->net->degree, nodes = p - c->order + 1;
    const double *knots = c->net->curve->knots;
    const double a = knots[span], half = (knots[span + 1] - a) / 2;
    double x[BATTEN_MAX_DEGREE + 1], weight[BATTEN_MAX_DEGREE + 1];
    double basis[4 * (BATTEN_MAX_DEGREE + 1)];
    double *matrix = c->matrix + (size_t)c->span_count * (size_t)((p + 1) * (p + 1));
    memset(matrix, 0, (size_t)((p + 1) * (p + 1)) * sizeof *matrix);
    bat_gauss(nodes, x, weight);
    for (int k = 0; k < nodes; k++) {
        bat_basis(p, knots, span, a + half * (1 + x[k]), c->order, basis);
        const double *row = basis + c->order * (p + 1);
        for (int i = 0; i <= p; i++)
            for (int j = 0; j <= p; j++)
                matrix[i * (p + 1) + j] += half * weight[k] * row[i] * row[j];
    }
    c->first[c->span_count++] = span - p;
    for (int i = 0; i <= p; i++)
        c->diagonal[bat_fair_net_index(c->net, span - p + i)] += matrix[i * (p + 2)];
}

static double find_gradient(coefficients *c, const double *z)
{
    const int p = c->net->degree, d = c->net->dimension;
    memset(c->gradient, 0, (size_t)(c->net->count * d) * sizeof *c->gradient);
    for (int s = 0; s < c->span_count; s++) {
        const double *matrix = c->matrix + (size_t)s * (size_t)((p + 1) * (p + 1));
        for (int i = 0; i <= p; i++) {
            double *out = c->gradient + bat_fair_net_index(c->net, c->first[s] + i) * d;
            for (int j = 0; j <= p; j++) {
                const double *from = z + bat_fair_net_index(c->net, c->first[s] + j) * d;
                for (int k = 0; k < d; k++)
                    out[k] += matrix[i * (p + 1) + j] * from[k];
            }
        }
    }
    return bat_dot(c->net->count * d, z, c->gradient);
}

static double integral(void *state, const double *z, double *unfairness)
{
    coefficients *c = state;
    const int d = c->net->dimension;
    const double sum = find_gradient(c, z);
    for (int i = 0; i < c->net->count; i++) {
        const double *g = c->gradient + i * d;
        unfairness[i] = c->diagonal[i] > 0 ? bat_dot(d, g, g) / c->diagonal[i] : 0;
    }
    return sum;
}

static void put_at_least(void *state, const double *z, int i, double *to)
{
    coefficients *c = state;
    const int d = c->net->dimension;
    find_gradient(c, z);
    for (int k = 0; k < d; k++)
        to[k] -= c->gradient[i * d + k] / c->diagonal[i];
}

batten_status bat_fair_by_coefficients(const bat_fair_net *net, double *z)
{
    const batten_curve *curve = net->curve;
    const int p = net->degree, spans = curve->count - p;
    coefficients c = {.net = net, .order = bat_min_int(p, 3)};
    c.first = bat_array((size_t)spans, sizeof *c.first);
    c.matrix = bat_array3((size_t)spans, (size_t)((p + 1) * (p + 1)), sizeof *c.matrix);
    c.diagonal = bat_array3((size_t)net->count, (size_t)net->dimension + 1, sizeof *c.diagonal);
    batten_status status = c.first && c.matrix && c.diagonal ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memset(c.diagonal, 0, (size_t)net->count * sizeof *c.diagonal);
        c.gradient = c.diagonal + net->count;
        for (int span = p; span < curve->count; span++)
            if (curve->knots[span] < curve->knots[span + 1])
                add_span(&c, span);
        const bat_one_by_one method = {.state = &c,
                                       .measure = integral,
                                       .propose = put_at_least,
                                       .is_done = NULL,
                                       .count = net->count,
                                       .ducks = &net->ducks,
                                       .most = net->options->max_moves,
                                       .job = net->job};
        status = bat_move_one_by_one(&method, z);
    }
    bat_release(c.first);
    bat_release(c.matrix);
    bat_release(c.diagonal);
    return status;
}
