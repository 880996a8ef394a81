/* What the files of elementary surfaces share. */
#ifndef BAT_ELEMENTARY_PARTS_H
#define BAT_ELEMENTARY_PARTS_H
#include "body/elementary/elementary.h"
#include "numeric/vector.h"

/* An elementary surface with its frame made square, and what it shall reach over. */
typedef struct {
    const bat_elementary *of;
    batten_frame frame; /* square */
    batten_vec3 y;
    int count;
    const double *points; /* [count][3] */
    double tolerance;
} bat_stand;

/* The frame made square. Of extrusions and revolutions only z counts; x may be anything. */
batten_status bat_elementary_frame(const bat_elementary *elementary, batten_frame *square,
                                   batten_vec3 *y);

/* Coordinate `axis` of a point in the frame. */
static inline double bat_stand_coordinate(const bat_stand *stand, const double point[3],
                                          int axis)
{
    const batten_vec3 way = bat_vec3_subtract(bat_vec3_of(3, point), stand->frame.origin);
    return bat_vec3_dot(way, axis == 0   ? stand->frame.x
                             : axis == 1 ? stand->y
                                         : stand->frame.z);
}

/* From the least to the largest coordinate of the points, `count` > 0. */
batten_interval bat_stand_range(const bat_stand *stand, int axis);

/* The surfaces of revolution (elementary_turned.c), u around from 0 to 2 pi. */
batten_status bat_stand_cylinder(const bat_stand *stand, batten_surface **out);
batten_status bat_stand_cone(const bat_stand *stand, batten_surface **out);
batten_status bat_stand_sphere(const bat_stand *stand, batten_surface **out);
batten_status bat_stand_torus(const bat_stand *stand, batten_surface **out);
batten_status bat_stand_revolution(const bat_stand *stand, batten_surface **out);
/* Of a profile that crosses the axis the part to which the points belong, or the first
 * (elementary_cut.c). BAD_ARGUMENT when it crosses nowhere. */
batten_status bat_stand_cut(const bat_stand *stand, batten_curve **out);

#endif
