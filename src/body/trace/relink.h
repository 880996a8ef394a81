/* What the two files that close loops along a cut share. */
#ifndef BAT_RELINK_H
#define BAT_RELINK_H
#include "body/trace/trace.h"

/* From one chain of uses to another, from cell to cell. */
typedef struct {
    int use, next; /* the last before, the first after */
    bool rises;    /* towards greater u (v) */
    double s;      /* where along the cut: v (-u), in one period */
    int vertex;
} bat_crossing;

typedef struct {
    bat_trace *trace;
    bat_trace_face *face;
    int k;        /* the direction that is cut */
    int *cells;   /* of each use */
    int *loop_of; /* of each use */
    int *leaves;  /* of each use: the crossing after it, or -1 */
    bool *done;
    int crossing_count;
    bat_crossing *crossings; /* by s */
    int *next; /* of each crossing that rises: the next higher; -1 for the border */
    bat_trace_loops made;
    double at[2]; /* how far what is added is moved, in the other direction */
} bat_relink;

/* The edge of a seam, from the rising crossing on; its places are of the covering plane. */
typedef struct {
    bool made;
    int edge; /* -1 when it has no length */
    int rim;  /* the edge of the border at its end, or -1 */
    double start, end;
} bat_seam;

/* Along the cut from the crossing that was reached to the use after another one: *use. Seams
 * [crossings] are made when they are first used. */
batten_status bat_relink_follow(bat_relink *relink, int crossing, bat_seam *seams, int *use);

#endif
