/* Blends between surfaces: their formula, and what they are measured by. */
#ifndef BAT_SURFACE_BLEND_H
#define BAT_SURFACE_BLEND_H
#include "shape/formula/formula.h"
#include <batten/blend.h>

/* Orders of a ribbon, rows in Bezier form, and curves of both ribbons. */
enum {
    BAT_BLEND_ORDERS = 3,
    BAT_BLEND_ROWS = 2 * BAT_BLEND_ORDERS,
    BAT_BLEND_CURVES = BAT_BLEND_ROWS
};

/* Six curves over [0, 1], those of the first ribbon before those of the second, and how much of
 * each is in each row. */
typedef struct {
    int count[2];                           /* curves in use on either side */
    batten_curve *curves[BAT_BLEND_CURVES]; /* [side * ORDERS + order]; NULL where not in use */
    double part[BAT_BLEND_CURVES][BAT_BLEND_ROWS];
} bat_blend;

/* The kind "blend", for weights that differ (blend_formula.c). */
extern const bat_formula bat_blend_formula;
int bat_blend_rows(const bat_blend *b);
void bat_blend_free(void *blend);

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
