/* The uses of a traced face as its loops run in its parameters, and where they cross. */
#ifndef BAT_PASSAGES_H
#define BAT_PASSAGES_H
#include "inspect/nearest/self_crossings.h"
#include <batten/body.h>

/* A use of the face as its loop runs. */
typedef struct {
    int loop, use, next;   /* which loop of the face; which use of the body; what follows */
    batten_curve *curve;   /* (u, v), from where it begins */
    double start[2];       /* where it begins */
    double before, length; /* in space: of its loop so far, and its own; only for doubts */
} bat_passage;

typedef struct {
    int count;
    bat_passage *at;
    double low[2], size[2]; /* of the box of all in (u, v); curves are as seen in its unit */
    bool *is_bad;           /* of each loop */
} bat_passages;

/* In the unit of the box places nearer than this are one: rounding, and the misses of traced
 * curves. */
static const double BAT_ONE_PLACE = 1e-7;

/* All uses of a face whose edges have parameters; release them, also after a failure. */
batten_status bat_passages_gather(const batten_body_parts *parts, int face, bat_passages *all);
void bat_passages_release(bat_passages *all);
/* Where they cross, without the joints of uses that follow each other; release `at`. */
batten_status bat_passages_cross(const bat_passages *all, bat_crossings *out);

/* How much area the loops of face `face` leave open where they cross: of the shorter part of each loop that is
 * cut off, four times that of a circle of its length; 0 without crossings. */
batten_status bat_loops_doubt(const batten_body_parts *parts, int face, double *area);

#endif
