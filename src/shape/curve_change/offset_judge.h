/* Which parts of an offset curve are as far from the curve as they should be. */
#ifndef BAT_CURVE_CHANGE_OFFSET_JUDGE_H
#define BAT_CURVE_CHANGE_OFFSET_JUDGE_H
#include "inspect/nearest/self_crossings.h"
#include "shape/curve_change/offset.h"

/* A part of a run; where it begins and ends; and who follows. */
typedef struct {
    int run;
    double a, b;
    double start[2], end[2];
    int next;      /* -1: none */
    bool followed; /* some part has it as the next */
} bat_offset_part;

typedef struct {
    const bat_offset *o;
    double least; /* distance that is far enough */
    double near;  /* ends of parts that meet */
    int removed;
    int count, room;
    bat_offset_part *parts;
} bat_offset_trimming;

/* How far points of the plane lie from the curve. */
batten_status bat_offset_distances(const bat_offset_trimming *t, int count,
                                   const double *points, double *out);
/* The least distance that is let pass. */
double bat_offset_excused(const bat_offset_trimming *t);
batten_status bat_offset_judge(bat_offset_trimming *t, const bat_crossings *crossings);

#endif
