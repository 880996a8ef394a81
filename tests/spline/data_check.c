/* Rows of points as callers give them: what is refused before any work. */
#include "support/test.h"

#include <batten/arcs.h>
#include <batten/nearest.h>
#include <batten/standard.h>

static const double row[15] = {0, 0, 0, 1, 0, 1, 2, 1, 0, 3, 3, 1, 4, 0, 5};

TEST(methods_of_the_plane_refuse_points_of_space)
{
    batten_chain *chain = NULL;
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_chain_biarcs((batten_points){3, 5, row}, NULL, NULL, NULL, &chain),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("the points have 3 coordinates, 2 are expected");
    CHECK_STATUS(batten_curve_conic_five((batten_points){3, 5, row}, &curve),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 4, row}, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a conic takes 5 points, not 4");
    CHECK(!chain && !curve);
}

TEST(distances_are_measured_from_points_of_the_curves_own_dimension)
{
    batten_curve *line = NULL;
    batten_deviation found = {.max = -1};
    CHECK_OK(batten_curve_line(2, row, row + 6, &line));
    CHECK_STATUS(
        batten_curve_deviation(line, (batten_points){3, 5, row}, NULL, NULL, NULL, &found),
        BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("the points have 3 coordinates, 2 are expected");
    CHECK_NEAR(found.max, -1, 0);
    CHECK_OK(
        batten_curve_deviation(line, (batten_points){2, 1, row}, NULL, NULL, NULL, &found));
    CHECK_NEAR(found.max, 0, 1e-15);
    batten_curve_unref(line);
}
