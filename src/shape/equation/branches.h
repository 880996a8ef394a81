/* The pieces of an implicit curve linked to branches. */
#ifndef BAT_EQUATION_BRANCHES_H
#define BAT_EQUATION_BRANCHES_H
#include "shape/equation/clusters.h"
#include "shape/equation/fit.h"

/* Ends of pieces are numbered 2 piece + end. */
typedef struct {
    const bat_cells *cells;
    const bat_clusters *clusters;
    int *mate;      /* [2 pieces] the end that continues; -1: none */
    int *cluster;   /* [2 pieces] the cluster it enters; -1: none */
    bool *used;     /* [pieces] */
    double *points; /* [clusters][3] */
    int loose;      /* ends that continue nowhere, inside of the box */
} bat_branches;

/* Find mates: ends that meet across a side of two cells, or whose tangents continue each other across a
 * singular point. Special points are added to the result. */
batten_status bat_branches_link(bat_branches *branches, const bat_cells *cells,
                                const bat_clusters *clusters, double tolerance,
                                batten_equation_curves *out);
void bat_branches_release(bat_branches *branches);

/* The segments of the next branch; none when all are used. Open ones come first. */
batten_status bat_branches_next(bat_branches *branches, bat_segments *out);

#endif
