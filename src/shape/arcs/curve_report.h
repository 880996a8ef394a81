/* How far arcs are from the curve they replace, on both sides. */
#ifndef BAT_ARCS_CURVE_REPORT_H
#define BAT_ARCS_CURVE_REPORT_H
#include "shape/arcs/smooth_arcs.h"

typedef struct {
    const bat_arcs_path *path;
    batten_arcs_options options;
    batten_arcs_side side; /* LEFT, RIGHT or EITHER */
    double slack;          /* what rounding does to a distance */
    /* Of the piece between two corners: */
    double from, to;
    bat_band band;
    batten_arcs_join joined; /* what is made now: BIARCS or PLAIN */
    double guess;            /* of a step, as a parameter */
    int first;               /* of its parts in the list */
    bat_arcs_list list, guide;
    int enough; /* arcs */
    bat_samples samples;
    bat_work work;
} bat_arc_fit;

/* Ask the caller at u whether to continue. */
batten_status bat_arcs_step(bat_arc_fit *t, double u);

batten_status bat_arcs_report_errors(bat_arc_fit *t, batten_arcs_report *report);

#endif
