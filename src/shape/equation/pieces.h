/* Curves of equations, put together from Bezier pieces; and the list of what is special on them. */
#ifndef BAT_EQUATION_PIECES_H
#define BAT_EQUATION_PIECES_H
#include "base/base.h"
#include <batten/contours.h>

/* The degree of a piece of a parametric curve. */
#define BAT_QUINTIC 5

/* One piece of a curve over [a, b]. */
typedef struct {
    double a, b;
    bool is_chord;                  /* its derivatives are not those of the curve */
    double leg[BAT_QUINTIC + 1][3]; /* Bezier points */
} bat_quintic_piece;

/* Are first and second derivatives of two pieces the same where they meet, as far as rounding goes? */
bool bat_quintics_agree(int dimension, const bat_quintic_piece *l, const bat_quintic_piece *r);

/* A C2 curve of pieces, but C0 at chords and where pieces do not agree. */
batten_status bat_quintics_joined(int dimension, int count, const bat_quintic_piece *pieces,
                                  batten_curve **out);

/* The space for another curve, or special point, of the result. */
batten_status bat_equation_add_curve(batten_equation_curves *out, batten_curve *curve);
batten_status bat_equation_add_point(batten_equation_curves *out, batten_equation_point point);

#endif
