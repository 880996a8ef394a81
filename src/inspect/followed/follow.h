/* One way along a line on a surface, by steps of Runge and Kutta that are held to a tolerance. */
#ifndef BAT_FOLLOW_H
#define BAT_FOLLOW_H
#include "base/work.h"
#include "inspect/followed/slope.h"

/* A point of a line: its tangent has length 1. */
typedef struct {
    batten_vec3 point, tangent;
    double place[BAT_SLOPE_SIZE];
    double length; /* from the start */
} bat_station;

typedef struct {
    int count, room;
    bat_station *at; /* the start first; of a closed line not again */
    batten_line_end end;
    double
        chord; /* the largest distance of a cubic between two points from the line, at its middle */
    double length;
} bat_way;

typedef struct {
    bat_slope_field field;
    double size;      /* of the surface */
    double tolerance; /* of cubics; steps err by a part of it */
    double most;      /* the length at which a way ends */
    double rounding;  /* steps that err by no more than this may do so however short they are */
    bat_work work;
} bat_follower;

/* From a station on; release way->at, also after a failure. TOO_LARGE beyond a hundred thousand points;
 * TOLERANCE_NOT_MET where steps err by rounding more than the tolerance allows. */
batten_status bat_follow(bat_follower *follower, const bat_station *start, bat_way *way);
/* A point of the cubic between two stations, at a share of its length. */
batten_vec3 bat_station_between(const bat_station *a, const bat_station *b, double share);

#endif
