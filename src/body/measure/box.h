/* Boxes around bodies. */
#ifndef BAT_BODY_BOX_H
#define BAT_BODY_BOX_H
#include "body/edge_box.h"
#include "body/kept_box.h"
#include <batten/body.h>

/* As batten_body_box, which gives the wide box where this fails: OUT_OF_MEMORY. */
batten_status bat_body_find_box(const batten_body *body, batten_box *out);

/* The box of the edges and of all surfaces whose faces may swell beyond them: it may be larger
 * than the body, and needs no memory. */
batten_box bat_body_wide_box(const batten_body *body);

/* The place for the box of a body in that body; changed by its first reader only. */
bat_kept_box *bat_body_kept_box(const batten_body *body);

/* ---- face_range.c ---- */

/* Parts of a surface that hold a face, as boxes of parameters; two in a direction where the
 * face crosses the seam. */
typedef struct {
    batten_surface *surface; /* clamped, owned */
    int count[2];
    batten_interval at[2][2]; /* [direction][count] */
} bat_face_range;

/* From the curves in the parameters when the body is traced, else from feet of its edges on the
 * surface; all of the surface where these do not tell. The size is about that of the body. */
batten_status bat_face_range_find(const batten_body_parts *parts, int face, double size,
                                  bat_face_range *out);

#endif
