/* The parts of fillets between surfaces. */
#ifndef BAT_SURFACE_FILLET_H
#define BAT_SURFACE_FILLET_H
#include "numeric/vector.h"
#include <batten/blend.h>

/* The ball in one place. */
typedef struct {
    double x[4]; /* u and v on the first, on the second surface */
    batten_vec3 centre, contact[2];
    batten_vec3 tangent; /* of the spine, of length one */
} bat_ball;

typedef struct {
    const batten_surface *const *surfaces;
    const double *radii;
    double size;
} bat_rolling;

typedef struct {
    int count;
    bat_ball *balls;
} bat_spine;

/* The ball with its centre in a plane, near a first guess; or, without a plane, anywhere near.
 * `*found` is false where there is none. */
batten_status bat_ball_in_plane(const bat_rolling *r, const double guess[4],
                                const batten_vec3 *point, const batten_vec3 *normal,
                                bat_ball *out, bool *found);
/* Stations from end to end; release the balls (fillet_spine.c). */
batten_status bat_spine_find(const bat_rolling *r, const double *start, bat_spine *out,
                             batten_fillet_end ends[2]);

#endif
