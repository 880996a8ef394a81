/* The chords of a polygon in the plane and its turns, on which nonlinear splines are built. */
#ifndef BAT_CHORD_POLYGON_H
#define BAT_CHORD_POLYGON_H
#include "base/base.h"
#include <batten/chain.h>

typedef struct {
    int count, spans; /* points; one span fewer, closed as many */
    bool closed;
    double *vector; /* [spans][2] */
    double *length; /* [spans] in units of the longest chord */
    double *turn;   /* [count] at each point, radians, a left turn positive; 0 at the ends */
    double unit;    /* the longest chord */
    double size;    /* the largest coordinate */
} bat_chord_polygon;

/* Of checked points [count][2]. COINCIDENT naming the pair, OVERFLOW. */
batten_status bat_chord_polygon_make(int count, const double *points, bool closed,
                                     bat_chord_polygon *out);
void bat_chord_polygon_end(bat_chord_polygon *chords);
/* SINGULAR_HERE when the polygon turns back on itself at point i. */
batten_status bat_chord_polygon_check_turn(const bat_chord_polygon *chords, int i);
/* The largest |turn| and its point. */
double bat_chord_polygon_sharpest(const bat_chord_polygon *chords, int *at);
/* Directions [count] of tangents that stand at `angles` [count] to the chords that leave their
 * points, each within half a turn of the one before as the polygon turns. */
void bat_chord_polygon_directions(const bat_chord_polygon *chords, const double *angles,
                                  double *out);
/* The angle of the tangent of the circle through three points at the middle one, from the chord
 * that leaves it, by the lengths of both chords. */
double bat_circle_angle(double before, double after, double turn);
/* Turn a span of its own frame, where the chord is the x axis, and put it at `point`. */
void bat_chord_put(const double *vector, const double *point, batten_span *span);

#endif
