/* What fits of primitives share. */
#ifndef BAT_PRIMITIVES_H
#define BAT_PRIMITIVES_H
#include <batten/approximate.h>

/* Data about their mean, by their size: all computing is with numbers near 1. */
typedef struct {
    int dimension, count;
    double mean[3], size;
    double *points; /* [count][dimension], (q - mean) / size */
} bat_cloud;

/* COINCIDENT when all points are one. */
batten_status bat_cloud_make(int dimension, int count, const double *points, bat_cloud *out);
void bat_cloud_free(bat_cloud *cloud);
/* Mean products of the coordinates: the directions in which the cloud spreads, rising. */
void bat_cloud_spread(const bat_cloud *cloud, double values[3], double vectors[9]);

/* max, rms and worst of distances [count], times `scale`. */
void bat_primitive_measure(int count, const double *distances, double scale,
                           batten_primitive_report *report);

/* From where to where angles go that follow each other by less than half a turn; a whole turn
 * or more is one turn from the first. */
void bat_angle_range(int count, const double *angles, double *start, double *angle);

#endif
