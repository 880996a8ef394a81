/* One side of a place on a curve, as joins look at it. */
#ifndef BAT_SIDE_H
#define BAT_SIDE_H
#include <batten/continuity.h>

enum { BAT_SIDE_ORDER = 3 };

/* The derivatives in the direction of travel, and how far rounding may have moved them. */
typedef struct {
    batten_vec3 c[BAT_SIDE_ORDER + 1];
    double roundoff[BAT_SIDE_ORDER + 1];
    batten_vec3 tangent; /* 0 where there is none */
    bool singular;
    /* By arc length: curvature, and its rate across the tangent, as vectors; for a sign in the
     * plane nothing but these is needed. */
    batten_vec3 curvature, rate;
} bat_side;

/* At the named end of a curve, run towards that end or, `away`, from it. */
batten_status bat_side_at_end(const batten_curve *curve, batten_curve_end end, bool away,
                              bat_side *out);
/* How far rounding may have moved the m-th derivative by arc length. */
double bat_side_roundoff(const bat_side *side, int m);

#endif
