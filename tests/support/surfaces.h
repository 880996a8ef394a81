/* Random surfaces, and what they are by definition. */
#ifndef TESTS_SUPPORT_SURFACES_H
#define TESTS_SUPPORT_SURFACES_H
#include <batten/measure.h>
#include <batten/surface.h>

#include "support/test.h"

/* What a constructor takes. The axes point into the struct: it is not to be copied. */
enum { SURFACE_DATA_COUNT = BATTEN_MAX_DEGREE + 6 };
typedef struct {
    int dimension;
    bool rational;
    batten_axis axes[2];
    double knots[2][SURFACE_DATA_COUNT + BATTEN_MAX_DEGREE + 1];
    double points[SURFACE_DATA_COUNT * SURFACE_DATA_COUNT * 3];
    double weights[SURFACE_DATA_COUNT * SURFACE_DATA_COUNT];
} surface_data;

/* Degrees up to `most`, clamped, unclamped or periodic, knots of any multiplicity, rational or
 * not. */
void surface_data_random(test_random *random, int most, surface_data *data);
batten_status surface_data_create(const surface_data *data, batten_surface **out);

/* Clamped knots [count + degree + 1] on [0, 1] with simple ones at random inside. */
void random_knots(test_random *random, int degree, int count, double *knots);
/* A parameter inside the domain, sometimes an end of a span. */
double random_parameter(test_random *random, const batten_surface *surface,
                        batten_direction direction);

/* By the definition of B-splines, in long double: all basis functions, k-th derivatives, of the
 * span that holds u (from the right; at the end of the domain from the left). out [count] */
void define_basis(int degree, int count, const double *knots, double u, int k,
                  long double *out);
/* The homogeneous derivative (k, l): out [4] = (w x, w y, w z, w). */
void define_surface(const batten_surface *surface, double u, double v, int k, int l,
                    long double *out);
/* The point itself. */
void define_point(const batten_surface *surface, double u, double v, double *out);

double largest_coordinate(const batten_surface *surface);
/* Do both surfaces have the same shape over their domains, to `tolerance`? */
void check_same_shape(const batten_surface *a, const batten_surface *b, double tolerance);
/* batten_surface_area, its measures as two numbers; `error` may be NULL. */
batten_status test_surface_area(const batten_surface *surface, double precision, double *area,
                                double *error);
#endif
