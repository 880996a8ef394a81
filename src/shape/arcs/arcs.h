/*
 * What the approximation of curves and of points by arcs share: how far arcs are from samples,
 * single arcs fitted to samples, and the list of what was found.
 */
#ifndef BAT_ARCS_H
#define BAT_ARCS_H
#include "shape/arcs/biarc.h"
#include <batten/arcs.h>

/* Where arcs may lie: by how much to the left of the curve. */
typedef struct {
    double low, high, middle;
} bat_band;

bat_band bat_band_of(batten_arcs_side side, double tolerance);

/* " with radii of 2 and more" for a message, or "" where any radius will do. */
enum { BAT_RADII_TEXT = 60 };
const char *bat_arcs_of_least_radius(double least, char text[static BAT_RADII_TEXT]);

/* The end of an arc: a point of the curve, or beside it. */
typedef struct {
    double point[2], direction[2];
} bat_node;

/* Points of the curve with its derivatives, or given points with zeros. */
typedef struct {
    int count, capacity;
    double *u;
    double (*rows)[4];
} bat_samples;

batten_status bat_samples_reserve(bat_samples *samples, int count);
void bat_samples_end(bat_samples *samples);

/* By how much a biarc passes to the left of what it stands for: the extremes, and where. */
typedef struct {
    double low, high, low_at, high_at;
} bat_beside;

/* At u it is d. */
void bat_beside_widen(bat_beside *beside, double u, double d);

/* A biarc, or one arc, ready for many points. */
typedef struct {
    int count;
    struct {
        double start[2], T[2], N[2], k;
    } arcs[2];
    double joint[2], along[2]; /* where the second begins, and its direction there */
} bat_arcs_probe;

void bat_arcs_probe_make(const batten_biarc *biarc, bat_arcs_probe *probe);
/* By how much the arcs pass to the left of a point. */
double bat_arcs_beside(const bat_arcs_probe *probe, const double point[2]);
/* How that changes along a derivative, times something positive. */
double bat_arcs_slope(const bat_arcs_probe *probe, const double row[4]);
/* Among samples. */
bat_beside bat_arcs_beside_samples(const bat_arcs_probe *probe, const bat_samples *samples);

/* Why a trial failed, or how much of the band it takes: 1 all of it. */
#define BAT_ARCS_REFUSED HUGE_VAL
double bat_band_share(const bat_band *band, const bat_beside *beside, double slack);

/* What an arc or a biarc is to replace. */
typedef struct {
    const bat_node *from, *to;
    double turn; /* of the curve between them */
    double least_radius;
    const bat_band *band; /* around the samples */
    const bat_samples *samples;
} bat_arcs_stretch;

/* The biarc between the nodes with their directions, its joint where both arcs leave as much of
 * the band; false when it turns otherwise than the curve, or has a radius below the least. */
bool bat_arcs_biarc(const bat_arcs_stretch *on, batten_biarc *out);
/* The arc between the nodes that leaves most room to the band; the same. */
bool bat_arcs_single(const bat_arcs_stretch *on, batten_biarc *out);
/* The line between two nodes. */
void bat_arcs_line(const bat_node *a, const bat_node *b, batten_biarc *out);

/* What was found, in order: biarcs, each for the part of the curve from one place to another.
 */
typedef struct {
    double from, to;
    batten_biarc biarc;
} bat_arcs_part;

typedef struct {
    int count, capacity;
    bat_arcs_part *parts;
} bat_arcs_list;

batten_status bat_arcs_list_add(bat_arcs_list *list, const bat_arcs_part *part);
void bat_arcs_list_end(bat_arcs_list *list);

/* One greedy run within a tolerance: how many parts, and how much of the last one's reach was
 * needed, (0, 1]. */
typedef batten_status (*bat_arcs_run)(void *task, double tolerance, int *count, double *last);
/* Run, and where `spread` is wanted again, within the smallest tolerance that needs no more
 * parts. */
batten_status bat_arcs_spread(bat_arcs_run run, void *task, double tolerance, bool spread);

typedef struct {
    const batten_arcs_options *options;
    bool closed;
    double scale; /* the largest coordinate */
} bat_arcs_chain_task;

/* The chain of the parts, with arcs on one circle joined and the report's numbers about it.
 * TOLERANCE_NOT_MET when there are more than options->most. */
batten_status bat_arcs_chain(const bat_arcs_list *list, const bat_arcs_chain_task *task,
                             batten_arcs_report *report, batten_chain **out);

batten_status bat_arcs_check(const batten_arcs_options *options);

#endif
