/*
 * How a curve bends at a parameter, and its energies: integrals whose peaks stand at known
 * places, so that no sharp bend falls between the nodes of the quadrature.
 */
#include "fair/bend.h"

#include "inspect/singular.h"
#include "numeric/quadrature.h"

/* ---- one parameter ---- */

/* To 0 what is not larger than `noise`. */
static double above_noise(double value, double noise)
{
    return fabs(value) > noise ? value : 0;
}

static batten_status bend_of_function(const batten_curve *curve, double size, double u,
                                      batten_side side, bat_curve_bend *out)
{
    double values[4];
    const batten_status status = batten_curve_evaluate_side(curve, u, side, 3, values);
    const double h = bat_span_width(curve, u, side);
    if (status == BATTEN_OK)
        *out = (bat_curve_bend){
            above_noise(values[2], bat_derivative_roundoff(curve, 2, size, h)),
            above_noise(values[3], bat_derivative_roundoff(curve, 3, size, h)), 1};
    return status;
}

/* The rate has a part from the third derivative, and one from the second, k times the change of
 * the speed: 3 k C'.C'' / v^3. */
batten_status bat_curve_bend_at(const batten_curve *curve, double size, double u,
                                batten_side side, bat_curve_bend *out)
{
    if (batten_curve_dimension(curve) == 1)
        return bend_of_function(curve, size, u, side, out);
    batten_curve_local at;
    const batten_status status = bat_curve_local_at(curve, size, u, side, &at);
    if (status == BATTEN_SINGULAR_HERE) {
        *out = (bat_curve_bend){0};
        return BATTEN_OK;
    }
    if (status != BATTEN_OK)
        return status;
    const double h = bat_span_width(curve, u, side), v = at.speed;
    const double second = bat_derivative_roundoff(curve, 2, size, h) / (v * v);
    const double third = bat_derivative_roundoff(curve, 3, size, h) / (v * v * v);
    *out = (bat_curve_bend){above_noise(at.curvature, second),
                            above_noise(at.curvature_rate, third), v};
    return BATTEN_OK;
}

/* ---- integrals ---- */

/* What is integrated along a curve: the square of its curvature, or of the rate of that. */
typedef struct {
    const batten_curve *curve;
    double size;
    bool rate;
} bent;

static batten_status square_density(void *context, double u, double *value)
{
    const bent *b = context;
    bat_curve_bend at = {0};
    const batten_status status =
        bat_curve_bend_at(b->curve, b->size, u, BATTEN_FROM_RIGHT, &at);
    const double bend = b->rate ? at.rate : at.curvature;
    *value = bend * bend * at.speed;
    return status;
}

/* One part in 1e9 is more than anyone reads; a bend as sharp as 1e-9 of its interval takes some
 * forty halvings to each side. */
#define PART 1e-9
enum { LIMIT = 4000 };

/* What is not finite anywhere is infinite as a whole. */
static batten_status integrate(bent *b, const batten_parameters *breaks, double *value,
                               double *error, bat_integral_breaks *fine)
{
    const bat_peaked_integral integral = {square_density, b,    breaks->count,
                                          breaks->at,     PART, LIMIT};
    const batten_status status = bat_integrate_peaked(&integral, value, error, fine);
    if (status == BATTEN_NOT_FINITE)
        *value = *error = HUGE_VAL;
    return status == BATTEN_TOLERANCE_NOT_MET || status == BATTEN_NOT_FINITE ? BATTEN_OK
                                                                             : status;
}

/* The rate is largest beside the peaks of curvature, about as far from them as these are wide:
 * where the energy wanted short intervals. */
batten_status bat_curve_energies(const batten_curve *curve, const batten_parameters *breaks,
                                 bat_energies *out)
{
    bent b = {curve, bat_curve_size(curve), false};
    bat_energies found = {0};
    bat_integral_breaks fine = {0};
    batten_status status = integrate(&b, breaks, &found.energy, &found.energy_error, &fine);
    const batten_parameters then =
        fine.count > 0 ? (batten_parameters){fine.count, fine.at} : *breaks;
    b.rate = true;
    if (status == BATTEN_OK)
        status = integrate(&b, &then, &found.variation, &found.variation_error, NULL);
    bat_release(fine.at);
    if (status == BATTEN_OK)
        *out = found;
    return status;
}
