/*
 * What the energy of a curve is, by adaptive quadrature: what a search of least energy lowers
 * are sums over fixed nodes, between which a cusp may hide.
 */
#include "inspect/inflections.h"
#include "numeric/quadrature.h"
#include "shape/bent/energy.h"
#include <batten/measure.h>

#include <string.h>

/* A curve, and the densities of its energy and length. */
typedef struct {
    const batten_chain *chain;
    const batten_curve *curve;
    int d;
    bat_energy_weights weights;
} measured;

static batten_status density_at(void *context, double u, double *value)
{
    const measured *m = context;
    double c[4 * 3];
    bat_energy_density at;
    const batten_status status = m->chain ? batten_chain_evaluate(m->chain, u, 3, c)
                                          : batten_curve_evaluate(m->curve, u, 3, c);
    if (status != BATTEN_OK)
        return status;
    bat_energy_density_at(&m->weights, m->d, c + m->d, false, &at);
    *value = at.energy;
    return BATTEN_OK;
}

/* Between the knots and, of a curve, the extrema of its curvature. */
static batten_status find_breaks(const measured *m, batten_parameters *out)
{
    const int count =
        m->chain ? batten_chain_span_count(m->chain) + 1 : batten_curve_spans(m->curve, NULL);
    batten_parameters knots = {count, bat_array((size_t)count, sizeof(double))}, extrema = {0};
    if (!knots.at)
        return BATTEN_OUT_OF_MEMORY;
    if (m->chain) {
        memcpy(knots.at, batten_chain_breaks(m->chain), (size_t)count * sizeof *knots.at);
        *out = knots;
        return BATTEN_OK;
    }
    batten_curve_spans(m->curve, knots.at);
    batten_status status = batten_curve_curvature_extrema(m->curve, &extrema);
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&knots, &extrema, batten_curve_domain(m->curve), out);
    bat_release(knots.at);
    batten_release(extrema.at);
    return status;
}

/* A tension is a force. */
double bat_energy_tension_unit(const bat_energy_spline *t)
{
    const double square = t->unit * t->unit;
    return t->options->energy == BATTEN_ENERGY_BENDING ? square : square * square;
}

double bat_energy_tension(const bat_energy_spline *t)
{
    return t->options->tension * bat_energy_tension_unit(t);
}

/* A part in 1e6: far below what makes one curve better than another. */
static const double part = 1e-6;
enum { LIMIT = 2000 };

/* The integral of the density; HUGE_VAL where it is not known. Of an arc or a line nothing is
 * known to a part of it: there `nothing` is. */
static batten_status integrate_density(measured *m, double nothing, double *out)
{
    batten_parameters breaks = {0};
    double error = 0;
    batten_status status = find_breaks(m, &breaks);
    if (status != BATTEN_OK)
        return status;
    const bat_peaked_integral integral = {density_at, m, breaks.count, breaks.at, part, LIMIT};
    status = bat_integrate_peaked(&integral, out, &error, NULL);
    batten_release(breaks.at);
    const bool is_known = status == BATTEN_OK || (status == BATTEN_TOLERANCE_NOT_MET &&
                                                  error <= 100 * part * *out + nothing);
    if (!is_known && (status == BATTEN_TOLERANCE_NOT_MET || status == BATTEN_NOT_FINITE))
        *out = HUGE_VAL;
    return status == BATTEN_OUT_OF_MEMORY ? status : BATTEN_OK;
}

batten_status bat_energy_measure(const bat_energy_spline *t, const batten_chain *chain,
                                 const batten_curve *curve, double unit, double *out)
{
    const batten_curve_minimum_energy_options *o = t->options;
    const bool bending = o->energy == BATTEN_ENERGY_BENDING;
    /* Energies are by the unit or its cube. */
    const double units = bending ? unit : unit * unit * unit;
    measured m = {chain, curve, t->d, {o->energy, 1, 0}};
    double energy = HUGE_VAL, length = 0;
    batten_status status = integrate_density(&m, BAT_ENERGY_NOTHING / units, &energy);
    if (status == BATTEN_OK)
        status = chain ? batten_chain_length(chain, NULL, &length)
                       : batten_curve_length(curve, part * unit * t->count, NULL, &length);
    if (status != BATTEN_OK)
        return status;
    const double lengths = bending ? length : length * length * length;
    *out = o->scale_invariant ? energy * lengths
                              : energy * units + bat_energy_tension(t) * length / unit;
    return BATTEN_OK;
}
