/* Whether all lines of a plane section of a surface were found. */
#ifndef BAT_DESIGN_SECTION_PROOF_H
#define BAT_DESIGN_SECTION_PROOF_H
#include <batten/surface.h>

/* Are the lines that were found, each whole, all in which the plane coordinate `axis` = `level` can meet the surface?
 * True is proved by the control points; false says nothing. */
bool bat_section_is_proved(const batten_surface *surface, int axis, double level, int lines);

#endif
