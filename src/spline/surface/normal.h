/* Normals of surfaces, where Su x Sv is one and where it vanishes. */
#ifndef BAT_SURFACE_NORMAL_H
#define BAT_SURFACE_NORMAL_H
#include "spline/surface/surface.h"
#include <float.h>

/* The roundoff of a first derivative: 8 p r D with D = 2 p |P| / span, r half of epsilon. */
static inline double bat_derivative_noise(int degree, double span, double largest)
{
    return 8 * DBL_EPSILON * degree * degree * largest / span;
}

/* The unit normal when Su x Sv stands out of the roundoff of Su and Sv; false when it does not,
 * or when its square is no number. */
static inline bool bat_regular_normal(const double su[3], const double sv[3], double noise_u,
                                      double noise_v, double normal[3])
{
    const double x = su[1] * sv[2] - su[2] * sv[1];
    const double y = su[2] * sv[0] - su[0] * sv[2];
    const double z = su[0] * sv[1] - su[1] * sv[0];
    const double square = x * x + y * y + z * z;
    const double uu = su[0] * su[0] + su[1] * su[1] + su[2] * su[2];
    const double vv = sv[0] * sv[0] + sv[1] * sv[1] + sv[2] * sv[2];
    /* (a + b + c)^2 <= 3 (a^2 + b^2 + c^2) saves two square roots. */
    const double nu = noise_u * noise_u, nv = noise_v * noise_v;
    if (!(square > 3 * (nu * vv + nv * uu + nu * nv)) || !(square > DBL_MIN) ||
        !isfinite(square))
        return false;
    const double length = sqrt(square);
    normal[0] = x / length;
    normal[1] = y / length;
    normal[2] = z / length;
    return true;
}

/* The normal where bat_regular_normal has failed. `*is_limit` is false when only the size of
 * the numbers was to blame. SINGULAR_HERE where rays disagree. */
batten_status bat_surface_limit_normal(const batten_surface *surface, double u, double v,
                                       double normal[3], bool *is_limit);

#endif
