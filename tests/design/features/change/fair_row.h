/* A row of points with two bumps, as a design and as its call. */
#ifndef TEST_FAIR_ROW_H
#define TEST_FAIR_ROW_H
#include "support/test.h"

#include <batten/fair.h>
#include <batten/interpolate.h>

/* Nearly straight in the plane x = 2, with a bump at point 4 and one of half its height at point 8. */
static const double heights[] = {0, 0, 0, 0.02, 0, 0, 0, 0.01, 0, 0};
enum { COUNT_OF_ROW = 10 };

static const char design_of_row[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  p: {points: [[2, 0, 0], [2, 1, 0], [2, 2, 0], [2, 3, 0.02], [2, 4, 0], [2, 5, 0], [2, 6, 0], "
    "[2, 7, 0.01], [2, 8, 0], [2, 9, 0]]}\n";

static inline void fair_row(const batten_fair_options *options, double *faired,
                            batten_fair_report *report)
{
    double points[2 * COUNT_OF_ROW], parameters[COUNT_OF_ROW];
    batten_curve_interpolate_options fit = batten_curve_interpolate_defaults();
    batten_curve *curve = NULL;
    for (int i = 0; i < COUNT_OF_ROW; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = heights[i];
    }
    const batten_points row = {2, COUNT_OF_ROW, points};
    CHECK_OK(batten_curve_interpolate(row, &fit, parameters, &curve));
    batten_curve_unref(curve);
    CHECK_OK(batten_fair_points(row, parameters, options, NULL, report, faired));
}

#endif
