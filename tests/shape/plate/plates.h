/* Edges of plates, and the developable surface between two of them. */
#ifndef TESTS_SHAPE_PLATES_H
#define TESTS_SHAPE_PLATES_H
#include <batten/plate.h>
#include <batten/standard.h>

#include "support/test.h"

/* An arc about the z-axis at the height z. */
static inline batten_curve *arc(double radius, double from, double to, double z)
{
    batten_frame frame = batten_frame_world();
    batten_curve *curve = NULL;
    frame.origin.z = z;
    CHECK_OK(batten_curve_arc_in(&frame, radius, from, to - from, &curve));
    return curve;
}

static inline batten_curve *line(const double *ends)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_line(3, ends, ends + 3, &curve));
    return curve;
}

/* The same shape with another parameter. */
static inline batten_curve *reparametrised(batten_curve *curve)
{
    batten_curve *changed = NULL;
    CHECK_OK(batten_curve_moebius(curve, 2, 0, 1, 1, &changed));
    batten_curve_unref(curve);
    return changed;
}

static inline batten_curve *space_cubic(double x, double y, double z)
{
    const double points[12] = {x,     y,       z,       x + 1, y + 0.8, z + 0.1,
                               x + 2, y - 0.3, z + 0.4, x + 3, y + 0.5, z + 0.2};
    const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 3, NULL, knots, &curve));
    return curve;
}

static inline batten_status develop(const batten_curve *a, const batten_curve *b,
                                    double tolerance, batten_developable *out)
{
    batten_surface_developable_options options = batten_surface_developable_defaults();
    options.tolerance = tolerance;
    return batten_surface_developable(a, b, &options, out);
}

static inline void drop(batten_curve *a, batten_curve *b)
{
    batten_curve_unref(a);
    batten_curve_unref(b);
}

#endif
