/* Bodies for tests. */
#ifndef TESTS_SUPPORT_BODIES_H
#define TESTS_SUPPORT_BODIES_H
#include <batten/body.h>

/* A box between two corners, as a solid: six bilinear faces named "left right front back bottom
 * top", twelve shared edges, eight vertices, without parameter curves. */
batten_body *test_box(batten_vec3 low, batten_vec3 high);

#endif
