/* Cardinal functions of a network: 1 at the parameter of one node and 0 at the others. */
#include "shape/linear/linear_solve.h"
#include "shape/network/gordon.h"

#include <string.h>

static bat_request blend_request(const bat_network *net, int family, bool periodic)
{
    bat_request r = {.degree = 3,
                     .count = net->family[1 - family].count - periodic,
                     .parameters = net->family[family].parameters,
                     .knots_at_data = true,
                     .periodic = periodic};
    if (net->options->blend == BATTEN_GORDON_LINEAR)
        r.degree = 1;
    else if (net->options->blend == BATTEN_GORDON_LAGRANGE) {
        r.degree = r.count - 1;
        r.knots_at_data = false;
    }
    return r;
}

/* One period becomes clamped over [0, 1]. */
static batten_status clamp_ends(const bat_operator *op, const double *control, size_t width,
                                bat_spline *out)
{
    bat_spline wrapped;
    const int m = op->count, p = op->degree;
    batten_status status = bat_spline_make(p, m + p, width, &wrapped);
    if (status != BATTEN_OK)
        return status;
    bat_knots_wrap(p, m, op->knots, wrapped.knots);
    for (int i = 0; i < m + p; i++)
        memcpy(wrapped.values + (size_t)i * width, control + (size_t)(i % m) * width,
               width * sizeof *control);
    status = bat_spline_subrange(&wrapped, 0, 1, out);
    bat_spline_free(&wrapped);
    return status;
}

static batten_status from_operator(const bat_operator *op, const double *control, size_t width,
                                   bat_spline *out)
{
    if (op->periodic)
        return clamp_ends(op, control, width, out);
    const batten_status status = bat_spline_make(op->degree, op->count, width, out);
    if (status == BATTEN_OK) {
        memcpy(out->knots, op->knots,
               (size_t)(op->count + op->degree + 1) * sizeof *out->knots);
        memcpy(out->values, control, (size_t)op->count * width * sizeof *control);
    }
    return status;
}

batten_status bat_network_make_cardinal(const bat_network *net, int family, bool periodic,
                                        bat_spline *out)
{
    const bat_request r = blend_request(net, family, periodic);
    const size_t m = (size_t)r.count;
    bat_operator op;
    if (net->options->blend == BATTEN_GORDON_LAGRANGE && r.count > 12)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "polynomials through %d curves swing; 12 are the limit", r.count);
    batten_status status = bat_operator_make(&r, &op);
    if (status != BATTEN_OK)
        return status;
    double *unit = bat_array3(m, m, sizeof *unit);
    double *control = bat_array3((size_t)op.count, m, sizeof *control);
    status = unit && control ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < m; i++)
        unit[i * m + i] = 1;
    if (status == BATTEN_OK)
        status = bat_operator_apply(&op, &(bat_spline_data){.width = m, .data = unit}, control);
    if (status == BATTEN_OK)
        status = from_operator(&op, control, m, out);
    bat_release(control);
    bat_release(unit);
    bat_operator_free(&op);
    return status;
}
