/* One step of frames that turn least. */
#ifndef BAT_FRAMES_H
#define BAT_FRAMES_H
#include <batten/geometry.h>

/* The axis at a place, with unit tangent, that turned least from `x` at another, which may be
 * the same: the double reflection. */
batten_vec3 bat_frame_carry(batten_vec3 from, batten_vec3 from_tangent, batten_vec3 to,
                            batten_vec3 to_tangent, batten_vec3 x);

#endif
