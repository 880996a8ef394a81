/* A function of one parameter as a polyline that stays near it. */
#ifndef BAT_TRACE_H
#define BAT_TRACE_H
#include "picture/lines/stroke.h"

/* The point at a parameter; at a knot the limit from the left, when asked, else from the right. */
typedef batten_status bat_point_at(const void *user, double at, bool from_left,
                                   double point[3]);

typedef struct {
    bat_point_at *point_at;
    const void *user;
    double tolerance; /* of the polyline from the curve */
    bool is_straight; /* between knots: nothing to refine */
    bool jumps;       /* at knots inside: both limits are kept */
} bat_traced;

/* With a point at every knot [knot_count], and between them as few as keep the polyline within the
 * tolerance. */
batten_status bat_trace(const bat_traced *traced, int knot_count, const double *knots,
                        bat_stroke *out);

#endif
