/*
 * Random curves and surfaces of the nasty kind: 20 % of the inner knots equal, 10 % nearly
 * equal (1 ulp to 1e-9 of the domain), 10 % of the points collapsed, sizes 1e-9 to 1e9, any
 * domain, rational or not, degrees 1..25, mostly small.
 */
#ifndef TESTS_SUPPORT_GENERATE_H
#define TESTS_SUPPORT_GENERATE_H
#include <batten/curve.h>

#include "support/test.h"

enum { TEST_MOST_POINTS = 256 };

typedef enum { TEST_EITHER, TEST_NEVER, TEST_ALWAYS } test_choice;

/* What is asked of a shape; all zero asks for nothing. */
typedef struct {
    int dimension;        /* 0: 1..3 */
    int degree;           /* 0: 1..25, mostly small */
    int most_points;      /* 0: as usual, degree + 1 .. degree + 30; at most 256 */
    test_choice rational; /* weights within a ratio of 100 */
    test_choice clamped;  /* either: mostly */
    bool tame;            /* no near-equal knots, no collapsed points, size and domain near 1 */
} test_wish;

/* Knots [count + degree + 1] that batten_curve_create accepts. */
void test_knots(test_random *random, const test_wish *wish, int degree, int count,
                double *knots);
/* Control points [count][dimension]. */
void test_points(test_random *random, const test_wish *wish, size_t count, int dimension,
                 double *points);
/* Degree and number of points within a wish. */
int test_degree(test_random *random, const test_wish *wish);
int test_point_count(test_random *random, const test_wish *wish, int degree);
void test_weights(test_random *random, size_t count, double *weights);

/* Yours to unref. */
batten_curve *test_curve(test_random *random, const test_wish *wish);
batten_curve *test_periodic_curve(test_random *random, const test_wish *wish);

/* The largest magnitude of a coordinate. */
double test_curve_size(const batten_curve *curve);
/* A random parameter in the domain: often a knot, an end, or close to one. */
double test_parameter(test_random *random, const batten_curve *curve);
/* Two curves at one parameter: the distance, divided by `size`. */
double test_curve_distance(const batten_curve *a, double at_a, const batten_curve *b,
                           double at_b, double size);

#endif
