/* A curve that arcs are to follow: its corners, samples of it, and how far arcs are from it. */
#ifndef BAT_ARCS_PATH_H
#define BAT_ARCS_PATH_H
#include "shape/arcs/arcs.h"

/* The curve with the places between which curvature is monotone, and those where it is not
 * smooth. */
typedef struct {
    const batten_curve *curve;
    batten_interval domain;
    double scale; /* largest coordinate */
    double speed; /* the average */
    bool closed, smooth_seam;
    int station_count;
    double *stations;
    int corner_count;
    double *corners; /* with both ends */
} bat_arcs_path;

/* `corner`: the angle from which on a jump of direction is one. */
batten_status bat_arcs_path_make(const batten_curve *curve, double corner, bat_arcs_path *p);
void bat_arcs_path_end(bat_arcs_path *p);

/* Point and direction; where derivatives vanish the direction is the limit. */
batten_status bat_arcs_direction(const bat_arcs_path *p, double u, batten_side side,
                                 double row[4]);

/* Both ends, the stations between, and `inner` places or more between these: `total` in all at
 * least. */
batten_status bat_arcs_take(const bat_arcs_path *p, batten_interval over, int inner, int total,
                            bat_samples *samples);
/* By how much the curve turns along its samples, all small turns added. */
double bat_arcs_turn(const bat_samples *samples);
/* A part as one or two ranges within the domain: a closed curve continues beyond its end. */
int bat_arcs_ranges(const bat_arcs_path *p, const bat_arcs_part *part,
                    batten_interval ranges[2]);
/* The run from one corner to the next as its own lines and arcs, when it is nothing else, has
 * no kinks and no arc below the least radius: then *kept, and they are added to the list. */
batten_status bat_arcs_keep(const bat_arcs_path *p, batten_interval run, double least_radius,
                            bat_arcs_list *list, bool *kept);
/* How far a biarc is beside the curve: the extremes among the samples and at all roots of the
 * slope between them. */
batten_status bat_arcs_measure(const bat_arcs_path *p, const batten_biarc *biarc,
                               const bat_samples *samples, bat_beside *beside);

#endif
