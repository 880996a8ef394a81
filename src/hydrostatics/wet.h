/* Integrals over the wet parts of patches. */
#ifndef BAT_HYDROSTATICS_WET_H
#define BAT_HYDROSTATICS_WET_H
#include "hydrostatics/hull.h"

/* Of N = S_u x S_v outwards, n upwards, h the height above the water, and xi, eta along the ship and
 * across it in the waterplane, from the centre of the hull: */
typedef enum {
    BAT_VOLUME,                          /* integral of h n.N */
    BAT_MOMENT,                          /* three: of P h n.N - n h^2 / 2 n.N */
    BAT_PLANE = BAT_MOMENT + 3,          /* of -n.N */
    BAT_PLANE_ALONG,                     /* of -xi n.N */
    BAT_PLANE_ACROSS,                    /* of -eta n.N */
    BAT_PLANE_SQUARES,                   /* three: of -xi^2, -xi eta, -eta^2 times n.N */
    BAT_OPENING = BAT_PLANE_SQUARES + 3, /* two: of N along the ship and across it */
    BAT_WETTED = BAT_OPENING + 2,        /* of |N|, of the surfaces */
    BAT_WET_LIDS,                        /* of |N|, of the lids */
    BAT_SUMS
} bat_sum_place;

typedef struct {
    double sums[BAT_SUMS];
    double errors[BAT_SUMS]; /* estimated */
    bool limited;            /* somewhere the limits of halving were met first */
} bat_wet;

/* BAD_ARGUMENT outside of 1e-14 to 0.1. */
batten_status bat_check_precision(double precision);

/* All patches, each sum within `precision` of the largest that its kind has. TOLERANCE_NOT_MET,
 * CANCELLED, INCOMPLETE, OUT_OF_MEMORY. */
batten_status bat_hull_wet(const batten_hull *hull, const bat_water *water, double precision,
                           const batten_job *job, bat_wet *out);

/* The values of these sums. */
void bat_take_values(const batten_hull *hull, const bat_water *water, const bat_wet *wet,
                     batten_hydrostatics *out);

/* Add the fluxes of (x, 0, 0), (0, y, 0) and (0, 0, z) out of a patch, whose sum is above 0 where it faces away from the
 * centre, and the integral of its normal. Of a closed surface each flux is the volume. */
void bat_patch_flux(const bat_patch *patch, double flux[3], double normal[3]);
/* In parts of the square of the size. */
batten_status bat_patch_area(const bat_patch *patch, double *area);

#endif
