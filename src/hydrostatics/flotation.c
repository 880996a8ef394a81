/* The values of a hull in the water, from the integrals over its wet patches. */
#include "hydrostatics/wet.h"

#include <float.h>

/* Below the first, differences of sums are rounding; above the second, results mean little. */
static const double LEAST_PRECISION = 1e-14, MOST_PRECISION = 0.1;

batten_status bat_water_of(const batten_hull *hull, const batten_flotation *flotation,
                           bat_water *out)
{
    const double theta = flotation->trim, phi = flotation->heel;
    if (!isfinite(flotation->draught))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the draught is not finite");
    if (!(fabs(theta) < BAT_PI / 2) || !(fabs(phi) < BAT_PI))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a trim of %g and a heel of %g degrees; they must be below 90 and 180",
                        theta * 180 / BAT_PI, phi * 180 / BAT_PI);
    const double st = bat_sin(theta), ct = bat_cos(theta), sp = bat_sin(phi), cp = bat_cos(phi);
    *out = (bat_water){{st, ct * sp, ct * cp}, {ct, -st * sp, -st * cp}, {0, cp, -sp}, 0};
    out->d = out->n[2] * flotation->draught;
    for (int c = 0; c < 3; c++)
        out->d -= out->n[c] * hull->centre[c];
    out->d /= hull->size;
    return BATTEN_OK;
}

batten_status bat_check_precision(double precision)
{
    return precision >= LEAST_PRECISION && precision <= MOST_PRECISION
               ? BATTEN_OK
               : bat_fail(BATTEN_BAD_ARGUMENT, "the precision is %g; it must be %g to %g",
                          precision, LEAST_PRECISION, MOST_PRECISION);
}

static batten_vec3 place_of(const batten_hull *hull, const double p[3])
{
    return (batten_vec3){hull->centre[0] + hull->size * p[0],
                         hull->centre[1] + hull->size * p[1],
                         hull->centre[2] + hull->size * p[2]};
}

/* Area, centre and second moments about it. */
static void take_waterplane(const batten_hull *hull, const bat_water *water,
                            const double sums[BAT_SUMS], batten_hydrostatics *out)
{
    const double area = sums[BAT_PLANE], l2 = hull->size * hull->size;
    if (!(area > 0))
        return;
    const double along = sums[BAT_PLANE_ALONG] / area, across = sums[BAT_PLANE_ACROSS] / area;
    const double *squares = sums + BAT_PLANE_SQUARES;
    double at[3];
    for (int c = 0; c < 3; c++)
        at[c] = along * water->along[c] + across * water->across[c] + water->d * water->n[c];
    out->waterplane = area * l2;
    out->flotation = place_of(hull, at);
    out->along = (squares[0] - area * along * along) * l2 * l2;
    out->mixed = (squares[1] - area * along * across) * l2 * l2;
    out->across = (squares[2] - area * across * across) * l2 * l2;
}

void bat_take_values(const batten_hull *hull, const bat_water *water, const bat_wet *wet,
                     batten_hydrostatics *out)
{
    const double *sums = wet->sums, l = hull->size;
    double at[3];
    *out = (batten_hydrostatics){0};
    if (sums[BAT_VOLUME] > 0) {
        for (int c = 0; c < 3; c++)
            at[c] = sums[BAT_MOMENT + c] / sums[BAT_VOLUME];
        out->volume = sums[BAT_VOLUME] * l * l * l;
        out->buoyancy = place_of(hull, at);
    }
    take_waterplane(hull, water, sums, out);
    out->wetted = sums[BAT_WETTED] * l * l;
    out->lids = sums[BAT_WET_LIDS] * l * l;
    for (int k = 0; k < 2; k++)
        out->open[k] = fabs(sums[BAT_OPENING + k]) * l * l;
    out->volume_error = wet->errors[BAT_VOLUME] / bat_max(sums[BAT_VOLUME], DBL_MIN);
    out->area_error = wet->errors[BAT_PLANE] / bat_max(sums[BAT_PLANE], DBL_MIN);
    out->wetted_error = wet->errors[BAT_WETTED] / bat_max(sums[BAT_WETTED], DBL_MIN);
}

batten_status batten_hull_hydrostatics(const batten_hull *hull,
                                       const batten_flotation *flotation, double precision,
                                       const batten_job *job, batten_hydrostatics *out)
{
    bat_water water;
    bat_wet wet;
    batten_status status = bat_check_precision(precision);
    if (status == BATTEN_OK)
        status = bat_water_of(hull, flotation, &water);
    if (status == BATTEN_OK)
        status = bat_hull_wet(hull, &water, precision, job, &wet);
    if (status == BATTEN_OK)
        bat_take_values(hull, &water, &wet, out);
    return status;
}
