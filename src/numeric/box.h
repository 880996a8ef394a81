/* Boxes along the axes that grow. */
#ifndef BAT_BOX_H
#define BAT_BOX_H
#include "base/base.h"
#include <batten/geometry.h>

/* It holds nothing, and is within every other. */
static inline batten_box bat_box_of_nothing(void)
{
    return (batten_box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

static inline bool bat_box_is_of_nothing(batten_box box)
{
    return box.low.x > box.high.x;
}

/* That of one point in space. */
static inline batten_box bat_box_at(const double p[3])
{
    return (batten_box){{p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
}

static inline void bat_box_join(batten_box *box, batten_box by)
{
    box->low = (batten_vec3){bat_min(box->low.x, by.low.x), bat_min(box->low.y, by.low.y),
                             bat_min(box->low.z, by.low.z)};
    box->high = (batten_vec3){bat_max(box->high.x, by.high.x), bat_max(box->high.y, by.high.y),
                              bat_max(box->high.z, by.high.z)};
}

/* The length of its diagonal: the size of what it holds. */
static inline double bat_box_diagonal(batten_box box)
{
    return bat_hypot(bat_hypot(box.high.x - box.low.x, box.high.y - box.low.y),
                     box.high.z - box.low.z);
}

#endif
