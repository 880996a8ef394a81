/* The box around the edges of a body. */
#ifndef BAT_BODY_EDGE_BOX_H
#define BAT_BODY_EDGE_BOX_H
#include <batten/body.h>

/* The box of the edges and vertices, and of the surfaces of faces without loops: about how
 * large a body is. Faces may reach beyond it. */
batten_box bat_body_edge_box(const batten_body *body);

#endif
