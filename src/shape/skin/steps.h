/* A skin on its way from its sections to the surface: what its steps share. */
#ifndef BAT_SKIN_PARTS_H
#define BAT_SKIN_PARTS_H
#include "numeric/vector.h"
#include "shape/linear/linear_system.h"
#include "shape/skin/sections.h"
#include "spline/curve/curve.h"

/* One skin on its way. */
typedef struct {
    int count; /* sections */
    const batten_surface_skin_options *options;
    const batten_curve *const *given; /* [count] */
    bat_work work;
    batten_curve **placed;  /* [count] where they stand, in one dimension, run the same way,
                               matched and cured */
    batten_curve **unified; /* [count] with common knots */
    double *moved;          /* [count] how far from where they stood at first */
    double *deviation;      /* [count] of the unified ones from the placed ones */
    bool *point;            /* [count] */
    bool closed;            /* all that are no points */
    bool mixed;             /* open and closed sections may stand together */
    bool cures;             /* creases are to be cured */
    bool reports;           /* somebody wants to know */
    batten_surface_skin_report found;
    double inner_corner; /* the largest of the sections, as placed, at their inner knots */
    double
        seam_corner; /* the largest of the closed sections, as placed, where they begin and end */
    double
        noted_crease; /* as found.crease, by the sections as placed, and at the seam, where nothing cures it */
    int dimension, points; /* of a section; one period of a periodic one */
    size_t width;          /* dimension, one more when rational */
    bool rational, periodic_u;
    double *v;    /* [count + 1] */
    double *rows; /* [count][points][width] homogeneous */
    bat_operator across;
    double *control; /* [across.count][points][width] */
} bat_skin;

/* ---- skin.c ---- */

/* Options checked, and sections placed, aligned and matched; end it after a failure too. */
batten_status bat_skin_begin(int count, const batten_curve *const *sections,
                             const batten_surface_skin_options *options, bool mixed,
                             bat_skin *t);
void bat_skin_end(bat_skin *t);

/* ---- placed_sections.c ---- */

/* The sections where they stand, in one dimension: `placed`. */
batten_status bat_skin_place(bat_skin *t);
/* Common knots, exact or within the tolerance: `unified`, `deviation`. */
batten_status bat_skin_unify(bat_skin *t);

/* ---- section_order.c ---- */

/* Which sections are points, and whether the others are closed; NOT_COMPATIBLE when only some
 * are. */
batten_status bat_skin_kinds(bat_skin *t);
/* Neighbours that cross or stand the other way round, of the unified sections: into `found`. */
batten_status bat_skin_order(bat_skin *t);

/* ---- reverse_sections.c ---- */

batten_status bat_skin_closed(const batten_curve *curve, bool *closed, bool *point);
/* Reverse sections that run against the one before, let closed ones begin near it. */
batten_status bat_skin_align(bat_skin *t);

/* ---- align_closed.c ---- */

/* Sections by arc length or by their marks: `moved` grows. */
batten_status bat_skin_match(bat_skin *t);
/* Sorted; of those nearer than 1e-12 of the whole the first is kept, and the end. How many. */
int bat_skin_sort_knots(int count, double *knots);

/* ---- crease_cures.c ---- */

/* Speeds that do not jump where the tangent is continuous, of polynomial sections. */
batten_status bat_skin_stretch(bat_skin *t);
/* The same of rational ones, with their weights; not done when one cannot be helped so. */
batten_status bat_skin_rescale(bat_skin *t, bool *done);
/* Polynomial sections in their place: `moved` grows. */
batten_status bat_skin_polynomial(bat_skin *t);

/* ---- interpolate_across.c ---- */

/* What the options ask of the splines across. */
bat_request bat_skin_request(const batten_surface_skin_options *o, int count, const double *v);

/* `rows`, `v`, and `control` from them. */
batten_status bat_skin_rows(bat_skin *t);
batten_status bat_skin_parameters(bat_skin *t);
batten_status bat_skin_across(bat_skin *t);
batten_status bat_skin_surface(const bat_skin *t, batten_surface **surface);

/* ---- report.c ---- */

/* Tangents that differ by more than this angle, in radians, are a corner and not an inaccuracy.
 */
static const double bat_skin_corner = 0.01;

/* The corners of the sections as they are placed, before any cure: `inner_corner`, `seam_corner`. */
batten_status bat_skin_find_corners(bat_skin *t);
/* Does the surface pass its sections? TOLERANCE_NOT_MET when not. Fills in `found`. */
batten_status bat_skin_inspect(bat_skin *t, const batten_surface *surface);

#endif
