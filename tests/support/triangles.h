/* Random Bezier triangles, and what they are by definition. */
#ifndef TESTS_SUPPORT_TRIANGLES_H
#define TESTS_SUPPORT_TRIANGLES_H
#include <batten/triangles.h>

#include "support/test.h"

/* Coordinates in [-1, 1], weights in [0.5, 2]. */
batten_status random_triangles(test_random *random, int dimension, int degree, int count,
                               bool rational, const batten_triangulation *domain,
                               batten_triangles **out);
/* Barycentric coordinates; sometimes on an edge or at a corner. */
void random_place(test_random *random, double at[3]);
/* The point as the sum of Bernstein polynomials, in long double. */
void define_triangle_point(const batten_triangles *triangles, int triangle, const double at[3],
                           double *out);
/* The function x^2 y + 2 x y - 3 y^2 + x + 5 and its cubic triangles over a domain. */
double example_cubic(double x, double y);
batten_status example_triangles(int count, const batten_triangulation *domain,
                                batten_triangles **out);
#endif
