/* From space to the plane of the picture: parallel projection. */
#ifndef BAT_VIEW_H
#define BAT_VIEW_H
#include "base/base.h"
#include "numeric/vector.h"
#include <batten/picture.h>

/* Three unit vectors at right angles; `eye` points to the one who looks. */
typedef struct {
    double right[3], up[3], eye[3];
} bat_view;

/* `azimuth` turns the eye about z from the direction of x, `elevation` lifts it; both count
 * only for the axonometric view, which is also what BATTEN_VIEW_AUTO gives here. */
bat_view bat_view_make(batten_view view, double azimuth, double elevation);

/* To the right, up, and towards the eye. */
static inline void bat_view_project(const bat_view *view, const double point[3], double out[3])
{
    const double x = bat_dot(3, view->right, point), y = bat_dot(3, view->up, point);
    const double z = bat_dot(3, view->eye, point);
    out[0] = x, out[1] = y, out[2] = z;
}

#endif
