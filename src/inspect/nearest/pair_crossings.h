/* Where two pieces of curves cross. */
#ifndef BAT_INSPECT_NEAREST_PAIR_CROSSINGS_H
#define BAT_INSPECT_NEAREST_PAIR_CROSSINGS_H
#include "inspect/nearest/self_crossings.h"
#include "spline/curve/curve.h"

/* Numbers of the largest piece. */
enum { BAT_CROSSING_ROWS = (BATTEN_MAX_DEGREE + 1) * 3 };

/* How often a piece is halved. */
enum { BAT_CROSSING_DEPTH = 40 };

/* A part of a curve in homogeneous Bezier rows (w x, w y, w), its box, and the cosine of the
 * widest angle between a leg of its polygon and its chord. */
typedef struct {
    int curve, degree;
    double a, b; /* parameters of its ends */
    double low[2], high[2];
    double cosine;
    double rows[BAT_CROSSING_ROWS];
} bat_crossing_piece;

/* What the search works on: pieces in the order of their left ends. */
typedef struct {
    int count, room;
    bat_crossing_piece *pieces;
    const batten_curve *const *curves;
    int curve_count;
    bool closed;
    double tiny; /* of parts shorter than this the direction is lost in rounding; ends nearer
                     than this are one point */
    bat_crossing_piece *stack; /* [2 * (2 * DEPTH + 2)] pairs that wait */
} bat_crossing_search;

void bat_crossing_piece_measure(bat_crossing_piece *p);
/* Cut at the middle; `left` and `right` may not be `p`. */
void bat_crossing_piece_halve(const bat_crossing_piece *p, bat_crossing_piece *left,
                              bat_crossing_piece *right);
bool bat_crossing_pieces_may_meet(const bat_crossing_piece *p, const bat_crossing_piece *q);
batten_status bat_crossing_pieces(bat_crossing_search *s, const bat_crossing_piece *first,
                                  const bat_crossing_piece *second, bat_crossings *out);

#endif
