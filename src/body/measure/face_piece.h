/* The integral over what lies between a piece of a loop and the edge of the parameters. */
#ifndef BAT_BODY_MEASURE_FACE_PIECE_H
#define BAT_BODY_MEASURE_FACE_PIECE_H
#include "body/measure/face_integral.h"

/* Nodes of the short rule and of the long one. */
enum { BAT_FACE_SHORT = 6, BAT_FACE_LONG = 9, BAT_FACE_NODES = BAT_FACE_SHORT + BAT_FACE_LONG };

/* The face in work. */
typedef struct {
    const batten_body_parts *parts;
    const bat_face_rules *rules;
    const batten_surface *surface;
    batten_interval range[2]; /* of u and v: the box of the loops, inside the domain */
    int inner;                /* along which G is made: 0 u, 1 v */
    double from;              /* G is 0 there */
    int knot_counts[2];       /* distinct knots of the surface */
    double *knots[2];         /* in u and v */
    double nodes[BAT_FACE_NODES], weights[BAT_FACE_NODES]; /* short, long */
    size_t inner_room;
    double *at, *weight, *jets; /* inner nodes; [inner_room][3][3] */
    size_t evaluations;
} bat_face_work;

/* A part of a loop between knot lines of the surface. */
typedef struct {
    const batten_curve *curve; /* (u, v) */
    bool reversed;
    double a, b;
    int fine; /* each span of G is cut in 2^fine parts */
    double values[BAT_FACE_INTEGRALS];
    double gross[2];     /* sizes of the terms of area and volume, for their rounding */
    double errors[2][2]; /* of area and volume; across (by G), along */
} bat_face_piece;

typedef struct {
    size_t count, room;
    bat_face_piece *items;
} bat_face_pieces;

/* The inner knots strictly between a and b: first and how many. */
int bat_face_knots_between(const bat_face_work *w, double a, double b, int *first);
batten_status bat_face_measure_piece(bat_face_work *w, bat_face_piece *p);
batten_status bat_face_add_piece(bat_face_pieces *list, const bat_face_piece *p);

#endif
