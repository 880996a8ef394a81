/* Where two curves in space meet, or how near they come. */
#ifndef BAT_MEETINGS_H
#define BAT_MEETINGS_H
#include "base/work.h"
#include <batten/curve.h>

/* A polynomial curve as chords, each with a bound on how far the curve leaves it, and boxes of
 * chords in a binary tree: node i holds nodes 2 i and 2 i + 1, chord k is node width + k. */
typedef struct {
    const batten_curve *curve; /* borrowed */
    int count, width;          /* chords; the power of two that holds them */
    double *at;                /* [count + 1] parameters */
    double *points;            /* [count + 1][3] */
    double *sag;               /* [count] */
    double *boxes;             /* [2 width][2][3], low and high */
} bat_trace;

/* @param curve polynomial, clamped, of dimension 3 */
batten_status bat_trace_make(const batten_curve *curve, bat_trace *out);
void bat_trace_free(bat_trace *trace);

typedef struct {
    double at[2]; /* parameters on both curves */
    double point[2][3];
    double distance;
} bat_meeting;

enum { BAT_MEETINGS = 4 };
typedef struct {
    int count;
    bool more; /* there are more than these: the curves run along each other, or cross often */
    bat_meeting found[BAT_MEETINGS]; /* by the first parameter */
    bat_meeting nearest;             /* of all, also when none is within the tolerance */
} bat_meetings;

/*
 * All places where two curves come within `tolerance` of each other: local minima of their
 * distance. Places whose points are within twice the tolerance are one. Pairs of chords whose
 * boxes are too far apart are never looked at, so the cost is some log(n) for each meeting.
 * @return INCOMPLETE when more than a million pairs of boxes would have to be looked at
 */
batten_status bat_meetings_find(const bat_trace *a, const bat_trace *b, double tolerance,
                                bat_work *work, bat_meetings *out);

#endif
