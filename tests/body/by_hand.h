/* Bodies by hand: edges by their curves, vertices found by place. */
#ifndef TESTS_BODY_BY_HAND_H
#define TESTS_BODY_BY_HAND_H
#include "body/builder.h"
#include <batten/geometry.h>

typedef struct {
    bat_builder builder;
    int turn; /* how parameters of its surfaces run: 1 changes u and v, 2 reverses u, 4 reverses v */
} hand;

extern const batten_frame hand_world;

hand hand_begin(void);
hand hand_turned(int turn);
/* Of 0 to 7: the faces stay as they are, whatever the parameters. */
void hand_every_turn(void (*of)(int turn));
/* Takes the curve over. */
int hand_edge(hand *m, batten_curve *curve);
int hand_line(hand *m, double x0, double y0, double z0, double x1, double y1, double z1);
/* About the z-axis at this height, angles in degrees. */
int hand_arc(hand *m, double radius, double z, double start, double angle);
/* Takes the surface over. */
void hand_face(hand *m, batten_surface *surface, bool reversed);
void hand_loop(hand *m, int count, const int *edges);
batten_surface *hand_cylinder(double radius, double height);
/* Traced; with what holds for all looked at, and that tracing it again changes nothing. */
batten_body *hand_trace(hand *m, double tolerance, batten_body_trace_report *report);
/* How many edges have exactly two uses, one each way. */
int hand_shared(const batten_body *body);
void hand_plate(hand *m, double x0, double y0, double x1, double y1, double z);
batten_surface *hand_torus(void);
double hand_area(const batten_body *body);
double hand_volume(const batten_body *body);
/* Edges from 1; a minus runs against the edge. */
#define HAND_LOOP(m, ...) hand_loop(m, COUNT(((int[]){__VA_ARGS__})), (int[]){__VA_ARGS__})

#endif
