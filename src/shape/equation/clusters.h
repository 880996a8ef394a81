/* Cells that are not understood, gathered where they touch: each lies about a singular point, or is undecided. */
#ifndef BAT_EQUATION_CLUSTERS_H
#define BAT_EQUATION_CLUSTERS_H
#include "shape/equation/cells.h"

typedef struct {
    bat_cell box;
    double extent; /* its diagonal */
} bat_cluster;

typedef struct {
    bat_cluster *items;
    int count;
    int *of; /* [undecided.count] */
} bat_clusters;

/* Gather the undecided cells. */
batten_status bat_clusters_gather(const bat_cells *cells, bat_clusters *out);
void bat_clusters_release(bat_clusters *clusters);

/* Where the derivatives vanish in a cluster, by Newton's method; its middle where that leads out. */
void bat_cluster_point(const bat_system *system, const bat_cluster *cluster, double *point);

#endif
