/* A skin on its way from its sections to the surface: what its steps share. */
#ifndef BAT_SKIN_PARTS_H
#define BAT_SKIN_PARTS_H
#include "numeric/vector.h"
#include "shape/skin.h"
#include "spline/curve.h"

/* One skin on its way. */
typedef struct {
    int count; /* sections */
    const batten_skin_options *options;
    bat_work work;
    batten_curve **placed;  /* [count] where they stand, in one dimension, run the same way */
    batten_curve **unified; /* [count] with common knots */
    double *deviation;      /* [count] */
    int dimension, points;  /* of a section; one period of a periodic one */
    size_t width;           /* dimension, one more when rational */
    bool rational, periodic_u;
    double *v;    /* [count + 1] */
    double *rows; /* [count][points][width] homogeneous */
    bat_operator across;
    double *control; /* [across.count][points][width] */
} bat_skin;

/* ---- skin_sections.c ---- */

/* The sections where they stand, in one dimension: `placed`. */
batten_status bat_skin_place(bat_skin *t, const batten_curve *const *sections);
/* Reverse each section that runs against the one before it, and say so. */
batten_status bat_skin_align(bat_skin *t);
/* Common knots, exact or within the tolerance: `unified`, `deviation`. */
batten_status bat_skin_unify(bat_skin *t);

/* ---- skin_across.c ---- */

/* `rows`, `v`, and `control` from them. */
batten_status bat_skin_rows(bat_skin *t);
batten_status bat_skin_parameters(bat_skin *t);
batten_status bat_skin_across(bat_skin *t);
batten_status bat_skin_surface(const bat_skin *t, batten_surface **surface);

/* ---- skin_inspect.c ---- */

/* Does the surface pass its sections? TOLERANCE_NOT_MET when not. @param report may be NULL */
batten_status bat_skin_inspect(const bat_skin *t, const batten_surface *surface,
                               batten_skin_report *report);

#endif
