/* Where a line on a surface goes on: principal and asymptotic directions, and the turning of geodesics. */
#ifndef BAT_SLOPE_H
#define BAT_SLOPE_H
#include "base/base.h"
#include <batten/nearest.h>

/* Of a line at one place: u and v, and of geodesics the tangent in space, which does not jump where parameters do. */
enum { BAT_SLOPE_SIZE = 5 };

typedef struct {
    const batten_surface *surface;
    batten_line_kind kind;
    batten_interval domain[2];
    bool closed[2];
} bat_slope_field;

typedef struct {
    batten_vec3 point, tangent;   /* the tangent of length 1 */
    double rates[BAT_SLOPE_SIZE]; /* of the place by length */
    double spread;                /* of the principal curvatures, over the larger one */
    batten_line_end obstacle; /* where there is no direction: why; else BATTEN_LINE_AT_LENGTH */
} bat_slope;

/* The slope at a place; of both ways that which is less than a right angle from `onward`. Places beyond the domain
 * count as those on its rim, or come around. */
batten_status bat_slope_at(const bat_slope_field *field, const double place[BAT_SLOPE_SIZE],
                           batten_vec3 onward, bat_slope *out);
/* u and v within the domain. */
void bat_slope_wrap(const bat_slope_field *field, const double place[2], double uv[2]);
/* How far a place is beyond the rim, over the width of the domain; below 0 inside. */
double bat_slope_beyond(const bat_slope_field *field, const double place[2]);
/* The tangent of a geodesic that starts in a direction of space, laid into the tangent plane. False where that is no
 * direction. */
bool bat_slope_begin(const bat_slope_field *field, double place[BAT_SLOPE_SIZE],
                     batten_vec3 direction);

#endif
