/* What blends between surfaces are measured by. */
#ifndef BAT_SURFACE_BLEND_H
#define BAT_SURFACE_BLEND_H
#include <batten/blend.h>

/* A blend to be: between what, how, and the report on it. */
typedef struct {
    const batten_surface *const *surfaces;
    const batten_surface_blend_end *ends;
    double size;
    batten_surfaces_blend_report *report;
} bat_blend_contact;

/* Fills in gap, angle, curvature and fold; TOLERANCE_NOT_MET when an edge is missed by more
 * than the error says. */
batten_status bat_blend_measure(const bat_blend_contact *t, const batten_surface *made);

#endif
