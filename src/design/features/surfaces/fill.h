/* The parts of the feature 'fill': what is said of its edges, and the fill that is one sheet. */
#ifndef BAT_FEATURE_FILL_H
#define BAT_FEATURE_FILL_H
#include "design/feature.h"
#include <batten/fill.h>

/* What an edge may have. */
typedef struct {
    const char *unit;
    double gap, angle, curvature;
} bat_edge_bounds;

/* The edge with the largest gap, angle, curvature; NULL where none has one. */
typedef struct {
    const batten_fill_edge *gap, *angle, *curvature;
} bat_worst_edges;

/* An edge by the names that the design knows. */
void bat_name_edge(const bat_objects *curves, const batten_fill_edge *edge, char name[160]);
/* The worst of these and of those known already. */
bat_worst_edges bat_find_worst_edges(int count, const batten_fill_edge *edges,
                                     bat_worst_edges worst);
/* One line: the worst gap, angle and curvature, each where it is. */
void bat_remark_worst_edges(const bat_run *run, const bat_objects *curves, const char *unit,
                            const bat_worst_edges *worst);
/* An edge that has more than it may. */
void bat_remark_excess(const bat_run *run, const bat_objects *curves,
                       const bat_edge_bounds *most, const batten_fill_edge *edge);

/* One trimmed surface for a hole, through what is inside; its body is added to the model. */
typedef struct {
    int count;
    const batten_ribbon *ribbons;
    double within;
} bat_hole;
batten_status bat_fill_by_sheet(bat_run *run, const bat_objects *curves, const bat_hole *hole);

#endif
