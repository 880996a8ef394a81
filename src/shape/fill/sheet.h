/*
 * A fill that is one surface over the plane of the hole, trimmed by its sides (sheet.c).
 *
 * In the frame of the hole, whose size is 1, the sheet is (x, y, z(x, y)), and z a quintic spline
 * with single knots: four derivatives are continuous, and over an outline that does not cross
 * itself it cannot fold. Points, tangent planes and curvatures along the sides are linear in z.
 */
#ifndef BAT_SHEET_H
#define BAT_SHEET_H
#include "shape/fill/fill.h"

/* The sides in the frame of the hole, in the loop's order, each as it was given. */
typedef struct {
    int count;
    bat_fill_side sides[BATTEN_SHEET_SIDES];
    bool reversed[BATTEN_SHEET_SIDES];       /* it runs against the loop */
    batten_curve *plane[BATTEN_SHEET_SIDES]; /* x and y of the sides */
    double centre[3], axes[3][3], size;      /* the frame; axes[2] is its z */
    double low[2], high[2];                  /* what holds the outline, control points too */
    int ring_count;
    double *ring; /* [ring_count][2], points of the outline round the loop */
} bat_sheet_outline;

/* The frame, the sides in it, and whether the outline is one (sheet_outline.c). */
batten_status bat_sheet_outline_make(int count, const batten_ribbon *sides, double tolerance,
                                     double *loop_gap, bat_sheet_outline *out);
void bat_sheet_outline_free(bat_sheet_outline *outline);
batten_affine bat_sheet_to_frame(const bat_sheet_outline *outline);
batten_affine bat_sheet_from_frame(const bat_sheet_outline *outline);
bool bat_sheet_is_inside(const bat_sheet_outline *outline, const double at[2]);

/* The derivative of this order along a direction that z has in a place. */
typedef struct {
    double at[2], along[2];
    int order; /* 0 to 2 */
    double value, weight;
    double allowed; /* how far it may be missed */
} bat_sheet_condition;

typedef struct {
    int count, room;
    bat_sheet_condition *at;
} bat_sheet_conditions;

/* What is asked inside the outline, in space. */
typedef struct {
    batten_points points;
    batten_curve_row curves;
} bat_sheet_inside;

/* All that the sides and what is inside ask of z, at places not wider than h apart
 * (sheet_conditions.c). Release `at` also after a failure. */
batten_status bat_sheet_ask(const bat_sheet_outline *outline, const bat_sheet_inside *inside,
                            bool curvature, double h, bat_sheet_conditions *out);

/* The fairest z that meets the conditions as well as `spans` spans along the longer side allow,
 * as a surface in the frame (sheet_solve.c). */
batten_status bat_sheet_solve(const bat_sheet_outline *outline,
                              const bat_sheet_conditions *conditions, int spans,
                              batten_surface **out);

/* What was reached, in model units (sheet_measure.c). @param surface  in the frame */
batten_status bat_sheet_measure(const bat_sheet_outline *outline,
                                const bat_sheet_inside *inside, const batten_surface *surface,
                                batten_fill_sheet_report *report);

#endif
