/* Three curves, with and without ribbons, for surfaces between them. */
#ifndef TESTS_SUPPORT_TRIANGLE_FRAMES_H
#define TESTS_SUPPORT_TRIANGLE_FRAMES_H
#include <batten/coons.h>

#include "support/test.h"

/* A polynomial of total degree `degree` with coefficients c[a][b] of x^a y^b. */
typedef struct {
    int degree;
    double c[5][5];
} polynomial;

double value_of(const polynomial *f, double x, double y, int dx, int dy);
polynomial random_polynomial(test_random *random, int degree);

typedef struct {
    batten_curve *curves[3], *slopes[3];
    batten_ribbon ribbons[3];
} frame;

void frame_free(frame *f);
/* The graph of a polynomial of degree 4 at most over a triangle. */
void polynomial_frame(const polynomial *f, bool smooth, frame *out);
/* Curves and ribbons in space that belong to no function; side e of the frame is curve e. */
void space_frame(test_random *random, frame *out);
#endif
